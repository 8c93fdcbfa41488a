//! An axis whose length is not 1.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;

use super::super::numbers::{rewrite, short, vector};
use super::axis::{NO_LENGTH, length, moving_axes};

pub(super) const RULE: Rule = Rule {
    code: "JNT011",
    name: "axis-not-normalized",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("axis-not-normalized"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (joint, text, axis) in moving_axes(cx.joints()) {
        let length = length(axis);
        if length >= NO_LENGTH && (length - 1.0).abs() > 1e-3 {
            let message = format!(
                "axis of joint `{}` is not a unit vector: its length is {}",
                joint.shown(),
                short(length)
            );
            let report = out
                .report(text.origin, message)
                .help("normalize the axis; parsers use it unchanged, so motion is scaled by its length");
            rewrite(report, Safety::Unsafe, text, vector(&axis.map(|part| part / length))).done();
        }
    }
}
