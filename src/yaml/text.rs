//! Scalars: plain, quoted, block.

use super::error::{RawError, repr};
use super::reader::{END, Mark, is_blank, is_blank_or_end, is_break, is_break_or_end};
use super::scanner::Scanner;
use super::token::{YamlToken, YamlTokenKind};
use base::TextRange;

/// A character as messages show it: Python reads every line end as `\n`.
pub(super) fn shown(c: char) -> String {
    repr(&if c == '\r' { '\n' } else { c }.to_string())
}

/// Whether a blank, other than a tab, or the end of the line follows.
pub(super) fn is_space_or_end(c: char) -> bool {
    c == ' ' || is_break_or_end(c)
}

impl Scanner<'_> {
    /// A token from `start` to the cursor.
    pub(super) fn token(&self, kind: YamlTokenKind, start: Mark) -> YamlToken {
        YamlToken {
            kind,
            start,
            end: self.reader.mark(),
        }
    }

    /// "expected X, but found Y", Y being the character at the cursor.
    pub(super) fn unexpected(&self, context: &str, began: Mark, expected: &str) -> RawError {
        let problem = format!(
            "expected {expected}, but found {}",
            shown(self.reader.peek())
        );
        RawError::within(context, began, problem, self.reader.mark())
    }

    /// The value of `count` hexadecimal digits, which are taken, or the first character that is none.
    pub(super) fn hex_digits(&mut self, count: usize) -> Result<u32, char> {
        let digits = (0..count).map(|ahead| self.reader.peek_at(ahead));
        let value = digits
            .map(|c| c.to_digit(16).ok_or(c))
            .try_fold(0u64, |value, digit| {
                digit.map(|digit| value * 16 + u64::from(digit))
            });
        let value = value?;
        for _ in 0..count {
            self.reader.advance();
        }
        Ok(u32::try_from(value).unwrap_or(u32::MAX))
    }

    /// Text without quotes.
    pub(super) fn scan_plain(&mut self) -> Result<YamlToken, RawError> {
        let start = self.reader.mark();
        let mut end = start;
        let indent = self.indent() + 1;
        let (mut text, mut blanks) = (String::new(), String::new());
        while self.reader.peek() != '#' {
            let before = text.len();
            while !self.plain_ends() {
                if text.len() == before {
                    text.push_str(&blanks);
                }
                text.push(self.reader.advance());
            }
            if text.len() == before {
                break;
            }
            self.key_allowed = false;
            end = self.reader.mark();
            blanks = self.scan_plain_blanks();
            let outdented = !self.in_flow() && i64::from(self.reader.mark().column) < indent;
            if blanks.is_empty() || outdented {
                break;
            }
        }
        Ok(YamlToken {
            kind: YamlTokenKind::Scalar(text, true),
            start,
            end,
        })
    }

    fn plain_ends(&self) -> bool {
        let in_flow = self.in_flow();
        match self.reader.peek() {
            c if is_blank_or_end(c) => true,
            ':' => {
                let next = self.reader.peek_at(1);
                is_blank_or_end(next) || in_flow && ",[]{}".contains(next)
            }
            c => in_flow && ",?[]{}".contains(c),
        }
    }

    /// What stands between two words of a plain scalar; nothing when the scalar ends here.
    fn scan_plain_blanks(&mut self) -> String {
        let blanks = self.reader.take_while(|c| c == ' ');
        let Some(first) = self.reader.take_break() else {
            return blanks.to_owned();
        };
        self.key_allowed = true;
        let mut breaks = String::new();
        loop {
            if self.reader.at_document_marker() {
                return String::new();
            }
            self.reader.take_while(|c| c == ' ');
            match self.reader.take_break() {
                Some(c) => breaks.push(c),
                None => return folded(first, &breaks),
            }
        }
    }

    /// Text in single or double quotes.
    pub(super) fn scan_quoted(&mut self) -> Result<YamlToken, RawError> {
        let start = self.reader.mark();
        let quote = self.reader.advance();
        let mut text = String::new();
        self.scan_quoted_words(quote, start, &mut text)?;
        while self.reader.peek() != quote {
            self.scan_quoted_blanks(start, &mut text)?;
            self.scan_quoted_words(quote, start, &mut text)?;
        }
        self.reader.advance();
        Ok(self.token(YamlTokenKind::Scalar(text, false), start))
    }

    fn scan_quoted_words(
        &mut self,
        quote: char,
        start: Mark,
        text: &mut String,
    ) -> Result<(), RawError> {
        loop {
            match self.reader.peek() {
                c if is_blank_or_end(c) => return Ok(()),
                '\\' if quote == '"' => self.scan_escape(start, text)?,
                c if c == quote => {
                    if quote == '"' || self.reader.peek_at(1) != quote {
                        return Ok(());
                    }
                    self.reader.advance();
                    text.push(self.reader.advance());
                }
                _ => text.push(self.reader.advance()),
            }
        }
    }

    fn scan_escape(&mut self, start: Mark, text: &mut String) -> Result<(), RawError> {
        let context = "while scanning a double-quoted scalar";
        self.reader.advance();
        let c = self.reader.peek();
        if let Some(plain) = escaped(c) {
            self.reader.advance();
            text.push(plain);
            return Ok(());
        }
        let length = match c {
            'x' => 2,
            'u' => 4,
            'U' => 8,
            c if is_break(c) => {
                self.reader.take_break();
                text.push_str(&self.scan_quoted_breaks(start)?);
                return Ok(());
            }
            _ => {
                let problem = format!("found unknown escape character {}", shown(c));
                return Err(RawError::within(
                    context,
                    start,
                    problem,
                    self.reader.mark(),
                ));
            }
        };
        self.reader.advance();
        let at = self.reader.mark();
        let code = self.hex_digits(length).map_err(|found| {
            let problem = format!(
                "expected escape sequence of {length} hexadecimal numbers, but found {}",
                shown(found)
            );
            RawError::within(context, start, problem, at)
        })?;
        // A lone surrogate is a character in Python and none here.
        match char::from_u32(code) {
            Some(c) => text.push(c),
            None if code <= 0xFFFF => text.push('\u{FFFD}'),
            None => {
                let range = TextRange::new(at.offset, self.reader.mark().offset);
                return Err(RawError::Python {
                    message: "chr() arg not in range(0x110000)".to_owned(),
                    range,
                });
            }
        }
        Ok(())
    }

    fn scan_quoted_blanks(&mut self, start: Mark, text: &mut String) -> Result<(), RawError> {
        let blanks = self.reader.take_while(is_blank);
        if self.reader.peek() == END {
            let problem = "found unexpected end of stream";
            return Err(RawError::within(
                "while scanning a quoted scalar",
                start,
                problem,
                self.reader.mark(),
            ));
        }
        match self.reader.take_break() {
            Some(first) => {
                let breaks = self.scan_quoted_breaks(start)?;
                text.push_str(&folded(first, &breaks));
            }
            None => text.push_str(blanks),
        }
        Ok(())
    }

    /// Empty lines inside quotes.
    fn scan_quoted_breaks(&mut self, start: Mark) -> Result<String, RawError> {
        let mut breaks = String::new();
        loop {
            if self.reader.at_document_marker() {
                let problem = "found unexpected document separator";
                let context = "while scanning a quoted scalar";
                return Err(RawError::within(
                    context,
                    start,
                    problem,
                    self.reader.mark(),
                ));
            }
            self.reader.take_while(is_blank);
            match self.reader.take_break() {
                Some(c) => breaks.push(c),
                None => return Ok(breaks),
            }
        }
    }

    /// Text behind `|` or `>`.
    pub(super) fn scan_block_scalar(&mut self) -> Result<YamlToken, RawError> {
        let start = self.reader.mark();
        let is_folded = self.reader.advance() == '>';
        let header = self.scan_block_header(start)?;
        let least = (self.indent() + 1).max(1);
        let mut end = self.reader.mark();
        let (mut breaks, indent) = match header.indent {
            Some(more) => (String::new(), least + i64::from(more) - 1),
            None => {
                let (breaks, widest) = self.scan_leading_lines(&mut end);
                (breaks, least.max(widest))
            }
        };
        breaks.push_str(&self.scan_block_breaks(indent, &mut end));
        let mut text = String::new();
        let mut last_break = None;
        while i64::from(self.reader.mark().column) == indent && self.reader.peek() != END {
            text.push_str(&breaks);
            let was_flush = !is_blank(self.reader.peek());
            text.push_str(self.reader.take_while(|c| !is_break_or_end(c)));
            end = self.reader.mark();
            last_break = self.reader.take_break();
            breaks = self.scan_block_breaks(indent, &mut end);
            let next = self.reader.peek();
            if i64::from(self.reader.mark().column) != indent || next == END {
                break;
            }
            match last_break {
                Some('\n') if is_folded && was_flush && !is_blank(next) => {
                    text.push_str(if breaks.is_empty() { " " } else { "" });
                }
                Some(c) => text.push(c),
                None => {}
            }
        }
        if header.chomp != Some('-') {
            text.extend(last_break);
        }
        if header.chomp == Some('+') {
            text.push_str(&breaks);
        }
        Ok(YamlToken {
            kind: YamlTokenKind::Scalar(text, false),
            start,
            end,
        })
    }

    fn scan_block_header(&mut self, start: Mark) -> Result<BlockHeader, RawError> {
        let context = "while scanning a block scalar";
        let mut header = BlockHeader::default();
        loop {
            match self.reader.peek() {
                c @ ('+' | '-') if header.chomp.is_none() => header.chomp = Some(c),
                '0' if header.indent.is_none() => {
                    let problem = "expected indentation indicator in the range 1-9, but found 0";
                    return Err(RawError::within(
                        context,
                        start,
                        problem,
                        self.reader.mark(),
                    ));
                }
                c if c.is_ascii_digit() && header.indent.is_none() => {
                    header.indent = c.to_digit(10)
                }
                _ => break,
            }
            self.reader.advance();
        }
        if !is_space_or_end(self.reader.peek()) {
            return Err(self.unexpected(context, start, "chomping or indentation indicators"));
        }
        self.skip_blanks_and_comment();
        if !is_break_or_end(self.reader.peek()) {
            return Err(self.unexpected(context, start, "a comment or a line break"));
        }
        self.reader.take_break();
        Ok(header)
    }

    /// The empty lines before the first line of a block scalar, and the widest indentation seen.
    fn scan_leading_lines(&mut self, end: &mut Mark) -> (String, i64) {
        let (mut breaks, mut widest) = (String::new(), 0);
        loop {
            if self.reader.peek() == ' ' {
                self.reader.advance();
                widest = widest.max(i64::from(self.reader.mark().column));
            } else if let Some(c) = self.reader.take_break() {
                breaks.push(c);
                *end = self.reader.mark();
            } else {
                return (breaks, widest);
            }
        }
    }

    /// The empty lines between lines of a block scalar.
    fn scan_block_breaks(&mut self, indent: i64, end: &mut Mark) -> String {
        let mut breaks = String::new();
        loop {
            while i64::from(self.reader.mark().column) < indent && self.reader.peek() == ' ' {
                self.reader.advance();
            }
            match self.reader.take_break() {
                Some(c) => breaks.push(c),
                None => return breaks,
            }
            *end = self.reader.mark();
        }
    }
}

/// What stands behind `|` or `>`.
#[derive(Default)]
struct BlockHeader {
    chomp: Option<char>,
    indent: Option<u32>,
}

/// One line break becomes a blank; of several, the first is dropped.
fn folded(first: char, breaks: &str) -> String {
    match (first, breaks) {
        ('\n', "") => " ".to_owned(),
        ('\n', breaks) => breaks.to_owned(),
        (first, breaks) => format!("{first}{breaks}"),
    }
}

/// The character a one-letter escape stands for.
fn escaped(c: char) -> Option<char> {
    Some(match c {
        '0' => '\0',
        'a' => '\x07',
        'b' => '\x08',
        't' | '\t' => '\t',
        'n' => '\n',
        'v' => '\x0B',
        'f' => '\x0C',
        'r' => '\r',
        'e' => '\x1B',
        ' ' | '"' | '\\' | '/' => c,
        'N' => '\u{85}',
        '_' => '\u{A0}',
        'L' => '\u{2028}',
        'P' => '\u{2029}',
        _ => return None,
    })
}
