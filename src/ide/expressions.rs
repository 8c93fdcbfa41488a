//! Texts with `${...}` and `$(...)` as they stand in a file, and what stands at an offset of them.

use std::borrow::Cow;

use super::locate::{LocatedNode, NodePart};
use base::TextRange;
use expr::ast::{Expr, ExprKind};
use expr::{self, Code, Template, TemplateToken};
use xml::{Attr, Document, Entities, Node, decode_text, source_offset};

/// The value of an attribute or character data, decoded and split.
pub struct ExprText<'a> {
    raw: &'a str,
    /// Offset of the text in the file.
    start: u32,
    is_attr: bool,
    entities: &'a Entities,
    /// The decoded text.
    pub text: Cow<'a, str>,
    /// Its tokens; their ranges count in the decoded text.
    pub template: Template,
}

impl<'a> ExprText<'a> {
    /// The value of an attribute of an item that begins at `base`.
    pub fn of_attr(document: &'a Document, base: u32, attr: Attr<'a>) -> Self {
        Self::new(
            attr.raw(),
            attr.value_range().start + base,
            true,
            document.entities(),
        )
    }

    /// Character data of an item that begins at `base`.
    pub fn of_text(document: &'a Document, base: u32, node: Node<'a>) -> Self {
        Self::new(
            node.raw(),
            node.raw_range().start + base,
            false,
            document.entities(),
        )
    }

    /// The text that stands at a place, if it is one that may hold expressions.
    pub fn at(document: &'a Document, at: &LocatedNode<'a>) -> Option<Self> {
        match (at.part, at.node) {
            (NodePart::AttrValue(attr), _) => Some(Self::of_attr(document, at.base, attr)),
            (NodePart::Text, Some(node)) => Some(Self::of_text(document, at.base, node)),
            _ => None,
        }
    }

    fn new(raw: &'a str, start: u32, is_attr: bool, entities: &'a Entities) -> Self {
        let text = decode_text(raw, entities, is_attr);
        let template = expr::split(&text);
        Self {
            raw,
            start,
            is_attr,
            entities,
            text,
            template,
        }
    }

    /// A range of the decoded text as a range of the file.
    pub fn range(&self, range: TextRange) -> TextRange {
        TextRange::new(self.source(range.start), self.source(range.end)).shift(self.start)
    }

    /// All of the text as a range of the file.
    pub fn whole(&self) -> TextRange {
        TextRange::new(self.start, self.start + self.raw.len() as u32)
    }

    fn source(&self, offset: u32) -> u32 {
        if self.text == self.raw {
            return offset;
        }
        source_offset(self.raw, self.entities, self.is_attr, offset as usize) as u32
    }

    /// The offset in the decoded text of an offset of the file.
    pub fn offset(&self, offset: u32) -> u32 {
        let inside = offset.saturating_sub(self.start);
        if self.text == self.raw {
            return inside;
        }
        let (mut low, mut high) = (0, self.text.len() as u32);
        while low < high {
            let middle = (low + high).div_ceil(2);
            if self.source(middle) <= inside {
                low = middle
            } else {
                high = middle - 1
            }
        }
        low
    }

    /// The expression or substitution at an offset of the file.
    pub fn token_at(&self, offset: u32) -> Option<&TemplateToken> {
        let inside = self.offset(offset);
        let holds = |token: &&TemplateToken| {
            matches!(
                token,
                TemplateToken::Expr { .. } | TemplateToken::Subst { .. }
            ) && token.range().touches(inside)
        };
        // between two expressions, the one behind
        self.template.tokens.iter().rfind(holds)
    }
}

/// The parsed expression of a token, and where it begins in the decoded text; none for substitutions and for code
/// that is put together when it is evaluated.
pub fn parsed(token: &TemplateToken) -> Option<(&Expr, u32)> {
    match token {
        TemplateToken::Expr {
            inner,
            code: Code::Static(parsed),
            ..
        } if parsed.errors.is_empty() => Some((&parsed.expr, inner.start)),
        _ => None,
    }
}

/// The way from an expression down to its smallest part at `offset`, the smallest last.
pub fn path_to(expr: &Expr, offset: u32) -> Vec<&Expr> {
    let mut path = vec![expr];
    while let Some(outer) = path.last().copied() {
        let mut next = None;
        expr::visit::children(outer, &mut |child| {
            if child.range.touches(offset) && !matches!(child.kind, ExprKind::Missing) {
                next = Some(child);
            }
        });
        match next {
            Some(child) => path.push(child),
            None => break,
        }
    }
    path
}
