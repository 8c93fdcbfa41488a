//! What a file has only once programs have changed its text or downloaded its data.
use std::path::{Component, Path};

use super::check_task::CheckTask;
use super::lowered::lower_where;
use super::session::Session;
use super::texts::text_of;
use rules::{Finding, Severity, named};
use workspace::{downloads_data, is_page};

/// What is wrong only before a program changes the text or gets the data is an info.
pub(super) fn settle_made_elsewhere(session: &Session, task: &CheckTask, findings: &mut [Finding]) {
    let is_rewritten = |finding: &Finding| {
        let is_about_package = finding.rule == named::MISSING_PACKAGE_DEPENDENCY
            || finding.rule == named::PACKAGE_NOT_FOUND;
        is_about_package && is_find_rewritten(session, &task.file, finding)
    };
    lower_where(findings, is_rewritten, || Some(Severity::Info));
    let is_absent = |finding: &Finding| {
        finding.rule == named::MESH_NOT_FOUND && has_no_such_folder(session, &task.file, finding)
    };
    let downloads = || downloads_data(&session.packages, &task.file).then_some(Severity::Info);
    lower_where(findings, is_absent, downloads);
    let is_to_be_had = |finding: &Finding| {
        finding.rule == named::MESH_NOT_FOUND
            && (has_only_a_page(session, &task.file, finding)
                || is_downloaded(session, &task.file, finding))
    };
    lower_where(findings, is_to_be_had, || Some(Severity::Info));
}

/// Whether a program changes the `$(find ...)` that a finding is about, in the robot or in the file of the finding.
fn is_find_rewritten(session: &Session, robot: &Path, finding: &Finding) -> bool {
    let Some(package) = text_of(&session.vfs, finding) else {
        return false;
    };
    let find = format!("$(find {})", package.trim());
    let own = session.vfs.path(finding.span.file);
    session.callers.rewrite(robot, &find) || session.callers.rewrite(&own, &find)
}

/// Whether the path of a mesh is relative, and nothing in the folders of its package begins like it.
fn has_no_such_folder(session: &Session, file: &Path, finding: &Finding) -> bool {
    let text = text_of(&session.vfs, finding).unwrap_or_default();
    let mut parts = Path::new(text.trim_start_matches("./")).components();
    let (Some(Component::Normal(first)), Some(_)) = (parts.next(), parts.next()) else {
        return false;
    };
    let package = session
        .packages
        .containing(file)
        .map(|package| package.folder);
    let is_inside = |folder: &&Path| {
        package
            .as_ref()
            .is_some_and(|package| folder.starts_with(package))
    };
    !text.contains([':', '$'])
        && !file
            .ancestors()
            .skip(1)
            .take_while(is_inside)
            .any(|folder| session.vfs.exists(&folder.join(first)))
}

/// Whether the folder of a mesh holds a page and nothing else: it says where to get the meshes.
fn has_only_a_page(session: &Session, file: &Path, finding: &Finding) -> bool {
    let text = text_of(&session.vfs, finding).unwrap_or_default();
    let named = text
        .strip_prefix("package://")
        .and_then(|rest| rest.split_once('/'));
    let folder = named.and_then(|(package, path)| {
        let package = session.packages.find(package, file).ok()?;
        Some(package.path.join(Path::new(path).parent()?))
    });
    let Some(folder) = folder.filter(|_| !text.contains('$')) else {
        return false;
    };
    let names = session.vfs.list_dir(&folder);
    let mut names = names
        .iter()
        .filter(|entry| !entry.name.starts_with('.'))
        .peekable();
    names.peek().is_some() && names.all(|entry| !entry.is_dir && is_page(&folder.join(&entry.name)))
}

/// Whether a program downloads the mesh that is missing: it has its name.
fn is_downloaded(session: &Session, file: &Path, finding: &Finding) -> bool {
    let text = text_of(&session.vfs, finding).unwrap_or_default();
    let name = text.rsplit('/').next().unwrap_or_default();
    !name.contains('$') && !name.is_empty() && session.callers.download(file, name)
}
