//! Files that launch files name for what they start with a robot, and that are not there or are not installed.
use std::path::Path;

use super::launched_descriptions::LaunchedDescriptions;
use super::session::Session;
use base::Span;
use rules::{Finding, Group, Severity, launched_file_not_installed};
use workspace::RobotCall;

/// A file that a launch file names, under none of the arguments of which there is one, and that nothing makes.
pub(super) fn missing_file(session: &Session, group: &[RobotCall]) -> Option<Finding> {
    let mut finding = LaunchedDescriptions(session).missing_load(group)?;
    let mut targets = group.iter().filter_map(|call| call.target.as_deref());
    let target = targets.find(|path| !session.vfs.exists(path))?;
    // a folder that is missing or was renamed is one mistake
    let folder = target.parent().unwrap_or(target).display();
    finding.group = Some(Group::Thing(format!("files in {folder}").into()));
    lower_for_tests(session, group, &mut finding);
    Some(finding)
}

/// What only tests need is an info: they may run in the sources, or not at all.
fn lower_for_tests(session: &Session, group: &[RobotCall], finding: &mut Finding) {
    let mut callers = group.iter().map(|call| &call.call.caller);
    if callers.any(|caller| session.callers.is_of_tests(caller)) {
        finding.severity = finding.severity.min(Severity::Info);
    }
}

/// A file that a launch file of ROS 2 names in the folder of an installed package, where the build does not put it.
pub(super) fn uninstalled_file(session: &Session, group: &[RobotCall]) -> Option<Finding> {
    let is_uninstalled = |call: &&RobotCall| build_without(session, call).is_some();
    let call = group.iter().find(is_uninstalled)?;
    let (build, inside) = build_without(session, call)?;
    let span = Span {
        file: session.vfs.file_id(&call.call.caller),
        range: call.call.file.written().unwrap_or(call.call.range),
    };
    let (package, _) = call.call.file.in_package()?;
    let mut finding = launched_file_not_installed(span, package, &inside, &build);
    lower_for_tests(session, group, &mut finding);
    Some(finding)
}

/// The name of the build file that does not install what a call names, and the path of that in its package.
fn build_without(session: &Session, call: &RobotCall) -> Option<(String, String)> {
    let packages = &session.packages;
    let (name, _) = call.call.file.in_package()?;
    let path = call.call.file.path(packages, &call.call.caller)?;
    let path = Some(&*path).filter(|path| session.vfs.is_file(path))?;
    let package = packages.containing(path).filter(|own| own.name == name)?;
    let build = packages.build_around(path)?;
    let inside = path.strip_prefix(&package.folder).ok()?;
    // what is installed by rules that cannot be worked out may be anything
    if build.is_opaque || !build.is_ament || build.installs_file(&session.vfs, name, inside) {
        return None;
    }
    let mut files = build.files.iter().filter(|file| session.vfs.is_file(file));
    let file = files.next().and_then(|file| file.file_name())?;
    let shown = vfs::slashed(Path::new(inside));
    Some((file.to_string_lossy().into_owned(), shown))
}
