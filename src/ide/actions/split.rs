//! What one sees of a link and what it collides with become two links.

use super::inertia::child;
use super::place::{enclosing, line_end, margin};
use super::{Action, ActionKind, edit};
use crate::robot_names::all_names;
use crate::{Cx, indentation};
use base::TextRange;
use xml::{Node, NodeKind};

/// Move the collisions of the link at an offset to a link of their own, which a fixed joint holds in the same place.
pub(super) fn collision(cx: &Cx<'_>, offset: u32) -> Option<Action> {
    let source = cx.source;
    let document = &source.document;
    let (base, link) = enclosing(document, offset, "link")?;
    let collisions: Vec<Node<'_>> = link
        .child_elements()
        .filter(|child| child.name() == "collision")
        .collect();
    let name = link.attr("name")?.raw();
    // what macros and blocks bring along cannot be seen here
    let plain = link
        .child_elements()
        .all(|child| !child.name().starts_with("xacro:"));
    let is_link = link.parent().is_none_or(|parent| parent.name() != "joint");
    let in_tag = link.start_tag_range().shift(base).touches(offset);
    let has_visual = child(link, "visual").is_some();
    if !plain || !is_link || !in_tag || !has_visual || collisions.is_empty() || name.is_empty() {
        return None;
    }
    let (copy, joint) = (
        format!("{name}_collision"),
        format!("{name}_collision_joint"),
    );
    if is_written(cx, &copy) || is_written(cx, &joint) {
        return None;
    }
    let (end, unit) = (line_end(document), indentation(document).unit);
    let own = margin(document, base + link.range().start);
    let (one, two) = (format!("{end}{own}"), format!("{end}{own}{unit}"));
    let bodies: Vec<String> = collisions
        .iter()
        .map(|node| format!("{two}{}", document.slice(node.range().shift(base))))
        .collect();
    let text = format!(
        "{one}<link name=\"{copy}\">{}{one}</link>{one}<joint name=\"{joint}\" type=\"fixed\">\
         {two}<parent link=\"{name}\"/>{two}<child link=\"{copy}\"/>{one}</joint>",
        bodies.concat()
    );
    let mut edits: Vec<_> = collisions
        .iter()
        .map(|node| edit(source, with_blanks(*node).shift(base), ""))
        .collect();
    edits.push(edit(
        source,
        TextRange::empty(base + link.range().end),
        text,
    ));
    let title = format!("split link `{name}` into a visual and a collision link");
    Some(Action {
        title,
        kind: ActionKind::Rewrite,
        edits,
    })
}

/// Whether the robot or the file has a name already.
fn is_written(cx: &Cx<'_>, name: &str) -> bool {
    all_names(cx).iter().any(|known| known.text.value == name)
        || cx.source.document.text().contains(&format!("\"{name}\""))
}

/// An element with the white space in front of it.
fn with_blanks(node: Node<'_>) -> TextRange {
    let siblings = node
        .parent()
        .into_iter()
        .flat_map(|parent| parent.children());
    let before = siblings.take_while(|other| *other != node).last();
    let blank = before.filter(|text| text.kind() == NodeKind::Text && text.raw().trim().is_empty());
    let start = blank.map_or(node.range().start, |text| text.range().start);
    TextRange::new(start, node.range().end)
}
