//! Numbers and bytes, made from their text as PyYAML makes them.

use num_bigint::BigInt;
use num_traits::Num;

use super::error::repr;
use base::limits::INTEGER_DIGITS;

/// `int` of a scalar.
///
/// # Errors
/// Python's message.
pub(super) fn int(text: &str) -> Result<BigInt, String> {
    let text = text.replace('_', "");
    let (negative, digits) = match text.chars().next() {
        None => return Err("string index out of range".to_owned()),
        Some('-') => (true, text.get(1..).unwrap_or_default()),
        Some('+') => (false, text.get(1..).unwrap_or_default()),
        Some(_) => (false, text.as_str()),
    };
    let value = if let Some(bits) = digits.strip_prefix("0b") {
        python_int(bits, 2)?
    } else if let Some(digits) = digits.strip_prefix("0x") {
        python_int(digits, 16)?
    } else if digits.is_empty() {
        return Err("string index out of range".to_owned());
    } else if digits == "0" {
        BigInt::ZERO
    } else if digits.starts_with('0') {
        python_int(digits, 8)?
    } else {
        let mut value = BigInt::ZERO;
        for part in digits.split(':') {
            value = value * 60 + python_int(part, 10)?;
        }
        value
    };
    Ok(if negative { -value } else { value })
}

/// `int(text, base)`
fn python_int(text: &str, base: u32) -> Result<BigInt, String> {
    let trimmed = text.trim();
    let (negative, digits) = match trimmed.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, trimmed.strip_prefix('+').unwrap_or(trimmed)),
    };
    let prefixes: &[&str] = match base {
        2 => &["0b", "0B"],
        8 => &["0o", "0O"],
        16 => &["0x", "0X"],
        _ => &[],
    };
    let digits = prefixes
        .iter()
        .find_map(|prefix| digits.strip_prefix(prefix))
        .unwrap_or(digits);
    if digits.is_empty() || !digits.chars().all(|c| c.is_digit(base)) {
        return Err(invalid_literal(text, base));
    }
    if base == 10 && digits.len() > INTEGER_DIGITS {
        return Err(format!(
            "Exceeds the limit ({INTEGER_DIGITS} digits) for integer string conversion: value has {} digits; use sys.set_int_max_str_digits() to increase the limit",
            digits.len()
        ));
    }
    let value = BigInt::from_str_radix(digits, base).map_err(|_| invalid_literal(text, base))?;
    Ok(if negative { -value } else { value })
}

fn invalid_literal(text: &str, base: u32) -> String {
    format!("invalid literal for int() with base {base}: {}", repr(text))
}

/// `float` of a scalar.
///
/// # Errors
/// Python's message.
pub(super) fn float(text: &str) -> Result<f64, String> {
    let text = text.replace('_', "").to_lowercase();
    let (sign, digits) = match text.chars().next() {
        None => return Err("string index out of range".to_owned()),
        Some('-') => (-1.0, text.get(1..).unwrap_or_default()),
        Some('+') => (1.0, text.get(1..).unwrap_or_default()),
        Some(_) => (1.0, text.as_str()),
    };
    match digits {
        ".inf" => Ok(sign * f64::INFINITY),
        ".nan" => Ok(f64::NAN),
        _ if digits.contains(':') => {
            let (mut value, mut base) = (0.0, 1.0);
            let parts: Result<Vec<f64>, String> = digits.split(':').map(python_float).collect();
            for part in parts?.into_iter().rev() {
                value += part * base;
                base *= 60.0;
            }
            Ok(sign * value)
        }
        _ => Ok(sign * python_float(digits)?),
    }
}

/// `float(text)`
fn python_float(text: &str) -> Result<f64, String> {
    text.trim()
        .parse()
        .map_err(|_| format!("could not convert string to float: {}", repr(text)))
}

/// The bytes of base64 text; what is no base64 digit is skipped.
///
/// # Errors
/// The message of Python's `binascii.Error`.
pub(super) fn base64(text: &str) -> Result<Vec<u8>, String> {
    let (mut bytes, mut digits, mut pads) = (Vec::new(), 0usize, 0usize);
    let mut pending = 0u32;
    for byte in text.bytes() {
        if byte == b'=' {
            if digits % 4 >= 2 {
                pads += 1;
                if digits % 4 + pads >= 4 {
                    return Ok(bytes);
                }
            }
            continue;
        }
        let Some(value) = base64_digit(byte) else {
            continue;
        };
        pads = 0;
        digits += 1;
        pending = pending << 6 | value;
        match digits % 4 {
            2 => bytes.push((pending >> 4) as u8),
            3 => bytes.push((pending >> 2) as u8),
            0 => bytes.push(pending as u8),
            _ => {}
        }
    }
    match digits % 4 {
        0 => Ok(bytes),
        1 => Err(format!(
            "Invalid base64-encoded string: number of data characters ({digits}) cannot be 1 more than a multiple of 4"
        )),
        _ => Err("Incorrect padding".to_owned()),
    }
}

fn base64_digit(byte: u8) -> Option<u32> {
    Some(u32::from(match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => return None,
    }))
}
