//! What launch files and programs load instead of a description.

use std::path::Path;
use std::sync::Arc;

use super::Callers;
use super::caller::Caller;
use super::meant::may_mean;
use super::mentions::TextMentions;
use super::uses::Uses;
use base::FastSet;

impl Callers {
    /// Whether a launch file around `file` loads a description that is there.
    pub fn launch_any(&self, file: &Path) -> bool {
        self.around(file)
            .is_some_and(|all| names_any(&all, Caller::is_launch))
    }

    /// Whether a launch file or program around `file` that names a description simulates, plans or controls something.
    pub fn move_any(&self, file: &Path) -> bool {
        self.around(file).is_some_and(|all| {
            let mut callers = all.callers.iter();
            callers.any(|caller| caller.simulates && !caller.is_page())
        })
    }

    /// Whether a launch file or program around `file` loads a description that is there, or a simulator has a model of its own.
    pub fn load_any(&self, file: &Path) -> bool {
        let has_model = |mentions: Arc<TextMentions>| {
            mentions.is_whole && mentions.runs && mentions.has_own_model
        };
        let loads =
            |all: Arc<Uses>| names_any(&all, |caller| caller.is_launch() || caller.is_program());
        self.around(file).is_some_and(loads) || self.mentions(file).is_some_and(has_model)
    }

    /// The names of the descriptions in the package of `file` that launch files, programs and build files load instead: none where the file itself
    /// is named somewhere, or the launch files take the name of any and it `may_be_given`.
    pub fn launched_instead(&self, file: &Path, may_be_given: bool) -> FastSet<String> {
        let all = self
            .packages
            .containing(file)
            .and_then(|_| self.around(file));
        let Some(all) = all else {
            return FastSet::default();
        };
        let is_loader = |caller: &&Caller| caller.may_load(file, &self.packages);
        let launches = all.callers.iter().filter(is_loader);
        // where others load robots of their own, a launch file with a default is for that one
        let has_own = launches
            .clone()
            .any(|caller| !caller.is_open && caller.has_default);
        let may_be = |caller: &Caller| caller.is_open && !(has_own && caller.has_default);
        let may_mean = |caller: &Caller| {
            caller.says(file) || may_be_given && caller.is_launch() && may_be(caller)
        };
        if self.of(file).iter().any(may_mean) {
            return FastSet::default();
        }
        launches
            .flat_map(|caller| caller.descriptions.keys().cloned())
            .collect()
    }

    /// Whether a launch file, program or build file that may mean `file` loads another description that is there.
    pub fn load_another(&self, file: &Path) -> bool {
        self.around(file).is_some_and(|all| {
            all.load_another(file, &self.packages, |caller| {
                caller.may_load(file, &self.packages)
            })
        })
    }

    /// Whether `file` lies in no package and no text of the workspace may mean it, while launch files load other
    /// descriptions that are there: a copy of something, or what another program has left.
    pub fn pass_over(&self, file: &Path) -> bool {
        let all = self
            .around(file)
            .filter(|_| self.packages.containing(file).is_none());
        let Some(all) = all else { return false };
        let may_mean = |caller: &Caller| {
            all.names(caller, file, &self.packages, false) && !caller.is_trial()
                || caller.ends(file)
                || caller.is_open && may_mean(&caller.path, file, &self.packages)
        };
        // without launch files, programs load robots
        !all.callers.iter().any(may_mean)
            && (all.load_another(file, &self.packages, Caller::is_launch)
                || !all.callers.iter().any(Caller::is_launch)
                    && all.load_another(file, &self.packages, Caller::is_program))
    }
}

/// Whether a caller of a kind names a description that is there.
fn names_any(all: &Uses, is_of_kind: impl Fn(&Caller) -> bool) -> bool {
    let callers = all.callers.iter().filter(|caller| is_of_kind(caller));
    callers
        .flat_map(|caller| caller.descriptions.keys())
        .any(|name| all.files.contains_key(name))
}
