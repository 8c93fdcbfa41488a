//! Files: open buffers laid over the disk, file numbers, decoding, and caches of what was read.
//!
//! The only module of the library that touches the disk or the environment. Everything takes `&self`
//! and may be called from any thread.

// The file system is allowed here, and only here: this module is what the others use instead.
#![allow(clippy::disallowed_methods)]

mod cache;
mod decode;
mod environment;
mod error;
mod glob;
mod ids;
mod output;
mod read;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, PoisonError, RwLock};

pub use environment::Environment;
pub use error::{LoadError, LoadErrorKind};
pub use glob::has_magic;
pub use output::write_atomically;

use crate::base::{FastMap, FileId};
use crate::xml::Document;
use cache::Cache;
use ids::Ids;
use read::{Identity, Stamp};

/// Text of a file that is not XML.
#[derive(Debug)]
pub struct TextFile {
    /// Its number.
    pub id: FileId,
    /// Its absolute path.
    pub path: Arc<Path>,
    /// The decoded text, without a byte order mark.
    pub text: String,
    /// Hash of the decoded text.
    pub hash: u64,
    /// Byte offset in the file and description of the first byte that is not valid in its encoding.
    pub encoding_error: Option<(u32, String)>,
}

/// An XML file, parsed.
pub struct SourceFile {
    /// Its number.
    pub id: FileId,
    /// Its absolute path.
    pub path: Arc<Path>,
    /// The parsed text.
    pub document: Document,
    /// Hash of the decoded text.
    pub hash: u64,
    /// Byte offset in the file and description of the first byte that is not valid in its encoding.
    pub encoding_error: Option<(u32, String)>,
}

impl std::fmt::Debug for SourceFile {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SourceFile")
            .field("path", &self.path)
            .field("hash", &self.hash)
            .finish_non_exhaustive()
    }
}

/// One name in a folder.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct DirEntry {
    /// The name, without folder.
    pub name: String,
    /// Whether it is a folder, or a link to one.
    pub is_dir: bool,
}

/// An open editor buffer.
struct Buffer {
    text: Arc<str>,
    revision: u64,
    /// The file it stands for, if saved: finds the buffer again through links and `..`.
    identity: Option<Identity>,
}

/// Where the text of a file comes from.
enum Source {
    Buffer(Arc<str>),
    Disk,
}

/// Open buffers over the disk.
pub struct Vfs {
    max_file_bytes: AtomicU64,
    cwd: PathBuf,
    ids: Ids,
    buffers: RwLock<FastMap<FileId, Buffer>>,
    revision: AtomicU64,
    texts: Cache<TextFile>,
    documents: Cache<SourceFile>,
}

impl Vfs {
    /// A file system whose relative paths start at the working directory of the process. Files larger
    /// than `max_file_bytes` are not read.
    pub fn new(max_file_bytes: u64) -> Self {
        Self::with_cwd(max_file_bytes, std::env::current_dir().unwrap_or_default())
    }

    /// The same with relative paths starting at `cwd`.
    pub fn with_cwd(max_file_bytes: u64, cwd: PathBuf) -> Self {
        Self {
            max_file_bytes: AtomicU64::new(max_file_bytes),
            cwd,
            ids: Ids::default(),
            buffers: RwLock::default(),
            revision: AtomicU64::new(0),
            texts: Cache::default(),
            documents: Cache::default(),
        }
    }

    /// Change the size limit, in bytes; it holds for files that are not in a cache yet.
    pub fn set_max_file_bytes(&self, limit: u64) {
        self.max_file_bytes.store(limit, Ordering::Relaxed);
    }

    /// The number of a file, which need not exist. The path is made absolute by its text alone:
    /// `..` and links stay as they are, so two spellings of one file have two numbers.
    pub fn file_id(&self, path: &Path) -> FileId {
        self.ids.id(self.absolute(path))
    }

    /// The absolute path of a number given out by [`Vfs::file_id`].
    pub fn path(&self, id: FileId) -> Arc<Path> {
        self.ids.path(id)
    }

    /// `path` made absolute against the working directory, without `.` and doubled slashes.
    pub fn absolute(&self, path: &Path) -> PathBuf {
        self.cwd.join(path).components().collect()
    }

    /// `path` with links and `..` resolved; as given when it does not exist.
    pub fn canonical(&self, path: &Path) -> PathBuf {
        let path = self.absolute(path);
        std::fs::canonicalize(&path).unwrap_or(path)
    }

    /// Lay `text` over the file (an editor opened or changed it), or uncover the disk (`None`).
    pub fn set_buffer(&self, path: &Path, text: Option<String>) {
        let id = self.file_id(path);
        let mut buffers = self.buffers.write().unwrap_or_else(PoisonError::into_inner);
        match text {
            Some(text) => {
                let revision = self.revision.fetch_add(1, Ordering::Relaxed) + 1;
                let identity = read::stat(&self.path(id)).ok().and_then(|stat| stat.identity);
                buffers.insert(id, Buffer { text: text.into(), revision, identity });
            }
            None => {
                buffers.remove(&id);
            }
        }
    }

    /// The text of a file: from its buffer if open, else from the disk. Not read again while the file
    /// stays as it is.
    ///
    /// # Errors
    /// Whatever keeps the file from being read.
    pub fn text(&self, path: &Path) -> Result<Arc<TextFile>, LoadError> {
        let id = self.file_id(path);
        let path = self.path(id);
        let (stamp, source) = self.source(id, &path)?;
        self.texts.get(id, stamp, || {
            let decoded = self.decoded(&path, source)?;
            let hash = read::hash(&decoded.text);
            let decode::Decoded { text, error } = decoded;
            Ok(TextFile { id, path: path.clone(), text, hash, encoding_error: error })
        })
    }

    /// An XML file, parsed: from its buffer if open, else from the disk. Not parsed again while the
    /// file stays as it is.
    ///
    /// # Errors
    /// Whatever keeps the file from being read.
    pub fn document(&self, path: &Path) -> Result<Arc<SourceFile>, LoadError> {
        let id = self.file_id(path);
        let path = self.path(id);
        let (stamp, source) = self.source(id, &path)?;
        self.documents.get(id, stamp, || {
            let decode::Decoded { text, error } = self.decoded(&path, source)?;
            let hash = read::hash(&text);
            let document = Document::parse(&text);
            Ok(SourceFile { id, path: path.clone(), document, hash, encoding_error: error })
        })
    }

    /// Whether there is a file, folder or buffer at `path`.
    pub fn exists(&self, path: &Path) -> bool {
        self.has_buffer(path) || self.absolute(path).exists()
    }

    /// Whether there is a file (of any kind but a folder) or a buffer at `path`.
    pub fn is_file(&self, path: &Path) -> bool {
        self.has_buffer(path) || std::fs::metadata(self.absolute(path)).is_ok_and(|found| !found.is_dir())
    }

    /// Whether there is a folder at `path`.
    pub fn is_dir(&self, path: &Path) -> bool {
        self.absolute(path).is_dir()
    }

    /// What tells a file or folder from every other one, whatever path led to it; `None` when it does
    /// not exist.
    pub fn identity(&self, path: &Path) -> Option<u128> {
        let path = self.absolute(path);
        let stat = read::stat(&path).ok()?;
        Some(stat.identity.map_or_else(|| u128::from(read::hash(&self.canonical(&path))), Identity::number))
    }

    /// The names in a folder, sorted; none when it cannot be read. Names that are not UTF-8 are left
    /// out: no description can name them.
    pub fn list_dir(&self, path: &Path) -> Vec<DirEntry> {
        let Ok(entries) = std::fs::read_dir(self.absolute(path)) else { return Vec::new() };
        let mut names: Vec<DirEntry> = entries
            .flatten()
            .filter_map(|entry| {
                let kind = entry.file_type().ok()?;
                let is_dir = kind.is_dir() || kind.is_symlink() && entry.path().is_dir();
                Some(DirEntry { name: entry.file_name().into_string().ok()?, is_dir })
            })
            .collect();
        names.sort();
        names
    }

    /// The paths a pattern matches, sorted: what `sorted(glob.glob(pattern))` of Python 3.11 gives with
    /// `base` as working directory. The paths are spelled as the pattern spells its folders.
    pub fn glob(&self, pattern: &str, base: &Path) -> Vec<PathBuf> {
        glob::glob(self, pattern, &self.absolute(base))
    }

    fn has_buffer(&self, path: &Path) -> bool {
        let buffers = self.buffers.read().unwrap_or_else(PoisonError::into_inner);
        !buffers.is_empty() && buffers.contains_key(&self.file_id(path))
    }

    /// Where the text of `path` is, and the stamp that changes when it changes.
    fn source(&self, id: FileId, path: &Path) -> Result<(Stamp, Source), LoadError> {
        let buffers = self.buffers.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(buffer) = buffers.get(&id) {
            return Ok((Stamp::Buffer(buffer.revision), Source::Buffer(buffer.text.clone())));
        }
        let stat = read::stat(path)?;
        let alias = stat
            .identity
            .and_then(|identity| buffers.values().find(|buffer| buffer.identity == Some(identity)));
        Ok(match alias {
            Some(buffer) => (Stamp::Buffer(buffer.revision), Source::Buffer(buffer.text.clone())),
            None => (stat.stamp, Source::Disk),
        })
    }

    fn decoded(&self, path: &Path, source: Source) -> Result<decode::Decoded, LoadError> {
        match source {
            Source::Buffer(text) => Ok(decode::Decoded { text: text.to_string(), error: None }),
            Source::Disk => {
                read::bytes(path, self.max_file_bytes.load(Ordering::Relaxed)).map(decode::decode)
            }
        }
    }
}
