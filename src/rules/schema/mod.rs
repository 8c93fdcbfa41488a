//! The vocabulary of URDF as one table: which element may stand where, its attributes, units and defaults.
//!
//! Rules check against it; completion and hover can be served from it.

mod control;
mod spec;
mod srdf;
mod urdf;

use std::sync::LazyLock;

use base::FastMap;

pub use spec::{AttributeKind, AttributeSpec, ContentModel, ElementSpec};

impl ElementSpec {
    /// The element of a name that may stand in it.
    pub fn child(&self, name: &str) -> Option<&'static ElementSpec> {
        static BY_PARENT: LazyLock<FastMap<(&str, &str), &'static ElementSpec>> =
            LazyLock::new(|| {
                let pairs = every_element().flat_map(|element| {
                    element.parents.iter().map(move |parent| (parent, element))
                });
                // of two elements of one name the first counts
                let mut known = FastMap::default();
                pairs.for_each(|(&parent, element)| {
                    known.entry((parent, element.name)).or_insert(element);
                });
                known
            });
        BY_PARENT.get(&(self.key, name)).copied()
    }

    /// The elements that may stand in it.
    pub fn children(&self) -> impl Iterator<Item = &'static ElementSpec> + use<> {
        let key = self.key;
        every_element().filter(move |element| element.parents.contains(&key))
    }
}

/// All elements, those of URDF first.
pub fn elements() -> impl Iterator<Item = &'static ElementSpec> {
    std::iter::once(robot())
        .chain(urdf::ELEMENTS)
        .chain(control::ELEMENTS)
}

/// All elements of URDF and SRDF; those of SRDF have keys of their own.
pub fn every_element() -> impl Iterator<Item = &'static ElementSpec> {
    elements().chain(semantic_elements())
}

/// The elements of SRDF.
pub fn semantic_elements() -> impl Iterator<Item = &'static ElementSpec> {
    std::iter::once(semantic_robot()).chain(srdf::ELEMENTS)
}

/// The root element of SRDF.
pub fn semantic_robot() -> &'static ElementSpec {
    &srdf::ROBOT
}

/// The root element.
pub fn robot() -> &'static ElementSpec {
    &urdf::ROBOT
}

/// Whether an element of this name may stand somewhere outside of the blocks that are meant for other tools.
pub(super) fn is_urdf(name: &str) -> bool {
    name == robot().name
        || urdf::ELEMENTS.iter().any(|element| element.name == name)
        || robot().child(name).is_some()
}

/// Elements of one name outside of those blocks, wherever they may stand.
pub(super) fn urdf_element(name: &str) -> Option<&'static ElementSpec> {
    urdf::ELEMENTS.iter().find(|element| element.name == name)
}

#[cfg(test)]
mod tests {
    use super::{AttributeKind, ContentModel, every_element, robot, semantic_robot};

    #[test]
    fn parents_are_elements_and_required_children_are_children() {
        for spec in every_element() {
            for parent in spec.parents {
                assert!(
                    every_element().any(|other| other.key == *parent),
                    "{}: {parent}",
                    spec.name
                );
            }
            for child in spec.required {
                assert!(spec.child(child).is_some(), "{}: {child}", spec.name);
            }
            let leaf = spec.children().next().is_none();
            assert!(leaf || spec.content != ContentModel::Text, "{}", spec.name);
        }
    }

    #[test]
    fn an_element_is_described_once_below_each_parent() {
        let mut seen = Vec::new();
        for spec in every_element() {
            for parent in spec.parents {
                assert!(
                    !seen.contains(&(spec.name, *parent)),
                    "{} in {parent}",
                    spec.name
                );
                seen.push((spec.name, *parent));
            }
        }
    }

    #[test]
    fn attributes_are_documented_and_defaults_fit() {
        for spec in every_element() {
            assert!(
                !spec.docs.is_empty() && !spec.docs.ends_with('.'),
                "{}",
                spec.name
            );
            for attribute in spec.attributes {
                let place = format!("{}/@{}", spec.name, attribute.name);
                assert!(
                    !attribute.docs.is_empty() && !attribute.docs.ends_with('.'),
                    "{place}"
                );
                let Some(default) = attribute.default else {
                    continue;
                };
                assert!(!attribute.required, "{place}");
                match attribute.kind {
                    AttributeKind::Choice(words) => assert!(words.contains(&default), "{place}"),
                    _ => {
                        let count = attribute.numbers();
                        assert!(
                            count.is_none_or(|n| default.split(' ').count() == n),
                            "{place}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn places() {
        let joint = robot().child("joint").unwrap();
        assert_eq!(joint.required, ["parent", "child"]);
        assert!(joint.child("origin").is_some() && joint.child("command_interface").is_none());
        assert!(robot().child("link").unwrap().child("origin").is_none());
        assert!(joint.attribute("type").unwrap().required);
        let controlled = robot()
            .child("ros2_control")
            .and_then(|block| block.child("joint"))
            .unwrap();
        assert!(controlled.child("command_interface").is_some());
        let group = semantic_robot().child("group").unwrap();
        assert!(
            group.child("chain").is_some()
                && group.child("group").unwrap().children().next().is_none()
        );
        assert!(semantic_robot().child("link").is_none() && robot().child("group").is_none());
    }
}
