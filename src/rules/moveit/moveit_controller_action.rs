//! A controller that does not offer the action that MoveIt sends to it.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::namespace::last;

pub(in super::super) static RULE: Rule = Rule::beside(
    "MOV012",
    "moveit-controller-action",
    Category::Moveit,
    Severity::Warning,
    page("moveit-controller-action"),
    check,
);

const TRAJECTORY: &str = "FollowJointTrajectory";
const GRIPPER: &str = "GripperCommand";

/// The actions of classes of controllers. Others may offer any.
/// Source: ros2_controllers, ros_controllers.
const ACTIONS: [(&str, Option<&str>); 15] = [
    ("/JointTrajectoryController", Some(TRAJECTORY)),
    (
        "position_controllers/GripperActionController",
        Some(GRIPPER),
    ),
    ("effort_controllers/GripperActionController", Some(GRIPPER)),
    ("diff_drive_controller/DiffDriveController", None),
    ("forward_command_controller/ForwardCommandController", None),
    (
        "forward_command_controller/MultiInterfaceForwardCommandController",
        None,
    ),
    ("/JointStateBroadcaster", None),
    ("/JointStateController", None),
    ("/JointGroupEffortController", None),
    ("/JointGroupPositionController", None),
    ("/JointGroupVelocityController", None),
    ("/JointEffortController", None),
    ("/JointPositionController", None),
    ("/JointVelocityController", None),
    ("/GPIOCommandController", None),
];

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let controllers = cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.moveit);
    for controller in controllers {
        let Some(wanted) = &controller.action else {
            continue;
        };
        if ![TRAJECTORY, GRIPPER].contains(&wanted.name.as_str()) {
            continue;
        }
        let name = last(&controller.name.name);
        let listed = cx.all_settings().flat_map(|settings| &settings.listed);
        let classes: Vec<&str> = listed
            .filter(|one| one.name.name == name)
            .map(|one| one.class.name.as_str())
            .collect();
        // one of several may be for another way to start the robot
        let lacks = |class: &&str| action_of(class).is_some_and(|has| has != Some(&wanted.name));
        let Some(class) = classes.first().filter(|_| classes.iter().all(lacks)) else {
            continue;
        };
        let message = format!(
            "controller `{name}` is a `{class}`, which has no action `{}`",
            wanted.name
        );
        let report = cx.report(out, wanted, message);
        match action_of(class).flatten() {
            Some(own) => report.help(format!("write `{own}`, or use another controller")),
            None => report.help(match wanted.name.as_str() {
                TRAJECTORY => "use a `joint_trajectory_controller/JointTrajectoryController`",
                _ => "use a controller of grippers, such as `position_controllers/GripperActionController`",
            }),
        }
        .done();
    }
}

/// The action of a class, or none; none at all of an unknown class.
fn action_of(class: &str) -> Option<Option<&'static str>> {
    let mut known = ACTIONS.iter();
    let found =
        known.find(|(name, _)| class == *name || name.starts_with('/') && class.ends_with(name));
    found.map(|(_, action)| *action)
}
