//! Attributes, calls and indices.

use super::Parser;
use crate::base::{FastSet, TextRange};
use crate::expr::ast::{Expr, ExprKind, Keyword};
use crate::expr::lexer::{Bracket, Tok};
use crate::expr::report::Stage;

/// The arguments of a call, while they are read.
#[derive(Default)]
struct Arguments {
    args: Vec<Expr>,
    keywords: Vec<Keyword>,
    /// Whether there was a `**mapping`.
    unpacking: bool,
    /// A generator without parentheses of its own; it must be the only argument.
    generator: Option<TextRange>,
}

impl Parser<'_> {
    /// `.name`
    pub(super) fn attribute(&mut self, start: u32, value: Expr) -> Expr {
        let dot_end = self.bump().range.end;
        let token = self.token();
        let name_range = match token.kind {
            Tok::Name => self.bump().range,
            _ => {
                let word = token.range.slice(self.text);
                let glued =
                    token.range.start == dot_end && word.starts_with(|c: char| c.is_ascii_alphabetic());
                if glued && !matches!(token.kind, Tok::Str) {
                    self.unexpected(format!("`{word}` is a keyword and cannot be an attribute"));
                    self.bump().range
                } else {
                    self.hole("the name of an attribute").range
                }
            }
        };
        let name = name_range.slice(self.text).trim().into();
        let range = TextRange::new(start, name_range.end.max(self.prev_end));
        Expr { kind: ExprKind::Attribute { value: Box::new(value), name, name_range }, range }
    }

    /// `[index]`
    pub(super) fn subscript(&mut self, start: u32, value: Expr) -> Expr {
        let open_end = self.bump().range.end;
        if self.kind().is_close() {
            let index = self.hole("an index");
            self.bump();
            return self.indexed(start, value, index);
        }
        let mut items = Vec::new();
        let comma = self.nested_items(|p| {
            let item = p.index_item();
            items.push(item);
        });
        let index = match items.pop() {
            Some(only) if !comma && items.is_empty() && !matches!(only.kind, ExprKind::Starred(_)) => only,
            last => {
                let end = last.as_ref().map_or(open_end, |last| last.range.end);
                items.extend(last);
                let from = items.first().map_or(open_end, |first| first.range.start);
                Expr { kind: ExprKind::Tuple(items), range: TextRange::new(from, end) }
            }
        };
        self.indexed(start, value, index)
    }

    fn indexed(&self, start: u32, value: Expr, index: Expr) -> Expr {
        let kind = ExprKind::Subscript { value: Box::new(value), index: Box::new(index) };
        Expr { kind, range: self.range_from(start) }
    }

    /// [`Parser::items`], counted as a level of nesting.
    fn nested_items(&mut self, item: impl FnMut(&mut Self)) -> bool {
        let mut comma = false;
        self.nested(|p| {
            comma = p.items(item);
            p.missing()
        });
        comma
    }

    /// A slice, or one index.
    fn index_item(&mut self) -> Expr {
        let start = self.start();
        if self.at(Tok::Comma) {
            return self.hole("an index");
        }
        let lower = if self.at(Tok::Colon) { None } else { Some(self.starred_or_named()) };
        if !self.at(Tok::Colon) {
            return lower.unwrap_or_else(|| self.missing());
        }
        self.bump();
        let upper = self.bound();
        let step = if self.eat(Tok::Colon) { self.bound() } else { None };
        let kind = ExprKind::Slice {
            lower: lower.map(Box::new),
            upper: upper.map(Box::new),
            step: step.map(Box::new),
        };
        Expr { kind, range: self.range_from(start) }
    }

    fn bound(&mut self) -> Option<Expr> {
        let absent = self.at_close() || matches!(self.kind(), Tok::Colon | Tok::Comma);
        (!absent).then(|| self.expression())
    }

    /// `(arguments)`
    pub(super) fn call(&mut self, start: u32, func: Expr) -> Expr {
        self.bump();
        let mut found = Arguments::default();
        let comma = self.nested_items(|p| p.argument(&mut found));
        if let Some(range) = found.generator
            && (comma || found.args.len() + found.keywords.len() > 1)
        {
            let reference = "Generator expression must be parenthesized";
            self.error(range, "a generator needs parentheses beside other arguments", reference);
        }
        self.check_repeated(&found.keywords);
        let kind = ExprKind::Call { func: Box::new(func), args: found.args, keywords: found.keywords };
        Expr { kind, range: self.range_from(start) }
    }

    fn argument(&mut self, found: &mut Arguments) {
        match self.kind() {
            Tok::Comma => {
                let hole = self.hole("an argument");
                found.args.push(hole);
            }
            Tok::DoubleStar => {
                let name_range = self.bump().range;
                let value = self.expression();
                found.unpacking = true;
                found.keywords.push(Keyword { name: None, name_range, value });
            }
            Tok::Name if self.next_kind() == Tok::Equal => self.keyword(found),
            Tok::True | Tok::False | Tok::None if self.next_kind() == Tok::Equal => {
                let word = self.token().range;
                let name = word.slice(self.text);
                let (message, reference) = (
                    format!("`{name}` cannot be the name of an argument"),
                    format!("cannot assign to {name}"),
                );
                self.error(word, message, &reference);
                self.keyword(found);
            }
            Tok::Star => self.unpacked(found),
            _ => self.positional(found),
        }
    }

    fn keyword(&mut self, found: &mut Arguments) {
        let name_range = self.bump().range;
        self.bump();
        let value = self.expression();
        if matches!(self.kind(), Tok::For | Tok::Async) {
            let reference = "invalid syntax. Maybe you meant '==' or ':=' instead of '='?";
            self.error(name_range, "a generator cannot start with `name =`", reference);
            self.clauses();
        }
        let name = Some(name_range.slice(self.text).into());
        found.keywords.push(Keyword { name, name_range, value });
    }

    fn unpacked(&mut self, found: &mut Arguments) {
        let start = self.start();
        let star = self.bump().range;
        if found.unpacking {
            let reference = "iterable argument unpacking follows keyword argument unpacking";
            self.error(star, "`*` must stand before `**`", reference);
        }
        let value = self.expression();
        found.args.push(self.node(start, value, ExprKind::Starred));
    }

    fn positional(&mut self, found: &mut Arguments) {
        let start = self.start();
        let expr = if self.at(Tok::Name) && self.next_kind() == Tok::Walrus {
            self.named()
        } else {
            self.expression()
        };
        if matches!(self.kind(), Tok::For | Tok::Async) {
            let clauses = self.clauses();
            let expr = self.comprehension_of(start, Bracket::Round, vec![expr], clauses);
            found.generator = Some(expr.range);
            found.args.push(expr);
            return;
        }
        match self.kind() {
            Tok::Equal => {
                self.bump();
                let reference = "expression cannot contain assignment, perhaps you meant \"==\"?";
                self.error(expr.range, "only a plain name can stand before `=` in a call", reference);
                let value = self.expression();
                let name_range = expr.range;
                found.args.push(expr);
                found.keywords.push(Keyword { name: None, name_range, value });
            }
            Tok::Walrus => {
                self.unexpected("`:=` needs a plain name on its left");
                self.bump();
                found.args.push(expr);
            }
            _ => {
                self.check_order(&expr, found);
                found.args.push(expr);
            }
        }
    }

    fn check_order(&mut self, expr: &Expr, found: &Arguments) {
        if found.keywords.is_empty() || matches!(expr.kind, ExprKind::Missing) {
            return;
        }
        let reference = match found.unpacking {
            true => "positional argument follows keyword argument unpacking",
            false => "positional argument follows keyword argument",
        };
        self.error(expr.range, "arguments without a name must stand before those with one", reference);
    }

    fn check_repeated(&mut self, keywords: &[Keyword]) {
        let mut seen = FastSet::default();
        for keyword in keywords {
            let Some(name) = &keyword.name else { continue };
            if !seen.insert(name) {
                let message = format!("the argument `{name}` is given twice");
                let reference = format!("keyword argument repeated: {name}");
                self.report.add(Stage::Tree, keyword.name_range, message, &reference);
            }
        }
    }
}
