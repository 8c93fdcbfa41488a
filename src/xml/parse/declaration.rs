//! The grammar of the XML declaration.

use crate::chars::is_space;

/// A `name="value"` of the declaration: name, its offset, value, its offset.
type PseudoAttribute<'t> = (&'t str, usize, &'t str, usize);

/// Check what stands between `<?xml`, which ends at `at`, and the end of `text`. Gives whether the document
/// is declared to be standalone; the error is the offset where expat stops.
pub(super) fn check_declaration(text: &str, at: usize) -> Result<bool, usize> {
    let start = at;
    let (pair, mut at) = pair(text, at)?;
    match pair {
        Some(("version", ..)) => {}
        Some((_, start, ..)) => return Err(start),
        None => return Err(start),
    }
    let (mut found, end) = self::pair(text, at)?;
    at = end;
    if let Some(("encoding", _, value, start)) = found {
        if !value.starts_with(|c: char| c.is_ascii_alphabetic()) {
            return Err(start);
        }
        (found, at) = self::pair(text, at)?;
    }
    let standalone = match found {
        None => return Ok(false),
        Some(("standalone", _, value @ ("yes" | "no"), _)) => value == "yes",
        Some(("standalone", _, _, start)) | Some((_, start, ..)) => return Err(start),
    };
    let rest = text.get(at..).unwrap_or("");
    match rest.bytes().position(|b| !is_space(b)) {
        Some(n) => Err(at + n),
        None => Ok(standalone),
    }
}

/// The next pair and the offset behind it; no pair at the end.
fn pair(text: &str, start: usize) -> Result<(Option<PseudoAttribute<'_>>, usize), usize> {
    let bytes = text.as_bytes();
    let name = skip_space(bytes, start);
    if name == text.len() {
        return Ok((None, name));
    }
    if name == start {
        return Err(start);
    }
    let name_end = (name..text.len()).find(|&at| {
        bytes
            .get(at)
            .is_none_or(|&b| b == b'=' || is_space(b) || b >= 0x80)
    });
    let name_end = name_end.unwrap_or(text.len());
    let equals = skip_space(bytes, name_end);
    if bytes.get(equals) != Some(&b'=') {
        return Err(equals);
    }
    if name_end == name {
        return Err(name);
    }
    let quote = skip_space(bytes, equals + 1);
    let Some(open @ (b'"' | b'\'')) = bytes.get(quote) else {
        return Err(quote);
    };
    let allowed = |b: &u8| b.is_ascii_alphanumeric() || b".-_".contains(b);
    let mut end = quote + 1;
    while bytes.get(end).is_some_and(allowed) {
        end += 1;
    }
    if bytes.get(end) != Some(open) {
        return Err(end);
    }
    let (name_text, value) = (text.get(name..name_end), text.get(quote + 1..end));
    Ok((
        name_text.zip(value).map(|(n, v)| (n, name, v, quote + 1)),
        end + 1,
    ))
}

/// The offset behind the white space at `at`.
fn skip_space(bytes: &[u8], mut at: usize) -> usize {
    while bytes.get(at).is_some_and(|&b| is_space(b)) {
        at += 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_where_expat_sees_them() {
        for (text, expected) in [
            (" version='1.0'", None),
            (" version = \"1.0\" encoding='utf-8' standalone='no' ", None),
            (" version='1.0' standalone='yes'", None),
            ("", Some(0)),
            (" encoding='x'", Some(1)),
            (" version='1.0'encoding='x'", Some(14)),
            (" version='1.0' encoding='8'", Some(25)),
            (" version='1.0' standalone='maybe'", Some(27)),
            (" version='1.0' standalone='no' x='1'", Some(31)),
            (" version 1", Some(9)),
            (" version='1 0'", Some(11)),
        ] {
            assert_eq!(check_declaration(text, 0).err(), expected, "{text}");
        }
        assert_eq!(
            check_declaration(" version='1.0' standalone='yes'", 0),
            Ok(true)
        );
    }
}
