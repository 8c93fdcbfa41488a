//! What surrounds a robot: its configuration, what calls it, what a checkout of it lacks.

mod callers;
pub mod config;
mod include_pattern;
pub mod launch;
mod left_out;

pub use callers::{
    Caller, Callers, ControlNode, Era, Excluded, GivenArg, PublishedTransform, Purpose, RobotCall,
    SpawnedControllers, downloads_data, has_name, is_page, without_comments,
};
pub use include_pattern::{
    admitted_files, include_pattern, included_files, named_file, reached_files,
};
pub use left_out::{is_ignored_by_git, is_in_git_lfs};
