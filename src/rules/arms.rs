//! Serial arms: moving joints one behind the other.
use base::FastSet;
use model::{Kinematics, Robot};

/// Of more chains than two, most are legs or fingers; an arm has at least so many joints.
const JOINTS_OF_ARM: usize = 5;

/// The arms of a robot, as far as one can tell: chains of joints that are not one of many short ones.
pub(super) fn serial_arms(robot: &Robot, kinematics: &Kinematics) -> Vec<Vec<usize>> {
    let mut arms = chains(robot, kinematics);
    if arms.len() > 2 {
        arms.retain(|arm| arm.len() >= JOINTS_OF_ARM);
    }
    arms
}

/// Two or more joints that move by themselves, each the only one behind the one before, from the base on.
/// Indices into [`Robot::joints`].
fn chains(robot: &Robot, kinematics: &Kinematics) -> Vec<Vec<usize>> {
    let mut arms = Vec::new();
    let mut inside: FastSet<usize> = FastSet::default();
    for start in driven_below(robot, kinematics, kinematics.roots(robot)) {
        let mut open = vec![start];
        while let Some(first) = open.pop() {
            if !inside.insert(first) {
                continue;
            }
            let mut arm = vec![first];
            let mut last = first;
            loop {
                let child = kinematics.ends(last).map(|(_, child)| child);
                let next = driven_below(robot, kinematics, child);
                match next.as_slice() {
                    [only] if inside.insert(*only) => {
                        arm.push(*only);
                        last = *only;
                    }
                    _ => {
                        open.extend(next);
                        break;
                    }
                }
            }
            if arm.len() >= 2 {
                arms.push(arm);
            }
        }
    }
    arms
}

/// The first joints below some links that move by themselves.
fn driven_below(
    robot: &Robot,
    kinematics: &Kinematics,
    links: impl IntoIterator<Item = usize>,
) -> Vec<usize> {
    let mut open: Vec<usize> = links.into_iter().collect();
    let mut seen: FastSet<usize> = open.iter().copied().collect();
    let mut found = Vec::new();
    while let Some(link) = open.pop() {
        for &joint in kinematics.child_joints(link) {
            if robot
                .joints
                .get(joint)
                .is_some_and(|joint| joint.is_driven())
            {
                found.push(joint);
            } else if let Some((_, child)) = kinematics
                .ends(joint)
                .filter(|(_, child)| seen.insert(*child))
            {
                open.push(child);
            }
        }
    }
    found
}
