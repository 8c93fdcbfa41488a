//! The robot of an expanded document.
use std::sync::{Arc, OnceLock};

use super::attr_value::AttrValue;
use super::blocks::{Gazebo, Ros2Control, Transmission};
use super::joint::{Joint, JointType};
use super::kept::Kept;
use super::kinematics::Kinematics;
use super::link::{Link, Material};
use super::naming::{self, Naming};
use super::shared_list::SharedList;
use expand::{Expansion, XId, XKind, XTree};

/// What an expanded document says about a robot; everything in document order.
#[derive(Clone, Debug)]
pub struct Robot {
    /// The root element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// Its links.
    pub links: SharedList<Link>,
    /// Its joints.
    pub joints: SharedList<Joint>,
    /// The materials that are children of the root.
    pub materials: Vec<Material>,
    /// Its `gazebo` elements.
    pub gazebo: Vec<Gazebo>,
    /// Its `ros2_control` elements.
    pub controls: Vec<Ros2Control>,
    /// Its `transmission` elements.
    pub transmissions: Vec<Transmission>,
    /// Shared with the robot before as long as no name is different.
    naming: Arc<OnceLock<Naming>>,
}

/// The names of links and joints and the ends of joints. Those of a robot after an edit are equal as long as no name is different:
/// an index of one list means the same link or joint then.
#[derive(Clone, Debug)]
pub struct SharedNames(Arc<OnceLock<Naming>>);

impl PartialEq for SharedNames {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Robot {
    /// The robot of an expansion; none when the root element is something else.
    pub fn of(expansion: &Expansion) -> Option<Self> {
        Self::again(expansion, None)
    }

    /// The same after an edit: links and joints are shared with the robot of the expansion `before` where that was taken over.
    pub fn again(expansion: &Expansion, before: Option<(&Expansion, &Self)>) -> Option<Self> {
        let tree = &expansion.tree;
        let element = tree.root().filter(|&root| tree.get(root).text == "robot")?;
        let kept = before.and_then(|(before, robot)| Kept::of(expansion, before, robot));
        let mut robot = Self::read(tree, element, kept);
        let old = before.map(|(_, old)| old);
        if let Some(old) = old.filter(|old| naming::are_same(&robot, old)) {
            robot.naming = Arc::clone(&old.naming);
        }
        Some(robot)
    }

    /// The parts of a robot among the children of `element`.
    pub fn below(tree: &XTree, element: XId) -> Self {
        Self::read(tree, element, None)
    }

    fn read(tree: &XTree, element: XId, kept: Option<Kept<'_>>) -> Self {
        let mut robot = Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            links: SharedList::default(),
            joints: SharedList::default(),
            materials: Vec::new(),
            gazebo: Vec::new(),
            controls: Vec::new(),
            transmissions: Vec::new(),
            naming: Arc::default(),
        };
        let mut next = tree.first_child(element);
        while let Some(child) = next {
            let left_out = kept
                .as_ref()
                .and_then(|kept| kept.add_to(&mut robot, child));
            if let Some(end) = left_out {
                next = tree.child_at(end, element);
                continue;
            }
            next = tree.next_sibling(child);
            if tree.get(child).kind != XKind::Element {
                continue;
            }
            match tree.get(child).text.as_str() {
                "link" => {
                    let same = kept.as_ref().and_then(|kept| kept.link(child));
                    let link = same.unwrap_or_else(|| Arc::new(Link::of(tree, child)));
                    robot.links.push(link);
                }
                "joint" => {
                    let same = kept.as_ref().and_then(|kept| kept.joint(child));
                    let joint = same.unwrap_or_else(|| Arc::new(Joint::of(tree, child)));
                    robot.joints.push(joint);
                }
                "material" => robot.materials.push(Material::of(tree, child)),
                "gazebo" => robot.gazebo.push(Gazebo::of(tree, child)),
                "ros2_control" => robot.controls.push(Ros2Control::of(tree, child)),
                "transmission" => robot.transmissions.push(Transmission::of(tree, child)),
                _ => {}
            }
        }
        robot.links.finish();
        robot.joints.finish();
        robot
    }

    /// How its links hang together; worked out once.
    pub fn kinematics(&self) -> &Kinematics {
        &self.naming().kinematics
    }

    /// What the names of its links and joints say; worked out once.
    pub fn naming(&self) -> &Naming {
        self.naming.get_or_init(|| Naming::of(self))
    }

    /// What tells whether another robot has the same names.
    pub fn shared_names(&self) -> SharedNames {
        SharedNames(Arc::clone(&self.naming))
    }

    /// The links of a name, in document order; a link without one has the empty name.
    pub fn links_named(&self, name: &str) -> impl Iterator<Item = &Link> + Clone {
        let links = self.naming().ends.links.named(name);
        links.filter_map(|index| self.links.get(index))
    }

    /// The joints whose child is a link of this name, in document order.
    pub fn joints_above(&self, link: &str) -> impl Iterator<Item = &Joint> + Clone {
        let joints = self.naming().ends.above.named(link);
        joints.filter_map(|index| self.joints.get(index))
    }

    /// The joints whose parent is a link of this name, in document order.
    pub fn joints_below(&self, link: &str) -> impl Iterator<Item = &Joint> + Clone {
        let joints = self.naming().ends.below.named(link);
        joints.filter_map(|index| self.joints.get(index))
    }

    /// Whether the document stands on its own: a robot with a name and a link.
    pub fn is_entry(&self) -> bool {
        !self.links.is_empty()
            && self
                .name
                .as_ref()
                .is_some_and(|name| !name.value.is_empty())
    }

    /// Whether a name is all that it needs to stand on its own.
    pub fn lacks_only_a_name(&self) -> bool {
        !self.links.is_empty() && self.name.as_ref().is_none_or(|name| name.value.is_empty())
    }

    /// The first joint of a name.
    pub fn joint(&self, name: &str) -> Option<&Joint> {
        let joint = self.naming().ends.joints.named(name).next()?;
        self.joints.get(joint)
    }

    /// The first link of a name.
    pub fn link(&self, name: &str) -> Option<&Link> {
        self.links_named(name).find(|link| link.name.is_some())
    }

    /// Whether no joint moves: an object or a part, as opposed to a mechanism.
    pub fn is_rigid(&self) -> bool {
        self.joints
            .iter()
            .all(|joint| joint.is(&[JointType::Fixed]))
    }

    /// Whether all names of links and joints and all ends of joints are known.
    pub fn names_are_known(&self) -> bool {
        !self.naming().has_doubtful
    }

    /// The names of links and joints and the ends of joints that are not known for sure.
    pub fn doubtful_names(&self) -> impl Iterator<Item = &AttrValue> {
        naming::all(self).filter(|text| text.is_doubtful())
    }
}
