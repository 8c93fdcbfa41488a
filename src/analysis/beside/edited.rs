//! Files beside robots in an editor.

use std::path::{Path, PathBuf};

use super::super::context::RootChoice;
use super::super::world::World;
use super::files::{Beside, sort};
use super::judge::{Compared, Robots};
use base::CancelFlag;

impl World {
    /// What there is to say about the files beside robots among `paths`, and about those beside robots that are shown: those
    /// that other robots, or the same with other arguments, have to be expanded for are left to when they are open.
    /// `None` when cancelled.
    pub(in super::super) fn beside_findings(
        &mut self,
        paths: &[PathBuf],
        roots: &[RootChoice],
        cancel: &CancelFlag,
    ) -> Option<Compared> {
        let mut files: Vec<PathBuf> = paths.iter().filter(|path| sort(path).is_some()).cloned().collect();
        let is_for_shown =
            |file: &PathBuf| self.session().pairing(file).roots.iter().all(|own| roots.contains(own));
        let beside = roots.iter().flat_map(|root| self.session().beside_of(&root.file));
        files.extend(beside.filter(is_for_shown));
        files.sort();
        files.dedup();
        let robots = self.analyzed_for(&files, cancel)?;
        let found = self.session().beside_findings(&files, cancel, &robots);
        (!cancel.is_cancelled()).then_some(found)
    }

    /// What has to be expanded to judge files beside robots. `None` when cancelled.
    fn analyzed_for(&mut self, files: &[PathBuf], cancel: &CancelFlag) -> Option<Robots> {
        let mut robots = Robots::default();
        for root in self.session().beside_roots(files) {
            let analyzed = self.analyzed(&root, cancel)?;
            robots.insert(root, analyzed);
        }
        Some(robots)
    }

    /// The files beside a robot, read. `None` when cancelled.
    pub fn beside(&mut self, root: &Path, cancel: &CancelFlag) -> Option<Vec<Beside>> {
        let files = self.session().beside_of(root);
        let robots = self.analyzed_for(&files, cancel)?;
        Some(files.iter().filter_map(|file| self.session().beside(file, &robots)).collect())
    }

    /// The robots that a file beside them is for, the most likely one first.
    pub fn robots_beside(&self, path: &Path) -> Vec<RootChoice> {
        match sort(path) {
            Some(_) => self.session().pairing(path).roots.clone(),
            None => Vec::new(),
        }
    }
}
