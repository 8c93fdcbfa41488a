//! The expanded document: a flat arena of nodes that can still be moved while it grows.
//!
//! Expansion splices finished subtrees (macro bodies, blocks, includes) into place, so siblings
//! are linked lists and moving a subtree costs nothing.
#![allow(clippy::indexing_slicing)] // ids are made by this arena only and never outlive it
use std::ops::{Deref, Range};
use std::sync::Arc;

use ecow::EcoString;

use super::origin::Origin;
use base::{FastSet, Id, IdVec, TextRange};

/// A node of the expanded document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct XId(u32);

base::ids!(XId);

impl XId {
    /// The document itself: parent of the prolog, the root element and the epilog.
    pub const DOCUMENT: XId = XId(0);
    const NIL: XId = XId(u32::MAX);

    #[inline]
    fn some(self) -> Option<XId> {
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
    parent: XId,
    first: XId,
    last: XId,
    prev: XId,
    next: XId,
}

impl XNode {
    /// Whether it has no children.
    #[inline]
    pub fn is_leaf(&self) -> bool {
        self.first == XId::NIL
    }
}

/// The attributes of an element. Copies share them: blocks are inserted more than once, and models keep values.
#[derive(Clone, Debug, Default)]
pub struct Attrs(Option<Arc<[XAttr]>>);

impl Attrs {
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

/// The arena.
#[derive(Clone, Debug)]
pub struct XTree {
    nodes: IdVec<XId, XNode>,
    /// Attributes with a prefix that were set: minidom takes them for attributes of no namespace.
    set_with_prefix: FastSet<(XId, EcoString)>,
}

impl Default for XTree {
    fn default() -> Self {
        let mut tree = Self {
            nodes: IdVec::from(Vec::with_capacity(256)),
            set_with_prefix: FastSet::default(),
        };
        tree.add(XKind::Container, EcoString::new(), Origin::NOWHERE);
        tree
    }
}

impl XTree {
    /// A new node without parent.
    pub fn add(&mut self, kind: XKind, text: EcoString, origin: Origin) -> XId {
        let nil = XId::NIL;
        self.nodes.push(XNode {
            kind,
            text,
            attrs: Attrs::default(),
            origin,
            parent: nil,
            first: nil,
            last: nil,
            prev: nil,
            next: nil,
        })
    }

    /// Make room for so many more nodes.
    pub(super) fn reserve(&mut self, nodes: usize) {
        self.nodes.reserve(nodes);
    }

    /// Give back the room for more nodes.
    pub(super) fn shrink(&mut self) {
        self.nodes.shrink_to_fit();
    }

    #[cfg(debug_assertions)]
    pub(super) fn all(&self) -> &[XNode] {
        self.nodes.as_slice()
    }

    /// How many nodes were ever made.
    #[inline]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether nothing was made but the document itself.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.nodes.len() <= 1
    }

    /// The node of an id.
    #[inline]
    pub fn get(&self, id: XId) -> &XNode {
        &self.nodes.as_slice()[id.index()]
    }

    /// The node of an id, to be changed.
    #[inline]
    pub fn get_mut(&mut self, id: XId) -> &mut XNode {
        &mut self.nodes.as_mut_slice()[id.index()]
    }

    /// The node's parent.
    #[inline]
    pub fn parent(&self, id: XId) -> Option<XId> {
        self.get(id).parent.some()
    }

    /// The first child.
    #[inline]
    pub fn first_child(&self, id: XId) -> Option<XId> {
        self.get(id).first.some()
    }

    /// The last child.
    #[inline]
    pub fn last_child(&self, id: XId) -> Option<XId> {
        self.get(id).last.some()
    }

    /// The sibling behind.
    #[inline]
    pub fn next_sibling(&self, id: XId) -> Option<XId> {
        self.get(id).next.some()
    }

    /// The sibling in front.
    #[inline]
    pub fn prev_sibling(&self, id: XId) -> Option<XId> {
        self.get(id).prev.some()
    }

    /// The children in order.
    #[inline]
    pub fn children(&self, id: XId) -> impl Iterator<Item = XId> + '_ {
        std::iter::successors(self.first_child(id), |&c| self.next_sibling(c))
    }

    /// The child elements in order.
    #[inline]
    pub fn elements(&self, id: XId) -> impl Iterator<Item = XId> + '_ {
        self.children(id)
            .filter(|&c| self.get(c).kind == XKind::Element)
    }

    /// All nodes below a node, in document order.
    pub fn below(&self, id: XId) -> impl Iterator<Item = XId> + '_ {
        std::iter::successors(self.first_child(id), move |&node| {
            self.first_child(node)
                .or_else(|| self.behind_inside(node, id))
        })
    }

    /// The node behind a node and all below it, when it is below `around`.
    #[inline]
    fn behind_inside(&self, mut node: XId, around: XId) -> Option<XId> {
        while node != around {
            if let Some(next) = self.next_sibling(node) {
                return Some(next);
            }
            node = self.parent(node)?;
        }
        None
    }

    /// The root element.
    pub fn root(&self) -> Option<XId> {
        self.elements(XId::DOCUMENT).next()
    }

    /// An attribute by name.
    #[inline]
    pub fn attr(&self, id: XId, name: &str) -> Option<&XAttr> {
        self.get(id).attrs.iter().find(|a| a.name == name)
    }

    /// Set or replace an attribute. As in minidom, a new one replaces what has the same local name and no namespace:
    /// attributes without a prefix, and those that were set before.
    pub fn set_attr(&mut self, id: XId, attr: XAttr) {
        let mut all = self.get(id).attrs.to_vec();
        if let Some(old) = all.iter_mut().find(|a| a.name == attr.name) {
            *old = attr;
        } else {
            all.retain(|old| {
                local_name(&old.name) != local_name(&attr.name) || self.has_namespace(id, &old.name)
            });
            if attr.name.contains(':') {
                self.set_with_prefix.insert((id, attr.name.clone()));
            }
            all.push(attr);
        }
        self.get_mut(id).attrs = all.into_iter().collect();
    }

    /// Whether an attribute is in a namespace: it has a prefix, and was not set.
    fn has_namespace(&self, id: XId, name: &EcoString) -> bool {
        if name.contains(':') {
            !self.set_with_prefix.contains(&(id, name.clone()))
        } else {
            name == "xmlns"
        }
    }

    /// Put a node without parent behind the last child of `parent`.
    pub fn append(&mut self, parent: XId, id: XId) {
        let last = self.get(parent).last;
        {
            let node = self.get_mut(id);
            node.parent = parent;
            node.prev = last;
            node.next = XId::NIL;
        }
        match last.some() {
            Some(last) => self.get_mut(last).next = id,
            None => self.get_mut(parent).first = id,
        }
        self.get_mut(parent).last = id;
    }

    /// Copy nodes of a compact tree, from the first of some siblings up to what lies behind the last one, to the end of
    /// `parent`.
    pub(super) fn graft(&mut self, from: &Self, (first, end): (XId, XId), parent: XId) {
        let start = self.nodes.len() as u32;
        let old = first.0..end.0;
        let range = first.index()..end.index();
        self.nodes.extend(
            from.nodes.as_slice()[range.clone()]
                .iter()
                .map(|node| XNode {
                    parent: moved(node.parent, &old, start),
                    first: moved(node.first, &old, start),
                    last: moved(node.last, &old, start),
                    prev: moved(node.prev, &old, start),
                    next: moved(node.next, &old, start),
                    ..node.clone()
                }),
        );
        for (id, node) in (start..).map(XId).zip(&from.nodes.as_slice()[range]) {
            if !old.contains(&node.parent.0) {
                self.append(parent, id);
            }
        }
    }

    /// What lies behind a node of a compact tree and all that is below it.
    pub(super) fn behind(&self, id: XId) -> XId {
        let last = std::iter::successors(Some(id), |&id| self.last_child(id)).last();
        XId(last.map_or(id.0, |last| last.0) + 1)
    }

    /// Take a node out of its parent; its subtree stays with it.
    pub fn detach(&mut self, id: XId) {
        let (parent, prev, next) = {
            let node = self.get(id);
            (node.parent, node.prev, node.next)
        };
        let Some(parent) = parent.some() else { return };
        match prev.some() {
            Some(prev) => self.get_mut(prev).next = next,
            None => self.get_mut(parent).first = next,
        }
        match next.some() {
            Some(next) => self.get_mut(next).prev = prev,
            None => self.get_mut(parent).last = prev,
        }
        let node = self.get_mut(id);
        node.parent = XId::NIL;
        node.prev = XId::NIL;
        node.next = XId::NIL;
    }

    /// Move all children of `from` behind the last child of `to`.
    pub fn move_children(&mut self, from: XId, to: XId) {
        let mut next = self.first_child(from);
        while let Some(child) = next {
            next = self.next_sibling(child);
            self.get_mut(child).parent = to;
        }
        let (first, last) = (self.get(from).first, self.get(from).last);
        if first == XId::NIL {
            return;
        }
        let tail = self.get(to).last;
        self.get_mut(first).prev = tail;
        match tail.some() {
            Some(tail) => self.get_mut(tail).next = first,
            None => self.get_mut(to).first = first,
        }
        self.get_mut(to).last = last;
        let from = self.get_mut(from);
        from.first = XId::NIL;
        from.last = XId::NIL;
    }
}

/// The new number of a node whose old one is in a range that begins again at `start`; none of a node outside of it.
fn moved(id: XId, old: &Range<u32>, start: u32) -> XId {
    if old.contains(&id.0) {
        XId(id.0 - old.start + start)
    } else {
        XId::NIL
    }
}

/// A qualified name without its prefix.
fn local_name(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, local)| local)
}
