//! A launch file that loads a xacro file as it is.
use super::super::finding::Finding;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG018",
    name: "launched-without-xacro",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("launched-without-xacro"),
    check: Check::Analysis,
};

/// The finding about a description with xacro elements or expressions that a launch file, in XML or Python, loads without xacro.
pub fn launched_without_xacro(span: Span, shown: &str, is_xml: bool) -> Finding {
    let message =
        format!("`{shown}` is loaded without xacro, so its xacro elements have no effect");
    let mut finding = Finding::new(&RULE, span, message);
    finding.help = Some(if is_xml {
        format!("expand it: `<param name=\"robot_description\" command=\"xacro {shown}\"/>`")
    } else {
        "expand it: `Command(['xacro ', path])`".to_owned()
    });
    finding
}
