//! A tool frame that moves against the last link.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{Joint, JointType, Link};

pub(super) static RULE: Rule = Rule {
    code: "FRM006",
    name: "tool0-not-fixed",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("tool0-not-fixed"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some((_, child)) = joint.ends() else {
        return;
    };
    let is_frame = ["tool0", "flange"].contains(&child.as_str());
    let Some(kind) = joint.kind.as_ref().filter(|_| is_frame) else {
        return;
    };
    if joint
        .joint_type()
        .is_some_and(|kind| kind != JointType::Fixed)
    {
        let message = format!(
            "parent joint `{}` of `{child}` is {} instead of fixed",
            joint.shown(),
            kind.value
        );
        let help = format!(
            "make another link the child of this joint, and attach `{child}` to it with a fixed joint"
        );
        out.report(kind.origin, message)
            .severity(severity(cx, child))
            .help(help)
            .done();
    }
}

/// How bad it is: a link with a shape is a body that only has the name of the frame.
fn severity(cx: &DocumentCx<'_>, link: &str) -> Severity {
    let is_body = |link: &Link| !link.visuals.is_empty() || !link.collisions.is_empty();
    if cx.links_named(link).any(is_body) {
        Severity::Info
    } else {
        RULE.severity
    }
}
