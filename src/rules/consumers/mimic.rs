//! Joints that mimic others.
use super::facts::{ConstructCollector, RobotFacts, joint_owner};
use model::{AttrValue, Joint, JointType};

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    for (number, joint) in facts.robot.joints.iter().enumerate() {
        let Some(mimic) = &joint.mimic else { continue };
        let (at, owner) = (facts.at(mimic.element), joint_owner(joint));
        if joint.is(&[JointType::Fixed]) {
            out.add("mimic-in-fixed", at, owner);
            continue;
        }
        let Some(name) = &mimic.joint else {
            out.add("mimic-without-joint", at, owner);
            continue;
        };
        let Some(name) = name.name() else { continue };
        if mimic.multiplier.as_ref().and_then(AttrValue::number) == Some(0.0) {
            out.add("mimic-multiplier-zero", at, owner);
        }
        let row = match position(facts, name) {
            None => "mimic-unknown",
            Some(other) if other == number => "mimic-self",
            Some(other) => row(facts, number, other),
        };
        out.add(row, at, owner);
    }
}

fn position(facts: &RobotFacts<'_, '_>, name: &str) -> Option<usize> {
    facts
        .robot
        .joints
        .iter()
        .position(|joint| joint.name.as_ref().is_some_and(|own| own.value == name))
}

fn row(facts: &RobotFacts<'_, '_>, joint: usize, other: usize) -> &'static str {
    let joints = &facts.robot.joints;
    let is_fixed = joints
        .get(other)
        .is_some_and(|joint| joint.is(&[JointType::Fixed]));
    let kind = joints.get(joint).and_then(Joint::joint_type);
    match mimicked(facts, other) {
        Some(back) if back == joint => "mimic-cycle",
        Some(_) => "mimic-chain",
        None if is_fixed => "mimic-of-fixed",
        None if other > joint => "mimic-before",
        None if kind == Some(JointType::Revolute) => "mimic-revolute",
        None => "mimic",
    }
}

/// The joint that a joint mimics.
fn mimicked(facts: &RobotFacts<'_, '_>, joint: usize) -> Option<usize> {
    let mimic = facts.robot.joints.get(joint)?.mimic.as_ref()?;
    position(facts, mimic.joint.as_ref()?.name()?)
}
