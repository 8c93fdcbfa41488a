//! A macro called without the prefix `xacro:`.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::{is_urdf_element, outside_free_zones};
use base::TextRange;
use xml::Node;

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC021",
    name: "unprefixed-macro-call",
    category: Category::Xacro,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unprefixed-macro-call"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for (base, node) in outside_free_zones(cx.elements()) {
        let name = node.name();
        if !cx.macros.contains(name) || is_urdf_element(name) || is_output(cx, node) {
            continue;
        }
        let start = node.name_range().shift(base);
        let end = node.end_name_range().map(|range| range.shift(base));
        let edits = [Some(start), end]
            .into_iter()
            .flatten()
            .map(|range| (TextRange::empty(range.start), "xacro:".to_owned()));
        let message =
            format!("call of macro `{name}` is missing the `xacro:` prefix, so xacro ignores it");
        out.report_in(cx.file, TextRange::new(start.start - 1, start.end), message)
            .help(format!("write `xacro:{name}`"))
            .fix(Safety::Safe, "add the prefix `xacro:`", cx.file, edits)
            .done();
    }
}

/// Whether a tag with the name of a macro is meant for the robot: the macro itself writes it, or it has attributes and the
/// macro has no parameter for any of them.
fn is_output(cx: &FileCx<'_>, node: Node<'_>) -> bool {
    let name = node.name();
    let is_own = |around: Node<'_>| around.name() == "xacro:macro" && defines(around, name);
    if ancestors(node).any(is_own) {
        return true;
    }
    let given: Vec<&str> = node
        .attrs()
        .map(|attr| attr.name())
        .filter(|name| !name.starts_with("xmlns"))
        .collect();
    let files = &cx.expansion.files;
    let items = files.iter().flat_map(|file| file.source.document.parts());
    let mut macros = items
        .flat_map(|(_, item)| item.all_nodes())
        .filter(|node| node.name() == "xacro:macro" && defines(*node, name))
        .peekable();
    let takes = |one: Node<'_>| {
        let params = one.attr("params").map(|params| params.raw().to_owned());
        let params = params.unwrap_or_default();
        let mut names = params
            .split_whitespace()
            .map(|param| param.split(':').next().unwrap_or(param));
        names.any(|param| given.contains(&param))
    };
    !given.is_empty() && macros.peek().is_some() && !macros.any(takes)
}

/// Whether a tag defines the macro of a name.
fn defines(node: Node<'_>, name: &str) -> bool {
    let own = node.attr("name").map(|own| own.raw().to_owned());
    own.is_some_and(|own| own.trim_start_matches("xacro:") == name)
}

/// The elements around a node.
fn ancestors(node: Node<'_>) -> impl Iterator<Item = Node<'_>> {
    std::iter::successors(node.parent(), |node| node.parent())
}
