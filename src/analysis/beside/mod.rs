//! Files beside robots that name their links and joints: SRDF, and YAML for controllers and MoveIt.

mod around;
mod assistant;
mod compare;
mod edited;
mod files;
mod fitting;
mod otherwise;
mod paired;
mod pairing;
mod robots;
mod said;
mod sort;
mod spelled;

pub use around::files_beside;
pub(super) use around::{beside_files, beside_roots};
pub(super) use compare::{ComparisonResult, beside_findings, is_in_launched};
pub(super) use edited::shown_beside_findings;
pub use edited::{read_file_beside, read_files_beside, robots_beside, robots_to_name};
pub use files::Beside;
pub(super) use files::Robots;
pub(super) use paired::Pairing;
pub(super) use pairing::{is_for_manager, is_named_as_launched, is_one_of_several, pairing_of};
pub(super) use robots::{extended, robot_name, stem};
pub(super) use said::said_to_others;
pub use sort::is_settings;
pub(super) use sort::{Sort, beside_around, beside_settings, sort};
