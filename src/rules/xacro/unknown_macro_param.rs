//! An attribute of a call that is no parameter of the macro.
use super::super::finding::Fix;
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use super::unknown_xacro_attribute::without_attribute;

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC006",
    "unknown-macro-param",
    Category::Xacro,
    Severity::Error,
    page("unknown-macro-param"),
)
.fixed(Safety::Unsafe);

/// Remove it: unsafe, since the parameter may be what is missing.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    without_attribute(cx, Safety::Unsafe)
}
