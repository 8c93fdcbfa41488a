//! String and bytes literals.

use std::borrow::Cow;

use ecow::EcoString;

use super::Parser;
use crate::ast::{Const, Expr, ExprKind, FPart};
use crate::escape;
use crate::report::ErrorStage;
use crate::token::Tok;
use base::TextRange;

/// A string token taken apart.
#[derive(Clone, Copy)]
pub(super) struct Literal {
    pub(super) raw: bool,
    bytes: bool,
    formatted: bool,
    /// What stands between the quotes.
    pub(super) body: TextRange,
}

impl Literal {
    fn new(text: &str, range: TextRange, closed: bool) -> Self {
        let token = range.slice(text);
        let prefix_len = token.find(['"', '\'']).unwrap_or(0);
        let (prefix, quoted) = token.split_at(prefix_len);
        let triple = quoted.starts_with("'''") || quoted.starts_with("\"\"\"");
        let quotes = if triple { 3 } else { 1 };
        let start = range.start + prefix_len as u32 + quotes;
        let end = if closed {
            range.end.saturating_sub(quotes)
        } else {
            range.end
        };
        Self {
            raw: prefix.contains(['r', 'R']),
            bytes: prefix.contains(['b', 'B']),
            formatted: prefix.contains(['f', 'F']),
            body: TextRange::new(start, end),
        }
    }
}

/// The value of adjacent literals, as far as it has been put together.
#[derive(Default)]
struct JoinedLiterals {
    text: String,
    bytes: Option<Vec<u8>>,
    /// Present as soon as one of the literals is an f-string; `text` is what follows the last part.
    parts: Option<Vec<FPart>>,
}

impl Parser<'_> {
    /// One or more adjacent literals.
    pub(super) fn strings(&mut self) -> Expr {
        let start = self.start();
        let mut joined = JoinedLiterals::default();
        let mut kinds = (false, false);
        while matches!(self.kind(), Tok::Str | Tok::OpenStr) {
            let token = self.bump();
            let literal = Literal::new(self.text, token.range, token.kind == Tok::Str);
            let seen = if literal.bytes {
                &mut kinds.0
            } else {
                &mut kinds.1
            };
            *seen = true;
            self.literal(&literal, token.range, &mut joined);
        }
        let range = self.range_from(start);
        if kinds == (true, true) {
            let message = "cannot join strings and bytes";
            self.report.add(
                ErrorStage::Grammar,
                range,
                message,
                "cannot mix bytes and nonbytes literals",
            );
        }
        Expr {
            kind: joined.finish(),
            range,
        }
    }

    fn literal(&mut self, literal: &Literal, token: TextRange, joined: &mut JoinedLiterals) {
        if literal.bytes {
            let bytes = self.bytes(literal, token);
            joined.bytes.get_or_insert_default().extend(bytes);
        } else if literal.formatted {
            let mut parts = Vec::new();
            self.format_string(literal, token, &mut parts);
            let all = joined.parts.get_or_insert_default();
            push_text(all, &std::mem::take(&mut joined.text));
            for part in parts {
                match part {
                    FPart::Text(text) => push_text(all, &text),
                    field => all.push(field),
                }
            }
        } else {
            let text = self.decoded(literal.body, literal.raw, token);
            joined.text.push_str(&text);
        }
    }

    /// The text that a piece of a literal stands for.
    pub(super) fn decoded(&mut self, body: TextRange, raw: bool, token: TextRange) -> String {
        let source = unify_line_ends(body.slice(self.text));
        if raw || !source.contains('\\') {
            return source.into_owned();
        }
        let decoded = escape::decode_str(&source);
        if let Some(error) = decoded.error {
            self.report
                .add(ErrorStage::Grammar, token, error.message, &error.reference);
        } else if let Some(message) = decoded.not_supported {
            self.report
                .not_supported(ErrorStage::Ours, token, message, message);
        }
        decoded.text
    }

    fn bytes(&mut self, literal: &Literal, token: TextRange) -> Vec<u8> {
        let source = unify_line_ends(literal.body.slice(self.text));
        if !source.is_ascii() {
            let reference = "bytes can only contain ASCII literal characters";
            self.report.add(
                ErrorStage::Grammar,
                token,
                "only ASCII characters are allowed in bytes",
                reference,
            );
            return Vec::new();
        }
        if literal.raw || !source.contains('\\') {
            return source.as_bytes().to_vec();
        }
        let (bytes, error) = escape::decode_bytes(&source);
        if let Some(error) = error {
            self.report
                .add(ErrorStage::Grammar, token, error.message, &error.reference);
        }
        bytes
    }
}

impl JoinedLiterals {
    fn finish(self) -> ExprKind {
        match (self.parts, self.bytes) {
            (Some(mut parts), _) => {
                push_text(&mut parts, &self.text);
                ExprKind::FString(parts)
            }
            (None, Some(bytes)) if self.text.is_empty() => ExprKind::Const(Const::Bytes(bytes)),
            _ => ExprKind::Const(Const::Str(EcoString::from(self.text))),
        }
    }
}

/// Python reads every line end as a line feed.
fn unify_line_ends(text: &str) -> Cow<'_, str> {
    if text.contains('\r') {
        Cow::Owned(text.replace("\r\n", "\n").replace('\r', "\n"))
    } else {
        Cow::Borrowed(text)
    }
}

/// Append text to the parts of an f-string; neighbors become one.
pub(super) fn push_text(parts: &mut Vec<FPart>, text: &str) {
    if text.is_empty() {
        return;
    }
    match parts.last_mut() {
        Some(FPart::Text(last)) => last.push_str(text),
        _ => parts.push(FPart::Text(text.into())),
    }
}
