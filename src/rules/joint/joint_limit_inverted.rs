//! A lower limit above the upper one.
use super::super::context::DocumentCx;
use super::super::edits::{is_called, source_text};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::{Reported, Sink};
use model::JointType::{Continuous, Fixed, Floating};
use model::{Joint, Limit, tag_start};

/// What to do, unless more is known.
const SWAP: &str = "swap the limits, or correct a sign";

pub(super) static RULE: Rule = Rule {
    code: "JNT004",
    name: "joint-limit-inverted",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("joint-limit-inverted"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if joint.is(&[Continuous, Fixed, Floating]) {
        return;
    }
    let Some(limit) = &joint.limit else { return };
    let Some((lower, upper)) = limit.range().filter(|(lower, upper)| lower > upper) else {
        return;
    };
    let message = format!(
        "lower limit {lower} of joint `{}` is greater than upper limit {upper}",
        joint.shown()
    );
    let report = out
        .report(tag_start(cx.expansion, limit.element), message)
        .help(SWAP);
    swapped(report, cx, limit).done();
}

/// With the fix to swap both values.
fn swapped<'s, 'a>(
    report: Reported<'s, 'a>,
    cx: &DocumentCx<'_>,
    limit: &Limit,
) -> Reported<'s, 'a> {
    let (Some(lower), Some(upper)) = (&limit.lower, &limit.upper) else {
        return report.help("add the missing limit; its default is 0");
    };
    if [lower, upper]
        .into_iter()
        .any(|text| !text.is_literal() && is_called(cx.expansion, text.origin))
    {
        return report.help("swap the values in the macro calls");
    }
    let texts = (
        source_text(cx.expansion, lower.origin),
        source_text(cx.expansion, upper.origin),
    );
    let (Some((file, at_lower, low)), Some((_, at_upper, up))) = texts else {
        return report;
    };
    let edits = [(at_lower, up), (at_upper, low)];
    report.fix(Safety::Unsafe, "swap lower and upper", file, edits)
}
