//! The finished document in as little room as possible: expansions are kept for long, and read often.
use super::params::is_space;
use super::tree::{XId, XKind, XTree};

impl XTree {
    /// Forget nodes that are part of neither the document nor what stands in `beside`, and blank text between
    /// elements, which nothing shows. What is left lies in document order. Ids change, those in `beside` with them.
    pub(super) fn compact<'i>(&mut self, beside: impl Iterator<Item = &'i mut XId>) {
        let mut kept = XTree::default();
        kept.reserve(self.len());
        self.take_children(XId::DOCUMENT, XId::DOCUMENT, &mut kept);
        for root in beside {
            let id = self.take_node(*root, &mut kept);
            self.take_children(*root, id, &mut kept);
            *root = id;
        }
        kept.shrink();
        *self = kept;
    }

    /// Move what a node says into `kept`, without its place.
    fn take_node(&mut self, id: XId, kept: &mut XTree) -> XId {
        let node = self.get_mut(id);
        let new = kept.add(node.kind, std::mem::take(&mut node.text), node.origin);
        kept.get_mut(new).attrs = std::mem::take(&mut self.get_mut(id).attrs);
        new
    }

    fn take_children(&mut self, from: XId, to: XId, kept: &mut XTree) {
        // an explicit stack: documents may be nested deeper than the call stack is
        let mut open = vec![(self.first_child(from), to, self.is_spaced(from))];
        while let Some((next, parent, spaced)) = open.pop() {
            let Some(id) = next else { continue };
            open.push((self.next_sibling(id), parent, spaced));
            let node = self.get(id);
            if spaced && node.kind == XKind::Text && node.text.chars().all(is_space) {
                continue;
            }
            let new = self.take_node(id, kept);
            kept.append(parent, new);
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

#[cfg(test)]
mod tests {
    use super::super::origin::Origin;
    use super::super::tree::{XId, XKind, XTree};
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
