//! A robot that urdf-rs does not load.
use std::panic::{AssertUnwindSafe, catch_unwind};

use roxmltree::{Document, Node, ParsingOptions};

use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use expand::write;
use model::tag_start;

pub(super) static RULE: Rule = Rule {
    code: "STR013",
    name: "rust-consumer-cannot-load",
    category: Category::Structure,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("rust-consumer-cannot-load"),
    check: Check::Whole(check),
};

/// Larger documents, in bytes, are not given to urdf-rs.
const MOST_BYTES: usize = 8 << 20;
/// Elements with more attributes than these are not, for which the parsers below urdf-rs need quadratic time.
const MOST_ATTRIBUTES: usize = 256;
/// Deeper elements are not: those parsers call themselves for each level.
const MOST_LEVELS: usize = 64;
/// Characters of what urdf-rs reports that are quoted.
const MOST_LETTERS: usize = 60;
/// Elements that are tried by themselves.
const MOST_PARTS: usize = 5000;

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    // what xacro refuses never comes to a consumer
    if !cx.expansion.complete || cx.expansion.has_errors() {
        return;
    }
    let tree = &cx.expansion.tree;
    let text = write(tree, "").text;
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: 1_000_000,
        ..ParsingOptions::default()
    };
    let Some(document) = Document::parse_with_options(&text, options)
        .ok()
        .filter(is_sane)
    else {
        return;
    };
    let Some(why) = refused(&text) else { return };
    // urdf-rs says nothing about places: the first part that is refused by itself is the culprit
    let elements = document.root_element().children().filter(Node::is_element);
    let mut parts = elements
        .zip(tree.elements(cx.robot.element))
        .take(MOST_PARTS);
    let found = parts.find_map(|(part, id)| Some((id, refused(&alone(&text, part))?)));
    let (id, why) = found.unwrap_or((cx.robot.element, why));
    out.report(
        tag_start(cx.expansion, id),
        format!(
            "urdf-rs cannot load {}: {}",
            named(cx, id),
            why.trim_start_matches("custom: ")
        ),
    )
    .help("correct the element; Rust programs read robot descriptions with urdf-rs")
    .done();
}

/// Whether a document may be given to urdf-rs.
fn is_sane(document: &Document<'_>) -> bool {
    document.input_text().len() <= MOST_BYTES
        && document.descendants().all(|node| {
            node.attributes().len() <= MOST_ATTRIBUTES
                && node.ancestors().take(MOST_LEVELS + 2).count() <= MOST_LEVELS + 1
        })
}

/// What urdf-rs has against a document, in one line.
fn refused(text: &str) -> Option<String> {
    let read = catch_unwind(AssertUnwindSafe(|| {
        urdf_rs::read_from_string(text).map(|_| ())
    }));
    let error = read.ok()?.err()?.to_string();
    let error = error.split_whitespace().collect::<Vec<_>>().join(" ");
    let sentence = error
        .split(". ")
        .next()
        .unwrap_or_default()
        .trim_end_matches('.');
    Some(match sentence.char_indices().nth(MOST_LETTERS) {
        Some((end, _)) => format!("{}...", sentence.get(..end).unwrap_or_default()),
        None => sentence.to_owned(),
    })
}

/// The root element with one of its children.
fn alone(text: &str, part: Node<'_, '_>) -> String {
    let root = part.document().root_element();
    let start = root
        .first_child()
        .map_or(root.range().end, |first| first.range().start);
    let tag = text.get(root.range().start..start).unwrap_or_default();
    format!(
        "{tag}{}</{}>",
        text.get(part.range()).unwrap_or_default(),
        root.tag_name().name()
    )
}

/// "joint `elbow`"
fn named(cx: &RobotCx<'_>, id: expand::XId) -> String {
    let tree = &cx.expansion.tree;
    let kind = tree.get(id).text.as_str();
    let name = model::AttrValue::attr(tree, id, "name")
        .and_then(|name| name.name().map(|n| n.to_string()));
    name.map_or_else(|| format!("a {kind}"), |name| format!("{kind} `{name}`"))
}
