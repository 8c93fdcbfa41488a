//! The `params` attribute of `xacro:macro`.
//!
//! The reference reads it with one regular expression; its backtracking is observable (a `${...}`
//! default may stretch to a later brace), so it is followed step by step here.

use ecow::EcoString;

use super::scope::Param;
use crate::base::TextRange;

/// Python's `str.isspace` for one character.
pub(super) fn is_space(c: char) -> bool {
    c.is_whitespace() || ('\u{1c}'..='\u{1f}').contains(&c)
}

/// Python's `str.strip`.
pub(super) fn strip(text: &str) -> &str {
    text.trim_matches(is_space)
}

/// The parameters of a `params` text; `None` when it holds nothing but blanks, which the reference refuses.
pub fn parse(text: &str) -> Option<Vec<Param>> {
    let mut params = Vec::new();
    let (mut text, mut at) = (text, 0);
    while at < text.len() {
        let (param, next) = match with_default(text, at) {
            Some((param, next)) => {
                // the expression's last group ends with the line: what stands behind is lost
                let line = text.get(next..).and_then(|rest| rest.find('\n'));
                text = line.and_then(|end| text.get(..next + end)).unwrap_or(text);
                (param, next)
            }
            None => bare_word(text, at)?,
        };
        params.push(param);
        at = next;
    }
    Some(params)
}

/// A word up to the next blank: a parameter without default.
fn bare_word(text: &str, at: usize) -> Option<(Param, usize)> {
    let start = skip_spaces(text, at);
    let end = run(text, start, |c| !is_space(c));
    if start == end {
        return None;
    }
    Some((param(text, start, end, false, None), skip_spaces(text, end)))
}

/// `NAME := [^|]DEFAULT` followed by a blank or the end.
fn with_default(text: &str, at: usize) -> Option<(Param, usize)> {
    let start = skip_spaces(text, at);
    let end = run(text, start, |c| !is_space(c) && c != ':' && c != '=');
    let mut i = skip_spaces(text, end);
    if start == end {
        return None;
    }
    if char_at(text, i) == Some(':') {
        i += 1;
    }
    if char_at(text, i) != Some('=') {
        return None;
    }
    i += 1;
    let value_start = skip_spaces(text, i);
    // the regular expression gives back blanks, then the `|` and the `^`, when the rest does not fit
    let mut from = value_start;
    loop {
        for forward in forward_marks(text, from) {
            if let Some((value_end, next)) = default_value(text, from + forward) {
                let value = (value_end > from + forward).then_some((from + forward, value_end));
                return Some((param(text, start, end, forward > 0, value), next));
            }
        }
        if from == i {
            return None;
        }
        from = prev_boundary(text, from);
    }
}

fn param(text: &str, start: usize, end: usize, forward: bool, default: Option<(usize, usize)>) -> Param {
    let range = |start: usize, end: usize| TextRange::new(start as u32, end as u32);
    let slice = |start: usize, end: usize| EcoString::from(text.get(start..end).unwrap_or(""));
    Param {
        name: slice(start, end),
        range: range(start, end),
        definition: None,
        forward,
        default: default.map(|(start, end)| (slice(start, end), range(start, end))),
    }
}

/// Lengths of the forward mark to try at `at`: `^|`, `^`, nothing.
fn forward_marks(text: &str, at: usize) -> impl Iterator<Item = usize> {
    let rest = text.get(at..).unwrap_or("");
    let longest = if rest.starts_with("^|") { 2 } else { usize::from(rest.starts_with('^')) };
    (0..=longest).rev()
}

/// The end of the default at `at`, and where the next parameter begins.
fn default_value(text: &str, at: usize) -> Option<(usize, usize)> {
    bracketed(text, at, "${", '}')
        .or_else(|| bracketed(text, at, "$(", ')'))
        .or_else(|| quoted_run(text, at))
        .or_else(|| tail(text, at).map(|next| (at, next)))
}

/// `${...}`: to the first closing bracket that is followed by a blank or the end.
fn bracketed(text: &str, at: usize, open: &str, close: char) -> Option<(usize, usize)> {
    let rest = text.get(at..)?.strip_prefix(open)?;
    let line = rest.split('\n').next().unwrap_or("");
    line.match_indices(close).find_map(|(i, _)| {
        let end = at + open.len() + i + 1;
        tail(text, end).map(|next| (end, next))
    })
}

/// `'...'`, `"..."` and unquoted text in any order, followed by a blank or the end.
fn quoted_run(text: &str, at: usize) -> Option<(usize, usize)> {
    let mut failed = vec![false; text.len().saturating_sub(at) + 1];
    // a place, and for an opening quote from where on its end is looked for
    let mut stack = vec![(at, None)];
    // depth first, shortest pieces first, each position tried once: what follows depends on the position alone
    while let Some((i, from)) = stack.pop() {
        if let (Some(from), Some(quote)) = (from, char_at(text, i)) {
            let rest = text.get(from..)?;
            if let Some(j) = rest.find([quote, '\n'])
                && char_at(rest, j) == Some(quote)
            {
                let end = from + j + 1;
                stack.extend([(i, Some(end)), (end, None)]);
            }
            continue;
        }
        if i > at
            && let Some(next) = tail(text, i)
        {
            return Some((i, next));
        }
        match failed.get_mut(i - at) {
            Some(seen) if !*seen => *seen = true,
            _ => continue,
        }
        match char_at(text, i) {
            Some('\'' | '"') => stack.push((i, Some(i + 1))),
            Some(c) if !is_space(c) => {
                let end = run(text, i, |c| !is_space(c) && c != '\'' && c != '"');
                stack.push((end, None));
            }
            _ => {}
        }
    }
    None
}

/// Where the next parameter begins when `at` is followed by a blank or the end.
fn tail(text: &str, at: usize) -> Option<usize> {
    let rest = text.get(at..)?;
    if rest.is_empty() || rest == "\n" {
        return Some(text.len());
    }
    let next = skip_spaces(text, at);
    (next > at).then_some(next)
}

fn skip_spaces(text: &str, at: usize) -> usize {
    run(text, at, is_space)
}

fn run(text: &str, at: usize, accept: impl Fn(char) -> bool) -> usize {
    let rest = text.get(at..).unwrap_or("");
    at + rest.find(|c| !accept(c)).unwrap_or(rest.len())
}

fn char_at(text: &str, at: usize) -> Option<char> {
    text.get(at..)?.chars().next()
}

fn prev_boundary(text: &str, at: usize) -> usize {
    text.get(..at).and_then(|head| head.char_indices().next_back()).map_or(0, |(i, _)| i)
}

#[cfg(test)]
mod tests {
    use super::parse;

    fn show(text: &str) -> String {
        let Some(params) = parse(text) else { return "error".into() };
        let one = |p: &super::Param| {
            let default = p.default.as_ref().map_or(String::new(), |(d, _)| format!("={d}"));
            format!("{}{}{default}", p.name, if p.forward { "^" } else { "" })
        };
        params.iter().map(one).collect::<Vec<_>>().join(" | ")
    }

    #[test]
    fn parameter_lists() {
        let cases = [
            ("", ""),
            ("   ", "error"),
            ("a b  c ", "a | b | c"),
            ("a:=1 b=2", "a=1 | b=2"),
            ("a := 1", "a=1"),
            ("a:= b", "a=b"),
            ("a:=", "a"),
            ("a:=^ b:=^|3 c:=^|", "a^ | b^=3 | c^"),
            ("a:='1 2 3' *b **c", "a='1 2 3' | *b | **c"),
            ("a:=${x + 1} b", "a=${x + 1} | b"),
            ("a:=${x}_s b:=${y}", "a=${x}_s b:=${y}"),
            ("a:=${x}_s b", "a=${x}_s | b"),
            ("a:=$(arg x) b", "a=$(arg x) | b"),
            ("a:='x b", "a:='x | b"),
            ("a:= 'x b", "a | 'x | b"),
            ("a:=^'x b", "a:=^'x | b"),
            ("a:=^|^ b", "a^=^ | b"),
            ("=x b", "=x | b"),
            ("a:='b'c'd' e", "a='b'c'd' | e"),
            ("a:=it's b", "a:=it's | b"),
            ("a:=x='1 2'y", "a=x='1 2'y"),
            ("a:b c", "a:b | c"),
            ("a:=1 b:=2\nc", "a=1 | b=2"),
            ("a:=1\nb c", "a=1 | b | c"),
            ("a\nb", "a | b"),
        ];
        for (text, expected) in cases {
            assert_eq!(show(text), expected, "{text}");
        }
    }
}
