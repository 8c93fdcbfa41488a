//! Attributes, calls and indices.

use super::Parser;
use crate::ast::{Expr, ExprKind, Keyword};
use crate::report::ErrorStage;
use crate::syntax::normalized;
use crate::token::{Bracket, Tok};
use base::{FastSet, TextRange};

/// The arguments of a call, while they are read.
#[derive(Default)]
struct ArgumentList {
    args: Vec<Expr>,
    keywords: Vec<Keyword>,
    /// Whether there was a `**mapping`.
    unpacking: bool,
    /// How many errors there were before.
    mark: usize,
    /// The first argument that stands too far behind, and CPython's text for that.
    misplaced: Option<(TextRange, &'static str)>,
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
                let glued = token.range.start == dot_end
                    && word.starts_with(|c: char| c.is_ascii_alphabetic());
                if glued && !matches!(token.kind, Tok::Str | Tok::OpenStr) {
                    self.unexpected(format!("keyword `{word}` is not allowed as an attribute"));
                    self.bump().range
                } else {
                    self.hole("the name of an attribute").range
                }
            }
        };
        let name = normalized(name_range.slice(self.text).trim()).into();
        let range = self.range_from(start);
        Expr {
            kind: ExprKind::Attribute {
                value: Box::new(value),
                name,
                name_range,
            },
            range,
        }
    }

    /// `[index]`
    pub(super) fn subscript(&mut self, start: u32, value: Expr) -> Expr {
        let open_end = self.bump().range.end;
        if self.kind().is_close() {
            let index = self.missing();
            self.bump();
            self.error_from(start, index.range, "expected an index", self.no_index(0));
            return self.indexed(start, value, index);
        }
        let mut items = Vec::new();
        let comma = self.items(|p| {
            let item = p.index_item();
            items.push(item);
        });
        let index = match items.pop() {
            Some(only)
                if !comma && items.is_empty() && !matches!(only.kind, ExprKind::Starred(_)) =>
            {
                only
            }
            last => {
                let end = self.items_end;
                items.extend(last);
                let from = items.first().map_or(open_end, |first| first.range.start);
                Expr {
                    kind: ExprKind::Tuple(items),
                    range: TextRange::new(from, end),
                }
            }
        };
        self.indexed(start, value, index)
    }

    /// CPython's text for brackets that are no index: within others it takes them for a list.
    /// `own` is 1 while the level counts these brackets themselves.
    fn no_index(&self, own: u32) -> &'static str {
        if self.level > own {
            "invalid syntax. Perhaps you forgot a comma?"
        } else {
            "invalid syntax"
        }
    }

    fn indexed(&self, start: u32, value: Expr, index: Expr) -> Expr {
        let kind = ExprKind::Subscript {
            value: Box::new(value),
            index: Box::new(index),
        };
        Expr {
            kind,
            range: self.range_from(start),
        }
    }

    /// A slice, or one index.
    fn index_item(&mut self) -> Expr {
        let start = self.start();
        if self.at(Tok::Comma) {
            return self.hole("an index");
        }
        let item = self.slice_or_index(start);
        if !matches!(self.kind(), Tok::For | Tok::Async) {
            return item;
        }
        let (at, error) = (self.token().range, self.report.len());
        let message = "a comprehension must be in brackets";
        self.error_from(at.start, at, message, self.no_index(1));
        let clauses = self.clauses();
        self.operand_start = None;
        self.reword_unclosed(error);
        self.comprehension_of(
            start.min(item.range.start),
            Bracket::Round,
            vec![item],
            clauses,
        )
    }

    fn slice_or_index(&mut self, start: u32) -> Expr {
        let lower = if self.at(Tok::Colon) {
            None
        } else {
            Some(self.starred_or_named())
        };
        if !self.at(Tok::Colon) {
            return lower.unwrap_or_else(|| self.missing());
        }
        if matches!(
            lower.as_ref().map(|l| &l.kind),
            Some(ExprKind::NamedExpr { .. } | ExprKind::Starred(_))
        ) {
            self.unexpected("`:=` and `*` are not allowed before `:`");
        }
        let start = lower
            .as_ref()
            .map_or(start, |lower| start.min(lower.range.start));
        self.bump();
        let upper = self.bound();
        let step = if self.eat(Tok::Colon) {
            self.bound()
        } else {
            None
        };
        self.grow();
        let kind = ExprKind::Slice {
            lower: lower.map(Box::new),
            upper: upper.map(Box::new),
            step: step.map(Box::new),
        };
        Expr {
            kind,
            range: self.range_from(start),
        }
    }

    fn bound(&mut self) -> Option<Expr> {
        let absent = self.at_close() || matches!(self.kind(), Tok::Colon | Tok::Comma);
        (!absent).then(|| self.expression())
    }

    /// `(arguments)`
    pub(super) fn call(&mut self, start: u32, func: Expr) -> Expr {
        let open = self.bump().range.start;
        let mut found = ArgumentList {
            mark: self.report.len(),
            ..ArgumentList::default()
        };
        let comma = self.items(|p| p.argument(&mut found));
        let alone = !comma && found.args.len() + found.keywords.len() == 1;
        match (found.generator, found.args.as_mut_slice()) {
            // CPython counts the parentheses of the call to the generator.
            (Some(_), [generator]) if alone => {
                generator.range = TextRange::new(open, self.prev_end)
            }
            (Some(range), _) => {
                let reference = "Generator expression must be parenthesized";
                self.error(
                    range,
                    "a generator next to other arguments must be in parentheses",
                    reference,
                );
            }
            (None, _) => {}
        }
        self.check_order(&found);
        self.check_repeated(&found.keywords);
        let kind = ExprKind::Call {
            func: Box::new(func),
            args: found.args,
            keywords: found.keywords,
        };
        Expr {
            kind,
            range: self.range_from(start),
        }
    }

    fn argument(&mut self, found: &mut ArgumentList) {
        match self.kind() {
            Tok::Comma => {
                let hole = self.hole("an argument");
                found.args.push(hole);
            }
            Tok::DoubleStar => {
                let name_range = self.bump().range;
                let value = self.expression();
                found.unpacking = true;
                found.keywords.push(Keyword {
                    name: None,
                    name_range,
                    value,
                });
            }
            Tok::Name if self.next_kind() == Tok::Equal => self.keyword(found),
            Tok::True | Tok::False | Tok::None if self.next_kind() == Tok::Equal => {
                let word = self.token().range;
                let name = word.slice(self.text);
                let (message, reference) = (
                    format!("`{name}` is not allowed as the name of an argument"),
                    format!("cannot assign to {name}"),
                );
                self.error(word, message, &reference);
                self.keyword(found);
            }
            Tok::Star => self.unpacked(found),
            _ => self.positional(found),
        }
    }

    fn keyword(&mut self, found: &mut ArgumentList) {
        let name_range = self.bump().range;
        self.bump();
        let value = self.expression();
        if matches!(self.kind(), Tok::For | Tok::Async) {
            let reference = "invalid syntax. Maybe you meant '==' or ':=' instead of '='?";
            self.error(
                name_range,
                "a generator must not start with `name =`",
                reference,
            );
            self.clauses();
        }
        let name = Some(self.identifier(name_range));
        found.keywords.push(Keyword {
            name,
            name_range,
            value,
        });
    }

    fn unpacked(&mut self, found: &mut ArgumentList) {
        let start = self.start();
        let star = self.bump().range;
        if found.unpacking {
            let reference = "iterable argument unpacking follows keyword argument unpacking";
            self.error(star, "`*` must come before `**`", reference);
        }
        let value = self.expression();
        self.grow();
        found.args.push(self.node(start, value, ExprKind::Starred));
    }

    fn positional(&mut self, found: &mut ArgumentList) {
        let start = self.start();
        let expr = if self.at(Tok::Name) && self.next_kind() == Tok::Walrus {
            self.named()
        } else {
            self.expression()
        };
        if matches!(self.kind(), Tok::For | Tok::Async) {
            let clauses = self.clauses();
            let expr = self.comprehension_of(
                start.min(expr.range.start),
                Bracket::Round,
                vec![expr],
                clauses,
            );
            self.operand_start = None;
            found.generator = Some(expr.range);
            found.args.push(expr);
            return;
        }
        match self.kind() {
            Tok::Equal => {
                self.bump();
                let reference = "expression cannot contain assignment, perhaps you meant \"==\"?";
                self.error(
                    expr.range,
                    "only a name is allowed before `=` in a call",
                    reference,
                );
                let value = self.expression();
                let name_range = expr.range;
                found.args.push(expr);
                found.keywords.push(Keyword {
                    name: None,
                    name_range,
                    value,
                });
            }
            Tok::Walrus => {
                self.unexpected("`:=` must follow a name");
                self.bump();
                found.args.push(expr);
            }
            _ => {
                self.note_order(&expr, found);
                found.args.push(expr);
            }
        }
    }

    /// `positional` behind a keyword is reported at the end of the call, as CPython does.
    fn note_order(&self, expr: &Expr, found: &mut ArgumentList) {
        let broken = matches!(expr.kind, ExprKind::Missing) || self.report.len() > found.mark;
        if found.keywords.is_empty() || found.misplaced.is_some() || broken {
            return;
        }
        found.misplaced = Some((
            expr.range,
            if found.unpacking {
                "positional argument follows keyword argument unpacking"
            } else {
                "positional argument follows keyword argument"
            },
        ));
    }

    fn check_order(&mut self, found: &ArgumentList) {
        let Some((range, reference)) = found.misplaced else {
            return;
        };
        match self.report.plain_since(found.mark) {
            Some(index) => self.reword(index, range.start, reference),
            None => self.error(
                range,
                "positional arguments must come before keyword arguments",
                reference,
            ),
        }
    }

    fn check_repeated(&mut self, keywords: &[Keyword]) {
        let mut seen = FastSet::default();
        for keyword in keywords {
            let Some(name) = &keyword.name else { continue };
            if !seen.insert(name) {
                let message = format!("duplicate argument `{name}`");
                let reference = format!("keyword argument repeated: {name}");
                self.report
                    .add(ErrorStage::Tree, keyword.name_range, message, &reference);
            }
        }
    }
}
