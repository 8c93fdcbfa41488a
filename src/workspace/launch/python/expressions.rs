//! Values of expressions.

use base::TextRange;
use base::limits::LAUNCH_DEPTH;
use expr::ast::{BinOp, Const, Expr, ExprKind, FPart, Keyword};
use expr::{ExprErrorKind, parse};

use super::PythonReader;
use super::value::PythonValue;
use crate::launch::text::Text;

impl PythonReader<'_> {
    /// The value of the expression in a range of the file.
    pub(super) fn value_at(&mut self, range: TextRange) -> PythonValue {
        let code = range.slice(self.text);
        if !self.spend(code.len() / 32 + 1) {
            return PythonValue::Unknown;
        }
        let parsed = parse(code);
        // of broken text, no value is certain; words of the language that are no expression give none either
        if parsed
            .errors
            .iter()
            .any(|error| error.kind == ExprErrorKind::Syntax)
        {
            return PythonValue::Unknown;
        }
        let outer = std::mem::replace(&mut self.base, range.start);
        let value = self.value(&parsed.expr);
        self.base = outer;
        value
    }

    pub(super) fn value(&mut self, expr: &Expr) -> PythonValue {
        if self.depth >= LAUNCH_DEPTH * 4 || !self.spend(1) {
            return PythonValue::Unknown;
        }
        self.depth += 1;
        let value = self.value_of(expr);
        self.depth -= 1;
        if let (Some(noticed), PythonValue::Text(text)) = (&mut self.noticed, &value) {
            text.arguments(&mut |name| noticed.push(name.to_owned()));
        }
        if self.spend(value.weight() / 4) {
            value
        } else {
            PythonValue::Unknown
        }
    }

    fn value_of(&mut self, expr: &Expr) -> PythonValue {
        match &expr.kind {
            ExprKind::Name(name) if name == "__file__" => {
                PythonValue::plain(vfs::slashed(self.path))
            }
            ExprKind::Name(name) => self
                .scopes
                .get(name)
                .cloned()
                .unwrap_or_else(|| PythonValue::Outer(name.clone())),
            ExprKind::Const(literal) => self.literal(literal, expr.range),
            ExprKind::FString(parts) => self.formatted(parts),
            ExprKind::Binary(BinOp::Add, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                added(a, b)
            }
            ExprKind::Binary(BinOp::Div, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                match (a, b) {
                    (PythonValue::Text(a), PythonValue::Text(b)) => {
                        PythonValue::Text(Text::joined([a, b]))
                    }
                    (PythonValue::Text(a), PythonValue::List(b)) => {
                        PythonValue::Text(Text::joined([a, PythonValue::List(b).text()]))
                    }
                    _ => PythonValue::Unknown,
                }
            }
            ExprKind::Binary(BinOp::BitOr, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                let (PythonValue::Dict { mut pairs, open }, PythonValue::Dict { .. }) = (a, &b)
                else {
                    return PythonValue::Unknown;
                };
                let open = PythonValue::spread(&mut pairs, b) || open;
                PythonValue::Dict { pairs, open }
            }
            ExprKind::Binary(BinOp::Mod, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                super::methods::percent(a, b)
            }
            ExprKind::IfElse { test, body, orelse } => self.choice(test, body, orelse),
            ExprKind::List(items) | ExprKind::Tuple(items) => self.list(items),
            ExprKind::Dict(pairs) => self.dict(pairs),
            ExprKind::Attribute { value, name, .. } => {
                let value = self.value(value);
                super::methods::attribute(value, name)
            }
            ExprKind::Subscript { value, index } => {
                let (value, index) = (self.value(value), self.value(index));
                super::methods::item(value, &index)
            }
            ExprKind::Call {
                func,
                args,
                keywords,
            } => self.called(expr, func, args, keywords),
            ExprKind::NamedExpr { name, value, .. } => {
                let value = self.value(value);
                self.scopes.set(name, value.clone());
                value
            }
            ExprKind::Comprehension(comprehension) => {
                for clause in &comprehension.clauses {
                    self.value(&clause.iter);
                    self.forget_targets(&clause.target);
                }
                self.value(&comprehension.element);
                comprehension
                    .value
                    .iter()
                    .for_each(|value| drop(self.value(value)));
                PythonValue::Unknown
            }
            // what a lambda gives depends on who calls it
            ExprKind::Lambda(lambda) => {
                let before = self.scopes.own();
                lambda
                    .params
                    .iter()
                    .for_each(|param| self.scopes.set(&param.name, PythonValue::Unknown));
                self.value(&lambda.body);
                self.scopes.replace(before);
                PythonValue::Unknown
            }
            _ => {
                expr::visit::children(expr, &mut |child| drop(self.value(child)));
                PythonValue::Unknown
            }
        }
    }

    fn forget_targets(&mut self, target: &Expr) {
        if let ExprKind::Name(name) = &target.kind {
            self.scopes.set(name, PythonValue::Unknown);
        }
        expr::visit::children(target, &mut |child| self.forget_targets(child));
    }

    fn literal(&self, literal: &Const, range: TextRange) -> PythonValue {
        match literal {
            Const::None => PythonValue::None,
            Const::Bool(true) => PythonValue::Number("True".to_owned()),
            Const::Bool(false) => PythonValue::Number("False".to_owned()),
            Const::Int(number) => PythonValue::Number(number.to_string()),
            Const::Float(number) if (1e-4..1e16).contains(&number.abs()) || *number == 0.0 => {
                PythonValue::Number(format!("{number:?}"))
            }
            Const::Str(text) => {
                PythonValue::Text(Text::plain(&**text, Some(range.shift(self.base))))
            }
            _ => PythonValue::Unknown,
        }
    }

    /// `a if test else b`
    fn choice(&mut self, test: &Expr, body: &Expr, orelse: &Expr) -> PythonValue {
        let outer = self.noticed.replace(Vec::new());
        self.value(test);
        let test = std::mem::replace(&mut self.noticed, outer).unwrap_or_default();
        let assumed = self.assumed.len();
        self.assumed.extend(test);
        let (body, orelse) = (self.value(body), self.value(orelse));
        self.assumed.truncate(assumed);
        body.join(orelse)
    }

    fn formatted(&mut self, parts: &[FPart]) -> PythonValue {
        let mut text = Text::default();
        for part in parts {
            match part {
                FPart::Text(plain) => text.push(Text::plain(&**plain, None)),
                FPart::Field {
                    value,
                    conversion,
                    spec,
                    debug,
                } => {
                    let value = self.value(value);
                    let is_plain = spec.is_empty()
                        && debug.is_none()
                        && matches!(conversion, None | Some('s'));
                    text.push(if is_plain {
                        value.written()
                    } else {
                        Text::opaque()
                    });
                }
            }
        }
        PythonValue::Text(text)
    }

    fn list(&mut self, items: &[Expr]) -> PythonValue {
        let mut values = Vec::new();
        for item in items {
            match &item.kind {
                ExprKind::Starred(inner) => match self.value(inner) {
                    PythonValue::List(inner) => values.extend(inner),
                    _ => values.push(PythonValue::Unknown),
                },
                _ => values.push(self.value(item)),
            }
        }
        PythonValue::List(values)
    }

    fn dict(&mut self, entries: &[(Option<Expr>, Expr)]) -> PythonValue {
        let (mut pairs, mut open) = (Vec::new(), false);
        for (key, value) in entries {
            let key = key.as_ref().map(|key| self.value(key));
            let value = self.value(value);
            match key {
                None => open |= PythonValue::spread(&mut pairs, value),
                Some(PythonValue::Text(key)) if key.literal().is_some() => {
                    PythonValue::set(&mut pairs, key.literal().unwrap_or_default(), value);
                }
                Some(PythonValue::Number(key)) => PythonValue::set(&mut pairs, key, value),
                Some(_) => {
                    PythonValue::forget(&mut pairs);
                    open = true;
                }
            }
        }
        PythonValue::Dict { pairs, open }
    }

    /// A call: its arguments are read in any case, since they may call xacro themselves.
    fn called(
        &mut self,
        call: &Expr,
        func: &Expr,
        args: &[Expr],
        keywords: &[Keyword],
    ) -> PythonValue {
        let assumed = self.assumed.len();
        let condition = keywords
            .iter()
            .find(|keyword| keyword.name.as_deref() == Some("condition"));
        if let Some(condition) = condition {
            let outer = self.noticed.replace(Vec::new());
            self.value(&condition.value);
            let test = std::mem::replace(&mut self.noticed, outer).unwrap_or_default();
            self.assumed.extend(test);
        }
        let target = self.value(func);
        let positional = match self.list(args) {
            PythonValue::List(values) => values,
            _ => Vec::new(),
        };
        let has_star = args
            .iter()
            .any(|arg| matches!(arg.kind, ExprKind::Starred(_)));
        let mut named = Vec::new();
        for keyword in keywords {
            let value = self.value(&keyword.value);
            match &keyword.name {
                Some(name) => named.push((name.to_string(), value)),
                None => match value {
                    PythonValue::Dict { pairs, open } => {
                        named.extend(pairs);
                        if open {
                            named.push(("**".to_owned(), PythonValue::Unknown));
                        }
                    }
                    _ => named.push(("**".to_owned(), PythonValue::Unknown)),
                },
            }
        }
        if has_star
            && positional
                .iter()
                .any(|value| matches!(value, PythonValue::Unknown))
        {
            named.push(("**".to_owned(), PythonValue::Unknown));
        }
        let range = call.range.shift(self.base);
        let value = match target {
            PythonValue::Function(number) => self.call(number, positional, named),
            PythonValue::Outer(path) => self.outer(range, &path, positional, named),
            PythonValue::Method(value, name) => {
                self.change_by_method(func, &name, &positional);
                self.method(range, *value, &name, positional, named)
            }
            _ => PythonValue::Unknown,
        };
        self.assumed.truncate(assumed);
        value
    }

    /// `x.append(y)` and the like change the variable.
    fn change_by_method(&mut self, func: &Expr, method: &str, args: &[PythonValue]) {
        let ExprKind::Attribute { value, .. } = &func.kind else {
            return;
        };
        let ExprKind::Name(name) = &value.kind else {
            return;
        };
        if ![
            "append",
            "extend",
            "insert",
            "update",
            "setdefault",
            "pop",
            "remove",
            "clear",
            "sort",
            "reverse",
        ]
        .contains(&method)
        {
            return;
        }
        let first = args.first().cloned().unwrap_or_default();
        let only = args.len() == 1;
        self.change(name, |old| match (old, method) {
            (PythonValue::List(mut list), "append") if only => {
                list.push(first);
                PythonValue::List(list)
            }
            (PythonValue::List(mut list), "extend") if only => match first {
                PythonValue::List(more) => {
                    list.extend(more);
                    PythonValue::List(list)
                }
                _ => PythonValue::Unknown,
            },
            (PythonValue::Dict { mut pairs, open }, "update") if only => {
                let open = PythonValue::spread(&mut pairs, first) || open;
                PythonValue::Dict { pairs, open }
            }
            _ => PythonValue::Unknown,
        });
    }
}

/// `a + b`
fn added(a: PythonValue, b: PythonValue) -> PythonValue {
    match (a, b) {
        (PythonValue::Text(mut a), PythonValue::Text(b)) => {
            a.push(b);
            PythonValue::Text(a)
        }
        (PythonValue::List(mut a), PythonValue::List(b)) => {
            a.extend(b);
            PythonValue::List(a)
        }
        (PythonValue::Text(mut a), PythonValue::Unknown) => {
            a.push(Text::opaque());
            PythonValue::Text(a)
        }
        (PythonValue::Unknown, PythonValue::Text(b)) => {
            PythonValue::Text(Text::concat([Text::opaque(), b]))
        }
        _ => PythonValue::Unknown,
    }
}
