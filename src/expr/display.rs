//! Python's `str()` and `repr()`.

use std::fmt::Write;

use super::budget::MAX_VALUE_BYTES;
use super::float_repr;
use super::numeric::MAX_STR_DIGITS;
use super::stop::{Eval, Stop};
use super::value::{DateValue, Str, Type, Value, ViewKind};

/// How deep containers may nest in a text.
const MAX_DEPTH: usize = 150;
/// The address shown for objects, which in Python differs from run to run.
const ADDRESS: &str = "0x7f0000000000";

/// Python's `str()`; none if the value is unknown, has an unknown part or no text of reasonable size.
pub fn to_str(value: &Value) -> Option<Str> {
    text_of(value).ok()
}

/// Python's `repr()`; none in the same cases.
pub fn repr(value: &Value) -> Option<Str> {
    repr_of(value).ok()
}

/// [`to_str`] with the reason of a failure.
pub(crate) fn text_of(value: &Value) -> Eval<Str> {
    match value {
        Value::Str(text) => Ok(text.clone()),
        Value::Date(date) => Ok(date_text(date, " ").into()),
        other => repr_of(other),
    }
}

/// [`repr`] with the reason of a failure.
pub(crate) fn repr_of(value: &Value) -> Eval<Str> {
    if let Value::Int(int) = value {
        let mut out = Str::new();
        let _ = write!(out, "{int}");
        return Ok(out);
    }
    let mut writer = Writer { out: String::new(), active: Vec::new() };
    writer.value(value)?;
    Ok(writer.out.into())
}

struct Writer {
    out: String,
    /// Addresses of the containers being written, to notice one inside itself.
    active: Vec<usize>,
}

impl Writer {
    fn value(&mut self, value: &Value) -> Eval<()> {
        if self.out.len() as u64 > MAX_VALUE_BYTES {
            return Err(Stop::budget(format!(
                "text of a value is longer than the limit of {} MB",
                MAX_VALUE_BYTES >> 20
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
            Value::Float(float) => self.out.push_str(&float_repr::repr(*float)),
            Value::Complex(re, im) => self.out.push_str(&complex_text(*re, *im)),
            Value::Str(text) => quote(&mut self.out, text),
            Value::Bytes(bytes) => quote_bytes(&mut self.out, bytes),
            Value::Date(date) => self.out.push_str(&date_repr(date)),
            Value::Type(kind) => push(&mut self.out, format_args!("<class '{}'>", kind.qualified_name())),
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
            Value::View(view) => self.within(value, "...", |w| w.view(view.kind, &view.dict.entries())),
            Value::Range(range) => {
                let step = if range.step == 1 { String::new() } else { format!(", {}", range.step) };
                push(&mut self.out, format_args!("range({}, {}{step})", range.start, range.stop));
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
    fn within(&mut self, value: &Value, instead: &str, body: impl FnOnce(&mut Self) -> Eval<()>) -> Eval<()> {
        let address = value.address().unwrap_or(0);
        if self.active.contains(&address) {
            self.out.push_str(instead);
            return Ok(());
        }
        if self.active.len() >= MAX_DEPTH {
            return Err(Stop::recursion(" while getting the repr of an object"));
        }
        self.active.push(address);
        let result = body(self);
        self.active.pop();
        result
    }

    fn nested(&mut self, value: &Value, open: &str, items: &[Value], close: &str) -> Eval<()> {
        let round = open == "(";
        self.within(value, if round { "(...)" } else { "[...]" }, |w| w.sequence(open, items, close))
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

fn push(out: &mut String, text: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = out.write_fmt(text);
}

/// Decimal digits of a big integer, unless there are too many.
pub(crate) fn big_text(big: &num_bigint::BigInt) -> Eval<String> {
    // 3.33 bits make a digit: this many bits are surely too long without converting them.
    let too_long = || {
        Stop::value(format!(
            "Exceeds the limit ({MAX_STR_DIGITS} digits) for integer string conversion; use sys.set_int_max_str_digits() to increase the limit"
        ))
    };
    if big.bits() > (MAX_STR_DIGITS as u64) * 10 / 3 {
        return Err(too_long());
    }
    let text = big.to_string();
    if text.trim_start_matches('-').len() > MAX_STR_DIGITS { Err(too_long()) } else { Ok(text) }
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
            format!("<method '{}' of '{}' objects>", method.function.name, method.function.owner)
        }
        Value::Method(method) => {
            let owner = method.receiver.type_name();
            format!("<built-in method {} of {owner} object at {ADDRESS}>", method.function.name)
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
    let sign = if im.is_nan() || im.is_sign_positive() { "+" } else { "" };
    format!("({}{sign}{}j)", short_float(re), short_float(im))
}

/// Python prefers single quotes unless the text holds only single ones.
fn quote_for(single: bool, double: bool) -> char {
    if single && !double { '"' } else { '\'' }
}

/// A string with quotes and escapes.
pub(crate) fn quote(out: &mut String, text: &str) {
    let quote = quote_for(text.contains('\''), text.contains('"'));
    out.push(quote);
    for c in text.chars() {
        match c {
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            '\\' => out.push_str("\\\\"),
            c if c == quote => {
                out.push('\\');
                out.push(c);
            }
            ' '..='~' => out.push(c),
            c if is_printable(c) => out.push(c),
            c => push_escape(out, c),
        }
    }
    out.push(quote);
}

/// `\x7f`, `\u200b` or `\U000e0001`
pub(crate) fn push_escape(out: &mut String, c: char) {
    match u32::from(c) {
        code @ 0..=0xff => push(out, format_args!("\\x{code:02x}")),
        code @ 0x100..=0xffff => push(out, format_args!("\\u{code:04x}")),
        code => push(out, format_args!("\\U{code:08x}")),
    }
}

/// Whether `repr()` shows the character itself: neither control, format, unassigned nor a separator other than the blank.
///
/// The standard library escapes for `Debug` by the same definition; in front of the character a letter keeps
/// combining marks as they are.
pub(crate) fn is_printable(c: char) -> bool {
    if c.is_ascii() {
        return (' '..='~').contains(&c);
    }
    let mut buffer = [b'a'; 5];
    let len = 1 + c.len_utf8();
    if let Some(rest) = buffer.get_mut(1..) {
        c.encode_utf8(rest);
    }
    let text = buffer.get(..len).and_then(|bytes| std::str::from_utf8(bytes).ok()).unwrap_or("");
    text.escape_debug().nth(1) == Some(c)
}

fn quote_bytes(out: &mut String, bytes: &[u8]) {
    let quote = quote_for(bytes.contains(&b'\''), bytes.contains(&b'"'));
    out.push('b');
    out.push(quote);
    for &byte in bytes {
        match byte {
            b'\n' => out.push_str("\\n"),
            b'\r' => out.push_str("\\r"),
            b'\t' => out.push_str("\\t"),
            b'\\' => out.push_str("\\\\"),
            byte if char::from(byte) == quote => {
                out.push('\\');
                out.push(quote);
            }
            b' '..=b'~' => out.push(char::from(byte)),
            byte => push(out, format_args!("\\x{byte:02x}")),
        }
    }
    out.push(quote);
}

/// `2001-12-14` or `2001-12-14 21:59:43.100000+01:00`
pub(crate) fn date_text(date: &DateValue, separator: &str) -> String {
    let (year, month, day) = date.date;
    let mut out = format!("{year:04}-{month:02}-{day:02}");
    let Some((hour, minute, second, micro)) = date.time else { return out };
    push(&mut out, format_args!("{separator}{hour:02}:{minute:02}:{second:02}"));
    if micro != 0 {
        push(&mut out, format_args!(".{micro:06}"));
    }
    if let Some(offset) = date.utc_offset {
        let sign = if offset < 0 { '-' } else { '+' };
        let (hours, minutes) = (offset.unsigned_abs() / 3600, offset.unsigned_abs() / 60 % 60);
        push(&mut out, format_args!("{sign}{hours:02}:{minutes:02}"));
    }
    out
}

fn date_repr(date: &DateValue) -> String {
    let (year, month, day) = date.date;
    let Some((hour, minute, second, micro)) = date.time else {
        return format!("datetime.date({year}, {month}, {day})");
    };
    let mut out = format!("datetime.datetime({year}, {month}, {day}, {hour}, {minute}");
    if second != 0 || micro != 0 {
        push(&mut out, format_args!(", {second}"));
    }
    if micro != 0 {
        push(&mut out, format_args!(", {micro}"));
    }
    match date.utc_offset {
        None => {}
        Some(0) => out.push_str(", tzinfo=datetime.timezone.utc"),
        Some(offset) => {
            let days = if offset < 0 { "days=-1, " } else { "" };
            let seconds = offset.rem_euclid(86_400);
            push(
                &mut out,
                format_args!(", tzinfo=datetime.timezone(datetime.timedelta({days}seconds={seconds}))"),
            );
        }
    }
    out.push(')');
    out
}
