//! Which descriptions are robots, by their texts, and what they are called.
use std::path::{Path, PathBuf};

use super::super::graph::gives_robot;
use super::super::session::Session;
use super::sort::sort;
use facts::{Fact, FactKind, facts_of, parts_where};

/// The name that the root element of a file says.
pub(in super::super) fn robot_name(session: &Session, path: &Path) -> Option<String> {
    let source = session.vfs.document(path).ok()?;
    let name = source.document.root()?.attr("name")?.raw().to_owned();
    (!name.is_empty()).then_some(name)
}

/// Whether a file is a description that gives a robot.
pub(super) fn is_robot(session: &Session, path: &Path) -> bool {
    sort(path).is_none()
        && session
            .vfs
            .document(path)
            .is_ok_and(|source| gives_robot(&source.document))
}

/// Whether a file with the name of a robot takes all of it from others.
pub(super) fn collects(session: &Session, path: &Path) -> bool {
    let Ok(source) = session.vfs.document(path) else {
        return false;
    };
    let includes = |fact: &Fact| fact.kind == FactKind::Include && !fact.in_macro;
    robot_name(session, path).is_some()
        && parts_where(&source.document, |marks| marks.include)
            .any(|(_, item)| facts_of(item).named.iter().any(includes))
}

/// The robot that MoveIt loads rather than the one in `.setup_assistant`: `config/NAME.urdf.xacro`, in which the assistant
/// puts `<ros2_control>` around it.
pub(in super::super) fn extended(session: &Session, package: &Path) -> Option<PathBuf> {
    let config = package.join("config");
    let names = session.vfs.list_dir(&config);
    let mut own = names
        .iter()
        .filter(|entry| !entry.is_dir && entry.name.ends_with(".urdf.xacro"));
    let only = own.next().filter(|_| own.next().is_none())?;
    Some(config.join(&only.name)).filter(|file| is_robot(session, file))
}

/// The name of a file before its first ending, `arm` of `arm.urdf.xacro`.
pub(in super::super) fn stem(path: &Path) -> Option<&str> {
    path.file_name()?.to_str()?.split('.').next()
}
