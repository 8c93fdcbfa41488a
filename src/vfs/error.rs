//! Why a file could not be read, in the words of the operating system.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use super::relative::slashed;

/// Classes of load errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadErrorKind {
    /// Nothing there.
    NotFound,
    /// A folder.
    IsDirectory,
    /// No permission.
    PermissionDenied,
    /// A pipe, socket or device: reading one might never end.
    NotRegular,
    /// More bytes than the limit.
    TooLarge {
        /// The limit, in bytes.
        limit: u64,
    },
    /// Anything else.
    Other,
}

/// A file that could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadError {
    /// The class.
    pub kind: LoadErrorKind,
    /// The error number of Linux.
    pub errno: i32,
    /// What `strerror` says of it, e.g. "No such file or directory".
    pub strerror: String,
    /// The path that was tried.
    pub path: PathBuf,
}

impl LoadError {
    /// An error of our own making.
    pub(super) fn new(kind: LoadErrorKind, path: &Path) -> Self {
        let (errno, strerror) = match kind {
            LoadErrorKind::NotFound => (2, "No such file or directory"),
            LoadErrorKind::PermissionDenied => (13, "Permission denied"),
            LoadErrorKind::IsDirectory => (21, "Is a directory"),
            LoadErrorKind::NotRegular => (22, "Not a regular file"),
            LoadErrorKind::TooLarge { .. } => (27, "File too large"),
            LoadErrorKind::Other => (5, "Input/output error"),
        };
        Self {
            kind,
            errno,
            strerror: strerror.to_owned(),
            path: path.to_owned(),
        }
    }

    /// A path that is no name of a file here, and why.
    pub(super) fn refused(reason: &str, path: &Path) -> Self {
        Self {
            kind: LoadErrorKind::Other,
            errno: 22,
            strerror: reason.to_owned(),
            path: path.to_owned(),
        }
    }

    /// A file of which only the name is known.
    pub(super) fn elsewhere(path: &Path) -> Self {
        Self {
            kind: LoadErrorKind::Other,
            errno: 5,
            strerror: "its content was not loaded".to_owned(),
            path: path.to_owned(),
        }
    }

    /// The reason in words: for a file that is too large with the limit.
    pub fn reason(&self) -> String {
        match self.kind {
            LoadErrorKind::TooLarge { limit } => {
                format!("it has more than {} MB, the limit", limit / 1_000_000)
            }
            _ => self.strerror.clone(),
        }
    }

    /// The same for an error of the system.
    pub fn from_io(error: &io::Error, path: &Path) -> Self {
        let kind = match error.kind() {
            io::ErrorKind::NotFound => LoadErrorKind::NotFound,
            io::ErrorKind::PermissionDenied => LoadErrorKind::PermissionDenied,
            io::ErrorKind::IsADirectory => LoadErrorKind::IsDirectory,
            _ => LoadErrorKind::Other,
        };
        if kind != LoadErrorKind::Other {
            return Self::new(kind, path);
        }
        let text = error.to_string();
        let strerror = text
            .split(" (os error")
            .next()
            .unwrap_or_default()
            .to_owned();
        Self {
            kind,
            errno: error.raw_os_error().unwrap_or(22),
            strerror,
            path: path.to_owned(),
        }
    }
}

impl fmt::Display for LoadError {
    /// As Python prints an `OSError`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "[Errno {}] {}: '{}'",
            self.errno,
            self.strerror,
            slashed(&self.path)
        )
    }
}

impl std::error::Error for LoadError {}
