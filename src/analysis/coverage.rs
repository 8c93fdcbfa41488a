//! What one expansion covers needs no other: which files are expanded at all, and which results are kept.
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::check_task::{CheckReason, CheckTask};
use super::generated::leave_out_copies;
use super::includes::Included;
use super::root_result::RootResult;
use super::session::Session;
use base::FastSet;

/// Tasks in two parts: what has to be expanded whatever the others give, and what a robot may cover that
/// includes it.
pub(super) fn in_turns(
    session: &Session,
    tasks: Vec<CheckTask>,
) -> (Vec<CheckTask>, Vec<CheckTask>) {
    let included = statically_included(session, &tasks);
    let waits =
        |task: &CheckTask| task.reason == CheckReason::Walked && included.contains(&task.file);
    let (later, first) = tasks.into_iter().partition(waits);
    (first, later)
}

/// The tasks that no robot among the results covers.
pub(super) fn uncovered(
    session: &Session,
    tasks: Vec<CheckTask>,
    results: &[RootResult],
) -> Vec<CheckTask> {
    let covered = covered_by_robots(session, results.iter());
    let is_open = |task: &CheckTask| {
        session
            .vfs
            .identity(&task.file)
            .is_none_or(|own| !covered.contains(&own))
    };
    tasks.into_iter().filter(is_open).collect()
}

fn covered_by_robots<'a>(
    session: &Session,
    results: impl Iterator<Item = &'a RootResult>,
) -> FastSet<u128> {
    let robots = results.filter(|result| result.is_robot);
    let reads: FastSet<&PathBuf> = robots.flat_map(|result| &result.reads).collect();
    reads
        .into_iter()
        .filter_map(|path| session.vfs.identity(path))
        .collect()
}

/// Drop what another expansion covers.
pub(super) fn without_covered(session: &Session, results: Vec<RootResult>) -> Vec<RootResult> {
    let mut covered = covered_by_robots(session, results.iter());
    let (mut kept, mut others): (Vec<RootResult>, Vec<RootResult>) = results
        .into_iter()
        .partition(|result| result.task.reason != CheckReason::Walked);
    // robots first: what they include needs no look of its own
    others.sort_by_key(|result| !result.is_robot);
    for result in others {
        let own = session.vfs.identity(&result.task.file).unwrap_or_default();
        if covered.contains(&own) {
            continue;
        }
        if !result.is_robot {
            covered.extend(
                result
                    .reads
                    .iter()
                    .filter_map(|path| session.vfs.identity(path)),
            );
        }
        kept.push(result);
    }
    leave_out_copies(session, &mut kept);
    kept
}

/// The files of the tasks that another one may include, by what its text says.
fn statically_included(session: &Session, tasks: &[CheckTask]) -> FastSet<PathBuf> {
    if tasks.iter().all(|task| task.reason != CheckReason::Walked) {
        return FastSet::default();
    }
    let files: FastSet<&Path> = tasks.iter().map(|task| task.file.as_path()).collect();
    let files: Vec<&Path> = files.into_iter().collect();
    let sources = files
        .par_iter()
        .filter_map(|file| session.vfs.document(file).ok());
    let included = Included::of_files(sources.collect(), &session.packages);
    files
        .into_par_iter()
        .filter(|file| included.has(file))
        .map(Path::to_path_buf)
        .collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::PathBuf;

    use crate::{CheckOptions, Report, Session, Setup};
    use vfs::testing::Tree;

    fn check(tree: &Tree) -> (Report, (usize, usize)) {
        let setup = Setup {
            about: tree.root().to_owned(),
            ..Setup::default()
        };
        let session = Session::new(&tree.environment(&[]), setup).unwrap();
        let options = CheckOptions {
            paths: vec![tree.root().to_owned()],
            ..CheckOptions::default()
        };
        let report = crate::check(&session, &options);
        (report, options.progress.get())
    }

    #[test]
    fn parts_of_robots_are_not_expanded_again() {
        let tree = Tree::new();
        let robot = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                     <xacro:arg name='kind' default='left'/>\
                     <xacro:include filename='parts/$(arg kind).xacro'/><link name='base_link'/></robot>";
        tree.write("r.urdf.xacro", robot);
        for part in ["left", "right", "alone"] {
            tree.write(&format!("parts/{part}.xacro"), "<robot/>");
        }
        let (report, progress) = check(&tree);
        let roots: BTreeSet<PathBuf> = report.roots.into_iter().collect();
        // whoever passes another argument includes the other one
        let expected = ["r.urdf.xacro", "parts/right.xacro"].map(|file| tree.path(file));
        assert_eq!(
            roots,
            BTreeSet::from(expected)
                .into_iter()
                .chain([tree.path("parts/alone.xacro")])
                .collect()
        );
        assert_eq!((report.robots, progress), (1, (4, 4)));
    }

    #[test]
    fn meshes_are_read_whether_they_are_there_or_not() {
        let tree = Tree::new();
        let body =
            |name: &str| format!("<visual><geometry><mesh filename='{name}'/></geometry></visual>");
        let bodies = body("there.stl") + &body("gone.stl");
        tree.write(
            "r.urdf",
            &format!("<robot name='r'><link name='base_link'>{bodies}</link></robot>"),
        );
        tree.write("there.stl", "solid");
        let (report, _) = check(&tree);
        for file in ["r.urdf", "there.stl", "gone.stl"] {
            assert!(report.reads.contains(&tree.path(file)), "{file}");
        }
    }
}
