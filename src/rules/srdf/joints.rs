//! The joints of planning groups.

use ecow::EcoString;

use super::super::beside::{BesideCx, PairedRobot};
use base::{FastMap, FastSet};
use model::{JointType, Text};
use project::{Group, Srdf};

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
        Self { srdf, robot, known: FastMap::default() }
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
        let robot = self.robot?;
        let mut joints = FastSet::default();
        let mut seen: FastSet<&str> = FastSet::default();
        let mut open: Vec<&str> = vec![group];
        while let Some(name) = open.pop() {
            // a group that contains itself has no more joints for it
            let Some(name) = Some(name).filter(|name| !seen.contains(name)) else { continue };
            let group = self.srdf.group(name)?;
            seen.insert(group.name.as_ref()?.value.as_str());
            add(robot, group, &mut joints)?;
            for inner in &group.subgroups {
                open.push(inner.name()?);
            }
        }
        Some(joints)
    }
}

/// The joints that a group names by itself, by its links and by its chains.
fn add<'a>(paired: &PairedRobot<'a>, group: &'a Group, joints: &mut FastSet<&'a str>) -> Option<()> {
    for joint in &group.joints {
        joints.insert(paired.robot.joint(joint.name()?)?.name.as_ref()?.value.as_str());
    }
    let link = |text: &Text| paired.kinematics.link(text.name()?);
    let name = |joint: usize| Some(paired.robot.joints.get(joint)?.name.as_ref()?.value.as_str());
    for text in &group.links {
        if let Some(&joint) = paired.kinematics.up(link(text)?).first() {
            joints.insert(name(joint)?);
        }
    }
    for chain in &group.chains {
        let (base, tip) = (link(chain.base.as_ref()?)?, link(chain.tip.as_ref()?)?);
        for joint in paired.kinematics.path(base, tip)? {
            joints.insert(name(joint)?);
        }
    }
    Some(())
}

/// Whether a state has to say where a joint is: it moves by itself, and something drives it.
pub(super) fn is_planned(cx: &BesideCx<'_>, srdf: &Srdf, name: &str) -> bool {
    let is_passive = srdf.passive.iter().any(|joint| joint.value == name);
    let has_value = |kind| matches!(kind, JointType::Revolute | JointType::Continuous | JointType::Prismatic);
    let is_driven = |joint: &model::Joint| joint.mimic.is_none() && joint.joint_type().is_some_and(has_value);
    !is_passive && cx.joints(name).all(|(_, joint)| is_driven(joint))
}
