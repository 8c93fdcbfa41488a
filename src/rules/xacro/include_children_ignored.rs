//! Elements inside an include.
use super::super::finding::{Edit, Fix};
use super::super::problem_cx::ProblemCx;
use super::super::rule::{Category, Rule, Safety, Severity, page};
use base::{Span, TextRange};
use expand::Problem;
use xml::{Document, Node};

pub(in super::super) static RULE: Rule = Rule::found(
    "XAC033",
    "include-children-ignored",
    Category::Xacro,
    Severity::Warning,
    page("include-children-ignored"),
)
.fixed(Safety::Safe);

/// Arguments have the same value in each file of a robot: an include passes them on without its children.
pub(in super::super) fn severity(problem: &Problem, document: &Document) -> Severity {
    let place = document.item_at(problem.place.range.start);
    let at = |node: &Node<'_>| node.name_range().shift(place.start).end == problem.place.range.end;
    let include = place
        .item
        .all_nodes()
        .find(at)
        .and_then(|node| node.parent());
    let is_itself = |child: Node<'_>| {
        let name = child.attr("name").map_or("", |name| name.raw());
        child.name() == "xacro:arg"
            && child.attr("value").is_some_and(|value| {
                value.raw() == format!("$(arg {name})") || value.raw() == format!("${{{name}}}")
            })
    };
    if include.is_some_and(|include| include.child_elements().all(is_itself)) {
        Severity::Info
    } else {
        RULE.severity
    }
}

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
