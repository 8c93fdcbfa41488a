//! Python's `str()` and `repr()`.

use std::fmt::Write;

use super::float_repr;
use super::host::ErrorKind;
use super::interp::Interp;
use super::quote::{quote, quote_bytes};
use super::stop::{Eval, Stop};
use super::value::{Str, Type, Value, ViewKind, date_repr, date_text};
use base::limits::{EVAL_VALUE_BYTES, INTEGER_DIGITS, SHOWN_DEPTH};

/// The address shown for objects, which in Python differs from run to run.
const ADDRESS: &str = "0x7f0000000000";

/// How long the part of a message may be that shows a value.
const MAX_SHOWN: u64 = 1 << 20;

/// Python's `str()`; none if the value is unknown, has an unknown part or no text of reasonable size.
pub fn to_str(value: &Value) -> Option<Str> {
    text_of(value, EVAL_VALUE_BYTES).ok()
}

/// Python's `repr()`; none in the same cases.
pub fn repr(value: &Value) -> Option<Str> {
    repr_of(value, EVAL_VALUE_BYTES).ok()
}

/// The `repr` of a value for a message.
pub(crate) fn shown(value: &Value) -> Eval<Str> {
    repr_of(value, MAX_SHOWN)
}

impl Interp<'_> {
    /// Python's `str()`, paid for.
    pub(crate) fn text(&mut self, value: &Value) -> Eval<Str> {
        let text = text_of(value, self.budget.text_limit());
        self.paid(text)
    }

    /// Python's `repr()`, paid for.
    pub(crate) fn repr(&mut self, value: &Value) -> Eval<Str> {
        let text = repr_of(value, self.budget.text_limit());
        self.paid(text)
    }

    /// A text that became too long has cost as much as is allowed.
    fn paid(&mut self, text: Eval<Str>) -> Eval<Str> {
        let cost = match &text {
            Ok(text) => text.len() as u128,
            Err(stop) if stop.is(&ErrorKind::Budget) => u128::from(self.budget.text_limit()),
            Err(_) => 0,
        };
        self.budget.text(cost)?;
        text
    }
}

/// [`to_str`] within `limit` bytes, with the reason of a failure.
pub(crate) fn text_of(value: &Value, limit: u64) -> Eval<Str> {
    match value {
        Value::Str(text) => Ok(text.clone()),
        Value::Date(date) => Ok(date_text(date, " ").into()),
        other => repr_of(other, limit),
    }
}

fn repr_of(value: &Value, limit: u64) -> Eval<Str> {
    if let Value::Int(int) = value {
        let mut out = Str::new();
        let _ = write!(out, "{int}");
        return Ok(out);
    }
    let mut writer = ReprWriter {
        out: String::new(),
        limit,
        active: Vec::new(),
    };
    writer.value(value)?;
    Ok(writer.out.into())
}

struct ReprWriter {
    out: String,
    /// Bytes it may have.
    limit: u64,
    /// Addresses of the containers being written, to notice one inside itself.
    active: Vec<usize>,
}

impl ReprWriter {
    fn value(&mut self, value: &Value) -> Eval<()> {
        if self.out.len() as u64 > self.limit {
            let limit = self.limit;
            return Err(Stop::budget(format!(
                "text of a value is longer than the limit of {limit} bytes"
            )));
        }
        match value {
            Value::Unknown | Value::Scope(_) | Value::Module(_) => return Err(Stop::Unknown),
            Value::None => self.out.push_str("None"),
            Value::Ellipsis => self.out.push_str("Ellipsis"),
            Value::Bool(true) => self.out.push_str("True"),
            Value::Bool(false) => self.out.push_str("False"),
            Value::Int(int) => push(&mut self.out, format_args!("{int}")),
            Value::Big(big) => self.out.push_str(&big_text(big)?),
            Value::Float(float) => float_repr::push_repr(&mut self.out, *float),
            Value::Complex(re, im) => self.out.push_str(&complex_text(*re, *im)),
            Value::Str(text) => quote(&mut self.out, text),
            Value::Bytes(bytes) => quote_bytes(&mut self.out, bytes),
            Value::Date(date) => self.out.push_str(&date_repr(date)),
            Value::Type(kind) => push(
                &mut self.out,
                format_args!("<class '{}'>", kind.qualified_name()),
            ),
            _ => return self.object(value),
        }
        Ok(())
    }

    fn object(&mut self, value: &Value) -> Eval<()> {
        match value {
            Value::List(list) => self.nested(value, "[", &list.snapshot(), "]"),
            Value::Tuple(tuple) => {
                let close = if tuple.items().len() == 1 { ",)" } else { ")" };
                self.nested(value, "(", tuple.items(), close)
            }
            Value::Dict(dict) => self.within(value, "{...}", |w| w.entries(&dict.entries())),
            Value::Set(set) => self.set(value, set.is_frozen(), &set.ordered()),
            Value::View(view) => {
                self.within(value, "...", |w| w.view(view.kind, &view.dict.entries()))
            }
            Value::Range(range) => {
                let step = if range.step == 1 {
                    String::new()
                } else {
                    format!(", {}", range.step)
                };
                push(
                    &mut self.out,
                    format_args!("range({}, {}{step})", range.start, range.stop),
                );
                Ok(())
            }
            Value::Slice(slice) => {
                let parts = [slice.start.clone(), slice.stop.clone(), slice.step.clone()];
                self.within(value, "...", |w| w.sequence("slice(", &parts, ")"))
            }
            other => {
                self.out.push_str(&function_text(other));
                Ok(())
            }
        }
    }

    /// Run `body` unless `value` is being written already, in which case `instead` stands for it.
    fn within(
        &mut self,
        value: &Value,
        instead: &str,
        body: impl FnOnce(&mut Self) -> Eval<()>,
    ) -> Eval<()> {
        let address = value.address().unwrap_or(0);
        if self.active.contains(&address) {
            self.out.push_str(instead);
            return Ok(());
        }
        if self.active.len() >= SHOWN_DEPTH {
            return Err(Stop::recursion(" while getting the repr of an object"));
        }
        self.active.push(address);
        let result = body(self);
        self.active.pop();
        result
    }

    fn nested(&mut self, value: &Value, open: &str, items: &[Value], close: &str) -> Eval<()> {
        let round = open == "(";
        self.within(value, if round { "(...)" } else { "[...]" }, |w| {
            w.sequence(open, items, close)
        })
    }

    fn sequence(&mut self, open: &str, items: &[Value], close: &str) -> Eval<()> {
        self.out.push_str(open);
        for (i, item) in items.iter().enumerate() {
            if i > 0 {
                self.out.push_str(", ");
            }
            self.value(item)?;
        }
        self.out.push_str(close);
        Ok(())
    }

    fn entries(&mut self, entries: &[(Value, Value)]) -> Eval<()> {
        self.out.push('{');
        for (i, (key, value)) in entries.iter().enumerate() {
            if i > 0 {
                self.out.push_str(", ");
            }
            self.value(key)?;
            self.out.push_str(": ");
            self.value(value)?;
        }
        self.out.push('}');
        Ok(())
    }

    fn set(&mut self, value: &Value, frozen: bool, items: &[Value]) -> Eval<()> {
        let (open, close) = match (frozen, items.is_empty()) {
            (false, true) => ("set(", ")"),
            (true, true) => ("frozenset(", ")"),
            (false, false) => ("{", "}"),
            (true, false) => ("frozenset({", "})"),
        };
        self.within(value, "set(...)", |w| w.sequence(open, items, close))
    }

    fn view(&mut self, kind: ViewKind, entries: &[(Value, Value)]) -> Eval<()> {
        let pair = |(key, value): &(Value, Value)| match kind {
            ViewKind::Keys => key.clone(),
            ViewKind::Values => value.clone(),
            ViewKind::Items => Value::tuple_from([key.clone(), value.clone()]),
        };
        let items: Vec<Value> = entries.iter().map(pair).collect();
        let open = match kind {
            ViewKind::Keys => "dict_keys([",
            ViewKind::Values => "dict_values([",
            ViewKind::Items => "dict_items([",
        };
        self.sequence(open, &items, "])")
    }
}

/// Add formatted text.
pub(crate) fn push(out: &mut String, text: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = out.write_fmt(text);
}

/// Decimal digits of a big integer, unless there are too many.
pub(crate) fn big_text(big: &num_bigint::BigInt) -> Eval<String> {
    // 3.33 bits make a digit: this many bits are surely too long without converting them.
    if big.bits() > (INTEGER_DIGITS as u64) * 10 / 3 {
        return Err(too_many_digits());
    }
    let text = big.to_string();
    if text.trim_start_matches('-').len() > INTEGER_DIGITS {
        Err(too_many_digits())
    } else {
        Ok(text)
    }
}

fn too_many_digits() -> Stop {
    Stop::value(format!(
        "Exceeds the limit ({INTEGER_DIGITS} digits) for integer string conversion; use sys.set_int_max_str_digits() to increase the limit"
    ))
}

/// The qualified name of a function written in Python.
fn python_name(name: &'static str, deprecated: bool) -> &'static str {
    match name {
        _ if deprecated => "create_global_symbols.<locals>.deprecate.<locals>.wrapper",
        "message" | "warning" | "error" | "print_location" => {
            "create_global_symbols.<locals>.message_adapter.<locals>.wrapper"
        }
        "arg" => "create_global_symbols.<locals>.<lambda>",
        "fatal" => "create_global_symbols.<locals>.fatal",
        "abs_filename" => "abs_filename_spec",
        other => other,
    }
}

fn function_text(value: &Value) -> String {
    match value {
        Value::Builtin(builtin) if Type::of(value) == Type::Builtin => {
            format!("<built-in function {}>", builtin.function.name)
        }
        Value::Builtin(builtin) => {
            let name = python_name(builtin.function.name, builtin.deprecated.is_some());
            format!("<function {name} at {ADDRESS}>")
        }
        Value::Method(method) if method.unbound => {
            format!(
                "<method '{}' of '{}' objects>",
                method.function.name, method.function.owner
            )
        }
        Value::Method(method) => {
            let owner = method.receiver.type_name();
            format!(
                "<built-in method {} of {owner} object at {ADDRESS}>",
                method.function.name
            )
        }
        Value::Lambda(_) => format!("<function <lambda> at {ADDRESS}>"),
        Value::Iter(_) if Type::of(value) == Type::Generator => {
            format!("<generator object <genexpr> at {ADDRESS}>")
        }
        other => format!("<{} object at {ADDRESS}>", other.type_name()),
    }
}

/// A part of a complex number: like a float, but without `.0`.
fn short_float(value: f64) -> String {
    let text = float_repr::repr(value);
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// `(1+2j)`
pub(crate) fn complex_text(re: f64, im: f64) -> String {
    if re == 0.0 && re.is_sign_positive() {
        return format!("{}j", short_float(im));
    }
    let sign = if im.is_nan() || im.is_sign_positive() {
        "+"
    } else {
        ""
    };
    format!("({}{sign}{}j)", short_float(re), short_float(im))
}
