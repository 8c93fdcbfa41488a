//! The `params` attribute of `xacro:macro`.
//!
//! The reference reads it with one regular expression; its backtracking is observable (a `${...}`
//! default may stretch to a later brace), so it is followed step by step here.

use super::macro_table::MacroParam;
use base::TextRange;

/// Python's `str.isspace` for one character.
pub(super) fn is_space(c: char) -> bool {
    c.is_whitespace() || ('\u{1c}'..='\u{1f}').contains(&c)
}

/// Python's `str.strip`.
pub(super) fn strip(text: &str) -> &str {
    text.trim_matches(is_space)
}

/// The parameters of a `params` text; `None` when it holds nothing but blanks, which the reference refuses.
pub fn parse(text: &str) -> Option<Vec<MacroParam>> {
    let mut params = Vec::new();
    let (mut text, mut at, mut is_cut) = (text, 0, false);
    let mut closings = Closings::default();
    while at < text.len() {
        let (param, next) = match with_default(text, at, &mut closings) {
            Some((param, next)) => {
                // the expression's last group ends with the line: what stands behind is lost
                if !std::mem::replace(&mut is_cut, true) {
                    let line = text.get(next..).and_then(|rest| rest.find('\n'));
                    text = line.and_then(|end| text.get(..next + end)).unwrap_or(text);
                }
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
fn bare_word(text: &str, at: usize) -> Option<(MacroParam, usize)> {
    let start = skip_spaces(text, at);
    let end = run(text, start, |c| !is_space(c));
    if start == end {
        return None;
    }
    Some((param(text, start, end, false, None), skip_spaces(text, end)))
}

/// `NAME := [^|]DEFAULT` followed by a blank or the end.
fn with_default(text: &str, at: usize, closings: &mut Closings) -> Option<(MacroParam, usize)> {
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
            if let Some((value_end, next)) = default_value(text, from + forward, closings) {
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

fn param(
    text: &str,
    start: usize,
    end: usize,
    forward: bool,
    default: Option<(usize, usize)>,
) -> MacroParam {
    let range = TextRange::new(start as u32, end as u32);
    MacroParam {
        name: range.slice(text).into(),
        range,
        definition: None,
        forward,
        default: default.map(|(start, end)| {
            let range = TextRange::new(start as u32, end as u32);
            (range.slice(text).into(), range)
        }),
        default_at: None,
    }
}

/// Lengths of the forward mark to try at `at`: `^|`, `^`, nothing.
fn forward_marks(text: &str, at: usize) -> impl Iterator<Item = usize> {
    let rest = text.get(at..).unwrap_or("");
    let longest = if rest.starts_with("^|") {
        2
    } else {
        usize::from(rest.starts_with('^'))
    };
    (0..=longest).rev()
}

/// The end of the default at `at`, and where the next parameter begins.
fn default_value(text: &str, at: usize, closings: &mut Closings) -> Option<(usize, usize)> {
    let bracketed = closings
        .curly
        .after(text, at, "${", '}')
        .or_else(|| closings.round.after(text, at, "$(", ')'));
    let end = bracketed.or_else(|| quoted_run(text, at)).unwrap_or(at);
    tail(text, end).map(|next| (end, next))
}

/// The closing brackets that were looked for last, so that a row of expressions that end nowhere is not searched
/// again from each of them.
#[derive(Default)]
struct Closings {
    curly: Closing,
    round: Closing,
}

/// What was found from `from` to `to`: the end of a closing bracket, or none up to the end of the line.
#[derive(Default)]
struct Closing {
    from: usize,
    to: usize,
    end: Option<usize>,
}

impl Closing {
    /// The end of `${...}`: the first closing bracket that is followed by a blank or the end.
    fn after(&mut self, text: &str, at: usize, open: &str, close: char) -> Option<usize> {
        let rest = text.get(at..)?.strip_prefix(open)?;
        let from = at + open.len();
        if !(self.from <= from && from < self.to) {
            let line = rest.split('\n').next().unwrap_or("");
            let ends = line.match_indices(close).map(|(i, _)| from + i + 1);
            let end = ends.into_iter().find(|&end| tail(text, end).is_some());
            *self = Self {
                from,
                to: end.unwrap_or(from + line.len()),
                end,
            };
        }
        self.end
    }
}

/// `'...'`, `"..."` and unquoted text in any order, to the blank or the end behind them.
///
/// A quotation may end at any later quote of its kind in the line. They are tried depth first, the nearest one first;
/// what follows depends on the position alone, so no quote is tried again once what is behind it did not fit.
fn quoted_run(text: &str, at: usize) -> Option<usize> {
    // of each kind the first quote whose later ones have all been tried
    let mut tried = [text.len(); 2];
    // a place, and for an opening quote from where on its end is looked for
    let mut stack = vec![(at, None)];
    while let Some((i, from)) = stack.pop() {
        let quote = char_at(text, i).filter(|c| matches!(c, '\'' | '"'));
        if let (Some(from), Some(quote)) = (from, quote) {
            let last = tried.get_mut(usize::from(quote == '"'))?;
            let rest = text.get(from..text.len().min(*last + 1)).unwrap_or("");
            match rest.find([quote, '\n']) {
                Some(j) if char_at(rest, j) == Some(quote) => {
                    stack.extend([(i, Some(from + j + 1)), (from + j + 1, None)]);
                }
                _ => *last = i.min(*last),
            }
        } else if i > at && tail(text, i).is_some() {
            return Some(i);
        } else if quote.is_some() {
            stack.push((i, Some(i + 1)));
        } else {
            let end = run(text, i, |c| !is_space(c) && c != '\'' && c != '"');
            if end > i {
                stack.push((end, None));
            }
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
    text.get(..at)
        .and_then(|head| head.char_indices().next_back())
        .map_or(0, |(i, _)| i)
}

#[cfg(test)]
mod tests {
    use super::parse;

    fn show(text: &str) -> String {
        let Some(params) = parse(text) else {
            return "error".into();
        };
        let one = |p: &super::MacroParam| {
            let default = p
                .default
                .as_ref()
                .map_or(String::new(), |(d, _)| format!("={d}"));
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
            ("a:='b'x'c d' e", "a='b'x'c d' | e"),
            ("a:='b\"c'd\"e' f\" g", "a='b\"c'd\"e' f\" | g"),
            ("a:='b\"c'\"d\"'e'\" f", "a='b\"c'\"d\"'e'\" | f"),
            (
                "a:=${x}y b:=${x}y c:=${x} d",
                "a=${x}y b:=${x}y c:=${x} | d",
            ),
            ("a:=${x}y\nb:=${x} c", "a=${x}y | b=${x} | c"),
        ];
        for (text, expected) in cases {
            assert_eq!(show(text), expected, "{text}");
        }
    }

    #[test]
    fn long_rows_take_no_longer_than_they_are() {
        let row = |piece: &str| parse(&piece.repeat(30_000)).map_or(0, |params| params.len());
        assert_eq!(row("x:='"), 1);
        assert_eq!(row("a:='x'\"y\""), 1);
        assert_eq!(row("'x\"y:="), 1);
        assert_eq!(row("a:=${b}c "), 30_000);
        assert_eq!(row("a:=$(b)c "), 30_000);
        assert_eq!(row("a:='b c'd "), 30_000);
    }
}
