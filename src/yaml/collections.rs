//! Lists and mappings, in blocks and in brackets.

use super::compose::{Composer, NodeContent, NodeIndex, NodePosition};
use super::error::RawError;
use super::resolve::MAP;
use super::token::YamlTokenKind;

/// The content of a collection, and where its last item, or its closing bracket, ends.
pub(super) type Filled = (NodeContent, Option<u32>);

impl Composer<'_> {
    fn last_end(&self, id: Option<NodeIndex>) -> Option<u32> {
        id.map(|id| self.end(id))
    }

    pub(super) fn block_sequence(&mut self) -> Result<Filled, RawError> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while let Some(dash) = self.take(&YamlTokenKind::BlockEntry)? {
            let none = matches!(
                self.peek()?,
                YamlTokenKind::BlockEntry | YamlTokenKind::BlockEnd
            );
            items.push(if none {
                self.empty(dash)
            } else {
                self.node(NodePosition::Block)?
            });
        }
        if self.take(&YamlTokenKind::BlockEnd)?.is_none() {
            let problem = "expected <block end>, but found";
            return Err(self.expected("while parsing a block collection", start, problem));
        }
        let end = self.last_end(items.last().copied());
        Ok((NodeContent::Sequence(items), end))
    }

    pub(super) fn indentless_sequence(&mut self) -> Result<Filled, RawError> {
        let mut items = Vec::new();
        while let Some(dash) = self.take(&YamlTokenKind::BlockEntry)? {
            let none = matches!(
                self.peek()?,
                YamlTokenKind::BlockEntry
                    | YamlTokenKind::Key
                    | YamlTokenKind::Value
                    | YamlTokenKind::BlockEnd
            );
            items.push(if none {
                self.empty(dash)
            } else {
                self.node(NodePosition::Block)?
            });
        }
        let end = self.last_end(items.last().copied());
        Ok((NodeContent::Sequence(items), end))
    }

    pub(super) fn block_mapping(&mut self) -> Result<Filled, RawError> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while let Some(mark) = self.take(&YamlTokenKind::Key)? {
            let key = if ends_part(self.peek()?) {
                self.empty(mark)
            } else {
                self.node(NodePosition::BlockValue)?
            };
            let value = match self.take(&YamlTokenKind::Value)? {
                Some(_) if !ends_part(self.peek()?) => self.node(NodePosition::BlockValue)?,
                Some(colon) => self.empty(colon),
                None => {
                    let here = self.here()?;
                    self.empty(here)
                }
            };
            items.push((key, value));
        }
        if self.take(&YamlTokenKind::BlockEnd)?.is_none() {
            let problem = "expected <block end>, but found";
            return Err(self.expected("while parsing a block mapping", start, problem));
        }
        let end = items
            .last()
            .map(|&(key, value)| self.end(key).max(self.end(value)));
        Ok((NodeContent::Mapping(items), end))
    }

    pub(super) fn flow_sequence(&mut self) -> Result<Filled, RawError> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while !self.at(&YamlTokenKind::FlowSequenceEnd)? {
            if !items.is_empty() && self.take(&YamlTokenKind::FlowEntry)?.is_none() {
                let problem = "expected ',' or ']', but got";
                return Err(self.expected("while parsing a flow sequence", start, problem));
            }
            if self.at(&YamlTokenKind::Key)? {
                items.push(self.flow_pair()?);
            } else if !self.at(&YamlTokenKind::FlowSequenceEnd)? {
                items.push(self.node(NodePosition::Flow)?);
            }
        }
        let end = self.scanner.next()?.end.offset;
        Ok((NodeContent::Sequence(items), Some(end)))
    }

    /// `key: value` as an item of a list: a mapping of one.
    fn flow_pair(&mut self) -> Result<NodeIndex, RawError> {
        let start = self.here()?;
        let (key, value) = self.flow_item(&YamlTokenKind::FlowSequenceEnd)?;
        let end = self.end(key).max(self.end(value));
        Ok(self.add(MAP, NodeContent::Mapping(vec![(key, value)]), start, end))
    }

    /// Key and value in brackets that `close` ends; the next token is the `Key`.
    fn flow_item(&mut self, close: &YamlTokenKind) -> Result<(NodeIndex, NodeIndex), RawError> {
        let mark = self.scanner.next()?.end;
        let next = self.peek()?;
        let none = *next == YamlTokenKind::Value || ends_flow_item(next, close);
        let key = if none {
            self.empty(mark)
        } else {
            self.node(NodePosition::Flow)?
        };
        let value = match self.take(&YamlTokenKind::Value)? {
            Some(_) if !ends_flow_item(self.peek()?, close) => self.node(NodePosition::Flow)?,
            Some(colon) => self.empty(colon),
            None => {
                let here = self.here()?;
                self.empty(here)
            }
        };
        Ok((key, value))
    }

    pub(super) fn flow_mapping(&mut self) -> Result<Filled, RawError> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while !self.at(&YamlTokenKind::FlowMappingEnd)? {
            if !items.is_empty() && self.take(&YamlTokenKind::FlowEntry)?.is_none() {
                let problem = "expected ',' or '}', but got";
                return Err(self.expected("while parsing a flow mapping", start, problem));
            }
            if self.at(&YamlTokenKind::Key)? {
                items.push(self.flow_item(&YamlTokenKind::FlowMappingEnd)?);
            } else if !self.at(&YamlTokenKind::FlowMappingEnd)? {
                let key = self.node(NodePosition::Flow)?;
                let here = self.here()?;
                let value = self.empty(here);
                items.push((key, value));
            }
        }
        let end = self.scanner.next()?.end.offset;
        Ok((NodeContent::Mapping(items), Some(end)))
    }
}

/// Whether a key or a value of a mapping in a block ends before a token.
fn ends_part(next: &YamlTokenKind) -> bool {
    matches!(
        next,
        YamlTokenKind::Key | YamlTokenKind::Value | YamlTokenKind::BlockEnd
    )
}

/// Whether an item in brackets that `close` ends does so before a token.
fn ends_flow_item(next: &YamlTokenKind, close: &YamlTokenKind) -> bool {
    *next == YamlTokenKind::FlowEntry || next == close
}
