//! All origins of a document.
use model::{Joint, Link, Pose};

/// The names of the three angles.
pub(super) const ANGLES: [&str; 3] = ["roll", "pitch", "yaw"];

/// An origin and what it places.
pub struct ElementPose<'a> {
    /// The origin.
    pub(super) pose: &'a Pose,
    kind: &'static str,
    name: &'a str,
}

impl ElementPose<'_> {
    /// What is placed, for messages.
    pub(super) fn owner(&self) -> String {
        let Self { kind, name, .. } = self;
        if *kind == "joint" {
            format!("joint `{name}`")
        } else {
            format!("a {kind} of link `{name}`")
        }
    }
}

/// The origin of a joint.
pub(in super::super) fn pose_of_joint(joint: &Joint) -> Option<ElementPose<'_>> {
    Some(ElementPose {
        pose: joint.origin.as_ref()?,
        kind: "joint",
        name: joint.shown(),
    })
}

/// The origins of the inertia, the visuals and the collisions of a link.
pub(in super::super) fn poses_of_link(link: &Link) -> impl Iterator<Item = ElementPose<'_>> {
    let inertial = link
        .inertial
        .iter()
        .map(|inertial| ("inertial", &inertial.origin));
    let visuals = link.visuals.iter().map(|body| ("visual", &body.origin));
    let collisions = link.collisions.iter();
    let collisions = collisions.map(|body| ("collision", &body.origin));
    let all = inertial.chain(visuals).chain(collisions);
    all.filter_map(|(kind, pose)| {
        Some(ElementPose {
            pose: pose.as_ref()?,
            kind,
            name: link.shown(),
        })
    })
}
