//! The expanded document: a flat arena of nodes that can still be moved while it grows.
//!
//! Expansion splices finished subtrees (macro bodies, blocks, includes) into place, so siblings
//! are linked lists and moving a subtree costs nothing.
#![allow(clippy::indexing_slicing)] // ids are made by this arena only and never outlive it
use std::ops::Range;

use ecow::EcoString;

use super::node::{Attrs, Links, XAttr, XId, XKind, XNode};
use super::origin::Origin;
use super::parts::{Part, Parts};
use base::{FastSet, Id, IdVec};

/// The arena.
#[derive(Clone, Debug)]
pub struct XTree {
    /// While it grows: all nodes.
    nodes: IdVec<XId, XNode>,
    /// Once it is finished: all nodes.
    parts: Parts,
    /// While it grows: elements that stand for children of the root element of another document.
    kept: Vec<(XId, Vec<Part>)>,
    /// Attributes with a prefix that were set: minidom takes them for attributes of no namespace.
    set_with_prefix: FastSet<(XId, EcoString)>,
}

impl Default for XTree {
    fn default() -> Self {
        let mut tree = Self {
            nodes: IdVec::from(Vec::with_capacity(256)),
            parts: Parts::default(),
            kept: Vec::new(),
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

    /// A document of these nodes.
    pub(super) fn finished(parts: Parts) -> Self {
        Self {
            nodes: IdVec::default(),
            parts,
            kept: Vec::new(),
            set_with_prefix: FastSet::default(),
        }
    }

    /// All nodes, each with its links.
    #[cfg(debug_assertions)]
    pub(super) fn all(&self) -> Vec<XNode> {
        let ids = (0..self.len()).map(XId::from_index);
        let seen = |id| {
            let mut node = self.get(id).clone();
            node.set_links(self.links(id));
            node
        };
        ids.map(seen).collect()
    }

    /// How many nodes were ever made.
    #[inline]
    pub fn len(&self) -> usize {
        self.nodes.len() + self.parts.len()
    }

    /// Whether nothing was made but the document itself.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len() <= 1
    }

    /// The node of an id.
    #[inline]
    pub fn get(&self, id: XId) -> &XNode {
        if self.parts.is_empty() {
            &self.nodes.as_slice()[id.index()]
        } else {
            self.parts.node(id)
        }
    }

    /// Where a node stands.
    #[inline]
    pub(super) fn links(&self, id: XId) -> Links {
        if self.parts.is_empty() {
            self.get(id).links()
        } else {
            self.parts.links(id)
        }
    }

    /// The node of an id, to be changed, while the document grows.
    #[inline]
    pub fn get_mut(&mut self, id: XId) -> &mut XNode {
        &mut self.nodes.as_mut_slice()[id.index()]
    }

    /// The node's parent.
    #[inline]
    pub fn parent(&self, id: XId) -> Option<XId> {
        if self.parts.is_empty() {
            self.nodes.as_slice()[id.index()].parent.some()
        } else {
            self.parts.parent(id)
        }
    }

    /// The first child.
    #[inline]
    pub fn first_child(&self, id: XId) -> Option<XId> {
        if self.parts.is_empty() {
            self.nodes.as_slice()[id.index()].first.some()
        } else {
            self.parts.first(id)
        }
    }

    /// The last child.
    #[inline]
    pub fn last_child(&self, id: XId) -> Option<XId> {
        if self.parts.is_empty() {
            self.nodes.as_slice()[id.index()].last.some()
        } else {
            self.parts.last(id)
        }
    }

    /// The sibling behind.
    #[inline]
    pub fn next_sibling(&self, id: XId) -> Option<XId> {
        if self.parts.is_empty() {
            self.nodes.as_slice()[id.index()].next.some()
        } else {
            self.parts.next(id)
        }
    }

    /// The sibling in front.
    #[inline]
    pub fn prev_sibling(&self, id: XId) -> Option<XId> {
        if self.parts.is_empty() {
            self.nodes.as_slice()[id.index()].prev.some()
        } else {
            self.parts.prev(id)
        }
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

    /// The numbers of nodes below the root element that are the very same in another finished document: whole children of it, in
    /// order.
    pub fn same_in(&self, other: &Self) -> Vec<Range<XId>> {
        self.parts.same_in(&other.parts)
    }

    /// Whether a child of an element may be text. Of the root element of a finished document it is known without a look at each.
    pub fn may_have_text(&self, id: XId) -> bool {
        self.parts.is_empty() || self.parent(id) != Some(XId::DOCUMENT) || self.parts.has_text()
    }

    /// The child of an element with a number, if it is one.
    pub fn child_at(&self, id: XId, parent: XId) -> Option<XId> {
        (id.index() < self.len() && self.parent(id) == Some(parent)).then_some(id)
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

    /// The marker of comments, without a place.
    pub(super) fn add_marker(&mut self) -> XId {
        self.add(XKind::Text, "\n\n".into(), Origin::NOWHERE)
    }

    /// Whether attributes with a prefix were set.
    pub(super) fn has_set_prefixes(&self) -> bool {
        !self.set_with_prefix.is_empty()
    }

    /// Put back what lies in front of a node behind a child of the root element, which gets other attributes; answers with an element
    /// that stands for all of it below the root element.
    pub(super) fn restore(
        &mut self,
        from: &Self,
        (last, end): (Option<XId>, XId),
        (root, attrs): (XId, Attrs),
    ) -> Option<XId> {
        self.nodes.clear();
        for id in (0..=root.index()).map(XId::from_index) {
            let mut node = from.get(id).clone();
            node.set_links(from.links(id));
            self.nodes.push(node);
        }
        let node = self.get_mut(root);
        (node.first, node.last, node.next) = (XId::NIL, XId::NIL, XId::NIL);
        node.attrs = attrs;
        self.get_mut(XId::DOCUMENT).last = root;
        self.keep(from, (root.following()..end, last?), root)
    }

    /// Add children of the root element of another document, of which the last is `last`: an element stands for them while this one
    /// grows. None where there are none.
    pub(super) fn keep(
        &mut self,
        from: &Self,
        (range, last): (Range<XId>, XId),
        parent: XId,
    ) -> Option<XId> {
        let parts = from.parts.slice(range, last);
        if parts.is_empty() {
            return None;
        }
        let id = self.add(XKind::Element, EcoString::new(), Origin::NOWHERE);
        self.append(parent, id);
        self.kept.push((id, parts));
        Some(id)
    }

    /// What a node says, without its place; it says nothing any more.
    pub(super) fn take(&mut self, id: XId) -> XNode {
        let node = self.get_mut(id);
        let mut taken = XNode {
            text: std::mem::take(&mut node.text),
            attrs: std::mem::take(&mut node.attrs),
            ..*node
        };
        taken.set_links(Links::default());
        taken
    }

    /// What an element stands for.
    pub(super) fn take_kept(&mut self, id: XId) -> Option<Vec<Part>> {
        let place = self.kept.iter().position(|(known, _)| *known == id)?;
        Some(self.kept.swap_remove(place).1)
    }

    /// Copy nodes of a compact tree, from the first of some siblings up to what lies behind the last one, to the end of
    /// `parent`.
    pub(super) fn graft(&mut self, from: &Self, (first, end): (XId, XId), parent: XId) {
        let start = self.nodes.len() as u32;
        let old = first.0..end.0;
        for number in old.clone() {
            let mut node = from.get(XId(number)).clone();
            let links = from.links(XId(number));
            let moved = |link: Option<XId>| moved(link?, &old, start);
            node.set_links(Links {
                parent: moved(links.parent),
                first: moved(links.first),
                last: moved(links.last),
                prev: moved(links.prev),
                next: moved(links.next),
            });
            let is_top = node.parent == XId::NIL;
            let id = self.nodes.push(node);
            if is_top {
                self.append(parent, id);
            }
        }
    }

    /// What lies behind a child of the root element and all that is below it, or at the beginning of its content.
    pub(super) fn behind_top(&self, top: Option<XId>, root: XId) -> XId {
        top.map_or(root.following(), |top| self.behind(top))
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
fn moved(id: XId, old: &Range<u32>, start: u32) -> Option<XId> {
    old.contains(&id.0).then(|| XId(id.0 - old.start + start))
}

/// A qualified name without its prefix.
fn local_name(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, local)| local)
}
