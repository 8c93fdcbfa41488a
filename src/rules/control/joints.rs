//! From blocks about joints to the joints of the robot.
use super::super::context::{DocumentCx, RobotCx};
use super::super::edits::{rename, source_text};
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::Severity;
use super::super::sink::Sink;
use base::{FastMap, FastSet, TextRange};
use expand::{Expansion, Origin};
use model::JointType::{Prismatic, Revolute};
use model::{AttrValue, ControlJoint, Joint};
use packages::Suggestions;

/// The joints that ros2_control lists, each with that of the robot.
pub(super) fn controlled<'a>(cx: &DocumentCx<'a>) -> Vec<(&'a ControlJoint, &'a Joint)> {
    let Some(robot) = cx.robot.filter(|robot| !robot.controls.is_empty()) else {
        return Vec::new();
    };
    let mut named: FastMap<&str, &Joint> = FastMap::default();
    for joint in &robot.joints {
        named.entry(joint.shown()).or_insert(joint);
    }
    let listed = robot.controls.iter().flat_map(|control| &control.joints);
    listed
        .filter_map(|listed| Some((listed, *named.get(listed.name.as_ref()?.name()?.as_str())?)))
        .collect()
}

/// Whether the robot is for distributions whose ros2_control does not compare its joints with those of the robot.
pub(super) fn is_before_jazzy(cx: &DocumentCx<'_>) -> bool {
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    has_old_plugin(cx) || root.is_some_and(|root| cx.world.packages.is_before_jazzy(root))
}

/// Whether a robot is used with Jazzy or a later distribution: the plugin of its simulator or its package says so.
pub(super) fn is_since_jazzy(cx: &DocumentCx<'_>) -> bool {
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    !has_old_plugin(cx) && root.is_some_and(|root| cx.world.packages.is_since_jazzy(root))
}

/// Whether the hardware is that of a simulator that Jazzy has not.
fn has_old_plugin(cx: &DocumentCx<'_>) -> bool {
    const OLD: [&str; 2] = ["gazebo_ros2_control/", "ign_ros2_control/"];
    let tree = &cx.expansion.tree;
    let plugins = cx
        .robot
        .into_iter()
        .flat_map(|robot| &robot.controls)
        .filter_map(|one| one.plugin(tree));
    let mut names = plugins.filter_map(|plugin| AttrValue::content(tree, plugin));
    names.any(|name| OLD.iter().any(|old| name.value.trim().starts_with(old)))
}

/// Report the names of joints in blocks of a kind that the robot does not have.
pub(super) fn unknown_joints<'t>(
    cx: &RobotCx<'_>,
    out: &mut Sink<'_>,
    texts: impl Iterator<Item = &'t AttrValue>,
    block: &str,
    severity: Severity,
) {
    let mut texts = texts.peekable();
    if texts.peek().is_none() {
        return;
    }
    let known: FastSet<&str> = cx.robot.joints.iter().map(|joint| joint.shown()).collect();
    let mut suggestions = Suggestions::default();
    for text in texts {
        let Some(name) = text.name().filter(|name| !known.contains(name.as_str())) else {
            continue;
        };
        let message = format!("{block} refers to unknown joint `{name}`");
        let report = out.report(text.origin, message).severity(severity);
        match suggestions.nearest(name, cx.robot.joints.iter().map(|joint| joint.shown())) {
            Some(near) => {
                let report = report.help(Help::did_you_mean(near));
                rename(report, cx.expansion, text, near).done();
            }
            None => report
                .group(Group::OtherRobot)
                .help("use the full name of a joint of this robot, including its prefix")
                .done(),
        }
    }
}

/// The limits of a joint that has some, radians or meters.
pub(crate) fn range(joint: &Joint) -> Option<(f64, f64)> {
    joint
        .limit
        .as_ref()
        .filter(|_| joint.is(&[Revolute, Prismatic]))?
        .range()
        .filter(|(lower, upper)| lower <= upper)
}

/// Where the text inside of an element stands, without the blanks around it.
pub(super) fn value_place(expansion: &Expansion, text: &AttrValue) -> Origin {
    let Some((_, _, source)) = source_text(expansion, text.origin) else {
        return text.origin;
    };
    let trimmed = source.trim();
    let start = text.origin.range.start + (source.len() - source.trim_start().len()) as u32;
    Origin {
        range: TextRange::new(start, start + trimmed.len() as u32),
        ..text.origin
    }
}
