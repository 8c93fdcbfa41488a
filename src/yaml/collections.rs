//! Lists and mappings, in blocks and in brackets.

use super::compose::{Composer, Content, Id, Place};
use super::error::Failure;
use super::resolve::MAP;
use super::token::TokenKind;

/// The content of a collection, and where its last item, or its closing bracket, ends.
pub(super) type Filled = (Content, Option<u32>);

impl Composer<'_> {
    fn last_end(&self, id: Option<Id>) -> Option<u32> {
        id.map(|id| self.end(id))
    }

    pub(super) fn block_sequence(&mut self) -> Result<Filled, Failure> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while let Some(dash) = self.take(&TokenKind::BlockEntry)? {
            let none = matches!(self.peek()?, TokenKind::BlockEntry | TokenKind::BlockEnd);
            items.push(if none {
                self.empty(dash)
            } else {
                self.node(Place::Block)?
            });
        }
        if self.take(&TokenKind::BlockEnd)?.is_none() {
            let problem = "expected <block end>, but found";
            return Err(self.expected("while parsing a block collection", start, problem));
        }
        let end = self.last_end(items.last().copied());
        Ok((Content::Sequence(items), end))
    }

    pub(super) fn indentless_sequence(&mut self) -> Result<Filled, Failure> {
        let mut items = Vec::new();
        while let Some(dash) = self.take(&TokenKind::BlockEntry)? {
            let none = matches!(
                self.peek()?,
                TokenKind::BlockEntry | TokenKind::Key | TokenKind::Value | TokenKind::BlockEnd
            );
            items.push(if none {
                self.empty(dash)
            } else {
                self.node(Place::Block)?
            });
        }
        let end = self.last_end(items.last().copied());
        Ok((Content::Sequence(items), end))
    }

    pub(super) fn block_mapping(&mut self) -> Result<Filled, Failure> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while let Some(mark) = self.take(&TokenKind::Key)? {
            let key = if ends_part(self.peek()?) {
                self.empty(mark)
            } else {
                self.node(Place::BlockValue)?
            };
            let value = match self.take(&TokenKind::Value)? {
                Some(_) if !ends_part(self.peek()?) => self.node(Place::BlockValue)?,
                Some(colon) => self.empty(colon),
                None => {
                    let here = self.here()?;
                    self.empty(here)
                }
            };
            items.push((key, value));
        }
        if self.take(&TokenKind::BlockEnd)?.is_none() {
            let problem = "expected <block end>, but found";
            return Err(self.expected("while parsing a block mapping", start, problem));
        }
        let end = items
            .last()
            .map(|&(key, value)| self.end(key).max(self.end(value)));
        Ok((Content::Mapping(items), end))
    }

    pub(super) fn flow_sequence(&mut self) -> Result<Filled, Failure> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while !self.at(&TokenKind::FlowSequenceEnd)? {
            if !items.is_empty() && self.take(&TokenKind::FlowEntry)?.is_none() {
                let problem = "expected ',' or ']', but got";
                return Err(self.expected("while parsing a flow sequence", start, problem));
            }
            if self.at(&TokenKind::Key)? {
                items.push(self.flow_pair()?);
            } else if !self.at(&TokenKind::FlowSequenceEnd)? {
                items.push(self.node(Place::Flow)?);
            }
        }
        let end = self.scanner.next()?.end.offset;
        Ok((Content::Sequence(items), Some(end)))
    }

    /// `key: value` as an item of a list: a mapping of one.
    fn flow_pair(&mut self) -> Result<Id, Failure> {
        let start = self.here()?;
        let (key, value) = self.flow_item(&TokenKind::FlowSequenceEnd)?;
        let end = self.end(key).max(self.end(value));
        Ok(self.add(MAP, Content::Mapping(vec![(key, value)]), start, end))
    }

    /// Key and value in brackets that `close` ends; the next token is the `Key`.
    fn flow_item(&mut self, close: &TokenKind) -> Result<(Id, Id), Failure> {
        let mark = self.scanner.next()?.end;
        let next = self.peek()?;
        let none = *next == TokenKind::Value || ends_flow_item(next, close);
        let key = if none {
            self.empty(mark)
        } else {
            self.node(Place::Flow)?
        };
        let value = match self.take(&TokenKind::Value)? {
            Some(_) if !ends_flow_item(self.peek()?, close) => self.node(Place::Flow)?,
            Some(colon) => self.empty(colon),
            None => {
                let here = self.here()?;
                self.empty(here)
            }
        };
        Ok((key, value))
    }

    pub(super) fn flow_mapping(&mut self) -> Result<Filled, Failure> {
        let start = self.scanner.next()?.start;
        let mut items = Vec::new();
        while !self.at(&TokenKind::FlowMappingEnd)? {
            if !items.is_empty() && self.take(&TokenKind::FlowEntry)?.is_none() {
                let problem = "expected ',' or '}', but got";
                return Err(self.expected("while parsing a flow mapping", start, problem));
            }
            if self.at(&TokenKind::Key)? {
                items.push(self.flow_item(&TokenKind::FlowMappingEnd)?);
            } else if !self.at(&TokenKind::FlowMappingEnd)? {
                let key = self.node(Place::Flow)?;
                let here = self.here()?;
                let value = self.empty(here);
                items.push((key, value));
            }
        }
        let end = self.scanner.next()?.end.offset;
        Ok((Content::Mapping(items), Some(end)))
    }
}

/// Whether a key or a value of a mapping in a block ends before a token.
fn ends_part(next: &TokenKind) -> bool {
    matches!(
        next,
        TokenKind::Key | TokenKind::Value | TokenKind::BlockEnd
    )
}

/// Whether an item in brackets that `close` ends does so before a token.
fn ends_flow_item(next: &TokenKind, close: &TokenKind) -> bool {
    *next == TokenKind::FlowEntry || next == close
}
