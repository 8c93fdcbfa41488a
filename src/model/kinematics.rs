//! How links hang together: the graph that joints make.

use ecow::EcoString;

use super::link::Link;
use super::robot::Robot;
use base::{FastMap, FastSet};

/// Links by name, and the joints between them.
///
/// Of several links of one name, the first counts. Joints with an end that is unknown or names no link
/// take no part.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// Index into [`Robot::links`] by name.
    links: FastMap<EcoString, usize>,
    /// For each link, whether it is the one that counts of its name.
    counts: Vec<bool>,
    /// For each link, the joints whose parent it is: indices into [`Robot::joints`], ordered by joint name.
    child_joints: Vec<Vec<usize>>,
    /// For each link, the joints whose child it is, in document order.
    parent_joints: Vec<Vec<usize>>,
    /// For each joint, the links it joins.
    ends: Vec<Option<(usize, usize)>>,
}

impl Kinematics {
    /// The graph of a robot.
    pub fn of(robot: &Robot) -> Self {
        let mut links = FastMap::default();
        links.reserve(robot.links.len());
        let mut counts = vec![false; robot.links.len()];
        for ((i, link), counts) in robot.links.iter().enumerate().zip(&mut counts) {
            if let Some(name) = link.name.as_ref().and_then(|name| name.name()) {
                *counts = *links.entry(name.clone()).or_insert(i) == i;
            }
        }
        let mut child_joints = vec![Vec::new(); robot.links.len()];
        let mut parent_joints = vec![Vec::new(); robot.links.len()];
        let mut ends = Vec::with_capacity(robot.joints.len());
        for (i, joint) in robot.joints.iter().enumerate() {
            let pair = joint
                .ends()
                .and_then(|(parent, child)| Some((*links.get(parent)?, *links.get(child)?)));
            if let Some((parent, child)) = pair {
                child_joints
                    .get_mut(parent)
                    .into_iter()
                    .for_each(|joints| joints.push(i));
                parent_joints
                    .get_mut(child)
                    .into_iter()
                    .for_each(|joints| joints.push(i));
            }
            ends.push(pair);
        }
        // urdfdom keeps joints in a map by name and hangs children up in its order
        for joints in child_joints.iter_mut().filter(|joints| joints.len() > 1) {
            joints.sort_by_key(|&joint: &usize| {
                robot
                    .joints
                    .get(joint)
                    .map(|joint| joint.shown().to_owned())
            });
        }
        Self {
            links,
            counts,
            child_joints,
            parent_joints,
            ends,
        }
    }

    /// Whether a link has the name of an earlier one.
    pub(super) fn has_repeated_link(&self, robot: &Robot) -> bool {
        let is_named = |link: &Link| link.name.as_ref().and_then(|name| name.name()).is_some();
        let mut links = robot.links.iter().zip(&self.counts);
        links.any(|(link, counts)| !counts && is_named(link))
    }

    /// The link of a name.
    pub fn link(&self, name: &str) -> Option<usize> {
        self.links.get(name).copied()
    }

    /// Parent and child link of a joint, when both exist.
    pub fn ends(&self, joint: usize) -> Option<(usize, usize)> {
        self.ends.get(joint).copied().flatten()
    }

    /// The joints whose parent is `link`, ordered by name as urdfdom does.
    pub fn child_joints(&self, link: usize) -> &[usize] {
        self.child_joints.get(link).map_or(&[], Vec::as_slice)
    }

    /// The joints whose child is `link`, in document order.
    pub fn parent_joints(&self, link: usize) -> &[usize] {
        self.parent_joints.get(link).map_or(&[], Vec::as_slice)
    }

    /// The joints above a link, the nearest first; of several parents the first counts. A circle ends it.
    pub fn ancestor_joints(&self, link: usize) -> impl Iterator<Item = usize> + '_ {
        let next = move |&joint: &usize| self.first_parent_joint(self.ends(joint)?.0);
        std::iter::successors(self.first_parent_joint(link), next).take(self.child_joints.len())
    }

    /// The first joint whose child is `link`.
    fn first_parent_joint(&self, link: usize) -> Option<usize> {
        self.parent_joints(link).first().copied()
    }

    /// The joints between two links, those above `from` first; none when they hang on nothing in common.
    pub fn path(&self, from: usize, to: usize) -> Option<Vec<usize>> {
        let from_root: Vec<usize> = self
            .ancestor_joints(from)
            .collect::<Vec<_>>()
            .into_iter()
            .rev()
            .collect();
        let to_root: Vec<usize> = self
            .ancestor_joints(to)
            .collect::<Vec<_>>()
            .into_iter()
            .rev()
            .collect();
        if self.way_start(from, &from_root)? != self.way_start(to, &to_root)? {
            return None;
        }
        let common = from_root
            .iter()
            .zip(&to_root)
            .take_while(|(a, b)| a == b)
            .count();
        let to_common = from_root.into_iter().skip(common).rev();
        Some(to_common.chain(to_root.into_iter().skip(common)).collect())
    }

    /// The link where a way of joints to `link` begins: `link` itself when there are none.
    fn way_start(&self, link: usize, way: &[usize]) -> Option<usize> {
        way.first()
            .map_or(Some(link), |&joint| Some(self.ends(joint)?.0))
    }

    /// The links that are no child of any joint, in document order; links of a name that an earlier link has
    /// are left out.
    pub fn roots(&self, robot: &Robot) -> Vec<usize> {
        // a joint whose parent does not exist still says that its child is no root
        let alone = robot.joints.iter().zip(&self.ends);
        let alone = alone.filter(|(_, ends)| ends.is_none());
        let held: FastSet<usize> = alone
            .filter_map(|(joint, _)| self.link(joint.child.as_ref()?.name()?))
            .collect();
        let is_root = |&(link, &counts): &(usize, &bool)| {
            counts && self.parent_joints(link).is_empty() && !held.contains(&link)
        };
        let roots = self.counts.iter().enumerate().filter(is_root);
        roots.map(|(link, _)| link).collect()
    }

    /// The cycles that joints make, each as the joints along it from parent to child; a joint from a link to
    /// itself is no cycle. Every way back to a link above is one cycle.
    pub fn cycles(&self) -> Vec<Vec<usize>> {
        let mut cycles = Vec::new();
        let mut state = vec![VisitState::New; self.child_joints.len()];
        for start in 0..self.child_joints.len() {
            // links from `start` down to where the walk is: link, joints tried, joint taken
            let mut way = vec![(start, 0, None)];
            if state.get(start) != Some(&VisitState::New) {
                continue;
            }
            set(&mut state, start, VisitState::OnWay);
            while let Some(&mut (link, ref mut tried, ref mut taken)) = way.last_mut() {
                let Some(&joint) = self.child_joints(link).get(*tried) else {
                    set(&mut state, link, VisitState::Done);
                    way.pop();
                    continue;
                };
                *tried += 1;
                *taken = Some(joint);
                let Some((_, child)) = self.ends(joint).filter(|(parent, child)| parent != child)
                else {
                    continue;
                };
                match state.get(child) {
                    Some(VisitState::New) => {
                        set(&mut state, child, VisitState::OnWay);
                        way.push((child, 0, None));
                    }
                    Some(VisitState::OnWay) => {
                        let cycle = way.iter().skip_while(|(link, ..)| *link != child);
                        cycles.push(cycle.filter_map(|&(_, _, taken)| taken).collect());
                    }
                    _ => {}
                }
            }
        }
        cycles
    }
}

/// How far the search for cycles is with a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum VisitState {
    New,
    OnWay,
    Done,
}

fn set(state: &mut [VisitState], link: usize, to: VisitState) {
    if let Some(slot) = state.get_mut(link) {
        *slot = to;
    }
}
