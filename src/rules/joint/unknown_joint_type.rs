//! A type of joint that URDF does not know.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::numbers::rewrite;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::{Joint, JointType};
use packages::nearest;

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT001",
    name: "unknown-joint-type",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unknown-joint-type"),
    check: Check::Joint(check),
};

fn check(_: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some(kind) = joint.kind.as_ref().filter(|kind| kind.is_known()) else {
        return;
    };
    if JointType::of(&kind.value).is_some() {
        return;
    }
    let message = format!(
        "joint `{}` has unknown type `{}`",
        joint.shown(),
        kind.value
    );
    let report = out.report(kind.origin, message);
    let names = JointType::ALL.map(|(name, _)| name);
    let same = names
        .into_iter()
        .find(|name| name.eq_ignore_ascii_case(kind.value.trim()));
    match (same, nearest(&kind.value, names)) {
        (Some(name), _) => {
            rewrite(
                report.help(format!("write `{name}`; joint types are lower case")),
                Safety::Safe,
                kind,
                name.to_owned(),
            )
            .done();
        }
        (None, Some(near)) => report.help(Help::did_you_mean(near)).done(),
        (None, None) => report.help(advice(&kind.value)).done(),
    }
}

/// What to do about a type that resembles none.
fn advice(kind: &str) -> String {
    let alone = match kind {
        "spherical" => "only urdf-rs supports `spherical`; ",
        "ball" | "screw" | "universal" => "urdfdom does not support this type; ",
        _ => "",
    };
    format!("{alone}use revolute, continuous, prismatic, fixed, floating or planar")
}
