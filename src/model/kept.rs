//! What the robot of an expansion may share with that of the expansion before.
use std::ops::Range;
use std::sync::Arc;

use super::joint::Joint;
use super::link::Link;
use super::robot::Robot;
use super::version::Version;
use expand::{Expansion, XId};

/// The robot of the expansion before, and the elements that are the same in both.
pub(super) struct Kept<'a> {
    robot: &'a Robot,
    /// Elements that were not evaluated again, in document order.
    left_out: Vec<Range<XId>>,
    /// Elements of steps that were taken over and stand at the same place, in document order.
    same: Vec<Range<XId>>,
}

impl<'a> Kept<'a> {
    /// None when what an element says depends on something that is different.
    pub(super) fn of(now: &Expansion, before: &Expansion, robot: &'a Robot) -> Option<Self> {
        if Version::of(&now.tree) != Version::of(&before.tree) {
            return None;
        }
        let left_out = now.tree.same_in(&before.tree);
        let is_left_out = |elements: &Range<XId>| {
            let behind = left_out.partition_point(|range| range.end <= elements.start);
            left_out
                .get(behind)
                .is_some_and(|range| range.contains(&elements.start))
        };
        let mut old = before.steps().peekable();
        let steps = now.steps().filter(|(_, elements)| !is_left_out(elements));
        let same = steps.filter_map(|(step, elements)| {
            while old
                .next_if(|(_, others)| others.start < elements.start)
                .is_some()
            {}
            old.peek()
                .is_some_and(|(other, others)| *other == step && *others == elements)
                .then_some(elements)
        });
        let same = same.collect();
        Some(Self {
            robot,
            left_out,
            same,
        })
    }

    /// Add to a robot what begins at a child of the root element and was not evaluated again; what lies behind it.
    pub(super) fn add_to(&self, robot: &mut Robot, child: XId) -> Option<XId> {
        let range = self.left_out.iter().find(|range| range.start == child)?;
        let old = self.robot;
        robot
            .links
            .add_range(&old.links, range, |link| link.element);
        robot
            .joints
            .add_range(&old.joints, range, |joint| joint.element);
        add_range(&mut robot.materials, &old.materials, range, |one| {
            one.element
        });
        add_range(&mut robot.gazebo, &old.gazebo, range, |one| one.element);
        add_range(&mut robot.controls, &old.controls, range, |one| one.element);
        let transmissions = &old.transmissions;
        add_range(&mut robot.transmissions, transmissions, range, |one| {
            one.element
        });
        Some(range.end)
    }

    /// Whether an element is the same as before.
    fn covers(&self, element: XId) -> bool {
        let passed = self.same.partition_point(|same| same.end <= element);
        let next = self.same.get(passed);
        next.is_some_and(|same| same.contains(&element))
    }

    /// The link of an element that is the same.
    pub(super) fn link(&self, element: XId) -> Option<Arc<Link>> {
        let links = self.covers(element).then_some(&self.robot.links)?;
        let link = links.shared(links.position(&element, |link| link.element))?;
        (link.element == element).then(|| Arc::clone(link))
    }

    /// The joint of an element that is the same.
    pub(super) fn joint(&self, element: XId) -> Option<Arc<Joint>> {
        let joints = self.covers(element).then_some(&self.robot.joints)?;
        let joint = joints.shared(joints.position(&element, |joint| joint.element))?;
        (joint.element == element).then(|| Arc::clone(joint))
    }
}

/// Add the elements of another list that lie in a range.
fn add_range<T: Clone>(
    list: &mut Vec<T>,
    other: &[T],
    range: &Range<XId>,
    element: impl Fn(&T) -> XId,
) {
    let start = other.partition_point(|one| element(one) < range.start);
    let end = other.partition_point(|one| element(one) < range.end);
    list.extend_from_slice(other.get(start..end).unwrap_or_default());
}
