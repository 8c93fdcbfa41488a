//! Numbers in values: how to write them, and how to turn degrees into radians.
use std::ops::Range;

use super::edits::{is_called, source_text, speaks_xacro};
use super::rule::Safety;
use super::sink::Reported;
use base::FastSet;
use expand::{BindingId, BindingKind, Expansion, Origin};
use model::{AttrValue, decimal};

/// From here on, a limit, an effort or a velocity means "unknown" or "unlimited", whatever its unit.
pub(super) const UNLIMITED: f64 = 1e3;

/// Bindings that are looked at to see what a value was made with.
const MOST_READS: usize = 64;
/// Bindings that are looked at to explain a value.
const MOST_DEFINITIONS: usize = 8;

/// A number with at most six digits behind the point.
pub(super) fn short(number: f64) -> String {
    digits(number, 6)
}

/// A number with at most so many digits behind the point.
fn digits(number: f64, most: usize) -> String {
    let text = format!("{number:.most$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// A vector as URDF writes it.
pub(super) fn vector(numbers: &[f64]) -> String {
    numbers
        .iter()
        .map(|&number| short(number))
        .collect::<Vec<_>>()
        .join(" ")
}

/// The whole of a value.
pub(super) fn whole(text: &AttrValue) -> Range<usize> {
    0..text.value.len()
}

/// Whether an angle is given in radians although it is more than a turn: a multiple of 15 degrees to four digits, or one
/// of half a turn that was computed.
pub(super) fn is_part_of_pi(angle: f64) -> bool {
    /// From here on, numbers in degrees come too close to multiples.
    const MOST: f64 = 100.0;
    (angle.abs() < MOST && is_multiple(angle, std::f64::consts::PI / 12.0, 1e-4))
        || is_multiple(angle, std::f64::consts::PI, 1e-9)
}

fn is_multiple(angle: f64, step: f64, tolerance: f64) -> bool {
    let steps = angle / step;
    (steps - steps.round()).abs() < tolerance
}

/// With the fix to take the part `range` of a value, the reported text, for degrees.
pub(super) fn from_degrees<'s, 'a>(
    report: Reported<'s, 'a>,
    expansion: &Expansion,
    text: &AttrValue,
    range: Range<usize>,
) -> Reported<'s, 'a> {
    let report = with_definitions(
        report,
        expansion,
        text.reads(expansion, range.clone()).collect(),
    );
    let origin = text.part(range.clone());
    let Some((_, _, source)) = source_text(expansion, origin) else {
        return report;
    };
    let inner = source
        .trim()
        .strip_prefix("${")
        .and_then(|rest| rest.strip_suffix('}'));
    let value = text.value.get(range).and_then(decimal);
    let new = match (inner, value) {
        (Some(inner), _) if !inner.contains('}') && !is_called(expansion, origin) => {
            format!("${{radians({inner})}}")
        }
        (None, Some(value)) if decimal(source.trim()) == Some(value) => {
            if speaks_xacro(expansion, origin) {
                format!("${{radians({})}}", source.trim())
            } else {
                digits(value.to_radians(), 10)
            }
        }
        _ => return report,
    };
    report.replace_with(
        Safety::Unsafe,
        format!("convert from degrees: `{new}`"),
        new,
    )
}

/// Whether the part `range` of a value comes from a property or an argument that somebody gave a number, as opposed to a
/// number in place or an expression of constants.
pub(super) fn comes_from_a_name(
    expansion: &Expansion,
    text: &AttrValue,
    range: Range<usize>,
) -> bool {
    let mut reads: Vec<BindingId> = text.reads(expansion, range).collect();
    let mut seen = FastSet::default();
    while let Some(read) = reads.pop() {
        let Some(binding) = expansion
            .index
            .bindings
            .get(read)
            .filter(|_| seen.insert(read))
        else {
            continue;
        };
        if binding.kind != BindingKind::Parameter && binding.origin.is_some() {
            return true;
        }
        reads.extend(expansion.index.read_in(binding.reads));
    }
    false
}

/// Whether one of these names stands in the expressions that the part `range` of a value was made with.
pub(super) fn is_made_with(
    expansion: &Expansion,
    text: &AttrValue,
    range: Range<usize>,
    names: &[&str],
) -> bool {
    let has_name = |origin: Origin| {
        let source = source_text(expansion, origin).map_or_else(String::new, |(_, _, text)| text);
        let mut words = source.split(|c: char| !c.is_alphanumeric() && c != '_');
        source.contains("${") && words.any(|word| names.contains(&word))
    };
    if has_name(text.part(range.clone())) {
        return true;
    }
    let mut reads: Vec<BindingId> = text.reads(expansion, range).collect();
    let mut seen = FastSet::default();
    while let Some(read) = reads.pop() {
        if seen.len() > MOST_READS || !seen.insert(read) {
            continue;
        }
        let Some(binding) = expansion.index.bindings.get(read) else {
            continue;
        };
        if binding.origin.is_some_and(has_name) || names.contains(&binding.name.as_str()) {
            return true;
        }
        reads.extend(expansion.index.read_in(binding.reads));
    }
    false
}

/// With the properties and arguments that a value comes from, however many parameters it went through.
fn with_definitions<'s, 'a>(
    mut report: Reported<'s, 'a>,
    expansion: &Expansion,
    mut reads: Vec<BindingId>,
) -> Reported<'s, 'a> {
    let mut seen = FastSet::default();
    while let Some(read) = reads.pop() {
        let Some(binding) = expansion
            .index
            .bindings
            .get(read)
            .filter(|_| seen.insert(read))
        else {
            continue;
        };
        let origin = binding
            .origin
            .filter(|_| binding.kind != BindingKind::Parameter);
        match origin {
            // a long list of definitions explains nothing
            Some(origin) if seen.len() <= MOST_DEFINITIONS => {
                report = report.also(origin, format!("`{}` is passed here", binding.name));
            }
            Some(_) => {}
            None => reads.extend(expansion.index.read_in(binding.reads)),
        }
    }
    report
}

/// With the fix to write something else for a value, when the source holds the value itself.
pub(super) fn rewrite<'s, 'a>(
    report: Reported<'s, 'a>,
    safety: Safety,
    text: &AttrValue,
    new: String,
) -> Reported<'s, 'a> {
    if text.is_literal() {
        report.replace_with(safety, format!("replace with `{new}`"), new)
    } else {
        report
    }
}
