//! Joints: types, axes, limits, dynamics, mimic.
use std::sync::OnceLock;

use ecow::EcoString;

use super::attr_value::AttrValue;
use super::pose::Pose;
use super::source::first_children;
use super::version::Version;
use expand::{XId, XTree};

/// A `joint` of the robot.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// Its `type`.
    pub kind: Option<AttrValue>,
    /// The same, when it is known and one of URDF's: many rules ask for it.
    known_kind: Option<JointType>,
    /// The `link` of its `parent`.
    pub parent: Option<AttrValue>,
    /// The `link` of its `child`.
    pub child: Option<AttrValue>,
    /// Where the child's frame stands in the parent's at position zero.
    pub origin: Option<Pose>,
    /// Its first `axis`.
    pub axis: Option<Axis>,
    /// Its first `limit`.
    pub limit: Option<Limit>,
    /// Its first `dynamics`. Boxed, as what follows: most joints have none.
    pub dynamics: Option<Box<Dynamics>>,
    /// Its first `mimic`.
    pub mimic: Option<Box<Mimic>>,
    /// Its first `safety_controller`.
    pub safety: Option<Box<SafetyController>>,
}

/// The types of joints that URDF knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum JointType {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    Floating,
    Planar,
}

impl JointType {
    /// All of them with their names.
    pub const ALL: [(&'static str, JointType); 6] = [
        ("revolute", JointType::Revolute),
        ("continuous", JointType::Continuous),
        ("prismatic", JointType::Prismatic),
        ("fixed", JointType::Fixed),
        ("floating", JointType::Floating),
        ("planar", JointType::Planar),
    ];

    /// The type of a name.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL
            .iter()
            .find(|(known, _)| *known == name)
            .map(|&(_, kind)| kind)
    }

    /// Whether it moves along or about one axis.
    pub fn has_axis(self) -> bool {
        matches!(
            self,
            JointType::Revolute | JointType::Continuous | JointType::Prismatic
        )
    }
}

/// An `axis`.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Its element.
    pub element: XId,
    /// Its direction in the joint's frame; unit length is expected, 1 0 0 is the default.
    pub xyz: Option<AttrValue>,
    /// The same as numbers: many rules ask for it.
    direction: OnceLock<Option<[f64; 3]>>,
}

impl Axis {
    /// Its direction; none when it is no known vector.
    fn direction(&self) -> Option<[f64; 3]> {
        let read = || {
            let xyz = self.xyz.as_ref();
            xyz.map_or(Some(Joint::DEFAULT_AXIS), AttrValue::numbers)
        };
        *self.direction.get_or_init(read)
    }
}

/// A `limit`: radians or meters, N m or N, rad/s or m/s.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Limit {
    pub element: XId,
    pub lower: Option<AttrValue>,
    pub upper: Option<AttrValue>,
    pub effort: Option<AttrValue>,
    pub velocity: Option<AttrValue>,
    /// `acceleration`, `deceleration` and `jerk`; none in robots older than URDF 1.2, where nobody reads them.
    pub dynamic: [Option<AttrValue>; 3],
}

impl Limit {
    /// The names of the entries of [`Limit::dynamic`].
    pub const DYNAMIC: [&'static str; 3] = ["acceleration", "deceleration", "jerk"];

    /// `lower` and `upper`, zero where absent as in urdfdom; none when one is not known.
    pub fn range(&self) -> Option<(f64, f64)> {
        Some((bound(&self.lower)?, bound(&self.upper)?))
    }

    fn of(tree: &XTree, element: XId) -> Self {
        let dynamic = Self::DYNAMIC
            .map(|name| AttrValue::attr(tree, element, name).filter(|_| Version::V1_2.is_in(tree)));
        Self {
            element,
            lower: AttrValue::attr(tree, element, "lower"),
            upper: AttrValue::attr(tree, element, "upper"),
            effort: AttrValue::attr(tree, element, "effort"),
            velocity: AttrValue::attr(tree, element, "velocity"),
            dynamic,
        }
    }
}

/// A bound of a range, zero where absent; none when it is not known.
fn bound(text: &Option<AttrValue>) -> Option<f64> {
    text.as_ref().map_or(Some(0.0), AttrValue::number)
}

/// A `dynamics`: N m s/rad or N s/m, N m or N.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Dynamics {
    pub element: XId,
    pub damping: Option<AttrValue>,
    pub friction: Option<AttrValue>,
}

/// A `mimic`: position = multiplier * position of the joint + offset.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Mimic {
    pub element: XId,
    pub joint: Option<AttrValue>,
    pub multiplier: Option<AttrValue>,
    pub offset: Option<AttrValue>,
}

/// A `safety_controller`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct SafetyController {
    pub element: XId,
    pub soft_lower_limit: Option<AttrValue>,
    pub soft_upper_limit: Option<AttrValue>,
    pub k_position: Option<AttrValue>,
    pub k_velocity: Option<AttrValue>,
}

impl Dynamics {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            damping: AttrValue::attr(tree, element, "damping"),
            friction: AttrValue::attr(tree, element, "friction"),
        }
    }
}

impl Mimic {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            joint: AttrValue::attr(tree, element, "joint"),
            multiplier: AttrValue::attr(tree, element, "multiplier"),
            offset: AttrValue::attr(tree, element, "offset"),
        }
    }
}

impl SafetyController {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            soft_lower_limit: AttrValue::attr(tree, element, "soft_lower_limit"),
            soft_upper_limit: AttrValue::attr(tree, element, "soft_upper_limit"),
            k_position: AttrValue::attr(tree, element, "k_position"),
            k_velocity: AttrValue::attr(tree, element, "k_velocity"),
        }
    }
}

impl Joint {
    const DEFAULT_AXIS: [f64; 3] = [1.0, 0.0, 0.0];

    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        const NAMES: [&str; 8] = [
            "parent",
            "child",
            "origin",
            "axis",
            "limit",
            "dynamics",
            "mimic",
            "safety_controller",
        ];
        let [parent, child, origin, axis, limit, dynamics, mimic, safety] =
            first_children(tree, element, NAMES);
        let end = |end: Option<XId>| AttrValue::attr(tree, end?, "link");
        let kind = AttrValue::attr(tree, element, "type");
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            known_kind: kind.as_ref().and_then(|kind| JointType::of(kind.name()?)),
            kind,
            parent: end(parent),
            child: end(child),
            origin: origin.map(|origin| Pose::of(tree, origin)),
            axis: axis.map(|axis| Axis {
                element: axis,
                xyz: AttrValue::attr(tree, axis, "xyz"),
                direction: OnceLock::new(),
            }),
            limit: limit.map(|limit| Limit::of(tree, limit)),
            dynamics: dynamics.map(|dynamics| Box::new(Dynamics::of(tree, dynamics))),
            mimic: mimic.map(|mimic| Box::new(Mimic::of(tree, mimic))),
            safety: safety.map(|safety| Box::new(SafetyController::of(tree, safety))),
        }
    }

    /// Names of parent and child, when both are known.
    pub fn ends(&self) -> Option<(&EcoString, &EcoString)> {
        Some((self.parent.as_ref()?.name()?, self.child.as_ref()?.name()?))
    }

    /// Its name for messages.
    pub fn shown(&self) -> &str {
        self.name.as_ref().map_or("", |name| name.value.as_str())
    }

    /// Its type, when it is known and one of URDF's.
    pub fn joint_type(&self) -> Option<JointType> {
        self.known_kind
    }

    /// Whether it is of one of these types; false when its type is not known.
    pub fn is(&self, kinds: &[JointType]) -> bool {
        self.joint_type().is_some_and(|kind| kinds.contains(&kind))
    }

    /// Whether it moves along or about one axis by itself, not with another joint.
    pub fn is_driven(&self) -> bool {
        self.joint_type().is_some_and(JointType::has_axis) && self.mimic.is_none()
    }

    /// Its axis in its own frame, 1 0 0 where none is written; none when it is no known vector.
    pub fn axis(&self) -> Option<[f64; 3]> {
        let axis = self.axis.as_ref();
        axis.map_or(Some(Self::DEFAULT_AXIS), Axis::direction)
    }
}
