//! An origin that says what holds without it.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::outside_free_zones;
use base::TextRange;
use model::decimal;
use xml::Node;

pub(super) static RULE: Rule = Rule {
    code: "STY001",
    name: "redundant-identity-origin",
    category: Category::Style,
    severity: Severity::Hint,
    default: Activation::Profiles(&["pedantic"]),
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("redundant-identity-origin"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    const PARENTS: [&str; 4] = ["joint", "visual", "collision", "inertial"];
    for (base, node) in
        outside_free_zones(cx.elements()).filter(|(_, node)| node.name() == "origin")
    {
        let counts = node
            .parent()
            .is_some_and(|parent| PARENTS.contains(&parent.name()));
        if counts && is_identity(node) && node.child_elements().next().is_none() {
            let range = node.range().shift(base);
            out.report_in(cx.file, range, "redundant `origin`")
                .help("remove the element; zero is the default")
                .fix(
                    Safety::Safe,
                    "remove the element",
                    cx.file,
                    [(line(node, base), String::new())],
                )
                .done();
        }
    }
}

/// Whether an origin moves nothing; one without attributes does not either.
fn is_identity(node: Node<'_>) -> bool {
    node.attrs().all(|attr| {
        let mut words = attr.raw().split_whitespace();
        matches!(attr.name(), "xyz" | "rpy") && words.all(|word| decimal(word) == Some(0.0))
    })
}

/// The element with the blanks in front of it.
fn line(node: Node<'_>, base: u32) -> TextRange {
    let range = node.range();
    let before = node
        .item()
        .text()
        .get(..range.start as usize)
        .unwrap_or_default();
    let start = before.trim_end().len() as u32;
    TextRange::new(start, range.end).shift(base)
}
