//! Files beside robots in an editor.
use std::path::{Path, PathBuf};

use super::super::host::AnalysisHost;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::super::walk::is_launch;
use super::compare::ComparisonResult;
use super::files::{Beside, Robots, Sort, sort};
use base::CancelFlag;
use facts::parts_where;

impl Session {
    /// What a file says that the pairing of other files rests on, and the arguments that it gives to robots.
    pub(in super::super) fn said_to_others(&self, path: &Path) -> Vec<String> {
        let mut said = vec![format!(
            "{:?} {}",
            self.robot_name(path),
            self.is_about_robots(path)
        )];
        if is_launch(path) {
            said.extend(self.given_in(path));
        } else if sort(path) == Some(Sort::Yaml) {
            let settings = self.beside_settings(path);
            said.extend(
                settings.map(|settings| format!("{:?} {:?}", settings.listed, settings.assistant)),
            );
        } else if let Ok(file) = self.vfs.document(path) {
            let parts = parts_where(&file.document, |marks| marks.parameters);
            let named = parts.flat_map(|(_, item)| item.text().split("<parameters>").skip(1));
            said.extend(named.filter_map(|rest| Some(rest.split_once('<')?.0.to_owned())));
        }
        said
    }
}

impl AnalysisHost {
    /// What there is to say about the files beside robots among `paths`, and about those beside robots that are shown: those
    /// that other robots, or the same with other arguments, have to be expanded for are left to when they are open.
    /// `None` when cancelled.
    pub(in super::super) fn beside_findings(
        &mut self,
        paths: &[PathBuf],
        roots: &[RootConfig],
        cancel: &CancelFlag,
    ) -> Option<ComparisonResult> {
        let mut files: Vec<PathBuf> = paths
            .iter()
            .filter(|path| sort(path).is_some())
            .cloned()
            .collect();
        let is_for_shown = |file: &PathBuf| {
            self.session()
                .pairing(file)
                .roots
                .iter()
                .all(|own| roots.contains(own))
        };
        let beside = roots
            .iter()
            .flat_map(|root| self.session().beside_of(&root.file));
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
        self.read(&files, cancel)
    }

    /// A file beside robots, read; none when it says nothing about one. `None` when cancelled.
    pub fn beside_itself(&mut self, path: &Path, cancel: &CancelFlag) -> Option<Option<Beside>> {
        Some(self.read(&[path.to_owned()], cancel)?.pop())
    }

    /// Files beside robots, read: of these, only SRDFs are expanded.
    fn read(&mut self, files: &[PathBuf], cancel: &CancelFlag) -> Option<Vec<Beside>> {
        let mut srdfs = Robots::default();
        for file in files.iter().filter(|file| sort(file) == Some(Sort::Srdf)) {
            let root = RootConfig::plain(file);
            let analyzed = self.analyzed(&root, cancel)?;
            srdfs.insert(root, analyzed);
        }
        Some(
            files
                .iter()
                .filter_map(|file| self.session().beside(file, &srdfs))
                .collect(),
        )
    }

    /// The robots that a file beside them is for, the most likely one first.
    pub fn robots_beside(&self, path: &Path) -> Vec<RootConfig> {
        match sort(path) {
            Some(_) => self.session().pairing(path).roots.clone(),
            None => Vec::new(),
        }
    }

    /// The robots whose names may be used in a file: those that it is for; where nothing says which, a few of the workspace.
    /// Enough to offer names, not to judge them.
    pub fn robots_to_name(&self, path: &Path) -> Vec<RootConfig> {
        const MOST: usize = 4;
        let known = self.robots_beside(path);
        if !known.is_empty() {
            return known;
        }
        let all = self.session().callers.descriptions(path);
        all.iter()
            .filter(|file| self.session().is_robot(file))
            .take(MOST)
            .map(|file| RootConfig::plain(file))
            .collect()
    }
}
