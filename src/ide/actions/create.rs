//! Things that are used and do not exist: made where they are missed.

use super::place::{before, element_at, enclosing, first_child, last_child, top_level};
use super::{Action, edit, fix};
use crate::schema;
use base::TextRange;
use expr::is_identifier;
use vfs::SourceFile;
use xml::{Document, Node};

/// A property of the name, or a parameter of the macro around.
pub(super) fn undefined_property(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let name = source.document.slice(range);
    if !is_identifier(&name) {
        return Vec::new();
    }
    let parameter = parameter(source, range, &name);
    property(source, range, &name)
        .into_iter()
        .chain(parameter)
        .collect()
}

/// A declaration of the argument.
pub(super) fn undefined_arg(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let name = source.document.slice(range);
    if is_plain(&name) {
        argument(source, &name).into_iter().collect()
    } else {
        Vec::new()
    }
}

/// A macro that takes what the call gives.
pub(super) fn undefined_macro(source: &SourceFile, range: TextRange) -> Vec<Action> {
    new_macro(source, range).into_iter().collect()
}

/// A link of the name.
pub(super) fn undefined_link(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let name = source.document.slice(range);
    if !is_plain(&name) {
        return Vec::new();
    }
    let text = format!("<link name=\"{name}\"/>");
    element(source, range, format!("add link `{name}`"), text)
}

/// A gray material of the name.
pub(super) fn undefined_material(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let name = source.document.slice(range);
    if !is_plain(&name) {
        return Vec::new();
    }
    let text = format!("<material name=\"{name}\"><color rgba=\"0.5 0.5 0.5 1\"/></material>");
    element(source, range, format!("add material `{name}`"), text)
}

/// A limit of the joint, to be filled in.
pub(super) fn missing_joint_limit(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let limit = "<limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>";
    child(source, range, "joint", "add `limit`", limit)
}

/// Whether a name can be written into an attribute as it is.
fn is_plain(name: &str) -> bool {
    !name.is_empty()
        && !name.contains(|c: char| matches!(c, '$' | '<' | '&' | '"' | '\'') || c.is_control())
}

fn speaks_xacro(document: &Document) -> bool {
    document
        .root()
        .is_some_and(|root| root.attr("xmlns:xacro").is_some())
}

/// A new child of the root in front of the element at a range.
fn element(source: &SourceFile, range: TextRange, title: String, text: String) -> Vec<Action> {
    let at = before(&source.document, range.start);
    let made = at.map(|at| {
        let text = top_level(&source.document, at, &text);
        fix(title, vec![edit(source, TextRange::empty(at), text)])
    });
    made.into_iter().collect()
}

fn property(source: &SourceFile, range: TextRange, name: &str) -> Option<Action> {
    let text = format!("<xacro:property name=\"{name}\" value=\"0\"/>");
    element(source, range, format!("add property `{name}`"), text).pop()
}

/// A further parameter of the macro around.
fn parameter(source: &SourceFile, range: TextRange, name: &str) -> Option<Action> {
    let (base, node) = enclosing(&source.document, range.start, "xacro:macro")?;
    let title = format!(
        "add parameter `{name}` to macro `{}`",
        node.attr("name")?.raw()
    );
    let new = match node.attr("params") {
        Some(params) => {
            let at = TextRange::empty(base + params.value_range().end);
            let blank = if params.raw().is_empty() || params.raw().ends_with(' ') {
                ""
            } else {
                " "
            };
            edit(source, at, format!("{blank}{name}"))
        }
        None => {
            let at = TextRange::empty(base + node.attr("name")?.range().end);
            edit(source, at, format!(" params=\"{name}\""))
        }
    };
    Some(fix(title, vec![new]))
}

/// Arguments are declared before anything reads them.
fn argument(source: &SourceFile, name: &str) -> Option<Action> {
    let at = first_child(&source.document)?;
    let text = top_level(
        &source.document,
        at,
        &format!("<xacro:arg name=\"{name}\" default=\"\"/>"),
    );
    Some(fix(
        format!("add argument `{name}`"),
        vec![edit(source, TextRange::empty(at), text)],
    ))
}

/// The name that an element calls a macro by.
fn called<'a>(node: Node<'a>) -> Option<&'a str> {
    node.name()
        .strip_prefix("xacro:")
        .filter(|name| !name.is_empty() && !name.contains('.'))
}

/// A macro that takes what the call gives.
fn new_macro(source: &SourceFile, range: TextRange) -> Option<Action> {
    let (_, node) = element_at(&source.document, range.start)?;
    let name = called(node)?;
    let mut params: Vec<String> = node.attrs().map(|attr| attr.name().to_owned()).collect();
    params.retain(|name| is_identifier(name));
    if node.child_elements().next().is_some() {
        params.push("*content".to_owned());
    }
    let text = format!(
        "<xacro:macro name=\"{name}\" params=\"{}\"></xacro:macro>",
        params.join(" ")
    );
    element(source, range, format!("add macro `{name}`"), text).pop()
}

/// A file that defines a macro.
pub struct MacroFile {
    /// How an include names it.
    pub filename: String,
}

/// Include files that define the macro that is called at a range.
pub fn include_macro(
    source: &SourceFile,
    range: TextRange,
    find: impl FnOnce(&str) -> Vec<MacroFile>,
) -> Vec<Action> {
    let document = &source.document;
    let name = element_at(document, range.start).and_then(|(_, node)| called(node));
    let (Some(name), true) = (name, speaks_xacro(document)) else {
        return Vec::new();
    };
    let files = find(name)
        .into_iter()
        .filter(|file| !file.filename.contains(['"', '<', '&']));
    let include = |file: MacroFile| {
        let title = format!("include `{}`", file.filename);
        let text = format!("<xacro:include filename=\"{}\"/>", file.filename);
        element(source, range, title, text)
    };
    files.flat_map(include).collect()
}

/// A new child of the element at a range.
fn child(
    source: &SourceFile,
    range: TextRange,
    parent: &str,
    title: &str,
    text: &str,
) -> Vec<Action> {
    let Some((base, node)) = element_at(&source.document, range.start) else {
        return Vec::new();
    };
    if node.name() != parent {
        return Vec::new();
    }
    let (range, text) = last_child(source, base, node, text);
    vec![fix(title.to_owned(), vec![edit(source, range, text)])]
}

/// The attributes that parsers insist on, to be filled in.
pub(super) fn missing_attributes(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let Some((base, node)) = element_at(&source.document, range.start) else {
        return Vec::new();
    };
    let specs = schema::element(node);
    let [spec] = specs.as_slice() else {
        return Vec::new();
    };
    let missing = spec
        .attributes
        .iter()
        .filter(|attr| attr.required && node.attr(attr.name).is_none());
    let missing: Vec<&str> = missing.map(|attr| attr.name).collect();
    if missing.is_empty() {
        return Vec::new();
    }
    let text: String = missing.iter().map(|name| format!(" {name}=\"\"")).collect();
    let at = node
        .attrs()
        .last()
        .map_or(node.name_range().end, |attr| attr.range().end);
    let title = format!("add `{}`", missing.join("` and `"));
    vec![fix(
        title,
        vec![edit(source, TextRange::empty(base + at), text)],
    )]
}
