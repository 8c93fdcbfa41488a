//! The finished document in as little room as possible: expansions are kept for long, and read often.
use super::node::{Links, XId, XKind, XNode};
use super::params::is_space;
use super::parts::{Part, Parts};
use super::tree::XTree;
use base::Id;

impl XTree {
    /// Forget nodes that are part of neither the document nor what stands in `beside`, and blank text between
    /// elements, which nothing shows. What is left lies in document order. Ids change, those in `beside` with them; answers with the
    /// old and the new ones of what stands below the root. One that stands for others has the new one of the last of these.
    pub(super) fn compact<'i>(&mut self, beside: impl Iterator<Item = &'i mut XId>) -> Vec<Moved> {
        let mut kept = Finished::default();
        let document = self.take_node(XId::DOCUMENT, None, &mut kept);
        kept.old_root = self.root();
        self.take_children(XId::DOCUMENT, document, &mut kept);
        for root in beside {
            let id = self.take_node(*root, None, &mut kept);
            self.take_children(*root, id, &mut kept);
            *root = id;
        }
        let moved = std::mem::take(&mut kept.moved);
        *self = kept.tree();
        moved
    }

    /// Move what a node says into `kept`, as the last child of a node.
    fn take_node(&mut self, id: XId, parent: Option<XId>, kept: &mut Finished) -> XId {
        kept.push(self.take(id), parent)
    }

    fn take_children(&mut self, from: XId, to: XId, kept: &mut Finished) {
        // an explicit stack: documents may be nested deeper than the call stack is
        let mut open = vec![(self.first_child(from), to, self.is_spaced(from))];
        while let Some((next, parent, spaced)) = open.pop() {
            let Some(id) = next else { continue };
            open.push((self.next_sibling(id), parent, spaced));
            let node = self.get(id);
            let is_element = node.kind == XKind::Element;
            if spaced && node.kind == XKind::Text && node.text.chars().all(is_space) {
                continue;
            }
            let new = match self.take_kept(id) {
                Some(parts) => kept.add(parts),
                None => self.take_node(id, Some(parent), kept),
            };
            let parent = self.parent(id);
            let old = id;
            kept.note(
                parent,
                Moved {
                    old,
                    new,
                    is_element,
                },
            );
            if let Some(first) = self.first_child(id) {
                open.push((Some(first), new, self.is_spaced(id)));
            }
        }
    }

    /// Whether blank text among the children means nothing: beside an element it decides nothing about the layout.
    fn is_spaced(&self, id: XId) -> bool {
        self.elements(id).next().is_some()
    }
}

/// A child of the root element, as it was numbered and as it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moved {
    pub old: XId,
    pub new: XId,
    pub is_element: bool,
}

/// The nodes of a finished document while they are put together.
#[derive(Default)]
struct Finished {
    pieces: Vec<Piece>,
    len: usize,
    root: Option<XId>,
    /// The root element before, and what stands below it.
    old_root: Option<XId>,
    moved: Vec<Moved>,
}

enum Piece {
    Own {
        start: usize,
        nodes: Vec<XNode>,
        tops: Option<(XId, XId)>,
    },
    Kept(Part),
}

impl Finished {
    /// Add a node behind the last child of a node.
    fn push(&mut self, node: XNode, parent: Option<XId>) -> XId {
        let id = XId::from_index(self.len);
        self.len += 1;
        match self.pieces.last_mut() {
            Some(Piece::Own { nodes, .. }) => nodes.push(node),
            _ => self.pieces.push(Piece::Own {
                start: id.index(),
                nodes: vec![node],
                tops: None,
            }),
        }
        if let Some(parent) = parent {
            self.link(parent, (id, id));
            if self.root == Some(parent)
                && let Some(Piece::Own { tops, .. }) = self.pieces.last_mut()
            {
                *tops = Some((tops.map_or(id, |(first, _)| first), id));
            }
        }
        id
    }

    /// Add what lies below the root element of another document; the last of it.
    fn add(&mut self, parts: Vec<Part>) -> XId {
        let mut last = XId::DOCUMENT;
        for part in parts {
            let part = part.placed(self.len);
            self.len += part.len();
            if let (Some(tops), Some(root)) = (part.tops(), self.root) {
                self.link(root, tops);
                last = tops.1;
            }
            self.pieces.push(Piece::Kept(part));
        }
        last
    }

    /// Put nodes, of which these are the first and the last one, behind the last child of `parent`.
    fn link(&mut self, parent: XId, (first, last): (XId, XId)) {
        let Some(around) = self.own(parent) else {
            return;
        };
        let mut links = around.links();
        let before = links.last.replace(last);
        links.first.get_or_insert(first);
        around.set_links(links);
        if let Some(node) = before.and_then(|before| self.own(before)) {
            let links = node.links();
            node.set_links(Links {
                next: Some(first),
                ..links
            });
        }
        if let Some(node) = self.own(first) {
            let links = node.links();
            node.set_links(Links {
                parent: Some(parent),
                prev: before,
                ..links
            });
        }
    }

    /// A node of this document alone.
    fn own(&mut self, id: XId) -> Option<&mut XNode> {
        let pieces = self.pieces.iter_mut().rev();
        pieces
            .filter_map(|piece| match piece {
                Piece::Own { start, nodes, .. } => nodes.get_mut(id.index().checked_sub(*start)?),
                Piece::Kept(_) => None,
            })
            .next()
    }

    /// Note the new number of a node that had this parent.
    fn note(&mut self, parent: Option<XId>, moved: Moved) {
        if parent == Some(XId::DOCUMENT) && self.old_root == Some(moved.old) {
            self.root = Some(moved.new);
        } else if self.old_root.is_some() && parent == self.old_root {
            self.moved.push(moved);
        }
    }

    fn tree(self) -> XTree {
        let parts = self.pieces.into_iter().map(|piece| match piece {
            Piece::Own {
                start,
                mut nodes,
                tops,
            } => {
                nodes.shrink_to_fit();
                Part::own(start, nodes, tops)
            }
            Piece::Kept(part) => part,
        });
        XTree::finished(Parts::new(parts.collect(), self.root))
    }
}

#[cfg(test)]
mod tests {
    use super::super::node::{XId, XKind};
    use super::super::origin::Origin;
    use super::super::tree::XTree;
    use super::super::write::write;

    fn tree_of(children: &[(XKind, &str)]) -> XTree {
        fn add(tree: &mut XTree, parent: XId, kind: XKind, text: &str) -> XId {
            let id = tree.add(kind, text.into(), Origin::NOWHERE);
            tree.append(parent, id);
            id
        }
        let mut tree = XTree::default();
        let root = add(&mut tree, XId::DOCUMENT, XKind::Element, "robot");
        for &(kind, text) in children {
            let id = add(&mut tree, root, kind, text);
            let lost = add(&mut tree, root, XKind::Element, "lost");
            tree.detach(lost);
            if kind == XKind::Element {
                add(&mut tree, id, XKind::Text, "\n");
                add(&mut tree, id, XKind::Text, " text ");
            }
        }
        tree
    }

    #[test]
    fn a_compact_document_reads_the_same() {
        use XKind::{Comment, Element, Text};
        let documents: [&[(XKind, &str)]; 4] = [
            &[
                (Text, "\n  "),
                (Element, "link"),
                (Text, "\n  "),
                (Element, "joint"),
                (Text, "\n"),
            ],
            &[(Text, " "), (Comment, "c"), (Text, "t")],
            &[(Text, " ")],
            &[(Text, "t"), (Element, "link"), (Text, " \n")],
        ];
        for children in documents {
            let mut tree = tree_of(children);
            let before = (write(&tree, "robot.xacro").text, tree.len());
            let mut beside = tree.add(XKind::Container, "macro".into(), Origin::NOWHERE);
            tree.compact(std::iter::once(&mut beside));
            assert_eq!(write(&tree, "robot.xacro").text, before.0);
            assert!(tree.len() <= before.1, "{children:?}");
            assert_eq!(tree.get(beside).text, "macro");
            let ids: Vec<XId> = tree.below(XId::DOCUMENT).collect();
            assert!(ids.is_sorted(), "{ids:?}");
        }
    }
}
