//! All origins of a document.
use super::super::context::DocumentCx;
use model::{Body, Pose};

/// The names of the three angles.
pub(super) const ANGLES: [&str; 3] = ["roll", "pitch", "yaw"];

/// An origin and what it places.
pub(super) struct ElementPose<'a> {
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

/// The origins of joints, visuals, collisions and inertias.
pub(super) fn poses<'a>(cx: &DocumentCx<'a>) -> Vec<ElementPose<'a>> {
    let Some(robot) = cx.robot else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for joint in &robot.joints {
        let placed = |pose| ElementPose {
            pose,
            kind: "joint",
            name: joint.shown(),
        };
        found.extend(joint.origin.as_ref().map(placed));
    }
    for link in &robot.links {
        let inertial = link
            .inertial
            .as_ref()
            .and_then(|inertial| inertial.origin.as_ref());
        found.extend(inertial.map(|pose| ElementPose {
            pose,
            kind: "inertial",
            name: link.shown(),
        }));
        let mut bodies = |kind, bodies: &'a [Body]| {
            let poses = bodies.iter().filter_map(|body| body.origin.as_ref());
            found.extend(poses.map(|pose| ElementPose {
                pose,
                kind,
                name: link.shown(),
            }));
        };
        bodies("visual", &link.visuals);
        bodies("collision", &link.collisions);
    }
    found
}
