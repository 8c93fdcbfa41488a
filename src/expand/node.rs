//! The nodes of the expanded document.
use std::ops::Deref;
use std::sync::Arc;

use ecow::EcoString;

use super::origin::Origin;
use base::TextRange;

/// A node of the expanded document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct XId(pub(super) u32);

base::ids!(XId);

impl XId {
    /// The document itself: parent of the prolog, the root element and the epilog.
    pub const DOCUMENT: XId = XId(0);
    pub(super) const NIL: XId = XId(u32::MAX);

    /// The number of the same node in another tree.
    pub(super) fn moved(self, by: i64) -> Self {
        Self((i64::from(self.0) + by) as u32)
    }

    /// The next number.
    pub(super) fn following(self) -> Self {
        Self(self.0 + 1)
    }

    /// What is to be added to another number for this one.
    pub(super) fn away_from(self, other: Self) -> i64 {
        i64::from(self.0) - i64::from(other.0)
    }

    #[inline]
    pub(super) fn some(self) -> Option<XId> {
        (self != XId::NIL).then_some(self)
    }
}

/// The kinds of nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum XKind {
    /// The document, or a container that is spliced away.
    Container,
    /// An element; `text` is its tag name.
    Element,
    /// Character data.
    Text,
    /// A comment, without its delimiters.
    Comment,
    /// A CDATA section, without its delimiters.
    CData,
    /// A processing instruction: target, blank, data.
    Pi,
    /// A document type declaration, as it is printed.
    Doctype,
}

/// A node: what it is, what it says, and the source text it came from.
#[derive(Clone, Debug)]
pub struct XNode {
    /// What it is.
    pub kind: XKind,
    /// Tag name or data.
    pub text: EcoString,
    /// Attributes in source order.
    pub attrs: Attrs,
    /// The source text that made this node, and how it got here.
    pub origin: Origin,
    /// Where it stands in the document that it was made in: see [`Parts`](super::parts::Parts).
    pub(super) parent: XId,
    pub(super) first: XId,
    pub(super) last: XId,
    pub(super) prev: XId,
    pub(super) next: XId,
}

impl XNode {
    /// Whether it has no children.
    #[inline]
    pub fn is_leaf(&self) -> bool {
        self.first == XId::NIL
    }

    /// Where it stands, as it is written down.
    pub(super) fn links(&self) -> Links {
        Links {
            parent: self.parent.some(),
            first: self.first.some(),
            last: self.last.some(),
            prev: self.prev.some(),
            next: self.next.some(),
        }
    }

    pub(super) fn set_links(&mut self, links: Links) {
        self.parent = links.parent.unwrap_or(XId::NIL);
        self.first = links.first.unwrap_or(XId::NIL);
        self.last = links.last.unwrap_or(XId::NIL);
        self.prev = links.prev.unwrap_or(XId::NIL);
        self.next = links.next.unwrap_or(XId::NIL);
    }
}

/// Where a node stands: its parent, its first and last child, the siblings in front and behind.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Links {
    pub parent: Option<XId>,
    pub first: Option<XId>,
    pub last: Option<XId>,
    pub prev: Option<XId>,
    pub next: Option<XId>,
}

/// The attributes of an element. Copies share them: blocks are inserted more than once, and models keep values.
#[derive(Clone, Debug, Default)]
pub struct Attrs(Option<Arc<[XAttr]>>);

impl Attrs {
    /// Whether these are the same ones, not only equal ones.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            (None, None) => true,
            _ => false,
        }
    }

    /// The attributes as a model shares them, and the place of one among them.
    pub fn find(&self, name: &str) -> Option<(Arc<[XAttr]>, usize)> {
        let attrs = self.0.as_ref()?;
        let place = attrs.iter().position(|attr| attr.name == name)?;
        Some((Arc::clone(attrs), place))
    }
}

impl Deref for Attrs {
    type Target = [XAttr];

    #[inline]
    fn deref(&self) -> &[XAttr] {
        self.0.as_deref().unwrap_or_default()
    }
}

impl<'a> IntoIterator for &'a Attrs {
    type Item = &'a XAttr;
    type IntoIter = std::slice::Iter<'a, XAttr>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl FromIterator<XAttr> for Attrs {
    fn from_iter<T: IntoIterator<Item = XAttr>>(attrs: T) -> Self {
        let mut attrs = attrs.into_iter().peekable();
        Self(attrs.peek().is_some().then(|| attrs.collect()))
    }
}

/// An attribute of an expanded element.
#[derive(Clone, Debug)]
pub struct XAttr {
    /// Its qualified name.
    pub name: EcoString,
    /// Its value after evaluation.
    pub value: EcoString,
    /// The value's text in the source (without quotes).
    pub origin: Origin,
    /// Which slices of the value came from which expressions; empty for text taken over verbatim.
    pub pieces: Box<[Piece]>,
}

/// A slice of an evaluated text that an expression produced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Byte range in the evaluated text.
    pub out: TextRange,
    /// The `${...}` or `$(...)` it came from.
    pub source: Origin,
    /// Properties, parameters and arguments read on the way: see
    /// [`Expansion::read_in`](super::Expansion::read_in).
    pub reads: TextRange,
    /// The expression could not be computed; the text reads `?` there.
    pub unknown: bool,
}
