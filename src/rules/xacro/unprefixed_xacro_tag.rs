//! A tag of xacro written without its prefix.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::{is_forgotten_prefix, outside_free_zones};
use base::TextRange;
use expand::Expansion;
use xml::{Document, Node};

pub(in super::super) static RULE: Rule = Rule {
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

/// The tags that nothing but xacro knows; nothing else knows an `include` with a file name either.
const OWN_TAGS: [&str; 3] = ["insert_block", "macro", "property"];

/// Whether an element outside of free zones is a tag of xacro without its prefix. A file that a robot in xacro includes is
/// one in xacro, whether it declares the prefix or not; so is one whose name says so.
pub(in super::super) fn is_unprefixed(
    expansion: &Expansion,
    document: &Document,
    node: Node<'_>,
) -> bool {
    let is_own = || {
        OWN_TAGS.contains(&node.name())
            || node.name() == "include" && node.attr("filename").is_some()
    };
    (is_forgotten_prefix(node.name()) && declares(document) || is_own() && is_in_xacro(expansion))
        && !is_of_maker(node)
        && is_of_robot(expansion, document)
        && !is_ignored(node)
}

/// Whether an element is the `property` of a maker, as in `<property motor_constant="0.1"/>`: that of xacro needs a name.
fn is_of_maker(node: Node<'_>) -> bool {
    node.name() == "property" && node.attrs().next().is_some() && node.attr("name").is_none()
}

/// Whether xacro ignores an element whatever its name is, as a child of an include.
fn is_ignored(node: Node<'_>) -> bool {
    node.parent()
        .is_some_and(|parent| parent.name() == "xacro:include")
}

/// Whether a document is a robot, or a part that one includes: the root element of a part may have any name.
fn is_of_robot(expansion: &Expansion, document: &Document) -> bool {
    let root = expansion.files.first().map(|file| &file.source.document);
    let is_robot = |document: &Document| document.root().is_some_and(|root| root.name() == "robot");
    is_robot(document) || root.is_some_and(|root| !std::ptr::eq(root, document) && is_robot(root))
}

/// Whether the robot is in xacro by the name of its file or the prefix that it declares.
fn is_in_xacro(expansion: &Expansion) -> bool {
    expansion.files.first().is_some_and(|root| {
        let named = root
            .source
            .path
            .extension()
            .is_some_and(|ending| ending == "xacro");
        named || declares(&root.source.document)
    })
}

fn declares(document: &Document) -> bool {
    document
        .root()
        .is_some_and(|root| root.attr("xmlns:xacro").is_some())
}

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let elements = outside_free_zones(cx.other_elements());
    for (base, node) in
        elements.filter(|&(_, node)| is_unprefixed(cx.expansion, &cx.source.document, node))
    {
        let name = node.name();
        let start = node.name_range().shift(base);
        let end = node.end_name_range().map(|range| range.shift(base));
        let edits = [Some(start), end]
            .into_iter()
            .flatten()
            .map(|range| (TextRange::empty(range.start), "xacro:".to_owned()));
        let message = format!("`{name}` is missing the `xacro:` prefix, so xacro ignores it");
        let place = TextRange::new(start.start - 1, start.end);
        if is_of_itself(node) {
            let help = "remove it; as a property it would be defined by itself";
            out.report_in(cx.file, place, message)
                .severity(Severity::Info)
                .help(help)
                .done();
            continue;
        }
        let report = out
            .report_in(cx.file, place, message)
            .help(format!("write `xacro:{name}`"));
        if !declares(&cx.source.document) {
            report.done();
            continue;
        }
        report
            .fix(Safety::Safe, "add the prefix `xacro:`", cx.file, edits)
            .done();
    }
}

/// Whether a property has its own name as its value: nothing is missing without it.
fn is_of_itself(node: Node<'_>) -> bool {
    let [name, value] = ["name", "value"].map(|name| node.attr(name).map(|value| value.raw()));
    let inner = value
        .unwrap_or_default()
        .trim()
        .strip_prefix("${")
        .and_then(|value| value.strip_suffix('}'));
    node.name() == "property" && inner.is_some_and(|inner| Some(inner.trim()) == name)
}
