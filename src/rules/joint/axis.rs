//! Axes of joints, as numbers.
use model::{AttrValue, Joint, JointType};

/// What counts as no length at all.
pub(super) const NO_LENGTH: f64 = 1e-9;

/// The axes of joints that move, as far as they are written and known. Fixed joints often carry a zero axis.
pub(super) fn moving_axes(
    joints: &[Joint],
) -> impl Iterator<Item = (&Joint, &AttrValue, [f64; 3])> {
    let moving = |joint: &&Joint| {
        joint
            .joint_type()
            .is_some_and(|kind| kind.has_axis() || kind == JointType::Planar)
    };
    joints.iter().filter(moving).filter_map(|joint| {
        let text = joint.axis.as_ref()?.xyz.as_ref()?;
        Some((joint, text, text.numbers()?))
    })
}

/// The length of a vector.
pub(super) fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
