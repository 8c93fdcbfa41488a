//! Tokens of a Python expression.
//!
//! Brackets come out balanced: a closer that fits nothing is dropped, a missing one is put in with
//! an empty range. So the parser can skip and recover without counting.

use super::number;
use super::report::{ErrorStage, ExprErrors, OpenBracket};
use super::syntax::{is_name_continue, is_name_start};
use super::token::{Bracket, Tok, Token, is_string_prefix, keyword, operator};
use base::TextRange;
use base::limits::BRACKETS;

/// What to read.
pub(super) struct LexerInput<'t> {
    pub(super) text: &'t str,
    /// First and last offset of the expression proper.
    pub(super) start: usize,
    pub(super) end: usize,
    /// Where the final token stands: behind blanks that follow the expression.
    pub(super) outer_end: usize,
    /// Whether line ends mean nothing, as inside brackets.
    pub(super) bracketed: bool,
}

/// Split the source into tokens; the last is [`Tok::End`].
pub(super) fn lex(source: &LexerInput<'_>, report: &mut ExprErrors<'_>) -> Vec<Token> {
    let text = source.text.get(..source.end).unwrap_or(source.text);
    let mut lexer = Lexer {
        text,
        pos: source.start.min(text.len()),
        bracketed: source.bracketed,
        stack: Vec::new(),
        tokens: Vec::with_capacity((source.end.saturating_sub(source.start)) / 3 + 4),
        report,
    };
    while let Some(b) = lexer.byte(0) {
        lexer.token(b);
    }
    lexer.finish(source.outer_end);
    lexer.tokens
}

struct Lexer<'t, 'r, 'x> {
    text: &'t str,
    pos: usize,
    bracketed: bool,
    stack: Vec<(Bracket, u32)>,
    tokens: Vec<Token>,
    report: &'r mut ExprErrors<'x>,
}

impl Lexer<'_, '_, '_> {
    /// The byte `ahead` of the current one.
    fn byte(&self, ahead: usize) -> Option<u8> {
        self.text.as_bytes().get(self.pos + ahead).copied()
    }

    fn rest(&self) -> &str {
        self.text.get(self.pos..).unwrap_or("")
    }

    fn range_from(&self, start: usize) -> TextRange {
        TextRange::new(start as u32, self.pos as u32)
    }

    /// Take `len` bytes as a token.
    fn take(&mut self, kind: Tok, len: usize) {
        let start = self.pos;
        self.pos += len;
        self.push(kind, self.range_from(start));
    }

    fn push(&mut self, kind: Tok, range: TextRange) {
        self.tokens.push(Token { kind, range });
    }

    fn error(&mut self, range: TextRange, message: impl Into<String>, reference: &str) {
        self.report
            .add(ErrorStage::Token, range, message, reference);
    }

    fn token(&mut self, b: u8) {
        match b {
            b' ' | b'\t' | 0x0c => self.pos += 1,
            b'a'..=b'z' | b'A'..=b'Z' | b'_' | 0x80.. => self.word(),
            b'0'..=b'9' => self.number(),
            b'.' if self.byte(1).is_some_and(|d| d.is_ascii_digit()) => self.number(),
            b'"' | b'\'' => self.string(self.pos),
            b'\n' | b'\r' => self.line_end(),
            b'#' => self.comment(),
            b'\\' => self.continuation(),
            b'(' => self.open(Bracket::Round),
            b'[' => self.open(Bracket::Square),
            b'{' => self.open(Bracket::Curly),
            b')' => self.close(Bracket::Round),
            b']' => self.close(Bracket::Square),
            b'}' => self.close(Bracket::Curly),
            0..0x20 | 0x7f => self.control(b),
            _ => self.operator(b),
        }
    }

    fn comment(&mut self) {
        self.pos += self.rest().find(['\n', '\r']).unwrap_or(self.rest().len());
    }

    fn continuation(&mut self) {
        match (self.byte(1), self.byte(2)) {
            (Some(b'\r'), Some(b'\n')) => self.pos += 3,
            (Some(b'\r' | b'\n'), _) => self.pos += 2,
            _ => {
                let start = self.pos;
                self.pos += 1;
                let range = self.range_from(start);
                let message = "`\\` is allowed only at the end of a line";
                self.error(
                    range,
                    message,
                    "unexpected character after line continuation character",
                );
            }
        }
    }

    /// A line end outside of brackets, with the empty and comment lines that follow it.
    fn line_end(&mut self) {
        let start = self.pos;
        let mut line_start = start;
        while let Some(b) = self.byte(0) {
            match b {
                b'\n' | b'\r' => {
                    self.pos += 1;
                    line_start = self.pos;
                }
                b' ' | b'\t' | 0x0c => self.pos += 1,
                b'#' => self.comment(),
                _ => break,
            }
        }
        if self.bracketed || !self.stack.is_empty() || self.byte(0).is_none() {
            return;
        }
        if !self.tokens.is_empty() {
            self.push(Tok::Newline, TextRange::new(start as u32, start as u32 + 1));
        }
        if self.pos > line_start {
            self.push(Tok::Indent, self.range_from(line_start));
        }
    }

    fn control(&mut self, b: u8) {
        let start = self.pos;
        self.pos += 1;
        let range = self.range_from(start);
        let reference = format!("invalid non-printable character U+{b:04X}");
        self.error(range, "unexpected control character", &reference);
    }

    fn word(&mut self) {
        let start = self.pos;
        let bytes = self.text.as_bytes();
        self.pos += bytes
            .iter()
            .skip(start)
            .take_while(|&&b| b.is_ascii_alphanumeric() || b == b'_' || b >= 0x80)
            .count();
        let range = self.range_from(start);
        let name = range.slice(self.text);
        if matches!(self.byte(0), Some(b'"' | b'\'')) && is_string_prefix(name) {
            self.string(start);
        } else if name.is_ascii() {
            self.push(keyword(name).unwrap_or(Tok::Name), range);
        } else {
            self.unicode_word(range);
        }
    }

    /// A word with characters beyond ASCII: keep its good pieces, report the first bad character.
    fn unicode_word(&mut self, range: TextRange) {
        let word = range.slice(self.text).to_owned();
        let mut piece = range.start;
        for (i, c) in word.char_indices() {
            let at = range.start + i as u32;
            let good = if at == piece {
                is_name_start(c)
            } else {
                is_name_continue(c)
            };
            if good {
                continue;
            }
            if at > piece {
                self.push(Tok::Name, TextRange::new(piece, at));
            }
            let bad = TextRange::new(at, at + c.len_utf8() as u32);
            self.bad_character(bad, c);
            piece = bad.end;
        }
        if range.end > piece {
            let last = TextRange::new(piece, range.end);
            self.push(keyword(last.slice(self.text)).unwrap_or(Tok::Name), last);
        }
    }

    fn bad_character(&mut self, range: TextRange, c: char) {
        let code = c as u32;
        if is_printable(c) {
            let reference = format!("invalid character '{c}' (U+{code:04X})");
            self.error(range, format!("unexpected character `{c}`"), &reference);
        } else {
            let message = format!("unexpected invisible character U+{code:04X}");
            self.error(
                range,
                message,
                &format!("invalid non-printable character U+{code:04X}"),
            );
        }
    }

    fn number(&mut self) {
        let start = self.pos;
        let scanned = number::scan(self.rest().as_bytes());
        self.pos += scanned.len;
        let range = self.range_from(start);
        match scanned.error {
            None => self.push(Tok::Number, range),
            Some(reference) => {
                self.push(Tok::BadNumber, range);
                let detail = if reference.starts_with("leading zeros") {
                    "; leading zeros are not allowed"
                } else {
                    ""
                };
                let message = format!("`{}` is not a number{detail}", range.slice(self.text));
                self.error(range, message, &reference);
            }
        }
    }

    /// A string literal; `self.pos` is at the quote, `start` at the prefix.
    fn string(&mut self, start: usize) {
        let Some(quote) = self.byte(0) else { return };
        let triple = self.byte(1) == Some(quote) && self.byte(2) == Some(quote);
        self.pos += if triple { 3 } else { 1 };
        let closed = self.string_body(quote, triple);
        let range = self.range_from(start);
        self.push(if closed { Tok::Str } else { Tok::OpenStr }, range);
        if closed {
            return;
        }
        let message = format!("string has no closing `{}`", char::from(quote));
        let detected = self.report.line(range.end);
        let kind = if triple {
            "triple-quoted string"
        } else {
            "string"
        };
        self.error(
            range,
            message,
            &format!("unterminated {kind} literal (detected at line {detected})"),
        );
    }

    /// Move behind the closing quote; false if there is none.
    fn string_body(&mut self, quote: u8, triple: bool) -> bool {
        while let Some(b) = self.byte(0) {
            if b == quote
                && (!triple || (self.byte(1) == Some(quote) && self.byte(2) == Some(quote)))
            {
                self.pos += if triple { 3 } else { 1 };
                return true;
            }
            match b {
                b'\\' if self.byte(1).is_some() => {
                    self.pos += 2;
                    if self.byte(0) == Some(b'\n')
                        && self.text.as_bytes().get(self.pos - 1) == Some(&b'\r')
                    {
                        self.pos += 1;
                    }
                }
                b'\n' | b'\r' if !triple => return false,
                _ => self.pos += 1,
            }
            // An escaped or plain character may be several bytes long.
            while !self.text.is_char_boundary(self.pos) {
                self.pos += 1;
            }
        }
        false
    }

    fn open(&mut self, bracket: Bracket) {
        let at = self.pos as u32;
        if self.stack.len() >= BRACKETS - usize::from(self.bracketed) {
            self.error(
                TextRange::new(at, at + 1),
                format!("brackets are nested more than {BRACKETS} levels deep"),
                "too many nested parentheses",
            );
            self.pos = self.text.len();
            return;
        }
        self.stack.push((bracket, at));
        self.take(Tok::Open(bracket), 1);
    }

    fn close(&mut self, bracket: Bracket) {
        let at = TextRange::new(self.pos as u32, self.pos as u32 + 1);
        let found = bracket.close();
        match self.stack.last().copied() {
            Some((open, _)) if open == bracket => {}
            None => {
                self.error(
                    at,
                    format!("unmatched `{found}`"),
                    &format!("unmatched '{found}'"),
                );
                self.pos += 1;
                return;
            }
            Some((open, open_at)) => {
                self.mismatch(at, found, open.open(), open_at);
                if !self.stack.iter().any(|(b, _)| *b == bracket) {
                    self.pos += 1;
                    return;
                }
            }
        }
        while let Some((open, _)) = self.stack.pop() {
            if open == bracket {
                break;
            }
            self.push(Tok::Close(open), TextRange::empty(at.start));
        }
        self.take(Tok::Close(bracket), 1);
    }

    fn mismatch(&mut self, at: TextRange, found: char, open: char, open_at: u32) {
        let (line, open_line) = (self.report.line(at.start), self.report.line(open_at));
        let place = if line == open_line {
            String::new()
        } else {
            format!(" on line {open_line}")
        };
        let reference = format!(
            "closing parenthesis '{found}' does not match opening parenthesis '{open}'{place}"
        );
        self.error(
            at,
            format!("`{found}` does not close the `{open}` before it"),
            &reference,
        );
    }

    fn operator(&mut self, b: u8) {
        let (kind, len) = operator(b, self.byte(1), self.byte(2));
        self.take(kind, len);
    }

    /// Close what is open and put the end mark.
    fn finish(&mut self, outer_end: usize) {
        let end = TextRange::empty(outer_end as u32);
        if let Some(&(open, at)) = self.stack.last() {
            self.report.unclosed = Some(OpenBracket {
                open: open.open(),
                at,
            });
        }
        while let Some((open, at)) = self.stack.pop() {
            self.push(Tok::Close(open), end);
            let open = open.open();
            self.report.add(
                ErrorStage::Unclosed,
                TextRange::new(at, at + 1),
                format!("unclosed `{open}`"),
                &format!("'{open}' was never closed"),
            );
        }
        self.push(Tok::End, end);
    }
}

/// Whether Python would print the character as it is (near enough for a message).
fn is_printable(c: char) -> bool {
    !c.is_whitespace()
        && !c.is_control()
        && !matches!(c, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}')
        && !matches!(c, '\u{2060}'..='\u{206f}' | '\u{e000}'..='\u{f8ff}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}')
        && (c as u32) < 0xe0000
}
