//! Which piece of a file is what: the base of colors.

mod expression;
mod kept;
mod names;
mod tags;

use std::cell::Cell;

use super::context::Cx;
use super::hover::condition;
use base::TextRange;
pub use kept::KeptTokens;
use names::KnownNames;
use xml::{Item, Node, NodeKind};

/// What a piece of text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum TokenKind {
    Macro,
    Parameter,
    Variable,
    Property,
    Keyword,
    Function,
    Number,
    String,
    Operator,
    EnumMember,
    Namespace,
    Class,
    Event,
    /// What a condition leaves out.
    Comment,
}

/// More about a piece: bits of a set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Modifiers(pub u32);

impl Modifiers {
    /// A name is given here.
    pub const DECLARATION: Self = Self(1);
    /// Its value is written as it is.
    pub const READONLY: Self = Self(2);
    /// An old way.
    pub const DEPRECATED: Self = Self(4);
    /// Part of every xacro.
    pub const DEFAULT_LIBRARY: Self = Self(8);
    /// Left out by a condition.
    pub const UNUSED: Self = Self(16);

    /// Both sets together.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// A piece of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HighlightToken {
    /// Where it stands.
    pub range: TextRange,
    /// What it is.
    pub kind: TokenKind,
    /// More about it.
    pub modifiers: Modifiers,
}

/// The pieces of a part of a file in order; none overlaps another. A piece may stretch over several lines.
pub fn tokens(cx: &Cx<'_>, within: TextRange) -> Vec<HighlightToken> {
    let parts = cx.source.document.parts();
    let parts: Vec<_> = parts
        .filter(|(base, item)| overlap(TextRange::new(*base, base + item.len()), within))
        .collect();
    let around = parts.iter().fold(within, |around, (base, item)| {
        TextRange::new(around.start.min(*base), around.end.max(base + item.len()))
    });
    let names = KnownNames::of(cx, around);
    let found = parts
        .into_iter()
        .flat_map(|(base, item)| Collector::new(cx, &names).part(base, item));
    found.filter(|token| overlap(token.range, within)).collect()
}

/// Whether two ranges have a byte in common.
fn overlap(one: TextRange, other: TextRange) -> bool {
    one.start < other.end && other.start < one.end
}

struct Collector<'c, 'a> {
    cx: &'c Cx<'a>,
    names: &'c KnownNames<'a>,
    found: Vec<HighlightToken>,
    /// Whether what was found rests on more than the text and the names in it.
    rests_on_robot: Cell<bool>,
    /// Whether it rests on what properties there are.
    rests_on_properties: Cell<bool>,
}

impl<'c, 'a> Collector<'c, 'a> {
    fn new(cx: &'c Cx<'a>, names: &'c KnownNames<'a>) -> Self {
        Self {
            cx,
            names,
            found: Vec::new(),
            rests_on_robot: Cell::new(false),
            rests_on_properties: Cell::new(false),
        }
    }

    /// The pieces of an item that begins at `base`, in order.
    fn part(&mut self, base: u32, item: &Item) -> Vec<HighlightToken> {
        let mut dead_end = 0;
        for node in item.all_nodes() {
            if node.range().start < dead_end {
                continue;
            }
            match node.kind() {
                NodeKind::Element => {
                    self.element(base, node);
                    if let Some(content) = self.dead_content(base, node) {
                        self.add(content.shift(base), TokenKind::Comment, Modifiers::UNUSED);
                        dead_end = content.end;
                    }
                }
                NodeKind::Text if node.has_dollar() => self.text(base, node),
                _ => {}
            }
        }
        let mut found = std::mem::take(&mut self.found);
        found.sort_by_key(|token| (token.range.start, token.range.end));
        let mut end = 0;
        found.retain(|token| {
            let free = token.range.start >= end && !token.range.is_empty();
            if free {
                end = token.range.end;
            }
            free
        });
        found
    }
}

impl Collector<'_, '_> {
    fn add(&mut self, range: TextRange, kind: TokenKind, modifiers: Modifiers) {
        self.found.push(HighlightToken {
            range,
            kind,
            modifiers,
        });
    }

    /// The content of a condition that is known to leave it out, whatever way leads there.
    fn dead_content(&self, base: u32, node: Node<'_>) -> Option<TextRange> {
        let wanted = match node.name() {
            "xacro:if" => true,
            "xacro:unless" => false,
            _ => return None,
        };
        self.rests_on_robot.set(true);
        let truths = condition(self.cx, base, node)?;
        if truths != [Some(!wanted)] {
            return None;
        }
        let content = TextRange::new(node.start_tag_range().end, node.end_tag()?.start);
        (!content.is_empty()).then_some(content)
    }
}
