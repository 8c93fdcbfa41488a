//! Short texts between the text: values of expressions, names of blocks, what a far end tag ends.

mod values;

use super::context::Cx;
use super::expressions::ExprText;
use super::values::cut;
use base::{Encoding, FastMap, TextRange};
use expand::{DefinitionId, SymbolKind, UseKind};
use values::Values;
use xml::{Document, Node, NodeKind};

/// Which hints are shown, and how long they may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HintSettings {
    /// Values of expressions.
    pub values: bool,
    /// Names of block parameters.
    pub blocks: bool,
    /// Most characters.
    pub most: usize,
}

impl Default for HintSettings {
    fn default() -> Self {
        Self {
            values: true,
            blocks: true,
            most: 24,
        }
    }
}

/// A short text between the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// Where it stands.
    pub offset: u32,
    /// What it says.
    pub label: String,
    /// What it is.
    pub kind: HintKind,
    /// The offset of what it is about.
    pub about: u32,
}

/// The kinds of hints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HintKind {
    /// The value of the expression in front.
    Value,
    /// The block parameter that the element behind is given for.
    Block,
    /// The name of what the end tag in front ends.
    End,
}

/// The hints in a range of the file, in document order.
pub fn hints(cx: &Cx<'_>, range: TextRange, settings: HintSettings) -> Vec<Hint> {
    let document = &cx.source.document;
    let calls = if settings.blocks {
        calls(cx)
    } else {
        FastMap::default()
    };
    let mut found = Vec::new();
    let mut values = Values::new(cx, settings.most);
    for (base, item) in document
        .parts()
        .filter(|(base, item)| overlaps(range, *base, item.len()))
    {
        for node in item.all_nodes() {
            let whole = node.range().shift(base);
            if !overlaps(range, whole.start, whole.len()) {
                continue;
            }
            match node.kind() {
                NodeKind::Text if settings.values && node.has_dollar() => {
                    values.of_text(&ExprText::of_text(document, base, node));
                }
                NodeKind::Element => {
                    let texts = node
                        .attrs()
                        .filter(|attr| attr.has_dollar() && attr.name() != "params");
                    for attr in texts.filter(|_| settings.values) {
                        values.of_attribute(&ExprText::of_attr(document, base, attr), node, attr);
                    }
                    if let Some(macro_id) = calls.get(&node.name_range().shift(base).end) {
                        blocks(cx, base, node, *macro_id, &mut found);
                    }
                    found.extend(end_name(document, base, node, settings.most));
                }
                _ => {}
            }
        }
    }
    found.extend(values.finish());
    found.retain(|hint| range.touches(hint.offset));
    found.sort_by_key(|hint| hint.offset);
    found
}

fn overlaps(range: TextRange, start: u32, length: u32) -> bool {
    start <= range.end && range.start <= start + length
}

/// The macro that each tag of the file calls, by the end of the tag's name.
fn calls(cx: &Cx<'_>) -> FastMap<u32, DefinitionId> {
    let bases = cx.bases();
    let calls = cx
        .expansion
        .index
        .symbols
        .all_uses()
        .filter(|used| used.kind == UseKind::Call);
    calls
        .filter_map(|used| {
            let base = bases.get(&used.place.src)?;
            Some((used.place.range.end + base, used.definition))
        })
        .collect()
}

fn blocks(cx: &Cx<'_>, base: u32, node: Node<'_>, called: DefinitionId, found: &mut Vec<Hint>) {
    let definitions = cx.expansion.index.symbols.definitions.iter();
    let blocks = definitions
        .filter(|given| given.of == Some(called) && given.kind == SymbolKind::BlockParameter);
    for (element, block) in node.child_elements().zip(blocks) {
        let offset = element.range().start + base;
        found.push(Hint {
            offset,
            label: format!("{}:", block.name),
            kind: HintKind::Block,
            about: offset,
        });
    }
}

/// The name behind an end tag that is far from its start.
fn end_name(document: &Document, base: u32, node: Node<'_>, most: usize) -> Option<Hint> {
    const FAR: u32 = 20;
    const NAMED: &[&str] = &["joint", "link", "xacro:macro"];
    if !NAMED.contains(&node.name()) || node.end_tag().is_none() {
        return None;
    }
    let name = node
        .attr("name")
        .map(|name| name.raw())
        .filter(|name| !name.is_empty())?;
    let range = node.range().shift(base);
    let [first, last] =
        [range.start, range.end].map(|offset| document.line_col(offset, Encoding::Utf8).line);
    if last - first < FAR {
        return None;
    }
    Some(Hint {
        offset: range.end,
        label: cut(name, most),
        kind: HintKind::End,
        about: range.start,
    })
}
