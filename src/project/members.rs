//! The joints of planning groups.

use super::srdf::{PlanningGroup, Srdf};
use base::FastSet;
use model::{AttrValue, Kinematics, Robot};

/// The joints of a group and of those in it; none when not all are known.
pub fn joints_of_group<'r>(
    srdf: &Srdf,
    group: &str,
    (robot, kinematics): (&'r Robot, &Kinematics),
) -> Option<FastSet<&'r str>> {
    let mut joints = FastSet::default();
    let mut seen: FastSet<&str> = FastSet::default();
    let mut open: Vec<&str> = vec![group];
    while let Some(name) = open.pop() {
        // a group that contains itself has no more joints for it
        let Some(name) = Some(name).filter(|name| !seen.contains(name)) else {
            continue;
        };
        let group = srdf.group(name)?;
        seen.insert(group.name.as_ref()?.value.as_str());
        add((robot, kinematics), group, &mut joints)?;
        for inner in &group.subgroups {
            open.push(inner.name()?);
        }
    }
    Some(joints)
}

/// The joints that a group names by itself, by its links and by its chains.
fn add<'r>(
    (robot, kinematics): (&'r Robot, &Kinematics),
    group: &PlanningGroup,
    joints: &mut FastSet<&'r str>,
) -> Option<()> {
    for joint in &group.joints {
        joints.insert(robot.joint(joint.name()?)?.name.as_ref()?.value.as_str());
    }
    for text in &group.links {
        if let Some(&joint) = kinematics
            .parent_joints(kinematics.link(text.name()?)?)
            .first()
        {
            joints.insert(joint_name(robot, joint)?);
        }
    }
    for chain in &group.chains {
        let base = kinematics.link(chain.base.as_ref()?.name()?)?;
        let tip = kinematics.link(chain.tip.as_ref()?.name()?)?;
        for joint in kinematics.path(base, tip)? {
            joints.insert(joint_name(robot, joint)?);
        }
    }
    Some(())
}

fn joint_name(robot: &Robot, joint: usize) -> Option<&str> {
    Some(robot.joints.get(joint)?.name.as_ref()?.value.as_str())
}

impl PlanningGroup {
    /// What it holds, in one line: `chain base → tool`, `2 joints`.
    pub fn in_short(&self) -> String {
        let text = |text: &Option<AttrValue>| {
            text.as_ref()
                .map_or("?".to_owned(), |text| text.value.to_string())
        };
        let chains = self
            .chains
            .iter()
            .map(|chain| format!("chain {} → {}", text(&chain.base), text(&chain.tip)));
        let others = [
            (&self.joints, "joint"),
            (&self.links, "link"),
            (&self.subgroups, "group"),
        ];
        chains
            .chain(
                others
                    .into_iter()
                    .filter_map(|(list, noun)| named_or_counted(list, noun)),
            )
            .collect::<Vec<_>>()
            .join(", ")
    }
}

/// The name of a single one, the number of several: `joint elbow`, `2 joints`.
fn named_or_counted(list: &[AttrValue], noun: &str) -> Option<String> {
    match list {
        [] => None,
        [one] => Some(format!("{noun} {}", one.value)),
        list => Some(format!("{} {noun}s", list.len())),
    }
}
