//! From tagged nodes to values.
//!
//! PyYAML makes values level by level, so of several errors it reports the one nearest to the root.
//! Here the tree is walked in order and the first error of the least level is kept.

use num_bigint::BigInt;
use num_traits::FromPrimitive;

use super::compose::{NodeContent, NodeIndex, NodeTree, Raw};
use super::error::{RawError, repr};
use super::reader::Mark;
use super::resolve::{BOOL, FLOAT, INT, MAP, MERGE, NULL, SEQ, STR, TIMESTAMP, VALUE, YAML};
use super::{Unit, YamlKind, YamlNode, numbers, timestamp};
use base::limits::{YAML_MERGES, YAML_NODES};
use base::{FastMap, TextRange};

/// The value of the node `root`.
///
/// # Errors
/// The one PyYAML would report.
pub(super) fn construct(tree: NodeTree, root: NodeIndex, keys: Keys) -> Result<YamlNode, RawError> {
    let active = vec![false; tree.len()];
    let mut constructor = Constructor {
        tree,
        active,
        keys,
        made: 0,
        failure: None,
    };
    let node = constructor.node(root, 0);
    match constructor.failure {
        Some((_, failure)) => Err(failure),
        None => Ok(node),
    }
}

/// What becomes of a key that a mapping has several times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keys {
    /// It has the last value, as in Python.
    Once,
    /// Each is there with its value.
    Repeated,
}

struct Constructor {
    tree: NodeTree,
    keys: Keys,
    /// The nodes being made: one of them inside itself is an error.
    active: Vec<bool>,
    made: usize,
    failure: Option<(u32, RawError)>,
}

impl Constructor {
    fn fail(&mut self, level: u32, failure: RawError) -> YamlKind {
        if self
            .failure
            .as_ref()
            .is_none_or(|(least, _)| level < *least)
        {
            self.failure = Some((level, failure));
        }
        YamlKind::Null
    }

    fn raw(&self, id: NodeIndex) -> Option<&Raw> {
        self.tree.get(id)
    }

    fn range(&self, id: NodeIndex) -> TextRange {
        self.raw(id).map_or_else(TextRange::default, Raw::range)
    }

    fn start(&self, id: NodeIndex) -> Mark {
        self.raw(id).map(|node| node.start).unwrap_or_default()
    }

    fn is_mapping(&self, id: NodeIndex) -> bool {
        let content = self.raw(id).map(|node| &node.content);
        matches!(content, Some(NodeContent::Mapping(_)))
    }

    /// A failure at the beginning of a node.
    fn problem(&self, id: NodeIndex, problem: impl Into<String>) -> RawError {
        RawError::new(problem, self.start(id)).blaming(self.range(id))
    }

    /// A failure at the beginning of a node, found while `outer` is made.
    fn problem_within(
        &self,
        context: &str,
        outer: NodeIndex,
        id: NodeIndex,
        problem: impl Into<String>,
    ) -> RawError {
        RawError::within(context, self.start(outer), problem, self.start(id))
            .blaming(self.range(id))
    }

    fn node(&mut self, id: NodeIndex, level: u32) -> YamlNode {
        let range = self.range(id);
        self.made += 1;
        let is_active = self.active.get(id).copied().unwrap_or(true);
        let kind = if is_active {
            let failure = self.problem(id, "found unconstructable recursive node");
            self.fail(level, failure)
        } else if self.made > YAML_NODES {
            let failure = self.problem(id, format!("found more than {YAML_NODES} values"));
            self.fail(level, failure)
        } else {
            self.set_active(id, true);
            let kind = self.kind(id, level);
            self.set_active(id, false);
            kind
        };
        YamlNode { kind, range }
    }

    fn set_active(&mut self, id: NodeIndex, active: bool) {
        if let Some(slot) = self.active.get_mut(id) {
            *slot = active;
        }
    }

    fn kind(&mut self, id: NodeIndex, level: u32) -> YamlKind {
        let tag = self
            .raw(id)
            .map(|node| node.tag.clone())
            .unwrap_or_default();
        match tag.as_ref() {
            SEQ => self.list(id, level),
            MAP => YamlKind::Map(self.mapping(id, level)),
            NULL | BOOL | INT | FLOAT | STR | TIMESTAMP => self.scalar(id, level, &tag),
            _ => match (tag.strip_prefix(YAML), unit_of(&tag)) {
                (Some("binary"), _) => self.scalar(id, level, &tag),
                (Some("set"), _) => {
                    let keys = self.mapping(id, level).into_iter().map(|(key, _)| key);
                    YamlKind::Set(keys.collect())
                }
                (Some("omap"), _) => self.pairs(id, level, "while constructing an ordered map"),
                (Some("pairs"), _) => self.pairs(id, level, "while constructing pairs"),
                (_, Some(unit)) => match self.text(id) {
                    Ok(text) => YamlKind::Tagged { unit, text },
                    Err(failure) => self.fail(level, failure),
                },
                _ => {
                    let problem = format!(
                        "could not determine a constructor for the tag {}",
                        repr(&tag)
                    );
                    let failure = self.problem(id, problem);
                    self.fail(level, failure)
                }
            },
        }
    }

    // Scalars.

    /// The text of a scalar, or of the `=` of a mapping.
    fn text(&self, id: NodeIndex) -> Result<String, RawError> {
        match self.raw(id).map(|node| &node.content) {
            Some(NodeContent::Scalar(text)) => Ok(text.clone()),
            Some(content) => {
                let default = match content {
                    NodeContent::Mapping(items) => {
                        items.iter().find(|(key, _)| self.has_tag(*key, VALUE))
                    }
                    _ => None,
                };
                let text = default.and_then(|&(_, value)| {
                    match self.raw(value).map(|node| &node.content) {
                        Some(NodeContent::Scalar(text)) => Some(text.clone()),
                        _ => None,
                    }
                });
                let problem = format!("expected a scalar node, but found {}", content.name());
                text.ok_or_else(|| self.problem(id, problem))
            }
            None => Ok(String::new()),
        }
    }

    fn has_tag(&self, id: NodeIndex, tag: &str) -> bool {
        self.raw(id).is_some_and(|node| node.tag == tag)
    }

    fn scalar(&mut self, id: NodeIndex, level: u32, tag: &str) -> YamlKind {
        let text = match self.text(id) {
            Ok(text) => text,
            Err(failure) => return self.fail(level, failure),
        };
        let made = match tag {
            NULL => Ok(YamlKind::Null),
            BOOL => bool(&text).map(YamlKind::Bool),
            INT => numbers::int(&text).map(YamlKind::Int),
            FLOAT => numbers::float(&text).map(YamlKind::Float),
            TIMESTAMP => time(&text),
            STR => Ok(YamlKind::Str(text)),
            _ => return self.binary(id, level, &text),
        };
        made.unwrap_or_else(|message| {
            let range = self.range(id);
            self.fail(level, RawError::Python { message, range })
        })
    }

    fn binary(&mut self, id: NodeIndex, level: u32, text: &str) -> YamlKind {
        let made = match not_ascii(text) {
            Some(error) => Err(format!("failed to convert base64 data into ascii: {error}")),
            None => numbers::base64(text)
                .map_err(|error| format!("failed to decode base64 data: {error}")),
        };
        match made {
            Ok(bytes) => YamlKind::Binary(bytes),
            Err(problem) => {
                let failure = self.problem(id, problem);
                self.fail(level, failure)
            }
        }
    }

    // Collections.

    fn list(&mut self, id: NodeIndex, level: u32) -> YamlKind {
        let items = match self.raw(id).map(|node| &node.content) {
            Some(NodeContent::Sequence(items)) => items.clone(),
            content => {
                let found = content.map_or("", NodeContent::name);
                let failure =
                    self.problem(id, format!("expected a sequence node, but found {found}"));
                return self.fail(level + 1, failure);
            }
        };
        YamlKind::List(
            items
                .into_iter()
                .map(|item| self.node(item, level + 1))
                .collect(),
        )
    }

    /// The items of a mapping: merged, one per key.
    fn mapping(&mut self, id: NodeIndex, level: u32) -> Vec<(YamlNode, YamlNode)> {
        let level = level + 1;
        if let Err(failure) = self.flatten(id, 0) {
            self.fail(level, failure);
            return Vec::new();
        }
        let items = match self.raw(id).map(|node| &node.content) {
            Some(NodeContent::Mapping(items)) => items.clone(),
            content => {
                let found = content.map_or("", NodeContent::name);
                let failure =
                    self.problem(id, format!("expected a mapping node, but found {found}"));
                self.fail(level, failure);
                return Vec::new();
            }
        };
        let mut made: Vec<(YamlNode, YamlNode)> = Vec::new();
        let mut places: FastMap<MappingKey, usize> = FastMap::default();
        for (key_id, value_id) in items {
            let key = (!self.makes_collection(key_id)).then(|| self.node(key_id, level));
            let Some((key, hashed)) =
                key.and_then(|key| MappingKey::of(&key.kind).map(|hashed| (key, hashed)))
            else {
                let context = "while constructing a mapping";
                let failure = self.problem_within(context, id, key_id, "found unhashable key");
                self.fail(level, failure);
                continue;
            };
            let value = self.node(value_id, level);
            match places.get(&hashed).and_then(|&place| made.get_mut(place)) {
                Some(slot) if self.keys == Keys::Once => slot.1 = value,
                Some(_) => made.push((key, value)),
                None => {
                    places.insert(hashed, made.len());
                    made.push((key, value));
                }
            }
        }
        made
    }

    /// Whether the value of a node is a list, mapping or set, so that it cannot be a key.
    fn makes_collection(&self, id: NodeIndex) -> bool {
        self.raw(id)
            .and_then(|node| node.tag.strip_prefix(YAML))
            .is_some_and(is_collection)
    }

    /// Replace the merge keys of a mapping by the items they bring, which go before its own.
    fn flatten(&mut self, id: NodeIndex, merges: u32) -> Result<(), RawError> {
        let Some(NodeContent::Mapping(items)) = self.raw(id).map(|node| &node.content) else {
            return Ok(());
        };
        let is_plain = |&(key, _): &(NodeIndex, NodeIndex)| {
            !self.has_tag(key, MERGE) && !self.has_tag(key, VALUE)
        };
        if items.iter().all(is_plain) {
            return Ok(());
        }
        let items = items.clone();
        if merges > YAML_MERGES {
            return Err(self.problem(
                id,
                format!("found more than {YAML_MERGES} merges into each other"),
            ));
        }
        let (mut merged, mut own) = (Vec::new(), Vec::new());
        for (key, value) in items {
            if self.has_tag(key, MERGE) {
                for source in self.merge_sources(id, value)? {
                    self.flatten(source, merges + 1)?;
                    if let Some(NodeContent::Mapping(items)) =
                        self.raw(source).map(|node| &node.content)
                    {
                        merged.extend_from_slice(items);
                    }
                    if merged.len() > YAML_NODES {
                        return Err(
                            self.problem(id, format!("found more than {YAML_NODES} merged items"))
                        );
                    }
                }
                continue;
            }
            if self.has_tag(key, VALUE)
                && let Some(node) = self.tree.get_mut(key)
            {
                node.tag = STR.into();
            }
            own.push((key, value));
        }
        merged.append(&mut own);
        if let Some(node) = self.tree.get_mut(id) {
            node.content = NodeContent::Mapping(merged);
        }
        Ok(())
    }

    /// The mappings a merge key names, in the order in which they are written over each other.
    fn merge_sources(&self, id: NodeIndex, value: NodeIndex) -> Result<Vec<NodeIndex>, RawError> {
        let (problem, at) = match self.raw(value).map(|node| &node.content) {
            Some(NodeContent::Mapping(_)) => return Ok(vec![value]),
            Some(NodeContent::Sequence(items)) => {
                match items.iter().find(|&&item| !self.is_mapping(item)) {
                    Some(&item) => ("expected a mapping for merging", item),
                    None => return Ok(items.iter().rev().copied().collect()),
                }
            }
            _ => ("expected a mapping or list of mappings for merging", value),
        };
        let found = self.raw(at).map_or("", |node| node.content.name());
        let problem = format!("{problem}, but found {found}");
        Err(self.problem_within("while constructing a mapping", id, at, problem))
    }

    /// A list of mappings of one item each.
    fn pairs(&mut self, id: NodeIndex, level: u32, context: &str) -> YamlKind {
        let level = level + 1;
        let items = match self.raw(id).map(|node| &node.content) {
            Some(NodeContent::Sequence(items)) => items.clone(),
            content => {
                let problem = format!(
                    "expected a sequence, but found {}",
                    content.map_or("", NodeContent::name)
                );
                let failure = self.problem_within(context, id, id, problem);
                return self.fail(level, failure);
            }
        };
        let mut made = Vec::new();
        for item in items {
            let problem = match self.raw(item).map(|node| &node.content) {
                Some(NodeContent::Mapping(pairs)) => match pairs.as_slice() {
                    &[(key, value)] => {
                        made.push((self.node(key, level), self.node(value, level)));
                        continue;
                    }
                    pairs => format!(
                        "expected a single mapping item, but found {} items",
                        pairs.len()
                    ),
                },
                content => {
                    let found = content.map_or("", NodeContent::name);
                    format!("expected a mapping of length 1, but found {found}")
                }
            };
            let failure = self.problem_within(context, id, item, problem);
            return self.fail(level, failure);
        }
        YamlKind::Pairs(made)
    }
}

fn is_collection(name: &str) -> bool {
    matches!(name, "seq" | "map" | "set" | "omap" | "pairs")
}

fn bool(text: &str) -> Result<bool, String> {
    let lower = text.to_lowercase();
    match lower.as_str() {
        "yes" | "true" | "on" => Ok(true),
        "no" | "false" | "off" => Ok(false),
        _ => Err(repr(&lower)),
    }
}

fn time(text: &str) -> Result<YamlKind, String> {
    let parts = timestamp::parse(text)
        .ok_or_else(|| "'NoneType' object has no attribute 'groupdict'".to_owned())?;
    let (text, repr) = parts.show()?;
    Ok(YamlKind::Timestamp { text, repr })
}

/// Python's message about the first run of characters that are not ASCII.
fn not_ascii(text: &str) -> Option<String> {
    let first = text.chars().position(|c| !c.is_ascii())?;
    let run: Vec<char> = text
        .chars()
        .skip(first)
        .take_while(|c| !c.is_ascii())
        .collect();
    let what = match run.as_slice() {
        [c] => {
            let code = *c as u32;
            let shown = match code {
                0..=0xFF => format!("\\x{code:02x}"),
                0x100..=0xFFFF => format!("\\u{code:04x}"),
                _ => format!("\\U{code:08x}"),
            };
            format!("character '{shown}' in position {first}")
        }
        _ => format!("characters in position {first}-{}", first + run.len() - 1),
    };
    Some(format!(
        "'ascii' codec can't encode {what}: ordinal not in range(128)"
    ))
}

/// A key as Python's dictionaries compare it: `1`, `1.0` and `True` are one.
#[derive(PartialEq, Eq, Hash)]
enum MappingKey {
    Null,
    Int(BigInt),
    Float(u64),
    Str(String),
    Binary(Vec<u8>),
    Timestamp(String),
    Tagged(Unit, String),
}

impl MappingKey {
    /// The key of a value, if it can be one.
    fn of(kind: &YamlKind) -> Option<Self> {
        Some(match kind {
            YamlKind::Null => MappingKey::Null,
            YamlKind::Bool(value) => MappingKey::Int(BigInt::from(u8::from(*value))),
            YamlKind::Int(value) => MappingKey::Int(value.clone()),
            YamlKind::Float(value) => match BigInt::from_f64(*value) {
                Some(whole) if value.fract() == 0.0 => MappingKey::Int(whole),
                _ => MappingKey::Float(value.to_bits()),
            },
            YamlKind::Str(text) => MappingKey::Str(text.clone()),
            YamlKind::Timestamp { repr, .. } => MappingKey::Timestamp(repr.clone()),
            YamlKind::Binary(bytes) => MappingKey::Binary(bytes.clone()),
            YamlKind::Tagged { unit, text } => MappingKey::Tagged(*unit, text.clone()),
            YamlKind::List(_) | YamlKind::Map(_) | YamlKind::Set(_) | YamlKind::Pairs(_) => {
                return None;
            }
        })
    }
}

/// The unit that a tag of one stands for.
fn unit_of(tag: &str) -> Option<Unit> {
    Unit::ALL
        .into_iter()
        .find(|unit| tag.strip_prefix('!') == Some(unit.name()))
}
