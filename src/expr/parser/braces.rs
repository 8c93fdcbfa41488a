//! Dicts, sets and their comprehensions.

use std::sync::Arc;

use super::{Parser, power};
use crate::ast::{CompFor, CompKind, Comprehension, Expr, ExprKind};
use crate::token::{Bracket, Tok};

/// What was read between braces so far; there are either pairs or items.
#[derive(Default)]
struct Braces {
    pairs: Vec<(Option<Expr>, Expr)>,
    items: Vec<Expr>,
    clauses: Option<Vec<CompFor>>,
}

impl Parser<'_> {
    /// `{…}`: a dict, a set or a comprehension of these.
    pub(super) fn dict_or_set(&mut self) -> Expr {
        let start = self.bump().range.start;
        let mut braces = Braces::default();
        self.items(|p| p.braces_item(&mut braces));
        let range = self.range_from(start);
        let Braces {
            mut pairs,
            items,
            clauses,
        } = braces;
        let kind = match clauses {
            Some(clauses) => match pairs.pop() {
                Some((key, value)) => {
                    let element = key.unwrap_or_else(|| Expr {
                        kind: ExprKind::Missing,
                        range: value.range,
                    });
                    let comp = Comprehension {
                        kind: CompKind::Dict,
                        element,
                        value: Some(value),
                        clauses,
                    };
                    ExprKind::Comprehension(Arc::new(comp))
                }
                None => return self.comprehension_of(start, Bracket::Curly, items, clauses),
            },
            None if items.is_empty() => ExprKind::Dict(pairs),
            None => ExprKind::Set(items),
        };
        Expr { kind, range }
    }

    fn braces_item(&mut self, braces: &mut Braces) {
        match self.kind() {
            Tok::Comma => {
                let hole = self.hole("a value");
                if braces.pairs.is_empty() {
                    braces.items.push(hole);
                }
            }
            Tok::DoubleStar if braces.items.is_empty() => {
                self.bump();
                let value = self.operand(power::BIT_OR);
                self.operand_start = None;
                if self.at(Tok::For) {
                    let reference = "dict unpacking cannot be used in dict comprehension";
                    self.error(
                        value.range,
                        "`**` is not allowed in a comprehension",
                        reference,
                    );
                }
                braces.pairs.push((None, value));
            }
            Tok::For | Tok::Async => {}
            _ if braces.pairs.is_empty() => self.first_or_set_item(braces),
            _ => {
                let key = self.expression();
                self.pair(key, braces);
            }
        }
        if matches!(self.kind(), Tok::For | Tok::Async) {
            match braces.pairs.len() {
                0 => self.check_elements(&braces.items, Bracket::Curly),
                1 => {}
                _ => self.unexpected("only one pair is allowed before `for`"),
            }
            braces.clauses = Some(self.clauses());
            self.operand_start = None;
            if self.at(Tok::Comma) {
                self.unexpected("a comprehension next to other items must be in parentheses");
            }
        }
    }

    fn first_or_set_item(&mut self, braces: &mut Braces) {
        let item = self.starred_or_named();
        if self.at(Tok::Colon)
            && braces.items.is_empty()
            && !matches!(item.kind, ExprKind::Starred(_))
        {
            self.pair(item, braces);
        } else {
            braces.items.push(item);
        }
    }

    /// The value that belongs to `key`, from the colon on.
    fn pair(&mut self, key: Expr, braces: &mut Braces) {
        let value = if !self.at(Tok::Colon) {
            let reference = "':' expected after dictionary key";
            self.error(self.gap(), "expected `:` and a value", reference);
            self.missing()
        } else {
            self.bump();
            self.pair_value()
        };
        braces.pairs.push((Some(key), value));
    }

    fn pair_value(&mut self) -> Expr {
        match self.kind() {
            Tok::Comma | Tok::Close(_) => {
                let reference = "expression expected after dictionary key and ':'";
                self.error(self.gap(), "expected a value", reference);
                self.missing()
            }
            Tok::Star => {
                let star = self.bump().range;
                let reference = "cannot use a starred expression in a dictionary value";
                self.error(star, "`*` is not allowed in a dict", reference);
                self.operand(power::BIT_OR)
            }
            _ => self.expression(),
        }
    }
}
