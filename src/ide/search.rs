//! Finding named things of a file by a few letters.

use base::TextRange;
use facts::{Fact, FactKind, facts};
use xml::Document;

/// Something with a name that fits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hit {
    /// Its name as it is written.
    pub name: String,
    /// What it is.
    pub kind: FactKind,
    /// Its name's text.
    pub range: TextRange,
    /// How badly it fits; the best have least.
    pub cost: u32,
}

/// The macros, links, joints, properties and arguments of a file whose names hold the letters of `query` in order.
pub fn search(document: &Document, query: &str) -> Vec<Hit> {
    let is_named = |fact: &&Fact| {
        use FactKind::{Argument, Joint, Link, Macro, Property};
        matches!(fact.kind, Macro | Link | Joint | Property | Argument) && !fact.name.is_empty()
    };
    let mut found = Vec::new();
    for (base, facts) in facts(document) {
        for fact in facts.named.iter().filter(is_named) {
            if let Some(cost) = fit(query, &fact.name) {
                let (name, kind, range) =
                    (fact.name.to_string(), fact.kind, fact.range.shift(base));
                found.push(Hit {
                    name,
                    kind,
                    range,
                    cost,
                });
            }
        }
    }
    found
}

/// How badly a name fits: none when it does not hold the letters in order. What is skipped costs, the more so
/// inside of a word; letter cases do not count.
pub fn fit(query: &str, name: &str) -> Option<u32> {
    let mut letters = query
        .chars()
        .filter(|c| !c.is_whitespace())
        .flat_map(char::to_lowercase)
        .peekable();
    let (mut cost, mut skipped, mut matched) = (0, 0, false);
    let mut before = '_';
    for c in name.chars() {
        let Some(&wanted) = letters.peek() else {
            // a longer name fits a little less
            cost += 1;
            continue;
        };
        if c.to_lowercase().eq(std::iter::once(wanted)) {
            letters.next();
            let starts_word =
                !before.is_alphanumeric() || c.is_uppercase() && before.is_lowercase();
            cost += if skipped == 0 {
                0
            } else {
                10 + skipped + if starts_word { 0 } else { 20 }
            };
            (skipped, matched) = (0, true);
        } else {
            skipped += if matched { 2 } else { 1 };
        }
        before = c;
    }
    letters.peek().is_none().then_some(cost + skipped)
}

#[cfg(test)]
mod tests {
    use super::fit;

    #[test]
    fn the_beginning_fits_best_then_words_then_anything() {
        let names = ["lens", "left_elbow", "cable", "handle"];
        let costs = names.map(|name| fit("le", name));
        assert!(costs.is_sorted(), "{costs:?}");
        assert!(fit("le", "el").is_none() && fit("", "x").is_some() && fit("LE", "lens").is_some());
        assert!(fit("fk", "front_knee") < fit("fk", "offkey"));
    }
}
