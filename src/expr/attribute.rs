//! `value.name`

use std::sync::Arc;

use super::builtins;
use super::host::{ErrorKind, Lookup};
use super::interp::Interp;
use super::methods;
use super::numeric::Num;
use super::stop::{Eval, Stop};
use super::value::{Bound, Key, Value};
use crate::base::TextRange;

impl Interp<'_> {
    /// `value.name`; `place` is where the name stands.
    pub(crate) fn attribute(&mut self, value: &Value, name: &str, place: TextRange) -> Eval {
        match value {
            Value::Unknown => return Err(Stop::Unknown),
            Value::Module(module) => {
                return match builtins::attribute(*module, name) {
                    Some(value) => Ok(value),
                    None => {
                        self.host.undefined(name, place);
                        Err(Stop::Unknown)
                    }
                };
            }
            Value::Scope(scope) => {
                if let Lookup::Found(value) = self.host.scope_attribute(*scope, name, place) {
                    return Ok(value);
                }
                if let Some(value) = builtins::global(name) {
                    return Ok(value);
                }
                self.host.undefined(name, place);
                return Err(Stop::Unknown);
            }
            _ => {}
        }
        if let Some(function) = methods::find(value, name) {
            let unbound = false;
            return Ok(Value::Method(Arc::new(Bound { receiver: value.clone(), function, unbound })));
        }
        data(value, name).map_or_else(|| missing(value, name), Ok)
    }
}

/// Attributes that are no methods.
fn data(value: &Value, name: &str) -> Option<Value> {
    match (value, name) {
        (Value::Dict(dict), _) if dict.is_yaml() => dict.get(&Key::text(name)).map(Value::wrapped),
        (Value::Range(range), "start") => Some(Value::int(range.start)),
        (Value::Range(range), "stop") => Some(Value::int(range.stop)),
        (Value::Range(range), "step") => Some(Value::int(range.step)),
        (Value::Slice(slice), "start") => Some(slice.start.clone()),
        (Value::Slice(slice), "stop") => Some(slice.stop.clone()),
        (Value::Slice(slice), "step") => Some(slice.step.clone()),
        (Value::Date(date), _) => date_part(date, name),
        (Value::Type(kind), _) => {
            let function = methods::of_type(*kind, name)?;
            Some(Value::Method(Arc::new(Bound { receiver: value.clone(), function, unbound: true })))
        }
        _ => number_part(Num::of(value)?, value, name),
    }
}

fn number_part(number: Num<'_>, value: &Value, name: &str) -> Option<Value> {
    let whole = || match value {
        Value::Bool(b) => Value::Int(i64::from(*b)),
        other => other.clone(),
    };
    match (number, name) {
        (Num::Complex(re, _), "real") => Some(Value::Float(re)),
        (Num::Complex(_, im), "imag") => Some(Value::Float(im)),
        (_, "real") => Some(whole()),
        (Num::Float(_), "imag") => Some(Value::Float(0.0)),
        (Num::Int(_) | Num::Big(_), "imag") => Some(Value::Int(0)),
        (Num::Int(_) | Num::Big(_), "numerator") => Some(whole()),
        (Num::Int(_) | Num::Big(_), "denominator") => Some(Value::Int(1)),
        _ => None,
    }
}

fn date_part(date: &super::value::DateValue, name: &str) -> Option<Value> {
    let number = match (name, date.time) {
        ("year", _) => i64::from(date.date.0),
        ("month", _) => i64::from(date.date.1),
        ("day", _) => i64::from(date.date.2),
        ("hour", Some(time)) => i64::from(time.0),
        ("minute", Some(time)) => i64::from(time.1),
        ("second", Some(time)) => i64::from(time.2),
        ("microsecond", Some(time)) => i64::from(time.3),
        _ => return None,
    };
    Some(Value::Int(number))
}

fn missing(value: &Value, name: &str) -> Eval {
    Err(match value {
        Value::Dict(dict) if dict.is_yaml() => {
            Stop::new(ErrorKind::YamlKey, format!("The yaml dictionary has no key '{name}'"))
        }
        Value::Type(kind) => {
            let kind = kind.name();
            Stop::new(ErrorKind::Attribute, format!("type object '{kind}' has no attribute '{name}'"))
        }
        other => {
            let kind = other.type_name();
            Stop::new(ErrorKind::Attribute, format!("'{kind}' object has no attribute '{name}'"))
        }
    })
}
