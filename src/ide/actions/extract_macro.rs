//! Elements become a macro, or a file of their own.

use super::place::{before, indented, line_end, margin, top_level};
use super::wrap::elements;
use super::{Action, ActionKind, edit};
use crate::{Cx, indentation};
use base::TextRange;
use expand::SymbolKind;
use expr::is_global_symbol;
use facts::{FactKind, MentionKind, facts};
use vfs::SourceFile;
use xml::{Document, Node, NodeKind};

/// A file to be made, and the text it gets.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewFile {
    /// Its name, in the folder of the file that is edited.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Make a macro of the selected elements. The names that they read and do not give become its parameters.
pub(super) fn extract_macro(cx: &Cx<'_>, selection: TextRange) -> Option<Action> {
    let source = cx.source;
    let document = &source.document;
    document.root()?.attr("xmlns:xacro")?;
    if selection.is_empty() {
        return None;
    }
    let range = elements(document, selection)?;
    let inside = nodes_in(document, range);
    // what it defines would be gone for what follows, and blocks belong to the macro around
    if inside.iter().any(|(_, node)| is_bound(*node)) {
        return None;
    }
    let mut names = free_names(document, range);
    // names of includes are known everywhere, and no values
    let symbols = &cx.expansion.index.symbols;
    names.retain(|name| {
        !symbols
            .iter()
            .any(|(_, it)| it.name == *name && it.kind == SymbolKind::Namespace)
    });
    let macro_name = free_macro_name(cx, "extracted");
    let at = before(document, range.start)?;
    let end = line_end(document);
    let unit = indentation(document).unit;
    let own = margin(document, range.start);
    let body = document
        .slice(range)
        .replace(&format!("\n{own}"), &format!("\n{unit}{unit}"));
    let params = if names.is_empty() {
        String::new()
    } else {
        format!(" params=\"{}\"", names.join(" "))
    };
    let definition = format!(
        "<xacro:macro name=\"{macro_name}\"{params}>{end}{unit}{unit}{body}{end}{unit}</xacro:macro>"
    );
    let given: Vec<String> = names
        .iter()
        .map(|name| format!(" {name}=\"${{{name}}}\""))
        .collect();
    let call = format!("<xacro:{macro_name}{}/>", given.concat());
    let edits = vec![
        edit(
            source,
            TextRange::empty(at),
            top_level(document, at, &definition),
        ),
        edit(source, range, call),
    ];
    let title = format!("extract selection to macro `{macro_name}`");
    Some(Action {
        title,
        kind: ActionKind::Extract,
        edits,
    })
}

/// The nodes of a range, with the offsets their ranges count from.
pub(super) fn nodes_in(document: &Document, range: TextRange) -> Vec<(u32, Node<'_>)> {
    let items = document
        .items()
        .filter(|(base, item)| *base < range.end && range.start < base + item.len());
    let nodes = items.flat_map(|(base, item)| item.all_nodes().map(move |node| (base, node)));
    nodes
        .filter(|(base, node)| {
            node.kind() == NodeKind::Element && range.contains_range(node.range().shift(*base))
        })
        .collect()
}

fn is_bound(node: Node<'_>) -> bool {
    matches!(
        node.name(),
        "xacro:property" | "xacro:macro" | "xacro:arg" | "xacro:include" | "xacro:insert_block"
    )
}

/// The names that expressions of a range read and that Python does not know, in order.
fn free_names(document: &Document, range: TextRange) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for (base, facts) in facts(document) {
        let sites = facts
            .sites()
            .iter()
            .filter(|site| range.contains_range(site.range.shift(base)));
        let mentions = sites.flat_map(|site| &site.mentions);
        for mention in mentions.filter(|mention| mention.kind == MentionKind::Name) {
            let name = mention.name.to_string();
            if name != "xacro" && !is_global_symbol(&name) && !names.contains(&name) {
                names.push(name);
            }
        }
    }
    names
}

fn free_macro_name(cx: &Cx<'_>, wanted: &str) -> String {
    let here = facts(&cx.source.document).flat_map(|(_, facts)| {
        facts
            .of(FactKind::Macro)
            .map(|fact| fact.name.to_string())
            .collect::<Vec<_>>()
    });
    let known: Vec<String> = here
        .chain(
            cx.expansion
                .index
                .symbols
                .definitions
                .iter()
                .map(|known| known.name.to_string()),
        )
        .collect();
    let numbered = (2..1000).map(|number| format!("{wanted}_{number}"));
    let mut names = std::iter::once(wanted.to_owned()).chain(numbered);
    names
        .find(|name| !known.contains(name))
        .unwrap_or_else(|| wanted.to_owned())
}

/// Move the selected children of the root to a file of their own, and include that.
pub fn move_to_file(
    source: &SourceFile,
    selection: TextRange,
    exists: impl Fn(&str) -> bool,
) -> Option<(Action, NewFile)> {
    let document = &source.document;
    let namespace = document.root()?.attr("xmlns:xacro")?.raw().to_owned();
    if selection.is_empty() || !document.errors().is_empty() {
        return None;
    }
    let range = elements(document, selection)?;
    let (base, first) = nodes_in(document, range).into_iter().next()?;
    // only what stands directly below the root means the same in another file
    if first.parent().is_some() || first.range().shift(base).start != range.start {
        return None;
    }
    let relative = ["load_yaml('", "$(dirname)", "<xacro:include filename=\""];
    let body = document.slice(range);
    if relative
        .iter()
        .any(|text| body.contains(text) && !body.contains("$(find "))
    {
        return None;
    }
    let wanted = name_of(first).unwrap_or_else(|| "part".to_owned());
    let numbered = (2..1000).map(|number| format!("{wanted}_{number}.xacro"));
    let name = std::iter::once(format!("{wanted}.xacro"))
        .chain(numbered)
        .find(|name| !exists(name))?;
    let (end, unit) = (line_end(document), indentation(document).unit);
    let own = margin(document, range.start);
    let body = body.replace(&format!("\n{own}"), &format!("\n{unit}"));
    let text = format!(
        "<?xml version=\"1.0\"?>{end}<robot xmlns:xacro=\"{namespace}\">{end}{unit}{body}{end}</robot>{end}"
    );
    let include = indented(
        document,
        range,
        &format!("<xacro:include filename=\"{name}\"/>"),
    )?;
    let title = format!("move selection to `{name}`");
    let action = Action {
        title,
        kind: ActionKind::Extract,
        edits: vec![edit(source, range, include)],
    };
    Some((action, NewFile { name, text }))
}

/// A name for a file, from that of what it will hold.
fn name_of(node: Node<'_>) -> Option<String> {
    let name = node.attr("name")?.raw();
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
    (!name.is_empty() && name.chars().all(plain)).then(|| name.to_owned())
}
