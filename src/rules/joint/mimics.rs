//! Which joint follows which.

use crate::model::{Joint, Robot, Text};

/// For each joint, the one it mimics: indices into [`Robot::joints`].
pub(super) fn targets(robot: &Robot) -> Vec<Option<usize>> {
    let target = |joint: &Joint| {
        let name = joint.mimic.as_ref()?.joint.as_ref()?.name()?;
        robot.joints.iter().position(|joint| joint.shown() == name)
    };
    robot.joints.iter().map(target).collect()
}

/// The joints that mimic another one: the joint, the name it gives, and the other one.
pub(super) fn mimicking(robot: &Robot) -> impl Iterator<Item = (&Joint, &Text, &Joint)> {
    let pairs = robot.joints.iter().zip(targets(robot));
    pairs.filter_map(|(joint, target)| {
        let text = joint.mimic.as_ref()?.joint.as_ref()?;
        Some((joint, text, robot.joints.get(target?)?))
    })
}
