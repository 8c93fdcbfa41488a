//! From bytes to text.

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE};

/// The text of a file.
pub(super) struct Decoded {
    /// The text, bad bytes replaced by U+FFFD.
    pub(super) text: String,
    /// Offset and description of the first bad byte.
    pub(super) error: Option<(u32, String)>,
}

/// Decode by byte order mark, else by the XML declaration, else as UTF-8.
pub(super) fn decode(bytes: Vec<u8>) -> Decoded {
    match bytes.as_slice() {
        [0xEF, 0xBB, 0xBF, rest @ ..] => utf8(rest.to_vec(), 3),
        [0xFF, 0xFE, rest @ ..] => legacy(UTF_16LE, "utf-16", rest, 2),
        [0xFE, 0xFF, rest @ ..] => legacy(UTF_16BE, "utf-16", rest, 2),
        [b'<', 0, b'?', 0, ..] => legacy(UTF_16LE, "utf-16", &bytes, 0),
        [0, b'<', 0, b'?', ..] => legacy(UTF_16BE, "utf-16", &bytes, 0),
        _ => match declared(&bytes) {
            None => utf8(bytes, 0),
            Some(label) => match Encoding::for_label(label.as_bytes()) {
                // A declaration in ASCII cannot be right about UTF-16.
                Some(encoding) if encoding != UTF_8 && encoding.is_ascii_compatible() => {
                    legacy(encoding, &label, &bytes, 0)
                }
                Some(_) => utf8(bytes, 0),
                None => {
                    let at = label_offset(&bytes);
                    let Decoded { text, .. } = utf8(bytes, 0);
                    Decoded { text, error: Some((at, format!("unknown encoding '{label}'"))) }
                }
            },
        },
    }
}

/// The encoding an XML declaration names.
fn declared(bytes: &[u8]) -> Option<String> {
    let head = bytes.strip_prefix(b"<?xml")?;
    let end = memchr::memmem::find(head, b"?>")?;
    let declaration = std::str::from_utf8(head.get(..end)?).ok()?;
    let (_, rest) = declaration.split_once("encoding")?;
    let value = rest.trim_start().strip_prefix('=')?.trim_start();
    let quote = value.chars().next().filter(|quote| matches!(quote, '"' | '\''))?;
    let (label, _) = value.get(1..)?.split_once(quote)?;
    Some(label.to_owned())
}

fn label_offset(bytes: &[u8]) -> u32 {
    offset(memchr::memmem::find(bytes, b"encoding").unwrap_or(0))
}

/// UTF-8 from the byte at `skipped` on; errors in the words of Python.
fn utf8(bytes: Vec<u8>, skipped: usize) -> Decoded {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return Decoded { text, error: None },
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
    let message = format!("'utf-8' codec can't decode byte 0x{byte:02x} in position {at}: {reason}");
    Decoded { text: String::from_utf8_lossy(bytes).into_owned(), error: Some((offset(at), message)) }
}

/// Any other encoding; `label` is its name for messages.
fn legacy(encoding: &'static Encoding, label: &str, bytes: &[u8], skipped: usize) -> Decoded {
    let valid = if label.eq_ignore_ascii_case("us-ascii") || label.eq_ignore_ascii_case("ascii") {
        Encoding::ascii_valid_up_to(bytes)
    } else {
        valid_up_to(encoding, bytes)
    };
    let (text, _) = encoding.decode_without_bom_handling(bytes);
    let error = (valid < bytes.len()).then(|| {
        let byte = bytes.get(valid).copied().unwrap_or_default();
        let at = skipped + valid;
        (offset(at), format!("'{label}' codec can't decode byte 0x{byte:02x} in position {at}"))
    });
    Decoded { text: text.into_owned(), error }
}

/// How many leading bytes are valid in `encoding`.
fn valid_up_to(encoding: &'static Encoding, bytes: &[u8]) -> usize {
    let mut decoder = encoding.new_decoder_without_bom_handling();
    let room = decoder.max_utf8_buffer_length_without_replacement(bytes.len()).unwrap_or(0);
    let mut sink = vec![0; room];
    match decoder.decode_to_utf8_without_replacement(bytes, &mut sink, true) {
        (encoding_rs::DecoderResult::Malformed(bad, behind), read, _) => {
            read.saturating_sub(usize::from(bad) + usize::from(behind))
        }
        _ => bytes.len(),
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
            mark.iter().copied().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect()
        };
        let table: Vec<(Vec<u8>, &str, Option<u32>)> = vec![
            (b"plain".to_vec(), "plain", None),
            ("\u{FEFF}<a/>é".into(), "<a/>é", None),
            (utf16("<a>ä€</a>", &[0xFF, 0xFE]), "<a>ä€</a>", None),
            (utf16("<?xml version='1.0'?><a/>", &[]), "<?xml version='1.0'?><a/>", None),
            (vec![0xFE, 0xFF, 0, b'<', 0, b'a'], "<a", None),
            (
                b"<?xml version='1.0' encoding='ISO-8859-1'?>\xe9".to_vec(),
                "<?xml version='1.0' encoding='ISO-8859-1'?>é",
                None,
            ),
            (
                b"<?xml encoding = \"windows-1252\" ?>\x80".to_vec(),
                "<?xml encoding = \"windows-1252\" ?>€",
                None,
            ),
            (b"<?xml encoding='us-ascii'?>\xe9".to_vec(), "<?xml encoding='us-ascii'?>é", Some(27)),
            (b"<?xml encoding='utf-8'?>a\xe9b".to_vec(), "<?xml encoding='utf-8'?>a\u{FFFD}b", Some(25)),
            (b"<?xml encoding='utf-16'?><a/>".to_vec(), "<?xml encoding='utf-16'?><a/>", None),
            (b"<?xml encoding='klingon'?>".to_vec(), "<?xml encoding='klingon'?>", Some(6)),
            (b"<?xml version='1.0'?>\xff".to_vec(), "<?xml version='1.0'?>\u{FFFD}", Some(21)),
            (
                b"<?xml encoding='shift_jis'?>ab\x81".to_vec(),
                "<?xml encoding='shift_jis'?>ab\u{FFFD}",
                Some(30),
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
            (b"ab\xe9", "'utf-8' codec can't decode byte 0xe9 in position 2: unexpected end of data"),
            (b"\xe9ab", "'utf-8' codec can't decode byte 0xe9 in position 0: invalid continuation byte"),
            (b"a\xff", "'utf-8' codec can't decode byte 0xff in position 1: invalid start byte"),
            (b"\x80", "'utf-8' codec can't decode byte 0x80 in position 0: invalid start byte"),
        ];
        for (bytes, message) in table {
            assert_eq!(decode(bytes.to_vec()).error.map(|(_, message)| message).as_deref(), Some(message));
        }
    }
}
