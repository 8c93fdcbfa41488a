//! Semantic descriptions (SRDF): groups, states, end effectors and collision pairs, taken from the expanded document.

use super::Kind;
use expand::{Expansion, XId, XTree};
use model::Text;

/// What an SRDF says; everything in document order.
#[derive(Clone, Debug)]
pub struct Srdf {
    /// The root element.
    pub element: XId,
    /// The name of the robot it is for.
    pub name: Option<Text>,
    /// Its planning groups.
    pub groups: Vec<Group>,
    /// Its named states of groups.
    pub states: Vec<GroupState>,
    /// Its end effectors.
    pub effectors: Vec<EndEffector>,
    /// Its virtual joints.
    pub virtual_joints: Vec<VirtualJoint>,
    /// The joints that nothing drives.
    pub passive: Vec<Text>,
    /// The pairs of links whose collisions are not checked.
    pub disabled: Vec<Pair>,
    /// The links that collide with nothing but what pairs enable.
    pub default_disabled: Vec<Text>,
    /// Other names of links and joints, with what they name.
    others: Vec<(Text, Kind)>,
}

/// A `group`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Group {
    pub element: XId,
    pub name: Option<Text>,
    pub links: Vec<Text>,
    pub joints: Vec<Text>,
    pub chains: Vec<Chain>,
    pub subgroups: Vec<Text>,
}

/// A `chain`: the joints from one link down to another.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Chain {
    pub element: XId,
    pub base: Option<Text>,
    pub tip: Option<Text>,
}

/// A `group_state`: positions of the joints of a group, radians or meters.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct GroupState {
    pub element: XId,
    pub name: Option<Text>,
    pub group: Option<Text>,
    /// Names and values.
    pub joints: Vec<(Text, Option<Text>)>,
}

/// An `end_effector`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct EndEffector {
    pub element: XId,
    pub name: Option<Text>,
    pub parent_link: Option<Text>,
    pub group: Option<Text>,
    pub parent_group: Option<Text>,
}

/// A `virtual_joint` between the world and the robot.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct VirtualJoint {
    pub element: XId,
    pub name: Option<Text>,
    pub child_link: Option<Text>,
}

/// A `disable_collisions`.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Pair {
    pub element: XId,
    pub link1: Option<Text>,
    pub link2: Option<Text>,
    pub reason: Option<Text>,
}

impl Srdf {
    /// The SRDF of an expansion; none when the root element is something else.
    pub fn of(expansion: &Expansion) -> Option<Self> {
        let tree = &expansion.tree;
        let element = tree.root().filter(|&root| tree.get(root).text == "robot")?;
        let mut srdf = Self {
            element,
            name: Text::attr(tree, element, "name"),
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
        let text = |name: &str| Text::attr(tree, element, name);
        match tree.get(element).text.as_str() {
            "group" => self.groups.push(Group::of(tree, element)),
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
            "disable_collisions" => self.disabled.push(Pair::of(tree, element)),
            "disable_default_collisions" => self.default_disabled.extend(text("link")),
            "enable_collisions" => {
                let links = ["link1", "link2"].map(text);
                self.others
                    .extend(links.into_iter().flatten().map(|link| (link, Kind::Link)));
            }
            "link_sphere_approximation" => self
                .others
                .extend(text("link").map(|link| (link, Kind::Link))),
            "joint_property" => self
                .others
                .extend(text("joint_name").map(|joint| (joint, Kind::Joint))),
            _ => {}
        }
    }

    /// Every name of a link, joint or group, with whether it is given here.
    pub fn names(&self) -> Vec<(&Text, Kind, bool)> {
        use Kind::{Group, Joint, Link};
        let mut found: Vec<(&Text, Kind, bool)> = Vec::new();
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
    pub fn group(&self, name: &str) -> Option<&Group> {
        self.groups
            .iter()
            .find(|group| group.name.as_ref().is_some_and(|own| own.value == name))
    }
}

impl Group {
    fn of(tree: &XTree, element: XId) -> Self {
        let chains = tree
            .elements(element)
            .filter(|&child| tree.get(child).text == "chain");
        let chain = |element| Chain {
            element,
            base: Text::attr(tree, element, "base_link"),
            tip: Text::attr(tree, element, "tip_link"),
        };
        Self {
            element,
            name: Text::attr(tree, element, "name"),
            links: names(tree, element, "link"),
            joints: names(tree, element, "joint"),
            chains: chains.map(chain).collect(),
            subgroups: names(tree, element, "group"),
        }
    }
}

/// The names of the elements of a kind in another one.
fn names(tree: &XTree, element: XId, tag: &str) -> Vec<Text> {
    tree.elements(element)
        .filter(|&child| tree.get(child).text == tag)
        .filter_map(|child| Text::attr(tree, child, "name"))
        .collect()
}

impl GroupState {
    fn of(tree: &XTree, element: XId) -> Self {
        let joints = tree
            .elements(element)
            .filter(|&child| tree.get(child).text == "joint");
        let joint = |child| {
            Some((
                Text::attr(tree, child, "name")?,
                Text::attr(tree, child, "value"),
            ))
        };
        Self {
            element,
            name: Text::attr(tree, element, "name"),
            group: Text::attr(tree, element, "group"),
            joints: joints.filter_map(joint).collect(),
        }
    }
}

impl Pair {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            link1: Text::attr(tree, element, "link1"),
            link2: Text::attr(tree, element, "link2"),
            reason: Text::attr(tree, element, "reason"),
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
