//! Files beside robots that name their links and joints: SRDF, and YAML for controllers and MoveIt.

mod assistant;
mod edited;
mod files;
mod fitting;
mod judge;
mod otherwise;
mod paired;
mod pairing;

pub(super) use files::Robots;
pub use files::{Beside, is_settings};
pub(super) use files::{Sort, sort};
pub(super) use judge::ComparisonResult;
pub(super) use paired::Pairing;
pub(super) use pairing::stem;
