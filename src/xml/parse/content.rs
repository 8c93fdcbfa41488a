//! Everything between start and end tags: the main loop, text, end tags.

use super::{Parser, Stop};
use crate::xml::chars::{first_illegal, name_char, stops_text};
use crate::xml::entities::{Reference, read_reference};
use crate::xml::error::{Condition, SyntaxError, SyntaxErrorKind as Kind, expat};
use crate::xml::node::{HAS_DOLLAR, NEEDS_DECODING, NodeKind};

/// Open elements an end tag looks through for its start tag.
const MAX_LOOK: usize = 512;
/// Unclosed elements reported where one end tag closes many.
const MAX_UNCLOSED: usize = 8;

impl Parser<'_> {
    /// Read up to the end of one top-level element, the root's end tag, or the end of the text.
    pub(super) fn content(&mut self) -> Stop {
        loop {
            let stop = match self.peek() {
                None => {
                    self.close_unclosed(0, None, (expat::NO_ELEMENT, self.pos));
                    return Stop::End;
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

    fn markup(&mut self) -> Option<Stop> {
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
            let message = "`]]>` may not stand in text: write `]]&gt;`";
            // expat notices at the `>`.
            self.error(Kind::CDataEndInText, (at, at + 3), (expat::INVALID, at + 2), message);
        }
    }

    /// Report forbidden characters in a part of the text, the first of each run.
    pub(super) fn check_characters(&mut self, start: usize, end: usize) {
        if self.clean {
            return;
        }
        let mut from = start;
        while let Some(at) = first_illegal(self.slice(from, end)).map(|at| from + at) {
            let next = self.char_end(at);
            let code = self.slice(at, next).chars().next().map_or(0, u32::from);
            let message = format!("the character U+{code:04X} may not stand in XML: remove it");
            self.error(Kind::IllegalCharacter, (at, next), (expat::INVALID, at), message);
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
        let verdict = if stop >= self.bytes.len() {
            self.hit_end = true;
            (expat::UNCLOSED_TOKEN, at)
        } else {
            (expat::INVALID, stop)
        };
        let message = match self.slice(at + 1, stop) {
            "" => "a plain `&` must be written `&amp;`".to_owned(),
            name => format!("`&{name}` needs a `;`, or write `&amp;` for a plain `&`"),
        };
        self.error(Kind::BadReference, (at, stop.max(at + 1)), verdict, message);
    }

    pub(super) fn bad_character_reference(&mut self, at: usize, end: usize, stop: usize) {
        let message = format!("`{}` refers to a character that XML does not allow", self.slice(at, end));
        self.error(Kind::BadCharacterReference, (at, end), (expat::BAD_CHAR_REF, stop), message);
    }

    /// Note a reference to an entity; whether it is fine, the header knows.
    pub(super) fn entity_use(&mut self, name: &str, at: (usize, usize), stop: usize, in_attribute: bool) {
        if matches!(name, "amp" | "lt" | "gt" | "quot" | "apos") {
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
        self.push_error(Condition::Entity { name: name.into(), in_attribute }, error);
    }

    /// A `<` that begins nothing.
    fn stray_lt(&mut self) {
        let start = self.pos;
        self.pos += 1;
        if self.peek().is_none() {
            self.push_node(NodeKind::Junk, start, 0);
            let message = "an element name is missing behind `<`";
            self.error(Kind::StrayLt, (start, self.pos), (expat::UNCLOSED_TOKEN, start), message);
            return;
        }
        self.push_node(NodeKind::Junk, start, 0);
        let message = "`<` begins no tag: write `&lt;` for a plain one";
        self.error(Kind::StrayLt, (start, self.pos), (expat::INVALID, self.pos), message);
    }

    fn name_of(&self, id: u32) -> &str {
        let Some(node) = self.nodes.get(id as usize) else { return "" };
        let start = self.base + node.start as usize + 1;
        self.slice(start, start + node.name_len as usize)
    }

    fn end_tag(&mut self) -> Option<Stop> {
        let start = self.pos;
        let (name_end, verdict) = self.scan_end_tag();
        let name = self.slice(start + 2, name_end);
        let mismatch = verdict.unwrap_or((expat::MISMATCH, start + 2));
        let found = self.open.iter().rev().take(MAX_LOOK).position(|&id| self.name_of(id) == name);
        if let Some(above) = found {
            self.report_end_tag(start, verdict);
            let depth = self.open.len() - above;
            let tag_end = std::mem::replace(&mut self.pos, start);
            self.close_unclosed(depth, Some((start, tag_end)), mismatch);
            self.pos = tag_end;
            self.close(Some(start));
            return self.open.is_empty().then_some(Stop::Element);
        }
        self.needs_root_name = true;
        if name == self.root_name {
            self.reach = self.reach.max(name_end + 1);
            let tag_end = std::mem::replace(&mut self.pos, start);
            self.close_unclosed(0, Some((start, tag_end)), mismatch);
            return Some(Stop::RootEnd);
        }
        self.report_end_tag(start, verdict);
        self.push_node(NodeKind::Junk, start, 0);
        let message = format!("`</{name}>` closes no open element: remove it or open one");
        self.error(Kind::MismatchedEndTag, (start, self.pos), mismatch, message);
        None
    }

    /// Move behind an end tag. Gives the end of its name and, if the tag is malformed, expat's verdict.
    pub(super) fn scan_end_tag(&mut self) -> (usize, Option<(&'static str, usize)>) {
        let start = self.pos;
        self.pos += 2;
        if name_char(self.text, self.pos, true) == 0 {
            let at = self.pos;
            let verdict =
                if self.peek().is_none() { (expat::UNCLOSED_TOKEN, start) } else { (expat::INVALID, at) };
            return (at, Some(verdict));
        }
        loop {
            match name_char(self.text, self.pos, false) {
                0 if self.bytes.get(self.pos) == Some(&b':') => self.pos += 1,
                0 => break,
                n => self.pos += n,
            }
        }
        let name_end = self.pos;
        self.skip_space();
        match self.peek() {
            Some(b'>') => {
                self.pos += 1;
                (name_end, None)
            }
            None => (name_end, Some((expat::UNCLOSED_TOKEN, start))),
            Some(_) => {
                let at = self.pos;
                self.pos = name_end;
                (name_end, Some((expat::INVALID, at)))
            }
        }
    }

    pub(super) fn report_end_tag(&mut self, start: usize, verdict: Option<(&'static str, usize)>) {
        if let Some(verdict) = verdict {
            let message = format!("the end tag `{}` needs a `>`", self.slice(start, self.pos));
            self.error(Kind::UnclosedTag, (start, self.pos), verdict, message);
        }
    }

    /// Close the elements above `depth` here, without end tags of their own.
    pub(super) fn close_unclosed(
        &mut self,
        depth: usize,
        end_tag: Option<(usize, usize)>,
        verdict: (&'static str, usize),
    ) {
        let mut reported = 0;
        while self.open.len() > depth {
            let Some(&id) = self.open.last() else { return };
            if reported < MAX_UNCLOSED {
                self.report_unclosed(id, end_tag, verdict);
                reported += 1;
            }
            self.close(None);
        }
    }

    fn report_unclosed(&mut self, id: u32, end_tag: Option<(usize, usize)>, verdict: (&'static str, usize)) {
        let Some(node) = self.nodes.get(id as usize) else { return };
        let start = self.base + node.start as usize;
        let end = start + 1 + node.name_len as usize;
        let name = self.slice(start + 1, end);
        let message = match end_tag {
            Some((from, _)) => {
                format!("`<{name}>` is not closed before `{}`: add `</{name}>`", self.tag_name_text(from))
            }
            None => format!("`<{name}>` is never closed: add `</{name}>`"),
        };
        let error = SyntaxError {
            kind: Kind::UnclosedElement,
            range: self.range(start, end),
            related: end_tag.map(|(from, to)| (self.range(from, to), "this end tag comes first")),
            message,
            expat: verdict.0,
            expat_offset: self.rel(verdict.1),
        };
        self.push_error(Condition::Always, error);
    }

    fn tag_name_text(&self, from: usize) -> String {
        let name = self.qname(from + 2);
        format!("{}>", self.slice(from, name.end))
    }

    /// Close the innermost element at the current position.
    fn close(&mut self, end_tag: Option<usize>) {
        let end = self.rel(self.pos);
        let subtree_end = self.nodes.len() as u32;
        let tag = end_tag.map(|at| self.rel(at));
        let Some(node) = self.open.pop().and_then(|id| self.nodes.get_mut(id as usize)) else { return };
        node.end = end;
        node.subtree_end = subtree_end;
        if let Some(tag) = tag {
            node.end_tag = tag;
        }
        self.scopes.leave(self.open.len());
    }
}
