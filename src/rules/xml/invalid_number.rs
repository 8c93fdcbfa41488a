//! A value that should be a number and is none.

use std::ops::Range;

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::meant::{self, Meant};
use super::walk;
use expand::{Origin, Place, XId};
use model::{Text, decimal, is_decimal};

pub(super) const RULE: Rule = Rule {
    code: "XML010",
    name: "invalid-number",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("invalid-number"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for Numeric { id, name, count, text } in numeric(cx) {
        if let Some(meant) = meant::of_numbers(cx, text, *count) {
            report_meant(cx, *id, name, text, meant, out);
            continue;
        }
        for range in bad_words(text, *count) {
            report(cx, *id, name, text, range, out);
        }
    }
}

/// An attribute that holds numbers.
#[derive(Debug)]
pub struct Numeric {
    /// Its element.
    pub id: XId,
    /// Its name.
    pub name: &'static str,
    /// How many numbers it holds.
    pub count: usize,
    /// Its value.
    pub text: Text,
}

/// Attributes that hold numbers. Those not known are left out.
pub(super) fn numeric<'a>(cx: &'a DocumentCx<'_>) -> &'a [Numeric] {
    cx.numeric.get_or_init(|| find_numeric(cx))
}

fn find_numeric(cx: &DocumentCx<'_>) -> Vec<Numeric> {
    let mut found = Vec::new();
    for (id, spec) in walk::known(cx) {
        for attribute in spec.attributes {
            let text = attribute.numbers().zip(Text::attr(&cx.expansion.tree, id, attribute.name));
            let judged = |text: &Text| {
                let open = text.value.contains("${") || text.value.contains("$(");
                text.is_known() && !open && !is_reported(cx, text.origin)
            };
            let text = text.filter(|(_, text)| judged(text));
            found.extend(text.map(|(count, text)| Numeric { id, name: attribute.name, count, text }));
        }
    }
    found
}

/// Whether expansion had something to say about a value.
pub(super) fn is_reported(cx: &DocumentCx<'_>, origin: Origin) -> bool {
    let Some(place) = cx.expansion.place(origin) else { return false };
    let inside = |at: Place| at.file == place.file && place.range.contains_range(at.range);
    cx.expansion.problems.iter().any(|problem| inside(problem.place))
}

/// The words that are no numbers. Of a single number also what follows it; an empty range when there is none.
pub(super) fn bad_words(text: &Text, count: usize) -> Vec<Range<usize>> {
    let is_bad = |range: &Range<usize>| text.value.get(range.clone()).is_none_or(|word| !is_decimal(word));
    let bad: Vec<Range<usize>> = text.words().filter(is_bad).collect();
    if count > 1 || !bad.is_empty() {
        return bad;
    }
    let whole = 0..text.value.len();
    let surplus = text.words().nth(1);
    let wrong = if text.words().next().is_none() { Some(whole) } else { surplus };
    wrong.into_iter().collect()
}

/// A value of which it is clear what it was meant to be.
fn report_meant(cx: &DocumentCx<'_>, id: XId, name: &str, text: &Text, meant: Meant, out: &mut Sink<'_>) {
    let Meant { help, value } = meant;
    let what = if text.words().nth(1).is_some() { "are no numbers" } else { "is not a number" };
    let message = format!("{}: `{}` in `{name}` {what}", walk::described(cx, id), text.value);
    let is_written = text.is_literal() && text.origin.range.len() as usize == text.value.len();
    let report = out.report(text.origin, message).help(format!("{help}: {name}=\"{value}\""));
    match is_written {
        true => report.replace_with(Safety::Unsafe, format!("write `{value}`"), value).done(),
        false => report.done(),
    }
}

fn report(cx: &DocumentCx<'_>, id: XId, name: &str, text: &Text, range: Range<usize>, out: &mut Sink<'_>) {
    let element = walk::described(cx, id);
    let word = text.value.get(range.clone()).unwrap_or_default();
    let origin = if word.is_empty() { text.origin } else { text.part(range.clone()) };
    let message = match word {
        "" | " " => format!("{element}: `{name}` is empty instead of a number"),
        word => format!("{element}: `{word}` in `{name}` is not a number"),
    };
    let report = out.report(origin, message);
    let repaired = word.replace(',', ".");
    let is_written = text.is_literal() && origin.range.len() as usize == word.len();
    if decimal(&repaired).is_some() && word.contains(',') && is_written {
        let report = report.help("decimals are written with a point");
        return report.replace_with(Safety::Unsafe, format!("write `{repaired}`"), repaired).done();
    }
    let help = match word.trim_start_matches(['+', '-']).to_ascii_lowercase().as_str() {
        "nan" | "inf" | "infinity" => "write a finite number",
        lower if lower.starts_with("0x") => "write it as a decimal number",
        _ => "write a decimal number such as 0.25 or 2.5e-3, without a unit",
    };
    report.help(help).done();
}
