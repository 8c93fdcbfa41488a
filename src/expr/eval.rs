//! Evaluation of the nodes of an expression.

use std::sync::Arc;

use ecow::EcoVec;

use super::ast::{BinOp, CmpOp, Const, Expr, ExprKind, Lambda, UnaryOp};
use super::format;
use super::host::ErrorKind;
use super::interp::Interp;
use super::ops;
use super::stop::{Eval, Stop};
use super::value::{Closure, Dict, DictMap, Key, List, Set, SetMap, Slice, Tuple, Value};
use base::TextRange;

impl Interp<'_> {
    /// The value of a node. A node with an unknown operand is unknown.
    pub(crate) fn eval(&mut self, expr: &Expr) -> Eval {
        self.budget.step()?;
        match &expr.kind {
            ExprKind::Name(name) => self.name(name, expr.range),
            ExprKind::Const(value) => Ok(constant(value)),
            _ => {
                self.down()?;
                let result = self.node(expr);
                self.up();
                match result {
                    Err(Stop::Unknown) => Ok(Value::Unknown),
                    Err(stop) => Err(stop.at(self.place(expr.range))),
                    value => value,
                }
            }
        }
    }

    fn node(&mut self, expr: &Expr) -> Eval {
        match &expr.kind {
            ExprKind::Binary(op, left, right) => self.binary(*op, left, right),
            ExprKind::Attribute {
                value,
                name,
                name_range,
            } => {
                let value = self.eval(value)?;
                let place = self.place(*name_range);
                self.attribute(&value, name, place)
                    .map_err(|stop| stop.at(place))
            }
            ExprKind::Call {
                func,
                args,
                keywords,
            } => self.call(expr.range, func, args, keywords),
            ExprKind::Subscript { value, index } => self.subscript(value, index),
            ExprKind::Compare(first, rest) => self.compare(first, rest),
            ExprKind::IfElse { test, body, orelse } => {
                let test = self.eval(test)?;
                if self.truth(&test)? {
                    self.eval(body)
                } else {
                    self.eval(orelse)
                }
            }
            ExprKind::And(items) => self.short_circuit(items, false),
            ExprKind::Or(items) => self.short_circuit(items, true),
            ExprKind::Unary(op, operand) => self.unary(*op, operand),
            ExprKind::Name(name) => self.name(name, expr.range),
            ExprKind::Const(value) => Ok(constant(value)),
            ExprKind::Missing => Ok(Value::Unknown),
            other => self.display(other),
        }
    }

    /// Displays, functions and the rarer nodes.
    fn display(&mut self, kind: &ExprKind) -> Eval {
        match kind {
            ExprKind::List(items) => Ok(Value::List(List::new(self.items(items)?, false))),
            ExprKind::Tuple(items) => Ok(Value::Tuple(Tuple::new(self.items(items)?))),
            ExprKind::Set(items) => self.set_display(items),
            ExprKind::Dict(entries) => self.dict_display(entries),
            ExprKind::Slice { lower, upper, step } => self.slice(lower, upper, step),
            ExprKind::Lambda(lambda) => self.lambda(lambda),
            ExprKind::Comprehension(comprehension) => self.comprehension(comprehension),
            ExprKind::FString(parts) => Ok(Value::Str(format::fstring(self, parts)?)),
            ExprKind::NamedExpr { name, value, .. } => {
                let value = self.eval(value)?;
                self.bind(name, value.clone());
                Ok(value)
            }
            _ => Err(Stop::new(
                ErrorKind::Syntax,
                "can't use starred expression here (<expression>, line 1)",
            )),
        }
    }

    fn binary(&mut self, op: BinOp, left: &Expr, right: &Expr) -> Eval {
        let a = self.eval(left)?;
        let b = self.eval(right)?;
        let result = ops::binary(self, op, &a, &b);
        match result {
            // The divisor is to blame.
            Err(stop) if stop.is(&ErrorKind::ZeroDivision) => Err(stop.at(self.place(right.range))),
            other => other,
        }
    }

    fn unary(&mut self, op: UnaryOp, operand: &Expr) -> Eval {
        let value = self.eval(operand)?;
        match op {
            UnaryOp::Not => Ok(Value::Bool(!self.truth(&value)?)),
            op => ops::unary(op, &value),
        }
    }

    fn short_circuit(&mut self, items: &[Expr], stop_at: bool) -> Eval {
        let mut last = Value::Unknown;
        for (i, item) in items.iter().enumerate() {
            last = self.eval(item)?;
            if i + 1 < items.len() && self.truth(&last)? == stop_at {
                break;
            }
        }
        Ok(last)
    }

    fn compare(&mut self, first: &Expr, rest: &[(CmpOp, Expr)]) -> Eval {
        let mut left = self.eval(first)?;
        let mut from = first.range;
        let mut result = Value::Unknown;
        for (i, (op, expr)) in rest.iter().enumerate() {
            let right = self.eval(expr)?;
            let place = self.place(TextRange::new(from.start, expr.range.end));
            let holds = ops::compare(self, *op, &left, &right).map_err(|stop| stop.at(place))?;
            result = Value::Bool(holds);
            if !holds || i + 1 == rest.len() {
                break;
            }
            (left, from) = (right, expr.range);
        }
        Ok(result)
    }

    fn subscript(&mut self, value: &Expr, index: &Expr) -> Eval {
        let object = self.eval(value)?;
        let key = self.eval(index)?;
        let result = ops::subscript(self, &object, &key);
        result.map_err(|stop| match stop {
            Stop::Raise(error)
                if matches!(
                    error.kind,
                    ErrorKind::Index | ErrorKind::Key | ErrorKind::YamlKey
                ) =>
            {
                Stop::Raise(error).at(self.place(index.range))
            }
            other => other,
        })
    }

    /// The items of a display, `*x` spread out.
    fn items(&mut self, exprs: &[Expr]) -> Eval<EcoVec<Value>> {
        self.budget.items(exprs.len() as u128 + 2)?;
        let mut items = EcoVec::with_capacity(exprs.len());
        for expr in exprs {
            match &expr.kind {
                ExprKind::Starred(inner) => self.spread(inner, &mut |item| items.push(item))?,
                _ => items.push(self.eval(expr)?),
            }
        }
        Ok(items)
    }

    /// Hand the items of `*inner` to `each`.
    pub(crate) fn spread(&mut self, inner: &Expr, each: &mut dyn FnMut(Value)) -> Eval<()> {
        let value = self.eval(inner)?;
        let mut cursor = self.iter(&value).map_err(|stop| match stop {
            Stop::Unknown => Stop::Unknown,
            _ => {
                let kind = value.type_name();
                Stop::typ(format!("Value after * must be an iterable, not {kind}"))
                    .at(self.place(inner.range))
            }
        })?;
        while let Some(item) = self.next(&mut cursor)? {
            self.budget.items(1)?;
            each(item);
        }
        Ok(())
    }

    fn set_display(&mut self, exprs: &[Expr]) -> Eval {
        let items = self.items(exprs)?;
        let set = items.into_iter().map(Key::new).collect::<Eval<SetMap>>()?;
        Ok(Value::Set(Set::new(set, false)))
    }

    fn dict_display(&mut self, entries: &[(Option<Expr>, Expr)]) -> Eval {
        /// So many entries are evaluated before the first of their keys is hashed, as in CPython.
        const AT_ONCE: usize = 16;
        let mut map = DictMap::default();
        let mut waiting: Vec<(Value, Value)> = Vec::new();
        for (key, value) in entries {
            match key {
                Some(key) => {
                    waiting.push((self.eval(key)?, self.eval(value)?));
                    if waiting.len() == AT_ONCE {
                        enter(&mut waiting, &mut map)?;
                    }
                }
                None => {
                    enter(&mut waiting, &mut map)?;
                    let other = self.eval(value)?.known()?;
                    let Some(entries) = self.mapping(&other)? else {
                        let message = format!("'{}' object is not a mapping", other.type_name());
                        return Err(Stop::typ(message));
                    };
                    map.extend(
                        entries
                            .snapshot()
                            .iter()
                            .map(|(k, v)| (k.clone(), v.clone())),
                    );
                }
            }
        }
        enter(&mut waiting, &mut map)?;
        Ok(Value::Dict(Dict::new(map, false)))
    }

    fn slice(
        &mut self,
        lower: &Option<Box<Expr>>,
        upper: &Option<Box<Expr>>,
        step: &Option<Box<Expr>>,
    ) -> Eval {
        let slice = Slice {
            start: self.slice_part(lower)?,
            stop: self.slice_part(upper)?,
            step: self.slice_part(step)?,
        };
        Ok(Value::Slice(Arc::new(slice)))
    }

    fn slice_part(&mut self, expr: &Option<Box<Expr>>) -> Eval {
        match expr {
            Some(expr) => self.eval(expr)?.known(),
            None => Ok(Value::None),
        }
    }

    fn lambda(&mut self, lambda: &Arc<Lambda>) -> Eval {
        // About the size of the function object.
        self.budget.items(lambda.params.len() as u128 + 4)?;
        let mut defaults = Vec::with_capacity(lambda.params.len());
        for param in &lambda.params {
            defaults.push(match &param.default {
                Some(expr) => Some(self.eval(expr)?),
                None => None,
            });
        }
        let context = self.context();
        Ok(Value::Lambda(Arc::new(Closure {
            lambda: Arc::clone(lambda),
            defaults,
            env: context.env,
            home: context.home,
            scope: context.scope,
        })))
    }
}

fn constant(value: &Const) -> Value {
    match value {
        Const::None => Value::None,
        Const::Ellipsis => Value::Ellipsis,
        Const::Bool(b) => Value::Bool(*b),
        Const::Int(i) => Value::Int(*i),
        Const::Big(big) => Value::int(big.clone()),
        Const::Float(f) => Value::Float(*f),
        Const::Imaginary(f) => Value::Complex(0.0, *f),
        Const::Str(text) => Value::Str(text.clone()),
        Const::Bytes(bytes) => Value::Bytes(bytes.iter().copied().collect()),
    }
}

/// Put evaluated entries into a dict.
fn enter(waiting: &mut Vec<(Value, Value)>, map: &mut DictMap) -> Eval<()> {
    for (key, value) in waiting.drain(..) {
        map.insert(Key::new(key)?, value);
    }
    Ok(())
}
