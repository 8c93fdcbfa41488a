//! Calls: evaluation of arguments, lambdas, and everything else that can be called.

use std::sync::Arc;

use super::args::{Args, bind};
use super::ast::{Expr, ExprKind, Keyword, Param, ParamKind};
use super::builtins::{self, Function};
use super::interp::Interp;
use super::stop::{Eval, Stop};
use super::value::{Bound, Closure, DictMap, Key, Str, Tuple, Value};
use super::{builtins::types, methods};
use crate::base::TextRange;

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
        let ExprKind::Attribute { name, name_range, .. } = &func.kind else { return Ok(Value::Unknown) };
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
        let mut args = Args { pos: Vec::with_capacity(exprs.len()), named: Vec::new() };
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
            return Err(Stop::typ(format!("{what} argument after * must be an iterable, not {kind}")));
        }
        args.pos.extend(self.collect(&value)?);
        Ok(())
    }

    fn double_star(&mut self, func: &Expr, value: &Value, args: &mut Args) -> Eval<()> {
        let Value::Dict(dict) = value else {
            if value.is_unknown() {
                return Err(Stop::Unknown);
            }
            let (what, kind) = (callee_name(func), value.type_name());
            return Err(Stop::typ(format!("{what} argument after ** must be a mapping, not {kind}")));
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
        self.apply_args(callee, Args { pos: args, named: Vec::new() })
    }

    /// Call `callee`.
    pub(crate) fn apply_args(&mut self, callee: &Value, args: Args) -> Eval {
        match callee {
            Value::Unknown => Err(Stop::Unknown),
            Value::Lambda(closure) => self.call_lambda(closure, args),
            Value::Builtin(builtin) => {
                if let Some(namespace) = builtin.deprecated {
                    self.host.deprecated(builtin.function.name, namespace, self.at);
                }
                self.invoke(builtin.function, &Value::None, args)
            }
            Value::Method(bound) if bound.unbound => self.call_unbound(bound, args),
            Value::Method(bound) => self.invoke(bound.function, &bound.receiver, args),
            Value::Type(kind) => {
                if args.has_unknown() {
                    return Err(Stop::Unknown);
                }
                types::construct(self, *kind, args)
            }
            other => Err(Stop::typ(format!("'{}' object is not callable", other.type_name()))),
        }
    }

    fn invoke(&mut self, function: &'static Function, receiver: &Value, args: Args) -> Eval {
        if args.has_unknown() && !function.stores_unknown() {
            return Err(Stop::Unknown);
        }
        let args = bind(function, args)?;
        (function.run)(self, receiver, &args)
    }

    /// `str.upper(s)`
    fn call_unbound(&mut self, bound: &Bound, mut args: Args) -> Eval {
        let Bound { receiver, function, .. } = bound;
        let Value::Type(kind) = receiver else { return Err(Stop::Unknown) };
        let (name, owner) = (function.name, kind.name());
        if args.pos.is_empty() {
            return Err(Stop::typ(format!("unbound method {owner}.{name}() needs an argument")));
        }
        let object = args.pos.remove(0).known()?;
        if !super::value::Type::of(&object).is_subclass(*kind) {
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
                builtin.function.qualified_name()
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
        return Err(Stop::typ(format!("{what} got multiple values for keyword argument '{name}'")));
    }
    args.named.push((name, value));
    Ok(())
}

/// The parameters of a lambda with their values, or the message of a call that does not fit.
fn bind_lambda(closure: &Closure, args: Args) -> Eval<Vec<(Str, Value)>> {
    let params = &closure.lambda.params;
    let mut binder = Binder { params, slots: vec![None; params.len()] };
    let rest = binder.positional(args.pos, closure)?;
    let extra = binder.named(args.named)?;
    binder.check_missing(closure)?;
    let mut vars = Vec::with_capacity(params.len());
    let mut rest = Some(rest);
    let mut extra = Some(extra);
    for ((param, slot), default) in params.iter().zip(binder.slots).zip(&closure.defaults) {
        let value = match param.kind {
            ParamKind::VarArgs => Value::Tuple(Tuple::new(rest.take().into_iter().flatten().collect())),
            ParamKind::VarKeywords => {
                let entries =
                    extra.take().into_iter().flatten().map(|(name, value)| (Key::text(name), value));
                Value::Dict(super::value::Dict::new(entries.collect::<DictMap>(), false))
            }
            _ => slot.or_else(|| default.clone()).unwrap_or_default(),
        };
        if !param.name.is_empty() {
            vars.push((param.name.clone(), value));
        }
    }
    Ok(vars)
}

struct Binder<'a> {
    params: &'a [Param],
    slots: Vec<Option<Value>>,
}

impl Binder<'_> {
    fn is_positional(param: &Param) -> bool {
        matches!(param.kind, ParamKind::PositionalOnly | ParamKind::Normal)
    }

    /// Fill the positional parameters; gives what `*args` takes.
    fn positional(&mut self, mut given: Vec<Value>, closure: &Closure) -> Eval<Vec<Value>> {
        let count = self.params.iter().filter(|param| Self::is_positional(param)).count();
        let takes_rest =
            self.params.iter().any(|param| param.kind == ParamKind::VarArgs && !param.name.is_empty());
        if given.len() > count && !takes_rest {
            return Err(self.too_many(given.len(), count, closure));
        }
        let rest = given.split_off(count.min(given.len()));
        let places = self.params.iter().zip(&mut self.slots).filter(|(param, _)| Self::is_positional(param));
        for ((_, slot), value) in places.zip(given) {
            *slot = Some(value);
        }
        Ok(rest)
    }

    fn too_many(&self, given: usize, count: usize, closure: &Closure) -> Stop {
        let defaults = self
            .params
            .iter()
            .zip(&closure.defaults)
            .filter(|(param, default)| Self::is_positional(param) && default.is_some())
            .count();
        let takes =
            if defaults > 0 { format!("from {} to {count}", count - defaults) } else { count.to_string() };
        let plural = if count == 1 && defaults == 0 { "" } else { "s" };
        let was = if given == 1 { "was" } else { "were" };
        Stop::typ(format!("<lambda>() takes {takes} positional argument{plural} but {given} {was} given"))
    }

    /// Fill parameters by name; gives what `**kwargs` takes.
    fn named(&mut self, named: Vec<(Str, Value)>) -> Eval<Vec<(Str, Value)>> {
        let takes_rest = self.params.iter().any(|param| param.kind == ParamKind::VarKeywords);
        let mut extra = Vec::new();
        let mut wrong = Vec::new();
        for (name, value) in named {
            let place = self.params.iter().position(|param| {
                param.name == name && matches!(param.kind, ParamKind::Normal | ParamKind::KeywordOnly)
            });
            let Some(slot) = place.and_then(|place| self.slots.get_mut(place)) else {
                if takes_rest {
                    extra.push((name, value));
                } else {
                    wrong.push(name);
                }
                continue;
            };
            if slot.replace(value).is_some() {
                return Err(Stop::typ(format!("<lambda>() got multiple values for argument '{name}'")));
            }
        }
        match wrong.first() {
            None => Ok(extra),
            Some(name) => Err(self.unexpected(name, &wrong)),
        }
    }

    fn unexpected(&self, name: &Str, wrong: &[Str]) -> Stop {
        let positional_only = |name: &&Str| {
            self.params.iter().any(|param| param.kind == ParamKind::PositionalOnly && param.name == **name)
        };
        let clashing: Vec<&str> = wrong.iter().filter(positional_only).map(Str::as_str).collect();
        if clashing.is_empty() {
            return Stop::typ(format!("<lambda>() got an unexpected keyword argument '{name}'"));
        }
        let names = clashing.join(", ");
        Stop::typ(format!(
            "<lambda>() got some positional-only arguments passed as keyword arguments: '{names}'"
        ))
    }

    fn check_missing(&self, closure: &Closure) -> Eval<()> {
        let missing = |keyword: bool| {
            let slots = self.params.iter().zip(&self.slots).zip(&closure.defaults);
            slots
                .filter(|((param, slot), default)| {
                    let kind = if keyword {
                        param.kind == ParamKind::KeywordOnly
                    } else {
                        Self::is_positional(param)
                    };
                    kind && slot.is_none() && default.is_none()
                })
                .map(|((param, _), _)| format!("'{}'", param.name))
                .collect::<Vec<_>>()
        };
        for (names, kind) in [(missing(false), "positional"), (missing(true), "keyword-only")] {
            if !names.is_empty() {
                let plural = if names.len() == 1 { "" } else { "s" };
                let (count, names) = (names.len(), enumeration(&names));
                return Err(Stop::typ(format!(
                    "<lambda>() missing {count} required {kind} argument{plural}: {names}"
                )));
            }
        }
        Ok(())
    }
}

/// `'a'`, `'a' and 'b'`, `'a', 'b', and 'c'`
fn enumeration(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [first, second] => format!("{first} and {second}"),
        [most @ .., last] => format!("{}, and {last}", most.join(", ")),
    }
}
