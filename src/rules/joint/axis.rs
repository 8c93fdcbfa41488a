//! Axes of joints, as numbers.
use model::{AttrValue, Joint, JointType};

/// What counts as no length at all.
pub(super) const NO_LENGTH: f64 = 1e-9;

/// Whether a joint moves about or along its axis. Fixed joints often carry a zero axis.
pub(super) fn moves(joint: &Joint) -> bool {
    joint
        .joint_type()
        .is_some_and(|kind| kind.has_axis() || kind == JointType::Planar)
}

/// The axis of a joint that moves, when it is written and known.
pub(super) fn moving_axis(joint: &Joint) -> Option<(&AttrValue, [f64; 3])> {
    let text = joint.axis.as_ref()?.xyz.as_ref()?;
    Some((text, text.numbers().filter(|_| moves(joint))?))
}

/// The length of a vector.
pub(super) fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
