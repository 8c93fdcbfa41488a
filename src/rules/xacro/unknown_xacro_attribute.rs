//! An attribute that the xacro element does not have.
use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use base::{Span, TextRange};

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC031",
    "unknown-xacro-attribute",
    Category::Xacro,
    Severity::Info,
    page("unknown-xacro-attribute"),
)
.fixed(Safety::Safe);

/// Remove it: expansion ignores it.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    without_attribute(cx, Safety::Safe)
}

/// Without the attribute whose name stands at the span, and the blanks in front of it.
pub(super) fn without_attribute(cx: &ProblemCx<'_>, safety: Safety) -> Option<Fix> {
    let (document, span) = (cx.document, cx.span);
    let place = document.item_at(span.range.start);
    let mut attrs = place.item.all_nodes().flat_map(|node| node.attrs());
    let attr = attrs.find(|attr| attr.name_range().shift(place.start) == span.range)?;
    let whole = attr.range().shift(place.start);
    let before = document.slice(TextRange::new(place.start, whole.start));
    let blanks = (before.len() - before.trim_end().len()) as u32;
    let range = TextRange::new(whole.start - blanks, whole.end);
    Some(Fix {
        safety,
        message: format!("remove `{}`", attr.name()),
        edits: vec![Edit {
            span: Span { range, ..span },
            content: String::new(),
        }],
    })
}
