//! Numbers with units: angles in degrees, colors.

use super::super::locate::{LocatedNode, NodePart};
use super::super::schema;
use super::super::values::number_text;
use super::elements;
use super::page::Page;
use base::TextRange;
use model::decimal;
use xml::Node;

/// The number at a place.
pub(super) fn about(cx: &super::Cx<'_>, at: &LocatedNode<'_>) -> Option<(TextRange, Page)> {
    let NodePart::AttrValue(attr) = at.part else {
        return None;
    };
    if attr.name() == "rgba" {
        return Some((at.shift(attr.value_range()), color(attr.raw())?));
    }
    let inside = at.offset.checked_sub(at.base + attr.value_range().start)?;
    let raw = attr.raw();
    let mut words = raw.split_ascii_whitespace().map(|word| {
        let start = (word.as_ptr() as usize - raw.as_ptr() as usize) as u32;
        (TextRange::new(start, start + word.len() as u32), word)
    });
    let (range, word) = words.find(|(range, _)| range.touches(inside))?;
    let mut page = Page::titled(in_degrees(at, decimal(word)?)?);
    if let Some((_, about)) = elements::about(cx, at) {
        page.add(about.finish());
    }
    Some((at.shift(range.shift(attr.value_range().start)), page))
}

/// `1.57 rad (89.95°)`, where the attribute at a place holds angles.
pub(super) fn in_degrees(at: &LocatedNode<'_>, number: f64) -> Option<String> {
    let (NodePart::AttrValue(attr), Some(node)) = (at.part, at.node) else {
        return None;
    };
    let unit = schema::attribute(node, attr.name())?.unit?;
    let angle = match unit {
        "rad" => "rad",
        "rad or m" if turns(node) => "rad",
        "rad/s or m/s" if turns(node) => "rad/s",
        _ => return None,
    };
    let (per, short) = (angle.trim_start_matches("rad"), rounded(number, 1e4));
    Some(format!("`{short} {angle} ({}°{per})`", degrees(number)))
}

/// Whether the joint around an element is known to turn.
fn turns(node: Node<'_>) -> bool {
    let joint =
        std::iter::successors(Some(node), |node| node.parent()).find(|node| node.name() == "joint");
    let kind = joint
        .and_then(|joint| joint.attr("type"))
        .map(|kind| kind.raw());
    matches!(kind, Some("revolute" | "continuous"))
}

/// Radians in degrees with two places.
pub(super) fn degrees(radians: f64) -> String {
    rounded(radians.to_degrees(), 100.0)
}

/// A number in steps of `1 / parts`; small ones as they are, so that they do not become zero.
pub(super) fn rounded(number: f64, parts: f64) -> String {
    let near = (number * parts).round() / parts;
    let text = number_text(if near == 0.0 { number } else { near });
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

/// A color.
fn color(raw: &str) -> Option<Page> {
    let parts: Option<Vec<f64>> = raw.split_ascii_whitespace().map(decimal).collect();
    let parts = parts
        .filter(|parts| parts.len() == 4 && parts.iter().all(|part| (0.0..=1.0).contains(part)))?;
    let byte = |part: &f64| (part * 255.0).round() as u8;
    let [red, green, blue, alpha] =
        <[u8; 4]>::try_from(parts.iter().map(byte).collect::<Vec<_>>()).ok()?;
    let image = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='48' height='16'><rect width='48' height='16' \
         fill='rgb({red},{green},{blue})' fill-opacity='{:.3}'/></svg>",
        f64::from(alpha) / 255.0
    );
    let encoded: String = image
        .chars()
        .map(|c| match c {
            ' ' => "%20".to_owned(),
            '<' => "%3C".to_owned(),
            '>' => "%3E".to_owned(),
            '#' => "%23".to_owned(),
            '(' => "%28".to_owned(),
            ')' => "%29".to_owned(),
            '\'' => "%27".to_owned(),
            other => other.to_string(),
        })
        .collect();
    let mut page = Page::titled(format!(
        "![color](data:image/svg+xml,{encoded}) `#{red:02x}{green:02x}{blue:02x}`"
    ));
    page.add("red, green, blue and opacity, each from 0 to 1");
    Some(page)
}
