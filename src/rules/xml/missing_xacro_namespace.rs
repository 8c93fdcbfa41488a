//! A prefix that the root element does not declare.
use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use base::{Span, TextRange};

pub(in super::super) static RULE: Rule = Rule::found(
    "XML002",
    "missing-xacro-namespace",
    Category::Xml,
    Severity::Error,
    page("missing-xacro-namespace"),
)
.fixed(Safety::Safe);

/// Declare it where the root element begins.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    let root = cx
        .document
        .root()
        .filter(|root| root.attr("xmlns:xacro").is_none())?;
    let range = TextRange::empty(root.name_range().end);
    Some(Fix {
        safety: Safety::Safe,
        message: "declare the prefix `xacro`".to_owned(),
        edits: vec![Edit {
            span: Span { range, ..cx.span },
            content: " xmlns:xacro=\"http://www.ros.org/wiki/xacro\"".to_owned(),
        }],
    })
}
