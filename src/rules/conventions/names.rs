//! The names of links and joints, and what refers to them.
use super::super::context::DocumentCx;
use super::super::finding::Edit;
use super::named_by::NamedBy;
use base::FastSet;
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
        .get_or_init(|| NamedBy::of(&cx.expansion.tree, cx.element));
    let mentions = match named {
        NamedElement::Link => &named_by.links,
        NamedElement::Joint => &named_by.joints,
    };
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
