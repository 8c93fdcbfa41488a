//! Names inside of a macro get the prefix that each call gives.

use super::extract_macro::nodes_in;
use super::place::enclosing;
use super::wrap::elements;
use super::{Action, ActionKind, edit};
use base::TextRange;
use rules::Edit;
use vfs::SourceFile;
use xml::{Attr, Node};

const PREFIX: &str = "${prefix}";

/// Put `${prefix}` in front of the names of the selected links and joints of a macro, and wherever the macro refers to
/// them. The macro gets the parameter, empty unless a call gives it.
pub(super) fn names(source: &SourceFile, selection: TextRange) -> Option<Action> {
    let document = &source.document;
    let range = elements(document, selection)?;
    let (base, around) = enclosing(document, range.start, "xacro:macro")?;
    let named: Vec<String> = nodes_in(document, range)
        .into_iter()
        .filter_map(|(_, node)| given(node))
        .map(|a| a.raw().to_owned())
        .collect();
    if named.is_empty() {
        return None;
    }
    let body = around.range().shift(base);
    let mut edits: Vec<Edit> = Vec::new();
    for (base, node) in nodes_in(document, body) {
        let attrs = given(node)
            .into_iter()
            .filter(|_| range.contains_range(node.range().shift(base)));
        for attr in attrs
            .chain(referring(node))
            .filter(|attr| named.iter().any(|name| name == attr.raw()))
        {
            let at = TextRange::empty(base + attr.value_range().start);
            edits.push(edit(source, at, PREFIX));
        }
    }
    edits.extend(parameter(source, base, around));
    edits.sort_by_key(|edit| edit.span.range.start);
    let title = "add `${prefix}` to names".to_owned();
    Some(Action {
        title,
        kind: ActionKind::Rewrite,
        edits,
    })
}

/// The name that a link or joint gives, when it has no prefix yet.
fn given<'a>(node: Node<'a>) -> Option<Attr<'a>> {
    if !matches!(node.name(), "link" | "joint")
        || node.name() == "joint" && node.attr("type").is_none()
    {
        return None;
    }
    node.attr("name")
        .filter(|name| !name.raw().is_empty() && !name.raw().contains(PREFIX))
}

/// The attribute that refers to a link or joint.
fn referring<'a>(node: Node<'a>) -> Option<Attr<'a>> {
    match node.name() {
        "parent" | "child" => node.attr("link"),
        "mimic" => node.attr("joint"),
        "gazebo" => node.attr("reference"),
        "joint" if node.attr("type").is_none() => node.attr("name"),
        _ => None,
    }
}

/// The parameter of the macro, unless it has it.
fn parameter(source: &SourceFile, base: u32, around: Node<'_>) -> Option<Edit> {
    const NEW: &str = "prefix:=''";
    let Some(params) = around.attr("params") else {
        let at = TextRange::empty(base + around.attr("name")?.range().end);
        return Some(edit(source, at, format!(" params=\"{NEW}\"")));
    };
    let known = params.raw().split_whitespace();
    let mut known = known.map(|spec| spec.split([':', '=']).next().unwrap_or(spec));
    if known.any(|name| name == "prefix") {
        return None;
    }
    let blank = if params.raw().is_empty() || params.raw().ends_with(' ') {
        ""
    } else {
        " "
    };
    Some(edit(
        source,
        TextRange::empty(base + params.value_range().end),
        format!("{blank}{NEW}"),
    ))
}
