//! From characters to tokens.
//!
//! A key is recognized only at its `:`; until then it is a *candidate*, and the tokens from it on are
//! held back. At most one candidate per flow level, on one line, at most 1024 characters back.

use std::collections::VecDeque;

use super::error::{RawError, repr};
use super::reader::{END, Mark, YamlReader, is_blank_or_end, is_break_or_end};
use super::token::{YamlToken, YamlTokenKind};
use base::TextRange;

/// How far a key may lie before its `:`, in characters.
const KEY_REACH: u32 = 1024;

/// A place where a key may have begun.
struct KeyCandidate {
    flow_level: i32,
    /// The number of its first token, counted from the first of the text.
    token: usize,
    /// Whether only a key can stand there.
    required: bool,
    mark: Mark,
}

impl KeyCandidate {
    /// Whether a colon at `here` comes too late for it.
    fn is_stale(&self, here: Mark) -> bool {
        self.mark.line != here.line || here.index - self.mark.index > KEY_REACH
    }
}

/// A source of tokens.
pub(super) struct Scanner<'t> {
    /// The text.
    pub(super) reader: YamlReader<'t>,
    tokens: VecDeque<YamlToken>,
    taken: usize,
    done: bool,
    /// Open brackets; below zero when too many were closed.
    flow_level: i32,
    /// Column of the current block collection, -1 outside of all.
    indent: i64,
    outer_indents: Vec<i64>,
    /// Whether a key may begin here.
    pub(super) key_allowed: bool,
    /// At most one per flow level.
    candidates: Vec<KeyCandidate>,
}

impl<'t> Scanner<'t> {
    /// The tokens of `text`.
    ///
    /// # Errors
    /// When the text holds a character no YAML may hold.
    pub(super) fn new(text: &'t str) -> Result<Self, RawError> {
        Ok(Self {
            reader: YamlReader::new(text)?,
            tokens: VecDeque::new(),
            taken: 0,
            done: false,
            flow_level: 0,
            indent: -1,
            outer_indents: Vec::new(),
            key_allowed: true,
            candidates: Vec::new(),
        })
    }

    /// The next token, left in place.
    pub(super) fn peek(&mut self) -> Result<&YamlToken, RawError> {
        while self.needs_more()? {
            self.fetch()?;
        }
        let here = self.reader.mark();
        if self.tokens.is_empty() {
            self.push(YamlTokenKind::StreamEnd, here);
        }
        self.tokens
            .front()
            .ok_or_else(|| RawError::new("found unexpected end of stream", here))
    }

    /// The next token.
    pub(super) fn next(&mut self) -> Result<YamlToken, RawError> {
        self.peek()?;
        self.taken += 1;
        let here = self.reader.mark();
        let end = YamlToken {
            kind: YamlTokenKind::StreamEnd,
            start: here,
            end: here,
        };
        Ok(self.tokens.pop_front().unwrap_or(end))
    }

    /// Whether brackets are open.
    pub(super) fn in_flow(&self) -> bool {
        self.flow_level != 0
    }

    /// The column plain and block text must be beyond.
    pub(super) fn indent(&self) -> i64 {
        self.indent
    }

    fn column(&self) -> i64 {
        i64::from(self.reader.mark().column)
    }

    fn needs_more(&mut self) -> Result<bool, RawError> {
        if self.done {
            return Ok(false);
        }
        if self.tokens.is_empty() {
            return Ok(true);
        }
        if self.candidates.is_empty() {
            return Ok(false);
        }
        self.drop_stale_candidates()?;
        Ok(self
            .candidates
            .iter()
            .map(|candidate| candidate.token)
            .min()
            == Some(self.taken))
    }

    fn push(&mut self, kind: YamlTokenKind, start: Mark) {
        self.tokens.push_back(YamlToken {
            kind,
            start,
            end: self.reader.mark(),
        });
    }

    /// Scan the next token, and the ends of blocks before it.
    fn fetch(&mut self) -> Result<(), RawError> {
        self.skip_to_token();
        self.drop_stale_candidates()?;
        self.close_blocks(self.column());
        let (c, next) = (self.reader.peek(), self.reader.peek_at(1));
        let at_line_start = self.reader.mark().column == 0;
        match c {
            END => self.fetch_end(),
            '%' if at_line_start => self.fetch_directive(),
            '-' | '.' if at_line_start && self.reader.at_document_marker() => self.fetch_marker(c),
            '[' => self.fetch_open(YamlTokenKind::FlowSequenceStart),
            '{' => self.fetch_open(YamlTokenKind::FlowMappingStart),
            ']' => self.fetch_close(YamlTokenKind::FlowSequenceEnd),
            '}' => self.fetch_close(YamlTokenKind::FlowMappingEnd),
            ',' => self.fetch_comma(),
            '-' if is_blank_or_end(next) => self.fetch_dash(),
            '?' if self.in_flow() || is_blank_or_end(next) => self.fetch_question_mark(),
            ':' if self.in_flow() || is_blank_or_end(next) => self.fetch_colon(),
            '*' | '&' => self.fetch_word(Self::scan_anchor),
            '!' => self.fetch_word(Self::scan_tag),
            '|' | '>' if !self.in_flow() => {
                self.key_allowed = true;
                self.drop_candidate()?;
                let token = self.scan_block_scalar()?;
                self.tokens.push_back(token);
                Ok(())
            }
            '\'' | '"' => self.fetch_word(Self::scan_quoted),
            _ if self.starts_plain(c, next) => self.fetch_word(Self::scan_plain),
            _ => {
                let problem = format!(
                    "found character {} that cannot start any token",
                    repr(&c.to_string())
                );
                Err(RawError::during(
                    "while scanning for the next token",
                    problem,
                    self.reader.mark(),
                ))
            }
        }
    }

    fn starts_plain(&self, c: char, next: char) -> bool {
        let special = is_blank_or_end(c) || "-?:,[]{}#&*!|>'\"%@`".contains(c);
        let rescued = c == '-' || !self.in_flow() && matches!(c, '?' | ':');
        !special || rescued && !is_blank_or_end(next)
    }

    fn skip_to_token(&mut self) {
        if self.reader.mark().index == 0 && self.reader.peek() == '\u{FEFF}' {
            self.reader.advance();
        }
        loop {
            self.skip_blanks_and_comment();
            if self.reader.take_break().is_none() {
                return;
            }
            if !self.in_flow() {
                self.key_allowed = true;
            }
        }
    }

    /// Move to the end of the line if only a comment stands there.
    pub(super) fn skip_blanks_and_comment(&mut self) {
        self.reader.take_while(|c| c == ' ');
        if self.reader.peek() == '#' {
            self.reader.take_while(|c| !is_break_or_end(c));
        }
    }

    // Candidates.

    fn missing_colon(&self, candidate: &KeyCandidate) -> RawError {
        let (start, end) = (candidate.mark, self.reader.mark());
        let reach = if start.line == end.line {
            end.offset
        } else {
            self.reader.line_end(start)
        };
        RawError::within(
            "while scanning a simple key",
            start,
            "could not find expected ':'",
            end,
        )
        .blaming(TextRange::new(start.offset, reach))
    }

    fn drop_stale_candidates(&mut self) -> Result<(), RawError> {
        let here = self.reader.mark();
        let lost = self
            .candidates
            .iter()
            .find(|candidate| candidate.required && candidate.is_stale(here));
        if let Some(lost) = lost {
            return Err(self.missing_colon(lost));
        }
        self.candidates
            .retain(|candidate| !candidate.is_stale(here));
        Ok(())
    }

    fn take_candidate(&mut self) -> Option<KeyCandidate> {
        let at = self
            .candidates
            .iter()
            .position(|candidate| candidate.flow_level == self.flow_level)?;
        Some(self.candidates.swap_remove(at))
    }

    fn drop_candidate(&mut self) -> Result<(), RawError> {
        match self.take_candidate() {
            Some(candidate) if candidate.required => Err(self.missing_colon(&candidate)),
            _ => Ok(()),
        }
    }

    fn save_candidate(&mut self) -> Result<(), RawError> {
        if self.key_allowed {
            self.drop_candidate()?;
            let required = !self.in_flow() && self.indent == self.column();
            let token = self.taken + self.tokens.len();
            let mark = self.reader.mark();
            self.candidates.push(KeyCandidate {
                flow_level: self.flow_level,
                token,
                required,
                mark,
            });
        }
        Ok(())
    }

    // Indentation.

    fn close_blocks(&mut self, column: i64) {
        while !self.in_flow() && self.indent > column {
            self.indent = self.outer_indents.pop().unwrap_or(-1);
            self.push(YamlTokenKind::BlockEnd, self.reader.mark());
        }
    }

    fn open_block(&mut self, column: i64) -> bool {
        let deeper = self.indent < column;
        if deeper {
            self.outer_indents.push(self.indent);
            self.indent = column;
        }
        deeper
    }

    /// Begin an entry of a block collection that is not a key candidate.
    fn begin_entry(&mut self, kind: YamlTokenKind, problem: &str) -> Result<(), RawError> {
        if !self.in_flow() {
            if !self.key_allowed {
                return Err(RawError::new(problem, self.reader.mark()));
            }
            if self.open_block(self.column()) {
                self.push(kind, self.reader.mark());
            }
        }
        Ok(())
    }

    // Tokens.

    fn fetch_character(&mut self, kind: YamlTokenKind) {
        let start = self.reader.mark();
        self.reader.advance();
        self.push(kind, start);
    }

    fn fetch_end(&mut self) -> Result<(), RawError> {
        self.close_blocks(-1);
        self.drop_candidate()?;
        self.key_allowed = false;
        self.candidates.clear();
        self.push(YamlTokenKind::StreamEnd, self.reader.mark());
        self.done = true;
        Ok(())
    }

    fn fetch_directive(&mut self) -> Result<(), RawError> {
        self.close_blocks(-1);
        self.drop_candidate()?;
        self.key_allowed = false;
        let token = self.scan_directive()?;
        self.tokens.push_back(token);
        Ok(())
    }

    fn fetch_marker(&mut self, c: char) -> Result<(), RawError> {
        self.close_blocks(-1);
        self.drop_candidate()?;
        self.key_allowed = false;
        let start = self.reader.mark();
        for _ in 0..3 {
            self.reader.advance();
        }
        self.push(
            if c == '-' {
                YamlTokenKind::DocumentStart
            } else {
                YamlTokenKind::DocumentEnd
            },
            start,
        );
        Ok(())
    }

    fn fetch_open(&mut self, kind: YamlTokenKind) -> Result<(), RawError> {
        self.save_candidate()?;
        self.flow_level += 1;
        self.key_allowed = true;
        self.fetch_character(kind);
        Ok(())
    }

    fn fetch_close(&mut self, kind: YamlTokenKind) -> Result<(), RawError> {
        self.drop_candidate()?;
        self.flow_level -= 1;
        self.key_allowed = false;
        self.fetch_character(kind);
        Ok(())
    }

    fn fetch_comma(&mut self) -> Result<(), RawError> {
        self.key_allowed = true;
        self.drop_candidate()?;
        self.fetch_character(YamlTokenKind::FlowEntry);
        Ok(())
    }

    fn fetch_dash(&mut self) -> Result<(), RawError> {
        self.begin_entry(
            YamlTokenKind::BlockSequenceStart,
            "sequence entries are not allowed here",
        )?;
        self.key_allowed = true;
        self.drop_candidate()?;
        self.fetch_character(YamlTokenKind::BlockEntry);
        Ok(())
    }

    fn fetch_question_mark(&mut self) -> Result<(), RawError> {
        self.begin_entry(
            YamlTokenKind::BlockMappingStart,
            "mapping keys are not allowed here",
        )?;
        self.key_allowed = !self.in_flow();
        self.drop_candidate()?;
        self.fetch_character(YamlTokenKind::Key);
        Ok(())
    }

    fn fetch_colon(&mut self) -> Result<(), RawError> {
        if let Some(candidate) = self.take_candidate() {
            let at = candidate
                .token
                .saturating_sub(self.taken)
                .min(self.tokens.len());
            let mark = candidate.mark;
            self.tokens.insert(
                at,
                YamlToken {
                    kind: YamlTokenKind::Key,
                    start: mark,
                    end: mark,
                },
            );
            if !self.in_flow() && self.open_block(i64::from(mark.column)) {
                self.tokens.insert(
                    at,
                    YamlToken {
                        kind: YamlTokenKind::BlockMappingStart,
                        start: mark,
                        end: mark,
                    },
                );
            }
            self.key_allowed = false;
        } else {
            self.begin_entry(
                YamlTokenKind::BlockMappingStart,
                "mapping values are not allowed here",
            )?;
            self.key_allowed = !self.in_flow();
        }
        self.fetch_character(YamlTokenKind::Value);
        Ok(())
    }

    /// A token that may be, or begin, a key.
    fn fetch_word(
        &mut self,
        scan: impl FnOnce(&mut Self) -> Result<YamlToken, RawError>,
    ) -> Result<(), RawError> {
        self.save_candidate()?;
        self.key_allowed = false;
        let token = scan(self)?;
        self.tokens.push_back(token);
        Ok(())
    }
}
