//! Numbers: the same mistakes in each attribute that holds them.
use super::super::xml::{described, known};
use super::facts::{ConstructCollector, RobotFacts};
use super::met::Met;
use super::table::fault;
use expand::XId;
use model::{AttrValue, is_decimal};

/// White space that is no space.
const BREAKS: [char; 3] = ['\t', '\n', '\r'];

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let tree = &facts.cx.expansion.tree;
    for (id, spec) in known(facts.cx) {
        for attribute in spec.attributes {
            let Some(count) = attribute.numbers() else {
                continue;
            };
            if facts.cx.is_older_than(attribute.since) {
                continue;
            }
            let text = AttrValue::attr(tree, id, attribute.name);
            let found = match &text {
                None if attribute.required => Some("missing"),
                Some(text) if text.is_known() => judge(&facts.seen(text), count),
                _ => None,
            };
            let Some(found) = found else { continue };
            let construct = keys(facts, id, attribute.name)
                .into_iter()
                .find_map(|key| fault(found, &key));
            let origin = text.map_or_else(|| facts.at(id), |text| text.origin);
            out.met.extend(construct.map(|construct| Met {
                construct,
                origin,
                owner: described(facts.cx, id),
            }));
        }
    }
}

/// The names of an attribute in the table, the longest first: `visual/box/size`, `box/size`.
fn keys(facts: &RobotFacts<'_, '_>, element: XId, attribute: &str) -> Vec<String> {
    let tree = &facts.cx.expansion.tree;
    let name = tree.get(element).text.as_str();
    let around = std::iter::successors(tree.parent(element), |&id| tree.parent(id));
    let around = around
        .map(|id| tree.get(id).text.as_str())
        .find(|name| *name != "geometry")
        .unwrap_or_default();
    vec![
        format!("{around}/{name}/{attribute}"),
        format!("{name}/{attribute}"),
    ]
}

/// What is wrong with a value that should hold `count` numbers.
fn judge(value: &str, count: usize) -> Option<&'static str> {
    let words: Vec<&str> = value.split_ascii_whitespace().collect();
    if words.is_empty() {
        return Some("empty");
    }
    if value.contains("${") || value.contains("$(") {
        return Some("text");
    }
    if words.iter().any(|word| word.contains(',')) {
        return Some("comma");
    }
    if let Some(found) = words.iter().find_map(|word| of_word(word)) {
        return Some(found);
    }
    match words.len() {
        found if count == 1 && found > 1 => Some("tail"),
        found if found < count => Some("few"),
        found if found > count => Some("many"),
        // what comes before a single number is skipped
        _ if count == 1 && value.ends_with(' ') => Some("space-after"),
        _ if count == 1 => value.ends_with(BREAKS).then_some("tab"),
        _ => value.contains(BREAKS).then_some("tab"),
    }
}

fn of_word(word: &str) -> Option<&'static str> {
    let bare = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if is_decimal(word) {
        let number: f64 = word.parse().unwrap_or_default();
        return if number.is_infinite() {
            Some("overflow")
        } else {
            (number != 0.0 && number.abs() < f64::MIN_POSITIVE).then_some("subnormal")
        };
    }
    Some(match bare.as_str() {
        "nan" => "nan",
        "inf" | "infinity" => "inf",
        bare if bare.starts_with("0x") => "hex",
        _ if is_overflow(word) => "overflow",
        bare if bare.starts_with(|c: char| c.is_ascii_digit() || c == '.') => "tail",
        _ => "text",
    })
}

/// Whether a word is spelled as a number that is too large.
fn is_overflow(word: &str) -> bool {
    word.parse::<f64>().is_ok_and(f64::is_infinite)
}
