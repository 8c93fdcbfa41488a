//! Names, literals, displays and what may be appended to them.

use super::Parser;
use crate::ast::{Const, Expr, ExprKind};
use crate::number;
use crate::report::ErrorStage;
use crate::token::{Bracket, Tok};
use base::TextRange;

impl Parser<'_> {
    /// An atom with its calls, indices and attributes.
    pub(super) fn primary(&mut self) -> Expr {
        let start = self.start();
        let mut expr = self.atom();
        loop {
            let start = start.min(expr.range.start);
            expr = match self.kind() {
                Tok::Dot => self.attribute(start, expr),
                Tok::Open(Bracket::Round) => self.call(start, expr),
                Tok::Open(Bracket::Square) => self.subscript(start, expr),
                _ => return expr,
            };
            if !self.grow() {
                return expr;
            }
        }
    }

    fn atom(&mut self) -> Expr {
        let token = self.token();
        let kind = match token.kind {
            Tok::Name => ExprKind::Name(self.identifier(token.range)),
            Tok::Number => self.number(token.range),
            Tok::BadNumber => ExprKind::Missing,
            Tok::None => ExprKind::Const(Const::None),
            Tok::True => ExprKind::Const(Const::Bool(true)),
            Tok::False => ExprKind::Const(Const::Bool(false)),
            Tok::Ellipsis => ExprKind::Const(Const::Ellipsis),
            Tok::Str | Tok::OpenStr => return self.strings(),
            Tok::Open(bracket) => return self.display(bracket),
            Tok::Lambda => {
                self.unexpected("`lambda` must be in parentheses here");
                return self.nested(Self::lambda);
            }
            Tok::Await => return self.awaited(),
            _ => return self.no_atom(),
        };
        self.bump();
        Expr {
            kind,
            range: token.range,
        }
    }

    fn number(&mut self, range: TextRange) -> ExprKind {
        match number::value(range.slice(self.text)) {
            Ok(value) => ExprKind::Const(value),
            Err(reference) => {
                self.report.add(
                    ErrorStage::Grammar,
                    range,
                    "integer has too many digits",
                    &reference,
                );
                ExprKind::Missing
            }
        }
    }

    fn display(&mut self, bracket: Bracket) -> Expr {
        let expr = match bracket {
            Bracket::Round => self.parenthesized(),
            Bracket::Square => self.list(),
            Bracket::Curly => self.dict_or_set(),
        };
        self.grow();
        expr
    }

    /// Something else stands where an operand should.
    fn no_atom(&mut self) -> Expr {
        match self.kind() {
            Tok::Keyword | Tok::Async | Tok::Yield | Tok::Other => {
                let found = self.shown_token();
                let hole = self.token().range;
                self.unexpected(format!("`{found}` is not allowed in an expression"));
                self.bump();
                Expr {
                    kind: ExprKind::Missing,
                    range: hole,
                }
            }
            _ => self.hole("a value"),
        }
    }

    /// `await value`: only possible in functions, and an expression is none.
    fn awaited(&mut self) -> Expr {
        let word = self.bump().range;
        let value = self.nested(Self::primary);
        let message = "`await` is not supported";
        self.report
            .not_supported(ErrorStage::Tree, word, message, "'await' outside function");
        self.node(word.start, value, |value| value.kind)
    }

    /// `(yield values)`, from behind the parenthesis on.
    pub(super) fn yielded(&mut self, start: u32) -> Expr {
        let word = self.bump().range;
        let message = "`yield` is not supported";
        self.report
            .not_supported(ErrorStage::Tree, word, message, "'yield' outside function");
        if self.token().range.slice(self.text) == "from" {
            self.bump();
        }
        let mut values = Vec::new();
        self.items(|p| values.push(p.starred_or_named()));
        Expr {
            kind: ExprKind::Tuple(values),
            range: self.range_from(start),
        }
    }
}
