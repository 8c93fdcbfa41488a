//! Blocks beside links and joints: Gazebo, ros2_control, transmissions.

use super::attr_value::AttrValue;
use super::source::{child, children};
use expand::{XId, XTree};

/// A `gazebo` element of the robot.
#[derive(Clone, Debug)]
pub struct Gazebo {
    /// Its element.
    pub element: XId,
    /// The link or joint it speaks about; none: the robot.
    pub reference: Option<AttrValue>,
}

/// A `ros2_control` element.
#[derive(Clone, Debug)]
pub struct Ros2Control {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// Its `type`: system, actuator or sensor.
    pub kind: Option<AttrValue>,
    /// Its `hardware` elements.
    pub hardware: Vec<XId>,
    /// Its `joint`s.
    pub joints: Vec<ControlJoint>,
}

/// A `joint` of a `ros2_control`.
#[derive(Clone, Debug)]
pub struct ControlJoint {
    /// Its element.
    pub element: XId,
    /// The joint of the robot it stands for.
    pub name: Option<AttrValue>,
    /// Its `mimic` attribute.
    pub mimic: Option<AttrValue>,
    /// Its `command_interface`s.
    pub commands: Vec<Interface>,
    /// Its `state_interface`s.
    pub states: Vec<Interface>,
}

/// A `command_interface` or `state_interface`.
#[derive(Clone, Debug)]
pub struct Interface {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// Its `param`s.
    pub params: Vec<InterfaceParam>,
}

/// A `param` of an interface.
#[derive(Clone, Debug)]
pub struct InterfaceParam {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// The text inside.
    pub value: Option<AttrValue>,
}

/// A `transmission` of the robot.
#[derive(Clone, Debug)]
pub struct Transmission {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// Its `joint`s: the element and its `name`.
    pub joints: Vec<(XId, Option<AttrValue>)>,
}

impl Gazebo {
    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            reference: AttrValue::attr(tree, element, "reference"),
        }
    }
}

impl Ros2Control {
    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            kind: AttrValue::attr(tree, element, "type"),
            hardware: children(tree, element, "hardware").collect(),
            joints: children(tree, element, "joint")
                .map(|joint| ControlJoint::of(tree, joint))
                .collect(),
        }
    }

    /// Its `hardware/plugin` element.
    pub fn plugin(&self, tree: &XTree) -> Option<XId> {
        child(tree, *self.hardware.first()?, "plugin")
    }
}

impl ControlJoint {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            mimic: AttrValue::attr(tree, element, "mimic"),
            commands: Interface::all(tree, element, "command_interface"),
            states: Interface::all(tree, element, "state_interface"),
        }
    }
}

impl ControlJoint {
    /// Its interfaces, those for commands first.
    pub fn interfaces(&self) -> impl Iterator<Item = &Interface> {
        self.commands.iter().chain(&self.states)
    }

    /// Its name for messages.
    pub fn shown(&self) -> &str {
        self.name.as_ref().map_or("", |name| name.value.as_str())
    }
}

impl Interface {
    /// The interfaces of a joint whose elements have the name `tag`.
    fn all(tree: &XTree, joint: XId, tag: &str) -> Vec<Self> {
        children(tree, joint, tag)
            .map(|interface| Self::of(tree, interface))
            .collect()
    }

    fn of(tree: &XTree, element: XId) -> Self {
        let params = children(tree, element, "param").map(|param| InterfaceParam::of(tree, param));
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            params: params.collect(),
        }
    }

    /// Whether it has this name.
    pub fn is(&self, name: &str) -> bool {
        self.name
            .as_ref()
            .and_then(AttrValue::name)
            .is_some_and(|own| own == name)
    }

    /// The text of its first `param` of a name.
    pub fn param(&self, name: &str) -> Option<&AttrValue> {
        let is_named =
            |param: &&InterfaceParam| param.name.as_ref().is_some_and(|own| own.value == name);
        self.params.iter().find(is_named)?.value.as_ref()
    }
}

impl InterfaceParam {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            value: AttrValue::content(tree, element),
        }
    }
}

impl Transmission {
    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        let joints = children(tree, element, "joint")
            .map(|joint| (joint, AttrValue::attr(tree, joint, "name")));
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            joints: joints.collect(),
        }
    }
}
