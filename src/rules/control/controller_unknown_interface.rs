//! A controller with an interface that its joints do not offer.
use super::super::beside::BesideCx;
use super::super::grouping::Group;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::hardware::HardwareJoints;
use project::{Controller, SpannedName, is_computed};

pub(in super::super) static RULE: Rule = Rule::beside(
    "CTL027",
    "controller-unknown-interface",
    Category::Control,
    Severity::Error,
    page("controller-unknown-interface"),
    check,
);

/// The interface that a controller commands at the joints of a parameter, whatever its other parameters say. None of these reads
/// `command_interfaces`.
/// Source: `command_interface_configuration` of ros2_controllers.
const COMMANDED: [(&str, &str, &str); 13] = [
    (
        "ackermann_steering_controller/AckermannSteeringController",
        "steering_joints_names",
        "position",
    ),
    (
        "ackermann_steering_controller/AckermannSteeringController",
        "traction_joints_names",
        "velocity",
    ),
    (
        "bicycle_steering_controller/BicycleSteeringController",
        "steering_joints_names",
        "position",
    ),
    (
        "bicycle_steering_controller/BicycleSteeringController",
        "traction_joints_names",
        "velocity",
    ),
    (
        "diff_drive_controller/DiffDriveController",
        "left_wheel_names",
        "velocity",
    ),
    (
        "diff_drive_controller/DiffDriveController",
        "right_wheel_names",
        "velocity",
    ),
    (
        "effort_controllers/GripperActionController",
        "joint",
        "effort",
    ),
    (
        "effort_controllers/JointGroupEffortController",
        "joints",
        "effort",
    ),
    (
        "position_controllers/GripperActionController",
        "joint",
        "position",
    ),
    (
        "position_controllers/JointGroupPositionController",
        "joints",
        "position",
    ),
    (
        "tricycle_controller/TricycleController",
        "steering_joint_name",
        "position",
    ),
    (
        "tricycle_controller/TricycleController",
        "traction_joint_name",
        "velocity",
    ),
    (
        "velocity_controllers/JointGroupVelocityController",
        "joints",
        "velocity",
    ),
];

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(all) = HardwareJoints::of(cx) else {
        return;
    };
    let lacks = |joint: &str, interface: &str, is_command| all.lacks(joint, interface, is_command);
    let chosen: Vec<&Controller> = of_ros2(cx).collect();
    check_with(cx, out, (&all, &lacks), &chosen, RULE.severity);
    // what one of several robots offers is no help to another one that is started with the controller
    for paired in cx.robots.iter().filter(|paired| !paired.started.is_empty()) {
        let Some(own) = HardwareJoints::of_robots(std::slice::from_ref(paired)) else {
            continue;
        };
        let is_started = |one: &&Controller| paired.started.contains(&one.name.name);
        let started: Vec<&Controller> = of_ros2(cx).filter(is_started).collect();
        let lacks = |joint: &str, interface: &str, is_command| {
            own.lacks(joint, interface, is_command)
                && !all.lacks(joint, interface, is_command)
                && !started.iter().any(|one| fits(&own, one, joint))
        };
        check_with(cx, out, (&own, &lacks), &started, Severity::Warning);
    }
}

/// The controllers of the file that are for ROS 2.
fn of_ros2<'a>(cx: &BesideCx<'a>) -> impl Iterator<Item = &'a Controller> + use<'a> {
    let controllers = cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.controllers);
    controllers.filter(|controller| controller.is_ros2)
}

/// Whether a controller can command a joint with what the hardware offers.
fn fits(hardware: &HardwareJoints<'_>, controller: &Controller, joint: &str) -> bool {
    let mut named = controller.joints.iter().map(|(_, own)| &own.name);
    let offers =
        |(name, is_command): (&SpannedName, bool)| !hardware.lacks(joint, &name.name, is_command);
    named.any(|own| own == joint)
        && (!controller.commands.is_empty() || controller.interface.is_some())
        && interfaces(controller).all(offers)
}

/// Whether a joint has no interface of a name, for commands or not.
type Lacks<'l> = &'l dyn Fn(&str, &str, bool) -> bool;

fn check_with(
    cx: &BesideCx<'_>,
    out: &mut Sink<'_>,
    (hardware, lacks): (&HardwareJoints<'_>, Lacks<'_>),
    controllers: &[&Controller],
    severity: Severity,
) {
    for controller in controllers {
        let class = class_of(cx, controller);
        let fixed = COMMANDED.iter().filter(|(of, ..)| Some(*of) == class);
        let is_fixed = fixed.clone().next().is_some();
        let is_read = |is_command| {
            let is_unread = if is_command { is_broadcaster } else { is_blind };
            !class.is_some_and(is_unread)
        };
        let named =
            interfaces(controller).filter(|&(_, is_command)| !is_fixed && is_read(is_command));
        for (interface, is_command) in named {
            // with joints of their own, commands are not for `joints`
            let key = if is_command
                && controller
                    .joints
                    .iter()
                    .any(|(key, _)| key == "command_joints")
            {
                "command_joints"
            } else {
                "joints"
            };
            let lacking = joints(controller, key)
                .find(|joint| lacks(&joint.name, &interface.name, is_command));
            if let Some(joint) = lacking {
                let what = (joint.name.as_str(), interface.name.as_str(), is_command);
                report(cx, out, (hardware, severity), (interface, None), what);
            }
        }
        for (_, key, interface) in fixed {
            let lacking =
                joints(controller, key).filter(|joint| lacks(&joint.name, interface, true));
            // the joints of a controller are of one kind, and what they offer is set in one place
            let group = Group::Name(controller.name.name.clone());
            lacking.for_each(|joint| {
                let what = (joint.name.as_str(), *interface, true);
                report(cx, out, (hardware, severity), (joint, Some(&group)), what);
            });
        }
    }
}

/// Whether a controller commands the joints of its parameter `joints`.
pub(super) fn is_commanding(cx: &BesideCx<'_>, controller: &Controller) -> bool {
    let class = class_of(cx, controller);
    !controller.commands.is_empty() && !class.is_some_and(is_broadcaster)
        || controller.interface.is_some()
        || COMMANDED
            .iter()
            .any(|(of, key, _)| Some(*of) == class && *key == "joints")
}

/// The joints of a parameter.
fn joints<'a>(controller: &'a Controller, key: &str) -> impl Iterator<Item = &'a SpannedName> {
    controller
        .joints
        .iter()
        .filter(move |(own, _)| own == key)
        .map(|(_, joint)| joint)
}

/// Whether controllers of a class claim no state interfaces, whatever their parameters list.
/// Source: `state_interface_configuration` of `forward_command_controller` in ros2_controllers.
fn is_blind(class: &str) -> bool {
    class.starts_with("forward_command_controller/")
}

/// Whether controllers of a class only publish what they read, whatever their parameters list.
fn is_broadcaster(class: &str) -> bool {
    class.ends_with("Broadcaster")
}

/// The class of a controller: its own parameter, or what a controller manager says.
pub(super) fn class_of<'a>(cx: &BesideCx<'a>, controller: &'a Controller) -> Option<&'a str> {
    let mut listed = cx.all_settings().flat_map(|settings| &settings.listed);
    let own = controller.class.as_ref();
    let class = own.or_else(|| {
        Some(
            &listed
                .find(|one| one.name.name == controller.name.name)?
                .class,
        )
    });
    class.map(|class| class.name.as_str())
}

/// Report, at a place, that a joint lacks an interface.
fn report(
    cx: &BesideCx<'_>,
    out: &mut Sink<'_>,
    (hardware, severity): (&HardwareJoints<'_>, Severity),
    (place, group): (&SpannedName, Option<&Group>),
    (joint, interface, is_command): (&str, &str, bool),
) {
    if cx.may_offer(joint, interface, is_command) {
        return;
    }
    let kind = if is_command { "command" } else { "state" };
    let message = format!("joint `{joint}` has no {kind} interface `{interface}`");
    let offered = hardware.offered(joint, is_command);
    let help = if offered.is_empty() {
        format!("add <{kind}_interface name=\"{interface}\"/> to the joint in `<ros2_control>`")
    } else if place.name == joint {
        format!(
            "the controller commands it; the joint offers `{}`",
            offered.join("`, `")
        )
    } else {
        format!(
            "use an interface that the joint offers: `{}`",
            offered.join("`, `")
        )
    };
    let report = cx.report(out, place, message).severity(severity).help(help);
    match group {
        Some(group) => report.group(group.clone()).done(),
        None => report.done(),
    }
}

/// The interfaces that a controller names, with whether each is for commands.
fn interfaces(controller: &Controller) -> impl Iterator<Item = (&SpannedName, bool)> {
    let commands = controller
        .commands
        .iter()
        .chain(&controller.interface)
        .map(|name| (name, true));
    let all = commands.chain(controller.states.iter().map(|name| (name, false)));
    all.filter(|(name, _)| !is_computed(&name.name) && !name.name.contains('/'))
}
