//! A limit without effort or velocity.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::schema;
use super::super::sink::Sink;
use super::super::xml::meant_attributes;
use model::{Joint, JointType, Limit, Version, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT003",
    name: "missing-limit-attribute",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-limit-attribute"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some(limit) = &joint.limit else { return };
    let is_new = Version::V1_2.is_in(&cx.expansion.tree);
    let mut missing = if is_new {
        missing_bounds(joint, limit)
    } else {
        missing_strength(limit)
    };
    if !missing.is_empty()
        && let Some(spec) = schema::urdf_element("limit")
    {
        let meant = meant_attributes(cx, limit.element, spec);
        missing.retain(|name| !meant.contains(name));
    }
    if missing.is_empty() {
        if !is_new {
            half_bounds(cx, joint, limit, out);
        }
        return;
    }
    let fixed = joint.is(&[JointType::Fixed]);
    let message = format!(
        "`limit` of joint `{}` has no {}",
        joint.shown(),
        missing.join(" and no ")
    );
    out.report(tag_start(cx.expansion, limit.element), message)
        .severity(if fixed { Severity::Info } else { Severity::Error })
        .help(if is_new {
            "add lower=\"...\" and upper=\"...\", which URDF 1.2 requires"
        } else {
            "add effort=\"...\" (N m or N) and velocity=\"...\" (rad/s or m/s), which urdfdom requires"
        })
        .done();
}

/// What a limit lacks before URDF 1.2.
fn missing_strength(limit: &Limit) -> Vec<&'static str> {
    let strength = [("effort", &limit.effort), ("velocity", &limit.velocity)];
    strength
        .into_iter()
        .filter(|(_, text)| text.is_none())
        .map(|(name, _)| name)
        .collect()
}

/// What a limit lacks from URDF 1.2 on.
fn missing_bounds(joint: &Joint, limit: &Limit) -> Vec<&'static str> {
    if !joint.is(&[JointType::Revolute, JointType::Prismatic]) {
        return Vec::new();
    }
    let bounds = [("lower", &limit.lower), ("upper", &limit.upper)];
    bounds
        .into_iter()
        .filter(|(_, text)| text.is_none())
        .map(|(name, _)| name)
        .collect()
}

/// Before URDF 1.2, a bound that is left out is 0: right for a gripper that opens from 0 on, and easily overlooked in an arm.
fn half_bounds(cx: &DocumentCx<'_>, joint: &Joint, limit: &Limit, out: &mut Sink<'_>) {
    let missing = missing_bounds(joint, limit);
    let [missing] = missing.as_slice() else {
        return;
    };
    out.report(
        tag_start(cx.expansion, limit.element),
        format!("`limit` of joint `{}` has no {missing}", joint.shown()),
    )
    .severity(Severity::Info)
    .help(format!("add {missing}=\"...\"; without it, the bound is 0"))
    .done();
}
