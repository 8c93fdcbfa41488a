//! Where a half-typed expression ends: in a name, behind a dot, in a text. Read off the tokens of the splitter and of
//! the lexer, so that quotes, escapes and brackets mean here what they mean when the expression is evaluated.

use base::TextRange;
use expr::{TemplateToken, WordKind, split, words};

/// Brackets of `${…}` and `$(…)` that are open inside of each other and that are looked into.
const MOST_NESTED: usize = 8;

/// What a text ends in the middle of, the innermost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnclosedCode<'t> {
    /// Behind a `$`.
    Dollar,
    /// The code of `${…`, or of `$(eval …`, in which arguments are names.
    Code { code: &'t str, is_eval: bool },
    /// What stands behind `$(`.
    Substitution(&'t str),
}

/// What is open at the end of a text.
pub fn unclosed(text: &str) -> Option<UnclosedCode<'_>> {
    let mut found = None;
    let mut start = 0;
    for _ in 0..MOST_NESTED {
        let rest = text.get(start..)?;
        match split(rest).tokens.last() {
            Some(TemplateToken::Text(_)) if rest.ends_with('$') => {
                return Some(UnclosedCode::Dollar);
            }
            // what is open inside is what is typed: `${xacro.load_yaml('$(find `
            Some(TemplateToken::Invalid {
                range,
                unclosed: Some(lead),
            }) => {
                start += range.start as usize + lead.len();
                found = Some(of_bracket(lead, text.get(start..)?));
            }
            // `$$`, which the reference refuses: what is typed behind it can be helped all the same
            Some(TemplateToken::Invalid {
                range,
                unclosed: None,
            }) => {
                let refused = range.slice(rest);
                let dollars = refused.len() - refused.trim_start_matches('$').len();
                start += range.start as usize + dollars;
            }
            _ => break,
        }
    }
    found
}

fn of_bracket<'t>(lead: &str, inside: &'t str) -> UnclosedCode<'t> {
    let eval = inside.strip_prefix("eval ");
    match (lead, eval) {
        ("${", _) => UnclosedCode::Code {
            code: inside,
            is_eval: false,
        },
        (_, Some(code)) => UnclosedCode::Code {
            code,
            is_eval: true,
        },
        _ => UnclosedCode::Substitution(inside),
    }
}

/// Where code ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CodeContext<'t> {
    /// Behind a number, or something else that no name can follow.
    Outside,
    /// In a string; what is in it begins at `start`.
    Text { start: usize, opened: Opened<'t> },
    /// Behind the dot of `object`, in a name that begins at `start`.
    Member { object: &'t str, start: usize },
    /// In a name, maybe an empty one.
    Name { start: usize, opened: Opened<'t> },
}

/// What a string or a name stands in, when it is the first thing behind a bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opened<'t> {
    /// Nothing of those below.
    Nothing,
    /// The index of this object; that is empty in a list.
    Index(&'t str),
    /// The call of this function.
    Call(&'t str),
}

/// Where the text of an expression ends.
pub fn cursor(code: &str) -> CodeContext<'_> {
    let words = Words::of(code);
    let Some((last, before)) = words.found.split_last() else {
        return words.name(&[], code.len());
    };
    let (range, kind) = *last;
    let start = range.start as usize;
    if kind == WordKind::OpenString {
        return CodeContext::Text {
            start: start + opening_length(range.slice(code)),
            opened: words.opened(before),
        };
    }
    let touches = range.end as usize == code.len();
    match kind {
        _ if words.is_comment_behind(range.end) => CodeContext::Outside,
        WordKind::Number if touches => CodeContext::Outside,
        WordKind::Name | WordKind::Keyword if touches => words.name(before, start),
        WordKind::String => CodeContext::Outside,
        WordKind::Operator if matches!(range.slice(code), "]" | ")") => CodeContext::Outside,
        _ => words.name(&words.found, code.len()),
    }
}

/// The length of what is in front of the characters of a string: its prefix and its quotes.
fn opening_length(string: &str) -> usize {
    let prefix = string.find(['\'', '"']).unwrap_or(0);
    let quotes = string.get(prefix..).unwrap_or("");
    let is_triple = ["'''", "\"\"\""]
        .iter()
        .any(|triple| quotes.starts_with(triple));
    prefix + if is_triple { 3 } else { 1 }
}

/// The innermost call that is open at the end of code: what is called, and how many commas stand in front.
pub fn open_call(code: &str) -> Option<(&str, usize)> {
    let words = Words::of(code);
    let mut open: Vec<(&str, usize, usize)> = Vec::new();
    for (at, &(range, kind)) in words.found.iter().enumerate() {
        if kind != WordKind::Operator {
            continue;
        }
        match range.slice(code) {
            bracket @ ("(" | "[" | "{") => open.push((bracket, at, 0)),
            closer @ (")" | "]" | "}") => {
                let same = open
                    .iter()
                    .rposition(|(bracket, ..)| *bracket == opener(closer));
                open.truncate(same.unwrap_or(open.len()));
            }
            "," => {
                if let Some((.., commas)) = open.last_mut() {
                    *commas += 1;
                }
            }
            _ => {}
        }
    }
    let calls = open.iter().rev().filter(|(bracket, ..)| *bracket == "(");
    calls
        .map(|&(_, at, commas)| (words.chain(words.found.get(..at).unwrap_or(&[])), commas))
        .find(|(name, _)| !name.is_empty())
}

fn opener(closer: &str) -> &'static str {
    match closer {
        ")" => "(",
        "]" => "[",
        _ => "{",
    }
}

/// The tokens of code that is cut off at its end.
struct Words<'t> {
    code: &'t str,
    found: Vec<(TextRange, WordKind)>,
}

impl<'t> Words<'t> {
    fn of(code: &'t str) -> Self {
        // line ends in the value of an attribute are blanks
        let found = if code.contains(['\n', '\r']) {
            words(&code.replace(['\n', '\r'], " "))
        } else {
            words(code)
        };
        Self { code, found }
    }

    fn text(&self, word: &(TextRange, WordKind)) -> &'t str {
        word.0.slice(self.code)
    }

    /// Whether code ends in a comment that begins behind its last token.
    fn is_comment_behind(&self, end: u32) -> bool {
        let rest = self.code.get(end as usize..);
        rest.is_some_and(|rest| rest.contains('#'))
    }

    /// A name that begins at `start`, behind these tokens.
    fn name(&self, before: &[(TextRange, WordKind)], start: usize) -> CodeContext<'t> {
        match before.split_last() {
            Some((dot, object)) if self.text(dot) == "." => match self.chain(object) {
                "" => CodeContext::Outside,
                object => CodeContext::Member { object, start },
            },
            _ => CodeContext::Name {
                start,
                opened: self.opened(before),
            },
        }
    }

    /// What the bracket belongs to that is the last of these tokens.
    fn opened(&self, before: &[(TextRange, WordKind)]) -> Opened<'t> {
        match before.split_last() {
            Some((bracket, object)) if self.text(bracket) == "[" => {
                Opened::Index(self.chain(object))
            }
            Some((bracket, called)) if self.text(bracket) == "(" => {
                Opened::Call(self.chain(called))
            }
            _ => Opened::Nothing,
        }
    }

    /// The names, indices and calls that tokens end in: `cam['mass'].head` of `2 * cam['mass'].head`.
    fn chain(&self, words: &[(TextRange, WordKind)]) -> &'t str {
        let mut rest = words;
        let mut start = None;
        while let Some((last, before)) = rest.split_last() {
            let is_index = matches!(self.text(last), "]" | ")");
            match last.1 {
                WordKind::Name | WordKind::String => {
                    start = Some(last.0.start);
                    rest = match before.split_last() {
                        Some((dot, object)) if self.text(dot) == "." => object,
                        _ => break,
                    };
                }
                WordKind::Operator if is_index => match self.opening(rest) {
                    Some((bracket, object)) => (start, rest) = (Some(bracket), object),
                    None => break,
                },
                _ => break,
            }
        }
        let end = words.last().map_or(0, |(range, _)| range.end);
        start.map_or("", |start| TextRange::new(start, end).slice(self.code))
    }

    /// Where the bracket begins that the last of these tokens closes, and the tokens in front of it.
    fn opening<'w>(
        &self,
        words: &'w [(TextRange, WordKind)],
    ) -> Option<(u32, &'w [(TextRange, WordKind)])> {
        let closer = self.text(words.last()?);
        let mut depth = 0;
        for (at, word) in words.iter().enumerate().rev() {
            let text = self.text(word);
            if text == closer {
                depth += 1;
            } else if text == opener(closer) {
                depth -= 1;
            }
            if depth == 0 {
                return Some((word.0.start, words.get(..at)?));
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{CodeContext, Opened, UnclosedCode, Words, cursor, open_call, unclosed};

    #[test]
    fn what_is_unclosed() {
        let code = |code| {
            Some(UnclosedCode::Code {
                code,
                is_eval: false,
            })
        };
        for (text, expected) in [
            ("a ${b", code("b")),
            ("a ${b} $(arg c", Some(UnclosedCode::Substitution("arg c"))),
            (
                "a $(eval b",
                Some(UnclosedCode::Code {
                    code: "b",
                    is_eval: true,
                }),
            ),
            (
                "${xacro.load_yaml('$(find ",
                Some(UnclosedCode::Substitution("find ")),
            ),
            ("${load_yaml('$(find x)/", code("load_yaml('$(find x)/")),
            ("a$", Some(UnclosedCode::Dollar)),
            ("${a$", Some(UnclosedCode::Dollar)),
            ("$${a", None),
            ("$$", None),
            ("a $$ ${b", code("b")),
            ("${a}", None),
            ("", None),
        ] {
            assert_eq!(unclosed(text), expected, "{text}");
        }
    }

    /// Without an end: brackets that are opened again and again.
    #[test]
    fn brackets_are_opened_often() {
        let text = "${".repeat(1000);
        assert!(matches!(unclosed(&text), Some(UnclosedCode::Code { .. })));
    }

    #[test]
    fn cursors() {
        let name = |start| CodeContext::Name {
            start,
            opened: Opened::Nothing,
        };
        let member = |object, start| CodeContext::Member { object, start };
        for (code, expected) in [
            ("", name(0)),
            ("2 * m", name(4)),
            ("a and ", name(6)),
            ("1.5", CodeContext::Outside),
            ("12", CodeContext::Outside),
            ("1.", CodeContext::Outside),
            ("(1 + 2).", member("(1 + 2)", 8)),
            ("cam.ma", member("cam", 4)),
            ("2*cam['a.b'].", member("cam['a.b']", 13)),
            ("cam['a']", CodeContext::Outside),
            ("a # ", CodeContext::Outside),
            (" .a", CodeContext::Outside),
        ] {
            assert_eq!(cursor(code), expected, "{code}");
        }
    }

    #[test]
    fn brackets_in_front_of_the_cursor() {
        let text = |start, opened| CodeContext::Text { start, opened };
        let name = |start, opened| CodeContext::Name { start, opened };
        for (code, expected) in [
            ("cam['", text(5, Opened::Index("cam"))),
            ("a.cam[ 'k", text(8, Opened::Index("a.cam"))),
            ("cam[", name(4, Opened::Index("cam"))),
            ("[", name(1, Opened::Index(""))),
            (
                "xacro.load_yaml('x/",
                text(17, Opened::Call("xacro.load_yaml")),
            ),
            ("f(a, 'x", text(6, Opened::Nothing)),
            // a line end in an attribute is a blank, and ends no string
            ("f('a\nb", text(3, Opened::Call("f"))),
            ("f(r'''a", text(6, Opened::Call("f"))),
        ] {
            assert_eq!(cursor(code), expected, "{code}");
        }
    }

    /// An escaped quote ends no string, whatever is asked.
    #[test]
    fn escaped_quotes() {
        assert_eq!(
            cursor(r"f('\'"),
            CodeContext::Text {
                start: 3,
                opened: Opened::Call("f")
            }
        );
        assert_eq!(open_call(r"f('\'(', "), Some(("f", 1)));
        assert_eq!(
            cursor(r"d['\')'].x"),
            CodeContext::Member {
                object: r"d['\')']",
                start: 9
            }
        );
    }

    fn chain(code: &str) -> &str {
        let words = Words::of(code);
        words.chain(&words.found)
    }

    #[test]
    fn chains() {
        assert_eq!(chain("2 * f(a, b)[1].c"), "f(a, b)[1].c");
        assert_eq!(chain("(1 + a)"), "(1 + a)");
        assert_eq!(chain("x if (a)"), "(a)");
        assert_eq!(chain("'a'[0]"), "'a'[0]");
        assert_eq!(chain("a + "), "");
    }

    #[test]
    fn calls() {
        assert_eq!(open_call("1 + max(a, [b, c], "), Some(("max", 2)));
        assert_eq!(open_call("math.sin("), Some(("math.sin", 0)));
        assert_eq!(open_call("sin(x)"), None);
        assert_eq!(open_call("f('(', "), Some(("f", 1)));
        assert_eq!(open_call("f(a, (b, "), Some(("f", 1)));
        assert_eq!(open_call("f(a[1, 2), b"), None);
    }
}
