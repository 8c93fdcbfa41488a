//! The DOCTYPE and the entities it declares.

use super::Parser;
use crate::xml::entities::{Entities, Entity, decode};
use crate::xml::error::{SyntaxErrorKind as Kind, expat};
use crate::xml::node::{CLOSED, NodeKind};

impl Parser<'_> {
    /// Read a DOCTYPE.
    pub(super) fn doctype(&mut self, entities: &mut Entities) {
        let start = self.pos;
        let mut in_subset = false;
        self.pos += 9;
        while let Some(b) = self.peek() {
            match b {
                b'"' | b'\'' => self.skip_literal(b),
                b'[' => in_subset = true,
                b']' => in_subset = false,
                b'>' if !in_subset => {
                    self.pos += 1;
                    self.push_node(NodeKind::Doctype, start, CLOSED);
                    return;
                }
                b'<' if in_subset && self.starts_with(b"<!ENTITY") => self.entity_declaration(entities),
                b'<' if in_subset && self.starts_with(b"<!--") => {
                    self.comment();
                    self.nodes.pop();
                    continue;
                }
                _ => {}
            }
            self.pos += 1;
        }
        self.push_node(NodeKind::Doctype, start, 0);
        let message = "this DOCTYPE needs its `>`";
        self.error(Kind::BadDoctype, (start, start + 9), (expat::NO_ELEMENT, self.pos), message);
    }

    fn skip_literal(&mut self, quote: u8) {
        let rest = self.bytes.get(self.pos + 1..).unwrap_or(&[]);
        self.pos += memchr::memchr(quote, rest).map_or(0, |n| n + 1);
    }

    fn entity_declaration(&mut self, entities: &mut Entities) {
        let start = self.pos + 8;
        let end = memchr::memchr(b'>', self.bytes.get(start..).unwrap_or(&[])).map_or(start, |n| start + n);
        let text = self.slice(start, end);
        let Some((name, rest)) = text.trim_start().split_once([' ', '\t', '\n', '\r']) else { return };
        let rest = rest.trim();
        if let Some(literal) = rest.strip_prefix(['"', '\'']) {
            let literal = literal.get(..literal.len().saturating_sub(1)).unwrap_or("");
            let value = decode(literal, &Entities::default(), false);
            entities.declare(name, Entity::Internal(value.into()));
        } else if rest.starts_with("SYSTEM") || rest.starts_with("PUBLIC") {
            entities.declare(name, Entity::External);
        }
        self.pos = end.saturating_sub(1);
    }
}
