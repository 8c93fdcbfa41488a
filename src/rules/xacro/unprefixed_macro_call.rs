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
    for (base, node) in outside_free_zones(cx.other_elements()) {
        let name = node.name();
        if !cx.macros().contains(name) || is_urdf_element(name) || is_output(cx, node) {
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

/// Whether a tag with the name of a macro is meant for the robot: the macro itself writes it and does not call itself with
/// what it needs, or it has attributes and the macro has no parameter for any of them.
fn is_output(cx: &FileCx<'_>, node: Node<'_>) -> bool {
    let name = node.name();
    let is_own = |around: &Node<'_>| around.name() == "xacro:macro" && defines(*around, name);
    if let Some(own) = ancestors(node).find(is_own) {
        return !may_call(node, own);
    }
    let files = &cx.expansion.files;
    let items = files.iter().flat_map(|file| file.source.document.parts());
    let mut macros = items
        .flat_map(|(_, item)| item.all_nodes())
        .filter(|node| node.name() == "xacro:macro" && defines(*node, name))
        .peekable();
    let given = given(node);
    let takes = |one: Node<'_>| params(one).iter().any(|(name, _)| given.contains(name));
    !given.is_empty() && macros.peek().is_some() && !macros.any(takes)
}

/// Whether a tag gives a macro what it needs, and nothing else.
fn may_call(node: Node<'_>, own: Node<'_>) -> bool {
    let (given, params) = (given(node), params(own));
    let is_known = |name: &String| params.iter().any(|(param, _)| param == name);
    let is_given = |(name, is_needed): &(String, bool)| !is_needed || given.contains(name);
    given.iter().all(is_known) && params.iter().all(is_given)
}

/// The attributes of a tag.
fn given(node: Node<'_>) -> Vec<String> {
    let names = node.attrs().map(|attr| attr.name().to_owned());
    names.filter(|name| !name.starts_with("xmlns")).collect()
}

/// The parameters of a macro, blocks left out, and whether each has to be given.
fn params(own: Node<'_>) -> Vec<(String, bool)> {
    let params = own.attr("params").map(|params| params.raw().to_owned());
    let params = params.unwrap_or_default();
    let param = |param: &str| match param.split_once([':', '=']) {
        Some((name, _)) => (name.to_owned(), false),
        None => (param.to_owned(), true),
    };
    params
        .split_whitespace()
        .filter(|word| !word.starts_with('*'))
        .map(param)
        .collect()
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
