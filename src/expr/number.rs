//! Number literals: where they end, what is wrong with them, what they are worth.

use num_bigint::BigInt;
use num_traits::Num;

use super::ast::Const;
use base::limits::INTEGER_DIGITS;

/// A number literal at the start of some text.
pub(super) struct Scanned {
    /// How many bytes belong to it; with an error also the junk glued to it.
    pub(super) len: usize,
    /// CPython's complaint.
    pub(super) error: Option<String>,
}

/// Scan a number literal; `bytes` starts with a digit, or a dot and a digit.
pub(super) fn scan(bytes: &[u8]) -> Scanned {
    let mut cursor = NumberReader { bytes, pos: 0 };
    match cursor.literal() {
        Ok(()) => Scanned {
            len: cursor.pos,
            error: None,
        },
        Err(error) => {
            cursor.pos += bytes
                .iter()
                .skip(cursor.pos)
                .take_while(|b| b.is_ascii_alphanumeric() || **b == b'_')
                .count();
            Scanned {
                len: cursor.pos,
                error: Some(error),
            }
        }
    }
}

struct NumberReader<'b> {
    bytes: &'b [u8],
    pos: usize,
}

impl NumberReader<'_> {
    fn peek(&self, ahead: usize) -> Option<u8> {
        self.bytes.get(self.pos + ahead).copied()
    }

    fn at(&self, lower: u8) -> bool {
        self.peek(0)
            .is_some_and(|b| b.to_ascii_lowercase() == lower)
    }

    fn at_digit(&self) -> bool {
        self.peek(0).is_some_and(|b| b.is_ascii_digit())
    }

    fn literal(&mut self) -> Result<(), String> {
        if self.peek(0) == Some(b'0') {
            let radix = match self.peek(1).map(|b| b.to_ascii_lowercase()) {
                Some(b'x') => Some((16, "hexadecimal")),
                Some(b'o') => Some((8, "octal")),
                Some(b'b') => Some((2, "binary")),
                _ => None,
            };
            if let Some((radix, name)) = radix {
                self.pos += 2;
                return self.radix_digits(radix, name);
            }
        }
        let octal_looking = self.leading_zeros()?;
        let whole_end = self.pos;
        if self.peek(0) == Some(b'.') {
            self.pos += 1;
            if self.at_digit() {
                self.decimal_digits()?;
            }
        }
        let exponent = self.exponent()?;
        if self.at(b'j') {
            self.pos += 1;
            return self.ends("imaginary");
        }
        if octal_looking && self.pos == whole_end && !exponent {
            return Err(
                "leading zeros in decimal integer literals are not permitted; \
                 use an 0o prefix for octal integers"
                    .into(),
            );
        }
        self.ends("decimal")
    }

    /// The whole part; true if it is a zero followed by other digits.
    fn leading_zeros(&mut self) -> Result<bool, String> {
        let start = self.pos;
        if self.at_digit() {
            self.decimal_digits()?;
        }
        let digits = self.bytes.get(start..self.pos).unwrap_or(&[]);
        Ok(digits.first() == Some(&b'0') && digits.iter().any(|b| (b'1'..=b'9').contains(b)))
    }

    /// Digits with single underscores between them.
    fn decimal_digits(&mut self) -> Result<(), String> {
        loop {
            while self.at_digit() {
                self.pos += 1;
            }
            if self.peek(0) != Some(b'_') {
                return Ok(());
            }
            self.pos += 1;
            if !self.at_digit() {
                return Err("invalid decimal literal".into());
            }
        }
    }

    /// `e`, sign and digits; an `e` that starts a word such as `else` is left alone.
    fn exponent(&mut self) -> Result<bool, String> {
        if !self.at(b'e') {
            return Ok(false);
        }
        match (self.peek(1), self.peek(2)) {
            (Some(b'+' | b'-'), Some(d)) if d.is_ascii_digit() => self.pos += 2,
            (Some(b'+' | b'-'), _) => return Err("invalid decimal literal".into()),
            (Some(d), _) if d.is_ascii_digit() => self.pos += 1,
            _ => return Ok(false),
        }
        self.decimal_digits()?;
        Ok(true)
    }

    fn radix_digits(&mut self, radix: u32, name: &str) -> Result<(), String> {
        loop {
            if self.peek(0) == Some(b'_') {
                self.pos += 1;
            }
            let start = self.pos;
            while self.peek(0).is_some_and(|b| char::from(b).is_digit(radix)) {
                self.pos += 1;
            }
            match self.peek(0) {
                Some(b) if b.is_ascii_digit() => {
                    return Err(format!(
                        "invalid digit '{}' in {name} literal",
                        char::from(b)
                    ));
                }
                _ if self.pos == start => return Err(format!("invalid {name} literal")),
                Some(b'_') => {}
                _ => return self.ends(name),
            }
        }
    }

    /// A number may touch a word only if that is (the start of) an operator keyword; CPython wants some
    /// of these as whole words.
    fn ends(&self, name: &str) -> Result<(), String> {
        let rest = self.bytes.get(self.pos..).unwrap_or(&[]);
        let in_word = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_' || *b >= 0x80;
        let whole: [&[u8]; 5] = [b"and", b"else", b"for", b"or", b"not"];
        let starts: [&[u8]; 3] = [b"if", b"in", b"is"];
        if starts.iter().any(|k| rest.starts_with(k))
            || whole
                .iter()
                .any(|k| rest.starts_with(k) && !rest.get(k.len()).is_some_and(in_word))
        {
            return Ok(());
        }
        match rest.first() {
            Some(b) if b.is_ascii_alphanumeric() || *b == b'_' => {
                Err(format!("invalid {name} literal"))
            }
            _ => Ok(()),
        }
    }
}

/// The value of a literal that [`scan`] accepted.
///
/// # Errors
/// CPython's text when the integer has too many digits.
pub(super) fn value(text: &str) -> Result<Const, String> {
    let digits: String;
    let plain = if text.contains('_') {
        digits = text.replace('_', "");
        &digits
    } else {
        text
    };
    let radix = match plain.as_bytes() {
        [b'0', b'x' | b'X', ..] => 16,
        [b'0', b'o' | b'O', ..] => 8,
        [b'0', b'b' | b'B', ..] => 2,
        _ => 10,
    };
    if radix != 10 {
        return Ok(integer(plain.get(2..).unwrap_or("0"), radix));
    }
    if let Some(number) = plain.strip_suffix(['j', 'J']) {
        return Ok(Const::Imaginary(float(number)));
    }
    if plain.bytes().any(|b| !b.is_ascii_digit()) {
        return Ok(Const::Float(float(plain)));
    }
    if plain.len() > INTEGER_DIGITS {
        return Err(format!(
            "Exceeds the limit ({INTEGER_DIGITS} digits) for integer string conversion: value has {} digits; \
             use sys.set_int_max_str_digits() to increase the limit - Consider hexadecimal for huge \
             integer literals to avoid decimal conversion limits.",
            plain.len()
        ));
    }
    Ok(integer(plain, 10))
}

fn integer(digits: &str, radix: u32) -> Const {
    match i64::from_str_radix(digits, radix) {
        Ok(small) => Const::Int(small),
        Err(_) => BigInt::from_str_radix(digits, radix).map_or(Const::Int(0), Const::Big),
    }
}

/// Rust reads every float Python does, once the underscores are gone.
fn float(text: &str) -> f64 {
    text.parse().unwrap_or(0.0)
}
