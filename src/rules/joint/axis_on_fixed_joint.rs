//! Axis, limits or dynamics of a fixed joint.
use super::super::context::DocumentCx;
use super::super::edits::delete_element;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::{Joint, JointType, element_range};

pub(super) static RULE: Rule = Rule {
    code: "JNT012",
    name: "axis-on-fixed-joint",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("axis-on-fixed-joint"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if !joint.is(&[JointType::Fixed]) {
        return;
    }
    let parts = [
        ("axis", joint.axis.as_ref().map(|axis| axis.element)),
        ("limit", joint.limit.as_ref().map(|limit| limit.element)),
        (
            "dynamics",
            joint.dynamics.as_ref().map(|dynamics| dynamics.element),
        ),
    ];
    for (name, element) in parts
        .into_iter()
        .filter_map(|(name, element)| Some((name, element?)))
    {
        let message = format!("`{name}` has no effect on fixed joint `{}`", joint.shown());
        let report = out.report(element_range(cx.expansion, element), message);
        let fix = format!("remove <{name}>");
        delete_element(
            report.help(fix.clone()),
            cx.expansion,
            element,
            (Safety::Safe, &fix),
        )
        .done();
    }
}
