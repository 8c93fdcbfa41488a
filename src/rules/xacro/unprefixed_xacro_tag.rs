//! A tag of xacro written without its prefix.

use super::super::context::FileCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::outside_free_zones;
use base::TextRange;
use xml::{Document, Node};

pub(super) const RULE: Rule = Rule {
    code: "XAC020",
    name: "unprefixed-xacro-tag",
    category: Category::Xacro,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unprefixed-xacro-tag"),
    check: Check::File(check),
};

const TAGS: [&str; 7] = ["arg", "if", "include", "insert_block", "macro", "property", "unless"];

/// Whether an element outside of free zones is a tag of xacro without its prefix.
pub(in super::super) fn is_unprefixed(document: &Document, node: Node<'_>) -> bool {
    let declares = |root: Node<'_>| root.name() == "robot" && root.attr("xmlns:xacro").is_some();
    TAGS.contains(&node.name()) && document.root().is_some_and(declares)
}

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let elements = outside_free_zones(cx.elements());
    for (base, node) in elements.filter(|&(_, node)| is_unprefixed(&cx.source.document, node)) {
        let name = node.name();
        let start = node.name_range().shift(base);
        let end = node.end_name_range().map(|range| range.shift(base));
        let edits = [Some(start), end]
            .into_iter()
            .flatten()
            .map(|range| (TextRange::empty(range.start), "xacro:".to_owned()));
        let message = format!("`{name}` lacks its prefix `xacro:`: it goes into the robot as it stands");
        out.report_in(cx.file, TextRange::new(start.start - 1, start.end), message)
            .help(format!("write `xacro:{name}`"))
            .fix(Safety::Safe, format!("write `xacro:{name}`"), cx.file, edits)
            .done();
    }
}
