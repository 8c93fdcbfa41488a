//! An axis whose length is not 1.
use super::super::context::DocumentCx;
use super::super::numbers::{rewrite, short, vector};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::axis::{NO_LENGTH, length, moving_axis};
use model::Joint;

pub(super) static RULE: Rule = Rule {
    code: "JNT011",
    name: "axis-not-normalized",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("axis-not-normalized"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some((text, axis)) = moving_axis(joint) else {
        return;
    };
    let length = length(axis);
    if length < NO_LENGTH || is_unit(length) {
        return;
    }
    let is_meant = is_rounded(length) || is_habit(cx, length) || is_diagonal(axis);
    let message = format!(
        "axis of joint `{}` is not a unit vector: its length is {}",
        joint.shown(),
        short(length)
    );
    let report = out
        .report(text.origin, message)
        .severity(if is_meant {
            Severity::Info
        } else {
            RULE.severity
        })
        .help("normalize the axis; parsers use it unchanged, so motion is scaled by its length");
    rewrite(
        report,
        Safety::Unsafe,
        text,
        vector(&axis.map(|part| part / length)),
    )
    .done();
}

/// Whether an axis is as long as one that was rounded to two digits.
fn is_rounded(length: f64) -> bool {
    (length - 1.0).abs() <= 1e-2
}

fn is_unit(length: f64) -> bool {
    (length - 1.0).abs() <= 1e-3
}

/// Whether three axes or more of a robot have the same length, which is not 1: a program or somebody wrote them in another unit, and
/// the directions are right.
fn is_habit(cx: &DocumentCx<'_>, own: f64) -> bool {
    const MANY: usize = 3;
    let lengths = cx.all().axis_lengths.get_or_init(|| {
        let axes = cx.joints().iter().filter_map(moving_axis);
        axes.map(|(_, axis)| length(axis)).collect()
    });
    let same = lengths
        .iter()
        .filter(|&&other| (other - own).abs() <= 1e-3 * own);
    same.take(MANY).count() == MANY
}

/// Whether an axis such as `1 1 0` is a direction that somebody wrote down without a root.
fn is_diagonal(axis: [f64; 3]) -> bool {
    let sizes = axis.map(f64::abs);
    sizes.iter().all(|&size| size == 0.0 || size == 1.0) && sizes.iter().sum::<f64>() >= 2.0
}
