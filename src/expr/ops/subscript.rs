//! `object[index]` and slices.

use std::sync::Arc;

use ecow::EcoVec;
use num_traits::ToPrimitive;

use crate::display;
use crate::host::ErrorKind;
use crate::interp::Interp;
use crate::stop::{Eval, Stop};
use crate::value::{Dict, Key, List, Range, Slice, Str, Tuple, Type, Value};

/// An integer used as an index or count; values beyond an `i128` are cut to its limits.
pub(crate) fn as_index(value: &Value) -> Option<i128> {
    match value {
        Value::Int(i) => Some(i128::from(*i)),
        Value::Bool(b) => Some(i128::from(*b)),
        Value::Big(big) => {
            let limit = if big.sign() == num_bigint::Sign::Minus {
                i128::MIN
            } else {
                i128::MAX
            };
            Some(big.to_i128().unwrap_or(limit))
        }
        _ => None,
    }
}

/// `object[key]`
pub(crate) fn subscript(interp: &mut Interp, object: &Value, key: &Value) -> Eval {
    if object.is_unknown() || key.is_unknown() {
        return Err(Stop::Unknown);
    }
    match object {
        Value::Dict(dict) => lookup(dict, key),
        Value::List(list) => {
            if let Value::Slice(slice) = key {
                let bounds = slice_bounds(slice, list.len())?;
                return Ok(Value::List(List::new(
                    bounds.select(interp, &list.snapshot())?,
                    list.is_yaml(),
                )));
            }
            let place = place(
                key,
                list.len(),
                "list",
                "list indices must be integers or slices",
            )?;
            list.get(place)
                .ok_or_else(|| Stop::index("list index out of range"))
        }
        Value::Tuple(tuple) => {
            let items = tuple.items();
            if let Value::Slice(slice) = key {
                let bounds = slice_bounds(slice, items.len())?;
                return Ok(Value::Tuple(Tuple::new(bounds.select(interp, items)?)));
            }
            let place = place(
                key,
                items.len(),
                "tuple",
                "tuple indices must be integers or slices",
            )?;
            items
                .get(place)
                .cloned()
                .ok_or_else(|| Stop::index("tuple index out of range"))
        }
        Value::Str(text) => text_item(interp, text, key),
        Value::Bytes(bytes) => bytes_item(interp, bytes, key),
        Value::Range(range) => range_item(range, key),
        Value::Scope(_) | Value::Module(_) => namespace_item(interp, object, key),
        Value::Type(Type::List | Type::Dict | Type::Tuple | Type::Set | Type::Type) => {
            Err(Stop::typ("generic types are not supported"))
        }
        Value::Type(kind) => Err(Stop::typ(format!(
            "type '{}' is not subscriptable",
            kind.name()
        ))),
        other => Err(Stop::typ(format!(
            "'{}' object is not subscriptable",
            other.type_name()
        ))),
    }
}

fn lookup(dict: &Dict, key: &Value) -> Eval {
    if let Some(value) = dict.get(&Key::new(key.clone())?) {
        return Ok(if dict.is_yaml() {
            value.wrapped()
        } else {
            value
        });
    }
    if dict.is_yaml() {
        let key = display::to_str(key).ok_or(Stop::Unknown)?;
        return Err(Stop::new(
            ErrorKind::YamlKey,
            format!("The yaml dictionary has no key '{key}'"),
        ));
    }
    Err(key_error(key))
}

/// `KeyError`, whose text is the key's `repr`.
pub(crate) fn key_error(key: &Value) -> Stop {
    display::shown(key).map_or_else(|stop| stop, |key| Stop::new(ErrorKind::Key, key))
}

/// Namespaces are dicts too.
fn namespace_item(interp: &mut Interp, object: &Value, key: &Value) -> Eval {
    let Value::Str(name) = key else {
        return Err(key_error(key));
    };
    interp
        .member(object, name, interp.at)
        .ok_or_else(|| key_error(key))
}

/// The place an index means, or an error if it means none.
fn place(key: &Value, len: usize, kind: &str, wanted: &str) -> Eval<usize> {
    let Some(index) = as_index(key) else {
        return Err(Stop::typ(format!("{wanted}, not {}", key.type_name())));
    };
    if i64::try_from(index).is_err() {
        return Err(Stop::index("cannot fit 'int' into an index-sized integer"));
    }
    let place = if index < 0 {
        index + len as i128
    } else {
        index
    };
    let fits = usize::try_from(place).ok().filter(|&place| place < len);
    fits.ok_or_else(|| Stop::index(format!("{kind} index out of range")))
}

fn text_item(interp: &mut Interp, text: &Str, key: &Value) -> Eval {
    interp.budget.steps(text.len() as u64 / 256)?;
    let ascii = text.is_ascii();
    let len = if ascii {
        text.len()
    } else {
        text.chars().count()
    };
    if let Value::Slice(slice) = key {
        let bounds = slice_bounds(slice, len)?;
        return Ok(Value::Str(bounds.select_text(interp, text, ascii)?));
    }
    let wanted = format!("string indices must be integers, not '{}'", key.type_name());
    if as_index(key).is_none() {
        return Err(Stop::typ(wanted));
    }
    let place = place(key, len, "string", "")?;
    let found = if ascii {
        text.as_bytes().get(place).map(|&b| char::from(b))
    } else {
        text.chars().nth(place)
    };
    found
        .map(|c| Value::Str(c.into()))
        .ok_or_else(|| Stop::index("string index out of range"))
}

fn bytes_item(interp: &mut Interp, bytes: &EcoVec<u8>, key: &Value) -> Eval {
    if let Value::Slice(slice) = key {
        let bounds = slice_bounds(slice, bytes.len())?;
        interp.budget.text(bounds.count as u128)?;
        return Ok(Value::Bytes(
            bounds
                .places()
                .filter_map(|i| bytes.get(i).copied())
                .collect(),
        ));
    }
    let place = place(
        key,
        bytes.len(),
        "",
        "byte indices must be integers or slices",
    )
    .map_err(|stop| {
        if stop.is(&ErrorKind::Index) {
            Stop::index("index out of range")
        } else {
            stop
        }
    })?;
    Ok(bytes
        .get(place)
        .map_or(Value::Unknown, |&byte| Value::Int(i64::from(byte))))
}

fn range_item(range: &Range, key: &Value) -> Eval {
    let len = range.len();
    if let Value::Slice(slice) = key {
        let bounds = slice_bounds(slice, usize::try_from(len).unwrap_or(usize::MAX))?;
        let step = range.step.saturating_mul(bounds.step);
        return Ok(Value::Range(Arc::new(Range {
            start: range.at(bounds.start),
            stop: range.at(bounds.stop),
            step,
        })));
    }
    let Some(index) = as_index(key) else {
        let kind = key.type_name();
        return Err(Stop::typ(format!(
            "range indices must be integers or slices, not {kind}"
        )));
    };
    let place = if index < 0 {
        index.saturating_add_unsigned(len)
    } else {
        index
    };
    match u128::try_from(place) {
        Ok(place) if place < len => Ok(Value::wide(range.nth(place))),
        _ => Err(Stop::index("range object index out of range")),
    }
}

/// A slice fitted to a sequence.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SliceBounds {
    pub(crate) start: i128,
    pub(crate) stop: i128,
    pub(crate) step: i128,
    pub(crate) count: usize,
}

impl SliceBounds {
    /// The places it selects.
    pub(crate) fn places(self) -> impl Iterator<Item = usize> {
        (0..self.count as i128)
            .filter_map(move |i| usize::try_from(self.start + self.step * i).ok())
    }

    fn select(self, interp: &mut Interp, items: &[Value]) -> Eval<EcoVec<Value>> {
        interp.budget.items(self.count as u128)?;
        Ok(self
            .places()
            .filter_map(|place| items.get(place).cloned())
            .collect())
    }

    fn select_text(self, interp: &mut Interp, text: &str, ascii: bool) -> Eval<Str> {
        interp.budget.text(self.count as u128)?;
        let from = usize::try_from(self.start).unwrap_or(0);
        if ascii && self.step == 1 {
            return Ok(text.get(from..from + self.count).unwrap_or("").into());
        }
        if self.step == 1 {
            return Ok(text.chars().skip(from).take(self.count).collect());
        }
        let chars: Vec<char> = text.chars().collect();
        Ok(self
            .places()
            .filter_map(|place| chars.get(place).copied())
            .collect())
    }
}

/// Fit a slice to a sequence of `len` items.
pub(crate) fn slice_bounds(slice: &Slice, len: usize) -> Eval<SliceBounds> {
    let step = slice_index(&slice.step)?.unwrap_or(1);
    if step == 0 {
        return Err(Stop::value("slice step cannot be zero"));
    }
    // Larger steps select the same items.
    let step = step.clamp(-(1 << 64), 1 << 64);
    let len = len as i128;
    let (lowest, highest) = if step < 0 { (-1, len - 1) } else { (0, len) };
    let fit = |index: i128| {
        let index = if index < 0 {
            index.saturating_add(len)
        } else {
            index
        };
        index.clamp(lowest, highest)
    };
    let start = slice_index(&slice.start)?.map_or(if step < 0 { highest } else { lowest }, fit);
    let stop = slice_index(&slice.stop)?.map_or(if step < 0 { lowest } else { highest }, fit);
    let distance = if step < 0 { start - stop } else { stop - start };
    let count = if distance <= 0 {
        0
    } else {
        (distance - 1) / step.abs() + 1
    };
    Ok(SliceBounds {
        start,
        stop,
        step,
        count: usize::try_from(count).unwrap_or(0),
    })
}

/// A part of a slice as a number; none when it is left out.
fn slice_index(value: &Value) -> Eval<Option<i128>> {
    match value {
        Value::None => Ok(None),
        Value::Unknown => Err(Stop::Unknown),
        other => as_index(other).map(Some).ok_or_else(|| {
            Stop::typ("slice indices must be integers or None or have an __index__ method")
        }),
    }
}

/// An optional start or end argument as in `s.find(x, start, end)`.
pub(crate) fn clamp_index(value: Option<&Value>, len: usize, default: usize) -> Eval<usize> {
    match value {
        None | Some(Value::None) => Ok(default),
        Some(value) => {
            let index = as_index(value).ok_or_else(|| {
                Stop::typ("slice indices must be integers or None or have an __index__ method")
            })?;
            let index = if index < 0 {
                index.saturating_add(len as i128).max(0)
            } else {
                index
            };
            // One behind the end stays distinguishable: nothing is found there, not even the empty string.
            Ok(usize::try_from(index.min(len as i128 + 1)).unwrap_or(0))
        }
    }
}
