//! An arm without a tool0 frame.
use super::super::arms::serial_arms;
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{Robot, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "FRM011",
    name: "missing-tool0",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("missing-tool0"),
    check: Check::Whole(check),
};

/// Words in the names of joints that make no arm.
const OTHERS: [&str; 8] = [
    "wheel", "caster", "leg", "hip", "head", "finger", "thumb", "rotor",
];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let has_tool0 = cx
        .robot
        .links
        .iter()
        .any(|link| link.shown().ends_with("tool0"));
    if !has_tool0
        && serial_arms(cx.robot, cx.kinematics)
            .iter()
            .any(|arm| is_arm(cx.robot, arm))
    {
        out.report(tag_start(cx.expansion, cx.robot.element), "arm has no frame `tool0`")
            .help("add a link `tool0` without geometry, fixed to the last link (or to `flange`), with z pointing out of the flange")
            .done();
    }
}

/// Whether joints one behind the other make an arm, by their names.
fn is_arm(robot: &Robot, joints: &[usize]) -> bool {
    let names = joints
        .iter()
        .filter_map(|&joint| robot.joints.get(joint))
        .map(|joint| joint.shown().to_lowercase());
    names
        .into_iter()
        .all(|name| !OTHERS.iter().any(|word| name.contains(word)))
}
