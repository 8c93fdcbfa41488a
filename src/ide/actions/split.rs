//! What one sees of a link and what it collides with become two links.

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
    let children = || link.child_elements();
    let collisions: Vec<Node<'_>> = children()
        .filter(|child| child.name() == "collision")
        .collect();
    let name = link.attr("name")?.raw();
    // what macros and blocks bring along cannot be seen here
    let plain = children().all(|child| !child.name().starts_with("xacro:"));
    let is_link = link.parent().is_none_or(|parent| parent.name() != "joint");
    let in_tag = link.start_tag_range().shift(base).touches(offset);
    let has_visual = children().any(|child| child.name() == "visual");
    if !plain || !is_link || !in_tag || !has_visual || collisions.is_empty() || name.is_empty() {
        return None;
    }
    let (copy, joint) = (
        format!("{name}_collision"),
        format!("{name}_collision_joint"),
    );
    let written = |new: &str| {
        all_names(cx).iter().any(|known| known.text.value == new)
            || document.text().contains(&format!("\"{new}\""))
    };
    if written(&copy) || written(&joint) {
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
