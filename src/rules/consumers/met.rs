//! A construct of the table, where a robot has it.
use super::table::Construct;
use expand::Origin;

/// A construct in a robot.
#[derive(Debug)]
pub struct Met {
    /// The row of the table.
    pub construct: &'static Construct,
    /// Where it is.
    pub origin: Origin,
    /// The thing that has it: "joint `elbow`".
    pub owner: String,
}
