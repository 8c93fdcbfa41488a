//! Where links and joints are named.
use ecow::EcoString;

use base::FastMap;
use expand::{XId, XKind, XTree};

/// Attributes by the name that is their value.
pub(in super::super) type Mentions = FastMap<EcoString, Vec<(XId, &'static str)>>;

/// The attributes that name links and joints: where they are defined and where they are referred to.
#[derive(Default)]
pub(in super::super) struct NamedBy {
    /// Attributes that name links.
    pub links: Mentions,
    /// Attributes that name joints.
    pub joints: Mentions,
}

impl NamedBy {
    /// Those of an element and all that is in it.
    pub fn of(tree: &XTree, root: XId) -> Self {
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
}
