//! The robots that a file may be for.
use std::path::PathBuf;

use super::super::root_config::RootConfig;

/// The robots that a file may be for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in super::super) struct Pairing {
    /// Their roots.
    pub roots: Vec<RootConfig>,
    /// Whether a file says so.
    pub is_named: bool,
    /// The SRDF through which a YAML file is for them: the only one in its package.
    pub srdf: Option<PathBuf>,
}

impl Pairing {
    pub fn named(mut roots: Vec<RootConfig>) -> Option<Self> {
        roots.dedup();
        roots.truncate(MOST_ROBOTS);
        (!roots.is_empty()).then_some(Self {
            roots,
            is_named: true,
            srdf: None,
        })
    }
}

/// Robots that one file is compared with.
pub(super) const MOST_ROBOTS: usize = 8;
