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
    /// Elements of steps that were taken over and stand at the same place, in document order.
    same: Vec<Range<XId>>,
    /// How many of these, of the links and of the joints lie behind the reader.
    passed: usize,
    links: usize,
    joints: usize,
}

impl<'a> Kept<'a> {
    /// None when what an element says depends on something that is different.
    pub(super) fn of(now: &Expansion, before: &Expansion, robot: &'a Robot) -> Option<Self> {
        if Version::of(&now.tree) != Version::of(&before.tree) {
            return None;
        }
        let mut old = before.steps().peekable();
        let same = now.steps().filter_map(|(step, elements)| {
            while old
                .next_if(|(_, others)| others.start < elements.start)
                .is_some()
            {}
            old.peek()
                .is_some_and(|(other, others)| *other == step && *others == elements)
                .then_some(elements)
        });
        Some(Self {
            robot,
            same: same.collect(),
            passed: 0,
            links: 0,
            joints: 0,
        })
    }

    /// Whether an element is the same as before; asked in document order.
    fn covers(&mut self, element: XId) -> bool {
        let rest = self.same.get(self.passed..).unwrap_or_default();
        self.passed += rest.iter().take_while(|same| same.end <= element).count();
        let next = self.same.get(self.passed);
        next.is_some_and(|same| same.contains(&element))
    }

    /// The link of an element that is the same.
    pub(super) fn link(&mut self, element: XId) -> Option<Arc<Link>> {
        if !self.covers(element) {
            return None;
        }
        let links = &self.robot.links;
        while links.get(self.links)?.element < element {
            self.links += 1;
        }
        let link = links.shared(self.links)?;
        (link.element == element).then(|| Arc::clone(link))
    }

    /// The joint of an element that is the same.
    pub(super) fn joint(&mut self, element: XId) -> Option<Arc<Joint>> {
        if !self.covers(element) {
            return None;
        }
        let joints = &self.robot.joints;
        while joints.get(self.joints)?.element < element {
            self.joints += 1;
        }
        let joint = joints.shared(self.joints)?;
        (joint.element == element).then(|| Arc::clone(joint))
    }
}
