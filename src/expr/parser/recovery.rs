//! Going on behind text that does not belong, with the words CPython has for it.

use super::Parser;
use crate::ast::{Expr, ExprKind};
use crate::token::Tok;

/// A place where a comma is missing.
struct Gap {
    /// Number of the error reported there.
    error: usize,
    /// Whether CPython has found nothing better to say than "invalid syntax" so far.
    plain: bool,
    /// Whether the next item starts with a brace: if that is broken, CPython does not take it for an item.
    brace: bool,
}

impl Parser<'_> {
    /// Read items up to the closing bracket and that bracket; true if there was a comma.
    /// The opening bracket was taken already; `item` must report when it takes nothing.
    pub(super) fn items(&mut self, mut item: impl FnMut(&mut Self)) -> bool {
        let mut comma = false;
        let mut gap: Option<Gap> = None;
        self.level += 1;
        while !self.at_close() {
            let before = self.pos;
            self.operand_start = None;
            item(self);
            let gap_before = gap.take();
            if self.eat(Tok::Comma) {
                comma = true;
            } else if !self.at_close() {
                gap = self.between_items(before, gap_before.as_ref());
            }
            if let Some(gap) = gap_before {
                self.settle(&gap);
            }
        }
        self.level -= 1;
        self.items_end = self.reach;
        if self.kind().is_close() {
            self.bump();
        }
        comma
    }

    /// Neither a comma nor the end.
    fn between_items(&mut self, item_start: usize, before: Option<&Gap>) -> Option<Gap> {
        if !self.kind().starts_operand() {
            let found = self.shown_token();
            self.unexpected(format!("unexpected `{found}`"));
            self.skip();
            return None;
        }
        let start = self.operand_start.unwrap_or(item_start);
        let first = self.token_at(start);
        let word = first.range.slice(self.text);
        let alone = start + 1 == self.pos;
        let reference = if alone && matches!(word, "print" | "exec") {
            print_reference(word)
        } else if self.suggests_comma() {
            "invalid syntax. Perhaps you forgot a comma?".to_owned()
        } else {
            "invalid syntax".to_owned()
        };
        let plain = reference == "invalid syntax";
        if let Some(before) = before.filter(|before| before.plain && !plain) {
            self.reword(before.error, first.range.start, &reference);
        }
        let (error, brace) = (
            self.report.len(),
            self.at(Tok::Open(crate::token::Bracket::Curly)),
        );
        let from = if plain {
            self.start()
        } else {
            first.range.start
        };
        self.error_from(
            from,
            self.gap(),
            "expected a comma or an operator",
            &reference,
        );
        let followed = !plain || (alone && self.operand_start.is_some());
        (followed && self.report.len() > error).then_some(Gap {
            error,
            plain,
            brace,
        })
    }

    /// The item behind a gap was read: CPython may have run into the end of the text, or may not have
    /// recognized it.
    fn settle(&mut self, gap: &Gap) {
        if gap.brace && self.report.len() > gap.error + 1 {
            self.report
                .reword(gap.error, "invalid syntax", self.report.line(self.prev_end));
        }
        self.reword_unclosed(gap.error);
    }

    /// If all went well from error `index` up to the end of the text, CPython sees the open bracket there.
    pub(super) fn reword_unclosed(&mut self, index: usize) {
        if self.at_unclosed_end()
            && self.report.plain_since(index + 1).is_none()
            && let Some((unclosed, line)) = self.report.never_closed()
        {
            self.report.reword(index, &unclosed, line);
        }
    }

    /// Whether CPython thinks of a comma between the operand just read and the one that follows.
    pub(super) fn suggests_comma(&self) -> bool {
        let Some(start) = self.operand_start else {
            return false;
        };
        let (first, second) = (self.token_at(start), self.token_at(start + 1));
        let word = first.range.slice(self.text);
        // For words such as `match` it does not; and it compares as many characters as the word has.
        let soft = ["_", "case", "match"]
            .iter()
            .any(|soft| soft.starts_with(word));
        let name_string = first.kind == Tok::Name && second.kind == Tok::Str;
        !soft && !name_string && self.operand_follows()
    }

    /// Whether an operand comes next, as far as its first two tokens tell.
    fn operand_follows(&self) -> bool {
        match self.kind() {
            Tok::Tilde | Tok::Not => {
                let next = self.next_kind();
                next.starts_operand()
                    || matches!(next, Tok::Open(_) | Tok::Minus | Tok::Plus)
                    || self.is_unclosed_end(self.pos + 1)
            }
            Tok::Lambda => !matches!(self.next_kind(), Tok::Comma | Tok::Close(_)),
            kind => kind.starts_operand(),
        }
    }

    /// Text behind a complete expression: keep its pieces as a tuple, for completion and hovering.
    /// CPython looks at more than one token of it only if it starts on the `same_line`.
    pub(super) fn leftovers(&mut self, start: u32, first: Expr, same_line: bool) -> Expr {
        let error = self.report.len();
        let mut open = self.report_leftover(&first) && same_line;
        let mut names = matches!(first.kind, ExprKind::Name(_));
        let mut items = vec![first];
        while !self.at(Tok::End) {
            if !self.starts_expression() {
                self.skip();
                continue;
            }
            let expr = self.expression();
            if open && self.at(Tok::End) {
                self.reword_unclosed(error);
            }
            // It tries whether a word is followed by an expression, over and over as long as it is.
            open &= names;
            names &= matches!(expr.kind, ExprKind::Name(_));
            items.push(expr);
        }
        Expr {
            kind: ExprKind::Tuple(items),
            range: self.range_from(start),
        }
    }

    /// Report the first token behind `first`; true if CPython reads on there.
    fn report_leftover(&mut self, first: &Expr) -> bool {
        if let Some(name) = self.old_print(first) {
            self.error(
                first.range,
                format!("missing parentheses in call of `{name}`"),
                &print_reference(name),
            );
            return false;
        }
        let found = self.shown_token();
        let message = match self.kind() {
            Tok::Equal => "assignment with `=` is not allowed; use `==` to compare".to_owned(),
            Tok::Indent => "unexpected line after the expression".to_owned(),
            _ => format!("unexpected `{found}`; an operator may be missing"),
        };
        self.unexpected(message);
        self.starts_expression()
    }

    fn starts_expression(&self) -> bool {
        self.kind().starts_operand() || matches!(self.kind(), Tok::Open(_))
    }

    /// The name, if `expr` is a `print` that misses its parentheses.
    fn old_print(&self, expr: &Expr) -> Option<&'static str> {
        let ExprKind::Name(name) = &expr.kind else {
            return None;
        };
        let name = ["print", "exec"].into_iter().find(|n| name == n)?;
        (self.kind().starts_operand() || self.at(Tok::Star)).then_some(name)
    }
}

/// Whether something was there for the leftmost operand.
pub(super) fn starts_well(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Missing | ExprKind::Lambda(_) => false,
        ExprKind::Binary(_, first, _) | ExprKind::Compare(first, _) => starts_well(first),
        ExprKind::And(items) | ExprKind::Or(items) => items.first().is_some_and(starts_well),
        ExprKind::Unary(_, value) => starts_well(value),
        _ => true,
    }
}

/// Whether the rightmost operand is missing.
pub(super) fn ends_with_hole(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Missing => true,
        ExprKind::Binary(_, _, last) | ExprKind::Unary(_, last) => ends_with_hole(last),
        ExprKind::Compare(_, rest) => rest.last().is_some_and(|(_, last)| ends_with_hole(last)),
        ExprKind::And(items) | ExprKind::Or(items) => items.last().is_some_and(ends_with_hole),
        _ => false,
    }
}

fn print_reference(name: &str) -> String {
    format!("Missing parentheses in call to '{name}'. Did you mean {name}(...)?")
}
