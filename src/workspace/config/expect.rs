//! What is expected of the robots that a root gives.

use serde_json::Value;

use super::ConfigLocation;
use super::roots::Axes;

/// Tolerance of numbers for which none is given: kg, radians, meters, N m, N, rad/s or m/s.
pub(super) const TOLERANCE: f64 = 0.001;

/// One `[[roots.expect]]` entry. In names and paths, `$(arg NAME)` stands for the value of an argument.
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    /// Where the entry is.
    pub place: ConfigLocation,
    /// Its name.
    pub name: Option<String>,
    /// It applies to robots whose arguments have these values.
    pub when: Axes,
    /// The root link.
    pub root: Option<String>,
    /// Links that exist.
    pub links: Vec<String>,
    /// Links that do not exist.
    pub no_links: Vec<String>,
    /// Joints that exist.
    pub joints: Vec<String>,
    /// Joints that do not exist.
    pub no_joints: Vec<String>,
    /// Number of links.
    pub link_count: Option<usize>,
    /// Number of joints.
    pub joint_count: Option<usize>,
    /// Number of joints that are not fixed.
    pub moving_joint_count: Option<usize>,
    /// Links of which each is below the previous one.
    pub chains: Vec<Vec<String>>,
    /// Total mass, kg.
    pub mass: Option<f64>,
    /// Tolerance of the mass, kg.
    pub mass_tolerance: f64,
    /// Properties of joints, by name.
    pub joint: Vec<(String, ExpectedJoint)>,
    /// All command interfaces of joints.
    pub command_interfaces: Vec<(String, Vec<String>)>,
    /// All state interfaces of joints.
    pub state_interfaces: Vec<(String, Vec<String>)>,
    /// A file that describes the same robot.
    pub expands_to: Option<String>,
    /// The entry as it is written.
    pub(super) written: Value,
}

impl Expectation {
    /// An entry that expects nothing.
    pub(super) fn new(place: ConfigLocation, written: Value) -> Self {
        Self {
            place,
            name: None,
            when: Axes::new(),
            root: None,
            links: Vec::new(),
            no_links: Vec::new(),
            joints: Vec::new(),
            no_joints: Vec::new(),
            link_count: None,
            joint_count: None,
            moving_joint_count: None,
            chains: Vec::new(),
            mass: None,
            mass_tolerance: TOLERANCE,
            joint: Vec::new(),
            command_interfaces: Vec::new(),
            state_interfaces: Vec::new(),
            expands_to: None,
            written,
        }
    }
}

/// What is expected of one joint.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedJoint {
    /// Its type.
    pub kind: Option<String>,
    /// Its parent link.
    pub parent: Option<String>,
    /// Its child link.
    pub child: Option<String>,
    /// The joint that it mimics.
    pub mimic: Option<String>,
    /// Its lower limit: radians or meters.
    pub lower: Option<f64>,
    /// Its upper limit: radians or meters.
    pub upper: Option<f64>,
    /// Its effort limit: N m or N.
    pub effort: Option<f64>,
    /// Its velocity limit: rad/s or m/s.
    pub velocity: Option<f64>,
    /// Tolerance of the limits.
    pub tolerance: f64,
}

impl Default for ExpectedJoint {
    fn default() -> Self {
        Self {
            kind: None,
            parent: None,
            child: None,
            mimic: None,
            lower: None,
            upper: None,
            effort: None,
            velocity: None,
            tolerance: TOLERANCE,
        }
    }
}
