//! From blocks about joints to the joints of the robot.

use super::super::context::{DocumentCx, RobotCx};
use super::super::edits::{rename, source_text};
use super::super::sink::Sink;
use crate::base::TextRange;
use crate::expand::{Expansion, Origin};
use crate::model::JointType::{Prismatic, Revolute};
use crate::model::{ControlJoint, Joint, Text};
use crate::workspace::nearest;

/// The joints that ros2_control lists, each with that of the robot.
pub(super) fn controlled<'a>(cx: &DocumentCx<'a>) -> Vec<(&'a ControlJoint, &'a Joint)> {
    let Some(robot) = cx.robot else { return Vec::new() };
    let listed = robot.controls.iter().flat_map(|control| &control.joints);
    listed.filter_map(|listed| Some((listed, robot.joint(listed.name.as_ref()?.name()?)?))).collect()
}

/// Report the name of a joint in a block if the robot has no such joint.
pub(super) fn unknown_joint(cx: &RobotCx<'_>, out: &mut Sink<'_>, text: &Text, block: &str) {
    let Some(name) = text.name().filter(|name| cx.robot.joint(name).is_none()) else { return };
    let report = out.report(text.origin, format!("{block} names joint `{name}`, which does not exist"));
    match nearest(name, cx.robot.joints.iter().map(|joint| joint.shown())) {
        Some(near) => {
            let report = report.help(format!("a joint with a similar name exists: `{near}`"));
            rename(report, cx.expansion, text, near).done();
        }
        None => report.help("name a joint of this robot, with its prefix").done(),
    }
}

/// The limits of a joint that has some, radians or metres.
pub(super) fn range(joint: &Joint) -> Option<(f64, f64)> {
    joint
        .limit
        .as_ref()
        .filter(|_| joint.is(&[Revolute, Prismatic]))?
        .range()
        .filter(|(lower, upper)| lower <= upper)
}

/// Where the text inside of an element stands, without the blanks around it.
pub(super) fn value_place(expansion: &Expansion, text: &Text) -> Origin {
    let Some((_, _, source)) = source_text(expansion, text.origin) else { return text.origin };
    let trimmed = source.trim();
    let start = text.origin.range.start + (source.len() - source.trim_start().len()) as u32;
    Origin { range: TextRange::new(start, start + trimmed.len() as u32), ..text.origin }
}
