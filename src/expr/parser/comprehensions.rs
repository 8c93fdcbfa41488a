//! `for … in … if …` behind an element.

use std::sync::Arc;

use super::{Parser, power};
use crate::ast::{CompFor, CompKind, Comprehension, Expr, ExprKind};
use crate::report::ErrorStage;
use crate::token::{Bracket, Tok};
use base::TextRange;

impl Parser<'_> {
    /// All `for` clauses that follow.
    pub(super) fn clauses(&mut self) -> Vec<CompFor> {
        let mut clauses = Vec::new();
        while matches!(self.kind(), Tok::For | Tok::Async) {
            if self.at(Tok::Async) {
                let range = self.bump().range;
                if !self.at(Tok::For) {
                    self.unexpected("`async` is not supported");
                    break;
                }
                let reference = "asynchronous comprehension outside of an asynchronous function";
                self.report.not_supported(
                    ErrorStage::Tree,
                    range,
                    "`async` is not supported",
                    reference,
                );
            }
            self.bump();
            clauses.push(self.clause());
            // Later clauses and the element nest inside of this one.
            if !self.grow() {
                break;
            }
        }
        clauses
    }

    fn clause(&mut self) -> CompFor {
        let target = self.target_list();
        let iter = if self.at(Tok::In) {
            self.check_target(&target);
            self.bump();
            self.operand(power::OR)
        } else if self.suggests_comma() && !matches!(target.kind, ExprKind::Missing) {
            let reference = "invalid syntax. Perhaps you forgot a comma?";
            let error = self.report.len();
            self.error_from(target.range.start, self.gap(), "expected `in`", reference);
            let iter = self.operand(power::OR);
            self.reword_unclosed(error);
            iter
        } else if self.is_invalid_target(&target) {
            self.check_target(&target);
            self.missing()
        } else {
            self.hole("`in`")
        };
        let mut conditions = Vec::new();
        while self.eat(Tok::If) {
            conditions.push(self.operand(power::OR));
        }
        CompFor {
            target,
            iter,
            conditions,
        }
    }

    /// `a`, `a, b`, `a, *b`, …
    fn target_list(&mut self) -> Expr {
        let start = self.start();
        let first = self.target();
        let start = start.min(first.range.start);
        if !self.at(Tok::Comma) {
            if matches!(first.kind, ExprKind::Starred(_)) {
                let reference = "starred assignment target must be in a list or tuple";
                self.report.add(
                    ErrorStage::Tree,
                    first.range,
                    "`*` must be used with other targets",
                    reference,
                );
            }
            return first;
        }
        let mut items = vec![first];
        while self.eat(Tok::Comma) {
            if self.at(Tok::In) || self.at_close() {
                break;
            }
            items.push(self.target());
        }
        Expr {
            kind: ExprKind::Tuple(items),
            range: self.range_from(start),
        }
    }

    fn target(&mut self) -> Expr {
        if self.at(Tok::In) {
            return self.hole("a name");
        }
        let start = self.start();
        if !self.at(Tok::Star) {
            let index = self.pos;
            let target = self.operand(power::BIT_OR);
            self.operand_start = Some(index);
            return target;
        }
        self.bump();
        let value = self.operand(power::BIT_OR);
        self.operand_start = None;
        self.grow();
        self.node(start, value, ExprKind::Starred)
    }

    /// A `for` follows: can what was read before be its element?
    pub(super) fn check_elements(&mut self, items: &[Expr], bracket: Bracket) {
        match items {
            [] => {
                self.unexpected("expected a value before `for`");
            }
            [only] if self.token_at(self.pos.saturating_sub(1)).kind != Tok::Comma => {
                if matches!(only.kind, ExprKind::Starred(_)) {
                    let reference = "iterable unpacking cannot be used in comprehension";
                    self.error(
                        only.range,
                        "`*` is not allowed in a comprehension",
                        reference,
                    );
                }
            }
            [first, ..] => {
                let reference = match bracket {
                    Bracket::Round => "invalid syntax",
                    _ => "did you forget parentheses around the comprehension target?",
                };
                let message = "several values before `for` must be in parentheses";
                self.error(first.range, message, reference);
            }
        }
    }

    /// Build the comprehension from its parts; several elements become a tuple, as was meant.
    pub(super) fn comprehension_of(
        &mut self,
        start: u32,
        bracket: Bracket,
        mut items: Vec<Expr>,
        clauses: Vec<CompFor>,
    ) -> Expr {
        let element = match (items.pop(), items.is_empty()) {
            (Some(only), true) => only,
            (Some(last), false) => {
                let from = items
                    .first()
                    .map_or(last.range.start, |first| first.range.start);
                let range = TextRange::new(from, last.range.end);
                items.push(last);
                Expr {
                    kind: ExprKind::Tuple(items),
                    range,
                }
            }
            (None, _) => Expr {
                kind: ExprKind::Missing,
                range: TextRange::empty(start),
            },
        };
        let kind = match bracket {
            Bracket::Round => CompKind::Generator,
            Bracket::Square => CompKind::List,
            Bracket::Curly => CompKind::Set,
        };
        let comp = Comprehension {
            kind,
            element,
            value: None,
            clauses,
        };
        Expr {
            kind: ExprKind::Comprehension(Arc::new(comp)),
            range: self.range_from(start),
        }
    }
}
