//! Escape sequences of string and bytes literals.

use std::iter::Peekable;
use std::str::CharIndices;

/// A broken escape sequence.
pub(super) struct EscapeError {
    pub(super) message: String,
    /// CPython's text.
    pub(super) reference: String,
}

/// A decoded string.
#[derive(Default)]
pub(super) struct DecodedString {
    pub(super) text: String,
    pub(super) error: Option<EscapeError>,
    /// Something Python can do and we cannot.
    pub(super) not_supported: Option<&'static str>,
}

/// Decode the escapes of a string; stops at the first error.
pub(super) fn decode_str(source: &str) -> DecodedString {
    let mut decoder = Decoder {
        source,
        chars: source.char_indices().peekable(),
        position: 0,
        out: DecodedString::default(),
    };
    while let Some((at, c)) = decoder.chars.next() {
        if c != '\\' {
            decoder.out.text.push(c);
            decoder.position += if c.is_ascii() { 1 } else { 10 };
        } else if !decoder.escape(at) {
            break;
        }
    }
    decoder.out
}

struct Decoder<'s> {
    source: &'s str,
    chars: Peekable<CharIndices<'s>>,
    /// Where we are in CPython's working copy, in which characters beyond ASCII take ten bytes.
    position: usize,
    out: DecodedString,
}

impl Decoder<'_> {
    /// The sequence whose backslash at `at` was just taken; false on an error.
    fn escape(&mut self, at: usize) -> bool {
        let Some((_, c)) = self.chars.next() else {
            self.out.text.push('\\');
            return true;
        };
        match c {
            'x' => return self.hex(2, "\\xXX"),
            'u' => return self.hex(4, "\\uXXXX"),
            'U' => return self.hex(8, "\\UXXXXXXXX"),
            'N' => return self.named(at),
            '0'..='7' => {
                let rest = self.source.get(at + 1..).unwrap_or("");
                let (value, len) = octal(rest.as_bytes());
                (1..len).for_each(|_| {
                    self.chars.next();
                });
                self.out.text.extend(char::from_u32(value));
                self.position += 1 + len;
                return true;
            }
            _ => {}
        }
        match simple(c) {
            Some(Some(value)) => self.out.text.push(value),
            Some(None) => {}
            None => {
                self.out.text.push('\\');
                self.out.text.push(c);
            }
        }
        self.position += if c.is_ascii() { 2 } else { 16 };
        true
    }

    fn hex(&mut self, digits: usize, form: &str) -> bool {
        let (mut value, mut read) = (0u32, 0);
        while read < digits
            && let Some(digit) = self.chars.peek().and_then(|(_, c)| c.to_digit(16))
        {
            value = value << 4 | digit;
            read += 1;
            self.chars.next();
        }
        if read < digits {
            let message = format!("`{form}` must be followed by {digits} hexadecimal digits");
            return self.fail(2 + read, &message, &format!("truncated {form} escape"));
        }
        match char::from_u32(value) {
            Some(c) => self.out.text.push(c),
            None if value <= 0x10_ffff => {
                self.out.text.push(char::REPLACEMENT_CHARACTER);
                self.out.not_supported = Some("half of a surrogate pair is not supported");
            }
            None => return self.fail(2 + read, "unknown character", "illegal Unicode character"),
        }
        self.position += 2 + read;
        true
    }

    /// `\N{NAME}`: known to Python, but we carry no table of names.
    fn named(&mut self, at: usize) -> bool {
        let rest = self.source.get(at + 2..).unwrap_or("");
        let message = "`\\N` must be followed by a name in braces";
        let Some(inner) = rest.strip_prefix('{') else {
            return self.fail(2, message, "malformed \\N character escape");
        };
        match inner.find('}') {
            None | Some(0) => {
                let len = if inner.starts_with('}') {
                    3
                } else {
                    3 + inner.len()
                };
                self.fail(len, message, "malformed \\N character escape")
            }
            Some(len) => {
                self.out.not_supported = Some("characters by name (`\\N{…}`) are not supported");
                self.out.text.push(char::REPLACEMENT_CHARACTER);
                let end = at + 4 + len;
                while self.chars.peek().is_some_and(|(i, _)| *i < end) {
                    self.chars.next();
                }
                self.position += 4 + len;
                true
            }
        }
    }

    fn fail(&mut self, len: usize, message: &str, what: &str) -> bool {
        let (first, last) = (self.position, self.position + len - 1);
        let reference = format!(
            "(unicode error) 'unicodeescape' codec can't decode bytes in position {first}-{last}: {what}"
        );
        self.out.error = Some(EscapeError {
            message: message.to_owned(),
            reference,
        });
        false
    }
}

/// Decode the escapes of a bytes literal (ASCII); stops at the first error.
pub(super) fn decode_bytes(source: &str) -> (Vec<u8>, Option<EscapeError>) {
    let mut out = Vec::with_capacity(source.len());
    let mut rest = source.as_bytes();
    while let Some((&first, tail)) = rest.split_first() {
        let at = source.len() - rest.len();
        rest = tail;
        if first != b'\\' {
            out.push(first);
            continue;
        }
        let Some((&c, tail)) = rest.split_first() else {
            out.push(first);
            break;
        };
        match c {
            b'x' => match hex_pair(tail) {
                Some(value) => {
                    out.push(value);
                    rest = tail.get(2..).unwrap_or(&[]);
                }
                None => {
                    let message = "`\\x` must be followed by two hexadecimal digits".to_owned();
                    let reference = format!("(value error) invalid \\x escape at position {at}");
                    return (out, Some(EscapeError { message, reference }));
                }
            },
            b'0'..=b'7' => {
                let (value, len) = octal(rest);
                out.push((value & 0xff) as u8);
                rest = rest.get(len..).unwrap_or(&[]);
            }
            _ => {
                rest = tail;
                match simple(char::from(c)) {
                    Some(value) => out.extend(value.map(|v| v as u8)),
                    None => out.extend([b'\\', c]),
                }
            }
        }
    }
    (out, None)
}

fn hex_pair(bytes: &[u8]) -> Option<u8> {
    let [high, low, ..] = bytes else { return None };
    let (high, low) = (char::from(*high), char::from(*low));
    u8::try_from(high.to_digit(16)? << 4 | low.to_digit(16)?).ok()
}

/// Up to three octal digits: value and count.
fn octal(bytes: &[u8]) -> (u32, usize) {
    let digits = bytes
        .iter()
        .take(3)
        .take_while(|b| (b'0'..=b'7').contains(b));
    digits.fold((0, 0), |(value, len), b| {
        (value << 3 | u32::from(b - b'0'), len + 1)
    })
}

/// One-character escapes: outer `None` if it is none, inner `None` for a line continuation.
fn simple(c: char) -> Option<Option<char>> {
    Some(Some(match c {
        '\n' => return Some(None),
        '\\' | '\'' | '"' => c,
        'a' => '\x07',
        'b' => '\x08',
        'f' => '\x0c',
        'n' => '\n',
        'r' => '\r',
        't' => '\t',
        'v' => '\x0b',
        _ => return None,
    }))
}
