//! What a file can name: the packages around it and those that are installed, and what lies in them.

mod cache;
mod container;
mod distribution;
mod hardware;
mod install;
mod manifest;
mod meant;
mod package_sources;
mod packages;
mod root;
mod scan;
mod shell;
mod similar;
mod similar_files;
mod sources;
mod trusted_paths;
mod unbuilt;
mod uri;

#[cfg(test)]
mod tests;

pub use cache::AnswerCache;
pub use container::workspace_of;
pub use install::{BUILD_FILES, Build, Built, RequiredSource};
pub use manifest::MANIFEST;
pub use package_sources::PackageSource;
pub use packages::{
    FoundPackage, NotFound, Package, PackageEntry, PackageOptions, Packages, RosVersion,
};
pub use root::{is_built, is_cache};
pub use shell::RosVariable;
pub use similar::{Suggestions, edit_distance, misspelled, nearest};
pub use trusted_paths::{TrustedPaths, UNQUOTED};
pub use uri::{UriKind, UriOutcome, UriResult, percent_decoded};
