//! A plugin of Gazebo that is told other wheels than the robot has.
use super::super::context::RobotCx;
use super::super::geometry::link_bounds;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugins::plugins_of;
use super::wheel_sizes::{DriveLength, WheelPair, length};
use expand::{XId, XTree};
use model::{AttrValue, Link};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL032",
    name: "plugin-wheel-mismatch",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("plugin-wheel-mismatch"),
    check: Check::Whole(check),
};

/// Parts of the file names of plugins that drive wheels on two sides.
pub(super) const DRIVES: [&str; 3] = ["diff_drive", "diff-drive", "skid_steer"];
/// The tags of the joints that they turn, left and right.
pub(super) const JOINTS: [[&str; 2]; 3] = [
    ["left_joint", "right_joint"],
    ["leftJoint", "rightJoint"],
    ["leftFrontJoint", "rightFrontJoint"],
];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for plugin in plugins_of(tree, cx.robot) {
        let file = AttrValue::attr(tree, plugin, "filename");
        let is_drive = |file: &AttrValue| DRIVES.iter().any(|part| file.value.contains(part));
        let Some(pair) = file.filter(is_drive).and_then(|_| wheels(cx, tree, plugin)) else {
            continue;
        };
        let mut seen: Vec<&str> = Vec::new();
        for parameter in tree.elements(plugin) {
            let name = tree.get(parameter).text.as_str();
            // further ones are about further pairs
            if DriveLength::of(name).is_none() || seen.contains(&name) {
                continue;
            }
            seen.push(name);
            let Some(value) = AttrValue::content(tree, parameter) else {
                continue;
            };
            let mismatch = value.number().and_then(|said| pair.mismatch(name, said));
            if let Some((message, real)) = mismatch {
                out.report(value.origin, message)
                    .help(format!("write {}, or correct the wheels", length(real)))
                    .done();
            }
        }
    }
}

/// The first wheels of a plugin on each side.
pub(super) fn wheels<'a>(cx: &RobotCx<'a>, tree: &XTree, plugin: XId) -> Option<WheelPair<'a>> {
    let named = |tag: &str| {
        let mut all = tree.elements(plugin);
        let first = all.find(|&child| tree.get(child).text == tag)?;
        AttrValue::content(tree, first)
    };
    JOINTS.iter().find_map(|[left, right]| {
        let (left, right) = (named(left)?, named(right)?);
        let bounds = |link: &Link| link_bounds(cx.expansion, cx.robot, cx.world, link);
        WheelPair::of(
            cx.robot,
            cx.kinematics,
            [&left.value, &right.value],
            &bounds,
        )
    })
}
