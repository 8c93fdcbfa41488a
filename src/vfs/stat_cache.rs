//! Answers of the disk that are kept for some time, in which files are assumed not to change.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::error::LoadError;
use super::read::Stat;
use super::{DirEntry, Vfs};
use base::{FastMap, FileId};

/// What was asked about files since somebody began to hold them.
#[derive(Default)]
pub(super) struct StatCache(Mutex<Answers>);

#[derive(Default)]
struct Answers {
    /// How many hold.
    holders: usize,
    known: FastMap<FileId, Result<Stat, LoadError>>,
    listed: FastMap<FileId, Arc<Vec<DirEntry>>>,
}

/// As long as this lives, the disk is asked once about each file and folder.
pub struct StatSnapshot<'a>(&'a Vfs);

impl Drop for StatSnapshot<'_> {
    fn drop(&mut self) {
        self.0.shared.stats.with(|answers| {
            answers.holders -= 1;
            if answers.holders == 0 {
                *answers = Answers::default();
            }
        });
    }
}

impl StatCache {
    fn with<T>(&self, work: impl FnOnce(&mut Answers) -> T) -> T {
        work(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn are_held(&self) -> bool {
        self.with(|answers| answers.holders > 0)
    }
}

impl Vfs {
    /// Take the files on the disk to stay as they are, until the result is dropped: a run over many robots reads
    /// the same files again and again.
    pub fn freeze(&self) -> StatSnapshot<'_> {
        self.shared.stats.with(|answers| answers.holders += 1);
        StatSnapshot(self)
    }

    /// The state of a file or folder.
    pub(super) fn stat(&self, id: FileId, path: &Path) -> Result<Stat, LoadError> {
        let known = self
            .shared
            .stats
            .with(|answers| answers.known.get(&id).cloned());
        known.unwrap_or_else(|| {
            let found = self.shared.disk.stat(path);
            self.shared.stats.with(|answers| {
                if answers.holders > 0 {
                    answers.known.insert(id, found.clone());
                }
            });
            found
        })
    }

    /// What there is at a path; none when there is nothing. Paths that are only asked about get no number, which
    /// would never be taken back, unless the answer is to be remembered.
    pub(super) fn stat_at(&self, path: &Path) -> Option<Stat> {
        let path = self.absolute(path);
        if !self.shared.stats.are_held() {
            return self.shared.disk.stat(&path).ok();
        }
        let id = self.shared.ids.id(path);
        let known = self.shared.stats.with(|answers| {
            answers
                .known
                .get(&id)
                .map(|found| found.as_ref().ok().copied())
        });
        known.unwrap_or_else(|| self.stat(id, &self.path(id)).ok())
    }

    /// What `list` lists in the folder at an absolute path.
    pub(super) fn listed(
        &self,
        path: PathBuf,
        list: impl FnOnce(&Path) -> Vec<DirEntry>,
    ) -> Arc<Vec<DirEntry>> {
        if !self.shared.stats.are_held() {
            return Arc::new(list(&path));
        }
        let id = self.shared.ids.id(path);
        self.shared
            .stats
            .with(|answers| answers.listed.get(&id).cloned())
            .unwrap_or_else(|| {
                let names = Arc::new(list(&self.path(id)));
                self.shared
                    .stats
                    .with(|answers| answers.listed.insert(id, names.clone()));
                names
            })
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::Tree;

    #[test]
    fn what_changes_in_the_meantime_is_seen_later() {
        let tree = Tree::new();
        let text = || {
            tree.vfs()
                .text(&tree.path("a"))
                .map(|file| file.text.clone())
                .ok()
        };
        {
            let _outer = tree.vfs().freeze();
            drop(tree.vfs().freeze());
            assert_eq!(text(), None);
            tree.write("a", "1");
            assert_eq!(text(), None);
        }
        assert_eq!(text().as_deref(), Some("1"));
    }

    #[test]
    fn all_questions_get_the_same_answer_until_then() {
        let tree = Tree::new();
        let answers = || {
            let (vfs, path) = (tree.vfs(), tree.path("d/a"));
            let names = vfs.list_dir(&tree.path("d")).len();
            (
                vfs.is_file(&path),
                vfs.exists(&path),
                vfs.is_dir(&tree.path("d")),
                vfs.size(&path),
                names,
            )
        };
        {
            let _held = tree.vfs().freeze();
            assert_eq!(answers(), (false, false, false, None, 0));
            tree.write("d/a", "12");
            assert_eq!(answers(), (false, false, false, None, 0));
        }
        assert_eq!(answers(), (true, true, true, Some(2), 1));
    }
}
