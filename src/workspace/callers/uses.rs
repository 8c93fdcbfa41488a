//! Who calls descriptions below a folder, and the descriptions there.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::caller::{Caller, NamePrefix};
use super::file_names::{self, name_of};
use super::meant::may_mean;
use super::walk::walk;
use super::{config, read};
use crate::launch;
use base::FastMap;
use base::limits::CALLER_FILES;
use packages::Packages;
use vfs::Vfs;

/// Who calls descriptions below a folder, and the descriptions there, by name.
#[derive(Default)]
pub(super) struct Uses {
    pub(super) callers: Vec<Caller>,
    /// The files that may hold calls of xacro: read as such when somebody asks for all calls.
    pub(super) scripts: Vec<PathBuf>,
    pub(super) files: FastMap<String, Vec<PathBuf>>,
    /// The same files in the order of their paths.
    pub(super) sorted: Arc<Vec<PathBuf>>,
    /// The files that may belong to robots by their names: SRDF, YAML, what MoveIt's setup assistant wrote down.
    pub(super) beside: Vec<PathBuf>,
}

impl Uses {
    /// Whether a caller names `file`. Of several files of that name (`is_near`: that it may mean), it means those that lie
    /// in the package and folders that it writes.
    pub(super) fn names(
        &self,
        caller: &Caller,
        file: &Path,
        packages: &Packages,
        is_near: bool,
    ) -> bool {
        let name = name_of(file);
        let Some(written) = caller.descriptions.get(name) else {
            return false;
        };
        let own = || packages.containing(file).map(|package| package.name);
        // a text that says another package means no file of this one
        let may_be = |written: &&NamePrefix| {
            let said = written.package.as_ref();
            said.is_none_or(|said| own().is_none_or(|own| own == *said))
        };
        let namesakes = self.files.get(name).into_iter().flatten();
        let may_mean = |other: &&PathBuf| !is_near || may_mean(&caller.path, other, packages);
        let others: Vec<&PathBuf> = namesakes
            .filter(|other| *other != file)
            .filter(may_mean)
            .collect();
        written.iter().filter(may_be).any(|written| {
            let fit = written.fit(file, packages);
            others
                .iter()
                .all(|other| written.fit(other, packages) <= fit)
        })
    }

    /// The descriptions that are there and that a caller names, other than `file`.
    pub(super) fn others<'u>(
        &'u self,
        caller: &'u Caller,
        file: &'u Path,
        packages: &'u Packages,
    ) -> impl Iterator<Item = &'u PathBuf> {
        let named = caller.descriptions.keys();
        let others = named.filter_map(|name| self.files.get(name)).flatten();
        others.filter(move |other| *other != file && self.names(caller, other, packages, false))
    }

    /// Whether a caller names a description that is there, other than `file`.
    pub(super) fn has_another(&self, caller: &Caller, file: &Path, packages: &Packages) -> bool {
        self.others(caller, file, packages).next().is_some()
    }

    /// Whether one of these callers names a description that is there, other than `file`.
    pub(super) fn load_another(
        &self,
        file: &Path,
        packages: &Packages,
        is_loader: impl Fn(&Caller) -> bool,
    ) -> bool {
        let mut loaders = self.callers.iter().filter(|caller| is_loader(caller));
        loaders.any(|caller| self.has_another(caller, file, packages))
    }
}

/// All callers and descriptions below a folder.
pub(super) fn search(vfs: &Vfs, top: &Path) -> Uses {
    let (mut files, mut uses) = (0, Uses::default());
    walk(vfs, top, &mut |path, name, is_small| {
        if file_names::is_beside(name)
            && uses.beside.len() < CALLER_FILES
            && (name.contains(".srdf") || is_small())
        {
            uses.beside.push(path.to_owned());
        }
        if files < CALLER_FILES && file_names::may_call(name) {
            files += 1;
            let text = is_small().then(|| vfs.text(path).ok()).flatten();
            if let Some(file) = text {
                uses.callers.extend(read::caller(path, &file.text));
                if launch::may_call(&file.text) {
                    uses.scripts.push(path.to_owned());
                }
            }
        } else if file_names::is_description(name) {
            uses.files
                .entry(name.to_owned())
                .or_default()
                .push(path.to_owned());
        }
    });
    let files = &uses.files;
    for caller in &mut uses.callers {
        let mut names = caller.descriptions.keys();
        caller.has_default = names.any(|name| files.contains_key(name));
    }
    uses.callers.sort_by(|a: &Caller, b| a.path.cmp(&b.path));
    uses.scripts.sort();
    uses.beside.sort();
    let mut sorted: Vec<PathBuf> = uses.files.values().flatten().cloned().collect();
    sorted.sort();
    uses.sorted = Arc::new(sorted);
    config::inherit(&mut uses.callers);
    uses
}
