//! Which comments disappear with the tags they stand in front of.
use super::expander::Expander;
use super::node::{XId, XKind};
use super::params::is_space;

impl Expander<'_> {
    /// Remove the comments at the end of `parent` that stand directly in front of a xacro tag:
    /// between them and the tag is at most one blank text with at most one line feed.
    ///
    /// What stops the removal is protected from tags further behind by the marker, an empty text.
    /// The reference has one such node for the whole run, and so do we: where it stood last decides
    /// how text in mixed content is laid out. `has_next`: the tag has a sibling behind it.
    pub fn drop_comments(&mut self, parent: XId, has_next: bool) {
        let tree = &mut self.result.tree;
        let mut previous = tree.last_child(parent);
        while let Some(id) = previous {
            let node = tree.get(id);
            let comment = match node.kind {
                XKind::Text if is_thin_blank(&node.text) => tree.prev_sibling(id),
                _ => Some(id),
            };
            let Some(comment) = comment.filter(|&c| tree.get(c).kind == XKind::Comment) else {
                if has_next {
                    tree.detach(self.marker);
                    tree.append(parent, self.marker);
                }
                return;
            };
            previous = tree.prev_sibling(comment);
            tree.detach(comment);
        }
    }

    /// Move the content of `from` to the end of `to`, in front of the marker if that stands there.
    pub fn splice(&mut self, from: XId, to: XId) {
        let tree = &mut self.result.tree;
        let protected = tree.last_child(to) == Some(self.marker);
        if protected {
            tree.detach(self.marker);
        }
        tree.move_children(from, to);
        if protected {
            tree.append(to, self.marker);
        }
    }
}

/// Whether a text is blank and has at most one line feed.
pub(super) fn is_thin_blank(text: &str) -> bool {
    !text.is_empty() && text.chars().all(is_space) && text.matches('\n').count() <= 1
}
