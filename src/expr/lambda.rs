//! How the arguments of a call fit a lambda.

use super::args::{Args, plural};
use super::ast::{Param, ParamKind};
use super::stop::{Eval, Stop};
use super::value::{Closure, Dict, DictMap, Key, Str, Tuple, Value};

/// The parameters of a lambda with their values, or the message of a call that does not fit.
pub(super) fn bind_lambda(closure: &Closure, args: Args) -> Eval<Vec<(Str, Value)>> {
    let params = &closure.lambda.params;
    let mut binder = Binder {
        params,
        slots: vec![None; params.len()],
    };
    let rest = binder.positional(args.pos, closure)?;
    let extra = binder.named(args.named)?;
    binder.check_missing(closure)?;
    let mut vars = Vec::with_capacity(params.len());
    let mut rest = Some(rest);
    let mut extra = Some(extra);
    for ((param, slot), default) in params.iter().zip(binder.slots).zip(&closure.defaults) {
        let value = match param.kind {
            ParamKind::VarArgs => {
                Value::Tuple(Tuple::new(rest.take().into_iter().flatten().collect()))
            }
            ParamKind::VarKeywords => {
                let entries = extra
                    .take()
                    .into_iter()
                    .flatten()
                    .map(|(name, value)| (Key::text(name), value));
                Value::Dict(Dict::new(entries.collect::<DictMap>(), false))
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
        let count = self
            .params
            .iter()
            .filter(|param| Self::is_positional(param))
            .count();
        let takes_rest = self
            .params
            .iter()
            .any(|param| param.kind == ParamKind::VarArgs && !param.name.is_empty());
        if given.len() > count && !takes_rest {
            return Err(self.too_many(given.len(), count, closure));
        }
        let rest = given.split_off(count.min(given.len()));
        let places = self
            .params
            .iter()
            .zip(&mut self.slots)
            .filter(|(param, _)| Self::is_positional(param));
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
        let takes = if defaults > 0 {
            format!("from {} to {count}", count - defaults)
        } else {
            count.to_string()
        };
        let plural = if count == 1 && defaults == 0 { "" } else { "s" };
        let was = if given == 1 { "was" } else { "were" };
        Stop::typ(format!(
            "<lambda>() takes {takes} positional argument{plural} but {given} {was} given"
        ))
    }

    /// Fill parameters by name; gives what `**kwargs` takes.
    fn named(&mut self, named: Vec<(Str, Value)>) -> Eval<Vec<(Str, Value)>> {
        let takes_rest = self
            .params
            .iter()
            .any(|param| param.kind == ParamKind::VarKeywords);
        let mut extra = Vec::new();
        let mut wrong = Vec::new();
        for (name, value) in named {
            let place = self.params.iter().position(|param| {
                param.name == name
                    && matches!(param.kind, ParamKind::Normal | ParamKind::KeywordOnly)
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
                return Err(Stop::typ(format!(
                    "<lambda>() got multiple values for argument '{name}'"
                )));
            }
        }
        match wrong.first() {
            None => Ok(extra),
            Some(name) => Err(self.unexpected(name, &wrong)),
        }
    }

    fn unexpected(&self, name: &Str, wrong: &[Str]) -> Stop {
        let positional_only = |name: &&Str| {
            self.params
                .iter()
                .any(|param| param.kind == ParamKind::PositionalOnly && param.name == **name)
        };
        let clashing: Vec<&str> = wrong
            .iter()
            .filter(positional_only)
            .map(Str::as_str)
            .collect();
        if clashing.is_empty() {
            return Stop::typ(format!(
                "<lambda>() got an unexpected keyword argument '{name}'"
            ));
        }
        let names = clashing.join(", ");
        Stop::typ(format!(
            "<lambda>() got some positional-only arguments passed as keyword arguments: '{names}'"
        ))
    }

    /// The parameters without a value, in quotes: those by keyword, or those by position.
    fn missing(&self, closure: &Closure, keyword: bool) -> Vec<String> {
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
            .collect()
    }

    fn check_missing(&self, closure: &Closure) -> Eval<()> {
        for (names, kind) in [
            (self.missing(closure, false), "positional"),
            (self.missing(closure, true), "keyword-only"),
        ] {
            if !names.is_empty() {
                let (count, names) = (names.len(), enumeration(&names));
                let plural = plural(count);
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
