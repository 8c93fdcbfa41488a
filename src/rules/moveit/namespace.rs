//! Names in a namespace.

/// A name without its namespace.
pub(super) fn last(name: &str) -> &str {
    name.rsplit('/').next().unwrap_or(name)
}
