//! A limit without effort or velocity.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{Joint, JointType, Limit, Version, tag_start};

pub(super) const RULE: Rule = Rule {
    code: "JNT003",
    name: "missing-limit-attribute",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-limit-attribute"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for joint in cx.joints() {
        let Some(limit) = &joint.limit else { continue };
        let is_new = Version::V1_2.is_in(&cx.expansion.tree);
        let missing = if is_new { missing_bounds(joint, limit) } else { missing_strength(limit) };
        if missing.is_empty() {
            continue;
        }
        let fixed = joint.is(&[JointType::Fixed]);
        let message = format!("the limit of joint `{}` has no {}", joint.shown(), missing.join(" and no "));
        out.report(tag_start(cx.expansion, limit.element), message)
            .severity(if fixed { Severity::Info } else { Severity::Error })
            .help(match is_new {
                true => "from URDF 1.2 on, urdfdom wants lower and upper in limits of these joints",
                false => "urdfdom wants effort (N m or N) and velocity (rad/s or m/s) in every limit",
            })
            .done();
    }
}

/// What a limit lacks before URDF 1.2.
fn missing_strength(limit: &Limit) -> Vec<&'static str> {
    let strength = [("effort", &limit.effort), ("velocity", &limit.velocity)];
    strength.into_iter().filter(|(_, text)| text.is_none()).map(|(name, _)| name).collect()
}

/// What a limit lacks from URDF 1.2 on.
fn missing_bounds(joint: &Joint, limit: &Limit) -> Vec<&'static str> {
    if !joint.is(&[JointType::Revolute, JointType::Prismatic]) {
        return Vec::new();
    }
    let bounds = [("lower", &limit.lower), ("upper", &limit.upper)];
    bounds.into_iter().filter(|(_, text)| text.is_none()).map(|(name, _)| name).collect()
}
