//! Who speaks of a rule names its `RULE`, not its code or name as text: a text with a typing error still compiles.

use std::collections::{BTreeMap, BTreeSet};

use xacro_lsp::rules;

use super::{is_test, sources};

/// Names of rules that are names of something else, too, and where: keys of the configuration, and constructs in
/// `src/rules/consumers/table`.
const OTHER_MEANINGS: [(&str, &[&str]); 4] = [
    (
        "no-links",
        &[
            "workspace/config/",
            "analysis/config_choices.rs",
            "rules/consumers/",
        ],
    ),
    ("link-cycle", &["rules/consumers/"]),
    ("mimic-cycle", &["rules/consumers/"]),
    ("mimic-chain", &["rules/consumers/"]),
];

fn means_something_else(text: &str, path: &str) -> bool {
    OTHER_MEANINGS
        .iter()
        .any(|(name, places)| *name == text && places.iter().any(|place| path.starts_with(place)))
}

/// The codes and names of rules that a file spells out between quotes.
fn spelled_out<'a>(code: &'a str, names: &BTreeSet<&str>) -> BTreeSet<&'a str> {
    // a piece that is no string holds blanks or signs, which no name has
    code.split('"')
        .filter(|piece| names.contains(piece))
        .collect()
}

#[test]
fn only_the_file_of_a_rule_spells_its_code_and_name() {
    let names: BTreeSet<&str> = rules::all()
        .flat_map(|rule| [rule.code, rule.name])
        .collect();
    let mut declared: BTreeMap<&str, usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    for (path, crate_name, code) in sources() {
        if is_test(&path) {
            continue;
        }
        let path = path.display().to_string().replace('\\', "/");
        let product = code
            .split("#[cfg(test)]\nmod tests {")
            .next()
            .unwrap_or_default();
        let found = spelled_out(product, &names);
        let own: Vec<_> = rules::all()
            .filter(|rule| {
                crate_name == "rules" && found.contains(rule.code) && found.contains(rule.name)
            })
            .collect();
        for rule in &own {
            *declared.entry(rule.code).or_default() += 1;
        }
        let others = found.iter().filter(|text| {
            !own.iter().any(|rule| [rule.code, rule.name].contains(text))
                && !means_something_else(text, &path)
        });
        wrong.extend(others.map(|text| format!("{path}: \"{text}\"")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let elsewhere: Vec<&str> = rules::all()
        .map(|rule| rule.code)
        .filter(|code| declared.get(code) != Some(&1))
        .collect();
    assert!(elsewhere.is_empty(), "not in one file each: {elsewhere:?}");
}
