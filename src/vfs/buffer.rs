//! Open editor buffers.

use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use super::read::{self, Identity};
use super::{SourceFile, TextFile};
use base::{FileId, TextRange};

/// One state of an open buffer. Text and tree are made when first asked for, one from the other.
pub(super) struct Buffer {
    pub(super) id: FileId,
    path: Arc<Path>,
    /// Different for every state of every buffer.
    pub(super) revision: u64,
    /// The file it stands for, if saved: finds the buffer again through links and `..`.
    pub(super) identity: Option<Identity>,
    /// The text, as long as there is no tree: a tree holds its text.
    text: Mutex<Option<Arc<TextFile>>>,
    source: OnceLock<Arc<SourceFile>>,
}

impl Buffer {
    /// A buffer without content yet.
    fn new(id: FileId, path: Arc<Path>, revision: u64) -> Self {
        let identity = read::stat(&path).ok().and_then(|stat| stat.identity);
        Self {
            id,
            path,
            revision,
            identity,
            text: Mutex::default(),
            source: OnceLock::new(),
        }
    }

    /// A buffer that holds `text`.
    pub(super) fn with_text(id: FileId, path: Arc<Path>, revision: u64, text: String) -> Self {
        let buffer = Self::new(id, path, revision);
        let hash = read::hash(&text);
        *buffer.held_text() = Some(buffer.text_file(text, hash));
        buffer
    }

    /// A buffer with the tree that was read of its text.
    pub(super) fn with_source(revision: u64, source: Arc<SourceFile>) -> Self {
        let buffer = Self::new(source.id, source.path.clone(), revision);
        buffer.source.get_or_init(|| source);
        buffer
    }

    /// This buffer with the bytes of `range` replaced. A tree that was made is edited, so that it shares
    /// all that the edit did not touch.
    pub(super) fn edited(&self, revision: u64, range: TextRange, replacement: &str) -> Self {
        let Some(source) = self.source.get() else {
            let mut text = self.text().text.clone();
            let (start, end) = (range.start as usize, range.end as usize);
            if text.get(start..end).is_some() {
                text.replace_range(start..end, replacement);
            }
            return Self::with_text(self.id, self.path.clone(), revision, text);
        };
        let mut document = source.document.clone();
        document.edit(range, replacement);
        let source = SourceFile {
            id: self.id,
            path: self.path.clone(),
            document,
            // reading the whole text for a hash would cost more than the edit
            hash: read::hash(&("revision", revision)),
            encoding_error: None,
        };
        Self::with_source(revision, Arc::new(source))
    }

    /// This buffer with all of its text replaced; as an edit of what differs, if there is a tree.
    pub(super) fn replaced(&self, revision: u64, text: String) -> Self {
        if self.source.get().is_none() {
            return Self::with_text(self.id, self.path.clone(), revision, text);
        }
        let old = self.text();
        let (range, replacement) = difference(&old.text, &text);
        self.edited(revision, range, replacement)
    }

    /// The text.
    pub(super) fn text(&self) -> Arc<TextFile> {
        if let Some(text) = &*self.held_text() {
            return text.clone();
        }
        let source = self.source.get();
        let text = source
            .map(|source| source.document.text())
            .unwrap_or_default();
        self.text_file(text, source.map_or(0, |source| source.hash))
    }

    fn held_text(&self) -> MutexGuard<'_, Option<Arc<TextFile>>> {
        self.text.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The hash of the text, without making text or tree.
    pub(super) fn hash(&self) -> u64 {
        self.source
            .get()
            .map_or_else(|| self.text().hash, |source| source.hash)
    }

    /// The tree.
    pub(super) fn source(&self) -> Arc<SourceFile> {
        let source = self
            .source
            .get_or_init(|| SourceFile::parse(&self.text()))
            .clone();
        *self.held_text() = None;
        source
    }

    fn text_file(&self, text: String, hash: u64) -> Arc<TextFile> {
        let (id, path) = (self.id, self.path.clone());
        Arc::new(TextFile {
            id,
            path,
            text,
            hash,
            encoding_error: None,
        })
    }
}

/// The smallest edit that makes `new` of `old`.
fn difference<'n>(old: &str, new: &'n str) -> (TextRange, &'n str) {
    let same_start = old
        .bytes()
        .zip(new.bytes())
        .take_while(|(a, b)| a == b)
        .count();
    let mut start = same_start;
    while !(old.is_char_boundary(start) && new.is_char_boundary(start)) {
        start -= 1;
    }
    let most = old.len().min(new.len()) - start;
    let same_end = old
        .bytes()
        .rev()
        .zip(new.bytes().rev())
        .take(most)
        .take_while(|(a, b)| a == b)
        .count();
    let mut tail = same_end;
    while !(old.is_char_boundary(old.len() - tail) && new.is_char_boundary(new.len() - tail)) {
        tail -= 1;
    }
    let range = TextRange::new(start as u32, (old.len() - tail) as u32);
    (range, new.get(start..new.len() - tail).unwrap_or(""))
}

#[cfg(test)]
mod tests {
    use super::difference;

    #[test]
    fn differences() {
        let table = [
            ("abc", "abc", (3, 3, "")),
            ("abc", "abXc", (2, 2, "X")),
            ("abc", "ac", (1, 2, "")),
            ("aaa", "aa", (2, 3, "")),
            ("aa", "aaa", (2, 2, "a")),
            ("", "x", (0, 0, "x")),
            ("x", "", (0, 1, "")),
            ("aéb", "aèb", (1, 3, "è")),
            ("é", "ę", (0, 2, "ę")),
            ("日x", "曥x", (0, 3, "曥")),
        ];
        for (old, new, (start, end, text)) in table {
            let (range, replacement) = difference(old, new);
            assert_eq!(
                (range.start, range.end, replacement),
                (start, end, text),
                "{old} {new}"
            );
            let mut edited = old.to_owned();
            edited.replace_range(range.start as usize..range.end as usize, replacement);
            assert_eq!(edited, new);
        }
    }
}
