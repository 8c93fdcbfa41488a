//! An element that is lost because it is the root of an included file.
use super::super::context::{DocumentCx, RootKind};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::TextRange;
use expand::{Expansion, FileIdx, XKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC044",
    name: "dropped-root-element",
    category: Category::Xacro,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("dropped-root-element"),
    check: Check::Document(check),
};

/// What means something inside of `robot`, and whose content means nothing there by itself.
const PARTS: [&str; 5] = ["gazebo", "joint", "link", "ros2_control", "transmission"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let expansion = cx.expansion;
    if cx.kind != RootKind::Robot || expansion.tree.root() != Some(cx.element) {
        return;
    }
    let included = expansion.files.iter_ids().skip(1);
    let roots = included.filter_map(|(file, used)| {
        let root = used.source.document.root()?;
        let name = PARTS.iter().find(|part| **part == root.name())?;
        Some((file, *name, root.name_range()))
    });
    for (file, name, range) in roots.collect::<Vec<_>>() {
        if !gives_children(expansion, file) {
            continue;
        }
        out.report_in(
            file,
            TextRange::new(range.start.saturating_sub(1), range.end),
            format!("`{name}` is lost: `xacro:include` inserts what the root element of a file has inside, without the element itself"),
        )
        .help(format!("write <robot> around `{name}`"))
        .done();
    }
}

/// Whether children of the root element of a file became children of the robot.
fn gives_children(expansion: &Expansion, file: FileIdx) -> bool {
    let tree = &expansion.tree;
    let is_child = |source: expand::Origin| {
        let item = expansion.sources.get(source.src);
        let node = item.and_then(|item| item.item.element_at(source.range.start));
        node.is_some_and(|node| node.parent().is_none())
    };
    let mut children = tree.root().into_iter().flat_map(|root| tree.children(root));
    children.any(|child| {
        let node = tree.get(child);
        let is_of_file = || {
            expansion
                .place(node.origin)
                .is_some_and(|place| place.file == file)
        };
        node.kind == XKind::Element && is_of_file() && is_child(node.origin)
    })
}
