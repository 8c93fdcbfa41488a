//! What surrounds a file: the packages it can name, the workspace it lies in, its configuration.

mod cache;
mod callers;
pub mod config;
mod distribution;
mod hardware;
mod include_pattern;
mod install;
pub mod launch;
mod left_out;
mod manifest;
mod package_sources;
mod packages;
mod root;
mod scan;
mod shell;
mod similar;
mod similar_files;
mod trusted_paths;
mod unbuilt;
mod uri;

#[cfg(test)]
mod tests;

pub use callers::{
    Caller, Callers, Era, Excluded, GivenArg, RobotCall, has_name, without_comments,
};
pub use include_pattern::{admitted_files, include_pattern, included_files, named_file};
pub use install::{BUILD_FILES, Build, Built};
pub use package_sources::PackageSource;
pub use packages::{
    FoundPackage, NotFound, Package, PackageEntry, PackageOptions, Packages, RosVersion,
};
pub use root::is_built;
pub use shell::RosVariable;
pub use similar::{edit_distance, misspelled, nearest};
pub use trusted_paths::{TrustedPaths, UNQUOTED};
pub use uri::{UriKind, UriOutcome, UriResult, percent_decoded};
