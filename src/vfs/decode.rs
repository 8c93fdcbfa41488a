//! From bytes to text.

/// The text of a file.
pub(super) struct DecodedText {
    /// The text, bad bytes replaced by U+FFFD.
    pub(super) text: String,
    /// Offset and description of the first bad byte.
    pub(super) error: Option<(u32, String)>,
}

/// Decode as UTF-8, whatever the XML declaration says: that is how the reference opens every file. Bytes
/// that are not UTF-8 are an error; for people they are shown in the encoding they seem to have, as far as the
/// feature `encodings` goes.
pub(super) fn decode(bytes: Vec<u8>) -> DecodedText {
    let marked = match bytes.as_slice() {
        // a second mark is no longer a mark: the parser has to see that there were two
        [0xEF, 0xBB, 0xBF, 0xEF, 0xBB, 0xBF, ..] => return utf8(bytes, 0),
        [0xEF, 0xBB, 0xBF, rest @ ..] => return utf8(rest.to_vec(), 3),
        [0xFF, 0xFE, rest @ ..] => Some(utf16(rest, u16::from_le_bytes)),
        [0xFE, 0xFF, rest @ ..] => Some(utf16(rest, u16::from_be_bytes)),
        [b'<', 0, b'?', 0, ..] => Some(utf16(&bytes, u16::from_le_bytes)),
        [0, b'<', 0, b'?', ..] => Some(utf16(&bytes, u16::from_be_bytes)),
        _ => None,
    };
    if let Some(text) = marked {
        let error = utf8(bytes.clone(), 0)
            .error
            .or_else(|| Some((0, "the file is UTF-16".to_owned())));
        return DecodedText { text, error };
    }
    #[cfg(feature = "encodings")]
    if let Some(text) = as_declared(&bytes) {
        let error = utf8(bytes, 0).error;
        return DecodedText { text, error };
    }
    utf8(bytes, 0)
}

/// The text of UTF-16; half a character and half a pair become U+FFFD.
fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let (units, rest) = bytes.as_chunks();
    let letters = char::decode_utf16(units.iter().map(|&bytes| unit(bytes)));
    let letters = letters.map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER));
    letters
        .chain(rest.first().map(|_| char::REPLACEMENT_CHARACTER))
        .collect()
}

/// The text of bytes that are not UTF-8 and that an XML declaration says are something else.
#[cfg(feature = "encodings")]
fn as_declared(bytes: &[u8]) -> Option<String> {
    use encoding_rs::{Encoding, UTF_8};

    let encoding = Encoding::for_label(declared(bytes)?.as_bytes())?;
    let is_other = encoding != UTF_8 && encoding.is_ascii_compatible();
    (is_other && std::str::from_utf8(bytes).is_err()).then(|| {
        let (text, _) = encoding.decode_without_bom_handling(bytes);
        text.into_owned()
    })
}

/// The encoding an XML declaration names.
#[cfg(feature = "encodings")]
fn declared(bytes: &[u8]) -> Option<String> {
    let head = bytes.strip_prefix(b"<?xml")?;
    let end = memchr::memmem::find(head, b"?>")?;
    let declaration = std::str::from_utf8(head.get(..end)?).ok()?;
    let (_, rest) = declaration.split_once("encoding")?;
    let value = rest.trim_start().strip_prefix('=')?.trim_start();
    let quote = value
        .chars()
        .next()
        .filter(|quote| matches!(quote, '"' | '\''))?;
    let (label, _) = value.get(1..)?.split_once(quote)?;
    Some(label.to_owned())
}

/// UTF-8 from the byte at `skipped` on; errors in the words of Python.
fn utf8(bytes: Vec<u8>, skipped: usize) -> DecodedText {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return DecodedText { text, error: None },
        Err(error) => error,
    };
    let at = error.utf8_error().valid_up_to();
    let bytes = error.as_bytes();
    let byte = bytes.get(at).copied().unwrap_or_default();
    let reason = match error.utf8_error().error_len() {
        None => "unexpected end of data",
        Some(_) if matches!(byte, 0xC2..=0xF4) => "invalid continuation byte",
        Some(_) => "invalid start byte",
    };
    let at = skipped + at;
    let message =
        format!("'utf-8' codec can't decode byte 0x{byte:02x} in position {at}: {reason}");
    DecodedText {
        text: String::from_utf8_lossy(bytes).into_owned(),
        error: Some((offset(at), message)),
    }
}

fn offset(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::decode;

    #[test]
    fn encodings() {
        let utf16 = |text: &str, mark: &[u8]| -> Vec<u8> {
            mark.iter()
                .copied()
                .chain(text.encode_utf16().flat_map(u16::to_le_bytes))
                .collect()
        };
        let shown = |with: &'static str, without: &'static str| {
            if cfg!(feature = "encodings") {
                with
            } else {
                without
            }
        };
        let table: Vec<(Vec<u8>, &str, Option<u32>)> = vec![
            (b"plain".to_vec(), "plain", None),
            ("\u{FEFF}<a/>é".into(), "<a/>é", None),
            ("\u{FEFF}\u{FEFF}<a/>".into(), "\u{FEFF}\u{FEFF}<a/>", None),
            (utf16("<a>ä€</a>", &[0xFF, 0xFE]), "<a>ä€</a>", Some(0)),
            (
                utf16("<?xml version='1.0'?><a/>", &[]),
                "<?xml version='1.0'?><a/>",
                Some(0),
            ),
            (vec![0xFE, 0xFF, 0, b'<', 0, b'a'], "<a", Some(0)),
            (
                vec![0xFE, 0xFF, 0xD8, 0x3D, 0, b'a', 0],
                "\u{FFFD}a\u{FFFD}",
                Some(0),
            ),
            (
                "<?xml encoding='ISO-8859-1'?>é".into(),
                "<?xml encoding='ISO-8859-1'?>é",
                None,
            ),
            (
                b"<?xml encoding='ISO-8859-1'?>\xe9".to_vec(),
                shown(
                    "<?xml encoding='ISO-8859-1'?>é",
                    "<?xml encoding='ISO-8859-1'?>\u{FFFD}",
                ),
                Some(29),
            ),
            (
                b"<?xml encoding = \"windows-1252\" ?>\x80".to_vec(),
                shown(
                    "<?xml encoding = \"windows-1252\" ?>€",
                    "<?xml encoding = \"windows-1252\" ?>\u{FFFD}",
                ),
                Some(34),
            ),
            (
                b"<?xml encoding='utf-8'?>a\xe9b".to_vec(),
                "<?xml encoding='utf-8'?>a\u{FFFD}b",
                Some(25),
            ),
            (
                b"<?xml encoding='utf-16'?><a/>".to_vec(),
                "<?xml encoding='utf-16'?><a/>",
                None,
            ),
            (
                b"<?xml encoding='klingon'?>".to_vec(),
                "<?xml encoding='klingon'?>",
                None,
            ),
            (
                b"<?xml version='1.0'?>\xff".to_vec(),
                "<?xml version='1.0'?>\u{FFFD}",
                Some(21),
            ),
        ];
        for (bytes, text, bad) in table {
            let decoded = decode(bytes);
            assert_eq!(decoded.text, text);
            assert_eq!(decoded.error.map(|(at, _)| at), bad, "{text}");
        }
    }

    #[test]
    fn utf8_errors_read_like_python() {
        let table: [(&[u8], &str); 4] = [
            (
                b"ab\xe9",
                "'utf-8' codec can't decode byte 0xe9 in position 2: unexpected end of data",
            ),
            (
                b"\xe9ab",
                "'utf-8' codec can't decode byte 0xe9 in position 0: invalid continuation byte",
            ),
            (
                b"a\xff",
                "'utf-8' codec can't decode byte 0xff in position 1: invalid start byte",
            ),
            (
                b"\x80",
                "'utf-8' codec can't decode byte 0x80 in position 0: invalid start byte",
            ),
        ];
        for (bytes, message) in table {
            assert_eq!(
                decode(bytes.to_vec())
                    .error
                    .map(|(_, message)| message)
                    .as_deref(),
                Some(message)
            );
        }
    }
}
