//! The joints of planning groups.
use ecow::EcoString;

use super::super::beside::{BesideCx, PairedRobot};
use base::{FastMap, FastSet};
use model::JointType;
use project::{Srdf, joints_of_group};

/// The joints of each group, once somebody has asked.
pub(super) struct Members<'a> {
    srdf: &'a Srdf,
    /// The robot, when there is one alone: in others the same chain has other joints.
    robot: Option<&'a PairedRobot<'a>>,
    known: FastMap<EcoString, Option<FastSet<&'a str>>>,
}

impl<'a> Members<'a> {
    pub fn new(cx: &BesideCx<'a>, srdf: &'a Srdf) -> Self {
        let robot = match cx.robots {
            [only] => Some(only),
            _ => None,
        };
        Self {
            srdf,
            robot,
            known: FastMap::default(),
        }
    }

    /// The joints of a group and of those in it; none when not all are known.
    pub fn of(&mut self, group: &EcoString) -> Option<&FastSet<&'a str>> {
        if !self.known.contains_key(group) {
            let joints = self.collect(group);
            self.known.insert(group.clone(), joints);
        }
        self.known.get(group)?.as_ref()
    }

    fn collect(&self, group: &str) -> Option<FastSet<&'a str>> {
        let paired = self.robot?;
        joints_of_group(self.srdf, group, (paired.robot, paired.kinematics))
    }
}

/// Whether a state has to say where a joint is: it moves by itself, and something drives it.
pub(super) fn is_planned(cx: &BesideCx<'_>, srdf: &Srdf, name: &str) -> bool {
    let is_passive = srdf.passive.iter().any(|joint| joint.value == name);
    let has_value = |kind| {
        matches!(
            kind,
            JointType::Revolute | JointType::Continuous | JointType::Prismatic
        )
    };
    let mut joints = cx.joints(name).map(|(_, joint)| joint);
    !is_passive
        && joints.all(|joint| joint.mimic.is_none() && joint.joint_type().is_some_and(has_value))
}
