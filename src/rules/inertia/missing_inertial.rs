//! A moving link that a simulator would drop.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::is_simulator_plugin;
use base::FastSet;
use model::{AttrValue, Gazebo, JointType, Ros2Control};
use workspace::config::Profile;

pub(super) static RULE: Rule = Rule {
    code: "INR011",
    name: "missing-inertial",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-inertial"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let robot = cx.robot;
    let simulated = is_simulated(cx) || cx.world.config.profiles.contains(&Profile::Gazebo);
    if !simulated && robot.controls.is_empty() {
        return;
    }
    let severity = if simulated {
        Severity::Warning
    } else {
        Severity::Info
    };
    for (index, link) in robot.links.iter().enumerate() {
        let Some(name) = link.name.as_ref().filter(|name| name.value != "world") else {
            continue;
        };
        let above = cx
            .kinematics
            .parent_joints(index)
            .first()
            .and_then(|&joint| robot.joints.get(joint)?.joint_type());
        let moves = above.is_some_and(|kind| kind != JointType::Fixed);
        if moves && link.has_geometry() && link.inertial.is_none() && !carries_mass(cx, index) {
            let message = format!("moving link `{}` has no `inertial`", name.value);
            let is_picture = is_drawn_linkage(cx, index);
            out.report(name.origin, message)
                .severity(if is_picture { Severity::Info } else { severity })
                .help("add an <inertial> with mass and inertia; Gazebo ignores the link, its joint and its children otherwise")
                .done();
        }
    }
}

/// Whether a link is the bar of a linkage that is only drawn: neither it nor what hangs on it has a collision or a mass, and one of
/// their joints moves as another one does.
fn is_drawn_linkage(cx: &RobotCx<'_>, link: usize) -> bool {
    let mut joints: Vec<usize> = cx.kinematics.parent_joints(link).to_vec();
    let mut open = vec![link];
    let mut seen = FastSet::default();
    while let Some(link) = open.pop() {
        if !seen.insert(link) {
            continue;
        }
        let own = cx.robot.links.get(link);
        if own.is_none_or(|own| !own.collisions.is_empty() || own.inertial.is_some()) {
            return false;
        }
        let below = cx.kinematics.child_joints(link);
        joints.extend(below);
        open.extend(
            below
                .iter()
                .filter_map(|&joint| Some(cx.kinematics.ends(joint)?.1)),
        );
    }
    let mut joints = joints
        .into_iter()
        .filter_map(|joint| cx.robot.joints.get(joint));
    joints.any(|joint| joint.mimic.is_some())
}

/// Whether a simulator loads the robot: a Gazebo tag or hardware of a simulator says so. A ros2_control block for
/// real hardware or for a mock does not, nor does one for MuJoCo: it reads a model of its own.
fn is_simulated(cx: &RobotCx<'_>) -> bool {
    let tree = &cx.expansion.tree;
    let is_simulator = |control: &Ros2Control| {
        let plugin = control
            .plugin(tree)
            .and_then(|element| AttrValue::content(tree, element));
        // a plugin that is not known may be one
        plugin
            .as_ref()
            .is_some_and(|plugin| !plugin.is_known() || is_simulator_plugin(&plugin.value))
    };
    let is_only_shown = cx.robot.links.iter().all(|link| link.inertial.is_none());
    // colors for Gazebo are kept where nobody simulates the robot
    let says_more = |block: &Gazebo| !is_only_shown || has_more_than_color(cx, block);
    cx.robot.gazebo.iter().any(says_more) || cx.robot.controls.iter().any(is_simulator)
}

fn has_more_than_color(cx: &RobotCx<'_>, block: &Gazebo) -> bool {
    let tree = &cx.expansion.tree;
    tree.elements(block.element)
        .any(|tag| tree.get(tag).text != "material")
}

/// Whether a link fixed below has a mass: simulators join both to one body.
fn carries_mass(cx: &RobotCx<'_>, link: usize) -> bool {
    let mut open = vec![link];
    let mut seen = FastSet::default();
    while let Some(link) = open.pop().filter(|_| seen.len() <= cx.robot.links.len()) {
        if !seen.insert(link) {
            continue;
        }
        if cx
            .robot
            .links
            .get(link)
            .is_some_and(|link| link.inertial.is_some())
        {
            return true;
        }
        let fixed = cx.kinematics.child_joints(link).iter().filter(|&&joint| {
            cx.robot
                .joints
                .get(joint)
                .is_some_and(|joint| joint.joint_type() == Some(JointType::Fixed))
        });
        open.extend(fixed.filter_map(|&joint| Some(cx.kinematics.ends(joint)?.1)));
    }
    false
}
