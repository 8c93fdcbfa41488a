//! The same thing written in another way: angles, paths, attributes in their usual order, URDF as xacro.

use super::place::element_at;
use super::{Action, ActionKind, edit};
use crate::paths::{FileKind, FileTarget, file_name_at};
use crate::{Cx, LocatedNode, NodePart, locate, schema};
use base::TextRange;
use rules::RuleEnv;
use vfs::SourceFile;

fn rewrite(title: impl Into<String>, edits: Vec<rules::Edit>) -> Action {
    Action {
        title: title.into(),
        kind: ActionKind::Rewrite,
        edits,
    }
}

/// A number in radians as `${radians(...)}`, and the other way round.
pub(super) fn angle(source: &SourceFile, offset: u32) -> Option<Action> {
    let document = &source.document;
    let at: LocatedNode<'_> = locate(document, offset);
    let (NodePart::AttrValue(attr), Some(node)) = (at.part, at.node) else {
        return None;
    };
    let speaks_xacro = document.root()?.attr("xmlns:xacro").is_some();
    if !speaks_xacro || !schema::is_angle(node, attr.name()) {
        return None;
    }
    let whole = at.shift(attr.value_range());
    let raw = attr.raw();
    let inside = (offset - whole.start) as usize;
    for (start, part) in words(raw) {
        let end = start + part.len();
        if inside < start || inside > end {
            continue;
        }
        let word = TextRange::new(whole.start + start as u32, whole.start + end as u32);
        let degrees = part
            .strip_prefix("${radians(")
            .and_then(|rest| rest.strip_suffix(")}"));
        if let Some(degrees) = degrees.and_then(|text| text.trim().parse::<f64>().ok()) {
            let radians = shown(degrees.to_radians(), 15);
            let edits = vec![edit(source, word, radians.clone())];
            return Some(rewrite(format!("convert angle to `{radians}` rad"), edits));
        }
        let text = format!("${{radians({})}}", round_degrees(part)?);
        let edits = vec![edit(source, word, text.clone())];
        return Some(rewrite(format!("convert angle to `{text}`"), edits));
    }
    None
}

/// The angle that somebody has written in radians with some digits: whole or half degrees, as far as the digits say.
/// Other numbers are no angles that somebody thought of in degrees.
fn round_degrees(radians: &str) -> Option<String> {
    /// With fewer digits, several angles round to the number.
    const DIGITS: usize = 4;
    let number = radians
        .parse::<f64>()
        .ok()
        .filter(|number| number.is_finite() && *number != 0.0)?;
    let decimals = radians.split_once('.').map_or("", |(_, decimals)| decimals);
    let digits = radians
        .chars()
        .filter(char::is_ascii_digit)
        .skip_while(|digit| *digit == '0')
        .count();
    let degrees = (number.to_degrees() * 2.0).round() / 2.0;
    let unit = 10f64.powi(-(decimals.len() as i32));
    let fits = (degrees.to_radians() - number).abs() <= unit;
    (digits >= DIGITS && fits && !radians.contains(['e', 'E'])).then(|| near_whole(degrees))
}

/// What begins the comment with the angles in degrees.
const NOTE: &str = "<!-- rpy in degrees:";

/// The angles of an `rpy` as a comment in degrees behind the element, or, where there is one, the angles it says.
pub(super) fn degrees_note(source: &SourceFile, offset: u32) -> Option<Action> {
    let document = &source.document;
    let at = locate(document, offset);
    let (NodePart::AttrValue(attr), Some(node)) = (at.part, at.node) else {
        return None;
    };
    let end = at.shift(node.range()).end;
    let written =
        angles(attr.raw()).filter(|_| attr.name() == "rpy" && node.end_tag().is_none())?;
    let behind = document.slice(TextRange::new(end, end.saturating_add(200)));
    let line = behind.lines().next().unwrap_or("");
    let note = line
        .trim_start()
        .strip_prefix(NOTE)
        .and_then(|rest| rest.split_once("-->"));
    if let Some((degrees, _)) = note {
        let degrees = angles(degrees)?;
        let far = written
            .iter()
            .zip(degrees)
            .any(|(old, new)| (old - new.to_radians()).abs() > 1e-3);
        let text = degrees.map(|angle| shown(angle.to_radians(), 15)).join(" ");
        let edits = vec![edit(source, at.shift(attr.value_range()), text)];
        return far.then(|| rewrite("set angles from the comment", edits));
    }
    if written == [0.0; 3] {
        return None;
    }
    let degrees = written
        .map(|angle| near_whole(angle.to_degrees()))
        .join(" ");
    let edits = vec![edit(
        source,
        TextRange::empty(end),
        format!(" {NOTE} {degrees} -->"),
    )];
    Some(rewrite("add comment with angles in degrees", edits))
}

/// Three numbers with white space between them.
fn angles(text: &str) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = text
        .split_whitespace()
        .map(|word| word.parse().ok().filter(|n: &f64| n.is_finite()))
        .collect();
    numbers?.try_into().ok()
}

/// Words of a value; an expression is one word.
fn words(raw: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let (mut start, mut depth) = (None, 0u32);
    for (at, c) in raw.char_indices() {
        match c {
            '{' | '(' => depth += 1,
            '}' | ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if c.is_whitespace() && depth == 0 {
            if let Some(begin) = start.take() {
                found.push((begin, raw.get(begin..at).unwrap_or("")));
            }
        } else if start.is_none() {
            start = Some(at);
        }
    }
    found.extend(start.map(|begin| (begin, raw.get(begin..).unwrap_or(""))));
    found
}

/// Degrees that are a whole number but for what rounding the radians made of them.
fn near_whole(degrees: f64) -> String {
    let rounded = (degrees * 10.0).round() / 10.0;
    let close = (rounded - degrees).abs() < 5e-4 && rounded != 0.0;
    shown(if close { rounded } else { degrees }, 10)
}

fn shown(number: f64, digits: usize) -> String {
    let rounded: f64 = format!("{number:.*e}", digits - 1)
        .parse()
        .unwrap_or(number);
    format!("{rounded}")
}

/// A path that counts from the file, as one that counts from its package.
pub(super) fn package_path(cx: &Cx<'_>, world: RuleEnv<'_>, offset: u32) -> Option<Action> {
    let at = locate(&cx.source.document, offset);
    let name = file_name_at(cx, world, &at)?;
    let text = cx.source.document.slice(name.range);
    let FileTarget::Found(path) = &name.target else {
        return None;
    };
    if text.contains("$(") || text.contains("${") || text.starts_with("package://") {
        return None;
    }
    let package = world.packages.containing(path)?;
    let new = match name.kind {
        FileKind::Include => format!("$(find {})/{}", package.name, package.inside(path)?),
        FileKind::Yaml => return None,
        FileKind::Mesh | FileKind::Other => package.uri(path)?,
    };
    Some(rewrite(
        format!("convert path to `{new}`"),
        vec![edit(cx.source, name.range, new.clone())],
    ))
}

/// The attributes of an element in the order in which its specification lists them.
pub(super) fn sort_attributes(source: &SourceFile, offset: u32) -> Option<Action> {
    let (base, node) = element_at(&source.document, offset)?;
    if !node.start_tag_range().shift(base).touches(offset) {
        return None;
    }
    let specs = schema::element(node);
    let [spec] = specs.as_slice() else {
        return None;
    };
    let written: Vec<TextRange> = node.attrs().map(|attr| attr.range().shift(base)).collect();
    let mut sorted: Vec<(usize, TextRange)> = node
        .attrs()
        .map(|attr| {
            let mut known = spec.attributes.iter();
            let rank = known.position(|known| known.name == attr.name());
            (rank.unwrap_or(usize::MAX), attr.range().shift(base))
        })
        .collect();
    sorted.sort_by_key(|(rank, _)| *rank);
    let pairs = written
        .iter()
        .zip(&sorted)
        .filter(|(old, (_, new))| *old != new);
    let edits: Vec<_> = pairs
        .map(|(old, (_, new))| edit(source, *old, source.document.slice(*new)))
        .collect();
    (!edits.is_empty()).then(|| rewrite("sort attributes", edits))
}

/// A plain description as one that xacro reads to the same effect.
pub(super) fn to_xacro(source: &SourceFile, offset: u32) -> Option<Action> {
    let document = &source.document;
    let root = document
        .root()
        .filter(|root| root.name() == "robot" && root.attr("xmlns:xacro").is_none())?;
    root.start_tag_range().touches(offset).then_some(())?;
    let at = root
        .attrs()
        .last()
        .map_or(root.name_range().end, |attr| attr.range().end);
    let mut edits = vec![edit(
        source,
        TextRange::empty(at),
        " xmlns:xacro=\"http://www.ros.org/wiki/xacro\"",
    )];
    // what looks like an expression is none
    for (base, item) in document.items() {
        for lead in ["${", "$("] {
            let places = item
                .text()
                .match_indices(lead)
                .map(|(at, _)| TextRange::empty(base + at as u32));
            edits.extend(places.map(|place| edit(source, place, "$")));
        }
    }
    edits.sort_by_key(|edit| edit.span.range.start);
    Some(rewrite("convert to a xacro file", edits))
}

#[cfg(test)]
mod tests {
    use super::{near_whole, words};

    #[test]
    fn expressions_are_words() {
        let found: Vec<&str> = words("0 ${radians(2 * 3)} 1e-3")
            .into_iter()
            .map(|(_, word)| word)
            .collect();
        assert_eq!(found, ["0", "${radians(2 * 3)}", "1e-3"]);
    }

    #[test]
    fn rounded_radians_are_whole_degrees() {
        for (radians, expected) in [
            ("1.5708", "90"),
            ("0.7854", "45"),
            ("3.14159", "180"),
            ("0.3", "17.18873385"),
        ] {
            assert_eq!(
                near_whole(radians.parse::<f64>().unwrap().to_degrees()),
                expected
            );
        }
    }
}
