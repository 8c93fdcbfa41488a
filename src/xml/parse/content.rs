//! The main loop: everything between the tags of the root.

use super::{ContentEnd, ItemParser};
use crate::chars::name_char;
use crate::error::{SyntaxErrorKind as Kind, expat};
use crate::node::NodeKind;

impl ItemParser<'_> {
    /// Read up to the end of one top-level element, the root's end tag, or the end of the text.
    pub(super) fn content(&mut self) -> ContentEnd {
        loop {
            let stop = match self.peek() {
                None => {
                    let end = self.pos;
                    self.cut_item();
                    self.close_unclosed(0, None, (expat::NO_ELEMENT, end));
                    return ContentEnd::End;
                }
                Some(b'<') => self.markup(),
                Some(_) => {
                    self.text_run();
                    None
                }
            };
            if let Some(stop) = stop {
                return stop;
            }
        }
    }

    fn markup(&mut self) -> Option<ContentEnd> {
        match self.bytes.get(self.pos + 1) {
            Some(b'/') => self.end_tag(),
            Some(b'!') => {
                self.bang();
                None
            }
            Some(b'?') => {
                self.instruction();
                None
            }
            Some(b':') => self.start_tag(),
            Some(_) if name_char(self.text, self.pos + 1, true) > 0 => self.start_tag(),
            _ => {
                self.stray_lt();
                None
            }
        }
    }

    /// A `<` that begins nothing.
    fn stray_lt(&mut self) {
        let start = self.pos;
        if self.is_conflict_marker(start) {
            return self.conflict_marker();
        }
        self.pos += 1;
        if self.peek().is_none() {
            self.push_node(NodeKind::Junk, start, 0);
            let message = "missing element name after `<`\nwrite an element name, or `&lt;` for a literal `<`";
            self.error(
                Kind::StrayLt,
                (start, self.pos),
                (expat::UNCLOSED_TOKEN, start),
                message,
            );
            return;
        }
        self.push_node(NodeKind::Junk, start, 0);
        let message = "unexpected `<`\nwrite `&lt;` for a literal `<`";
        self.error(
            Kind::StrayLt,
            (start, self.pos),
            (expat::INVALID, self.pos),
            message,
        );
    }

    /// A `<<<<<<<` line.
    pub(super) fn conflict_marker(&mut self) {
        let start = self.pos;
        self.pos += memchr::memchr2(b'\n', b'\r', self.bytes.get(start..).unwrap_or(&[]))
            .unwrap_or(self.bytes.len() - start);
        self.hit_end |= self.pos == self.bytes.len();
        self.push_node(NodeKind::Junk, start, 0);
        let message = "unresolved merge conflict\nkeep one of the two versions and remove the conflict markers";
        self.error(
            Kind::MergeConflict,
            (start, self.pos),
            (expat::INVALID, start + 1),
            message,
        );
    }
}
