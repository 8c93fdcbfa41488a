//! Packages and files of the workspace.

mod package_not_found;

use super::registry::Rule;

pub(super) use package_not_found::is_news;

/// The rules.
pub(super) static RULES: &[Rule] = &[package_not_found::RULE];
