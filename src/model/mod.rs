//! The robot: links and joints of an expanded document, each with the text it came from.

mod kinematics;
mod robot;
mod source;
#[cfg(test)]
mod tests;

pub use kinematics::Kinematics;
pub use robot::{Joint, Link, Robot, Text};
pub use source::tag_start;
