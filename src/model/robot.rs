//! Reading links and joints off the expanded tree.

use ecow::EcoString;

use crate::expand::{Expansion, Origin, XAttr, XId, XTree};

/// The value of an attribute, and where it stands in the source.
#[derive(Clone, Debug)]
pub struct Text {
    /// The value after evaluation.
    pub value: EcoString,
    /// The value's text in the source, without quotes.
    pub origin: Origin,
    /// False when a part of the value could not be computed: no rule may draw a conclusion from it.
    pub known: bool,
    /// Whether the source holds the value itself, not an expression.
    pub literal: bool,
}

impl Text {
    fn of(attr: &XAttr) -> Self {
        let known = attr.pieces.iter().all(|piece| !piece.unknown);
        Self { value: attr.value.clone(), origin: attr.origin, known, literal: attr.pieces.is_empty() }
    }

    /// An attribute of an element.
    pub fn attr(tree: &XTree, element: XId, name: &str) -> Option<Self> {
        tree.attr(element, name).map(Text::of)
    }

    /// The value, when all of it is known and it is not empty.
    pub fn name(&self) -> Option<&EcoString> {
        (self.known && !self.value.is_empty()).then_some(&self.value)
    }
}

/// A `link` of the robot.
#[derive(Clone, Debug)]
pub struct Link {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<Text>,
}

/// A `joint` of the robot.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<Text>,
    /// Its `type`.
    pub kind: Option<Text>,
    /// The `link` of its `parent`.
    pub parent: Option<Text>,
    /// The `link` of its `child`.
    pub child: Option<Text>,
}

impl Joint {
    /// Names of parent and child, when both are known.
    pub fn ends(&self) -> Option<(&EcoString, &EcoString)> {
        Some((self.parent.as_ref()?.name()?, self.child.as_ref()?.name()?))
    }

    /// Its name for messages.
    pub fn shown(&self) -> &str {
        self.name.as_ref().map_or("", |name| name.value.as_str())
    }
}

/// What an expanded document says about a robot.
#[derive(Clone, Debug)]
pub struct Robot {
    /// The root element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<Text>,
    /// Its links in document order.
    pub links: Vec<Link>,
    /// Its joints in document order.
    pub joints: Vec<Joint>,
}

impl Robot {
    /// The robot of an expansion; none when the root element is something else.
    pub fn of(expansion: &Expansion) -> Option<Self> {
        let tree = &expansion.tree;
        let element = tree.root().filter(|&root| tree.get(root).text == "robot")?;
        let mut robot =
            Self { element, name: Text::attr(tree, element, "name"), links: Vec::new(), joints: Vec::new() };
        for child in tree.elements(element) {
            match tree.get(child).text.as_str() {
                "link" => robot.links.push(Link { element: child, name: Text::attr(tree, child, "name") }),
                "joint" => robot.joints.push(joint(tree, child)),
                _ => {}
            }
        }
        Some(robot)
    }

    /// Whether the document stands on its own: a robot with a name and a link.
    pub fn is_entry(&self) -> bool {
        !self.links.is_empty() && self.name.as_ref().is_some_and(|name| !name.value.is_empty())
    }

    /// Whether all names of links and joints and all ends of joints are known.
    pub fn names_are_known(&self) -> bool {
        let known = |text: &Option<Text>| text.as_ref().is_none_or(|text| text.known);
        self.links.iter().all(|link| known(&link.name))
            && self
                .joints
                .iter()
                .all(|joint| known(&joint.name) && known(&joint.parent) && known(&joint.child))
    }
}

fn joint(tree: &XTree, element: XId) -> Joint {
    // urdfdom reads the first element of each name
    let end = |name: &str| {
        let first = tree.elements(element).find(|&id| tree.get(id).text == name)?;
        Text::attr(tree, first, "link")
    };
    Joint {
        element,
        name: Text::attr(tree, element, "name"),
        kind: Text::attr(tree, element, "type"),
        parent: end("parent"),
        child: end("child"),
    }
}
