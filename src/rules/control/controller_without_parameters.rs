//! A controller without parameters, or parameters of no controller.
use super::super::beside::BesideCx;
use super::super::finding::Help;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastSet;
use packages::nearest;
use project::YamlSettings;

pub(in super::super) static RULE: Rule = Rule::beside(
    "CTL028",
    "controller-without-parameters",
    Category::Control,
    Severity::Warning,
    page("controller-without-parameters"),
    check,
);

/// Controllers that do nothing without joints.
/// Source: the parameter files of ros2_controllers.
const NEED_JOINTS: [&str; 9] = [
    "diff_drive_controller/DiffDriveController",
    "effort_controllers/JointGroupEffortController",
    "forward_command_controller/ForwardCommandController",
    "joint_trajectory_controller/JointTrajectoryController",
    "parallel_gripper_action_controller/GripperActionController",
    "position_controllers/GripperActionController",
    "position_controllers/JointGroupPositionController",
    "velocity_controllers/JointGroupVelocityController",
    "effort_controllers/GripperActionController",
];

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(own) = cx.settings().filter(|settings| !settings.listed.is_empty()) else {
        return;
    };
    let given: FastSet<&str> = names(cx.all_settings());
    let listed: FastSet<&str> = cx
        .all_settings()
        .flat_map(|settings| &settings.listed)
        .map(|one| one.name.name.as_str())
        .collect();
    let needing = own
        .listed
        .iter()
        .filter(|one| !one.has_file && NEED_JOINTS.contains(&one.class.name.as_str()));
    for one in needing {
        if given.contains(one.name.name.as_str()) {
            continue;
        }
        let message = format!("controller `{}` has no parameters", one.name.name);
        let free = given.iter().copied().filter(|name| !listed.contains(name));
        let help = match nearest(&one.name.name, free) {
            Some(near) => {
                format!("the parameters of `{near}` belong to no controller; is it the same?")
            }
            None => format!(
                "add `{}` with `ros__parameters` and its joints",
                one.name.name
            ),
        };
        cx.report(out, &one.name, message).help(help).done();
    }
    for controller in own
        .controllers
        .iter()
        .filter(|one| one.is_ros2 && one.class.is_none() && !one.joints.is_empty())
    {
        let name = controller.name.name.as_str();
        // other nodes have parameters too: only what looks like a listed controller is meant for one
        let lacking = listed.iter().copied().filter(|one| !given.contains(one));
        let near = nearest(name, lacking).filter(|_| !listed.contains(name));
        if let Some(near) = near {
            let message = format!("parameters of `{name}`, which no controller manager lists");
            cx.report(out, &controller.name, message)
                .help(Help::did_you_mean(near))
                .done();
        }
    }
}

/// The controllers that have parameters.
fn names<'a>(all: impl Iterator<Item = &'a YamlSettings>) -> FastSet<&'a str> {
    all.flat_map(|settings| &settings.controllers)
        .map(|controller| controller.name.name.as_str())
        .collect()
}
