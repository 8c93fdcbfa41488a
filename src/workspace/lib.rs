//! What surrounds a file: the packages it can name, the workspace it lies in, its configuration.

mod belonging;
mod callers;
pub mod config;
mod distribution;
mod hardware;
mod include_pattern;
mod install;
pub mod launch;
mod left_out;
mod manifest;
mod memo;
mod namesakes;
mod packages;
mod root;
mod scan;
mod shell;
mod similar;
mod steps;
mod unbuilt;
mod uri;

#[cfg(test)]
mod tests;

pub use belonging::{UNQUOTED, Vicinity};
pub use callers::{
    Caller, Callers, Era, Excluded, GivenArg, RobotCall, has_name, without_comments,
};
pub use include_pattern::{admitted_files, include_pattern, included_files, named_file};
pub use install::{BUILD_FILES, Build, Built};
pub use packages::{Entry, Found, NotFound, Package, PackageOptions, Packages, Target};
pub use root::is_built;
pub use shell::RosVariable;
pub use similar::{edit_distance, misspelled, nearest};
pub use steps::Step;
pub use uri::{UriKind, UriOutcome, UriResult, percent_decoded};
