//! Files beside robots that name their links and joints: SRDF, and YAML for controllers and MoveIt.

mod assistant;
mod edited;
mod files;
mod judge;
mod otherwise;
mod pairing;

pub use files::{Beside, is_settings};
pub(super) use files::{Sort, sort};
pub(super) use judge::{Compared, Robots};
pub(super) use pairing::{Pairing, stem};
