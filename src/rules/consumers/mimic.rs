//! Joints that mimic others.
use super::facts::{Facts, Found, joint_owner};
use model::{Joint, JointType, Text};

pub(super) fn find(facts: &Facts<'_, '_>, out: &mut Found) {
    for (number, joint) in facts.robot.joints.iter().enumerate() {
        let Some(mimic) = &joint.mimic else { continue };
        let mut add = |row: &str| out.add(row, facts.at(mimic.element), joint_owner(joint));
        if joint.is(&[JointType::Fixed]) {
            add("mimic-in-fixed");
            continue;
        }
        let Some(name) = &mimic.joint else {
            add("mimic-without-joint");
            continue;
        };
        let Some(name) = name.name() else { continue };
        if mimic.multiplier.as_ref().and_then(Text::number) == Some(0.0) {
            add("mimic-multiplier-zero");
        }
        let row = match position(facts, name) {
            None => "mimic-unknown",
            Some(other) if other == number => "mimic-self",
            Some(other) => row(facts, number, other),
        };
        add(row);
    }
}

fn position(facts: &Facts<'_, '_>, name: &str) -> Option<usize> {
    facts
        .robot
        .joints
        .iter()
        .position(|joint| joint.name.as_ref().is_some_and(|own| own.value == name))
}

fn row(facts: &Facts<'_, '_>, joint: usize, other: usize) -> &'static str {
    let mimicked = |joint: usize| {
        let joint: &Joint = facts.robot.joints.get(joint)?;
        position(facts, joint.mimic.as_ref()?.joint.as_ref()?.name()?)
    };
    let is_fixed = facts
        .robot
        .joints
        .get(other)
        .is_some_and(|joint| joint.is(&[JointType::Fixed]));
    let kind = |joint: usize| facts.robot.joints.get(joint).and_then(Joint::joint_type);
    match mimicked(other) {
        Some(back) if back == joint => "mimic-cycle",
        Some(_) => "mimic-chain",
        None if is_fixed => "mimic-of-fixed",
        None if other > joint => "mimic-before",
        None if kind(joint) == Some(JointType::Revolute) => "mimic-revolute",
        None => "mimic",
    }
}
