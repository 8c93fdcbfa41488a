//! From tokens to a tree of tagged nodes, in which an alias is the node of its anchor.

use std::borrow::Cow;

use super::error::{RawError, repr};
use super::reader::Mark;
use super::resolve::{MAP, SEQ, STR, resolve};
use super::scanner::Scanner;
use super::token::{YamlDirective, YamlTokenKind};
use base::limits::YAML_DEPTH;
use base::{FastMap, TextRange};

/// Number of a node in its [`NodeTree`].
pub(super) type NodeIndex = usize;

/// All nodes of a document.
pub(super) type NodeTree = Vec<Raw>;

/// A node before its value is made.
#[derive(Debug)]
pub(super) struct Raw {
    /// The full name of its type.
    pub(super) tag: Cow<'static, str>,
    /// What it holds.
    pub(super) content: NodeContent,
    /// Where it begins.
    pub(super) start: Mark,
    /// Offset behind it.
    pub(super) end: u32,
}

impl Raw {
    /// The text of it.
    pub(super) fn range(&self) -> TextRange {
        TextRange::new(self.start.offset, self.end)
    }
}

/// The three kinds of nodes.
#[derive(Debug)]
pub(super) enum NodeContent {
    Scalar(String),
    Sequence(Vec<NodeIndex>),
    Mapping(Vec<(NodeIndex, NodeIndex)>),
}

impl NodeContent {
    /// The name of the kind in messages.
    pub(super) fn name(&self) -> &'static str {
        match self {
            NodeContent::Scalar(_) => "scalar",
            NodeContent::Sequence(_) => "sequence",
            NodeContent::Mapping(_) => "mapping",
        }
    }
}

/// Where a node stands: what may begin there.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum NodePosition {
    Flow,
    Block,
    /// A value of a block mapping: its list need not be indented.
    BlockValue,
}

/// Makes the tree.
pub(super) struct Composer<'t> {
    /// The tokens.
    pub(super) scanner: Scanner<'t>,
    tree: NodeTree,
    anchors: FastMap<String, NodeIndex>,
    handles: FastMap<String, String>,
    depth: u32,
}

/// The one document of `text`, or nothing.
///
/// # Errors
/// When it is not well-formed, or not one.
pub(super) fn compose(text: &str) -> Result<Option<(NodeTree, NodeIndex)>, RawError> {
    let mut composer = Composer {
        scanner: Scanner::new(text)?,
        tree: NodeTree::new(),
        anchors: FastMap::default(),
        handles: default_handles(),
        depth: 0,
    };
    let Some(root) = composer.document()? else {
        return Ok(None);
    };
    if let Some(other) = composer.next_document()? {
        let start = composer.start(root);
        let context = "expected a single document in the stream";
        return Err(RawError::within(
            context,
            start,
            "but found another document",
            other,
        ));
    }
    Ok(Some((composer.tree, root)))
}

fn default_handles() -> FastMap<String, String> {
    let handles = [("!", "!"), ("!!", "tag:yaml.org,2002:")];
    handles
        .iter()
        .map(|(handle, prefix)| ((*handle).to_owned(), (*prefix).to_owned()))
        .collect()
}

impl Composer<'_> {
    pub(super) fn peek(&mut self) -> Result<&YamlTokenKind, RawError> {
        Ok(&self.scanner.peek()?.kind)
    }

    pub(super) fn at(&mut self, kind: &YamlTokenKind) -> Result<bool, RawError> {
        Ok(self.peek()? == kind)
    }

    /// Take the next token if it is `kind`; its end.
    pub(super) fn take(&mut self, kind: &YamlTokenKind) -> Result<Option<Mark>, RawError> {
        if self.peek()? == kind {
            self.scanner.next().map(|token| Some(token.end))
        } else {
            Ok(None)
        }
    }

    pub(super) fn here(&mut self) -> Result<Mark, RawError> {
        Ok(self.scanner.peek()?.start)
    }

    fn start(&self, id: NodeIndex) -> Mark {
        self.tree
            .get(id)
            .map_or_else(Mark::default, |node| node.start)
    }

    pub(super) fn end(&self, id: NodeIndex) -> u32 {
        self.tree.get(id).map_or(0, |node| node.end)
    }

    pub(super) fn add(
        &mut self,
        tag: impl Into<Cow<'static, str>>,
        content: NodeContent,
        start: Mark,
        end: u32,
    ) -> NodeIndex {
        self.tree.push(Raw {
            tag: tag.into(),
            content,
            start,
            end,
        });
        self.tree.len() - 1
    }

    pub(super) fn empty(&mut self, at: Mark) -> NodeIndex {
        self.add(
            resolve(""),
            NodeContent::Scalar(String::new()),
            at,
            at.offset,
        )
    }

    pub(super) fn expected(&mut self, context: &str, began: Mark, problem: &str) -> RawError {
        match self.scanner.peek() {
            Ok(token) => {
                let (found, at) = (repr(token.kind.name()), token.start);
                RawError::within(context, began, format!("{problem} {found}"), at)
            }
            Err(failure) => failure,
        }
    }

    // Documents.

    fn document(&mut self) -> Result<Option<NodeIndex>, RawError> {
        let explicit = matches!(
            self.peek()?,
            YamlTokenKind::Directive(_) | YamlTokenKind::DocumentStart | YamlTokenKind::StreamEnd
        );
        let root = if !explicit {
            self.node(NodePosition::Block)?
        } else if self.next_document()?.is_none() {
            return Ok(None);
        } else {
            let no_content = matches!(
                self.peek()?,
                YamlTokenKind::Directive(_)
                    | YamlTokenKind::DocumentStart
                    | YamlTokenKind::DocumentEnd
                    | YamlTokenKind::StreamEnd
            );
            let here = self.here()?;
            if no_content {
                self.empty(here)
            } else {
                self.node(NodePosition::Block)?
            }
        };
        self.take(&YamlTokenKind::DocumentEnd)?;
        Ok(Some(root))
    }

    /// Move behind the head of the next document and return where that began; `None` at the end.
    fn next_document(&mut self) -> Result<Option<Mark>, RawError> {
        while self.take(&YamlTokenKind::DocumentEnd)?.is_some() {}
        if self.at(&YamlTokenKind::StreamEnd)? {
            return Ok(None);
        }
        let start = self.here()?;
        self.directives()?;
        if self.take(&YamlTokenKind::DocumentStart)?.is_none() {
            let at = self.here()?;
            let found = repr(self.peek()?.name());
            return Err(RawError::new(
                format!("expected '<document start>', but found {found}"),
                at,
            ));
        }
        Ok(Some(start))
    }

    fn directives(&mut self) -> Result<(), RawError> {
        let mut has_version = false;
        let mut declared = FastMap::default();
        while matches!(self.peek()?, YamlTokenKind::Directive(_)) {
            let token = self.scanner.next()?;
            match token.kind {
                YamlTokenKind::Directive(YamlDirective::Yaml(_)) if has_version => {
                    return Err(RawError::new("found duplicate YAML directive", token.start));
                }
                YamlTokenKind::Directive(YamlDirective::Yaml(major)) => {
                    if major.trim_start_matches('0') != "1" {
                        let problem = "found incompatible YAML document (version 1.* is required)";
                        return Err(RawError::new(problem, token.start));
                    }
                    has_version = true;
                }
                YamlTokenKind::Directive(YamlDirective::Tag(handle, prefix)) => {
                    if declared.contains_key(&handle) {
                        let problem = format!("duplicate tag handle {}", repr(&handle));
                        return Err(RawError::new(problem, token.start));
                    }
                    declared.insert(handle, prefix);
                }
                _ => {}
            }
        }
        self.handles = default_handles();
        self.handles.extend(declared);
        Ok(())
    }

    // Nodes.

    pub(super) fn node(&mut self, place: NodePosition) -> Result<NodeIndex, RawError> {
        let at = self.here()?;
        if self.depth >= YAML_DEPTH {
            return Err(RawError::new(
                format!("found more than {YAML_DEPTH} levels of nesting"),
                at,
            ));
        }
        self.depth += 1;
        let node = if matches!(self.peek()?, YamlTokenKind::Alias(_)) {
            self.alias()
        } else {
            self.content(place)
        };
        self.depth -= 1;
        node
    }

    fn alias(&mut self) -> Result<NodeIndex, RawError> {
        let token = self.scanner.next()?;
        let name = if let YamlTokenKind::Alias(name) = token.kind {
            name
        } else {
            String::new()
        };
        self.anchors.get(&name).copied().ok_or_else(|| {
            let range = TextRange::new(token.start.offset, token.end.offset);
            RawError::new(
                format!("found undefined alias {}", repr(&name)),
                token.start,
            )
            .blaming(range)
        })
    }

    fn content(&mut self, place: NodePosition) -> Result<NodeIndex, RawError> {
        let properties = self.properties()?;
        let start = match properties.start {
            Some(start) => start,
            None => self.here()?,
        };
        let block = place != NodePosition::Flow;
        let begins = match self.peek()? {
            YamlTokenKind::BlockEntry => place == NodePosition::BlockValue,
            YamlTokenKind::BlockSequenceStart | YamlTokenKind::BlockMappingStart => block,
            YamlTokenKind::Scalar(..)
            | YamlTokenKind::FlowSequenceStart
            | YamlTokenKind::FlowMappingStart => true,
            _ => false,
        };
        if !begins && properties.start.is_none() {
            let context = if block {
                "while parsing a block node"
            } else {
                "while parsing a flow node"
            };
            return Err(self.expected(context, start, "expected the node content, but found"));
        }
        // A scalar is taken, with what must be read to know whether it is a key, before its anchor counts.
        let scalar = match self.peek()? {
            YamlTokenKind::Scalar(..) => Some(self.scanner.next()?),
            _ => None,
        };
        self.check_anchor(properties.anchor.as_deref(), start)?;
        let (tag, end) = (properties.tag, properties.end);
        if let Some(token) = scalar {
            let YamlTokenKind::Scalar(text, plain) = token.kind else {
                return Ok(self.empty(start));
            };
            let tag = match tag {
                Some(tag) => tag,
                None if plain || properties.is_bare => Cow::Borrowed(resolve(&text)),
                None => Cow::Borrowed(STR),
            };
            let id = self.add(tag, NodeContent::Scalar(text), start, token.end.offset);
            self.register(properties.anchor, id);
            return Ok(id);
        }
        if !begins {
            let tag = tag.unwrap_or_else(|| Cow::Borrowed(resolve("")));
            let id = self.add(tag, NodeContent::Scalar(String::new()), start, end);
            self.register(properties.anchor, id);
            return Ok(id);
        }
        self.collection(tag, properties.anchor, start)
    }

    /// Anchor and tag, in either order.
    fn properties(&mut self) -> Result<Properties, RawError> {
        let mut found = Properties::default();
        let mut tag: Option<(Option<String>, String, Mark)> = None;
        loop {
            match self.peek()? {
                YamlTokenKind::Anchor(_) if found.anchor.is_none() => {}
                YamlTokenKind::Tag(..) if tag.is_none() => {}
                _ => break,
            }
            let token = self.scanner.next()?;
            found.start.get_or_insert(token.start);
            found.end = token.end.offset;
            match token.kind {
                YamlTokenKind::Anchor(name) => found.anchor = Some(name),
                YamlTokenKind::Tag(handle, suffix) => tag = Some((handle, suffix, token.start)),
                _ => {}
            }
        }
        let Some((handle, suffix, at)) = tag else {
            return Ok(found);
        };
        let tag = match handle {
            None => suffix,
            Some(handle) => match self.handles.get(&handle) {
                Some(prefix) => format!("{prefix}{suffix}"),
                None => {
                    let problem = format!("found undefined tag handle {}", repr(&handle));
                    let start = found.start.unwrap_or(at);
                    return Err(RawError::within("while parsing a node", start, problem, at));
                }
            },
        };
        found.is_bare = tag == "!";
        found.tag = (!found.is_bare).then_some(Cow::Owned(tag));
        Ok(found)
    }

    fn check_anchor(&self, anchor: Option<&str>, start: Mark) -> Result<(), RawError> {
        match anchor.and_then(|anchor| Some((anchor, *self.anchors.get(anchor)?))) {
            Some((anchor, first)) => {
                let context = format!("found duplicate anchor {}; first occurrence", repr(anchor));
                Err(RawError::within(
                    &context,
                    self.start(first),
                    "second occurrence",
                    start,
                ))
            }
            None => Ok(()),
        }
    }

    fn register(&mut self, anchor: Option<String>, id: NodeIndex) {
        if let Some(anchor) = anchor {
            self.anchors.insert(anchor, id);
        }
    }

    fn collection(
        &mut self,
        tag: Option<Cow<'static, str>>,
        anchor: Option<String>,
        start: Mark,
    ) -> Result<NodeIndex, RawError> {
        let is_sequence = matches!(
            self.peek()?,
            YamlTokenKind::BlockEntry
                | YamlTokenKind::BlockSequenceStart
                | YamlTokenKind::FlowSequenceStart
        );
        let (default, content) = if is_sequence {
            (SEQ, NodeContent::Sequence(Vec::new()))
        } else {
            (MAP, NodeContent::Mapping(Vec::new()))
        };
        let id = self.add(
            tag.unwrap_or(Cow::Borrowed(default)),
            content,
            start,
            start.offset,
        );
        // Known from here on: what it holds may refer to it.
        self.register(anchor, id);
        let (content, end) = match self.peek()? {
            YamlTokenKind::BlockEntry => self.indentless_sequence()?,
            YamlTokenKind::BlockSequenceStart => self.block_sequence()?,
            YamlTokenKind::FlowSequenceStart => self.flow_sequence()?,
            YamlTokenKind::FlowMappingStart => self.flow_mapping()?,
            _ => self.block_mapping()?,
        };
        if let Some(node) = self.tree.get_mut(id) {
            node.content = content;
            node.end = end.unwrap_or(start.offset);
        }
        Ok(id)
    }
}

/// What stands before a node.
#[derive(Default)]
struct Properties {
    anchor: Option<String>,
    /// The full tag, unless it is missing or `!`.
    tag: Option<Cow<'static, str>>,
    /// Whether the tag is `!`.
    is_bare: bool,
    start: Option<Mark>,
    end: u32,
}
