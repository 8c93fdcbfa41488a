//! A limit without effort or velocity.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::JointType;
use model::tag_start;

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
        let missing: Vec<&str> = [("effort", &limit.effort), ("velocity", &limit.velocity)]
            .into_iter()
            .filter(|(_, text)| text.is_none())
            .map(|(name, _)| name)
            .collect();
        if missing.is_empty() {
            continue;
        }
        let fixed = joint.is(&[JointType::Fixed]);
        let message = format!("the limit of joint `{}` has no {}", joint.shown(), missing.join(" and no "));
        out.report(tag_start(cx.expansion, limit.element), message)
            .severity(if fixed { Severity::Info } else { Severity::Error })
            .help("urdfdom wants effort (N m or N) and velocity (rad/s or m/s) in every limit")
            .done();
    }
}
