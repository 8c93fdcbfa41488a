//! Reading settings off YAML values: keys, names and lists, each with its place.

use ecow::EcoString;

use base::TextRange;
use yaml::{YamlKind, YamlNode};

/// A name and where it is written, quotes included.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpannedName {
    /// The name.
    pub name: EcoString,
    /// Its place.
    pub range: TextRange,
}

impl SpannedName {
    /// The text of a node, when it is one.
    pub(super) fn of(node: &YamlNode) -> Option<Self> {
        match &node.kind {
            YamlKind::Str(text) => Some(Self {
                name: text.as_str().into(),
                range: node.range,
            }),
            _ => None,
        }
    }

    /// The texts of a list, or the one text.
    pub(super) fn list(node: &YamlNode) -> Vec<Self> {
        match &node.kind {
            YamlKind::List(items) => items.iter().filter_map(Self::of).collect(),
            _ => Self::of(node).into_iter().collect(),
        }
    }
}

/// The entries of a mapping whose keys are texts.
pub(super) fn entries(node: &YamlNode) -> impl Iterator<Item = (SpannedName, &YamlNode)> {
    let entries = match &node.kind {
        YamlKind::Map(entries) => entries.as_slice(),
        _ => &[],
    };
    entries
        .iter()
        .filter_map(|(key, value)| Some((SpannedName::of(key)?, value)))
}

/// The value of a key; of several, the last.
pub(super) fn get<'n>(node: &'n YamlNode, key: &str) -> Option<&'n YamlNode> {
    let YamlKind::Map(entries) = &node.kind else {
        return None;
    };
    let is_key = |name: &YamlNode| matches!(&name.kind, YamlKind::Str(text) if text == key);
    let found = entries.iter().rev().find(|(name, _)| is_key(name));
    found.map(|(_, value)| value)
}

/// The text of a key.
pub(super) fn text(node: &YamlNode, key: &str) -> Option<SpannedName> {
    SpannedName::of(get(node, key)?)
}

/// The value of a number, and whether it is written as an integer.
pub(super) fn number(node: &YamlNode) -> Option<(f64, bool)> {
    match &node.kind {
        YamlKind::Int(value) => Some((value.to_string().parse().ok()?, true)),
        YamlKind::Float(value) => Some((*value, false)),
        _ => None,
    }
}
