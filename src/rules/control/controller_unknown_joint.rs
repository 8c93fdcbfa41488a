//! A controller with a joint that the robot does not have.
use super::super::beside::{BesideCx, PairedRobot};
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::controller_unknown_interface::class_of;
use project::{Controller, ProjectNameKind, is_computed};

pub(in super::super) static RULE: Rule = Rule::beside(
    "CTL025",
    "controller-unknown-joint",
    Category::Control,
    Severity::Error,
    page("controller-unknown-joint"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    for controller in cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.controllers)
    {
        // `pid/joint_1` is an interface of another controller
        let joints = controller
            .joints
            .iter()
            .filter(|(_, joint)| !joint.name.contains('/'));
        // and `twist.linear.x` is one of no joint
        let joints = joints.filter(|_| {
            !controller
                .commands
                .iter()
                .any(|name| name.name.contains('.'))
        });
        // of a joint that the hardware has as well, that place is reported
        let joints = joints.filter(|(_, joint)| !is_computed(&joint.name));
        let joints: Vec<_> = joints
            .filter(|(_, joint)| !is_in_hardware(cx, &joint.name))
            .collect();
        let unknown: Vec<_> = joints
            .iter()
            .filter(|(_, joint)| cx.lacks(ProjectNameKind::Joint, &joint.name))
            .collect();
        let is_for_another = unknown.len() == joints.len() && joints.len() > MOST_RENAMED;
        if unknown.is_empty()
            || is_for_another
            || publishes_all(cx, controller)
            || has_variant(cx, controller)
        {
            continue;
        }
        for (key, joint) in unknown {
            let message = format!(
                "`{key}` of controller `{}` has unknown joint `{}`",
                controller.name.name, joint.name
            );
            let severity = if registers_joints(cx) || cx.is_open() {
                Severity::Info
            } else {
                RULE.severity
            };
            let advice = cx.advice(ProjectNameKind::Joint, &joint.name);
            cx.report(out, joint, message)
                .severity(severity)
                .help(advice)
                .done();
        }
    }
}

/// Whether a controller is a broadcaster of joint states that publishes all joints: without `interfaces`, it does so whatever
/// joints are listed. Source: `joint_state_broadcaster` of ros2_controllers, whose documentation says that both are needed.
fn publishes_all(cx: &BesideCx<'_>, controller: &Controller) -> bool {
    const CLASS: &str = "joint_state_broadcaster/JointStateBroadcaster";
    !controller.has_interfaces && class_of(cx, controller) == Some(CLASS)
}

/// With more joints than these, all of them unknown, a controller is for another robot.
const MOST_RENAMED: usize = 2;

/// Whether another file has the same controller with joints that the robot has: this one is for another robot.
fn has_variant(cx: &BesideCx<'_>, controller: &Controller) -> bool {
    let all = cx.all_settings().flat_map(|settings| &settings.controllers);
    let mut same =
        all.filter(|other| other.name.name == controller.name.name && !other.joints.is_empty());
    same.any(|other| {
        other
            .joints
            .iter()
            .all(|(_, joint)| !cx.lacks(ProjectNameKind::Joint, &joint.name))
    })
}

/// Whether a `<ros2_control>` has a joint of that name.
fn is_in_hardware(cx: &BesideCx<'_>, name: &str) -> bool {
    let controls = cx.robots.iter().flat_map(|paired| &paired.robot.controls);
    let mut joints = controls.flat_map(|control| &control.joints);
    joints.any(|joint| joint.name.as_ref().is_some_and(|own| own.value == name))
}

/// Whether hardware of ROS 1 that is written in the workspace registers joints by itself, and the description says nothing
/// of them: neither transmissions nor hardware.
fn registers_joints(cx: &BesideCx<'_>) -> bool {
    let says_none = |paired: &PairedRobot<'_>| {
        paired.robot.transmissions.is_empty() && paired.robot.controls.is_empty()
    };
    cx.registers_joints && cx.robots.iter().all(says_none)
}
