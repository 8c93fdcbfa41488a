//! A plugin of Gazebo with a joint that the robot does not have.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::unknown_joints;
use super::plugins::plugins_of;
use expand::XTree;
use model::{AttrValue, Robot};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL029",
    name: "plugin-unknown-joint",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("plugin-unknown-joint"),
    check: Check::Whole(check),
};

/// Wheels by their side.
const WHEELS: &[&str] = &[
    "left_joint",
    "right_joint",
    "leftJoint",
    "rightJoint",
    "left_steering_joint",
    "right_steering_joint",
    "front_left_joint",
    "front_right_joint",
    "rear_left_joint",
    "rear_right_joint",
    "back_left_joint",
    "back_right_joint",
    "leftFrontJoint",
    "rightFrontJoint",
    "leftRearJoint",
    "rightRearJoint",
    "steering_wheel_joint",
    "steeringJoint",
    "actuatedWheelJoint",
    "encoderWheelLeftJoint",
    "encoderWheelRightJoint",
];

/// Parameters that hold the name of a joint: what the file name of the plugin contains, and the tags.
/// Source: the systems of gz-sim, the plugins of gazebo_ros_pkgs and of roboticsgroup_gazebo_plugins.
const TAGS: [(&str, &[&str]); 13] = [
    ("diff-drive", WHEELS),
    ("diff_drive", WHEELS),
    ("skid_steer_drive", WHEELS),
    ("tricycle_drive", WHEELS),
    ("ackermann", WHEELS),
    ("mecanum-drive", WHEELS),
    ("joint-position-controller", &["joint_name"]),
    ("joint-controller", &["joint_name"]),
    ("joint-state-publisher", &["joint_name"]),
    ("joint_state_publisher", &["joint_name", "jointName"]),
    ("joint-trajectory-controller", &["joint_name"]),
    ("ft_sensor", &["joint_name", "jointName"]),
    ("mimic_joint", &["joint", "mimicJoint"]),
];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let names = named_by_plugins(&cx.expansion.tree, cx.robot, |_| true);
    unknown_joints(cx, out, names.iter(), "plugin", RULE.severity);
}

/// The joints that plugins of Gazebo for drives move.
pub(in super::super) fn driven(tree: &XTree, robot: &Robot) -> Vec<AttrValue> {
    named_by_plugins(tree, robot, |tags| tags == WHEELS)
}

/// The names of joints in parameters of plugins that are known, of those whose tags are `wanted`.
fn named_by_plugins(
    tree: &XTree,
    robot: &Robot,
    wanted: impl Fn(&[&str]) -> bool,
) -> Vec<AttrValue> {
    let mut names: Vec<AttrValue> = Vec::new();
    for plugin in plugins_of(tree, robot) {
        let Some(file) = AttrValue::attr(tree, plugin, "filename") else {
            continue;
        };
        let known = TAGS.iter().find(|(part, _)| file.value.contains(part));
        let Some((_, tags)) = known.filter(|(_, tags)| file.is_known() && wanted(tags)) else {
            continue;
        };
        for parameter in tree
            .elements(plugin)
            .filter(|&one| tags.contains(&tree.get(one).text.as_str()))
        {
            // lists, and names in other models, are not looked at
            let is_plain = |text: &AttrValue| !text.value.contains([',', ':', '/', ' ']);
            names.extend(AttrValue::content(tree, parameter).filter(is_plain));
        }
    }
    names
}
