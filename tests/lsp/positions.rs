//! Positions as the protocol counts them, and places of edits and findings.

use serde_json::{Value, json};

/// `line:start-end code`, lines from 1, columns as the protocol counts.
pub fn short(diagnostic: &Value) -> String {
    let (start, end) = (&diagnostic["range"]["start"], &diagnostic["range"]["end"]);
    let line = start["line"].as_u64().unwrap() + 1;
    format!(
        "{line}:{}-{} {}",
        start["character"],
        end["character"],
        diagnostic["code"].as_str().unwrap()
    )
}

/// The position of a byte offset, in UTF-16.
pub fn position(text: &str, offset: usize) -> Value {
    let before = &text[..offset];
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    json!({ "line": before.matches('\n').count(), "character": before[line_start..].encode_utf16().count() })
}

/// The byte offset of a position in UTF-16.
pub fn offset(text: &str, position: &Value) -> usize {
    let line = usize::try_from(position["line"].as_u64().unwrap()).unwrap();
    let start = text
        .split_inclusive('\n')
        .take(line)
        .map(str::len)
        .sum::<usize>();
    let mut left = position["character"].as_u64().unwrap();
    for (at, c) in text[start..].char_indices() {
        if left == 0 {
            return start + at;
        }
        left = left.saturating_sub(c.len_utf16() as u64);
    }
    text.len()
}

/// Put `new` in place of what the edits of a rename replace; how many there are.
pub fn replace_all(text: &mut String, edits: &Value, new: &str) -> usize {
    let edits = edits.as_array().unwrap().iter();
    let mut edits: Vec<(usize, usize)> = edits
        .map(|edit| {
            (
                offset(text, &edit["range"]["start"]),
                offset(text, &edit["range"]["end"]),
            )
        })
        .collect();
    edits.sort_unstable();
    for &(start, end) in edits.iter().rev() {
        text.replace_range(start..end, new);
    }
    edits.len()
}
