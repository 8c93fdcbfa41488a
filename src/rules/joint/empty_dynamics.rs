//! Dynamics that say nothing.
use super::super::context::DocumentCx;
use super::super::edits::delete_element;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::schema;
use super::super::sink::Sink;
use super::super::xml::meant_attributes;
use model::{Joint, element_range};

pub(super) static RULE: Rule = Rule {
    code: "JNT018",
    name: "empty-dynamics",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("empty-dynamics"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some(dynamics) = joint
        .dynamics
        .as_ref()
        .filter(|d| d.damping.is_none() && d.friction.is_none())
    else {
        return;
    };
    // a misspelled attribute has its own finding
    let spec = schema::urdf_element("dynamics");
    if spec.is_some_and(|spec| !meant_attributes(cx, dynamics.element, spec).is_empty()) {
        return;
    }
    let message = format!(
        "`dynamics` of joint `{}` has neither damping nor friction",
        joint.shown()
    );
    let report = out.report(element_range(cx.expansion, dynamics.element), message);
    let report =
        report.help("remove <dynamics>, or add damping=\"...\" or friction=\"...\"; urdfdom rejects the joint otherwise");
    delete_element(
        report,
        cx.expansion,
        dynamics.element,
        (Safety::Safe, "remove <dynamics>"),
    )
    .done();
}
