//! Substitutions in launch files in XML: `$(arg name)`, `$(find-pkg-share name)`.

use base::TextRange;

use super::text::{Text, TextPiece};

/// Substitutions inside of substitutions that are followed.
const MOST_NESTED: usize = 8;

/// The text of an attribute, and the commands that it runs: `$(command 'xacro ...')`.
pub(super) fn text(
    value: &str,
    at: Option<TextRange>,
    folder: &str,
    commands: &mut Vec<Text>,
) -> Text {
    nested(value, at, folder, commands, 0)
}

fn nested(
    value: &str,
    at: Option<TextRange>,
    folder: &str,
    commands: &mut Vec<Text>,
    depth: usize,
) -> Text {
    let mut text = Text::default();
    let mut rest = value;
    while let Some((before, inner)) = rest.split_once("$(") {
        if !before.is_empty() {
            text.push(Text::plain(before, at));
        }
        let end = closing(inner);
        let code = inner.get(..end).unwrap_or(inner);
        text.push(if depth < MOST_NESTED && end < inner.len() {
            substitution(code, at, folder, commands, depth)
        } else {
            Text::opaque()
        });
        rest = inner.get(end + 1..).unwrap_or("");
    }
    if !rest.is_empty() {
        text.push(Text::plain(rest, at));
    }
    text
}

/// Where the bracket closes that was opened before.
fn closing(text: &str) -> usize {
    let mut depth = 1usize;
    for (at, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

fn substitution(
    code: &str,
    at: Option<TextRange>,
    folder: &str,
    commands: &mut Vec<Text>,
    depth: usize,
) -> Text {
    let code = code.trim();
    let (kind, rest) = code.split_once(char::is_whitespace).unwrap_or((code, ""));
    let rest = rest.trim();
    let mut inner = |text: &str| nested(text, at, folder, commands, depth + 1);
    match kind {
        "arg" | "var" => match inner(unquoted(rest)).literal() {
            Some(name) => Text(vec![TextPiece::Argument(name)]),
            None => Text::opaque(),
        },
        "find" | "find-pkg-share" => Text::share(inner(unquoted(rest))),
        "find-exec" => inner(unquoted(rest)),
        "dirname" => Text::plain(folder, None),
        "command" => {
            // the second word says what to do with what the command prints to its other output
            let line = inner(unquoted(without_mode(rest)));
            commands.push(line);
            Text::opaque()
        }
        _ => {
            inner(rest);
            Text::opaque()
        }
    }
}

/// A command without the word behind it that says what becomes of its errors.
fn without_mode(text: &str) -> &str {
    let bare = text.trim_end_matches(['"', '\'']);
    let before = ["warn", "ignore", "strict", "capture"]
        .iter()
        .find_map(|mode| bare.strip_suffix(mode));
    let before = before.map(|before| before.trim_end_matches(['"', '\'']).trim_end());
    before
        .filter(|before| before.ends_with(['"', '\'']))
        .unwrap_or(text)
}

fn unquoted(text: &str) -> &str {
    quoted(text).unwrap_or(text)
}

/// The text in the quotes that it begins with, to the last of them.
fn quoted(text: &str) -> Option<&str> {
    let quote = text.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    let end = text.rfind(quote).filter(|end| *end > 0)?;
    text.get(1..end)
}
