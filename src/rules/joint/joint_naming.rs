//! Joints of an arm that are not numbered from the base on.
use super::super::arms::serial_arms;
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(super) static RULE: Rule = Rule {
    code: "JNT027",
    name: "joint-naming",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("joint-naming"),
    check: Check::Robot(check),
};

/// Words of an arm: `shoulder_lift_joint` is its second joint, `lift_joint` carries it.
const OWN: [&str; 5] = ["shoulder", "upper", "elbow", "forearm", "wrist"];

/// Words in the names of joints that are no part of the arm.
const OTHERS: [&str; 14] = [
    "gripper",
    "finger",
    "jaw",
    "hand",
    "claw",
    "rail",
    "track",
    "external",
    "ext",
    "torso",
    "lift",
    "turntable",
    "positioner",
    "wheel",
];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for arm in serial_arms(cx.robot, cx.kinematics) {
        let joints = arm.iter().filter_map(|&joint| cx.robot.joints.get(joint));
        let joints: Vec<_> = joints.filter(|joint| !is_other(joint.shown())).collect();
        if joints.len() < 2 {
            continue;
        }
        let prefix = joints
            .iter()
            .enumerate()
            .find_map(|(i, joint)| joint.shown().strip_suffix(&format!("joint_{}", i + 1)))
            .unwrap_or_default();
        for (i, joint) in joints.iter().enumerate() {
            let Some(name) = joint.name.as_ref().filter(|name| name.is_known()) else {
                continue;
            };
            let expected = format!("{prefix}joint_{}", i + 1);
            if name.value != expected {
                let message = format!(
                    "joint `{}` is joint {} of the arm but is not named `{expected}`",
                    name.value,
                    i + 1
                );
                out.report(name.origin, message)
                    .help(format!(
                        "rename it to `{expected}`; ROS-Industrial numbers joints from the base"
                    ))
                    .done();
            }
        }
    }
}

/// Whether a joint belongs to a gripper or an external axis, by its name.
fn is_other(name: &str) -> bool {
    let name = name.to_lowercase();
    let words: Vec<&str> = name
        .split(['_', '-', '/'])
        .map(|word| word.trim_end_matches(|c: char| c.is_ascii_digit()))
        .collect();
    words.iter().any(|word| OTHERS.contains(word)) && !words.iter().any(|word| OWN.contains(word))
}
