//! Semantic descriptions (SRDF): groups, states, end effectors and collision pairs, taken from the expanded document.

use super::ProjectNameKind;
use expand::{Expansion, XId, XTree};
use model::AttrValue;

/// What an SRDF says; everything in document order.
#[derive(Clone, Debug)]
pub struct Srdf {
    /// The root element.
    pub element: XId,
    /// The name of the robot it is for.
    pub name: Option<AttrValue>,
    /// Its planning groups.
    pub groups: Vec<PlanningGroup>,
    /// Its named states of groups.
    pub states: Vec<GroupState>,
    /// Its end effectors.
    pub effectors: Vec<EndEffector>,
    /// Its virtual joints.
    pub virtual_joints: Vec<VirtualJoint>,
    /// The joints that nothing drives.
    pub passive: Vec<AttrValue>,
    /// The pairs of links whose collisions are not checked.
    pub disabled: Vec<CollisionPair>,
    /// The links that collide with nothing but what pairs enable.
    pub default_disabled: Vec<AttrValue>,
    /// Other names of links and joints, with what they name.
    others: Vec<(AttrValue, ProjectNameKind)>,
}

/// A `group`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct PlanningGroup {
    pub element: XId,
    pub name: Option<AttrValue>,
    pub links: Vec<AttrValue>,
    pub joints: Vec<AttrValue>,
    pub chains: Vec<Chain>,
    pub subgroups: Vec<AttrValue>,
}

/// A `chain`: the joints from one link down to another.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Chain {
    pub element: XId,
    pub base: Option<AttrValue>,
    pub tip: Option<AttrValue>,
}

/// A `group_state`: positions of the joints of a group, radians or meters.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct GroupState {
    pub element: XId,
    pub name: Option<AttrValue>,
    pub group: Option<AttrValue>,
    /// Names and values.
    pub joints: Vec<(AttrValue, Option<AttrValue>)>,
}

/// An `end_effector`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct EndEffector {
    pub element: XId,
    pub name: Option<AttrValue>,
    pub parent_link: Option<AttrValue>,
    pub group: Option<AttrValue>,
    pub parent_group: Option<AttrValue>,
}

/// A `virtual_joint` between the world and the robot.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct VirtualJoint {
    pub element: XId,
    pub name: Option<AttrValue>,
    pub child_link: Option<AttrValue>,
}

/// A `disable_collisions`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct CollisionPair {
    pub element: XId,
    pub link1: Option<AttrValue>,
    pub link2: Option<AttrValue>,
    pub reason: Option<AttrValue>,
}

impl Srdf {
    /// The SRDF of an expansion; none when the root element is something else.
    pub fn of(expansion: &Expansion) -> Option<Self> {
        let tree = &expansion.tree;
        let element = tree.root().filter(|&root| tree.get(root).text == "robot")?;
        let mut srdf = Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            groups: Vec::new(),
            states: Vec::new(),
            effectors: Vec::new(),
            virtual_joints: Vec::new(),
            passive: Vec::new(),
            disabled: Vec::new(),
            default_disabled: Vec::new(),
            others: Vec::new(),
        };
        tree.elements(element)
            .for_each(|child| srdf.add(tree, child));
        Some(srdf)
    }

    fn add(&mut self, tree: &XTree, element: XId) {
        let text = |name: &str| AttrValue::attr(tree, element, name);
        match tree.get(element).text.as_str() {
            "group" => self.groups.push(PlanningGroup::of(tree, element)),
            "group_state" => self.states.push(GroupState::of(tree, element)),
            "end_effector" => self.effectors.push(EndEffector {
                element,
                name: text("name"),
                parent_link: text("parent_link"),
                group: text("group"),
                parent_group: text("parent_group"),
            }),
            "virtual_joint" => self.virtual_joints.push(VirtualJoint {
                element,
                name: text("name"),
                child_link: text("child_link"),
            }),
            "passive_joint" => self.passive.extend(text("name")),
            "disable_collisions" => self.disabled.push(CollisionPair::of(tree, element)),
            "disable_default_collisions" => self.default_disabled.extend(text("link")),
            "enable_collisions" => {
                let links = ["link1", "link2"].map(text);
                self.others.extend(
                    links
                        .into_iter()
                        .flatten()
                        .map(|link| (link, ProjectNameKind::Link)),
                );
            }
            "link_sphere_approximation" => self
                .others
                .extend(text("link").map(|link| (link, ProjectNameKind::Link))),
            "joint_property" => self
                .others
                .extend(text("joint_name").map(|joint| (joint, ProjectNameKind::Joint))),
            _ => {}
        }
    }

    /// Every name of a link, joint or group, with whether it is given here.
    pub fn names(&self) -> Vec<(&AttrValue, ProjectNameKind, bool)> {
        use ProjectNameKind::{Group, Joint, Link};
        let mut found: Vec<(&AttrValue, ProjectNameKind, bool)> = Vec::new();
        for group in &self.groups {
            found.extend(group.name.iter().map(|name| (name, Group, true)));
            found.extend(group.links.iter().map(|name| (name, Link, false)));
            found.extend(group.joints.iter().map(|name| (name, Joint, false)));
            found.extend(group.subgroups.iter().map(|name| (name, Group, false)));
            let ends = group
                .chains
                .iter()
                .flat_map(|chain| [&chain.base, &chain.tip]);
            found.extend(ends.flatten().map(|name| (name, Link, false)));
        }
        for state in &self.states {
            found.extend(state.group.iter().map(|name| (name, Group, false)));
            found.extend(state.joints.iter().map(|(name, _)| (name, Joint, false)));
        }
        for effector in &self.effectors {
            found.extend(effector.parent_link.iter().map(|name| (name, Link, false)));
            let groups = effector.group.iter().chain(&effector.parent_group);
            found.extend(groups.map(|name| (name, Group, false)));
        }
        for joint in &self.virtual_joints {
            found.extend(joint.name.iter().map(|name| (name, Joint, true)));
            found.extend(joint.child_link.iter().map(|name| (name, Link, false)));
        }
        found.extend(self.passive.iter().map(|name| (name, Joint, false)));
        let pairs = self
            .disabled
            .iter()
            .flat_map(|pair| [&pair.link1, &pair.link2])
            .flatten();
        found.extend(
            pairs
                .chain(&self.default_disabled)
                .map(|name| (name, Link, false)),
        );
        found.extend(self.others.iter().map(|(name, kind)| (name, *kind, false)));
        found
    }

    /// The first group of a name.
    pub fn group(&self, name: &str) -> Option<&PlanningGroup> {
        self.groups
            .iter()
            .find(|group| group.name.as_ref().is_some_and(|own| own.value == name))
    }
}

impl PlanningGroup {
    fn of(tree: &XTree, element: XId) -> Self {
        let chains = tree
            .elements(element)
            .filter(|&child| tree.get(child).text == "chain");
        let chain = |element| Chain {
            element,
            base: AttrValue::attr(tree, element, "base_link"),
            tip: AttrValue::attr(tree, element, "tip_link"),
        };
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            links: names(tree, element, "link"),
            joints: names(tree, element, "joint"),
            chains: chains.map(chain).collect(),
            subgroups: names(tree, element, "group"),
        }
    }
}

/// The names of the elements of a kind in another one.
fn names(tree: &XTree, element: XId, tag: &str) -> Vec<AttrValue> {
    tree.elements(element)
        .filter(|&child| tree.get(child).text == tag)
        .filter_map(|child| AttrValue::attr(tree, child, "name"))
        .collect()
}

impl GroupState {
    fn of(tree: &XTree, element: XId) -> Self {
        let joints = tree
            .elements(element)
            .filter(|&child| tree.get(child).text == "joint");
        let joint = |child| {
            Some((
                AttrValue::attr(tree, child, "name")?,
                AttrValue::attr(tree, child, "value"),
            ))
        };
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            group: AttrValue::attr(tree, element, "group"),
            joints: joints.filter_map(joint).collect(),
        }
    }
}

impl CollisionPair {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            link1: AttrValue::attr(tree, element, "link1"),
            link2: AttrValue::attr(tree, element, "link2"),
            reason: AttrValue::attr(tree, element, "reason"),
        }
    }

    /// Both links, when they are known; the lesser name first.
    pub fn links(&self) -> Option<(&str, &str)> {
        let (one, two) = (
            self.link1.as_ref()?.name()?.as_str(),
            self.link2.as_ref()?.name()?.as_str(),
        );
        Some((one.min(two), one.max(two)))
    }
}
