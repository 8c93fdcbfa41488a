//! The list of all rules, and how they are found by name.
use super::rule::Rule;
use super::{
    consumers, control, conventions, frames, geometry, inertia, joint, linter, moveit, package,
    srdf, structure, style, xacro, xml,
};
use packages::nearest;

/// All rules, by category and code.
pub fn all() -> impl Iterator<Item = &'static Rule> {
    let categories: [&'static [&'static Rule]; 15] = [
        xml::RULES,
        xacro::RULES,
        structure::RULES,
        joint::RULES,
        frames::RULES,
        inertia::RULES,
        geometry::RULES,
        conventions::RULES,
        package::RULES,
        control::RULES,
        srdf::RULES,
        moveit::RULES,
        consumers::RULES,
        style::RULES,
        linter::RULES,
    ];
    categories.into_iter().flatten().copied()
}

/// The rule of a code.
pub fn by_code(code: &str) -> Option<&'static Rule> {
    all().find(|rule| rule.code == code)
}

/// The rules that a selector means: a code, the beginning of a code (at least its letters) or a name.
pub fn find(selector: &str) -> impl Iterator<Item = &'static Rule> {
    all().filter(move |rule| rule.is_named(selector))
}

/// A code or name much like a selector that means no rule.
pub fn nearest_selector(selector: &str) -> Option<&'static str> {
    nearest(selector, all().flat_map(|rule| [rule.name, rule.code]))
}

/// The rules that have a word in their name.
fn with_word(word: &str) -> Vec<&'static str> {
    all()
        .map(|rule| rule.name)
        .filter(|name| name.split('-').any(|part| part == word))
        .collect()
}

/// What to tell the user about a selector that means no rule.
pub fn unknown_selector(selector: &str) -> String {
    match nearest_selector(selector) {
        Some(near) => format!("unknown rule `{selector}`; did you mean `{near}`?"),
        None if !with_word(selector).is_empty() => {
            format!(
                "unknown rule `{selector}`; rules that contain the word: `{}`",
                with_word(selector).join("`, `")
            )
        }
        None => format!("unknown rule `{selector}`; run `xacro-lint rules` to list all rules"),
    }
}
