//! Who calls a description: the launch files, scripts, tests and pages of the workspace that name it, and the
//! arguments that they give.
//!
//! Read as text, never executed: which values a launch file computes is not known then, only that it gives them.

mod called;
mod caller;
mod choices;
mod config;
mod copied;
mod era;
mod file_names;
mod instead;
mod loaded;
mod localizing;
mod meant;
mod mentions;
mod programs;
mod purpose;
mod read;
mod text_words;
mod uses;
mod walk;

pub use called::{ControlNode, PublishedTransform, RobotCall, SpawnedControllers};
pub use caller::{Caller, GivenArg};
pub use choices::Excluded;
pub use era::Era;
pub use file_names::is_page;
pub use programs::downloads_data;
pub use purpose::Purpose;
pub use read::{has_name, without_comments};

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use file_names::name_of;
use meant::may_mean;
use packages::{AnswerCache, Packages};
use uses::{Uses, search};

/// The callers below some folders, found when somebody asks for them.
pub struct Callers {
    packages: Arc<Packages>,
    below: AnswerCache<PathBuf, Arc<Uses>>,
    called: AnswerCache<PathBuf, Arc<called::LaunchCalls>>,
    copies: AnswerCache<PathBuf, Arc<copied::CopiedFolders>>,
    mentions: AnswerCache<PathBuf, Arc<mentions::TextMentions>>,
    /// Descriptions that were edited since somebody asked what texts mention.
    edited: Mutex<BTreeSet<PathBuf>>,
}

impl Callers {
    /// Those of the descriptions in the folders around these packages.
    pub fn new(packages: Arc<Packages>) -> Self {
        Self {
            packages,
            below: AnswerCache::default(),
            called: AnswerCache::default(),
            copies: AnswerCache::default(),
            mentions: AnswerCache::default(),
            edited: Mutex::default(),
        }
    }

    /// The files that call the description `file`: first those that name it, then those that may, since they compute the
    /// name; each in the order of their paths.
    pub fn of(&self, file: &Path) -> Vec<Caller> {
        let name = name_of(file);
        let Some(all) = self.around(file).filter(|_| !name.is_empty()) else {
            return Vec::new();
        };
        let is_named = |caller: &&Caller| all.names(caller, file, &self.packages, true);
        let named = all.callers.iter().filter(is_named);
        let may_name = |caller: &&Caller| {
            !caller.descriptions.contains_key(name)
                && caller
                    .endings
                    .iter()
                    .any(|ending| name.ends_with(ending.as_str()))
        };
        let computed = all.callers.iter().filter(may_name);
        let may_mean = |caller: &&Caller| {
            caller.computes_the_file() || may_mean(&caller.path, file, &self.packages)
        };
        named.chain(computed).filter(may_mean).cloned().collect()
    }

    /// What is known of the sources around a file.
    fn around(&self, file: &Path) -> Option<Arc<Uses>> {
        let top = self.packages.sources_around(file)?;
        Some(
            self.below
                .get(top.clone(), || Arc::new(search(self.packages.vfs(), &top))),
        )
    }

    /// The files around `file` that may belong to robots, by their names: SRDF, YAML, what MoveIt's setup assistant wrote.
    pub fn beside(&self, file: &Path) -> Vec<PathBuf> {
        self.around(file)
            .map_or_else(Vec::new, |all| all.beside.clone())
    }

    /// The descriptions around `file`, in the order of their paths.
    pub fn descriptions(&self, file: &Path) -> Arc<Vec<PathBuf>> {
        let all = self.around(file);
        all.map(|all| all.sorted.clone()).unwrap_or_default()
    }

    /// A description was edited: it may mention something else.
    pub fn edit_description(&self, path: &Path) {
        self.edited().insert(path.to_owned());
    }

    fn edited(&self) -> MutexGuard<'_, BTreeSet<PathBuf>> {
        self.edited.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Forget what was found: files have come, gone or changed.
    pub fn forget(&self) {
        self.below.clear();
        self.called.clear();
        self.copies.clear();
        self.mentions.clear();
    }
}

#[cfg(test)]
mod read_tests;
#[cfg(test)]
mod tests;
