//! A negative effort or velocity.

use super::super::context::DocumentCx;
use super::super::numbers::rewrite;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::JointType;

pub(super) const RULE: Rule = Rule {
    code: "JNT008",
    name: "joint-limit-negative",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("joint-limit-negative"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for joint in cx.joints().iter().filter(|joint| !joint.is(&[JointType::Fixed])) {
        let Some(limit) = &joint.limit else { continue };
        for (name, text) in [("effort", &limit.effort), ("velocity", &limit.velocity)] {
            let Some(text) = text else { continue };
            if let Some(value) = text.number().filter(|&value| value < 0.0) {
                // SDFormat reads -1 as "no limit"
                let severity = if value == -1.0 { Severity::Warning } else { Severity::Error };
                let message = format!("joint `{}` has the negative {name} {}", joint.shown(), text.value);
                let report = out
                    .report(text.origin, message)
                    .severity(severity)
                    .help("write its magnitude: it holds in both directions");
                rewrite(report, Safety::Unsafe, text, text.value.trim().trim_start_matches('-').to_owned())
                    .done();
            }
        }
    }
}
