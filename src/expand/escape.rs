//! Text as XML.

/// `& < > "` as references, the rest as it is.
pub(super) fn escape(out: &mut String, text: &str) {
    let mut from = 0;
    for (i, byte) in text.bytes().enumerate() {
        let reference = match byte {
            b'&' => "&amp;",
            b'<' => "&lt;",
            b'>' => "&gt;",
            b'"' => "&quot;",
            _ => continue,
        };
        out.push_str(text.get(from..i).unwrap_or(""));
        out.push_str(reference);
        from = i + 1;
    }
    out.push_str(text.get(from..).unwrap_or(""));
}
