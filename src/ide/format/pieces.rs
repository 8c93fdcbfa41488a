//! A document as a row of tags and what stands between them.

use super::is_blank;
use base::TextRange;
use xml::{Document, Node, NodeKind};

/// A piece of a document that is no white space between elements.
pub(super) struct FormatPiece<'a> {
    pub(super) kind: PieceKind<'a>,
    /// Where it stands in the file.
    pub(super) range: TextRange,
    /// Offset of its part of the file.
    pub(super) base: u32,
    /// How many elements are around it.
    pub(super) depth: usize,
}

/// What a piece is.
#[derive(Clone, Copy)]
pub(super) enum PieceKind<'a> {
    /// A start tag, or an empty element.
    Start(Node<'a>),
    /// An end tag.
    End {
        /// Whether there are elements in front of it that it closes the parent of.
        closes_elements: bool,
    },
    /// A comment, an instruction, a declaration.
    Other,
    /// Everything in an element that holds text.
    Content,
}

/// The row of a document without mistakes.
pub(super) fn pieces(document: &Document) -> Vec<FormatPiece<'_>> {
    let mut row = PieceRow::default();
    for node in document
        .header()
        .nodes()
        .filter(|node| node.kind() != NodeKind::Text)
    {
        row.node(node, 0);
    }
    let Some(root) = document.root() else {
        return row.pieces;
    };
    let end_tag = document.root_end_tag();
    if let Some(end) = end_tag {
        let start = root.start_tag_range().end;
        let whole = keeps_space(root) || holds_text(document);
        if whole {
            row.push(PieceKind::Content, TextRange::new(start, end.start), 0);
        } else {
            row.inside(document);
        }
        row.depth = 0;
        row.push(
            PieceKind::End {
                closes_elements: !whole && document.item_count() > 0,
            },
            end,
            0,
        );
    }
    for node in document
        .epilog()
        .filter(|node| node.kind() != NodeKind::Text)
    {
        row.node(node, document.footer_start());
    }
    row.pieces
}

/// Whether there is text directly in the root.
fn holds_text(document: &Document) -> bool {
    let items = document.items().flat_map(|(_, item)| item.nodes());
    items.chain(document.footer_content()).any(is_text)
}

fn is_text(node: Node<'_>) -> bool {
    match node.kind() {
        NodeKind::Text | NodeKind::Junk => !is_blank(node.raw()),
        NodeKind::CData => true,
        _ => false,
    }
}

fn keeps_space(element: Node<'_>) -> bool {
    element
        .attr("xml:space")
        .is_some_and(|attr| attr.raw() == "preserve")
}

#[derive(Default)]
struct PieceRow<'a> {
    pieces: Vec<FormatPiece<'a>>,
    depth: usize,
    /// The elements that are open, innermost last.
    open: Vec<Node<'a>>,
}

impl<'a> PieceRow<'a> {
    fn push(&mut self, kind: PieceKind<'a>, range: TextRange, base: u32) {
        self.pieces.push(FormatPiece {
            kind,
            range: range.shift(base),
            base,
            depth: self.depth,
        });
    }

    /// Everything in the root.
    fn inside(&mut self, document: &'a Document) {
        for (base, item) in document.items() {
            self.depth = 1;
            let mut behind = 0;
            for node in item
                .all_nodes()
                .filter(|node| node.kind() != NodeKind::Text)
            {
                // what lies in an element with text was taken as a whole
                if node.range().start < behind {
                    continue;
                }
                self.close_before(node.range().start, base);
                if let Some(end) = self.node(node, base) {
                    behind = end;
                }
            }
            self.close_before(u32::MAX, base);
        }
        self.depth = 1;
        for node in document
            .footer_content()
            .filter(|node| node.kind() != NodeKind::Text)
        {
            self.node(node, document.footer_start());
        }
    }

    /// The end tags that stand in front of an offset.
    fn close_before(&mut self, offset: u32, base: u32) {
        while let Some(element) = self
            .open
            .last()
            .copied()
            .filter(|open| open.range().end <= offset)
        {
            self.open.pop();
            self.depth -= 1;
            if let Some(end) = element.end_tag() {
                let closes_elements = element.child_elements().next().is_some();
                self.push(PieceKind::End { closes_elements }, end, base);
            }
        }
    }

    /// A node without what is in it; where its content ends when that was taken as a whole.
    fn node(&mut self, node: Node<'a>, base: u32) -> Option<u32> {
        if node.kind() != NodeKind::Element {
            self.push(PieceKind::Other, node.range(), base);
            return None;
        }
        self.push(PieceKind::Start(node), node.start_tag_range(), base);
        let end = node.end_tag()?;
        if keeps_space(node) || node.children().any(is_text) {
            let content = TextRange::new(node.start_tag_range().end, end.start);
            self.push(PieceKind::Content, content, base);
            self.push(
                PieceKind::End {
                    closes_elements: false,
                },
                end,
                base,
            );
            return Some(node.range().end);
        }
        self.open.push(node);
        self.depth += 1;
        None
    }
}
