//! A tolerant parser of Python expressions: operator precedence on top, brackets below.
//!
//! It stops nowhere: what is missing becomes [`ExprKind::Missing`], what is too much is reported
//! and skipped, so that completion has a tree for half-typed text.

mod atoms;
mod braces;
mod calls;
mod comprehensions;
mod fstrings;
mod items;
mod lambdas;
mod strings;
mod targets;
#[cfg(test)]
mod tests;

use super::ast::{BinOp, CmpOp, Expr, ExprKind, UnaryOp};
use super::lexer::{Source, Tok, Token, lex};
use super::report::{Report, Stage};
use super::syntax::{ExprErrorKind, Parsed, forbidden_names, is_python_space};
use crate::base::TextRange;

/// How deep the tree, and the recursion that builds it, may become. Evaluators recurse over it too.
const MAX_DEPTH: u32 = 240;

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
    let text = if u32::try_from(text.len()).is_ok() { text } else { "" };
    let trimmed = text.trim_start_matches(is_python_space);
    let start = text.len() - trimmed.len();
    let end = start + trimmed.trim_end_matches(is_python_space).len();
    let mut report = Report::new(text, start as u32);
    let source = Source { text, start, end, outer_end: text.len(), bracketed: false };
    let tokens = lex(&source, &mut report);
    let mut parser = Parser::new(text, tokens, report, start as u32);
    let expr = parser.whole();
    let mut report = parser.report;
    report_forbidden(&expr, text, &mut report);
    Parsed { expr, errors: report.finish() }
}

fn report_forbidden(expr: &Expr, text: &str, report: &mut Report<'_>) {
    if !text.contains("__") {
        return;
    }
    let names = forbidden_names(expr);
    let Some((_, range)) = names.first() else { return };
    let list: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
    let list = list.join(", ");
    let message = format!("names that start with `__` are not allowed: {list}");
    let reference = format!("Use of invalid name(s):  {list}");
    report.push(Stage::Name, ExprErrorKind::ForbiddenName, *range, message, reference);
}

struct Parser<'t> {
    text: &'t str,
    tokens: Vec<Token>,
    pos: usize,
    /// End of the last token taken.
    prev_end: u32,
    report: Report<'t>,
    /// Calls of [`Parser::nested`] under way.
    depth: u32,
    /// At least the height of the subtrees built since the innermost `nested` began.
    height: u32,
    too_deep: bool,
    /// Index of the first token of the last operand that stood where a whole expression may.
    operand_start: Option<usize>,
    /// Whether a `:=` was seen, so that its special rules need checking.
    walrus: bool,
}

const END: Token = Token { kind: Tok::End, range: TextRange { start: 0, end: 0 } };

// Cursor
impl<'t> Parser<'t> {
    fn new(text: &'t str, tokens: Vec<Token>, report: Report<'t>, start: u32) -> Self {
        Self {
            text,
            tokens,
            pos: 0,
            prev_end: start,
            report,
            depth: 0,
            height: 0,
            too_deep: false,
            operand_start: None,
            walrus: false,
        }
    }

    fn token_at(&self, index: usize) -> Token {
        self.tokens.get(index).or(self.tokens.last()).copied().unwrap_or(END)
    }

    fn token(&self) -> Token {
        self.token_at(self.pos)
    }

    fn kind(&self) -> Tok {
        self.token().kind
    }

    fn next_kind(&self) -> Tok {
        self.token_at(self.pos + 1).kind
    }

    fn at(&self, kind: Tok) -> bool {
        self.kind() == kind
    }

    /// Whether the innermost bracket, or the text, ends here.
    fn at_close(&self) -> bool {
        let kind = self.kind();
        kind.is_close() || kind == Tok::End
    }

    fn bump(&mut self) -> Token {
        let token = self.token();
        if token.kind != Tok::End {
            self.pos += 1;
            self.prev_end = token.range.end;
        }
        token
    }

    fn eat(&mut self, kind: Tok) -> bool {
        let found = self.at(kind);
        if found {
            self.bump();
        }
        found
    }

    fn start(&self) -> u32 {
        self.token().range.start
    }

    fn range_from(&self, start: u32) -> TextRange {
        TextRange::new(start, self.prev_end)
    }

    /// The blank space before the next token: where a cursor stands that is about to fill a hole.
    fn gap(&self) -> TextRange {
        TextRange::new(self.prev_end, self.start())
    }

    fn missing(&self) -> Expr {
        Expr { kind: ExprKind::Missing, range: self.gap() }
    }

    /// Skip one token, or a bracket with all it holds.
    fn skip(&mut self) {
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
    fn at_unclosed_end(&self) -> bool {
        let token = self.token();
        self.report.unclosed.is_some()
            && self.tokens.last().is_some_and(|end| token.range.start == end.range.start)
    }
}

// Errors
impl Parser<'_> {
    /// A grammar error at `range`; an open bracket takes precedence as it does in CPython.
    fn error(&mut self, range: TextRange, message: impl Into<String>, reference: &str) {
        if self.too_deep || self.report.is_full() {
            return;
        }
        let line = self.report.line(self.start());
        if let Some((unclosed, open_line)) = self.report.never_closed()
            && (self.at_unclosed_end() || line > open_line)
        {
            self.report.add_at_line(Stage::Grammar, range, message, &unclosed, open_line);
            return;
        }
        self.report.add_at_line(Stage::Grammar, range, message, reference, line);
    }

    /// The next token is wrong.
    fn unexpected(&mut self, message: impl Into<String>) {
        let token = self.token();
        let range = if token.range.is_empty() { self.gap() } else { token.range };
        let reference = if token.kind == Tok::Indent { "unexpected indent" } else { "invalid syntax" };
        self.error(range, message, reference);
    }

    /// An operand is missing before the next token.
    fn hole(&mut self, what: &str) -> Expr {
        let found = self.token();
        let message = if found.range.is_empty() || found.kind.is_close() {
            format!("{what} is missing here")
        } else {
            format!("{what} is missing before `{}`", found.range.slice(self.text))
        };
        self.unexpected(message);
        self.missing()
    }
}

// Expressions
impl Parser<'_> {
    /// Everything up to the end of the text.
    fn whole(&mut self) -> Expr {
        let start = self.start();
        if self.tokens.len() == 1 {
            let line = usize::from(!self.text.trim_matches(is_python_space).is_empty());
            let message = "an expression is missing here";
            self.report.add_at_line(Stage::Grammar, self.gap(), message, "invalid syntax", line);
            return self.missing();
        }
        let first = self.expression();
        let expr = if self.at(Tok::Comma) { self.bare_tuple(start, first) } else { first };
        while self.eat(Tok::Newline) {}
        if self.at(Tok::End) { expr } else { self.leftovers(start, expr) }
    }

    fn bare_tuple(&mut self, start: u32, first: Expr) -> Expr {
        let mut items = vec![first];
        while self.eat(Tok::Comma) {
            if matches!(self.kind(), Tok::End | Tok::Newline) {
                break;
            }
            items.push(self.expression());
        }
        Expr { kind: ExprKind::Tuple(items), range: self.range_from(start) }
    }

    /// Text behind a complete expression: keep its pieces as a tuple, for completion and hovering.
    fn leftovers(&mut self, start: u32, first: Expr) -> Expr {
        if let Some(name) = self.old_print(&first) {
            self.error(first.range, format!("`{name}` needs parentheses"), &print_reference(name));
        } else {
            let found = self.token().range.slice(self.text).trim().to_owned();
            let message = match self.kind() {
                Tok::Equal => "`=` assigns, which is not possible here; compare with `==`".to_owned(),
                Tok::Indent => "this line cannot continue the expression".to_owned(),
                _ => format!("`{found}` cannot follow a complete expression"),
            };
            self.unexpected(message);
        }
        let mut items = vec![first];
        while !self.at(Tok::End) {
            let before = self.pos;
            if self.kind().starts_operand() || matches!(self.kind(), Tok::Open(_)) {
                items.push(self.expression());
            }
            if self.pos == before {
                self.skip();
            }
        }
        Expr { kind: ExprKind::Tuple(items), range: self.range_from(start) }
    }

    /// The name, if `expr` is a `print` that misses its parentheses.
    fn old_print(&self, expr: &Expr) -> Option<&'static str> {
        let ExprKind::Name(name) = &expr.kind else { return None };
        let name = ["print", "exec"].into_iter().find(|n| name == n)?;
        (self.kind().starts_operand() || self.at(Tok::Star)).then_some(name)
    }

    /// Run `f` one level deeper, or give up with a hole when that is too deep.
    fn nested(&mut self, f: impl FnOnce(&mut Self) -> Expr) -> Expr {
        if self.depth >= MAX_DEPTH {
            return self.give_up("too many nested parentheses");
        }
        self.depth += 1;
        let outer = std::mem::take(&mut self.height);
        let expr = f(self);
        self.height = outer.max(self.height + 1);
        self.depth -= 1;
        expr
    }

    /// One more level on top of what was parsed last; false if that is too much.
    fn grow(&mut self) -> bool {
        self.height += 1;
        if self.height >= MAX_DEPTH {
            self.give_up("maximum recursion depth exceeded during compilation");
        }
        self.height < MAX_DEPTH
    }

    fn give_up(&mut self, reference: &str) -> Expr {
        let hole = Expr { kind: ExprKind::Missing, range: TextRange::empty(self.prev_end) };
        if !self.too_deep {
            self.error(self.token().range, "the expression is nested too deeply", reference);
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
            let body = p.operand(power::OR);
            p.operand_start = Some(index);
            if p.at(Tok::If) { p.conditional(start, body) } else { body }
        })
    }

    fn conditional(&mut self, start: u32, body: Expr) -> Expr {
        self.bump();
        let test = self.operand(power::OR);
        let orelse = if self.eat(Tok::Else) {
            self.expression()
        } else {
            if !matches!(test.kind, ExprKind::Missing) {
                let reference = if self.at(Tok::Colon) {
                    "invalid syntax"
                } else {
                    "expected 'else' after 'if' expression"
                };
                self.error(self.gap(), "`else` and a value are missing here", reference);
            }
            self.missing()
        };
        let range = TextRange::new(start, self.prev_end.max(orelse.range.end));
        let kind = ExprKind::IfElse { test: Box::new(test), body: Box::new(body), orelse: Box::new(orelse) };
        Expr { kind, range }
    }

    /// An operand and all operators behind it that bind at least as tight as `min`.
    fn operand(&mut self, min: u8) -> Expr {
        self.nested(|p| {
            let start = p.start();
            let mut left = p.prefix(min);
            loop {
                let range_start = start.min(left.range.start);
                left = match p.infix(min, left, range_start) {
                    Ok(longer) => longer,
                    Err(done) => return done,
                };
                if !p.grow() {
                    return left;
                }
            }
        })
    }

    /// Extend `left` by the operator that follows, or give it back.
    fn infix(&mut self, min: u8, left: Expr, start: u32) -> Result<Expr, Expr> {
        let kind = self.kind();
        if let Some((op, bind)) = binary_operator(kind) {
            if bind < min {
                return Err(left);
            }
            self.bump();
            let right = self.operand(if bind == power::POW { power::UNARY } else { bind + 1 });
            return Ok(self.node(start, right, |right| ExprKind::Binary(op, Box::new(left), right)));
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
        let range = TextRange::new(start, self.prev_end.max(last.range.end));
        Expr { kind: kind(Box::new(last)), range }
    }

    fn chain(&mut self, word: Tok, bind: u8, left: Expr, start: u32) -> Expr {
        let mut items = vec![left];
        let mut end = self.prev_end;
        while self.eat(word) {
            let item = self.operand(bind + 1);
            end = end.max(item.range.end).max(self.prev_end);
            items.push(item);
        }
        let kind = if word == Tok::And { ExprKind::And(items) } else { ExprKind::Or(items) };
        Expr { kind, range: TextRange::new(start, end) }
    }

    fn comparison(&mut self, first: Expr, start: u32) -> Expr {
        let mut rest = Vec::new();
        let mut end = self.prev_end;
        while let Some((op, words)) = self.comparison_operator() {
            for _ in 0..words {
                self.bump();
            }
            let right = self.operand(power::COMPARE + 1);
            end = end.max(right.range.end).max(self.prev_end);
            rest.push((op, right));
        }
        Expr { kind: ExprKind::Compare(Box::new(first), rest), range: TextRange::new(start, end) }
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
            self.unexpected("`not` needs parentheses here");
        }
        self.bump();
        let value = self.operand(if op == UnaryOp::Not { power::NOT } else { power::UNARY });
        self.node(start, value, |value| ExprKind::Unary(op, value))
    }
}

fn print_reference(name: &str) -> String {
    format!("Missing parentheses in call to '{name}'. Did you mean {name}(...)?")
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
