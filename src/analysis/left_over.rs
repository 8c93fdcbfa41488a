//! Files of a package that nothing uses, beside others that are used.
use std::path::{Path, PathBuf};

use super::beside::stem;
use super::session::Session;
use super::{graph, walk};
use base::FastSet;

impl Session {
    /// Whether launch files, programs or build files load other descriptions than those of the package that nothing can mean.
    pub(super) fn is_left_over(&self, file: &Path) -> bool {
        let mut launched = self.callers.launched_instead(file, false);
        if !launched.is_empty() && self.may_be_given(file, &launched) {
            launched = self.callers.launched_instead(file, true);
        }
        let Some(package) = self.packages.containing(file) else {
            return false;
        };
        if launched.is_empty() {
            return self.is_variant(file, &package.folder);
        }
        let is_launched = |other: &PathBuf| {
            let name = other.file_name().and_then(|name| name.to_str());
            other != file && name.is_some_and(|name| launched.contains(name))
        };
        walk::all_descriptions(&package.folder, &self.vfs, &self.env)
            .iter()
            .any(is_launched)
            || self.callers.load_another(file) && !self.is_built_for_moveit(file, &package.folder)
    }

    /// Whether a program that builds the configuration of MoveIt reads a file without its name.
    pub(super) fn is_built_for_moveit(&self, file: &Path, package: &Path) -> bool {
        self.extended(package).as_deref() == Some(file) && self.callers.build_for_moveit(file)
    }

    /// Whether somebody may start a launch file that takes the name of any description with this one: it is a robot, and none of
    /// the same name is launched.
    fn may_be_given(&self, file: &Path, launched: &FastSet<String>) -> bool {
        let is_same = |name: &String| {
            let other = file.with_file_name(name);
            other != file && stem(&other) == stem(file) && self.vfs.is_file(&other)
        };
        self.gives_robot(file) && !launched.iter().any(is_same)
    }

    /// Whether a robot is named by nothing, while another one of its package is part of a robot.
    fn is_variant(&self, file: &Path, package: &Path) -> bool {
        let is_used = |other: &PathBuf| {
            let is_outside = |by: &PathBuf| !by.starts_with(package);
            other != file && self.includers(other).iter().any(is_outside) && self.gives_robot(other)
        };
        self.gives_robot(file)
            && !self.callers.load(file)
            && !self.callers.launch(file)
            && walk::all_descriptions(package, &self.vfs, &self.env)
                .iter()
                .any(is_used)
    }

    fn gives_robot(&self, file: &Path) -> bool {
        self.vfs
            .document(file)
            .is_ok_and(|source| graph::gives_robot(&source.document))
    }
}
