//! Files: open buffers laid over the disk, file numbers, decoding, and caches of what was read.
//!
//! The only module of the library that touches the disk or the environment. Everything takes `&self`
//! and may be called from any thread.

// The file system is allowed here, and only here: this module is what the others use instead.
#![allow(clippy::disallowed_methods)]

mod buffer;
mod cache;
mod decode;
mod derived;
mod disk;
mod environment;
mod error;
mod glob;
mod ids;
mod memory;
mod output;
mod process;
mod read;
mod relative;
mod stat_cache;
#[doc(hidden)]
pub mod testing;
#[cfg(test)]
mod tests;

use std::path::{Component, Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, PoisonError, RwLock};

pub use derived::{FileCache, text_of};
pub use environment::Environment;
pub use error::{LoadError, LoadErrorKind};
pub use glob::{TooMany, Wildcard, covers, has_magic};
pub use output::write_atomically;
pub use process::{first_stack, is_process_alive, unbuffered_stdout};
use relative::is_tidy;
pub use relative::{relative, shown_path, slashed, spelled, without_parents};
pub use stat_cache::StatSnapshot;

use base::{FastMap, FileId, TextRange};
use buffer::Buffer;
use cache::Cache;
use disk::Disk;
use ids::Ids;
use read::{EntryKind, Identity, Stamp, Stat};
use stat_cache::StatCache;
use xml::Document;
use yaml::{self, YamlError, YamlNode};

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
    /// The tree, which holds the text.
    pub document: Document,
    /// Equal hashes mean equal texts; in an edited buffer, equal texts may have different ones.
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

impl SourceFile {
    fn parse(file: &TextFile) -> Arc<Self> {
        Arc::new(Self {
            id: file.id,
            path: file.path.clone(),
            document: Document::parse(&file.text),
            hash: file.hash,
            encoding_error: file.encoding_error.clone(),
        })
    }
}

/// A YAML file, loaded.
pub struct YamlFile {
    /// The text.
    pub file: Arc<TextFile>,
    /// Its value, or the error Python would raise.
    pub value: Result<YamlNode, YamlError>,
}

impl YamlFile {
    fn load(file: Arc<TextFile>, name: &str) -> Self {
        let value = match &file.encoding_error {
            Some((_, message)) => {
                let range = TextRange::default();
                Err(YamlError {
                    message: message.clone(),
                    range,
                    short: message.clone(),
                })
            }
            None => yaml::load(&file.text, name),
        };
        Self { file, value }
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

/// Where the text of a file comes from.
enum TextSource {
    Buffer(Arc<Buffer>),
    Disk(Stat),
}

/// Open buffers over the disk.
pub struct Vfs {
    max_file_bytes: AtomicU64,
    cwd: PathBuf,
    buffers: RwLock<FastMap<FileId, Arc<Buffer>>>,
    shared: Arc<SharedState>,
}

/// What an overlay has in common with the files below it.
#[derive(Default)]
struct SharedState {
    ids: Ids,
    revision: AtomicU64,
    disk: Disk,
    texts: Cache<TextFile>,
    sources: Cache<SourceFile>,
    yaml: Cache<YamlFile>,
    folders: Cache<Vec<DirEntry>>,
    stats: StatCache,
}

impl Vfs {
    /// A file system whose relative paths start at the working directory of the process. Files larger
    /// than `max_file_bytes` are not read.
    pub fn new(max_file_bytes: u64) -> Self {
        Self::with_cwd(
            max_file_bytes,
            spelled(std::env::current_dir().unwrap_or_default()),
        )
    }

    /// The same with relative paths starting at `cwd`.
    pub fn with_cwd(max_file_bytes: u64, cwd: PathBuf) -> Self {
        Self {
            max_file_bytes: AtomicU64::new(max_file_bytes),
            cwd,
            buffers: RwLock::default(),
            shared: Arc::default(),
        }
    }

    /// The files that a run sees: relative paths start at its working directory.
    pub fn of(env: &Environment, max_file_bytes: u64) -> Self {
        let shared = Arc::new(SharedState {
            disk: Disk::within(&env.within),
            ..SharedState::default()
        });
        Self {
            shared,
            ..Self::with_cwd(max_file_bytes, env.cwd.clone())
        }
    }

    /// These files as they would be with other texts. The original is not touched, whatever becomes of the overlay; file
    /// numbers are the same in both.
    pub fn overlay(&self, texts: impl IntoIterator<Item = (PathBuf, String)>) -> Self {
        let buffers = self
            .buffers
            .read()
            .unwrap_or_else(PoisonError::into_inner)
            .clone();
        let overlay = Self {
            max_file_bytes: AtomicU64::new(self.max_file_bytes.load(Ordering::Relaxed)),
            cwd: self.cwd.clone(),
            buffers: RwLock::new(buffers),
            shared: self.shared.clone(),
        };
        for (path, text) in texts {
            overlay.set_buffer(&path, Some(text));
        }
        overlay
    }

    /// Change the size limit, in bytes; it holds for files that are not in a cache yet.
    pub fn set_max_file_bytes(&self, limit: u64) {
        self.max_file_bytes.store(limit, Ordering::Relaxed);
    }

    /// The number of a file, which need not exist. Links stay as they are, so two spellings of one file may have two
    /// numbers.
    pub fn file_id(&self, path: &Path) -> FileId {
        self.shared.ids.id(self.absolute(path))
    }

    /// The absolute path of a number given out by [`Vfs::file_id`].
    pub fn path(&self, id: FileId) -> Arc<Path> {
        self.shared.ids.path(id)
    }

    /// `path` made absolute against the working directory, without `.` and doubled slashes; and without `folder/..`
    /// where that is a folder and no link, so that a file included as `../parts/a.xacro` is the one that is open.
    pub fn absolute(&self, path: &Path) -> PathBuf {
        if is_tidy(path) {
            return path.to_owned();
        }
        let path: PathBuf = self.cwd.join(path).components().collect();
        let leads_back = path.components().any(|part| part == Component::ParentDir);
        spelled(if leads_back {
            tidy(&path, &self.shared.disk)
        } else {
            path
        })
    }

    /// `path` with links and `..` resolved; as given when it does not exist.
    pub fn canonical(&self, path: &Path) -> PathBuf {
        let path = self.absolute(path);
        self.shared.disk.canonical(&path).map_or(path, spelled)
    }

    /// Whether there is a folder at `path` that is no link to one.
    pub fn is_own_folder(&self, path: &Path) -> bool {
        self.shared.disk.is_own_folder(path)
    }

    /// Write `after` into a file that holds `before`, whatever is laid over it; a byte order mark stays.
    ///
    /// # Errors
    /// When the file holds something else, or something other than UTF-8; and those of the system.
    pub fn rewrite(&self, path: &Path, before: &str, after: &str) -> std::io::Result<()> {
        const MARK: &[u8] = b"\xEF\xBB\xBF";
        output::change(
            &self.absolute(path),
            self.max_file_bytes.load(Ordering::Relaxed),
            |old| {
                let (mark, text) = if old.starts_with(MARK) {
                    old.split_at(MARK.len())
                } else {
                    old.split_at(0)
                };
                if text == before.as_bytes() {
                    return Ok(Some([mark, after.as_bytes()].concat()));
                }
                if text == after.as_bytes() {
                    // another run was faster
                    return Ok(None);
                }
                let is_utf8 = std::str::from_utf8(text).is_ok();
                let why = if is_utf8 {
                    "it was changed by another program"
                } else {
                    "it is not UTF-8"
                };
                Err(std::io::Error::new(std::io::ErrorKind::InvalidData, why))
            },
        )
    }

    /// Lay `text` over the file (an editor opened or changed it), or uncover the disk (`None`).
    pub fn set_buffer(&self, path: &Path, text: Option<String>) {
        let id = self.file_id(path);
        let mut buffers = self.buffers.write().unwrap_or_else(PoisonError::into_inner);
        let Some(text) = text else {
            buffers.remove(&id);
            return;
        };
        let revision = self.next_revision();
        let buffer = match buffers.get(&id) {
            Some(buffer) => buffer.replaced(revision, text),
            None => self.opened(id, revision, text),
        };
        buffers.insert(id, Arc::new(buffer));
    }

    /// A new buffer. Mostly its text is the one on disk, whose tree it shares then.
    fn opened(&self, id: FileId, revision: u64, text: String) -> Buffer {
        let is_same = |known: &Arc<SourceFile>| {
            known.encoding_error.is_none() && known.hash == read::hash(&text)
        };
        match self.shared.sources.latest(id).filter(is_same) {
            Some(known) => Buffer::with_source(revision, known),
            None => Buffer::with_text(id, self.path(id), revision, text),
        }
    }

    /// Replace the bytes of `range` in an open buffer; nothing happens when there is none.
    pub fn edit_buffer(&self, path: &Path, range: TextRange, replacement: &str) {
        let id = self.file_id(path);
        let mut buffers = self.buffers.write().unwrap_or_else(PoisonError::into_inner);
        if let Some(buffer) = buffers.get_mut(&id) {
            *buffer = Arc::new(buffer.edited(self.next_revision(), range, replacement));
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
        match self.state(id, &path)? {
            TextSource::Buffer(buffer) if buffer.id == id => Ok(buffer.text()),
            TextSource::Buffer(buffer) => {
                self.shared
                    .texts
                    .get(id, Stamp::Buffer(buffer.revision), || {
                        let file = buffer.text();
                        let (text, hash) = (file.text.clone(), file.hash);
                        Ok(Arc::new(TextFile {
                            id,
                            path,
                            text,
                            hash,
                            encoding_error: None,
                        }))
                    })
            }
            TextSource::Disk(stat) => self
                .shared
                .texts
                .get(id, stat.stamp, || self.read(id, &path, &stat).map(Arc::new)),
        }
    }

    fn read(&self, id: FileId, path: &Arc<Path>, known: &Stat) -> Result<TextFile, LoadError> {
        let limit = self.max_file_bytes.load(Ordering::Relaxed);
        let decode::DecodedText { text, error } =
            decode::decode(self.shared.disk.bytes(path, known, limit)?);
        let hash = read::hash(&text);
        Ok(TextFile {
            id,
            path: path.clone(),
            text,
            hash,
            encoding_error: error,
        })
    }

    /// An XML file, parsed; not again while its text stays the same. Of a buffer that was edited, only
    /// what the edit touched is parsed.
    ///
    /// # Errors
    /// Whatever keeps the file from being read. What is wrong with the XML stands in the document.
    pub fn document(&self, path: &Path) -> Result<Arc<SourceFile>, LoadError> {
        let id = self.file_id(path);
        let path = self.path(id);
        match self.state(id, &path)? {
            TextSource::Buffer(buffer) if buffer.id == id => Ok(buffer.source()),
            TextSource::Buffer(buffer) => {
                self.shared
                    .sources
                    .get(id, Stamp::Buffer(buffer.revision), || {
                        let source = buffer.source();
                        let (document, hash) = (source.document.clone(), source.hash);
                        Ok(Arc::new(SourceFile {
                            id,
                            path,
                            document,
                            hash,
                            encoding_error: None,
                        }))
                    })
            }
            // the document holds the text: it need not be kept a second time
            TextSource::Disk(stat) if stat.stamp.is_settled() => {
                self.shared.sources.get(id, stat.stamp, || {
                    Ok(SourceFile::parse(&self.read(id, &path, &stat)?))
                })
            }
            TextSource::Disk(_) => {
                let text = self.text(&path)?;
                self.shared.sources.get(id, Stamp::Content(text.hash), || {
                    Ok(SourceFile::parse(&text))
                })
            }
        }
    }

    /// The hash of the text of a file, as [`TextFile::hash`] and [`SourceFile::hash`] have it; none when it
    /// cannot be read.
    pub fn document_hash(&self, path: &Path) -> Option<u64> {
        let id = self.file_id(path);
        match self.state(id, &self.path(id)).ok()? {
            TextSource::Buffer(buffer) => Some(buffer.hash()),
            TextSource::Disk(stat) if self.shared.sources.knows(id, stat.stamp) => {
                Some(self.document(path).ok()?.hash)
            }
            TextSource::Disk(_) => Some(self.text(path).ok()?.hash),
        }
    }

    /// A YAML file, loaded; not again while its text stays the same. `name` is its name in messages.
    ///
    /// # Errors
    /// Whatever keeps the file from being read. What is wrong with the YAML is in the value.
    pub fn yaml(&self, path: &Path, name: &str) -> Result<Arc<YamlFile>, LoadError> {
        let file = self.text(path)?;
        let stamp = Stamp::Content(read::hash(&(file.hash, name)));
        self.shared
            .yaml
            .get(file.id, stamp, || Ok(Arc::new(YamlFile::load(file, name))))
    }

    /// A number that changes when the content of a file on disk does, or when it comes or goes.
    pub fn state_on_disk(&self, path: &Path) -> u64 {
        self.shared
            .disk
            .stat(&self.absolute(path))
            .map_or(0, |stat| read::hash(&stat.stamp))
    }

    /// Whether there is a file, folder or buffer at `path`.
    pub fn exists(&self, path: &Path) -> bool {
        self.has_buffer(path) || self.stat_at(path).is_some()
    }

    /// Whether there is anything at `path`, be it a link that leads nowhere.
    pub fn is_present(&self, path: &Path) -> bool {
        let path = self.absolute(path);
        self.exists(&path) || self.shared.disk.is_present(&path)
    }

    /// Whether there is a file (of any kind but a folder) or a buffer at `path`.
    pub fn is_file(&self, path: &Path) -> bool {
        self.has_buffer(path)
            || self
                .stat_at(path)
                .is_some_and(|found| found.kind != EntryKind::Folder)
    }

    /// Whether there is a folder at `path`.
    pub fn is_dir(&self, path: &Path) -> bool {
        self.stat_at(path)
            .is_some_and(|found| found.kind == EntryKind::Folder)
    }

    /// The size of a file on the disk, in bytes.
    pub fn size(&self, path: &Path) -> Option<u64> {
        let found = self.stat_at(path)?;
        (found.kind == EntryKind::Regular).then_some(found.size)
    }

    /// What tells a file or folder from every other one, whatever path led to it; `None` when it does
    /// not exist.
    pub fn identity(&self, path: &Path) -> Option<u128> {
        let stat = self.stat_at(path)?;
        Some(stat.identity.map_or_else(
            || u128::from(read::hash(&self.canonical(path))),
            Identity::number,
        ))
    }

    /// The names in a folder, sorted; none when it cannot be read. Names that are not UTF-8 are left
    /// out: no description can name them.
    pub fn list_dir(&self, path: &Path) -> Arc<Vec<DirEntry>> {
        let path = self.absolute(path);
        self.listed(path, |path| {
            let mut names: Vec<DirEntry> = self.shared.disk.entries(path).collect();
            names.sort();
            names
        })
    }

    /// The paths a pattern matches, sorted: what `sorted(glob.glob(pattern))` of Python 3.11 gives with
    /// `base` as working directory. The paths are spelled as the pattern spells its folders. At most `left` entries
    /// of folders are looked at; afterwards it says how many are left.
    ///
    /// # Errors
    /// When it matches too much, or more would have to be looked at.
    pub fn glob(
        &self,
        pattern: &str,
        base: &Path,
        left: &mut usize,
    ) -> Result<Vec<PathBuf>, TooMany> {
        glob::glob(self, pattern, &self.absolute(base), left)
    }

    fn has_buffer(&self, path: &Path) -> bool {
        let buffers = self.buffers.read().unwrap_or_else(PoisonError::into_inner);
        !buffers.is_empty() && buffers.contains_key(&self.file_id(path))
    }

    fn next_revision(&self) -> u64 {
        self.shared.revision.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Where the text of `path` is now.
    fn state(&self, id: FileId, path: &Path) -> Result<TextSource, LoadError> {
        let buffers = self.buffers.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(buffer) = buffers.get(&id) {
            return Ok(TextSource::Buffer(buffer.clone()));
        }
        let stat = self.stat(id, path)?;
        let is_same =
            |buffer: &&Arc<Buffer>| stat.identity.is_some() && buffer.identity == stat.identity;
        Ok(match buffers.values().find(is_same) {
            Some(buffer) => TextSource::Buffer(buffer.clone()),
            None => TextSource::Disk(stat),
        })
    }
}

/// A path without `folder/..`, where the system sees it so too: a link leads elsewhere, and nothing leads back from a
/// folder that is not there.
fn tidy(path: &Path, disk: &Disk) -> PathBuf {
    let mut tidy = PathBuf::new();
    for part in path.components() {
        let leads_back =
            part == Component::ParentDir && tidy.file_name().is_some() && disk.is_own_folder(&tidy);
        if leads_back {
            tidy.pop();
        } else {
            tidy.push(part);
        }
    }
    tidy
}
