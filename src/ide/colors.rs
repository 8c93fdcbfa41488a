//! Colors of materials.

use super::context::Cx;
use base::{FastMap, TextRange};
use expand::{SourceRange, XId};
use model::decimal;

/// A color, and where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Color {
    /// The text of the value.
    pub range: TextRange,
    /// Red, green, blue, opacity, each 0 to 1.
    pub rgba: [f64; 4],
}

/// The colors in a file. A color made by expressions is left out when it differs by call.
pub fn colors(cx: &Cx<'_>) -> Vec<Color> {
    let document = &cx.source.document;
    let mut found = Vec::new();
    let mut computed = None;
    for (base, item) in document.parts() {
        for attr in item.all_nodes().filter_map(|node| node.attr("rgba")) {
            let range = attr.value_range().shift(base);
            let rgba = if attr.has_dollar() {
                let known = computed.get_or_insert_with(|| evaluated(cx));
                cx.source_range(range)
                    .and_then(|place| known.get(&place).copied().flatten())
            } else {
                parsed(&attr.value(document.entities()))
            };
            found.extend(rgba.map(|rgba| Color { range, rgba }));
        }
    }
    found
}

/// Three or four numbers from 0 to 1.
fn parsed(text: &str) -> Option<[f64; 4]> {
    let mut rgba = [1.0; 4];
    let mut count = 0;
    for word in text.split_ascii_whitespace() {
        let number = decimal(word).filter(|number| (0.0..=1.0).contains(number))?;
        *rgba.get_mut(count)? = number;
        count += 1;
    }
    (count >= 3).then_some(rgba)
}

/// What the values of `rgba` became, by place; none where that differs.
fn evaluated(cx: &Cx<'_>) -> FastMap<SourceRange, Option<[f64; 4]>> {
    let tree = &cx.expansion.tree;
    let mut found: FastMap<SourceRange, Option<[f64; 4]>> = FastMap::default();
    for attr in tree
        .below(XId::DOCUMENT)
        .filter_map(|id| tree.attr(id, "rgba"))
    {
        let rgba = parsed(&attr.value).filter(|_| !attr.pieces.iter().any(|piece| piece.unknown));
        let known = found.entry(attr.origin.into()).or_insert(rgba);
        if *known != rgba {
            *known = None;
        }
    }
    found
}

/// The text of a color: at most three decimals, always four numbers.
pub fn color_text(rgba: [f64; 4]) -> String {
    let number = |part: f64| {
        let rounded = (part.clamp(0.0, 1.0) * 1000.0).round() / 1000.0;
        rounded.to_string()
    };
    rgba.map(number).join(" ")
}

#[cfg(test)]
mod tests {
    use super::{color_text, parsed};

    #[test]
    fn colors_are_three_or_four_numbers() {
        assert_eq!(parsed("1 0 .5"), Some([1.0, 0.0, 0.5, 1.0]));
        assert_eq!(parsed("1 0 0.5 0.25"), Some([1.0, 0.0, 0.5, 0.25]));
        assert!(
            ["1 0", "1 0 0 0 0", "1 0 x 1", "2 0 0 1", ""]
                .iter()
                .all(|text| parsed(text).is_none())
        );
        assert_eq!(color_text([1.0, 0.0, 1.0 / 3.0, 0.5]), "1 0 0.333 0.5");
    }
}
