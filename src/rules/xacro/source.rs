//! From definitions and uses back to the tags of the source.
use std::path::Path;

use super::super::context::{DocumentCx, RuleEnv};
use base::{FastMap, FileId, Span, TextRange};
use expand::{Definition, Expansion, FileIdx, FileRange, FrameId, FrameKind, SourceRange};
use xml::{Document, Node};

/// Whether a context is about the whole document, not about a macro that nothing calls.
pub(super) fn is_main(cx: &DocumentCx<'_>) -> bool {
    cx.expansion.tree.root() == Some(cx.element)
}

/// The absolute place of a text.
pub(super) fn place(expansion: &Expansion, at: SourceRange) -> Option<FileRange> {
    let source = expansion.sources.get(at.src)?;
    Some(FileRange {
        file: source.file,
        range: at.range.shift(source.base),
    })
}

/// The innermost element whose start tag holds a text, with the offset its ranges count from.
pub(super) fn tag(expansion: &Expansion, at: SourceRange) -> Option<(u32, Node<'_>)> {
    let source = expansion.sources.get(at.src)?;
    let node = source
        .item
        .all_nodes()
        .find(|node| node.start_tag_range().contains_range(at.range))?;
    Some((source.base, node))
}

/// The tag of a definition.
pub(super) fn definition_tag<'a>(
    expansion: &'a Expansion,
    definition: &Definition,
) -> Option<Node<'a>> {
    tag(expansion, definition.place).map(|(_, node)| node)
}

/// Whether a conditional stands around an element, in its file.
pub(super) fn is_conditional(node: Node<'_>) -> bool {
    let around = std::iter::successors(node.parent(), |node| node.parent());
    around
        .into_iter()
        .any(|node| matches!(node.name(), "xacro:if" | "xacro:unless"))
}

/// The macro that an element stands in.
pub(super) fn macro_around(node: Node<'_>) -> Option<Node<'_>> {
    std::iter::successors(node.parent(), |node| node.parent())
        .find(|node| node.name() == "xacro:macro")
}

/// The name of a file without its folders.
pub(super) fn file_name(expansion: &Expansion, file: FileIdx) -> &str {
    let name = expansion
        .files
        .get(file)
        .map_or("", |file| file.name.as_str());
    name.rsplit('/').next().unwrap_or(name)
}

/// What to delete to remove an element: with its line, when nothing else is on it.
pub(super) fn removal(document: &Document, element: TextRange) -> TextRange {
    /// Nobody indents farther, and a line may be as long as the file.
    const FAR: u32 = 1000;
    let (before, behind) = document.beside(element, FAR);
    let indent = before.len() - before.trim_end_matches([' ', '\t']).len();
    let rest = behind.len() - behind.trim_start_matches([' ', '\t', '\r']).len();
    let starts = element.start == indent as u32
        || before.trim_end_matches([' ', '\t']).as_bytes().last() == Some(&b'\n');
    let ends = behind.as_bytes().get(rest) == Some(&b'\n');
    if starts && ends {
        return TextRange::new(element.start - indent as u32, element.end + rest as u32 + 1);
    }
    element
}

/// An include that was carried out.
pub(super) struct Inclusion<'a> {
    /// Its frame.
    pub frame: FrameId,
    /// The tag, from `<` to the end of the name.
    pub tag: FileRange,
    /// The same as an element.
    pub node: Node<'a>,
    /// The file that was included.
    pub target: FileIdx,
    /// The namespace it was included into, those around it in front; empty: none.
    pub namespace: String,
    /// The frame that the tag was reached through.
    pub within: FrameId,
}

/// The includes of an expansion, in order; of very many, the first ones.
pub(super) fn inclusions<'a>(expansion: &'a Expansion, world: RuleEnv<'_>) -> Vec<Inclusion<'a>> {
    const MOST: usize = 10_000;
    let files = expansion.files.iter_ids();
    let mut by_name: FastMap<&str, Option<FileIdx>> = files
        .clone()
        .map(|(idx, file)| (file.name.as_str(), Some(idx)))
        .collect();
    let by_id: FastMap<FileId, FileIdx> = files.map(|(idx, file)| (file.source.id, idx)).collect();
    let mut namespaces: FastMap<FrameId, String> = FastMap::default();
    let mut found = Vec::new();
    let frames = expansion
        .frames
        .iter_ids()
        .filter(|(_, frame)| frame.kind == FrameKind::Include);
    for (id, frame) in frames.take(MOST) {
        let target = *by_name.entry(&frame.name).or_insert_with(|| {
            let path = world.vfs.absolute(Path::new(frame.name.as_str()));
            let file = world.vfs.document(&world.packages.present(&path)).ok()?;
            by_id.get(&file.id).copied()
        });
        let node = tag(expansion, frame.call.into()).map(|(_, node)| node);
        let (Some(target), Some(node), Some(tag)) = (target, node, expansion.place(frame.call))
        else {
            continue;
        };
        let within = frame.call.frame;
        let outer = include_around(expansion, within).and_then(|around| namespaces.get(&around));
        let mut namespace = outer.cloned().unwrap_or_default();
        if let Some(ns) = node.attr("ns") {
            namespace = format!("{namespace}.{}", ns.raw());
        }
        namespaces.insert(id, namespace.clone());
        found.push(Inclusion {
            frame: id,
            tag,
            node,
            target,
            namespace,
            within,
        });
    }
    found
}

/// The files that an expansion included, each with the tag that did.
pub fn include_tags(expansion: &Expansion, world: RuleEnv<'_>) -> Vec<(FileId, Span)> {
    let files = &expansion.files;
    let tag = |found: Inclusion<'_>| {
        let span = Span {
            file: files.get(found.tag.file)?.source.id,
            range: found.tag.range,
        };
        Some((files.get(found.target)?.source.id, span))
    };
    inclusions(expansion, world)
        .into_iter()
        .filter_map(tag)
        .collect()
}

/// The innermost include among a frame and those around it.
fn include_around(expansion: &Expansion, mut frame: FrameId) -> Option<FrameId> {
    loop {
        let here = expansion.frames.get(frame)?;
        match here.kind {
            FrameKind::Include => return Some(frame),
            FrameKind::Root => return None,
            FrameKind::Macro | FrameKind::Block => frame = here.call.frame,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::removal;
    use base::TextRange;
    use xml::Document;

    #[test]
    fn an_element_goes_with_its_line() {
        for (text, expected) in [
            ("a\n  <b/> \nc", "a\nc"),
            ("a <b/>\nc", "a \nc"),
            ("<b/>\nc", "c"),
            ("  <b/> c", "   c"),
        ] {
            let start = text.find("<b/>").unwrap() as u32;
            let range = removal(&Document::parse(text), TextRange::new(start, start + 4));
            let (start, end) = (range.start as usize, range.end as usize);
            assert_eq!(
                format!("{}{}", &text[..start], &text[end..]),
                expected,
                "{text:?}"
            );
        }
    }
}
