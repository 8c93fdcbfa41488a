//! Where a half-typed expression ends: in a name, behind a dot, in a text.

/// What a text ends in the middle of; the offset is that of what is inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum UnclosedDelimiter {
    /// `$`; its own offset.
    Dollar(usize),
    /// `${…`
    Code(usize),
    /// `$(…`
    Substitution(usize),
}

/// What is open at the end of a text, the innermost.
pub(super) fn hole(text: &str) -> Option<UnclosedDelimiter> {
    let mut pos = 0;
    loop {
        let rest = text.get(pos..)?;
        let dollar = pos + rest.find('$')?;
        let dollars = text
            .get(dollar..)?
            .bytes()
            .take_while(|b| *b == b'$')
            .count();
        let behind = dollar + dollars;
        let open = text.get(behind..)?.chars().next();
        let (close, make): (char, fn(usize) -> UnclosedDelimiter) = match open {
            None if dollars == 1 => return Some(UnclosedDelimiter::Dollar(dollar)),
            None => return None,
            Some('{') if dollars == 1 => ('}', UnclosedDelimiter::Code),
            Some('(') if dollars == 1 => (')', UnclosedDelimiter::Substitution),
            Some(_) => {
                pos = behind;
                continue;
            }
        };
        let start = behind + 1;
        match text.get(start..)?.find(close) {
            Some(end) => pos = start + end + 1,
            // what is open inside is what is typed: `${xacro.load_yaml('$(find `
            None => {
                return hole(text.get(start..)?)
                    .map(|inner| inner.shifted(start))
                    .or(Some(make(start)));
            }
        }
    }
}

impl UnclosedDelimiter {
    fn shifted(self, by: usize) -> Self {
        match self {
            UnclosedDelimiter::Dollar(at) => UnclosedDelimiter::Dollar(at + by),
            UnclosedDelimiter::Code(at) => UnclosedDelimiter::Code(at + by),
            UnclosedDelimiter::Substitution(at) => UnclosedDelimiter::Substitution(at + by),
        }
    }
}

/// Where code ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cursor<'t> {
    /// Behind a number, or something else that no name can follow.
    Outside,
    /// In a string; what is in it begins at `start`.
    Text { start: usize },
    /// Behind the dot of `object`, in a name that begins at `start`.
    Member { object: &'t str, start: usize },
    /// In a name, maybe an empty one.
    Name { start: usize },
}

/// Where the text of an expression ends.
pub(super) fn cursor(code: &str) -> Cursor<'_> {
    if let Some(start) = open_text(code) {
        return Cursor::Text { start };
    }
    let start = code.rfind(|c: char| !is_word(c)).map_or(0, |at| {
        at + code
            .get(at..)
            .and_then(|rest| rest.chars().next())
            .map_or(1, char::len_utf8)
    });
    let (before, word) = (
        code.get(..start).unwrap_or(""),
        code.get(start..).unwrap_or(""),
    );
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        return Cursor::Outside;
    }
    let before = before.trim_end();
    match before.strip_suffix('.') {
        Some(object) => match chain_before(object) {
            "" => Cursor::Outside,
            number if number.bytes().all(|b| b.is_ascii_digit()) => Cursor::Outside,
            object => Cursor::Member { object, start },
        },
        None if word.is_empty() && before.ends_with(['\'', '"', ']', ')']) => Cursor::Outside,
        None => Cursor::Name { start },
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Where the string begins that is open at the end.
fn open_text(code: &str) -> Option<usize> {
    let mut open: Option<(char, usize)> = None;
    let mut escaped = false;
    for (at, c) in code.char_indices() {
        match open {
            Some(_) if escaped => escaped = false,
            Some(_) if c == '\\' => escaped = true,
            Some((quote, _)) if c == quote => open = None,
            None if matches!(c, '\'' | '"') => open = Some((c, at + 1)),
            _ => {}
        }
    }
    open.map(|(_, start)| start)
}

/// The names, indices and calls that a text ends in: `cam['mass'].head` of `2 * cam['mass'].head`.
pub(super) fn chain_before(text: &str) -> &str {
    let text = text.trim_end();
    let mut start = text.len();
    loop {
        let before = text.get(..start).unwrap_or("");
        let word = before.trim_end_matches(is_word).len();
        if word < start {
            start = word;
            match before.get(..word).unwrap_or("").strip_suffix('.') {
                Some(object) => start = object.len(),
                None => break,
            }
        } else if before.ends_with([']', ')']) {
            match opening(before) {
                Some(at) => start = at,
                None => break,
            }
        } else {
            break;
        }
    }
    text.get(start..).unwrap_or("").trim_start_matches('.')
}

/// The bracket that the one at the end closes.
fn opening(text: &str) -> Option<usize> {
    let mut depth = 0;
    let mut quote: Option<char> = None;
    for (at, c) in text.char_indices().rev() {
        match quote {
            Some(open) if c == open => quote = None,
            Some(_) => {}
            None => match c {
                '\'' | '"' => quote = Some(c),
                ']' | ')' => depth += 1,
                '[' | '(' => {
                    depth -= 1;
                    if depth == 0 {
                        return Some(at);
                    }
                }
                _ => {}
            },
        }
    }
    None
}

/// The innermost call that is open at the end of code: what is called, and how many commas stand in front.
pub(super) fn open_call(code: &str) -> Option<(&str, usize)> {
    let mut open: Vec<(char, usize, usize)> = Vec::new();
    let mut quote: Option<char> = None;
    for (at, c) in code.char_indices() {
        match quote {
            Some(open) if c == open => quote = None,
            Some(_) => {}
            None => match c {
                '\'' | '"' => quote = Some(c),
                '(' | '[' | '{' => open.push((c, at, 0)),
                ')' | ']' | '}' => {
                    open.pop();
                }
                ',' => {
                    if let Some((_, _, commas)) = open.last_mut() {
                        *commas += 1;
                    }
                }
                _ => {}
            },
        }
    }
    let calls = open.iter().rev().filter(|(bracket, ..)| *bracket == '(');
    calls
        .map(|&(_, at, commas)| (chain_before(code.get(..at).unwrap_or("")), commas))
        .find(|(name, _)| !name.is_empty())
}

#[cfg(test)]
mod tests {
    use super::{Cursor, UnclosedDelimiter, chain_before, cursor, hole, open_call};

    #[test]
    fn holes() {
        for (text, expected) in [
            ("a ${b", Some(UnclosedDelimiter::Code(4))),
            ("a ${b} $(arg c", Some(UnclosedDelimiter::Substitution(9))),
            (
                "${xacro.load_yaml('$(find ",
                Some(UnclosedDelimiter::Substitution(21)),
            ),
            ("a$", Some(UnclosedDelimiter::Dollar(1))),
            ("$${a", None),
            ("$$", None),
            ("${a}", None),
        ] {
            assert_eq!(hole(text), expected, "{text}");
        }
    }

    #[test]
    fn cursors() {
        for (code, expected) in [
            ("", Cursor::Name { start: 0 }),
            ("2 * m", Cursor::Name { start: 4 }),
            ("1.5", Cursor::Outside),
            ("12", Cursor::Outside),
            (
                "cam.ma",
                Cursor::Member {
                    object: "cam",
                    start: 4,
                },
            ),
            (
                "2*cam['a.b'].",
                Cursor::Member {
                    object: "cam['a.b']",
                    start: 13,
                },
            ),
            ("cam['", Cursor::Text { start: 5 }),
            ("cam['a']", Cursor::Outside),
        ] {
            assert_eq!(cursor(code), expected, "{code}");
        }
    }

    #[test]
    fn chains_and_calls() {
        assert_eq!(chain_before("2 * f(a, b)[1].c"), "f(a, b)[1].c");
        assert_eq!(chain_before("(1 + a)"), "(1 + a)");
        assert_eq!(open_call("1 + max(a, [b, c], "), Some(("max", 2)));
        assert_eq!(open_call("math.sin("), Some(("math.sin", 0)));
        assert_eq!(open_call("sin(x)"), None);
        assert_eq!(open_call("f('(', "), Some(("f", 1)));
    }
}
