//! A time in which files are taken to stay as they are.

use std::path::Path;
use std::sync::{Mutex, PoisonError};

use super::Vfs;
use super::error::LoadError;
use super::read::{self, Stat};
use crate::base::{FastMap, FileId};

/// What was asked about files since somebody began to hold them.
#[derive(Default)]
pub(super) struct Asked(Mutex<Answers>);

#[derive(Default)]
struct Answers {
    /// How many hold.
    holders: usize,
    known: FastMap<FileId, Result<Stat, LoadError>>,
}

/// As long as this lives, the disk is asked once about each file.
pub struct Held<'a>(&'a Vfs);

impl Drop for Held<'_> {
    fn drop(&mut self) {
        self.0.asked.with(|answers| {
            answers.holders -= 1;
            if answers.holders == 0 {
                answers.known.clear();
            }
        });
    }
}

impl Asked {
    fn with<T>(&self, work: impl FnOnce(&mut Answers) -> T) -> T {
        work(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Vfs {
    /// Take the files on the disk to stay as they are, until the result is dropped: a run over many robots reads
    /// the same files again and again.
    pub fn hold(&self) -> Held<'_> {
        self.asked.with(|answers| answers.holders += 1);
        Held(self)
    }

    /// The state of a file or folder.
    pub(super) fn stat(&self, id: FileId, path: &Path) -> Result<Stat, LoadError> {
        let known = self.asked.with(|answers| answers.known.get(&id).cloned());
        known.unwrap_or_else(|| {
            let found = read::stat(path);
            self.asked.with(|answers| {
                if answers.holders > 0 {
                    answers.known.insert(id, found.clone());
                }
            });
            found
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::Tree;

    #[test]
    fn what_changes_in_the_meantime_is_seen_later() {
        let tree = Tree::new();
        let text = || tree.vfs().text(&tree.path("a")).map(|file| file.text.clone()).ok();
        {
            let _outer = tree.vfs().hold();
            drop(tree.vfs().hold());
            assert_eq!(text(), None);
            tree.write("a", "1");
            assert_eq!(text(), None);
        }
        assert_eq!(text().as_deref(), Some("1"));
    }
}
