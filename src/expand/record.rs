//! What an expansion read: the facts its result depends on.
use std::path::PathBuf;

use base::FastSet;

/// One thing that was read, or looked for and not found.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Read {
    /// A file, with the hash of its text.
    File(PathBuf, u64),
    /// A path at which a file was looked for; creating it changes the result.
    Missing(PathBuf),
    /// A folder listing (a wildcard include).
    Glob(String, Vec<PathBuf>),
    /// A package, and where it was found.
    Package(String, Option<PathBuf>),
    /// An environment variable, and its value.
    Env(String, Option<String>),
    /// An argument that was given from outside, and its value.
    Arg(String, Option<String>),
}

/// Everything an expansion read, in the order of the first reads.
#[derive(Clone, Debug, Default)]
pub struct Record {
    reads: Vec<Read>,
    seen: FastSet<Read>,
    /// Reads since the log was started, repeated ones too.
    log: Option<Vec<Read>>,
}

impl Record {
    /// Note a read.
    pub fn add(&mut self, read: Read) {
        if let Some(log) = &mut self.log
            && !log.contains(&read)
        {
            log.push(read.clone());
        }
        if self.seen.insert(read.clone()) {
            self.reads.push(read);
        }
    }

    pub(super) fn start_log(&mut self) {
        self.log = Some(Vec::new());
    }

    pub(super) fn take_log(&mut self) -> Vec<Read> {
        self.log.take().unwrap_or_default()
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.reads.len()
    }

    /// The reads in order.
    pub fn iter(&self) -> impl Iterator<Item = &Read> {
        self.reads.iter()
    }
}
