//! Elements inside an include.
use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use base::{Span, TextRange};
use xml::Node;

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC033",
    "include-children-ignored",
    Category::Xacro,
    Severity::Warning,
    page("include-children-ignored"),
)
.fixed(Safety::Safe);

/// Leave the tag of the include alone.
pub(in super::super) fn fix(cx: &ProblemCx<'_>) -> Option<Fix> {
    let (document, span) = (cx.document, cx.span);
    let place = document.item_at(span.range.start);
    let at = |node: &Node<'_>| node.name_range().shift(place.start).end == span.range.end;
    let include = place.item.all_nodes().find(at)?.parent()?;
    let (start, end) = (include.start_tag_range(), include.end_tag()?);
    let range = TextRange::new(start.end, end.start).shift(place.start);
    Some(Fix {
        safety: Safety::Safe,
        message: "remove the content of the include".to_owned(),
        edits: vec![Edit {
            span: Span { range, ..span },
            content: String::new(),
        }],
    })
}
