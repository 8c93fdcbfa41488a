//! What rests on names alone: how links hang together, and which names are unusual. An edit of a number changes none of it, so
//! the robot after it shares this with the one before.
use ecow::EcoString;

use super::attr_value::AttrValue;
use super::ends::Ends;
use super::joint::Joint;
use super::kinematics::Kinematics;
use super::link::Link;
use super::robot::Robot;
use super::shared_list::SharedList;
use base::FastSet;

/// What the names of links and joints and the ends of joints say together.
#[derive(Debug)]
pub struct Naming {
    /// How the links hang together.
    pub kinematics: Kinematics,
    /// The cycles in it: see [`Kinematics::cycles`].
    pub cycles: Vec<Vec<usize>>,
    /// What the names may hold.
    pub marks: NameMarks,
    /// Whether a name or an end is not known for sure.
    pub has_doubtful: bool,
    /// Whether two links have one name.
    pub has_repeated_link: bool,
    /// Whether two joints have one name.
    pub has_repeated_joint: bool,
    /// Whether a joint has the name of a link.
    pub has_shared_name: bool,
    /// Whether a joint names one link as both of its ends.
    pub has_loop: bool,
    /// The first in the order of letters of the names that joints have for their parents and no link has.
    pub missing_parent: Option<EcoString>,
    /// Which joints end where.
    pub(super) ends: Ends,
}

/// What names and ends may hold. What is said not to be there is not there; where it is, nobody knows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NameMarks {
    /// A capital letter, or one that is not English.
    pub capital: bool,
    /// A character that is no English letter, no digit, and none of `_`, `.`, `/` and `-`.
    pub unusual: bool,
    /// A slash at the beginning.
    pub slash: bool,
    /// Two underscores at the beginning.
    pub underscores: bool,
    /// Nothing.
    pub empty: bool,
}

impl Naming {
    pub(super) fn of(robot: &Robot) -> Self {
        let kinematics = Kinematics::of(robot);
        let mut joints = FastSet::default();
        let (mut has_repeated_joint, mut has_shared_name) = (false, false);
        for joint in &robot.joints {
            if let Some(name) = joint.name.as_ref().and_then(AttrValue::name) {
                has_repeated_joint |= !joints.insert(name);
                has_shared_name |= kinematics.link(name).is_some();
            }
        }
        let is_loop = |joint: &Joint| {
            let ends = joint.parent.as_ref().zip(joint.child.as_ref());
            ends.is_some_and(|(parent, child)| parent.value == child.value)
        };
        let mut marks = NameMarks::default();
        all(robot).for_each(|name| marks.note(&name.value));
        Self {
            cycles: kinematics.cycles(),
            marks,
            has_doubtful: all(robot).any(AttrValue::is_doubtful),
            has_repeated_link: kinematics.has_repeated_link(robot),
            has_repeated_joint,
            has_shared_name,
            has_loop: robot.joints.iter().any(is_loop),
            missing_parent: missing_parent(robot, &kinematics),
            ends: Ends::of(robot),
            kinematics,
        }
    }
}

impl NameMarks {
    fn note(&mut self, name: &str) {
        let is_usual =
            |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b'/' | b'-');
        let is_capital = |byte: u8| byte.is_ascii_uppercase() || !byte.is_ascii();
        self.capital |= name.bytes().any(is_capital);
        self.unusual |= !name.bytes().all(is_usual);
        self.slash |= name.starts_with('/');
        self.underscores |= name.starts_with("__");
        self.empty |= name.is_empty();
    }
}

fn missing_parent(robot: &Robot, kinematics: &Kinematics) -> Option<EcoString> {
    let parents = robot.joints.iter();
    let parents = parents.filter_map(|joint| joint.parent.as_ref()?.name());
    let missing = parents.filter(|parent| kinematics.link(parent).is_none());
    missing.min().cloned()
}

/// The names of links and joints, and the ends of joints.
pub(super) fn all(robot: &Robot) -> impl Iterator<Item = &AttrValue> {
    let of_links = robot.links.iter().filter_map(|link| link.name.as_ref());
    let of_joints = robot.joints.iter().flat_map(names_of).flatten();
    of_links.chain(of_joints)
}

fn names_of(joint: &Joint) -> [Option<&AttrValue>; 3] {
    [&joint.name, &joint.parent, &joint.child].map(Option::as_ref)
}

/// Whether two robots have the same names at the same places. Links and joints that they share are not looked at.
pub(super) fn are_same(one: &Robot, other: &Robot) -> bool {
    let link = |one: &Link, other: &Link| is_same(one.name.as_ref(), other.name.as_ref());
    let joint = |one: &Joint, other: &Joint| {
        let mut names = names_of(one).into_iter().zip(names_of(other));
        names.all(|(one, other)| is_same(one, other))
    };
    SharedList::are_alike(&one.links, &other.links, link)
        && SharedList::are_alike(&one.joints, &other.joints, joint)
}

fn is_same(one: Option<&AttrValue>, other: Option<&AttrValue>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => {
            one.value == other.value
                && one.is_known() == other.is_known()
                && one.is_literal() == other.is_literal()
        }
        (one, other) => one.is_none() && other.is_none(),
    }
}
