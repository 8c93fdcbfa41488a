//! Joints: types, axes, limits, dynamics, mimic.

use ecow::EcoString;

use super::pose::Pose;
use super::source::child;
use super::text::Text;
use super::version::Version;
use expand::{XId, XTree};

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
    pub safety: Option<Box<Safety>>,
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
    pub xyz: Option<Text>,
}

/// A `limit`: radians or meters, N m or N, rad/s or m/s.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Limit {
    pub element: XId,
    pub lower: Option<Text>,
    pub upper: Option<Text>,
    pub effort: Option<Text>,
    pub velocity: Option<Text>,
    /// `acceleration`, `deceleration` and `jerk`; none in robots older than URDF 1.2, where nobody reads them.
    pub dynamic: [Option<Text>; 3],
}

impl Limit {
    /// The names of the entries of [`Limit::dynamic`].
    pub const DYNAMIC: [&'static str; 3] = ["acceleration", "deceleration", "jerk"];

    /// `lower` and `upper`, zero where absent as in urdfdom; none when one is not known.
    pub fn range(&self) -> Option<(f64, f64)> {
        let bound = |text: &Option<Text>| text.as_ref().map_or(Some(0.0), Text::number);
        Some((bound(&self.lower)?, bound(&self.upper)?))
    }
}

/// A `dynamics`: N m s/rad or N s/m, N m or N.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Dynamics {
    pub element: XId,
    pub damping: Option<Text>,
    pub friction: Option<Text>,
}

/// A `mimic`: position = multiplier * position of the joint + offset.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Mimic {
    pub element: XId,
    pub joint: Option<Text>,
    pub multiplier: Option<Text>,
    pub offset: Option<Text>,
}

/// A `safety_controller`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Safety {
    pub element: XId,
    pub soft_lower_limit: Option<Text>,
    pub soft_upper_limit: Option<Text>,
    pub k_position: Option<Text>,
    pub k_velocity: Option<Text>,
}

impl Joint {
    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        // urdfdom reads the first element of each name
        let first = |name: &str| child(tree, element, name);
        let end = |name: &str| Text::attr(tree, first(name)?, "link");
        let text = |element: XId| move |name: &str| Text::attr(tree, element, name);
        Self {
            element,
            name: Text::attr(tree, element, "name"),
            kind: Text::attr(tree, element, "type"),
            parent: end("parent"),
            child: end("child"),
            origin: first("origin").map(|origin| Pose::of(tree, origin)),
            axis: first("axis").map(|element| Axis {
                element,
                xyz: text(element)("xyz"),
            }),
            limit: first("limit").map(|element| {
                let text = text(element);
                let (lower, upper) = (text("lower"), text("upper"));
                let (effort, velocity) = (text("effort"), text("velocity"));
                let dynamic =
                    Limit::DYNAMIC.map(|name| text(name).filter(|_| Version::V1_2.is_in(tree)));
                Limit {
                    element,
                    lower,
                    upper,
                    effort,
                    velocity,
                    dynamic,
                }
            }),
            dynamics: first("dynamics").map(|element| {
                let text = text(element);
                Box::new(Dynamics {
                    element,
                    damping: text("damping"),
                    friction: text("friction"),
                })
            }),
            mimic: first("mimic").map(|element| {
                let text = text(element);
                let (multiplier, offset) = (text("multiplier"), text("offset"));
                Box::new(Mimic {
                    element,
                    joint: text("joint"),
                    multiplier,
                    offset,
                })
            }),
            safety: first("safety_controller").map(|element| {
                let text = text(element);
                Box::new(Safety {
                    element,
                    soft_lower_limit: text("soft_lower_limit"),
                    soft_upper_limit: text("soft_upper_limit"),
                    k_position: text("k_position"),
                    k_velocity: text("k_velocity"),
                })
            }),
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
        JointType::of(self.kind.as_ref()?.name()?)
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
        let text = self.axis.as_ref().and_then(|axis| axis.xyz.as_ref());
        text.map_or(Some([1.0, 0.0, 0.0]), Text::numbers)
    }
}
