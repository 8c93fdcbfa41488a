//! The scan of a workspace for descriptions: it goes on between other work, since a folder can be as large as the disk.
use std::path::PathBuf;

use super::session::Session;
use super::walk::Listing;
use base::limits::SCAN_FILES;

/// How far the scan is.
#[derive(Default)]
pub(super) struct Scan {
    /// The search for files, while it goes on.
    listing: Option<Listing>,
    /// Whether all files were found.
    is_listed: bool,
    /// Files that were found and not read yet, the next one last.
    pub waiting: Vec<PathBuf>,
}

impl Scan {
    /// Search again from the start.
    pub fn restart(&mut self) {
        self.is_listed = false;
        self.listing = None;
    }

    /// Whether all files were found and read.
    pub fn is_done(&self) -> bool {
        self.is_listed && self.waiting.is_empty()
    }

    /// Search for files until `stop` says so; returns whether all were found.
    pub fn list(
        &mut self,
        start: impl FnOnce() -> Listing,
        session: &Session,
        stop: &dyn Fn() -> bool,
    ) -> bool {
        if self.is_listed {
            return true;
        }
        let listing = self.listing.get_or_insert_with(start);
        if !listing.go_on(session, stop) {
            return false;
        }
        let found = self.listing.take().map_or_else(Vec::new, Listing::done);
        self.waiting = found.into_iter().take(SCAN_FILES).collect();
        self.waiting.reverse();
        self.is_listed = true;
        true
    }
}
