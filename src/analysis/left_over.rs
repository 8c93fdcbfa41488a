//! Files of a package that nothing uses, beside others that are used.
use std::path::{Path, PathBuf};

use super::beside::{extended, stem};
use super::includers::includers;
use super::session::Session;
use super::{graph, walk};
use base::FastSet;

/// Whether launch files, programs or build files load other descriptions than those of the package that nothing can mean.
pub(super) fn is_left_over(session: &Session, file: &Path) -> bool {
    let mut launched = session.callers.launched_instead(file, false);
    if !launched.is_empty() && may_be_given(session, file, &launched) {
        launched = session.callers.launched_instead(file, true);
    }
    let Some(package) = session.packages.containing(file) else {
        return false;
    };
    if launched.is_empty() {
        return is_variant(session, file, &package.folder);
    }
    let is_launched = |other: &PathBuf| {
        let name = other.file_name().and_then(|name| name.to_str());
        other != file && name.is_some_and(|name| launched.contains(name))
    };
    walk::all_descriptions(&package.folder, &session.vfs, &session.env)
        .iter()
        .any(is_launched)
        || session.callers.load_another(file)
            && !is_built_for_moveit(session, file, &package.folder)
}

/// Whether a program that builds the configuration of MoveIt reads a file without its name.
pub(super) fn is_built_for_moveit(session: &Session, file: &Path, package: &Path) -> bool {
    extended(session, package).as_deref() == Some(file) && session.callers.build_for_moveit(file)
}

/// Whether somebody may start a launch file that takes the name of any description with this one: it is a robot, and none of
/// the same name is launched.
fn may_be_given(session: &Session, file: &Path, launched: &FastSet<String>) -> bool {
    let is_same = |name: &String| {
        let other = file.with_file_name(name);
        other != file && stem(&other) == stem(file) && session.vfs.is_file(&other)
    };
    gives_robot(session, file) && !launched.iter().any(is_same)
}

/// Whether a robot is named by nothing, while another one of its package is part of a robot.
fn is_variant(session: &Session, file: &Path, package: &Path) -> bool {
    let is_used = |other: &PathBuf| {
        let is_outside = |by: &PathBuf| !by.starts_with(package);
        other != file
            && includers(session, other).iter().any(is_outside)
            && gives_robot(session, other)
    };
    gives_robot(session, file)
        && !session.callers.load(file)
        && !session.callers.launch(file)
        && walk::all_descriptions(package, &session.vfs, &session.env)
            .iter()
            .any(is_used)
}

fn gives_robot(session: &Session, file: &Path) -> bool {
    session
        .vfs
        .document(file)
        .is_ok_and(|source| graph::gives_robot(&source.document))
}
