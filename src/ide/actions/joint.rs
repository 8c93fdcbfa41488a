//! What links and joints often lack, added from what is there.

use super::inertia::child;
use super::place::{enclosing, last_child, line_end, margin};
use super::{Action, ActionKind, edit};
use crate::indentation;
use base::TextRange;
use vfs::SourceFile;
use xml::Node;

/// Elements that the joint at an offset can have and does not.
pub(super) fn additions(source: &SourceFile, offset: u32) -> Vec<Action> {
    let Some((base, joint)) = enclosing(&source.document, offset, "joint") else {
        return Vec::new();
    };
    let kind = joint.attr("type").map_or("", |kind| kind.raw());
    // what a macro or a block brings along cannot be seen here
    if joint
        .child_elements()
        .any(|child| child.name().starts_with("xacro:"))
    {
        return Vec::new();
    }
    let mut missing = Vec::new();
    if matches!(kind, "revolute" | "continuous" | "prismatic" | "planar")
        && child(joint, "axis").is_none()
    {
        missing.push(("add default `axis`", "<axis xyz=\"1 0 0\"/>"));
    }
    if matches!(kind, "revolute" | "prismatic") && child(joint, "limit").is_none() {
        let limit = "<limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>";
        missing.push(("add `limit`", limit));
    }
    let actions = missing.into_iter().map(|(title, text)| {
        let (range, text) = last_child(source, base, joint, text);
        Action {
            title: title.to_owned(),
            kind: ActionKind::Rewrite,
            edits: vec![edit(source, range, text)],
        }
    });
    actions.collect()
}

/// An inertial for the link at an offset, of a body of 1 kg to be replaced by the true one.
pub(super) fn inertial(source: &SourceFile, offset: u32) -> Option<Action> {
    let (base, link) = enclosing(&source.document, offset, "link")?;
    let brings_one =
        |node: Node<'_>| node.name() == "inertial" || node.name().starts_with("xacro:");
    let whole = link.start_tag_range().shift(base).touches(offset);
    if !whole
        || link.parent().is_some_and(|parent| parent.name() == "joint")
        || link.child_elements().any(brings_one)
    {
        return None;
    }
    let (end, unit) = (
        line_end(&source.document),
        indentation(&source.document).unit,
    );
    let inner = format!(
        "{end}{}{unit}{unit}",
        margin(&source.document, base + link.range().start)
    );
    let text = format!(
        "<inertial>{inner}<mass value=\"1\"/>{inner}\
         <inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/>{}</inertial>",
        inner.strip_suffix(unit.as_str()).unwrap_or(&inner)
    );
    let (range, text) = last_child(source, base, link, &text);
    let edits = vec![edit(source, range, text)];
    Some(Action {
        title: "add `inertial`".to_owned(),
        kind: ActionKind::Rewrite,
        edits,
    })
}

/// A collision of the shape of the visual at an offset.
pub(super) fn collision(source: &SourceFile, offset: u32) -> Option<Action> {
    let document = &source.document;
    let (base, visual) = enclosing(document, offset, "visual")?;
    let is_collision =
        |node: Node<'_>| node.name() == "collision" || node.name().starts_with("xacro:");
    if visual.parent()?.name() != "link" || visual.parent()?.child_elements().any(is_collision) {
        return None;
    }
    let (end, margin) = (
        line_end(document),
        margin(document, base + visual.range().start),
    );
    let inner = format!("{end}{margin}{}", indentation(document).unit);
    let kept = visual
        .child_elements()
        .filter(|child| matches!(child.name(), "origin" | "geometry"));
    let kept: Vec<String> = kept
        .map(|child| document.slice(child.range().shift(base)))
        .collect();
    if !kept.iter().any(|text| text.starts_with("<geometry")) {
        return None;
    }
    let text = format!(
        "{end}{margin}<collision>{inner}{}{end}{margin}</collision>",
        kept.join(&inner)
    );
    let edits = vec![edit(
        source,
        TextRange::empty(base + visual.range().end),
        text,
    )];
    Some(Action {
        title: "add `collision` with the same geometry".to_owned(),
        kind: ActionKind::Rewrite,
        edits,
    })
}
