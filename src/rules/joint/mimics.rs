//! Which joint follows which.
use base::FastMap;
use model::{AttrValue, Joint, Robot};

/// For each joint, the one it mimics: indices into [`Robot::joints`].
pub(super) fn targets(robot: &Robot) -> Vec<Option<usize>> {
    let mut named: FastMap<&str, usize> = FastMap::default();
    if robot.joints.iter().all(|joint| joint.mimic.is_none()) {
        return vec![None; robot.joints.len()];
    }
    for (i, joint) in robot.joints.iter().enumerate() {
        named.entry(joint.shown()).or_insert(i);
    }
    let target = |joint: &Joint| {
        let name = joint.mimic.as_ref()?.joint.as_ref()?.name()?;
        named.get(name.as_str()).copied()
    };
    robot.joints.iter().map(target).collect()
}

/// The joints that mimic another one: the joint, the name it gives, and the other one.
pub(super) fn mimicking(robot: &Robot) -> impl Iterator<Item = (&Joint, &AttrValue, &Joint)> {
    let pairs = robot.joints.iter().zip(targets(robot));
    pairs.filter_map(|(joint, target)| {
        let text = joint.mimic.as_ref()?.joint.as_ref()?;
        Some((joint, text, robot.joints.get(target?)?))
    })
}
