//! An element without a child that parsers insist on.
use super::super::context::DocumentCx;
use super::super::geometry::{is_read_last, is_taken_out};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::schema::ElementSpec;
use super::super::sink::Sink;
use super::seen::CheckedElement;
use super::walk;
use expand::{XId, XKind, XTree};
use model::tag_start;

pub(in super::super) static RULE: Rule = Rule {
    code: "XML009",
    name: "missing-element",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-element"),
    check: Check::WholeElement(check),
};

fn check(
    cx: &DocumentCx<'_>,
    &CheckedElement { id, known, .. }: &CheckedElement,
    out: &mut Sink<'_>,
) {
    let Some(spec) = known.filter(|spec| !spec.required.is_empty()) else {
        return;
    };
    let missing = missing(cx, id, spec);
    if missing.is_empty() || walk::may_get_more(cx, id) {
        return;
    }
    let message = format!(
        "missing element `{1}` in {0}",
        walk::described(cx, id),
        missing.join("` and `")
    );
    let shape = bare_shape(&cx.expansion.tree, id).filter(|_| missing == ["geometry"]);
    if let Some(shape) = shape {
        let help = format!("put `{shape}` in <geometry>");
        out.report(tag_start(cx.expansion, id), message)
            .help(help)
            .done();
        return;
    }
    let tree = &cx.expansion.tree;
    let is_meant = missing == ["geometry"]
        && (is_taken_out(tree, id, id) || is_empty_collision(tree, id) && is_read_last(tree, id));
    let severity = if is_meant {
        Severity::Info
    } else {
        RULE.severity
    };
    let add: Vec<String> = missing
        .iter()
        .map(|name| format!("<{name} .../>"))
        .collect();
    out.report(tag_start(cx.expansion, id), message)
        .severity(severity)
        .help(format!("add {}", add.join(" and ")))
        .done();
}

/// Whether an element is a collision in which nothing was written.
fn is_empty_collision(tree: &XTree, id: XId) -> bool {
    tree.get(id).text == "collision"
        && tree
            .children(id)
            .all(|child| tree.get(child).kind == XKind::Text)
}

/// The required children that are absent, not misspelled, and in no tag that lacks its prefix.
fn missing(cx: &DocumentCx<'_>, id: XId, spec: &ElementSpec) -> Vec<&'static str> {
    let tree = &cx.expansion.tree;
    let mut misspelled = Vec::new();
    for child in tree.elements(id) {
        let name = tree.get(child).text.as_str();
        if spec.child(name).is_none() {
            if walk::lacks_prefix(cx, child) {
                return Vec::new();
            }
            misspelled.extend(walk::meant(name, spec.children().map(|child| child.name)));
        }
    }
    let absent = |name: &&str| {
        let there = tree
            .elements(id)
            .any(|child| tree.get(child).text == **name);
        !there && !misspelled.iter().any(|(meant, _)| meant == name)
    };
    spec.required.iter().copied().filter(absent).collect()
}

/// The shape that stands in a visual or collision without a geometry around it.
pub(super) fn bare_shape(tree: &XTree, id: XId) -> Option<&str> {
    let is_body = matches!(tree.get(id).text.as_str(), "visual" | "collision");
    let is_geometry = |child: XId| tree.get(child).text == "geometry";
    if !is_body || tree.elements(id).any(is_geometry) {
        return None;
    }
    let mut names = tree.elements(id).map(|child| tree.get(child).text.as_str());
    names.find(|name| ["box", "cylinder", "sphere", "capsule", "mesh"].contains(name))
}
