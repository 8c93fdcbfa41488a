//! Files beside robots that name their links and joints: SRDF, and YAML for controllers and MoveIt.

mod assistant;
mod compare;
mod edited;
mod files;
mod fitting;
mod otherwise;
mod paired;
mod pairing;
mod spelled;

pub(super) use compare::ComparisonResult;
pub(super) use files::Robots;
pub use files::{Beside, is_settings};
pub(super) use files::{Sort, sort};
pub(super) use paired::Pairing;
pub(super) use pairing::stem;
