//! The vocabulary of URDF as one table: which element may stand where, its attributes, units and defaults.
//!
//! Rules check against it; completion and hover can be served from it.

mod control;
mod srdf;
mod urdf;

use std::sync::LazyLock;

use base::FastMap;
use model::Version;

/// An element below certain parents. Elements of one name below different parents have entries of their own.
#[derive(Clone, Copy, Debug)]
pub struct ElementSpec {
    /// Its name.
    pub name: &'static str,
    /// What its children call it: its name, unless an element elsewhere has the same name and other children.
    pub key: &'static str,
    /// The keys of the elements it may stand in; none for the root.
    pub parents: &'static [&'static str],
    /// What it is, in one line.
    pub docs: &'static str,
    /// Its attributes.
    pub attributes: &'static [AttributeSpec],
    /// Child elements that must be there.
    pub required: &'static [&'static str],
    /// Whether its parent may hold several.
    pub repeats: bool,
    /// Who decides about what stands inside.
    pub content: Content,
}

/// What may stand inside an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// The elements that name it as a parent, and no text.
    Elements,
    /// Text.
    Text,
    /// Whatever the tool it is meant for reads: the table lists the usual elements only.
    Free,
}

/// An attribute of an element.
#[derive(Clone, Copy, Debug)]
pub struct AttributeSpec {
    /// Its name.
    pub name: &'static str,
    /// What its value is.
    pub kind: AttributeKind,
    /// Whether parsers refuse the element without it.
    pub required: bool,
    /// The unit of its numbers: rad, m, kg and so on.
    pub unit: Option<&'static str>,
    /// The value that parsers take where it is absent.
    pub default: Option<&'static str>,
    /// What it says, in one line.
    pub docs: &'static str,
    /// The version of URDF that brought it; readers pass over it in robots of an older one.
    pub since: Version,
}

/// What the value of an attribute is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AttributeKind {
    /// The name of the thing itself.
    Name,
    /// The name of a link.
    Link,
    /// The name of a joint.
    Joint,
    /// The name of a link or a joint.
    LinkOrJoint,
    /// The name of a planning group.
    Group,
    /// A number.
    Number,
    /// So many numbers, separated by blanks.
    Vector(usize),
    /// One of these words.
    Choice(&'static [&'static str]),
    /// Where a file is: `package://...`, `file://...`, a path.
    Uri,
    /// Any text.
    Text,
}

impl ElementSpec {
    const fn new(name: &'static str, parents: &'static [&'static str], docs: &'static str) -> Self {
        let (attributes, required): (&[AttributeSpec], &[&str]) = (&[], &[]);
        Self {
            name,
            key: name,
            parents,
            docs,
            attributes,
            required,
            repeats: false,
            content: Content::Elements,
        }
    }

    const fn keyed(mut self, key: &'static str) -> Self {
        self.key = key;
        self
    }

    const fn with(mut self, attributes: &'static [AttributeSpec]) -> Self {
        self.attributes = attributes;
        self
    }

    const fn needs(mut self, children: &'static [&'static str]) -> Self {
        self.required = children;
        self
    }

    const fn many(mut self) -> Self {
        self.repeats = true;
        self
    }

    const fn holding(mut self, content: Content) -> Self {
        self.content = content;
        self
    }

    /// The attribute of a name.
    pub fn attribute(&self, name: &str) -> Option<&'static AttributeSpec> {
        self.attributes
            .iter()
            .find(|attribute| attribute.name == name)
    }

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

impl AttributeSpec {
    const fn new(name: &'static str, kind: AttributeKind, docs: &'static str) -> Self {
        Self {
            name,
            kind,
            required: false,
            unit: None,
            default: None,
            docs,
            since: Version::V1_0,
        }
    }

    const fn required(mut self) -> Self {
        self.required = true;
        self
    }

    const fn unit(mut self, unit: &'static str) -> Self {
        self.unit = Some(unit);
        self
    }

    const fn default(mut self, value: &'static str) -> Self {
        self.default = Some(value);
        self
    }

    const fn since(mut self, version: Version) -> Self {
        self.since = version;
        self
    }

    /// How many numbers its value holds; none when it holds something else.
    pub fn numbers(&self) -> Option<usize> {
        match self.kind {
            AttributeKind::Number => Some(1),
            AttributeKind::Vector(count) => Some(count),
            _ => None,
        }
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
    let of_urdf = || urdf::ELEMENTS.iter().any(|element| element.name == name);
    name == robot().name || of_urdf() || robot().child(name).is_some()
}

/// Elements of one name outside of those blocks, wherever they may stand.
pub(super) fn urdf_element(name: &str) -> Option<&'static ElementSpec> {
    urdf::ELEMENTS.iter().find(|element| element.name == name)
}

#[cfg(test)]
mod tests {
    use super::{AttributeKind, Content, every_element, robot, semantic_robot};

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
            assert!(leaf || spec.content != Content::Text, "{}", spec.name);
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
