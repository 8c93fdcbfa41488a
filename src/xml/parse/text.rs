//! Character data and references.

use super::ItemParser;
use crate::chars::{first_illegal, stops_text};
use crate::decode::{Reference, read_reference};
use crate::entities::predefined;
use crate::error::{Condition, SyntaxError, SyntaxErrorKind as Kind, expat};
use crate::node::{HAS_DOLLAR, NEEDS_DECODING, NodeKind};

impl<'t> ItemParser<'t> {
    /// Character data and references up to the next `<`.
    pub(super) fn text_run(&mut self) {
        let start = self.pos;
        let first_error = self.errors.len();
        let mut flags = 0;
        while let Some(&b) = self.bytes.get(self.pos) {
            if !stops_text(b) {
                self.pos += 1;
                continue;
            }
            match b {
                b'<' => break,
                b'$' => flags |= HAS_DOLLAR,
                b'\r' => flags |= NEEDS_DECODING,
                _ => {
                    flags |= NEEDS_DECODING;
                    self.text_reference();
                    continue;
                }
            }
            self.pos += 1;
        }
        if self.pos == self.bytes.len() {
            self.hit_end = true;
        }
        self.push_node(NodeKind::Text, start, flags);
        if !self.clean || self.has_cdata_end {
            self.check_text(start);
        }
        if let Some(errors) = self.errors.get_mut(first_error..) {
            errors.sort_by_key(|e| e.error.expat_offset);
        }
    }

    fn check_text(&mut self, start: usize) {
        let text = self.slice(start, self.pos);
        self.check_characters(start, self.pos);
        for at in memchr::memmem::find_iter(text.as_bytes(), b"]]>") {
            let at = start + at;
            let message = "`]]>` is not allowed in text\nwrite `]]&gt;`";
            // expat notices at the `>`.
            self.error(
                Kind::CDataEndInText,
                (at, at + 3),
                (expat::INVALID, at + 2),
                message,
            );
        }
    }

    /// Report the forbidden characters in a part of the text.
    pub(super) fn check_characters(&mut self, start: usize, end: usize) {
        if self.clean {
            return;
        }
        let mut from = start;
        while let Some(at) = first_illegal(self.slice(from, end)).map(|at| from + at) {
            let next = self.char_end(at);
            let code = self.slice(at, next).chars().next().map_or(0, u32::from);
            let message = format!("character U+{code:04X} is not allowed in XML\nremove it");
            self.error(
                Kind::IllegalCharacter,
                (at, next),
                (expat::INVALID, at),
                message,
            );
            from = next;
        }
    }

    fn text_reference(&mut self) {
        let at = self.pos;
        match read_reference(self.text, at) {
            Reference::Bad(stop) => {
                self.pos = stop;
                self.bad_reference(at, stop);
            }
            Reference::Char(c, end) => {
                self.pos = end;
                if c.is_none() {
                    self.bad_character_reference(at, end, at);
                }
            }
            Reference::Entity { name, end } => {
                self.pos = end;
                self.entity_use(name, (at, end), at, false);
            }
        }
    }

    /// The `&` at `at` begins no reference; `stop` is where that shows.
    pub(super) fn bad_reference(&mut self, at: usize, stop: usize) {
        let expat_error = if stop >= self.bytes.len() {
            self.hit_end = true;
            (expat::UNCLOSED_TOKEN, at)
        } else {
            (expat::INVALID, stop)
        };
        let message = match self.slice(at + 1, stop) {
            "" if self.bytes.get(at + 1) == Some(&b'&') => {
                "unescaped `&`\nwrite `and` instead of `&&` in expressions".to_owned()
            }
            "" => "unescaped `&`\nwrite `&amp;`".to_owned(),
            name => format!(
                "`&{name}` is not followed by `;`\nwrite `&amp;` for a literal `&`, or add `;`"
            ),
        };
        self.error(
            Kind::BadReference,
            (at, stop.max(at + 1)),
            expat_error,
            message,
        );
    }

    pub(super) fn bad_character_reference(&mut self, at: usize, end: usize, stop: usize) {
        let message = format!(
            "`{}` is a character that is not allowed in XML\nremove it",
            self.slice(at, end)
        );
        self.error(
            Kind::BadCharacterReference,
            (at, end),
            (expat::BAD_CHAR_REF, stop),
            message,
        );
    }

    /// Note a reference to an entity; whether it is fine, the header knows.
    pub(super) fn entity_use(
        &mut self,
        name: &'t str,
        at: (usize, usize),
        stop: usize,
        in_attribute: bool,
    ) {
        if predefined(name).is_some() {
            return;
        }
        let count = self.entity_uses.entry((name, in_attribute)).or_default();
        *count += 1;
        if *count > 1 {
            return;
        }
        let error = SyntaxError {
            kind: Kind::UndefinedEntity,
            range: self.range(at.0, at.1),
            related: None,
            message: String::new(),
            expat: expat::UNDEFINED_ENTITY,
            expat_offset: self.rel(stop),
        };
        self.push_error(
            Condition::Entity {
                name: name.into(),
                in_attribute,
            },
            error,
        );
    }
}
