//! What stands between brackets, separated by commas.

use super::Parser;
use crate::ast::{CmpOp, Expr, ExprKind};
use crate::parser::power;
use crate::token::{Bracket, Tok};

impl Parser<'_> {
    /// `star_named_expression`: `*x`, or [`Parser::named`].
    pub(super) fn starred_or_named(&mut self) -> Expr {
        if !self.at(Tok::Star) {
            return self.named();
        }
        let start = self.start();
        let first = self.pos > 0 && matches!(self.token_at(self.pos - 1).kind, Tok::Open(_));
        self.bump();
        let operand = self.pos;
        let value = self.operand(power::BIT_OR);
        self.operand_start = first.then_some(operand);
        self.grow();
        self.node(start, value, ExprKind::Starred)
    }

    /// `named_expression`: an expression, or `name := value`.
    pub(super) fn named(&mut self) -> Expr {
        let start = self.start();
        if self.at(Tok::Name) && self.next_kind() == Tok::Walrus {
            let name = self.bump().range;
            self.bump();
            let value = self.expression();
            self.walrus = true;
            self.grow();
            let text = self.identifier(name);
            return self.node(start, value, |value| ExprKind::NamedExpr {
                name: text,
                name_range: name,
                value,
            });
        }
        let expr = self.expression();
        let start = start.min(expr.range.start);
        match self.kind() {
            Tok::Walrus => self.walrus_to_nothing(start, expr),
            Tok::Equal => self.assignment(start, expr),
            _ => expr,
        }
    }

    /// `a.b := value`
    fn walrus_to_nothing(&mut self, start: u32, target: Expr) -> Expr {
        self.bump();
        let value = self.expression();
        self.grow();
        let what = target.kind_name();
        let message = format!("`:=` must follow a name, not {}", with_article(what));
        self.error(
            target.range,
            message,
            &format!("cannot use assignment expressions with {what}"),
        );
        self.node(start, value, |value| ExprKind::Tuple(vec![target, *value]))
    }

    /// `a = value` where a comparison was meant.
    fn assignment(&mut self, start: u32, target: Expr) -> Expr {
        self.bump();
        let value = self.expression();
        self.grow();
        let again = matches!(self.kind(), Tok::Equal | Tok::Walrus);
        let hole = matches!(value.kind, ExprKind::Missing);
        let reference = match &target.kind {
            _ if again || hole || !target.is_bitwise_or() => "invalid syntax".to_owned(),
            ExprKind::Name(_) => {
                "invalid syntax. Maybe you meant '==' or ':=' instead of '='?".to_owned()
            }
            _ if !target.may_be_blamed() => "invalid syntax".to_owned(),
            _ => {
                format!(
                    "cannot assign to {} here. Maybe you meant '==' instead of '='?",
                    target.kind_name()
                )
            }
        };
        self.error(
            target.range,
            "assignment with `=` is not allowed; use `==` to compare",
            &reference,
        );
        self.node(start, value, |value| {
            ExprKind::Compare(Box::new(target), vec![(CmpOp::Eq, *value)])
        })
    }

    /// `(…)`: a group, a tuple or a generator.
    pub(super) fn parenthesized(&mut self) -> Expr {
        let start = self.bump().range.start;
        self.group(start)
    }

    /// The content of parentheses and the closing one.
    pub(super) fn group(&mut self, start: u32) -> Expr {
        if self.at(Tok::DoubleStar) {
            return self.double_starred(start);
        }
        if self.at(Tok::Yield) {
            return self.yielded(start);
        }
        let (mut items, comma, done) = self.elements(start, Bracket::Round);
        if let Some(comprehension) = done {
            return comprehension;
        }
        let range = self.range_from(start);
        match items.pop() {
            Some(only) if !comma && items.is_empty() => {
                if matches!(only.kind, ExprKind::Starred(_)) {
                    let message = "`*` is only allowed in calls, lists and tuples";
                    self.error(only.range, message, "cannot use starred expression here");
                }
                only
            }
            last => {
                items.extend(last);
                Expr {
                    kind: ExprKind::Tuple(items),
                    range,
                }
            }
        }
    }

    /// `(**x)`
    fn double_starred(&mut self, start: u32) -> Expr {
        let stars = self.bump().range;
        let value = self.expression();
        let alone = self.at_close() && !matches!(value.kind, ExprKind::Missing);
        let reference = if alone {
            "cannot use double starred expression here"
        } else {
            "invalid syntax"
        };
        self.error(stars, "`**` is only allowed in calls and dicts", reference);
        let mut values = vec![value];
        self.eat(Tok::Comma);
        self.items(|p| values.push(p.starred_or_named()));
        Expr {
            kind: ExprKind::Tuple(values),
            range: self.range_from(start),
        }
    }

    /// `[…]` as a display.
    pub(super) fn list(&mut self) -> Expr {
        let start = self.bump().range.start;
        let (items, _, done) = self.elements(start, Bracket::Square);
        done.unwrap_or_else(|| Expr {
            kind: ExprKind::List(items),
            range: self.range_from(start),
        })
    }

    /// The elements of a tuple or list, or the comprehension they turn out to be.
    fn elements(&mut self, start: u32, bracket: Bracket) -> (Vec<Expr>, bool, Option<Expr>) {
        let mut items = Vec::new();
        let mut clauses = None;
        let comma = self.items(|p| {
            if p.at(Tok::Comma) {
                items.push(p.hole("a value"));
                return;
            }
            if !matches!(p.kind(), Tok::For | Tok::Async) {
                items.push(p.starred_or_named());
            }
            if matches!(p.kind(), Tok::For | Tok::Async) {
                p.check_elements(&items, bracket);
                clauses = Some(p.clauses());
                p.operand_start = None;
                if p.at(Tok::Comma) {
                    p.unexpected("a comprehension next to other items must be in parentheses");
                }
            }
        });
        let done = clauses.map(|clauses| {
            self.comprehension_of(start, bracket, std::mem::take(&mut items), clauses)
        });
        (items, comma, done)
    }
}

/// A noun of [`Expr::kind_name`] in a sentence.
fn with_article(noun: &str) -> String {
    match noun.chars().next() {
        Some('a' | 'e' | 'i' | 'o') => format!("an {noun}"),
        _ => format!("a {noun}"),
    }
}
