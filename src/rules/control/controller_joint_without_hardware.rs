//! A controller with a joint that is in no `<ros2_control>` of the robot.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::controller_unknown_interface::is_commanding;
use super::hardware::HardwareJoints;
use project::joint_keys;

pub(super) static RULE: Rule = Rule::beside(
    "CTL026",
    "controller-joint-without-hardware",
    Category::Control,
    Severity::Warning,
    page("controller-joint-without-hardware"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(hardware) = HardwareJoints::of(cx).filter(|hardware| hardware.is_complete) else {
        return;
    };
    let controllers = cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.controllers);
    for controller in controllers.filter(|controller| controller.is_ros2) {
        for (key, joint) in &controller.joints {
            // the joints that the broadcaster publishes need no hardware
            let is_driven = match key.as_str() {
                "joints" => is_commanding(cx, controller),
                key => key != "extra_joints" && joint_keys().contains(&key),
            };
            let is_known = hardware.has(&joint.name) || cx.may_drive(&joint.name);
            if !is_driven || is_known || cx.joints(&joint.name).next().is_none() {
                continue;
            }
            let message = format!(
                "joint `{}` of controller `{}` is not in `<ros2_control>`",
                joint.name, controller.name.name
            );
            let help = format!(
                "add <joint name=\"{}\"> with its interfaces to `<ros2_control>`",
                joint.name
            );
            cx.report(out, joint, message).help(help).done();
        }
    }
}
