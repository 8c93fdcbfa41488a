//! Attribute values.

use super::{ExpatError, ItemParser};
use crate::chars::{is_space, name_char, stops_value};
use crate::decode::{Reference, read_reference};
use crate::error::{SyntaxErrorKind as Kind, expat};
use crate::node::{HAS_DOLLAR, NEEDS_DECODING, QUOTED};

/// Bytes one line is looked at for a closing quote.
const MAX_LINE: usize = 1024;

impl ItemParser<'_> {
    /// Read a value in quotes; the position is on the opening one. Gives whether it is sound.
    pub(super) fn quoted_value(&mut self, name: (usize, usize), quote: u8, mut flags: u8) -> bool {
        let start = self.pos + 1;
        let first_error = self.errors.len();
        let min_offset = self.min_offset.take();
        self.pos = start;
        flags |= self.scan_value(quote);
        let end = self.pos;
        self.check_characters(start, end);
        if let Some(errors) = self.errors.get_mut(first_error..) {
            errors.sort_by_key(|e| e.error.expat_offset);
        }
        self.min_offset =
            min_offset.max(self.errors.get(first_error).map(|e| e.error.expat_offset));
        if self.bytes.get(end) != Some(&quote) {
            return self.broken_value(name, start, quote, flags);
        }
        if let Some(cut) = self.swallowed_attribute(start, end) {
            self.cut_value(name, (start, cut), flags, (expat::INVALID, end + 1));
            return false;
        }
        self.pos += 1;
        self.push_attr(name.0, name.1, (start, end), flags | QUOTED);
        true
    }

    /// Move to the closing quote, to a `<`, or to the end of the text.
    fn scan_value(&mut self, quote: u8) -> u8 {
        let mut flags = 0;
        while let Some(&b) = self.bytes.get(self.pos) {
            if !stops_value(b) {
                self.pos += 1;
                continue;
            }
            match b {
                b'<' => return flags,
                _ if b == quote => return flags,
                b'$' => flags |= HAS_DOLLAR,
                b'&' => {
                    flags |= NEEDS_DECODING;
                    match read_reference(self.text, self.pos) {
                        // The end of the text is reported once, for the tag.
                        Reference::Bad(stop) if stop < self.bytes.len() => {
                            self.bad_reference(self.pos, stop)
                        }
                        _ => {}
                    }
                }
                b'"' | b'\'' => {}
                _ => flags |= NEEDS_DECODING,
            }
            self.pos += 1;
        }
        self.hit_end = true;
        flags
    }

    /// The value from `start` is closed at `end`, but what follows shows that the quote there opens the
    /// next value: `a="x b="y"`. Gives the end of the real value.
    fn swallowed_attribute(&self, start: usize, end: usize) -> Option<usize> {
        let next = *self.bytes.get(end + 1)?;
        if is_space(next) || b"/>?<".contains(&next) {
            return None;
        }
        let value = self.slice(start, end).strip_suffix('=')?.trim_end();
        let name = value.len()
            - value
                .chars()
                .rev()
                .take_while(|c| !c.is_ascii_whitespace())
                .map(char::len_utf8)
                .sum::<usize>();
        let is_name = name_char(self.text, start + name, true) > 0
            && self.qname(start + name).end == start + value.len();
        (is_name && name > 0)
            .then(|| start + value.get(..name).map_or(0, |text| text.trim_end().len()))
    }

    /// The value from `start` runs into a `<` or into the end of the text, where the position is.
    fn broken_value(&mut self, name: (usize, usize), start: usize, quote: u8, flags: u8) -> bool {
        let stop = self.pos;
        let line = self.bytes.get(stop..).unwrap_or(&[]);
        let line = line.get(..MAX_LINE).unwrap_or(line);
        let line_end = stop + memchr::memchr2(b'\n', b'\r', line).unwrap_or(line.len());
        self.look(line_end + 1);
        if stop < self.bytes.len() && !self.begins_line(stop) {
            let closing = memchr::memchr(quote, self.bytes.get(stop..line_end).unwrap_or(&[]))
                .map(|n| stop + n);
            if let Some(end) = closing.filter(|end| self.may_end_value(end + 1)) {
                return self.value_with_lt(name, start, (stop, end), flags);
            }
        }
        let first_line = memchr::memchr2(b'\n', b'\r', self.bytes.get(start..stop).unwrap_or(&[]));
        let text = self.slice(start, first_line.map_or(stop, |n| start + n));
        let text = text
            .strip_suffix("/>")
            .or(text.strip_suffix('>'))
            .unwrap_or(text);
        let expat_error = if stop < self.bytes.len() {
            (expat::INVALID, stop)
        } else {
            let tag = self.nodes.last().map_or(0, |node| node.start as usize);
            (expat::UNCLOSED_TOKEN, self.base + tag)
        };
        self.cut_value(name, (start, start + text.len()), flags, expat_error);
        false
    }

    fn begins_line(&mut self, at: usize) -> bool {
        self.look(at + 9);
        self.next_line_markup(at, at + 1).is_some()
    }

    fn may_end_value(&self, at: usize) -> bool {
        self.bytes
            .get(at)
            .is_none_or(|&b| is_space(b) || b"/>?".contains(&b))
    }

    /// A value with a stray `<` at `stop` that is closed on the same line, at `end`.
    fn value_with_lt(
        &mut self,
        name: (usize, usize),
        start: usize,
        (stop, end): (usize, usize),
        mut flags: u8,
    ) -> bool {
        let message = "`<` is not allowed in an attribute value\nwrite `&lt;`";
        self.error(
            Kind::LtInValue,
            (stop, stop + 1),
            (expat::INVALID, stop),
            message,
        );
        flags |= self.raw_flags(stop, end);
        self.pos = end + 1;
        self.push_attr(name.0, name.1, (start, end), flags | QUOTED);
        true
    }

    fn raw_flags(&self, start: usize, end: usize) -> u8 {
        let raw = self.slice(start, end);
        let dollar = if raw.contains('$') { HAS_DOLLAR } else { 0 };
        let coded = if raw.contains(['&', '\t', '\n', '\r']) {
            NEEDS_DECODING
        } else {
            0
        };
        dollar | coded
    }

    /// The value ends where it should, but for its quote; go on from there.
    fn cut_value(
        &mut self,
        name: (usize, usize),
        value: (usize, usize),
        flags: u8,
        expat_error: ExpatError,
    ) {
        // What was found behind the cut will be found again, as something else.
        let behind = self.rel(value.1);
        let dropped = self.errors.iter().find(|e| e.error.range.start >= behind);
        let expat_error = dropped.map_or(expat_error, |e| {
            (e.error.expat, self.base + e.error.expat_offset as usize)
        });
        self.errors.retain(|e| e.error.range.start < behind);
        self.pos = value.1;
        self.look(expat_error.1 + 1);
        let message = format!(
            "value of `{}` has no closing quote\nadd the closing quote",
            self.slice(name.0, name.1)
        );
        self.error(
            Kind::UnclosedValue,
            (value.0 - 1, value.1),
            expat_error,
            message,
        );
        self.mark_divergence();
        let flags = flags & !(HAS_DOLLAR | NEEDS_DECODING) | self.raw_flags(value.0, value.1);
        self.push_attr(name.0, name.1, value, flags);
    }

    /// A value without quotes, perhaps without anything.
    pub(super) fn bare_value(&mut self, name: (usize, usize), behind_equals: usize, flags: u8) {
        let start = self.pos;
        while let Some(&b) = self.bytes.get(self.pos) {
            if is_space(b) || b"<>\"'".contains(&b) || self.starts_with(b"/>") {
                break;
            }
            self.pos += 1;
        }
        if start < self.bytes.len() {
            let name_text = self.slice(name.0, name.1);
            let message = match self
                .slice(start, self.pos)
                .chars()
                .next()
                .filter(|c| "“”„‟‘’‚″′«»".contains(*c))
            {
                Some(quote) => {
                    format!("value of `{name_text}` is in `{quote}` instead of quotes\nwrite `\"`")
                }
                None => format!("value of `{name_text}` must be quoted\nwrite {name_text}=\"...\""),
            };
            self.error(
                Kind::BadAttribute,
                (name.0, self.pos),
                (expat::INVALID, start),
                message,
            );
        }
        if self.pos == start {
            self.pos = behind_equals;
            self.push_attr(name.0, name.1, (behind_equals, behind_equals), flags);
            return;
        }
        let flags = flags | self.raw_flags(start, self.pos);
        self.push_attr(name.0, name.1, (start, self.pos), flags);
    }
}
