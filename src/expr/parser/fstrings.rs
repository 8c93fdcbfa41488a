//! f-strings, by the rules of CPython 3.11: the literal is found first, its fields afterwards.

use super::Parser;
use super::strings::{Literal, push_text};
use crate::ast::{Expr, ExprKind, FPart};
use crate::lexer::{LexerInput, lex};
use crate::report::{ErrorStage, ExprErrors};
use crate::syntax::is_python_space;
use base::TextRange;
use base::limits::BRACKETS;

/// A place in the body of an f-string.
struct FStringScanner<'t> {
    text: &'t str,
    pos: usize,
    end: usize,
    raw: bool,
    token: TextRange,
}

impl FStringScanner<'_> {
    fn byte(&self, ahead: usize) -> Option<u8> {
        let at = self.pos + ahead;
        if at < self.end {
            self.text.as_bytes().get(at).copied()
        } else {
            None
        }
    }

    fn at_tripled(&self, quote: u8) -> bool {
        (0..3).all(|i| self.byte(i) == Some(quote))
    }
}

/// What is wrong with an f-string: our words and CPython's.
type FStringProblem = (String, String);

fn problem(message: &str, reference: &str) -> FStringProblem {
    (message.to_owned(), reference.to_owned())
}

fn no_brace() -> FStringProblem {
    problem("missing `}` in this f-string", "f-string: expecting '}'")
}

impl Parser<'_> {
    /// Add the parts of an f-string.
    pub(super) fn format_string(
        &mut self,
        literal: &Literal,
        token: TextRange,
        parts: &mut Vec<FPart>,
    ) {
        let Literal { raw, body, .. } = *literal;
        let mut scan = FStringScanner {
            text: self.text,
            pos: body.start as usize,
            end: body.end as usize,
            raw,
            token,
        };
        if let Err((message, reference)) = self.format_parts(&mut scan, 0, parts) {
            self.report
                .add(ErrorStage::Grammar, token, message, &reference);
        }
    }

    /// Text and fields up to the end, or up to the `}` that closes a format specification.
    fn format_parts(
        &mut self,
        scan: &mut FStringScanner<'_>,
        level: u8,
        parts: &mut Vec<FPart>,
    ) -> Result<(), FStringProblem> {
        loop {
            self.format_text(scan, level, parts)?;
            match scan.byte(0) {
                Some(b'{') => {
                    let field = self.field(scan, level)?;
                    parts.push(field);
                }
                _ => return Ok(()),
            }
        }
    }

    /// Text up to the next brace that is not doubled.
    fn format_text(
        &mut self,
        scan: &mut FStringScanner<'_>,
        level: u8,
        parts: &mut Vec<FPart>,
    ) -> Result<(), FStringProblem> {
        let mut start = scan.pos;
        while let Some(b) = scan.byte(0) {
            match b {
                b'{' | b'}' if level == 0 && scan.byte(1) == Some(b) => {
                    let range = TextRange::new(start as u32, scan.pos as u32 + 1);
                    push_text(parts, &self.decoded(range, scan.raw, scan.token));
                    scan.pos += 2;
                    start = scan.pos;
                }
                b'}' if level == 0 => {
                    let reference = "f-string: single '}' is not allowed";
                    return Err(problem("single `}` in an f-string; write `}}`", reference));
                }
                b'{' | b'}' => break,
                b'\\' if !scan.raw && scan.byte(1) == Some(b'N') && scan.byte(2) == Some(b'{') => {
                    while scan.byte(0).is_some_and(|b| b != b'}') {
                        scan.pos += 1;
                    }
                    scan.pos = (scan.pos + 1).min(scan.end);
                }
                b'\\' if !scan.raw && !matches!(scan.byte(1), None | Some(b'{' | b'}')) => {
                    scan.pos += 2
                }
                _ => scan.pos += 1,
            }
        }
        let range = TextRange::new(start as u32, scan.pos as u32);
        push_text(parts, &self.decoded(range, scan.raw, scan.token));
        Ok(())
    }

    /// `{value=!conversion:spec}`; `scan` is at the brace.
    fn field(&mut self, scan: &mut FStringScanner<'_>, level: u8) -> Result<FPart, FStringProblem> {
        if level >= 2 {
            let reference = "f-string: expressions nested too deeply";
            return Err(problem("f-string fields are nested too deeply", reference));
        }
        scan.pos += 1;
        let start = scan.pos;
        find_value_end(scan)?;
        let value = Box::new(self.field_value(start, scan.pos, scan.byte(0))?);
        let mut debug = None;
        if scan.byte(0) == Some(b'=') {
            scan.pos += 1;
            while scan.byte(0).is_some_and(|b| b.is_ascii_whitespace()) {
                scan.pos += 1;
            }
            debug = Some(
                TextRange::new(start as u32, scan.pos as u32)
                    .slice(self.text)
                    .into(),
            );
        }
        let mut conversion = conversion(scan)?;
        let mut spec = Vec::new();
        let has_spec = scan.byte(0) == Some(b':');
        if has_spec {
            scan.pos += 1;
            self.format_parts(scan, level + 1, &mut spec)?;
        }
        if scan.byte(0) != Some(b'}') {
            return Err(no_brace());
        }
        scan.pos += 1;
        if debug.is_some() && !has_spec && conversion.is_none() {
            conversion = Some('r');
        }
        Ok(FPart::Field {
            value,
            conversion,
            spec,
            debug,
        })
    }

    /// The expression of a field: what could stand in parentheses.
    fn field_value(
        &mut self,
        start: usize,
        end: usize,
        behind: Option<u8>,
    ) -> Result<Expr, FStringProblem> {
        let range = TextRange::new(start as u32, end as u32);
        if range
            .slice(self.text)
            .trim_matches(is_python_space)
            .is_empty()
        {
            let reference = match behind {
                Some(b @ (b'!' | b':' | b'=')) => {
                    format!("f-string: expression required before '{}'", char::from(b))
                }
                _ => "f-string: empty expression not allowed".to_owned(),
            };
            return Err(("expected a value between the braces".to_owned(), reference));
        }
        let mut report = ExprErrors::new(self.text, self.report.start());
        let source = LexerInput {
            text: self.text,
            start,
            end,
            outer_end: end,
            bracketed: true,
        };
        let tokens = lex(&source, &mut report);
        let mut inner = Parser::new(self.text, tokens, report, start as u32);
        inner.depth = self.depth;
        let value = inner.nested(|p| {
            let value = p.group(start as u32);
            match value.kind {
                ExprKind::Missing => Expr {
                    kind: ExprKind::Missing,
                    range,
                },
                _ => value,
            }
        });
        self.height = self.height.max(inner.height);
        self.grow();
        self.report.absorb(inner.report, "f-string: ");
        Ok(value)
    }
}

/// Move to the character that ends the expression of a field.
fn find_value_end(scan: &mut FStringScanner<'_>) -> Result<(), FStringProblem> {
    let mut quote: Option<(u8, bool)> = None;
    let mut open: Vec<u8> = Vec::new();
    while let Some(b) = scan.byte(0) {
        if b == b'\\' {
            let reference = "f-string expression part cannot include a backslash";
            return Err(problem(
                "a backslash is not allowed between the braces",
                reference,
            ));
        }
        match (quote, b) {
            (Some((q, triple)), _) if b == q && (!triple || scan.at_tripled(q)) => {
                scan.pos += if triple { 2 } else { 0 };
                quote = None;
            }
            (Some(_), _) => {}
            (None, b'\'' | b'"') => {
                let triple = scan.at_tripled(b);
                scan.pos += if triple { 2 } else { 0 };
                quote = Some((b, triple));
            }
            (None, b'(' | b'[' | b'{') => {
                if open.len() >= BRACKETS {
                    let reference = "f-string: too many nested parenthesis";
                    return Err(problem("brackets are nested too deeply", reference));
                }
                open.push(b);
            }
            (None, b'#') => {
                let reference = "f-string expression part cannot include '#'";
                return Err(problem("`#` is not allowed between the braces", reference));
            }
            (None, b'!' | b'=' | b'<' | b'>') if open.is_empty() && scan.byte(1) == Some(b'=') => {
                scan.pos += 1
            }
            (None, b'!' | b':' | b'}' | b'=') if open.is_empty() => break,
            (None, b')' | b']' | b'}') => close(&mut open, b)?,
            _ => {}
        }
        scan.pos += 1;
    }
    match (quote, open.last()) {
        (Some(_), _) => Err(problem(
            "unclosed string between the braces",
            "f-string: unterminated string",
        )),
        (None, Some(&b)) => Err(problem(
            "unclosed bracket",
            &format!("f-string: unmatched '{}'", char::from(b)),
        )),
        (None, None) if scan.pos >= scan.end => Err(no_brace()),
        _ => Ok(()),
    }
}

fn close(open: &mut Vec<u8>, closer: u8) -> Result<(), FStringProblem> {
    let found = char::from(closer);
    let opener = match closer {
        b')' => b'(',
        b']' => b'[',
        _ => b'{',
    };
    match open.pop() {
        Some(top) if top == opener => Ok(()),
        Some(top) => {
            let top = char::from(top);
            let reference = format!(
                "f-string: closing parenthesis '{found}' does not match opening parenthesis '{top}'"
            );
            Err((
                format!("`{found}` does not match the opening `{top}`"),
                reference,
            ))
        }
        None => Err((
            format!("unmatched `{found}`"),
            format!("f-string: unmatched '{found}'"),
        )),
    }
}

/// `!r`, `!s` or `!a`.
fn conversion(scan: &mut FStringScanner<'_>) -> Result<Option<char>, FStringProblem> {
    if scan.byte(0) != Some(b'!') {
        return Ok(None);
    }
    scan.pos += 1;
    let Some(b) = scan.byte(0) else {
        return Err(no_brace());
    };
    scan.pos += 1;
    match b {
        b'r' | b's' | b'a' => Ok(Some(char::from(b))),
        _ => {
            let reference = "f-string: invalid conversion character: expected 's', 'r', or 'a'";
            Err(problem(
                "unknown conversion; only `!r`, `!s` and `!a` are allowed",
                reference,
            ))
        }
    }
}
