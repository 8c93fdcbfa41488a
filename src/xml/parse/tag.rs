//! Start tags and their attributes.
#![allow(clippy::indexing_slicing)] // ids and attribute numbers this parser made itself

use super::{ContentEnd, ExpatError, ItemParser};
use crate::chars::is_space;
use crate::error::{SyntaxErrorKind as Kind, expat};
use crate::node::{AttrData, HAS_EQUALS, NO_CONTENT, NodeKind, PREFIXED, SELF_CLOSING};
use base::Id;

impl ItemParser<'_> {
    /// Read a start tag.
    pub(super) fn start_tag(&mut self) -> Option<ContentEnd> {
        let start = self.pos;
        let name = self.qname(start + 1);
        self.min_offset = Some(0);
        self.pos = name.end;
        let id = self.push_node(NodeKind::Element, start, 0);
        let first_attr = self.attrs.len();
        self.nodes.as_mut_slice()[id.index()].name_len = (name.end - start - 1) as u32;
        if let Some(at) = name.bad {
            self.bad_name((start + 1, name.end), at);
        }
        let flags = self.tag_rest(start, name.bad.is_some());
        let node = &mut self.nodes.as_mut_slice()[id.index()];
        node.flags = flags;
        node.attrs = (first_attr as u32, self.attrs.len() as u32);
        node.start_tag_end = (self.pos - self.base) as u32;
        node.end = node.start_tag_end;
        let prefix = if name.prefixed && name.bad.is_none() {
            name.end
        } else {
            start
        };
        self.check_tag(start, prefix, first_attr);
        self.min_offset = None;
        if flags & NO_CONTENT == 0 {
            self.open.push(id);
            return None;
        }
        self.scopes.leave(self.open.len());
        self.open.is_empty().then_some(ContentEnd::Element)
    }

    /// A name whose grammar breaks at `at`.
    pub(super) fn bad_name(&mut self, range: (usize, usize), at: usize) {
        if at >= self.bytes.len() {
            // The end of the text is reported once, for the tag.
            self.hit_end = true;
            return;
        }
        let name = self.slice(range.0, range.1);
        let message = if name.ends_with(':') {
            format!("missing name after `{name}`\nwrite a name")
        } else {
            format!(
                "invalid name `{name}`\nuse letters, digits, `_`, `-` and `.`; start with a letter or `_`"
            )
        };
        self.error(Kind::BadName, range, (expat::INVALID, at), message);
    }

    /// Read attributes up to the end of the tag. Gives the flags of the element.
    fn tag_rest(&mut self, start: usize, mut bad: bool) -> u8 {
        let mut slash = false;
        loop {
            let gap = self.pos;
            self.skip_space();
            let at = self.pos;
            match self.peek() {
                Some(b'>') => {
                    self.pos += 1;
                    return if slash { NO_CONTENT | SELF_CLOSING } else { 0 };
                }
                Some(b'/') if self.bytes.get(at + 1) == Some(&b'>') => {
                    self.pos += 2;
                    return NO_CONTENT | SELF_CLOSING;
                }
                None => return self.unclosed_tag(start, gap, (expat::UNCLOSED_TOKEN, start)),
                Some(b'<') => return self.unclosed_tag(start, gap, (expat::INVALID, at)),
                Some(b'/') => {
                    self.pos += 1;
                    if self.peek().is_some() {
                        let message = "`/` is not followed by `>`\nwrite `/>`";
                        self.error(
                            Kind::BadAttribute,
                            (at, at + 1),
                            (expat::INVALID, at + 1),
                            message,
                        );
                    }
                    bad = true;
                    slash = true;
                    continue;
                }
                Some(_) => {
                    if gap == at && !bad {
                        let written = self.slice(start, at);
                        let is_inside = written.rfind("${") > written.rfind('}');
                        let message = if is_inside {
                            "missing space between attributes\nuse single quotes inside of the value: `'`; `\"` ends it"
                        } else {
                            "missing space between attributes\nadd a space"
                        };
                        let end = self.char_end(at);
                        self.error(Kind::BadAttribute, (at, end), (expat::INVALID, at), message);
                    }
                    bad = !self.attribute();
                    slash = false;
                }
            }
        }
    }

    fn unclosed_tag(&mut self, start: usize, gap: usize, expat_error: ExpatError) -> u8 {
        let next = self.pos;
        self.look(next + 1);
        self.pos = gap;
        let name = self.qname(start + 1);
        let message = format!(
            "unclosed tag `<{}`: `>` or `/>` is missing\nadd `>` or `/>`",
            self.slice(start + 1, name.end)
        );
        self.error(Kind::UnclosedTag, (start, name.end), expat_error, message);
        // Whatever follows the root is meant to be in it.
        if self.in_header || self.keeps_content(start, name.end, next) {
            0
        } else {
            NO_CONTENT
        }
    }

    /// Read one attribute, or skip what is none. Gives whether it is sound.
    fn attribute(&mut self) -> bool {
        let start = self.pos;
        let name = self.qname(start);
        if name.end == start {
            return self.skip_junk_in_tag();
        }
        self.pos = name.end;
        if let Some(at) = name.bad {
            self.bad_name((start, name.end), at);
        }
        self.skip_space();
        let flags = if name.prefixed && name.bad.is_none() {
            PREFIXED
        } else {
            0
        };
        if self.bytes.get(self.pos) != Some(&b'=') {
            let at = std::mem::replace(&mut self.pos, name.end);
            if name.bad.is_none() && at < self.bytes.len() {
                let message = format!(
                    "attribute `{0}` has no value\nwrite {0}=\"...\"",
                    self.slice(start, name.end)
                );
                self.error(
                    Kind::BadAttribute,
                    (start, name.end),
                    (expat::INVALID, at),
                    message,
                );
            }
            self.push_attr(start, name.end, (name.end, name.end), flags);
            return at >= self.bytes.len();
        }
        self.pos += 1;
        let behind_equals = self.pos;
        self.skip_space();
        match self.peek() {
            Some(quote @ (b'"' | b'\'')) => {
                self.quoted_value((start, name.end), quote, flags | HAS_EQUALS)
            }
            _ => {
                self.bare_value((start, name.end), behind_equals, flags | HAS_EQUALS);
                false
            }
        }
    }

    fn skip_junk_in_tag(&mut self) -> bool {
        let start = self.pos;
        self.pos = self.char_end(start);
        while self
            .bytes
            .get(self.pos)
            .is_some_and(|&b| !is_space(b) && !b"/><".contains(&b))
        {
            self.pos = self.char_end(self.pos);
        }
        let message = format!(
            "unexpected `{}` in a tag\nremove it",
            self.slice(start, self.pos)
        );
        self.error(
            Kind::BadAttribute,
            (start, self.pos),
            (expat::INVALID, start),
            message,
        );
        false
    }

    pub(super) fn push_attr(
        &mut self,
        name: usize,
        name_end: usize,
        value: (usize, usize),
        flags: u8,
    ) {
        let attr = AttrData {
            name: self.rel(name),
            name_len: (name_end - name) as u32,
            value: self.rel(value.0),
            value_end: self.rel(value.1),
            end: self.rel(self.pos),
            flags,
        };
        self.attrs.push(attr);
    }
}
