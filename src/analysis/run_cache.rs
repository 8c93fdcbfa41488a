//! Expansions that were made, kept while the files that they read stay the same.
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use ecow::EcoString;

use base::{FastMap, TextRange};
use expand::{Forced, ProblemKind};
use vfs::Vfs;

/// One way to expand a robot.
#[derive(Clone, Default, PartialEq, Eq, Hash)]
pub(super) struct RunSetting {
    /// Arguments: names and values.
    pub args: Vec<(String, String)>,
    /// Conditions whose outcome is given.
    pub forced: Vec<Forced>,
}

/// What an expansion gave.
pub(super) struct RunResult {
    /// The expanded document.
    pub text: String,
    /// Whether it has errors.
    pub refused: bool,
    /// Its errors: code, file and place.
    pub failures: Vec<(ProblemKind, PathBuf, u32)>,
    /// The values of all arguments.
    pub arguments: Vec<(EcoString, EcoString)>,
    /// Where the macros stand that were called.
    pub called: Vec<(PathBuf, TextRange)>,
    /// The descriptions it is made of.
    pub files: Vec<PathBuf>,
    /// All texts it read, with their hashes.
    pub texts: Vec<(PathBuf, u64)>,
}

/// Bytes of expanded texts that are kept; beyond, robots are expanded again.
const MOST_BYTES: usize = 64 << 20;

/// What tells an expansion from others.
pub(super) type RunKey = (PathBuf, RunSetting);

/// Expansions that were made, while there is room.
#[derive(Default)]
pub(super) struct Runs(pub Mutex<CachedRuns>);

#[derive(Default)]
pub(super) struct CachedRuns {
    /// The last two of each: before and after the last change that was tried.
    pub by_key: FastMap<RunKey, Vec<Arc<RunResult>>>,
    pub bytes: usize,
}

impl CachedRuns {
    pub fn add(&mut self, key: RunKey, run: Arc<RunResult>) {
        if self.bytes > MOST_BYTES {
            *self = Self::default();
        }
        self.bytes += run.text.len();
        let own = self.by_key.entry(key).or_default();
        if own.len() > 1 {
            self.bytes -= own.remove(0).text.len();
        }
        own.push(run);
    }
}

impl RunResult {
    /// Whether the files that it read have the same texts as then.
    pub fn is_current(&self, vfs: &Vfs) -> bool {
        self.texts
            .iter()
            .all(|(path, hash)| vfs.document_hash(path) == Some(*hash))
    }

    /// The descriptions it is made of.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Whether a description takes part.
    pub fn reads(&self, path: &Path) -> bool {
        self.files.iter().any(|file| file == path)
    }

    /// Whether a macro was called that stands in a place.
    pub fn calls(&self, (path, range): &(PathBuf, TextRange)) -> bool {
        self.called
            .iter()
            .any(|(file, place)| file == path && range.contains_range(*place))
    }
}
