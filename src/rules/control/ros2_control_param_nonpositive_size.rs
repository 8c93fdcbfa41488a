//! A number of interfaces that is no positive integer.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::AttrValue;

pub(super) static RULE: Rule = Rule {
    code: "CTL017",
    name: "ros2-control-param-nonpositive-size",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-param-nonpositive-size"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let blocks = cx.robot.into_iter().flat_map(|robot| &robot.controls);
    let parts = blocks.flat_map(|control| tree.elements(control.element));
    let interfaces = parts
        .flat_map(|part| tree.elements(part))
        .filter(|&id| tree.get(id).text.ends_with("_interface"));
    for text in interfaces.filter_map(|interface| AttrValue::attr(tree, interface, "size")) {
        let digits = text.value.bytes().all(|byte| byte.is_ascii_digit());
        if text.is_known() && (!digits || text.value.bytes().all(|byte| byte == b'0')) {
            out.report(
                text.origin,
                format!("size `{}` is not a positive integer", text.value),
            )
            .help("write the number of values of the interface, for example 1")
            .done();
        }
    }
}
