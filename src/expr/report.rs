//! Collecting errors and deciding which one CPython would name.
//!
//! CPython tries its grammar twice, the second time with rules for common mistakes, so which text it prints
//! depends on how far it backtracks. For single mistakes the texts here are the same; for several at once
//! about one in two hundred differs (measured on mutated expressions). Known: an indented second line in
//! front of an unmatched bracket ("unexpected indent"), mistakes inside of what it tries behind a missing
//! comma, and conditions or operators where the target of a `for` belongs.

use super::syntax::{ExprError, ExprErrorKind};
use base::TextRange;
use base::limits::EXPRESSION_ERRORS;

/// When CPython notices an error; the earliest stage wins, whatever the place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum ErrorStage {
    /// While reading tokens: these win even behind a grammar error.
    Token,
    /// In the grammar, or while decoding a literal.
    Grammar,
    /// A bracket still open at the end.
    Unclosed,
    /// In the finished tree.
    Tree,
    /// Names that xacro refuses.
    Name,
    /// Only we refuse it.
    Ours,
}

/// The innermost bracket that is open at the end of the text.
#[derive(Clone, Copy, Debug)]
pub(super) struct OpenBracket {
    pub(super) open: char,
    pub(super) at: u32,
}

/// The errors of one expression.
pub(super) struct ExprErrors<'t> {
    text: &'t str,
    /// Where the stripped expression starts: its line is line 1.
    start: u32,
    errors: Vec<(ErrorStage, ExprError)>,
    pub(super) unclosed: Option<OpenBracket>,
}

impl<'t> ExprErrors<'t> {
    pub(super) fn new(text: &'t str, start: u32) -> Self {
        Self {
            text,
            start,
            errors: Vec::new(),
            unclosed: None,
        }
    }

    /// Where the stripped expression starts.
    pub(super) fn start(&self) -> u32 {
        self.start
    }

    /// Line of an offset in the stripped expression, from 1.
    pub(super) fn line(&self, at: u32) -> usize {
        let before = TextRange::new(self.start, at).slice(self.text).as_bytes();
        1 + before
            .iter()
            .enumerate()
            .filter(|&(i, &b)| b == b'\n' || (b == b'\r' && before.get(i + 1) != Some(&b'\n')))
            .count()
    }

    /// An error of the given stage; `reference` is CPython's text without the place.
    pub(super) fn add(
        &mut self,
        stage: ErrorStage,
        range: TextRange,
        message: impl Into<String>,
        reference: &str,
    ) {
        if self.is_full() {
            return;
        }
        let line = self.line(range.start);
        self.add_at_line(stage, range, message, reference, line);
    }

    /// The same with CPython's idea of the line.
    pub(super) fn add_at_line(
        &mut self,
        stage: ErrorStage,
        range: TextRange,
        message: impl Into<String>,
        reference: &str,
        line: usize,
    ) {
        let reference = format!("{reference} (<expression>, line {line})");
        self.push(stage, ExprErrorKind::Syntax, range, message, reference);
    }

    /// Something Python allows and we do not.
    pub(super) fn not_supported(
        &mut self,
        stage: ErrorStage,
        range: TextRange,
        message: &str,
        reference: &str,
    ) {
        if self.is_full() {
            return;
        }
        let reference = format!(
            "{reference} (<expression>, line {})",
            self.line(range.start)
        );
        self.push(
            stage,
            ExprErrorKind::NotSupported,
            range,
            message,
            reference,
        );
    }

    pub(super) fn push(
        &mut self,
        stage: ErrorStage,
        kind: ExprErrorKind,
        range: TextRange,
        message: impl Into<String>,
        reference: String,
    ) {
        if !self.is_full() {
            self.errors.push((
                stage,
                ExprError {
                    message: message.into(),
                    reference,
                    range,
                    kind,
                },
            ));
        }
    }

    /// CPython's text for the bracket left open, with its place.
    pub(super) fn never_closed(&self) -> Option<(String, usize)> {
        self.unclosed
            .map(|u| (format!("'{}' was never closed", u.open), self.line(u.at)))
    }

    /// How many errors there are.
    pub(super) fn len(&self) -> usize {
        self.errors.len()
    }

    /// The first of the errors from `mark` on for which CPython has no better text than "invalid syntax".
    pub(super) fn plain_since(&self, mark: usize) -> Option<usize> {
        let plain = |(stage, error): &(ErrorStage, ExprError)| {
            *stage == ErrorStage::Grammar && error.reference.starts_with("invalid syntax (")
        };
        self.errors
            .iter()
            .skip(mark)
            .position(plain)
            .map(|i| mark + i)
    }

    /// Change what CPython says to an error that was reported before.
    pub(super) fn reword(&mut self, index: usize, reference: &str, line: usize) {
        if let Some((_, error)) = self.errors.get_mut(index) {
            error.reference = format!("{reference} (<expression>, line {line})");
        }
    }

    /// Whether further errors would be dropped.
    pub(super) fn is_full(&self) -> bool {
        self.errors.len() >= EXPRESSION_ERRORS
    }

    /// Take over the errors of a replacement field, worded as CPython does for these.
    pub(super) fn absorb(&mut self, inner: ExprErrors<'_>, prefix: &str) {
        for (stage, mut error) in inner.errors {
            if stage == ErrorStage::Grammar {
                error.reference.insert_str(0, prefix);
            }
            self.errors.push((stage.max(ErrorStage::Grammar), error));
        }
    }

    /// All errors, the one CPython stops at first.
    pub(super) fn finish(mut self) -> Vec<ExprError> {
        self.errors.sort_by_key(|(stage, _)| *stage);
        self.errors.into_iter().map(|(_, error)| error).collect()
    }
}
