//! Files beside robots in an editor.
use std::path::{Path, PathBuf};

use super::super::graph::gives_robot;
use super::super::host::AnalysisHost;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::super::walk::is_launch;
use super::compare::ComparisonResult;
use super::files::{Beside, Robots, Sort, sort};
use base::CancelFlag;
use facts::parts_where;
use xml::Document;

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
            said.push(gives_robot(&file.document).to_string());
            said.extend(included_names(&file.document));
        }
        said
    }
}

/// The names of the files that a document includes, with the prefix of xacro or without it.
fn included_names(document: &Document) -> impl Iterator<Item = String> {
    let parts = parts_where(document, |marks| marks.include);
    let nodes = parts.flat_map(|(_, item)| item.all_nodes());
    let tags = nodes.filter(|node| matches!(node.name(), "xacro:include" | "include"));
    tags.filter_map(|tag| Some(tag.attr("filename")?.raw().to_owned()))
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

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::AnalysisHost;
    use base::TextRange;
    use vfs::testing::Tree;

    #[test]
    fn an_edited_include_decides_for_which_robots_a_file_is() {
        let tree = Tree::new();
        let robot = |name: &str, part: &str| {
            format!(
                "<robot name='{name}' xmlns:xacro='http://www.ros.org/wiki/xacro'><link name='base'/><xacro:include filename='{part}'/></robot>"
            )
        };
        let plugin = "<robot><gazebo><plugin name='c' filename='libc.so'><parameters>$(find arm)/config/c.yaml</parameters></plugin></gazebo></robot>";
        tree.write("package.xml", "<package><name>arm</name></package>");
        tree.write("config/c.yaml", "go:\n  joints: [lift]\n");
        tree.write("urdf/simulated.xacro", plugin);
        tree.write("urdf/a.urdf.xacro", &robot("a", "simulated.xacro"));
        tree.write("urdf/b.urdf.xacro", &robot("b", "other.xacro"));
        let mut host = AnalysisHost::new(tree.environment(&[]), vec![tree.root().to_owned()]);
        let robots = |host: &AnalysisHost| -> Vec<PathBuf> {
            let all = host.robots_beside(&tree.path("config/c.yaml"));
            all.into_iter().map(|root| root.file).collect()
        };
        let path = tree.path("urdf/b.urdf.xacro");
        host.set_text(&path, robot("b", "other.xacro"));
        let replace = |host: &mut AnalysisHost, old: &str, new: &str| {
            let text = host.document(&path).unwrap().document.text();
            let at = text.find(old).unwrap();
            let range = TextRange::new(at as u32, (at + old.len()) as u32);
            host.edit(&path, range, new);
        };
        let both = ["a", "b"].map(|name| tree.path(&format!("urdf/{name}.urdf.xacro")));
        assert_eq!(robots(&host), both[..1]);
        replace(&mut host, "other", "simulated");
        assert_eq!(robots(&host), both);
        // without its name it is no robot
        replace(&mut host, " name='b'", "");
        assert_eq!(robots(&host), both[..1]);
        replace(&mut host, "<robot", "<robot name='b'");
        assert_eq!(robots(&host), both);
    }
}
