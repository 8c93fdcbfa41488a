//! Reading settings off YAML values: keys, names and lists, each with its place.

use ecow::EcoString;

use base::TextRange;
use yaml::{Kind, Node};

/// A name and where it is written, quotes included.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// The name.
    pub name: EcoString,
    /// Its place.
    pub range: TextRange,
}

impl Named {
    /// The text of a node, when it is one.
    pub(super) fn of(node: &Node) -> Option<Self> {
        match &node.kind {
            Kind::Str(text) => Some(Self {
                name: text.as_str().into(),
                range: node.range,
            }),
            _ => None,
        }
    }

    /// The texts of a list, or the one text.
    pub(super) fn list(node: &Node) -> Vec<Self> {
        match &node.kind {
            Kind::List(items) => items.iter().filter_map(Self::of).collect(),
            _ => Self::of(node).into_iter().collect(),
        }
    }
}

/// The entries of a mapping whose keys are texts.
pub(super) fn entries(node: &Node) -> impl Iterator<Item = (Named, &Node)> {
    let entries = match &node.kind {
        Kind::Map(entries) => entries.as_slice(),
        _ => &[],
    };
    entries
        .iter()
        .filter_map(|(key, value)| Some((Named::of(key)?, value)))
}

/// The value of a key; of several, the last.
pub(super) fn get<'n>(node: &'n Node, key: &str) -> Option<&'n Node> {
    let found = entries(node).filter(|(name, _)| name.name == key).last();
    found.map(|(_, value)| value)
}

/// The text of a key.
pub(super) fn text(node: &Node, key: &str) -> Option<Named> {
    Named::of(get(node, key)?)
}

/// The value of a number, and whether it is written as an integer.
pub(super) fn number(node: &Node) -> Option<(f64, bool)> {
    match &node.kind {
        Kind::Int(value) => Some((value.to_string().parse().ok()?, true)),
        Kind::Float(value) => Some((*value, false)),
        _ => None,
    }
}
