//! Which robots of a pairing a file is compared with: whole ones, whose names it has.
use std::path::Path;
use std::sync::Arc;

use super::super::root_analysis::RootAnalysis;
use super::super::session::Session;
use super::super::set_aside::is_set_aside;
use super::files::{Beside, Robots, read_beside};
use super::paired::Pairing;
use super::robots::stem;
use expand::Expansion;
use rules::{RobotNames, is_whole};

/// The robots that a file is compared with.
#[derive(Default)]
pub(super) struct Paired {
    /// Whole robots.
    pub robots: Vec<Arc<RootAnalysis>>,
    /// Copies and old versions of these, and those that lack a part beside a copy that has it: their names are known, and nothing
    /// else of them counts.
    pub unused: Vec<Arc<RootAnalysis>>,
}

/// The part of the names of links and joints that has to fit when nothing but the name of the robot says for which one a
/// file is, and when a file says so.
const LIKE: f64 = 0.5;
const NAMED: f64 = 0.2;
/// Of several names, one at least has to fit.
const SEVERAL: u32 = 3;
/// The part that has to fit a robot in use, for copies of it not to count.
const IN_USE: f64 = 0.75;

/// The robots of a pairing that may be compared with a file: whole ones, when enough names fit.
pub(super) fn paired(
    session: &Session,
    own: &Beside,
    pairing: &Pairing,
    robots: &Robots,
) -> Option<Paired> {
    let all: Option<Vec<_>> = pairing
        .roots
        .iter()
        .map(|root| robots.get(root).cloned())
        .collect();
    let mut found = all?;
    found.retain(|one| !is_empty(one));
    let mut unused = take_unused(session, &mut found, own);
    // where a part of a robot is missing, nothing can be said to be missing; a part of another robot is known there
    if found
        .iter()
        .any(|one| !is_settled(one) && !is_part_of(one, &found))
    {
        return None;
    }
    let (found, lacking): (Vec<_>, Vec<_>) = found.into_iter().partition(|one| is_settled(one));
    unused.extend(lacking);
    let names = names_of(&found);
    let has_arguments = found.iter().any(|one| !one.expansion.arguments.is_empty());
    // what the SRDF is for, the other settings in its package are for
    let srdf = pairing
        .srdf
        .as_ref()
        .and_then(|srdf| read_beside(session, srdf, robots));
    let is_like = srdf.is_some_and(|srdf| likeness(&srdf, &names).1 >= LIKE);
    let (count, likeness) = likeness(own, &names);
    let least = if !pairing.is_named && !is_like {
        LIKE
    } else if has_arguments && count >= SEVERAL {
        NAMED
    } else {
        0.0
    };
    let is_any = likeness > 0.0 || count < SEVERAL;
    let is_for_them = !found.is_empty() && is_any && likeness >= least;
    is_for_them.then_some(Paired {
        robots: found,
        unused,
    })
}

/// Take out the copies and old versions of a robot in use, when the file fits that one.
fn take_unused(
    session: &Session,
    robots: &mut Vec<Arc<RootAnalysis>>,
    own: &Beside,
) -> Vec<Arc<RootAnalysis>> {
    if robots.len() < 2 {
        return Vec::new();
    }
    let (unused, used): (Vec<_>, Vec<_>) = robots
        .iter()
        .cloned()
        .partition(|one| is_set_aside(session, &one.root.file));
    let is_enough =
        used.iter().any(|one| is_settled(one)) && likeness(own, &names_of(&used)).1 >= IN_USE;
    if unused.is_empty() || !is_enough {
        return Vec::new();
    }
    *robots = used;
    unused
}

/// The names of links and joints in robots.
pub(super) fn names_of(robots: &[Arc<RootAnalysis>]) -> RobotNames {
    let mut names = RobotNames::default();
    robots
        .iter()
        .filter_map(|one| one.robot.as_ref())
        .for_each(|robot| names.add(robot));
    names
}

/// The same, with the joints that hardware moves: a file that is missing may give them.
pub(super) fn all_names_of(robots: &[Arc<RootAnalysis>]) -> RobotNames {
    let mut names = names_of(robots);
    let robots = robots.iter().filter_map(|one| one.robot.as_ref());
    let hardware = robots.flat_map(|robot| &robot.controls);
    let joints = hardware.flat_map(|control| &control.joints);
    let named = joints.filter_map(|joint| joint.name.as_ref()?.name().cloned());
    names.joints.extend(named);
    names
}

/// Whether all names of a robot are known, and all of it is there.
fn is_settled(analyzed: &RootAnalysis) -> bool {
    let known = analyzed
        .robot
        .as_ref()
        .is_some_and(|robot| !robot.links.is_empty() && robot.names_are_known());
    let broken = analyzed
        .expansion
        .files
        .iter()
        .any(|file| !file.source.document.errors().is_empty());
    known && !broken && is_whole(&analyzed.expansion)
}

/// Whether a file gives no robot, and its conditions do not change that: it collects macros.
fn is_empty(analyzed: &RootAnalysis) -> bool {
    let gives = analyzed
        .robot
        .as_ref()
        .is_some_and(|robot| !robot.links.is_empty());
    !gives && is_whole(&analyzed.expansion) && !has_choices(&analyzed.expansion)
}

/// Whether another robot, of which everything is known, includes the file of this one, or is written for it: `arm.urdf`
/// beside `arm.urdf.xacro`.
fn is_part_of(analyzed: &RootAnalysis, all: &[Arc<RootAnalysis>]) -> bool {
    let own = &analyzed.root.file;
    all.iter()
        .any(|other| is_whole_of(other, own) && is_settled(other))
}

/// Whether another robot includes a file, or has its name in the same folder.
fn is_whole_of(other: &RootAnalysis, part: &Path) -> bool {
    let root = &other.root.file;
    let mut files = other.expansion.files.iter().map(|file| &*file.source.path);
    let is_named_so = root.parent() == part.parent() && stem(root) == stem(part);
    root != part && (is_named_so || files.any(|file| file == part))
}

/// Whether conditions of a file decide what it gives.
pub(super) fn has_choices(expansion: &Expansion) -> bool {
    let items = expansion
        .files
        .iter()
        .flat_map(|file| file.source.document.parts());
    let mut nodes = items.flat_map(|(_, item)| item.all_nodes());
    !expansion.arguments.is_empty()
        || nodes.any(|node| ["xacro:if", "xacro:unless"].contains(&node.name()))
}

/// How many names of links and joints there are in a file, and which part of them a robot has.
fn likeness(own: &Beside, names: &RobotNames) -> (u32, f64) {
    let (mut all, mut known) = (0u32, 0u32);
    for (kind, name) in own.names() {
        let list = match kind {
            project::ProjectNameKind::Link => &names.links,
            project::ProjectNameKind::Joint => &names.joints,
            project::ProjectNameKind::Group => continue,
        };
        all += 1;
        known += u32::from(list.contains(name.as_str()));
    }
    (
        all,
        if all == 0 {
            1.0
        } else {
            f64::from(known) / f64::from(all)
        },
    )
}

#[cfg(test)]
mod tests {
    use super::super::super::set_aside_tests::found;

    #[test]
    fn joints_of_hardware_beside_a_copy_without_them() {
        let of = |hardware: &str| {
            let arm = "<link name='base'/><link name='tip'/><joint name='turn' type='continuous'><parent link='base'/>\
                       <child link='tip'/><axis xyz='0 0 1'/></joint>";
            let block = |joints: &str| {
                format!(
                    "<ros2_control name='h' type='system'><hardware><plugin>p/P</plugin></hardware>{joints}</ros2_control>"
                )
            };
            let joint = |name: &str| {
                format!("<joint name='{name}'><command_interface name='position'/></joint>")
            };
            let copy = format!("<robot name='arm'>{arm}{}</robot>", block(&joint("turn")));
            let robot = format!(
                "<robot name='arm' xmlns:xacro='x'><xacro:include filename='$(find gripper)/gripper.xacro'/>{arm}\
                 <xacro:gripper/>{}</robot>",
                block(&(joint("turn") + hardware))
            );
            let controllers = "controller_manager:\n  ros__parameters:\n    grip:\n      type: position_controllers/GripperActionController\n    \
                               go:\n      type: joint_trajectory_controller/JointTrajectoryController\n\
                               grip:\n  ros__parameters:\n    joint: finger\n\
                               go:\n  ros__parameters:\n    joints: [turn]\n    command_interfaces: [position]\n";
            let files = [
                (
                    "package.xml",
                    "<package format='3'><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
                ),
                ("urdf/arm.urdf", copy.as_str()),
                ("urdf/arm.urdf.xacro", robot.as_str()),
                ("config/controllers.yaml", controllers),
            ];
            found(&files, "controller-unknown-joint").len()
        };
        assert_eq!(of(""), 1);
        let finger = "<joint name='finger'><command_interface name='position'/></joint>";
        assert_eq!(of(finger), 0);
    }
}
