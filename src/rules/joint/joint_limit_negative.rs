//! A negative effort or velocity.
use super::super::context::DocumentCx;
use super::super::control::driven;
use super::super::numbers::{UNLIMITED, rewrite};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::{Joint, JointType, Limit, Robot, Version};

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT008",
    name: "joint-limit-negative",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("joint-limit-negative"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if joint.is(&[JointType::Fixed]) {
        return;
    }
    let Some(limit) = &joint.limit else { return };
    let is_new = Version::V1_2.is_in(&cx.expansion.tree);
    let strength = [("effort", &limit.effort), ("velocity", &limit.velocity)];
    for (name, text) in strength
        .into_iter()
        .chain(Limit::DYNAMIC.into_iter().zip(&limit.dynamic))
    {
        let Some(text) = text else { continue };
        if let Some(value) = text.number().filter(|&value| value < 0.0) {
            // SDFormat reads -1 as "no limit"; urdfdom refuses it from URDF 1.2 on
            let severity = if value != -1.0 || is_new {
                Severity::Error
            } else if is_only_driven(cx, joint) || is_endless(limit) {
                Severity::Info
            } else {
                Severity::Warning
            };
            let message = format!(
                "joint `{}` has negative {name} {}",
                joint.shown(),
                text.value
            );
            let report = out
                .report(text.origin, message)
                .severity(severity)
                .help("write the value without the sign; it applies to both directions");
            rewrite(
                report,
                Safety::Unsafe,
                text,
                text.value.trim().trim_start_matches('-').to_owned(),
            )
            .done();
        }
    }
}

/// Whether the range of a joint stands for none as well, as SDFormat writes it: nobody has limits in mind.
fn is_endless(limit: &Limit) -> bool {
    limit
        .range()
        .is_some_and(|(lower, upper)| -lower >= UNLIMITED && upper >= UNLIMITED)
}

/// Whether a plugin of Gazebo for drives moves a joint, and nothing else does: there, `-1` means what it says.
fn is_only_driven(cx: &DocumentCx<'_>, joint: &Joint) -> bool {
    let Some(robot) = cx.robot else { return false };
    let joint = joint.shown();
    let mut driven = driven(&cx.expansion.tree, robot).into_iter();
    driven.any(|name| name.value.trim() == joint) && !is_controlled(robot, joint)
}

/// Whether hardware of ros2_control or a transmission moves a joint.
fn is_controlled(robot: &Robot, joint: &str) -> bool {
    let hardware = robot.controls.iter().flat_map(|control| &control.joints);
    let listed = hardware.filter_map(|joint| joint.name.as_ref());
    let transmitted = robot.transmissions.iter().flat_map(|one| &one.joints);
    let transmitted = transmitted.filter_map(|(_, name)| name.as_ref());
    listed.chain(transmitted).any(|name| name.value == joint)
}
