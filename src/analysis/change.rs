//! Checks of a change: which robots it reaches, and which findings are about it.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;

use super::candidates::Candidates;
use super::check_task::{CheckReason, CheckTask};
use super::includes::IncludeTargets;
use super::options::CheckOptions;
use super::root_result::RootResult;
use super::session::Session;
use super::walk::is_description;
use base::{FastSet, FileId};
use packages::{BUILD_FILES, Package};
use rules::{Category, Check, Finding, Severity};

/// The files that changed.
pub(super) struct Change<'a> {
    session: &'a Session,
    /// As they were named, absolute: files that are gone have nothing else.
    paths: Vec<PathBuf>,
    /// What tells those that are there from others, whatever path leads to them.
    identities: FastSet<u128>,
}

impl<'a> Change<'a> {
    /// The change that a check is about; none: it is about everything.
    pub(super) fn of(session: &'a Session, options: &CheckOptions) -> Option<Self> {
        let paths: Vec<PathBuf> = options
            .changed
            .iter()
            .map(|path| session.vfs.absolute(path))
            .collect();
        let identities = paths
            .iter()
            .filter_map(|path| session.vfs.identity(path))
            .collect();
        (!paths.is_empty()).then_some(Self {
            session,
            paths,
            identities,
        })
    }

    /// Whether a file changed, or lies in a folder that was named.
    pub(super) fn holds(&self, path: &Path) -> bool {
        self.paths.iter().any(|changed| path.starts_with(changed))
            || self
                .session
                .vfs
                .identity(path)
                .is_some_and(|own| self.identities.contains(&own))
    }

    /// The changed descriptions that are not among `tasks`: those elsewhere, or in folders that are passed over.
    /// What the configuration excludes stays out.
    pub(super) fn further(&self, tasks: &[CheckTask], args: &[(String, String)]) -> Vec<CheckTask> {
        let known: FastSet<u128> = tasks
            .iter()
            .filter_map(|task| self.session.vfs.identity(&task.file))
            .collect();
        let is_new = |path: &&PathBuf| {
            let own = self.session.vfs.identity(path);
            own.is_some_and(|own| !known.contains(&own))
                && !self.session.settings(path).excludes(path)
        };
        let files = self
            .paths
            .iter()
            .filter(|path| is_description(path) && self.session.vfs.is_file(path));
        let task =
            |file: &PathBuf| CheckTask::new(file.clone(), CheckReason::Walked, args.to_vec());
        files.filter(is_new).map(task).collect()
    }

    /// The tasks that may read a changed file, by what the texts include. All of them when something changed
    /// that is read in other ways. What files include is looked up in `known`, and put there.
    pub(super) fn reached(&self, tasks: Vec<CheckTask>, known: &Candidates) -> Vec<CheckTask> {
        if !self.paths.iter().all(|path| is_description(path)) {
            return tasks;
        }
        let files: FastSet<&Path> = tasks.iter().map(|task| task.file.as_path()).collect();
        let files: Vec<&Path> = files.into_iter().collect();
        let mut open: Vec<(&Path, Arc<IncludeTargets>)> = files
            .into_par_iter()
            .filter_map(|file| Some((file, known.reach(self.session, file)?)))
            .collect();
        let mut reached: FastSet<PathBuf> = FastSet::default();
        let mut newest = self.paths.clone();
        while !newest.is_empty() {
            let is_next = |(file, reach): &(&Path, Arc<IncludeTargets>)| {
                reach.anything || self.holds(file) || newest.iter().any(|path| reach.has(path))
            };
            let (next, rest) = open.into_iter().partition(is_next);
            open = rest;
            newest = Vec::<(&Path, Arc<IncludeTargets>)>::into_iter(next)
                .map(|(file, _)| file.to_path_buf())
                .collect();
            reached.extend(newest.iter().cloned());
        }
        tasks
            .into_iter()
            .filter(|task| reached.contains(&task.file))
            .collect()
    }

    /// Whether an expansion read a changed file, looked for one that is gone, or belongs to a package whose
    /// manifest or build file changed.
    pub(super) fn is_read_by(&self, result: &RootResult) -> bool {
        let package = self.session.packages.containing(&result.task.file);
        let of_package = |package: Package| {
            let names = std::iter::once("package.xml").chain(BUILD_FILES);
            names
                .map(|name| package.folder.join(name))
                .collect::<Vec<_>>()
        };
        let of_package = package.map_or_else(Vec::new, of_package);
        let read = std::iter::once(&result.task.file)
            .chain(&result.reads)
            .chain(&of_package);
        read.into_iter().any(|path| self.holds(path))
    }

    /// Whether a file changed, by its number.
    pub(super) fn has(&self, file: FileId) -> bool {
        self.holds(&self.session.vfs.path(file))
    }

    /// Whether a finding of an expansion that read a changed file is about the change: it is there, or leads
    /// there, or is an error elsewhere that the change may have caused.
    pub(super) fn concerns(&self, finding: &Finding) -> bool {
        let related = finding.related.iter().map(|related| related.span);
        let call_sites = finding.call_sites.iter().map(|site| site.call);
        let files: FastSet<FileId> = std::iter::once(finding.span)
            .chain(related)
            .chain(call_sites)
            .map(|span| span.file)
            .collect();
        let of_its_file =
            matches!(finding.rule.check, Check::File(_)) || finding.rule.category == Category::Xml;
        finding.severity == Severity::Error && !of_its_file
            || files.into_iter().any(|file| self.has(file))
    }
}

#[cfg(test)]
mod tests {
    use crate::{CheckOptions, Report, Session, Setup};
    use vfs::testing::Tree;

    fn check(tree: &Tree, changed: &[&str]) -> (Report, usize) {
        let session = Session::new(&tree.environment(&[]), Setup::default()).unwrap();
        let changed = changed.iter().map(|name| tree.path(name)).collect();
        let paths = vec![tree.root().to_owned()];
        let options = CheckOptions {
            paths,
            changed,
            ..CheckOptions::default()
        };
        let report = crate::check(&session, &options);
        (report, options.progress.get().1)
    }

    fn names(tree: &Tree, report: &Report) -> Vec<String> {
        let below = |path: &std::path::Path| {
            path.strip_prefix(tree.root())
                .unwrap()
                .display()
                .to_string()
        };
        report
            .findings
            .iter()
            .map(|f| format!("{} {}", below(report.path(f.span.file)), f.rule.name))
            .collect()
    }

    /// Two robots over a common macro file, a third one beside them.
    fn tree() -> Tree {
        let tree = Tree::new();
        let robot = |name: &str, include: &str, rest: &str| {
            format!(
                "<robot name='{name}' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                 <xacro:include filename=\"{include}\"/><link name='base_link'/>{rest}</robot>"
            )
        };
        tree.write(
            "a.urdf.xacro",
            &robot("a", "parts/arm.xacro", "<xacro:arm/><link name='lost'/>"),
        );
        tree.write(
            "b.urdf.xacro",
            &robot(
                "b",
                "${'parts/' + 'arm.xacro'}",
                "<xacro:property name='n' value='1'/>",
            ),
        );
        tree.write("c.urdf.xacro", &robot("c", "parts/other.xacro", "${gone}"));
        let library = "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'>";
        tree.write(
            "parts/arm.xacro",
            &format!("{library}<xacro:macro name='arn'/></robot>"),
        );
        tree.write("parts/other.xacro", &format!("{library}</robot>"));
        tree
    }

    #[test]
    fn robots_that_include_a_changed_file() {
        let tree = tree();
        let (report, expanded) = check(&tree, &["parts/arm.xacro"]);
        // the robot whose include says nothing by its text is looked at, the one that includes something else is not
        assert_eq!((expanded, report.robots), (3, 2));
        let found = names(&tree, &report);
        assert!(
            found.contains(&"a.urdf.xacro undefined-macro".to_owned()),
            "{found:?}"
        );
        assert!(
            !found.iter().any(|name| name.starts_with("c.")),
            "{found:?}"
        );
        // a warning beside the change is no news
        assert!(
            !found.contains(&"b.urdf.xacro unused-property".to_owned()),
            "{found:?}"
        );
    }

    #[test]
    fn warnings_where_the_change_is() {
        let tree = tree();
        let (report, _) = check(&tree, &["b.urdf.xacro"]);
        let found = names(&tree, &report);
        assert!(
            found.contains(&"b.urdf.xacro unused-property".to_owned()),
            "{found:?}"
        );
        assert!(
            !found.iter().any(|name| name.starts_with("a.")),
            "{found:?}"
        );
    }

    #[test]
    fn a_file_that_is_gone() {
        let tree = tree();
        std::fs::remove_file(tree.path("parts/other.xacro")).unwrap();
        let (report, _) = check(&tree, &["parts/other.xacro"]);
        let found = names(&tree, &report);
        assert!(
            found.contains(&"c.urdf.xacro include-not-found".to_owned()),
            "{found:?}"
        );
        assert!(report.unreadable.is_empty());
    }

    #[test]
    fn values_from_a_file_of_another_kind() {
        let tree = Tree::new();
        let robot = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                     <xacro:property name='p' value=\"${load_yaml('p.yaml')}\"/>\
                     <link name='base_link'/><link name='${p[0]}'/></robot>";
        tree.write("r.urdf.xacro", robot);
        tree.write(
            "s.urdf",
            "<robot name='s'><link name='a'/><link name='b'/></robot>",
        );
        tree.write("p.yaml", "[tool]");
        let (report, _) = check(&tree, &["p.yaml"]);
        assert_eq!(names(&tree, &report), ["r.urdf.xacro orphan-link"; 2]);
    }
}
