//! The text, read character by character.

use super::error::RawError;

/// A place in the text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Mark {
    /// Bytes before it.
    pub(super) offset: u32,
    /// Characters before it.
    pub(super) index: u32,
    /// Lines before its line.
    pub(super) line: u32,
    /// Characters before it in its line.
    pub(super) column: u32,
}

/// What [`YamlReader::peek`] gives behind the last character; no text holds it.
pub(super) const END: char = '\0';

/// A cursor.
pub(super) struct YamlReader<'t> {
    text: &'t str,
    mark: Mark,
}

/// Whether a character ends a line.
pub(super) fn is_break(c: char) -> bool {
    matches!(c, '\n' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// Whether a line ends here.
pub(super) fn is_break_or_end(c: char) -> bool {
    c == END || is_break(c)
}

/// Whether a character stands between words of a line.
pub(super) fn is_blank(c: char) -> bool {
    matches!(c, ' ' | '\t')
}

/// Whether a word ends here.
pub(super) fn is_blank_or_end(c: char) -> bool {
    is_blank(c) || is_break_or_end(c)
}

impl<'t> YamlReader<'t> {
    /// A cursor at the start of `text`.
    ///
    /// # Errors
    /// When the text holds a character no YAML may hold.
    pub(super) fn new(text: &'t str) -> Result<Self, RawError> {
        for (index, (offset, c)) in text.char_indices().enumerate() {
            if !is_printable(c) {
                // Python counts a line end of two characters as one.
                let pairs = text.get(..offset).unwrap_or("").matches("\r\n").count();
                return Err(RawError::Character {
                    c,
                    index: index - pairs,
                    offset,
                });
            }
        }
        Ok(Self {
            text,
            mark: Mark::default(),
        })
    }

    /// The place of the cursor.
    pub(super) fn mark(&self) -> Mark {
        self.mark
    }

    fn rest(&self) -> &'t str {
        self.text.get(self.mark.offset as usize..).unwrap_or("")
    }

    /// The character at the cursor.
    pub(super) fn peek(&self) -> char {
        match self.text.as_bytes().get(self.mark.offset as usize) {
            Some(&byte) if byte.is_ascii() => char::from(byte),
            _ => self.rest().chars().next().unwrap_or(END),
        }
    }

    /// The character `ahead` places further; for small numbers.
    pub(super) fn peek_at(&self, ahead: usize) -> char {
        self.rest().chars().nth(ahead).unwrap_or(END)
    }

    /// Whether the text at the cursor starts with `prefix`.
    pub(super) fn starts_with(&self, prefix: &str) -> bool {
        self.rest().starts_with(prefix)
    }

    /// The text up to the next blank (a tab is none) or line break.
    pub(super) fn word(&self) -> &'t str {
        self.rest()
            .split(|c| c == ' ' || is_break(c))
            .next()
            .unwrap_or("")
    }

    /// The offset at which the line of `mark` ends.
    pub(super) fn line_end(&self, mark: Mark) -> u32 {
        let line = self
            .text
            .get(mark.offset as usize..)
            .unwrap_or("")
            .split(is_break)
            .next();
        mark.offset + line.map_or(0, str::len) as u32
    }

    /// Whether `---` or `...` stands here as a word.
    pub(super) fn at_document_marker(&self) -> bool {
        (self.starts_with("---") || self.starts_with("...")) && is_blank_or_end(self.peek_at(3))
    }

    /// Move over one character and return it.
    pub(super) fn advance(&mut self) -> char {
        let c = self.peek();
        if c == END {
            return END;
        }
        self.mark.offset += c.len_utf8() as u32;
        self.mark.index += 1;
        if is_break(c) && (c != '\r' || self.peek() != '\n') {
            self.mark.line += 1;
            self.mark.column = 0;
        } else if c != '\u{FEFF}' {
            self.mark.column += 1;
        }
        c
    }

    /// Move over all characters `wanted` accepts and return them.
    pub(super) fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> &'t str {
        let start = self.mark.offset as usize;
        loop {
            let c = self.peek();
            if c == END || !wanted(c) {
                return self
                    .text
                    .get(start..self.mark.offset as usize)
                    .unwrap_or("");
            }
            self.advance();
        }
    }

    /// Move over one line break, if there is one, and return what stands for it in a scalar.
    pub(super) fn take_break(&mut self) -> Option<char> {
        let c = self.peek();
        if !is_break(c) {
            return None;
        }
        if self.advance() == '\r' && self.peek() == '\n' {
            self.advance();
        }
        Some(if matches!(c, '\u{2028}' | '\u{2029}') {
            c
        } else {
            '\n'
        })
    }
}

fn is_printable(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | ' '..='~' | '\u{85}' | '\u{A0}'..='\u{D7FF}' | '\u{E000}'..='\u{FFFD}')
        || c >= '\u{10000}'
}
