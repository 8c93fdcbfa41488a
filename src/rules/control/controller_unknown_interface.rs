//! A controller with an interface that its joints do not offer.

use super::super::beside::BesideCx;
use super::super::registry::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::hardware::Hardware;
use project::{Controller, Named, is_computed};

pub(super) const RULE: Rule = Rule::beside(
    "CTL027",
    "controller-unknown-interface",
    Category::Control,
    Severity::Error,
    page("controller-unknown-interface"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(hardware) = Hardware::of(cx) else { return };
    let controllers = cx.settings().into_iter().flat_map(|settings| &settings.controllers);
    for controller in controllers.filter(|controller| controller.is_ros2) {
        for (interface, is_command) in interfaces(controller) {
            let of = |key: &str| controller.joints.iter().any(|(own, _)| *own == key);
            // with joints of their own, commands are not for `joints`
            let key = if is_command && of("command_joints") { "command_joints" } else { "joints" };
            let joints = controller.joints.iter().filter(|(own, _)| *own == key).map(|(_, joint)| joint);
            let lacking = joints.filter(|joint| hardware.lacks(&joint.name, &interface.name, is_command));
            let Some(joint) = lacking.into_iter().next() else { continue };
            let kind = if is_command { "command" } else { "state" };
            let message = format!("joint `{}` has no {kind} interface `{}`", joint.name, interface.name);
            let offered = hardware.offered(&joint.name, is_command);
            let help = match offered.is_empty() {
                true => format!(
                    "add <{kind}_interface name=\"{}\"/> to the joint in `<ros2_control>`",
                    interface.name
                ),
                false => format!("use an interface that the joint offers: `{}`", offered.join("`, `")),
            };
            cx.report(out, interface, message).help(help).done();
        }
    }
}

/// The interfaces that a controller names, with whether each is for commands.
fn interfaces(controller: &Controller) -> impl Iterator<Item = (&Named, bool)> {
    let commands = controller.commands.iter().map(|name| (name, true));
    let all = commands.chain(controller.states.iter().map(|name| (name, false)));
    all.filter(|(name, _)| !is_computed(&name.name) && !name.name.contains('/'))
}
