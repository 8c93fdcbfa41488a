//! Negative damping or friction.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::Joint;

pub(super) static RULE: Rule = Rule {
    code: "JNT019",
    name: "negative-dynamics",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("negative-dynamics"),
    check: Check::Joint(check),
};

fn check(_: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some(dynamics) = &joint.dynamics else {
        return;
    };
    for (name, text) in [
        ("damping", &dynamics.damping),
        ("friction", &dynamics.friction),
    ] {
        let Some(text) = text else { continue };
        if text.number().is_some_and(|value| value < 0.0) {
            out.report(
                text.origin,
                format!(
                    "joint `{}` has negative {name} {}",
                    joint.shown(),
                    text.value
                ),
            )
            .help("write 0 or more; a negative value makes simulations unstable")
            .done();
        }
    }
}
