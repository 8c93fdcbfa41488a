//! An axis along a negative coordinate axis.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::axis::moving_axis;
use model::Joint;

pub(super) static RULE: Rule = Rule {
    code: "JNT016",
    name: "negative-joint-axis",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("negative-joint-axis"),
    check: Check::Joint(check),
};

fn check(_: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some((text, axis)) = moving_axis(joint) else {
        return;
    };
    let zeros = axis.iter().filter(|part| **part == 0.0).count();
    if zeros == 2 && axis.contains(&-1.0) {
        out.report(
            text.origin,
            format!("joint `{}` has a negative axis", joint.shown()),
        )
        .help("use the positive axis if the sign agrees with the controller")
        .done();
    }
}
