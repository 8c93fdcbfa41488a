//! The origin of a joint looks like millimeters.
use super::super::context::DocumentCx;
use super::super::numbers::{rewrite, short, vector};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::thresholds::MAX_JOINT_OFFSET;
use super::super::vocabulary::is_surroundings;
use base::FastSet;
use ecow::EcoString;
use model::{Joint, JointType, SharedList};

pub(super) static RULE: Rule = Rule {
    code: "FRM003",
    name: "origin-units-mm",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("origin-units-mm"),
    check: Check::Joint(check),
};

/// Parts of a robot are closer to each other, meters.
const LARGE: f64 = 1.0;
/// A distance that is much greater than the others is that of millimeters only from here on, meters.
const FAR: f64 = 5.0;
/// So many joints show how large a model is.
const MANY: usize = 10;

/// How far apart the joints of a document are, and which links hang on one.
pub struct Distances {
    /// Whether it describes a building or a landscape.
    is_large: bool,
    /// The median of the distances that are not zero, meters.
    median: f64,
    held: FastSet<EcoString>,
}

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some(length) = offset(joint) else { return };
    let most = MAX_JOINT_OFFSET.value(cx.world.config);
    if length <= most.min(FAR) || cx.is_static() {
        return;
    }
    let distances = cx
        .all()
        .distances
        .get_or_init(|| Distances::between(cx.joints()));
    let far = length > most || (length > 1000.0 * distances.median && length > FAR);
    let is_part_of_building = distances.is_large && joint.is(&[JointType::Fixed]);
    if !far || is_part_of_building || is_placed(cx, joint, &distances.held) {
        return;
    }
    let Some(text) = joint.origin.as_ref().and_then(|origin| origin.xyz.as_ref()) else {
        return;
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

impl Distances {
    fn between(joints: &SharedList<Joint>) -> Self {
        let mut offsets: Vec<f64> = joints
            .iter()
            .filter_map(offset)
            .filter(|offset| *offset > 1e-9)
            .collect();
        offsets.sort_by(f64::total_cmp);
        let held = joints
            .iter()
            .filter_map(|joint| Some(joint.child.as_ref()?.value.clone()));
        Self {
            is_large: is_large(joints),
            median: offsets.get(offsets.len() / 2).copied().unwrap_or(0.0),
            held: held.collect(),
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
fn is_large(joints: &SharedList<Joint>) -> bool {
    let fixed: Vec<f64> = joints
        .iter()
        .filter(|joint| joint.is(&[JointType::Fixed]))
        .filter_map(offset)
        .collect();
    let far = fixed.iter().filter(|&&offset| offset > LARGE).count();
    fixed.len() >= MANY && 2 * fixed.len() > joints.len() && 2 * far > fixed.len()
}

/// Whether a joint places the robot in its surroundings: that may be anywhere.
fn is_placed(cx: &DocumentCx<'_>, joint: &Joint, held: &FastSet<EcoString>) -> bool {
    let Some(parent) = joint.parent.as_ref().map(|parent| parent.value.as_str()) else {
        return false;
    };
    is_surroundings(parent)
        // a root without a body stands for what is around the robot
        || !held.contains(parent)
            && cx.links_named(parent).next().is_some_and(|link| !link.has_geometry())
}
