//! A second element where parsers read one.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::seen::CheckedElement;
use super::walk;
use base::FastMap;
use expand::{XId, XKind, XTree};
use model::{Pose, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "XML012",
    name: "duplicate-element",
    category: Category::Xml,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("duplicate-element"),
    check: Check::Element(check),
};

/// The elements that count once.
const SINGLE: [&str; 12] = [
    "axis",
    "child",
    "dynamics",
    "geometry",
    "inertia",
    "inertial",
    "limit",
    "mass",
    "mimic",
    "origin",
    "parent",
    "safety_controller",
];

fn check(
    cx: &DocumentCx<'_>,
    &CheckedElement { id, known, .. }: &CheckedElement,
    out: &mut Sink<'_>,
) {
    let tree = &cx.expansion.tree;
    if known.is_none_or(|spec| spec.name == "robot") {
        return;
    }
    let mut first: FastMap<&str, XId> = FastMap::default();
    for child in tree.elements(id) {
        let name = tree.get(child).text.as_str();
        if !SINGLE.contains(&name) {
            continue;
        }
        if let Some(&earlier) = first.get(name) {
            let message = format!("{} has more than one `{name}`", walk::described(cx, id));
            // a fixed joint has no use for them
            let is_fixed = tree
                .attr(id, "type")
                .is_some_and(|kind| kind.value == "fixed");
            let is_idle = is_fixed && ["axis", "dynamics", "limit"].contains(&name);
            let equal = is_idle
                || is_same(tree, earlier, child)
                || name == "origin" && is_same_pose(tree, earlier, child);
            out.report(tag_start(cx.expansion, child), message)
                .severity(if equal {
                    Severity::Info
                } else {
                    Severity::Warning
                })
                .also(tag_start(cx.expansion, earlier), "first one here")
                .help(
                    "remove one of them; urdfdom uses the first one, other parsers reject the file",
                )
                .done();
        } else {
            first.insert(name, child);
        }
    }
}

/// Whether two elements say the same, comments and blanks left out.
pub(super) fn is_same(tree: &XTree, a: XId, b: XId) -> bool {
    words(tree, a).eq(words(tree, b))
}

/// Whether two origins stand for the same place.
fn is_same_pose(tree: &XTree, a: XId, b: XId) -> bool {
    let [a, b] = [a, b].map(|element| Pose::of(tree, element).transform());
    a.is_some() && a == b
}

/// What an element says, piece by piece.
fn words(tree: &XTree, element: XId) -> impl Iterator<Item = (&str, Vec<(&str, &str)>)> {
    let nodes = std::iter::once(element)
        .chain(tree.below(element))
        .map(|id| tree.get(id));
    nodes
        .filter(|node| matches!(node.kind, XKind::Element | XKind::Text | XKind::CData))
        .filter(|node| !node.text.trim().is_empty())
        .map(|node| {
            let mut attrs: Vec<_> = node
                .attrs
                .iter()
                .map(|attr| (attr.name.as_str(), attr.value.as_str()))
                .collect();
            attrs.sort_unstable();
            (node.text.trim(), attrs)
        })
}
