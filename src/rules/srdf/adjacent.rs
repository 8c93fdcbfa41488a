//! Which links are adjacent: those that a joint connects, or that only links without collision geometry are between.
//! Source: `computeConnectionGraph` of the MoveIt setup assistant.
use super::super::beside::PairedRobot;
use super::super::context::DocumentCx;
use super::super::geometry::extent_of;
use base::FastSet;
use model::{AttrValue, Bounds, Joint, JointType, Robot, transform};

/// Links without geometry that are looked through, one behind the other.
const MOST_STEPS: usize = 64;

/// Whether two links are adjacent; none when one of them is not there.
pub(super) fn are_adjacent(paired: &PairedRobot<'_>, one: &str, two: &str) -> Option<bool> {
    let (one, two) = (paired.kinematics.link(one)?, paired.kinematics.link(two)?);
    let mut seen: FastSet<usize> = FastSet::from_iter([one]);
    let mut open = vec![one];
    for _ in 0..MOST_STEPS {
        let mut next = Vec::new();
        for link in open {
            for neighbor in neighbors(paired, link) {
                if neighbor == two {
                    return Some(true);
                }
                if seen.insert(neighbor) && !has_body(paired, neighbor) {
                    next.push(neighbor);
                }
            }
        }
        if next.is_empty() {
            return Some(false);
        }
        open = next;
    }
    None
}

fn neighbors(paired: &PairedRobot<'_>, link: usize) -> impl Iterator<Item = usize> {
    let kinematics = paired.kinematics;
    let up = kinematics
        .parent_joints(link)
        .iter()
        .filter_map(|&joint| Some(kinematics.ends(joint)?.0));
    let down = kinematics
        .child_joints(link)
        .iter()
        .filter_map(|&joint| Some(kinematics.ends(joint)?.1));
    up.chain(down).collect::<Vec<_>>().into_iter()
}

fn has_body(paired: &PairedRobot<'_>, link: usize) -> bool {
    paired
        .robot
        .links
        .get(link)
        .is_some_and(|link| !link.collisions.is_empty())
}

/// The joints between two links that both have collision geometry, with these links, the lesser name first.
pub(super) fn touching<'a>(paired: &PairedRobot<'a>) -> Vec<(&'a Joint, (&'a str, &'a str))> {
    let robot = paired.robot;
    let pair = |(number, joint): (usize, &'a Joint)| {
        let (parent, child) = paired.kinematics.ends(number)?;
        let (one, two) = (colliding(robot, parent)?, colliding(robot, child)?);
        Some((joint, (one.min(two), one.max(two))))
    };
    let joints = robot.joints.iter().enumerate();
    joints.filter_map(pair).collect()
}

/// Whether a fixed joint keeps the collision geometry of its links apart: there is a gap between the boxes around it.
pub(super) fn are_apart(shapes: &DocumentCx<'_>, paired: &PairedRobot<'_>, joint: &Joint) -> bool {
    let bounds = |end: &Option<AttrValue>| {
        let link = paired.kinematics.link(end.as_ref()?.name()?)?;
        extent_of(shapes, &paired.robot.links.get(link)?.collisions).bounds()
    };
    let boxes = || {
        let child = bounds(&joint.child)?;
        let place = transform(joint.origin.as_ref())?;
        Some((bounds(&joint.parent)?, child.moved(&place)))
    };
    let is_gap = |(one, two): (Bounds, Bounds)| {
        let lengths = |bounds: Bounds| bounds.min.into_iter().zip(bounds.max);
        lengths(one)
            .zip(lengths(two))
            .any(|((min, max), (from, to))| max < from || to < min)
    };
    joint.is(&[JointType::Fixed]) && boxes().is_some_and(is_gap)
}

/// The name of a link that has collision geometry.
fn colliding(robot: &Robot, index: usize) -> Option<&str> {
    let link = robot.links.get(index)?;
    let name = link.name.as_ref().filter(|_| !link.collisions.is_empty())?;
    Some(name.name()?.as_str())
}
