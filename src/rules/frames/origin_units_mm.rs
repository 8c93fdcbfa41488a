//! The origin of a joint looks like millimeters.
use super::super::context::DocumentCx;
use super::super::numbers::{rewrite, short, vector};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::thresholds::MAX_JOINT_OFFSET;
use super::super::vocabulary::is_surroundings;
use base::FastSet;
use model::{Joint, JointType, Robot};

pub(super) static RULE: Rule = Rule {
    code: "FRM003",
    name: "origin-units-mm",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("origin-units-mm"),
    check: Check::Document(check),
};

/// Parts of a robot are closer to each other, meters.
const LARGE: f64 = 1.0;
/// So many joints show how large a model is.
const MANY: usize = 10;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| !cx.is_static()) else {
        return;
    };
    let most = MAX_JOINT_OFFSET.value(cx.world.config);
    let mut offsets: Vec<f64> = cx
        .joints()
        .iter()
        .filter_map(offset)
        .filter(|offset| *offset > 1e-9)
        .collect();
    offsets.sort_by(f64::total_cmp);
    let median = offsets.get(offsets.len() / 2).copied().unwrap_or(0.0);
    let large = is_large(cx.joints());
    let held: FastSet<&str> = cx
        .joints()
        .iter()
        .filter_map(|joint| Some(joint.child.as_ref()?.value.as_str()))
        .collect();
    for joint in cx.joints() {
        let Some(length) = offset(joint) else {
            continue;
        };
        let far = length > most || (length > 1000.0 * median && length > 5.0);
        let is_part_of_building = large && joint.is(&[JointType::Fixed]);
        if !far || is_part_of_building || is_placed(robot, joint, &held) {
            continue;
        }
        let Some(text) = joint.origin.as_ref().and_then(|origin| origin.xyz.as_ref()) else {
            continue;
        };
        let message = format!(
            "joint `{}` is {} m away from its parent link; this looks like millimeters",
            joint.shown(),
            short(length)
        );
        let report = out
            .report(text.origin, message)
            .help("write lengths in meters");
        let meters = text
            .numbers::<3>()
            .map(|numbers| vector(&numbers.map(|number| number / 1000.0)));
        match meters {
            Some(meters) => rewrite(report, Safety::Unsafe, text, meters).done(),
            None => report.done(),
        }
    }
}

/// How far a joint is from the frame of its parent, meters.
fn offset(joint: &Joint) -> Option<f64> {
    let [x, y, z] = joint.origin.as_ref()?.translation()?;
    Some((x * x + y * y + z * z).sqrt())
}

/// Whether a document describes a building or a landscape: most of its joints are fixed, and most of these are farther
/// than [`LARGE`] from their parent.
fn is_large(joints: &[Joint]) -> bool {
    let fixed: Vec<f64> = joints
        .iter()
        .filter(|joint| joint.is(&[JointType::Fixed]))
        .filter_map(offset)
        .collect();
    let far = fixed.iter().filter(|&&offset| offset > LARGE).count();
    fixed.len() >= MANY && 2 * fixed.len() > joints.len() && 2 * far > fixed.len()
}

/// Whether a joint places the robot in its surroundings: that may be anywhere.
fn is_placed(robot: &Robot, joint: &Joint, held: &FastSet<&str>) -> bool {
    let Some(parent) = joint.parent.as_ref().map(|parent| parent.value.as_str()) else {
        return false;
    };
    is_surroundings(parent)
        // a root without a body stands for what is around the robot
        || !held.contains(parent) && robot.link(parent).is_some_and(|link| !link.has_geometry())
}
