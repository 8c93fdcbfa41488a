//! Calls: evaluation of arguments, lambdas, and everything else that can be called.

use std::sync::Arc;

use super::args::{Args, bind};
use super::ast::{Expr, ExprKind, Keyword};
use super::builtins::{self, Function};
use super::interp::Interp;
use super::lambda::bind_lambda;
use super::stop::{Eval, Stop};
use super::value::{Bound, Closure, Str, Type, Value};
use super::{builtins::types, methods};
use base::TextRange;

impl Interp<'_> {
    /// A call node at `range`.
    pub(crate) fn call(
        &mut self,
        range: TextRange,
        func: &Expr,
        args: &[Expr],
        keywords: &[Keyword],
    ) -> Eval {
        if let ExprKind::Attribute { value, name, .. } = &func.kind {
            let object = self.eval(value)?;
            // The common case needs no method object.
            if let Some(function) = methods::find(&object, name) {
                let args = self.arguments(func, args, keywords)?;
                self.at = self.place(range);
                return self.invoke(function, &object, args);
            }
            let callee = self.attribute_of(func, &object)?;
            return self.call_with(range, func, callee, args, keywords);
        }
        let callee = self.eval(func)?;
        self.call_with(range, func, callee, args, keywords)
    }

    /// The attribute node `func`, whose object is evaluated already.
    fn attribute_of(&mut self, func: &Expr, object: &Value) -> Eval {
        let ExprKind::Attribute {
            name, name_range, ..
        } = &func.kind
        else {
            return Ok(Value::Unknown);
        };
        let place = self.place(*name_range);
        match self.attribute(object, name, place) {
            Err(Stop::Unknown) => Ok(Value::Unknown),
            result => result.map_err(|stop| stop.at(place)),
        }
    }

    fn call_with(
        &mut self,
        range: TextRange,
        func: &Expr,
        callee: Value,
        args: &[Expr],
        keywords: &[Keyword],
    ) -> Eval {
        let args = self.arguments(func, args, keywords)?;
        self.at = self.place(range);
        self.apply_args(&callee, args)
    }

    fn arguments(&mut self, func: &Expr, exprs: &[Expr], keywords: &[Keyword]) -> Eval<Args> {
        let mut args = Args {
            pos: Vec::with_capacity(exprs.len()),
            named: Vec::new(),
        };
        for expr in exprs {
            match &expr.kind {
                ExprKind::Starred(inner) => self.star_argument(func, inner, &mut args)?,
                _ => args.pos.push(self.eval(expr)?),
            }
        }
        for keyword in keywords {
            let value = self.eval(&keyword.value)?;
            match &keyword.name {
                Some(name) => add_named(&mut args, func, name.clone(), value)?,
                None => self.double_star(func, &value, &mut args)?,
            }
        }
        Ok(args)
    }

    fn star_argument(&mut self, func: &Expr, inner: &Expr, args: &mut Args) -> Eval<()> {
        let value = self.eval(inner)?.known()?;
        if self.iter(&value).is_err() {
            let (what, kind) = (callee_name(func), value.type_name());
            return Err(Stop::typ(format!(
                "{what} argument after * must be an iterable, not {kind}"
            )));
        }
        args.pos.extend(self.collect(&value)?);
        Ok(())
    }

    fn double_star(&mut self, func: &Expr, value: &Value, args: &mut Args) -> Eval<()> {
        let Some(dict) = self.mapping(value)? else {
            if value.is_unknown() {
                return Err(Stop::Unknown);
            }
            let (what, kind) = (callee_name(func), value.type_name());
            return Err(Stop::typ(format!(
                "{what} argument after ** must be a mapping, not {kind}"
            )));
        };
        for (key, value) in dict.entries() {
            match key {
                Value::Str(name) => add_named(args, func, name, value)?,
                _ => return Err(Stop::typ("keywords must be strings")),
            }
        }
        Ok(())
    }

    /// Call `callee` with positional arguments.
    pub(crate) fn apply(&mut self, callee: &Value, args: Vec<Value>) -> Eval {
        self.apply_args(
            callee,
            Args {
                pos: args,
                named: Vec::new(),
            },
        )
    }

    /// Call `callee`.
    pub(crate) fn apply_args(&mut self, callee: &Value, args: Args) -> Eval {
        match callee {
            Value::Unknown => Err(Stop::Unknown),
            Value::Lambda(closure) => self.call_lambda(closure, args),
            Value::Builtin(builtin) => {
                if let Some(namespace) = builtin.deprecated {
                    self.host
                        .deprecated(builtin.function.name, namespace, self.at);
                }
                self.invoke(builtin.function, &Value::None, args)
            }
            Value::Method(bound) if bound.unbound => self.call_unbound(bound, args),
            Value::Method(bound) => self.invoke(bound.function, &bound.receiver, args),
            Value::Type(kind) => {
                // An entry may be unknown, but not what a conversion looks at.
                let entries = kind.is_subclass(Type::Dict) || *kind == Type::YamlDict;
                if args.pos.iter().any(Value::is_unknown) || (args.has_unknown() && !entries) {
                    return Err(Stop::Unknown);
                }
                types::construct(self, *kind, args)
            }
            other => Err(Stop::typ(format!(
                "'{}' object is not callable",
                other.type_name()
            ))),
        }
    }

    fn invoke(&mut self, function: &'static Function, receiver: &Value, args: Args) -> Eval {
        if args.has_unknown() && !function.stores_unknown() {
            return Err(Stop::Unknown);
        }
        let args = bind(function, receiver, args)?;
        (function.run)(self, receiver, &args)
    }

    /// `str.upper(s)`
    fn call_unbound(&mut self, bound: &Bound, mut args: Args) -> Eval {
        let Bound {
            receiver, function, ..
        } = bound;
        let Value::Type(kind) = receiver else {
            return Err(Stop::Unknown);
        };
        let (name, owner) = (function.name, kind.name());
        if args.pos.is_empty() {
            return Err(Stop::typ(format!(
                "unbound method {owner}.{name}() needs an argument"
            )));
        }
        let object = args.pos.remove(0).known()?;
        if !Type::of(&object).is_subclass(*kind) {
            let got = object.type_name();
            return Err(Stop::typ(format!(
                "descriptor '{name}' for '{owner}' objects doesn't apply to a '{got}' object"
            )));
        }
        self.invoke(function, &object, args)
    }

    fn call_lambda(&mut self, closure: &Arc<Closure>, args: Args) -> Eval {
        self.down()?;
        self.budget.step()?;
        let result = match bind_lambda(closure, args) {
            Ok(vars) => {
                let context = Interp::closure_context(closure, vars);
                self.inside(context, |interp| interp.eval(&closure.lambda.body))
            }
            Err(stop) => Err(stop),
        };
        self.up();
        result
    }
}

/// `f()` or `s.f()` as messages name the function called.
fn callee_name(func: &Expr) -> String {
    match &func.kind {
        ExprKind::Name(name) => match builtins::global(name) {
            Some(Value::Builtin(builtin)) if builtin.deprecated.is_none() => {
                builtin.function.qualified_name(&Value::None)
            }
            Some(Value::Builtin(_)) => {
                "xacro.create_global_symbols.<locals>.deprecate.<locals>.wrapper".to_owned()
            }
            _ => format!("{name}()"),
        },
        ExprKind::Attribute { name, .. } => format!("{name}()"),
        _ => "<lambda>()".to_owned(),
    }
}

fn add_named(args: &mut Args, func: &Expr, name: Str, value: Value) -> Eval<()> {
    if args.named.iter().any(|(given, _)| *given == name) {
        let what = callee_name(func);
        return Err(Stop::typ(format!(
            "{what} got multiple values for keyword argument '{name}'"
        )));
    }
    args.named.push((name, value));
    Ok(())
}
