//! The names of links and joints, and what refers to them.
use super::super::context::DocumentCx;
use super::super::finding::Edit;
use base::{FastMap, FastSet};
use ecow::EcoString;
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
    let named_by = cx
        .named_by
        .get_or_init(|| NamedBy::of(cx.expansion, cx.element));
    let mentions = named_by.of_element(named);
    if mentions.contains_key(new) {
        return None;
    }
    let mut places = FastSet::default();
    let mut edits = Vec::new();
    for &(id, attr) in mentions.get(old)? {
        let text = AttrValue::attr(&cx.expansion.tree, id, attr)?;
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
    Some(edits)
}

/// Attributes by the name that is their value.
type Mentions = FastMap<EcoString, Vec<(XId, &'static str)>>;

/// The attributes that name links and joints: where they are defined and where they are referred to.
#[derive(Default)]
pub(in super::super) struct NamedBy {
    links: Mentions,
    joints: Mentions,
}

impl NamedBy {
    fn of(expansion: &Expansion, root: XId) -> Self {
        let tree = &expansion.tree;
        let mut found = Self::default();
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            let node = tree.get(id);
            let around = tree
                .parent(id)
                .filter(|&id| tree.get(id).kind == XKind::Element);
            let parent = around.map_or("", |id| tree.get(id).text.as_str());
            let (of_link, of_joint) = match (node.text.as_str(), parent) {
                ("link", _) => (Some("name"), None),
                ("joint", _) => (None, Some("name")),
                ("parent" | "child", "joint") => (Some("link"), None),
                ("mimic", _) => (None, Some("joint")),
                ("gazebo", _) => (Some("reference"), Some("reference")),
                _ => (None, None),
            };
            let maps = [(&mut found.links, of_link), (&mut found.joints, of_joint)];
            for (map, attr) in maps {
                if let Some(attr) = attr
                    && let Some(value) = tree.attr(id, attr)
                {
                    map.entry(value.value.clone()).or_default().push((id, attr));
                }
            }
            open.extend(tree.elements(id));
        }
        found
    }

    fn of_element(&self, named: NamedElement) -> &Mentions {
        match named {
            NamedElement::Link => &self.links,
            NamedElement::Joint => &self.joints,
        }
    }
}
