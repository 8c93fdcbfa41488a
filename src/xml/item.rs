//! The unit of parsing: one child of the root with its own text and its own flat tree.

use std::any::Any;
use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use super::error::{Condition, ItemError, SyntaxError, SyntaxErrorKind, expat};
use super::node::{AttrData, Node, NodeData, NodeId, Siblings};
use base::{Cache, Id, TextRange};

/// An immutable piece of a document: leading text and comments and one element, or the header, or the
/// footer. All ranges in it count from its own start.
pub struct Item {
    pub(super) text: Box<str>,
    pub(super) nodes: Box<[NodeData]>,
    pub(super) attrs: Box<[AttrData]>,
    pub(super) extra: Option<Box<ItemDetails>>,
    /// The only thing that could be wrong: a prefix that the root must declare. Most items of xacro have that.
    outer: Option<UnboundPrefix>,
    /// Line ends in `text`.
    pub(super) lines: u32,
    cache: Cache,
}

/// A prefix that the root must declare.
#[derive(Clone, Copy)]
struct UnboundPrefix {
    range: TextRange,
    expat_offset: u32,
}

impl UnboundPrefix {
    /// The only error of an item, if it is one of these.
    fn of(extra: &ItemDetails) -> Option<Self> {
        let ItemDetails {
            errors,
            entity_uses,
            lookahead: 0,
            needs_root_name: false,
        } = extra
        else {
            return None;
        };
        match &**errors {
            [
                ItemError {
                    error,
                    condition: Condition::UnlessBound,
                    diverges: false,
                },
            ] if entity_uses.is_empty() && error.related.is_none() => Some(Self {
                range: error.range,
                expat_offset: error.expat_offset,
            }),
            _ => None,
        }
    }

    fn error(self) -> ItemError {
        let error = SyntaxError {
            kind: SyntaxErrorKind::UnboundPrefix,
            range: self.range,
            related: None,
            message: String::new(),
            expat: expat::UNBOUND,
            expat_offset: self.expat_offset,
        };
        ItemError {
            error,
            condition: Condition::UnlessBound,
            diverges: false,
        }
    }
}

/// What few items have.
#[derive(Default)]
pub(super) struct ItemDetails {
    /// In the order expat would meet them.
    pub(super) errors: Box<[ItemError]>,
    /// Length of the text the parser looked at to shape this item, when that goes beyond its end;
    /// `u32::MAX`: to the end of the file.
    pub(super) lookahead: u32,
    /// References to entities that must be declared: name, whether in an attribute, how many.
    pub(super) entity_uses: Vec<EntityUse>,
    /// Whether the shape depends on the name of the root.
    pub(super) needs_root_name: bool,
}

/// References to one entity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct EntityUse {
    pub(super) name: Box<str>,
    pub(super) in_attribute: bool,
    pub(super) count: u32,
}

impl Item {
    pub(super) fn new(
        text: &str,
        lines: u32,
        nodes: &[NodeData],
        attrs: &[AttrData],
        extra: Option<ItemDetails>,
    ) -> Self {
        let outer = extra.as_ref().and_then(UnboundPrefix::of);
        Self {
            text: text.into(),
            nodes: nodes.into(),
            attrs: attrs.into(),
            outer,
            extra: extra.filter(|_| outer.is_none()).map(Box::new),
            lines,
            cache: Cache::default(),
        }
    }

    /// The source text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Length of the text in bytes.
    #[allow(clippy::len_without_is_empty)] // emptiness of an item is no question anybody asks
    pub fn len(&self) -> u32 {
        self.text.len() as u32
    }

    /// The top-level nodes in order.
    pub fn nodes(&self) -> Siblings<'_> {
        Siblings::new(self, 0, self.nodes.len() as u32)
    }

    /// All nodes, parents before children.
    pub fn all_nodes(&self) -> impl Iterator<Item = Node<'_>> {
        (0..self.nodes.len() as u32).map(move |id| self.node(NodeId(id)))
    }

    /// The node with this id. An id of another item gives some node or an empty piece of junk, never a panic.
    pub fn node(&self, id: NodeId) -> Node<'_> {
        Node::new(self, id)
    }

    /// The element whose start tag begins at an offset.
    pub fn element_at(&self, start: u32) -> Option<Node<'_>> {
        // parents come before their children, and siblings in order, so starts never go back
        let first = self.nodes.partition_point(|node| node.start < start);
        let here = self
            .nodes
            .iter()
            .enumerate()
            .skip(first)
            .take_while(|(_, node)| node.start == start);
        let mut elements = here.filter(|(_, node)| node.kind == super::NodeKind::Element);
        elements
            .next()
            .map(|(id, _)| self.node(NodeId::from_index(id)))
    }

    /// The element of this item: the last top-level node, if that is an element.
    pub fn element(&self) -> Option<Node<'_>> {
        self.nodes()
            .filter(|node| node.kind() == super::NodeKind::Element)
            .last()
    }

    /// Whether the item holds errors of its own (those that depend on the header not counted).
    pub fn has_errors(&self) -> bool {
        self.errors().any(|e| e.condition == Condition::Always)
    }

    pub(super) fn errors(&self) -> impl Iterator<Item = Cow<'_, ItemError>> {
        let outer = self.outer.map(|outer| Cow::Owned(outer.error()));
        let stored = self
            .extra
            .iter()
            .flat_map(|extra| &extra.errors)
            .map(Cow::Borrowed);
        outer.into_iter().chain(stored)
    }

    pub(super) fn entity_uses(&self) -> &[EntityUse] {
        self.extra.as_ref().map_or(&[], |extra| &extra.entity_uses)
    }

    /// Length of the text this item depends on; at least its own.
    pub(super) fn lookahead(&self) -> u32 {
        self.extra
            .as_ref()
            .map_or(0, |extra| extra.lookahead)
            .max(self.len())
    }

    /// What was read off this item; made on first use. One type is kept: for another type, `make` is called every
    /// time.
    pub fn cached<T: Any + Send + Sync>(&self, make: impl FnOnce(&Item) -> Arc<T>) -> Arc<T> {
        self.cache.get_or_make(|| make(self))
    }
}

impl fmt::Debug for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Item({:?})", self.text)
    }
}
