//! A tolerant parser of Python expressions: operator precedence on top, brackets below.
//!
//! It stops nowhere: what is missing becomes [`ExprKind::Missing`], what is too much is reported
//! and skipped, so that completion has a tree for half-typed text.

mod atoms;
mod braces;
mod calls;
mod comprehensions;
mod cursor;
mod fstrings;
mod items;
mod lambdas;
mod recovery;
mod strings;
mod targets;
#[cfg(test)]
mod tests;
mod walrus;

use super::ast::{BinOp, CmpOp, Expr, ExprKind, UnaryOp};
use super::lexer::{LexerInput, lex};
use super::report::{ErrorStage, ExprErrors};
use super::syntax::{ExprErrorKind, Parsed, forbidden_names, is_python_space};
use super::token::{Tok, Token};
use base::TextRange;
use base::limits::EXPRESSION_DEPTH;

/// Binding powers, loosest first.
mod power {
    pub(super) const OR: u8 = 2;
    pub(super) const AND: u8 = 4;
    pub(super) const NOT: u8 = 6;
    pub(super) const COMPARE: u8 = 8;
    pub(super) const BIT_OR: u8 = 10;
    pub(super) const UNARY: u8 = 22;
    pub(super) const POW: u8 = 24;
}

/// Parse a whole expression.
pub(super) fn parse(text: &str) -> Parsed {
    // Ranges are 32 bits wide; no description comes near.
    let text = if u32::try_from(text.len()).is_ok() {
        text
    } else {
        ""
    };
    let trimmed = text.trim_start_matches(is_python_space);
    let start = text.len() - trimmed.len();
    let end = start + trimmed.trim_end_matches(is_python_space).len();
    let mut report = ExprErrors::new(text, start as u32);
    let source = LexerInput {
        text,
        start,
        end,
        outer_end: text.len(),
        bracketed: false,
    };
    let tokens = lex(&source, &mut report);
    let mut parser = Parser::new(text, tokens, report, start as u32);
    let expr = parser.whole();
    let walrus = parser.walrus;
    let mut report = parser.report;
    if walrus {
        walrus::check(&expr, &mut report);
    }
    report_forbidden(&expr, text, &mut report);
    Parsed {
        expr,
        errors: report.finish(),
    }
}

fn report_forbidden(expr: &Expr, text: &str, report: &mut ExprErrors<'_>) {
    if !text.contains("__") {
        return;
    }
    let names = forbidden_names(expr);
    let Some((_, range)) = names.first() else {
        return;
    };
    let list: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
    let list = list.join(", ");
    let message = format!("names that start with `__` are not allowed: {list}");
    let reference = format!("Use of invalid name(s):  {list}");
    report.push(
        ErrorStage::Name,
        ExprErrorKind::ForbiddenName,
        *range,
        message,
        reference,
    );
}

struct Parser<'t> {
    text: &'t str,
    tokens: Vec<Token>,
    pos: usize,
    /// End of the last token taken.
    prev_end: u32,
    /// The same, or behind a hole after it.
    reach: u32,
    report: ExprErrors<'t>,
    /// Calls of [`Parser::nested`] under way.
    depth: u32,
    /// At least the height of the subtrees built since the innermost `nested` began; who builds a node on
    /// top of them calls [`Parser::grow`].
    height: u32,
    too_deep: bool,
    /// Index of the first token of the last operand that stood where a whole expression may.
    operand_start: Option<usize>,
    /// Brackets around the current token, as far as they hold items.
    level: u32,
    /// Where the last [`Parser::items`] ended, before the closing bracket.
    items_end: u32,
    /// Whether a `:=` was seen, so that its special rules need checking.
    walrus: bool,
}

impl Parser<'_> {
    /// Everything up to the end of the text.
    fn whole(&mut self) -> Expr {
        let start = self.start();
        if self.tokens.len() == 1 {
            let line = usize::from(!self.text.trim_matches(is_python_space).is_empty());
            let message = "expected an expression";
            self.report.add_at_line(
                ErrorStage::Grammar,
                self.gap(),
                message,
                "invalid syntax",
                line,
            );
            return self.missing();
        }
        let first = self.expression();
        let start = start.min(first.range.start);
        let expr = if self.at(Tok::Comma) {
            self.bare_tuple(start, first)
        } else {
            first
        };
        let same_line = !self.at(Tok::Newline);
        while self.eat(Tok::Newline) {}
        if self.at(Tok::End) {
            expr
        } else {
            self.leftovers(start, expr, same_line)
        }
    }

    fn bare_tuple(&mut self, start: u32, first: Expr) -> Expr {
        let mut items = vec![first];
        while self.eat(Tok::Comma) {
            if matches!(self.kind(), Tok::End | Tok::Newline) {
                break;
            }
            items.push(self.expression());
        }
        Expr {
            kind: ExprKind::Tuple(items),
            range: self.range_from(start),
        }
    }

    /// Run `f` one level deeper, or give up with a hole when that is too deep.
    fn nested(&mut self, f: impl FnOnce(&mut Self) -> Expr) -> Expr {
        if self.depth >= EXPRESSION_DEPTH {
            return self.give_up();
        }
        self.depth += 1;
        let outer = std::mem::take(&mut self.height);
        let mut expr = f(self);
        if self.height >= EXPRESSION_DEPTH {
            // Too high already: whatever comes on top stands on a hole.
            self.give_up();
            expr.kind = ExprKind::Missing;
            self.height = 0;
        }
        self.height = outer.max(self.height);
        self.depth -= 1;
        expr
    }

    /// One more level on top of what was parsed last; false if that is too much.
    fn grow(&mut self) -> bool {
        self.height += 1;
        if self.height >= EXPRESSION_DEPTH {
            self.give_up();
        }
        self.height < EXPRESSION_DEPTH
    }

    fn give_up(&mut self) -> Expr {
        let reference = "maximum recursion depth exceeded during compilation";
        let hole = Expr {
            kind: ExprKind::Missing,
            range: TextRange::empty(self.prev_end),
        };
        if !self.too_deep {
            let (range, kind) = (self.token().range, ExprErrorKind::Syntax);
            self.report.push(
                ErrorStage::Grammar,
                kind,
                range,
                format!("expression is nested more than {EXPRESSION_DEPTH} levels deep"),
                reference.into(),
            );
        }
        self.too_deep = true;
        self.pos = self.tokens.len().saturating_sub(1);
        hole
    }

    /// `expression`: a conditional, a lambda, or what is below these.
    fn expression(&mut self) -> Expr {
        self.nested(|p| {
            if p.at(Tok::Lambda) {
                return p.lambda();
            }
            let (start, index) = (p.start(), p.pos);
            let body = p.operand_here(power::OR);
            let start = start.min(body.range.start);
            p.operand_start = Some(index);
            if p.at(Tok::If) {
                p.conditional(start, body)
            } else {
                body
            }
        })
    }

    fn conditional(&mut self, start: u32, body: Expr) -> Expr {
        self.bump();
        let mark = self.report.len();
        let test = self.operand(power::OR);
        let hole = matches!(test.kind, ExprKind::Missing);
        let half = recovery::starts_well(&test) && recovery::ends_with_hole(&test);
        let no_else = "expected 'else' after 'if' expression";
        if let Some(index) = self.report.plain_since(mark).filter(|_| half) {
            // CPython takes the part of the test that makes sense, and finds no `else` behind that.
            self.reword(index, start, no_else);
        }
        let orelse = if self.eat(Tok::Else) {
            self.expression()
        } else {
            if !hole {
                let reference = if self.at(Tok::Colon) {
                    "invalid syntax"
                } else {
                    no_else
                };
                self.error_from(
                    start,
                    self.gap(),
                    "expected `else` and a value after `if`",
                    reference,
                );
            }
            self.missing()
        };
        self.grow();
        let range = self.range_from(start);
        let kind = ExprKind::IfElse {
            test: Box::new(test),
            body: Box::new(body),
            orelse: Box::new(orelse),
        };
        Expr { kind, range }
    }

    /// An operand and all operators behind it that bind at least as tight as `min`.
    fn operand(&mut self, min: u8) -> Expr {
        self.nested(|p| p.operand_here(min))
    }

    /// The same without counting a level.
    fn operand_here(&mut self, min: u8) -> Expr {
        let start = self.start();
        let mut left = self.prefix(min);
        loop {
            let start = start.min(left.range.start);
            left = match self.infix(min, left, start) {
                Ok(longer) => longer,
                Err(done) => return done,
            };
            if !self.grow() {
                return left;
            }
        }
    }

    /// Extend `left` by the operator that follows, or give it back.
    fn infix(&mut self, min: u8, left: Expr, start: u32) -> Result<Expr, Expr> {
        let kind = self.kind();
        if let Some((op, bind)) = binary_operator(kind) {
            if bind < min {
                return Err(left);
            }
            self.bump();
            let right = self.operand(if bind == power::POW {
                power::UNARY
            } else {
                bind + 1
            });
            return Ok(self.node(start, right, |right| {
                ExprKind::Binary(op, Box::new(left), right)
            }));
        }
        match kind {
            Tok::And if min <= power::AND => Ok(self.chain(Tok::And, power::AND, left, start)),
            Tok::Or if min <= power::OR => Ok(self.chain(Tok::Or, power::OR, left, start)),
            _ if min <= power::COMPARE && self.comparison_operator().is_some() => {
                Ok(self.comparison(left, start))
            }
            _ => Err(left),
        }
    }

    /// A node that starts at `start` and ends with `last`, which may be a hole.
    fn node(&self, start: u32, last: Expr, kind: impl FnOnce(Box<Expr>) -> ExprKind) -> Expr {
        Expr {
            kind: kind(Box::new(last)),
            range: self.range_from(start),
        }
    }

    fn chain(&mut self, word: Tok, bind: u8, left: Expr, start: u32) -> Expr {
        let mut items = vec![left];
        while self.eat(word) {
            items.push(self.operand(bind + 1));
        }
        let kind = if word == Tok::And {
            ExprKind::And(items)
        } else {
            ExprKind::Or(items)
        };
        Expr {
            kind,
            range: self.range_from(start),
        }
    }

    fn comparison(&mut self, first: Expr, start: u32) -> Expr {
        let mut rest = Vec::new();
        while let Some((op, words)) = self.comparison_operator() {
            for _ in 0..words {
                self.bump();
            }
            rest.push((op, self.operand(power::COMPARE + 1)));
        }
        Expr {
            kind: ExprKind::Compare(Box::new(first), rest),
            range: self.range_from(start),
        }
    }

    /// The comparison operator that starts here, and of how many tokens it consists.
    fn comparison_operator(&self) -> Option<(CmpOp, u8)> {
        Some(match self.kind() {
            Tok::EqEq => (CmpOp::Eq, 1),
            Tok::NotEq => (CmpOp::Ne, 1),
            Tok::Lt => (CmpOp::Lt, 1),
            Tok::Le => (CmpOp::Le, 1),
            Tok::Gt => (CmpOp::Gt, 1),
            Tok::Ge => (CmpOp::Ge, 1),
            Tok::In => (CmpOp::In, 1),
            Tok::Not if self.next_kind() == Tok::In => (CmpOp::NotIn, 2),
            Tok::Is if self.next_kind() == Tok::Not => (CmpOp::IsNot, 2),
            Tok::Is => (CmpOp::Is, 1),
            _ => return None,
        })
    }

    /// A unary operator with its operand, or a primary.
    fn prefix(&mut self, min: u8) -> Expr {
        let op = match self.kind() {
            Tok::Minus => UnaryOp::Neg,
            Tok::Plus => UnaryOp::Pos,
            Tok::Tilde => UnaryOp::Invert,
            Tok::Not => UnaryOp::Not,
            _ => return self.primary(),
        };
        let start = self.start();
        if op == UnaryOp::Not && min > power::NOT {
            self.unexpected("`not` must be in parentheses here");
        }
        self.bump();
        let value = self.operand(if op == UnaryOp::Not {
            power::NOT
        } else {
            power::UNARY
        });
        self.grow();
        self.node(start, value, |value| ExprKind::Unary(op, value))
    }
}

fn binary_operator(kind: Tok) -> Option<(BinOp, u8)> {
    Some(match kind {
        Tok::Pipe => (BinOp::BitOr, power::BIT_OR),
        Tok::Caret => (BinOp::BitXor, 12),
        Tok::Amp => (BinOp::BitAnd, 14),
        Tok::LShift => (BinOp::LShift, 16),
        Tok::RShift => (BinOp::RShift, 16),
        Tok::Plus => (BinOp::Add, 18),
        Tok::Minus => (BinOp::Sub, 18),
        Tok::Star => (BinOp::Mul, 20),
        Tok::Slash => (BinOp::Div, 20),
        Tok::DoubleSlash => (BinOp::FloorDiv, 20),
        Tok::Percent => (BinOp::Mod, 20),
        Tok::At => (BinOp::MatMul, 20),
        Tok::DoubleStar => (BinOp::Pow, power::POW),
        _ => return None,
    })
}
