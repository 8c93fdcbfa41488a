//! The names of links and joints, and what refers to them.
use super::super::context::DocumentCx;
use super::super::finding::Edit;
use base::FastSet;
use expand::{Expansion, XId, XKind};
use model::{AttrValue, Robot};

/// What a name names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum NamedElement {
    Link,
    Joint,
}

impl NamedElement {
    /// The word for messages.
    pub fn word(self) -> &'static str {
        match self {
            NamedElement::Link => "link",
            NamedElement::Joint => "joint",
        }
    }
}

/// The known names of a robot, or of what a library gives.
pub(in super::super) fn names(robot: &Robot) -> impl Iterator<Item = (NamedElement, &AttrValue)> {
    let links = robot
        .links
        .iter()
        .filter_map(|link| Some((NamedElement::Link, link.name.as_ref()?)));
    let joints = robot
        .joints
        .iter()
        .filter_map(|joint| Some((NamedElement::Joint, joint.name.as_ref()?)));
    links.chain(joints).filter(|(_, name)| name.is_known())
}

/// The edits that rename a link or joint with all that refers to it; none when some of it is computed, or when
/// the new name is taken.
pub(in super::super) fn rename(
    cx: &DocumentCx<'_>,
    named: NamedElement,
    old: &str,
    new: &str,
) -> Option<Vec<Edit>> {
    let mut places = FastSet::default();
    let mut edits = Vec::new();
    for (id, attr) in mentions(cx.expansion, cx.element, named) {
        let text = AttrValue::attr(&cx.expansion.tree, id, attr)?;
        if text.value == new {
            return None;
        }
        if text.value != old {
            continue;
        }
        let place = cx
            .expansion
            .place(text.origin)
            .filter(|_| text.is_literal())?;
        let file = cx.expansion.files.get(place.file)?.source.id;
        if places.insert(place) {
            let span = base::Span {
                file,
                range: place.range,
            };
            edits.push(Edit {
                span,
                content: new.to_owned(),
            });
        }
    }
    (!edits.is_empty()).then_some(edits)
}

/// The attributes that name links, or joints: where they are defined and where they are referred to.
fn mentions(expansion: &Expansion, root: XId, named: NamedElement) -> Vec<(XId, &'static str)> {
    let tree = &expansion.tree;
    let mut open = vec![root];
    let mut found = Vec::new();
    while let Some(id) = open.pop() {
        let node = tree.get(id);
        let around = tree
            .parent(id)
            .filter(|&id| tree.get(id).kind == XKind::Element);
        let parent = around.map_or("", |id| tree.get(id).text.as_str());
        let attr = match (node.text.as_str(), parent, named) {
            ("link", _, NamedElement::Link) | ("joint", _, NamedElement::Joint) => Some("name"),
            ("parent" | "child", "joint", NamedElement::Link) => Some("link"),
            ("mimic", _, NamedElement::Joint) => Some("joint"),
            ("gazebo", _, _) => Some("reference"),
            _ => None,
        };
        found.extend(
            attr.filter(|attr| tree.attr(id, attr).is_some())
                .map(|attr| (id, attr)),
        );
        open.extend(tree.elements(id));
    }
    found
}
