//! A comment about something left to do.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use xml::NodeKind;

pub(super) static RULE: Rule = Rule {
    code: "STY004",
    name: "todo-comment",
    category: Category::Style,
    severity: Severity::Hint,
    default: Activation::Profiles(&["pedantic"]),
    since: "0.1",
    fix: None,
    docs: page("todo-comment"),
    check: Check::File(check),
};

/// Words that say something is left to do.
const TODO_MARKERS: [&str; 2] = ["TODO", "FIXME"];

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for (base, item) in cx.source.document.parts() {
        for node in item
            .all_nodes()
            .filter(|node| node.kind() == NodeKind::Comment)
        {
            let mut words = node.raw().split(|c: char| !c.is_alphanumeric());
            if let Some(word) = words.find(|word| TODO_MARKERS.contains(word)) {
                out.report_in(
                    cx.file,
                    node.range().shift(base),
                    format!("`{word}` in a comment"),
                )
                .help("resolve it, or move it to an issue tracker")
                .done();
            }
        }
    }
}
