//! Moving over the tokens, and reporting what is wrong with them.

use ecow::EcoString;

use super::Parser;
use crate::ast::{Expr, ExprKind};
use crate::report::{ErrorStage, ExprErrors};
use crate::syntax::normalized;
use crate::token::{Tok, Token};
use base::TextRange;

const END: Token = Token {
    kind: Tok::End,
    range: TextRange { start: 0, end: 0 },
};

impl<'t> Parser<'t> {
    pub(super) fn new(
        text: &'t str,
        tokens: Vec<Token>,
        report: ExprErrors<'t>,
        start: u32,
    ) -> Self {
        Self {
            text,
            tokens,
            pos: 0,
            prev_end: start,
            reach: start,
            report,
            depth: 0,
            height: 0,
            too_deep: false,
            operand_start: None,
            level: 0,
            items_end: 0,
            walrus: false,
        }
    }

    /// The name at `range`, as Python compares it.
    pub(super) fn identifier(&self, range: TextRange) -> EcoString {
        normalized(range.slice(self.text)).into()
    }

    pub(super) fn token_at(&self, index: usize) -> Token {
        self.tokens
            .get(index)
            .or(self.tokens.last())
            .copied()
            .unwrap_or(END)
    }

    pub(super) fn token(&self) -> Token {
        self.token_at(self.pos)
    }

    pub(super) fn kind(&self) -> Tok {
        self.token().kind
    }

    pub(super) fn next_kind(&self) -> Tok {
        self.token_at(self.pos + 1).kind
    }

    pub(super) fn at(&self, kind: Tok) -> bool {
        self.kind() == kind
    }

    /// Whether the innermost bracket, or the text, ends here.
    pub(super) fn at_close(&self) -> bool {
        let kind = self.kind();
        kind.is_close() || kind == Tok::End
    }

    pub(super) fn bump(&mut self) -> Token {
        let token = self.token();
        if token.kind != Tok::End {
            self.pos += 1;
            self.prev_end = token.range.end;
            self.reach = token.range.end;
        }
        token
    }

    pub(super) fn eat(&mut self, kind: Tok) -> bool {
        let found = self.at(kind);
        if found {
            self.bump();
        }
        found
    }

    pub(super) fn start(&self) -> u32 {
        self.token().range.start
    }

    pub(super) fn range_from(&self, start: u32) -> TextRange {
        TextRange::new(start, self.reach)
    }

    /// The blank space before the next token: where a cursor stands that is about to fill a hole.
    pub(super) fn gap(&self) -> TextRange {
        TextRange::new(self.prev_end, self.start())
    }

    pub(super) fn missing(&mut self) -> Expr {
        let range = self.gap();
        self.reach = range.end;
        Expr {
            kind: ExprKind::Missing,
            range,
        }
    }

    /// Skip one token, or a bracket with all it holds.
    pub(super) fn skip(&mut self) {
        let mut open = 0usize;
        loop {
            match self.bump().kind {
                Tok::Open(_) => open += 1,
                Tok::Close(_) => open = open.saturating_sub(1),
                Tok::End => return,
                _ => {}
            }
            if open == 0 {
                return;
            }
        }
    }

    /// Whether the text ended inside a bracket and the parser has got there.
    pub(super) fn at_unclosed_end(&self) -> bool {
        self.is_unclosed_end(self.pos)
    }

    /// The same for another token than the current one.
    pub(super) fn is_unclosed_end(&self, index: usize) -> bool {
        let start = self.token_at(index).range.start;
        self.report.unclosed.is_some()
            && self
                .tokens
                .last()
                .is_some_and(|end| start == end.range.start)
    }

    /// Offset on the line on which CPython sees the current token.
    fn place(&self) -> u32 {
        let range = self.token().range;
        if range.is_empty() {
            self.prev_end
        } else {
            range.start
        }
    }
}

impl Parser<'_> {
    /// A grammar error at `range`, on the line on which `range` starts.
    pub(super) fn error(&mut self, range: TextRange, message: impl Into<String>, reference: &str) {
        self.error_from(range.start, range, message, reference);
    }

    /// A grammar error that CPython places at `from`; an open bracket takes precedence as it does there.
    pub(super) fn error_from(
        &mut self,
        from: u32,
        range: TextRange,
        message: impl Into<String>,
        reference: &str,
    ) {
        if self.too_deep || self.report.is_full() {
            return;
        }
        if let Some((unclosed, open_line)) = self.report.never_closed()
            && (self.at_unclosed_end() || self.report.line(self.place()) > open_line)
        {
            self.report
                .add_at_line(ErrorStage::Grammar, range, message, &unclosed, open_line);
            return;
        }
        self.report.add_at_line(
            ErrorStage::Grammar,
            range,
            message,
            reference,
            self.report.line(from),
        );
    }

    /// The text of the current token for a message; of a string over several lines, the first one.
    pub(super) fn shown_token(&self) -> String {
        let text = self.token().range.slice(self.text).trim();
        match text.split_once(['\n', '\r']) {
            Some((first, _)) => format!("{first}…"),
            None => text.to_owned(),
        }
    }

    /// The next token is wrong.
    pub(super) fn unexpected(&mut self, message: impl Into<String>) {
        let token = self.token();
        let range = if token.range.is_empty() {
            self.gap()
        } else {
            token.range
        };
        let reference = if token.kind == Tok::Indent {
            "unexpected indent"
        } else {
            "invalid syntax"
        };
        self.error_from(self.place(), range, message, reference);
    }

    /// What was reported at `index` has a better text in CPython, provided that all brackets are closed.
    pub(super) fn reword(&mut self, index: usize, from: u32, reference: &str) {
        let unclosed = self
            .report
            .never_closed()
            .filter(|_| self.at_unclosed_end());
        match unclosed {
            Some((unclosed, line)) => self.report.reword(index, &unclosed, line),
            None => self.report.reword(index, reference, self.report.line(from)),
        }
    }

    /// An operand is missing before the next token.
    pub(super) fn hole(&mut self, what: &str) -> Expr {
        let found = self.token();
        let message = if found.range.is_empty() || found.kind.is_close() {
            format!("expected {what}")
        } else {
            format!(
                "expected {what} before `{}`",
                found.range.slice(self.text).replace('\n', "\\n")
            )
        };
        self.unexpected(message);
        self.missing()
    }
}
