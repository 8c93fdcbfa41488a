//! Methods of bytes, and encodings.

use super::{methods, optional, up_to};
use crate::args::Args;
use crate::args::Arity::{One, Zero};
use crate::builtins::{Function, argument_type};
use crate::interp::Interp;
use crate::stop::{Eval, Stop};
use crate::value::Value;

/// Sorted by name.
pub(super) static METHODS: &[Function] = methods! { "bytes":
    "decode" optional(&["encoding", "errors"]) => |i, s, a| {
        i.budget.text(this(s)?.len() as u128)?;
        decode(this(s)?, a.get(0), a.get(1))
    },
    "endswith" up_to(1, 1) => |_, s, a| Ok(Value::Bool(this(s)?.ends_with(part(a.at(0))?))),
    "find" up_to(1, 1) => |_, s, a| {
        let place = memchr::memmem::find(this(s)?, part(a.at(0))?);
        Ok(Value::Int(place.and_then(|place| i64::try_from(place).ok()).unwrap_or(-1)))
    },
    "hex" Zero => |i, s, _| {
        i.budget.text(this(s)?.len() as u128 * 2)?;
        Ok(Value::from(this(s)?.iter().map(|byte| format!("{byte:02x}")).collect::<String>()))
    },
    "lower" Zero => |_, s, _| Ok(Value::Bytes(this(s)?.iter().map(u8::to_ascii_lowercase).collect())),
    "startswith" up_to(1, 1) => |_, s, a| Ok(Value::Bool(this(s)?.starts_with(part(a.at(0))?))),
    "strip" Zero => |_, s, _| Ok(Value::Bytes(this(s)?.trim_ascii().iter().copied().collect())),
    "swapcase" Zero => |_, s, _| Ok(Value::Bytes(this(s)?.iter().map(swapcase).collect())),
    "title" Zero => |_, s, _| Ok(Value::Bytes(title(this(s)?))),
    "upper" Zero => |_, s, _| Ok(Value::Bytes(this(s)?.iter().map(u8::to_ascii_uppercase).collect())),
};

/// Sorted by name.
pub(super) static CLASS: &[Function] = methods! { "bytes":
    "fromhex" One => from_hex,
};

fn swapcase(byte: &u8) -> u8 {
    if byte.is_ascii_lowercase() {
        byte.to_ascii_uppercase()
    } else {
        byte.to_ascii_lowercase()
    }
}

/// The first letter of each run of letters large, the others small.
fn title(bytes: &[u8]) -> ecow::EcoVec<u8> {
    let mut inside = false;
    let letter = |byte: &u8| {
        let cased = if inside {
            byte.to_ascii_lowercase()
        } else {
            byte.to_ascii_uppercase()
        };
        inside = byte.is_ascii_alphabetic();
        cased
    };
    bytes.iter().map(letter).collect()
}

fn this(value: &Value) -> Eval<&[u8]> {
    match value {
        Value::Bytes(bytes) => Ok(bytes),
        _ => Err(Stop::Unknown),
    }
}

fn part(value: &Value) -> Eval<&[u8]> {
    match value {
        Value::Bytes(bytes) => Ok(bytes),
        other => Err(Stop::typ(format!(
            "a bytes-like object is required, not '{}'",
            other.type_name()
        ))),
    }
}

fn from_hex(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let Value::Str(text) = args.at(0) else {
        return Err(Stop::typ(format!(
            "fromhex() argument must be str, not {}",
            args.at(0).type_name()
        )));
    };
    let mut bytes = ecow::EcoVec::new();
    let mut high = None;
    for (place, c) in text.chars().enumerate() {
        if c.is_ascii_whitespace() && high.is_none() {
            continue;
        }
        let digit = c
            .to_digit(16)
            .and_then(|digit| u8::try_from(digit).ok())
            .ok_or_else(|| wrong_digit(place))?;
        match high.take() {
            None => high = Some(digit),
            Some(high) => bytes.push(high << 4 | digit),
        }
    }
    if high.is_some() {
        Err(wrong_digit(text.chars().count()))
    } else {
        Ok(Value::Bytes(bytes))
    }
}

fn wrong_digit(place: usize) -> Stop {
    Stop::value(format!(
        "non-hexadecimal number found in fromhex() arg at position {place}"
    ))
}

/// Encodings whose code points are the same up to a limit.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ByteEncoding {
    Utf8,
    Ascii,
    Latin1,
}

fn encoding(name: Option<&Value>) -> Eval<ByteEncoding> {
    let name = match name {
        None => return Ok(ByteEncoding::Utf8),
        Some(Value::Str(name)) => name,
        Some(other) => {
            let kind = argument_type(other);
            return Err(Stop::typ(format!(
                "encode() argument 'encoding' must be str, not {kind}"
            )));
        }
    };
    let plain: String = name
        .chars()
        .filter(char::is_ascii_alphanumeric)
        .map(|c| c.to_ascii_lowercase())
        .collect();
    match plain.as_str() {
        "utf8" | "u8" | "cp65001" => Ok(ByteEncoding::Utf8),
        "ascii" | "usascii" | "646" => Ok(ByteEncoding::Ascii),
        "latin1" | "iso88591" | "latin" | "l1" | "88591" | "cp819" => Ok(ByteEncoding::Latin1),
        _ => Err(Stop::new(
            crate::host::ErrorKind::Value,
            format!("unknown encoding: {name}"),
        )),
    }
}

/// `text.encode(encoding, errors)`
pub(super) fn encode(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    interp.budget.text(text.len() as u128 * 2)?;
    let encoding = encoding(args.get(0))?;
    let mode = args.get(1).and_then(Value::as_str).unwrap_or("strict");
    let (limit, codec, range) = match encoding {
        ByteEncoding::Utf8 => return Ok(Value::Bytes(text.bytes().collect())),
        ByteEncoding::Ascii => (0x80, "ascii", 128),
        ByteEncoding::Latin1 => (0x100, "latin-1", 256),
    };
    let mut bytes = ecow::EcoVec::with_capacity(text.len());
    for (place, c) in text.chars().enumerate() {
        match (u8::try_from(u32::from(c)), mode) {
            (Ok(byte), _) if u32::from(byte) < limit => bytes.push(byte),
            (_, "ignore") => {}
            (_, "replace") => bytes.push(b'?'),
            _ => {
                let mut shown = String::new();
                display_escape(&mut shown, c);
                return Err(Stop::value(format!(
                    "'{codec}' codec can't encode character '{shown}' in position {place}: ordinal not in range({range})"
                )));
            }
        }
    }
    Ok(Value::Bytes(bytes))
}

fn display_escape(out: &mut String, c: char) {
    crate::quote::push_escape(out, c);
}

/// `bytes.decode(encoding, errors)`
pub(crate) fn decode(bytes: &[u8], name: Option<&Value>, errors: Option<&Value>) -> Eval {
    let encoding = encoding(name)?;
    let mode = errors.and_then(Value::as_str).unwrap_or("strict");
    if encoding == ByteEncoding::Latin1 {
        return Ok(Value::from(
            bytes
                .iter()
                .map(|&byte| char::from(byte))
                .collect::<String>(),
        ));
    }
    let error = match encoding {
        ByteEncoding::Ascii => bytes.iter().position(|byte| !byte.is_ascii()).map(|place| {
            undecodable(
                "ascii",
                bytes,
                place,
                place + 1,
                "ordinal not in range(128)",
            )
        }),
        _ => std::str::from_utf8(bytes)
            .err()
            .map(|error| not_utf8(bytes, &error)),
    };
    match (error, mode) {
        (None, _) | (Some(_), "replace") => {
            Ok(Value::from(String::from_utf8_lossy(bytes).into_owned()))
        }
        (Some(_), "ignore") => Ok(Value::from(
            String::from_utf8_lossy(bytes).replace('\u{fffd}', ""),
        )),
        (Some(error), _) => Err(error),
    }
}

fn not_utf8(bytes: &[u8], error: &std::str::Utf8Error) -> Stop {
    let start = error.valid_up_to();
    let first = bytes.get(start).copied().unwrap_or(0);
    match error.error_len() {
        None => undecodable("utf-8", bytes, start, bytes.len(), "unexpected end of data"),
        Some(len) if (0xc2..0xf5).contains(&first) => undecodable(
            "utf-8",
            bytes,
            start,
            start + len,
            "invalid continuation byte",
        ),
        Some(len) => undecodable("utf-8", bytes, start, start + len, "invalid start byte"),
    }
}

fn undecodable(codec: &str, bytes: &[u8], start: usize, end: usize, reason: &str) -> Stop {
    let first = bytes.get(start).copied().unwrap_or(0);
    let what = if end - start == 1 {
        format!("byte 0x{first:02x} in position {start}")
    } else {
        format!("bytes in position {start}-{}", end - 1)
    };
    Stop::value(format!("'{codec}' codec can't decode {what}: {reason}"))
}
