//! Packages and files of the workspace.

use super::registry::{Category::Package, Rule, Safety, Severity::Error, page};

/// The rules.
pub(super) static RULES: &[Rule] =
    &[Rule::found("PKG001", "package-not-found", Package, Error, page!("package-not-found")).fixed(Safety::Unsafe)];
