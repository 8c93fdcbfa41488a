//! The numbers of rules that `thresholds.*` of the configuration can change.
use workspace::config::Config;

/// A number of a rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// Its name in the configuration; the unit is in the name.
    pub name: &'static str,
    /// Its value when nothing is configured.
    pub default: f64,
    /// What it bounds.
    pub docs: &'static str,
}

/// All thresholds, by name.
pub static THRESHOLDS: &[Threshold] = &[
    MAX_COLLISION_TRIANGLES,
    MAX_EXTENT,
    MAX_JOINT_OFFSET,
    MAX_JOINT_VELOCITY,
    MIN_EXTENT,
    WARN_COLLISION_TRIANGLES,
];

/// The longest way from one joint to the next, meters.
pub(super) const MAX_JOINT_OFFSET: Threshold = Threshold {
    name: "max-joint-offset-m",
    default: 20.0,
    docs: "the greatest length of a joint origin, in meters",
};

/// The fastest revolute joint, rad/s.
pub(super) const MAX_JOINT_VELOCITY: Threshold = Threshold {
    name: "max-joint-velocity-rad-per-s",
    default: 50.0,
    docs: "the highest velocity of a revolute joint, in rad/s",
};

pub(super) const MAX_COLLISION_TRIANGLES: Threshold = Threshold {
    name: "max-collision-triangles",
    default: 5000.0,
    docs: "Number of triangles a collision mesh may have.",
};

pub(super) const WARN_COLLISION_TRIANGLES: Threshold = Threshold {
    name: "warn-collision-triangles",
    default: 20_000.0,
    docs: "Number of triangles of a collision mesh above which the finding is a warning.",
};

pub(super) const MAX_EXTENT: Threshold = Threshold {
    name: "max-extent-m",
    default: 10.0,
    docs: "Greatest length of a mesh along an axis, in meters.",
};

pub(super) const MIN_EXTENT: Threshold = Threshold {
    name: "min-extent-m",
    default: 1e-4,
    docs: "Least length of a mesh along its longest axis, in meters.",
};

impl Threshold {
    /// The value that holds under a configuration.
    pub fn value(&self, config: &Config) -> f64 {
        config
            .thresholds
            .get(self.name)
            .copied()
            .unwrap_or(self.default)
    }
}
