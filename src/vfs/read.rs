//! Questions to the disk: what is there, has it changed, what does it hold.

use std::fs::{File, Metadata};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Read;
use std::path::Path;
use std::time::{Duration, SystemTime};

use super::DirEntry;
use super::error::{LoadError, LoadErrorKind};
use base::paths::HERE;

/// A file written less than this before it was read may change again without a new time stamp.
const CLOCK_GRAIN: Duration = Duration::from_millis(100);

/// Device and file number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Identity {
    device: u64,
    inode: u64,
}

impl Identity {
    /// That of a folder in memory, by a hash of its path.
    pub(super) fn of_name(hash: u64) -> Self {
        Self {
            device: 0,
            inode: hash,
        }
    }

    /// Both in one.
    pub(super) fn number(self) -> u128 {
        u128::from(self.device) << 64 | u128::from(self.inode)
    }
}

/// What changes when the text of a file changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Stamp {
    /// Revision of an open buffer.
    Buffer(u64),
    /// Hash of the text itself.
    Content(u64),
    /// State of a file on disk.
    Disk {
        /// Time of the last change of the content.
        modified: Option<SystemTime>,
        /// Length in bytes.
        size: u64,
        /// Device, file number and time of the last change of the inode; 0 where unknown.
        node: (u128, i64, i64),
    },
}

impl Stamp {
    /// Whether text read now is sure to be told apart from text written later.
    pub(super) fn is_settled(&self) -> bool {
        match self {
            Stamp::Buffer(_) | Stamp::Content(_) => true,
            Stamp::Disk { modified, .. } => modified
                .and_then(|modified| SystemTime::now().duration_since(modified).ok())
                .is_some_and(|age| age > CLOCK_GRAIN),
        }
    }
}

/// What there is at a path, links followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EntryKind {
    Regular,
    Folder,
    /// A pipe, socket or device.
    Other,
}

/// The answer of [`stat`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Stat {
    /// What it is.
    pub(super) kind: EntryKind,
    /// Length in bytes.
    pub(super) size: u64,
    /// State of the content.
    pub(super) stamp: Stamp,
    /// Which file it is, where the system tells.
    pub(super) identity: Option<Identity>,
}

/// The state of a file or folder.
///
/// # Errors
/// When there is none, or none that may be looked at.
pub(super) fn stat(path: &Path) -> Result<Stat, LoadError> {
    if let Some(reason) = path.to_str().and_then(|text| HERE.refusal(text)) {
        return Err(LoadError::refused(reason, path));
    }
    let found = std::fs::metadata(path).map_err(|error| LoadError::from_io(&error, path))?;
    let (identity, changed) = node(path, &found);
    let number = identity.map_or(0, Identity::number);
    let size = found.len();
    let stamp = Stamp::Disk {
        modified: found.modified().ok(),
        size,
        node: (number, changed.0, changed.1),
    };
    Ok(Stat {
        kind: kind(&found),
        size,
        stamp,
        identity,
    })
}

fn kind(found: &Metadata) -> EntryKind {
    match (found.is_file(), found.is_dir()) {
        (true, _) => EntryKind::Regular,
        (_, true) => EntryKind::Folder,
        _ => EntryKind::Other,
    }
}

#[cfg(unix)]
fn node(_: &Path, found: &Metadata) -> (Option<Identity>, (i64, i64)) {
    use std::os::unix::fs::MetadataExt;
    let identity = Identity {
        device: found.dev(),
        inode: found.ino(),
    };
    (Some(identity), (found.ctime(), found.ctime_nsec()))
}

/// Volume and number of the file: names in other letters, links and junctions lead to the same ones.
#[cfg(windows)]
fn node(path: &Path, _: &Metadata) -> (Option<Identity>, (i64, i64)) {
    let handle = winapi_util::Handle::from_path_any(path);
    let found = handle
        .and_then(|handle| winapi_util::file::information(&handle))
        .ok();
    let identity = found.map(|found| Identity {
        device: found.volume_serial_number(),
        inode: found.file_index(),
    });
    (identity, (0, 0))
}

#[cfg(not(any(unix, windows)))]
fn node(_: &Path, _: &Metadata) -> (Option<Identity>, (i64, i64)) {
    (None, (0, 0))
}

/// The names in the folder at an absolute path, in the order of the disk, each looked at when it is asked for.
pub(super) fn entries(path: &Path) -> impl Iterator<Item = DirEntry> + use<> {
    let entries = std::fs::read_dir(path).into_iter().flatten().flatten();
    entries.filter_map(|entry| {
        let kind = entry.file_type().ok()?;
        let is_dir = kind.is_dir() || kind.is_symlink() && entry.path().is_dir();
        Some(DirEntry {
            name: entry.file_name().into_string().ok()?,
            is_dir,
        })
    })
}

/// The bytes of a regular file of at most `limit` bytes, `known` to be one since a moment ago.
///
/// # Errors
/// When it is not one, or cannot be read.
pub(super) fn bytes(path: &Path, known: &Stat, limit: u64) -> Result<Vec<u8>, LoadError> {
    let io = |error: std::io::Error| LoadError::from_io(&error, path);
    // opening a device may do something: what is none must not be opened
    may_be_read(known.kind, known.size, path, limit)?;
    let file = open(path).map_err(io)?;
    // it may have become something else in between
    let found = file.metadata().map_err(io)?;
    may_be_read(kind(&found), found.len(), path, limit)?;
    // Files of /proc and files that grow say a smaller size than they have.
    let mut bytes = Vec::with_capacity(usize::try_from(found.len()).unwrap_or(0));
    file.take(limit.saturating_add(1))
        .read_to_end(&mut bytes)
        .map_err(io)?;
    if bytes.len() as u64 > limit {
        return Err(LoadError::new(LoadErrorKind::TooLarge { limit }, path));
    }
    Ok(bytes)
}

/// Only regular files of at most `limit` bytes are read.
pub(super) fn may_be_read(
    kind: EntryKind,
    size: u64,
    path: &Path,
    limit: u64,
) -> Result<(), LoadError> {
    let kind = match kind {
        EntryKind::Regular if size <= limit => return Ok(()),
        EntryKind::Regular => LoadErrorKind::TooLarge { limit },
        EntryKind::Folder => LoadErrorKind::IsDirectory,
        EntryKind::Other => LoadErrorKind::NotRegular,
    };
    Err(LoadError::new(kind, path))
}

/// Open a file for reading. Some files of /proc say that they are regular and then let readers wait: those answer
/// that they would.
#[cfg(target_os = "linux")]
pub(super) fn open(path: &Path) -> std::io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt;
    /// `O_NONBLOCK` of Linux.
    const NON_BLOCKING: i32 = 0o4000;
    std::fs::OpenOptions::new()
        .read(true)
        .custom_flags(NON_BLOCKING)
        .open(path)
}

#[cfg(not(target_os = "linux"))]
pub(super) fn open(path: &Path) -> std::io::Result<File> {
    File::open(path)
}

/// A hash that is the same in every run of one build.
pub(super) fn hash(value: &(impl Hash + ?Sized)) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}
