//! `value.name`

use std::sync::Arc;

use super::builtins;
use super::host::{ErrorKind, Lookup};
use super::interp::Interp;
use super::methods;
use super::numeric::Num;
use super::stop::{Eval, Stop};
use super::value::{Bound, Dict, Key, Type, Value};
use base::TextRange;

impl Interp<'_> {
    /// `value.name`; `place` is where the name stands.
    pub(crate) fn attribute(&mut self, value: &Value, name: &str, place: TextRange) -> Eval {
        match value {
            Value::Unknown => return Err(Stop::Unknown),
            Value::Module(_) | Value::Scope(_) => {
                if matches!(name, "copy" | "get" | "items" | "keys" | "values") {
                    let entries = Value::Dict(self.entries(value)?);
                    return self.attribute(&entries, name, place);
                }
                if name == "depth" && matches!(value, Value::Module(_)) {
                    return Ok(Value::Int(0));
                }
                // the host knows the depth of a scope
                if is_namespace_attribute(name) && name != "depth" {
                    return Err(Stop::Unknown);
                }
                return self.member(value, name, place).ok_or_else(|| {
                    self.host.undefined(name, place);
                    Stop::Unknown
                });
            }
            // Not everything they have is known here.
            Value::Date(date) => {
                return date_part(date, name)
                    .or_else(|| date_method(value, name))
                    .ok_or(Stop::Unknown);
            }
            _ => {}
        }
        if let Some(function) = methods::find(value, name) {
            let unbound = false;
            return Ok(Value::Method(Arc::new(Bound {
                receiver: value.clone(),
                function,
                unbound,
            })));
        }
        data(value, name).map_or_else(|| missing(value, name), Ok)
    }

    /// What a namespace holds under a name.
    pub(crate) fn member(
        &mut self,
        namespace: &Value,
        name: &str,
        place: TextRange,
    ) -> Option<Value> {
        match namespace {
            Value::Module(module) => builtins::attribute(*module, name),
            Value::Scope(scope) => match self.host.scope_attribute(*scope, name, place) {
                Lookup::Found(value) => Some(value),
                Lookup::Missing => builtins::global(name),
            },
            _ => None,
        }
    }

    /// What a namespace holds itself: in the reference it is a dict.
    pub(crate) fn entries(&mut self, namespace: &Value) -> Eval<Dict> {
        let entries = match namespace {
            Value::Module(module) => {
                let names = builtins::names(*module).iter();
                names
                    .filter_map(|name| {
                        Some((Key::text(*name), builtins::attribute(*module, name)?))
                    })
                    .collect()
            }
            Value::Scope(scope) => {
                let entries = self.host.scope_entries(*scope).ok_or(Stop::Unknown)?;
                entries
                    .into_iter()
                    .map(|(name, value)| (Key::text(name), value))
                    .collect()
            }
            _ => return Err(Stop::Unknown),
        };
        let dict = Dict::new(entries, false);
        self.budget.items(dict.len() as u128)?;
        Ok(dict)
    }

    /// The dict that a value is, or None.
    pub(crate) fn mapping(&mut self, value: &Value) -> Eval<Option<Dict>> {
        match value {
            Value::Dict(dict) => Ok(Some(dict.clone())),
            Value::Module(_) | Value::Scope(_) => self.entries(value).map(Some),
            _ => Ok(None),
        }
    }

    /// `item in namespace`: also what is around it counts.
    pub(crate) fn namespace_holds(&mut self, namespace: &Value, item: &Value) -> Eval<bool> {
        let key = Key::new(item.clone())?;
        match (namespace, item) {
            (Value::Scope(scope), Value::Str(name)) => {
                Ok(self.host.scope_holds(*scope, name) || builtins::global(name).is_some())
            }
            (Value::Scope(_), _) => Ok(false),
            _ => Ok(self.entries(namespace)?.get(&key).is_some()),
        }
    }
}

/// Whether `namespace.name` is an attribute of the namespace object itself and hides a property of that name.
///
/// The reference's namespaces are dicts with attributes of their own: `ns.depth` is not the property `depth`.
/// The value of such an attribute is unknown here.
pub fn is_namespace_attribute(name: &str) -> bool {
    matches!(
        name,
        "depth" | "parent" | "recursive" | "root" | "top" | "unevaluated"
    ) || methods::of_type(Type::Dict, name).is_some()
        || name == "fromkeys"
}

/// Attributes that are no methods.
fn data(value: &Value, name: &str) -> Option<Value> {
    match (value, name) {
        (Value::Dict(dict), _) if dict.is_yaml() => dict.get(&Key::text(name)).map(Value::wrapped),
        (Value::Range(range), "start") => Some(Value::wide(range.start)),
        (Value::Range(range), "stop") => Some(Value::wide(range.stop)),
        (Value::Range(range), "step") => Some(Value::wide(range.step)),
        (Value::Slice(slice), "start") => Some(slice.start.clone()),
        (Value::Slice(slice), "stop") => Some(slice.stop.clone()),
        (Value::Slice(slice), "step") => Some(slice.step.clone()),
        (Value::Type(kind), _) => {
            let function = methods::of_type(*kind, name)?;
            Some(Value::Method(Arc::new(Bound {
                receiver: value.clone(),
                function,
                unbound: true,
            })))
        }
        _ => number_part(Num::of(value)?, value, name),
    }
}

fn number_part(number: Num<'_>, value: &Value, name: &str) -> Option<Value> {
    match (number, name) {
        (Num::Complex(re, _), "real") => Some(Value::Float(re)),
        (Num::Complex(_, im), "imag") => Some(Value::Float(im)),
        (_, "real") => Some(without_bool(value)),
        (Num::Float(_), "imag") => Some(Value::Float(0.0)),
        (Num::Int(_) | Num::Big(_), "imag") => Some(Value::Int(0)),
        (Num::Int(_) | Num::Big(_), "numerator") => Some(without_bool(value)),
        (Num::Int(_) | Num::Big(_), "denominator") => Some(Value::Int(1)),
        _ => None,
    }
}

/// A number, with a truth value as the number that it is.
fn without_bool(value: &Value) -> Value {
    match value {
        Value::Bool(b) => Value::Int(i64::from(*b)),
        other => other.clone(),
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

fn date_method(value: &Value, name: &str) -> Option<Value> {
    let function = methods::find(value, name)?;
    Some(Value::Method(Arc::new(Bound {
        receiver: value.clone(),
        function,
        unbound: false,
    })))
}

fn missing(value: &Value, name: &str) -> Eval {
    Err(match value {
        // Most methods of strings exist for bytes too, only not here: better an error than a guess.
        Value::Bytes(_) if methods::of_type(Type::Str, name).is_some() => Stop::new(
            ErrorKind::Attribute,
            format!("the method '{name}' of bytes is not supported here"),
        ),
        Value::Dict(dict) if dict.is_yaml() => Stop::new(
            ErrorKind::YamlKey,
            format!("The yaml dictionary has no key '{name}'"),
        ),
        Value::Type(kind) => {
            let kind = kind.name();
            Stop::new(
                ErrorKind::Attribute,
                format!("type object '{kind}' has no attribute '{name}'"),
            )
        }
        other => {
            let kind = other.type_name();
            Stop::new(
                ErrorKind::Attribute,
                format!("'{kind}' object has no attribute '{name}'"),
            )
        }
    })
}
