//! Files beside robots in an editor.
use std::path::{Path, PathBuf};

use super::super::host::AnalysisHost;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::around::{beside_of, beside_roots};
use super::compare::{ComparisonResult, beside_findings};
use super::files::{Beside, Robots, read_beside};
use super::pairing::pairing_of;
use super::robots::is_robot;
use super::sort::{Sort, sort};
use base::CancelFlag;

/// What there is to say about the files beside robots among `paths`, and about those beside robots that are shown: those
/// that other robots, or the same with other arguments, have to be expanded for are left to when they are open.
/// `None` when cancelled.
pub(in super::super) fn shown_beside_findings(
    host: &mut AnalysisHost,
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
        pairing_of(host.session(), file)
            .roots
            .iter()
            .all(|own| roots.contains(own))
    };
    let beside = roots
        .iter()
        .flat_map(|root| beside_of(host.session(), &root.file));
    files.extend(beside.filter(is_for_shown));
    files.sort();
    files.dedup();
    let robots = analyzed_for(host, &files, cancel)?;
    let found = beside_findings(host.session(), &files, cancel, &robots);
    (!cancel.is_cancelled()).then_some(found)
}

/// What has to be expanded to judge files beside robots. `None` when cancelled.
fn analyzed_for(host: &mut AnalysisHost, files: &[PathBuf], cancel: &CancelFlag) -> Option<Robots> {
    let mut robots = Robots::default();
    for root in beside_roots(host.session(), files) {
        let analyzed = host.analyzed(&root, cancel)?;
        robots.insert(root, analyzed);
    }
    Some(robots)
}

/// The files beside a robot, read. `None` when cancelled.
pub fn read_files_beside(
    host: &mut AnalysisHost,
    root: &Path,
    cancel: &CancelFlag,
) -> Option<Vec<Beside>> {
    let files = beside_of(host.session(), root);
    read(host, &files, cancel)
}

/// A file beside robots, read; none when it says nothing about one. `None` when cancelled.
pub fn read_file_beside(
    host: &mut AnalysisHost,
    path: &Path,
    cancel: &CancelFlag,
) -> Option<Option<Beside>> {
    Some(read(host, &[path.to_owned()], cancel)?.pop())
}

/// Files beside robots, read: of these, only SRDFs are expanded.
fn read(host: &mut AnalysisHost, files: &[PathBuf], cancel: &CancelFlag) -> Option<Vec<Beside>> {
    let mut srdfs = Robots::default();
    for file in files.iter().filter(|file| sort(file) == Some(Sort::Srdf)) {
        let root = RootConfig::plain(file);
        let analyzed = host.analyzed(&root, cancel)?;
        srdfs.insert(root, analyzed);
    }
    Some(
        files
            .iter()
            .filter_map(|file| read_beside(host.session(), file, &srdfs))
            .collect(),
    )
}

/// The robots that a file beside them is for, the most likely one first.
pub fn robots_beside(session: &Session, path: &Path) -> Vec<RootConfig> {
    match sort(path) {
        Some(_) => pairing_of(session, path).roots.clone(),
        None => Vec::new(),
    }
}

/// The robots whose names may be used in a file: those that it is for; where nothing says which, a few of the workspace.
/// Enough to offer names, not to judge them.
pub fn robots_to_name(session: &Session, path: &Path) -> Vec<RootConfig> {
    const MOST: usize = 4;
    let known = robots_beside(session, path);
    if !known.is_empty() {
        return known;
    }
    let all = session.callers.descriptions(path);
    all.iter()
        .filter(|file| is_robot(session, file))
        .take(MOST)
        .map(|file| RootConfig::plain(file))
        .collect()
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::{AnalysisHost, robots_beside};
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
            let all = robots_beside(host.session(), &tree.path("config/c.yaml"));
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
