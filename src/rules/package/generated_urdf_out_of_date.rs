//! A file that xacro generated, and that differs from what its source gives.
use super::super::finding::Finding;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use base::Span;

pub(in super::super) static RULE: Rule = Rule {
    code: "PKG011",
    name: "generated-urdf-out-of-date",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("generated-urdf-out-of-date"),
    check: Check::Analysis,
};

/// The finding about a generated file, at the name of its source in the banner of xacro.
pub fn generated_urdf_out_of_date(span: Span, source: &str, help: String) -> Finding {
    let message = format!("generated file is out of date: `{source}` gives another robot");
    Finding {
        help: Some(help),
        ..Finding::new(&RULE, span, message)
    }
}
