//! A value that should be a number and is none.
use std::ops::Range;

use super::super::context::{DocumentCx, RootKind, is_plain_urdf};
use super::super::edits::source_text;
use super::super::grouping::Group;
use super::super::numbers::rewrite;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::xml::seen::{CheckedElement, Numeric};
use super::meant::{self, MeantValue};
use super::walk;
use expand::{BindingId, Origin, XId, meant_number};
use model::{AttrValue, decimal, is_decimal};

pub(in super::super) static RULE: Rule = Rule {
    code: "XML010",
    name: "invalid-number",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("invalid-number"),
    check: Check::Number(check),
};

fn check(cx: &DocumentCx<'_>, number: &Numeric, out: &mut Sink<'_>) {
    let &Numeric {
        id,
        name,
        count,
        ref text,
    } = number;
    if is_decimal(&text.value) {
        return; // as nearly all are
    }
    let bad = bad_words(text, count);
    if bad.is_empty() {
        blanks(cx, (id, name), count, text, out);
    } else if let Some(meant) = meant::of_numbers(cx, text, count) {
        report_meant(cx, id, name, text, meant, out);
    } else {
        bad.into_iter()
            .for_each(|range| report(cx, id, name, text, range, out));
    }
}

/// The attributes of an element that hold numbers. Those not known are left out.
pub(in super::super) fn each_number(
    cx: &DocumentCx<'_>,
    element: &CheckedElement,
    mut each: impl FnMut(&Numeric),
) {
    let id = element.id;
    let attributes = element.known.map_or(&[][..], |spec| spec.attributes);
    for attribute in attributes {
        let Some((count, text)) =
            attribute
                .numbers()
                .zip(AttrValue::attr(&cx.expansion.tree, id, attribute.name))
        else {
            continue;
        };
        let open = text.value.contains("${") || text.value.contains("$(");
        // readers pass over what is newer than the robot
        if text.is_known()
            && !open
            && !is_reported(cx, text.origin)
            && !cx.is_older_than(attribute.since)
        {
            each(&Numeric {
                id,
                name: attribute.name,
                count,
                text,
            });
        }
    }
}

/// Blanks that urdfdom does not take: behind a number, and other ones than spaces between numbers.
fn blanks(
    cx: &DocumentCx<'_>,
    (id, name): (XId, &str),
    count: usize,
    text: &AttrValue,
    out: &mut Sink<'_>,
) {
    let trimmed = text.value.trim();
    if count == 1 {
        if text.value.trim_end().len() == text.value.len() {
            return;
        }
        let element = walk::described(cx, id);
        let message = format!(
            "`{name}` of {element} ends with whitespace, which urdfdom does not accept after a number"
        );
        let report = out
            .report(text.origin, message)
            .help(format!("write `{trimmed}`"));
        rewrite(report, Safety::Unsafe, text, trimmed.to_owned()).done();
    } else if text.is_literal()
        && is_plain(cx)
        && let Some((_, _, written)) = source_text(cx.expansion, text.origin)
        && let Some(blank) = blank_in_vector(&written)
    {
        let element = walk::described(cx, id);
        let message = format!(
            "{blank} between the numbers of `{name}` of {element}; urdfdom accepts only spaces"
        );
        let spaced = trimmed
            .split_ascii_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        let report = out
            .report(text.origin, message)
            // how somebody breaks lines
            .group(Group::File)
            .help(format!("write `{spaced}`"));
        rewrite(report, Safety::Unsafe, text, spaced).done();
    }
}

/// Whether readers take the values as they are written: xacro makes a space of each blank.
fn is_plain(cx: &DocumentCx<'_>) -> bool {
    let file = cx
        .expansion
        .files
        .first()
        .filter(|_| cx.kind == RootKind::Robot);
    file.is_some_and(|file| {
        let root = file.source.document.root();
        let declares_xacro = root.is_some_and(|root| root.attr("xmlns:xacro").is_some());
        is_plain_urdf(&file.source.path) && !declares_xacro && cx.expansion.files.len() == 1
    })
}

/// The tab or line break that makes urdfdom refuse a vector. It cuts the text at spaces, and of each part reads a
/// number, which blanks may precede and not follow.
fn blank_in_vector(value: &str) -> Option<&'static str> {
    let blank = value.split(' ').find_map(|part| {
        let last = part.chars().next_back();
        last.filter(|last| last.is_ascii_whitespace())
            .or_else(|| part.trim().chars().find(|c| c.is_ascii_whitespace()))
    })?;
    Some(if blank == '\t' {
        "a tab"
    } else {
        "a line break"
    })
}

/// Whether expansion had something to say about a value.
pub(super) fn is_reported(cx: &DocumentCx<'_>, origin: Origin) -> bool {
    let Some(place) = cx.expansion.place(origin) else {
        return false;
    };
    let mut places = cx.expansion.problems.iter().map(|problem| problem.place);
    let found = places.any(|at| at.file == place.file && place.range.contains_range(at.range));
    if found {
        // what is reported there may be gone after the next edit, wherever it is
        cx.look_beyond();
    }
    found
}

/// The words that are no numbers. Of a single number also what follows it; an empty range when there is none.
pub(super) fn bad_words(text: &AttrValue, count: usize) -> Vec<Range<usize>> {
    let is_bad = |range: &Range<usize>| {
        text.value
            .get(range.clone())
            .is_none_or(|word| !is_decimal(word))
    };
    let bad: Vec<Range<usize>> = text.words().filter(is_bad).collect();
    if count > 1 || !bad.is_empty() {
        return bad;
    }
    let whole = 0..text.value.len();
    let surplus = text.words().nth(1);
    let wrong = if text.words().next().is_none() {
        Some(whole)
    } else {
        surplus
    };
    wrong.into_iter().collect()
}

/// A value of which it is clear what it was meant to be.
fn report_meant(
    cx: &DocumentCx<'_>,
    id: XId,
    name: &str,
    text: &AttrValue,
    meant: MeantValue,
    out: &mut Sink<'_>,
) {
    let MeantValue { help, value } = meant;
    let what = if text.words().nth(1).is_some() {
        "is not a list of numbers"
    } else {
        "is not a number"
    };
    let message = format!(
        "`{1}` in `{name}` of {0} {what}",
        walk::described(cx, id),
        text.value
    );
    let is_written = text.is_literal() && text.origin.range.len() as usize == text.value.len();
    let report = out
        .report(text.origin, message)
        .help(format!("{help}: {name}=\"{value}\""));
    if is_written {
        report
            .replace_with(Safety::Unsafe, format!("replace with `{value}`"), value)
            .done()
    } else {
        report.done()
    }
}

fn report(
    cx: &DocumentCx<'_>,
    id: XId,
    name: &str,
    text: &AttrValue,
    range: Range<usize>,
    out: &mut Sink<'_>,
) {
    let element = walk::described(cx, id);
    let word = text.value.get(range.clone()).unwrap_or_default();
    if let Some(at) = written_at(cx, text, range.clone()) {
        return report_value(cx, (&element, name), word, at, out);
    }
    let origin = if word.is_empty() {
        text.origin
    } else {
        text.part(range.clone())
    };
    let message = match word {
        "" | " " => format!("`{name}` of {element} is empty; expected a number"),
        word => format!("`{word}` in `{name}` of {element} is not a number"),
    };
    let report = out.report(origin, message);
    let repaired = word.replace(',', ".");
    let is_written = text.is_literal() && origin.range.len() as usize == word.len();
    if decimal(&repaired).is_some() && word.contains(',') && is_written {
        let report = report.help("write a decimal point instead of a comma");
        return report
            .replace_with(
                Safety::Unsafe,
                format!("replace with `{repaired}`"),
                repaired,
            )
            .done();
    }
    if let Some(meant) = meant::of_word(cx, word).filter(|_| text.is_written(range)) {
        let report = report.help(format!("write `{meant}`: an expression is in `${{...}}`"));
        return report
            .replace_with(Safety::Unsafe, format!("replace with `{meant}`"), meant)
            .done();
    }
    let help = match word
        .trim_start_matches(['+', '-'])
        .to_ascii_lowercase()
        .as_str()
    {
        "nan" | "inf" | "infinity" => "write a finite number",
        lower if lower.starts_with("0x") => "write it as a decimal number",
        _ => "write a decimal number such as 0.25 or 2.5e-3, without a unit",
    };
    report.help(help).done();
}

/// Where a word is written that comes from a property, an argument or a parameter, and is a number with a slip.
fn written_at(cx: &DocumentCx<'_>, text: &AttrValue, range: Range<usize>) -> Option<Origin> {
    const MOST: usize = 64;
    let word = text.value.get(range.clone())?;
    if meant_number(word).is_none() && meant::name_of_property(cx, word).is_none() {
        return None;
    }
    let mut open: Vec<BindingId> = text.reads(cx.expansion, range).collect();
    let mut seen = 0;
    while let Some(read) = open.pop().filter(|_| seen < MOST) {
        seen += 1;
        let Some(binding) = cx.expansion.index.bindings.get(read) else {
            continue;
        };
        open.extend(cx.expansion.index.read_in(binding.reads));
        let Some(origin) = binding.origin else {
            continue;
        };
        if source_text(cx.expansion, origin).is_some_and(|(_, _, source)| source == word) {
            return Some(origin);
        }
    }
    None
}

/// A number with a slip, where it is written. What an expression could not do with it is said there already.
fn report_value(
    cx: &DocumentCx<'_>,
    (element, name): (&str, &str),
    word: &str,
    at: Origin,
    out: &mut Sink<'_>,
) {
    if is_reported(cx, at) {
        return;
    }
    let of_name = || {
        Some((
            meant::name_of_property(cx, word)?,
            "put the name of the property in `${...}`",
        ))
    };
    let Some((number, help)) = meant_number(word).or_else(of_name) else {
        return;
    };
    let message = format!("`{word}` in `{name}` of {element} is not a number");
    out.report(at, message)
        .help(format!("{help}: write `{number}`"))
        .replace_with(Safety::Unsafe, format!("replace with `{number}`"), number)
        .done();
}
