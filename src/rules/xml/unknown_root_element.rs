//! A description whose root element is not `robot`.
use super::super::context::{DocumentCx, RootKind};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::tag_start;

pub(in super::super) static RULE: Rule = Rule {
    code: "XML005",
    name: "unknown-root-element",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unknown-root-element"),
    check: Check::Document(check),
};

/// Roots of other formats that carry the ending `.urdf` by accident.
const OTHER_FORMATS: [&str; 4] = ["sdf", "mujoco", "COLLADA", "launch"];

/// What stands inside of links: a file of these alone is a piece to be included there.
const PARTS_OF_LINKS: [&str; 6] = [
    "inertial",
    "visual",
    "collision",
    "origin",
    "geometry",
    "material",
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let Some(root) = tree
        .root()
        .filter(|_| cx.kind == RootKind::Robot && cx.robot.is_none())
    else {
        return;
    };
    let name = &tree.get(root).text;
    let report = out.report(
        tag_start(cx.expansion, root),
        format!("root element is `{name}` instead of `robot`"),
    );
    if OTHER_FORMATS.contains(&name.as_str()) && !cx.explicit {
        return report
            .severity(Severity::Info)
            .help("pass the file explicitly to check it; it is in another format")
            .done();
    }
    let mut parts = tree
        .elements(root)
        .map(|part| tree.get(part).text.as_str())
        .peekable();
    if parts.peek().is_some() && parts.all(|part| PARTS_OF_LINKS.contains(&part)) {
        return report
            .severity(Severity::Info)
            .help("include this file inside a link")
            .done();
    }
    report
        .help("write <robot name=\"...\"> as the root element")
        .done();
}
