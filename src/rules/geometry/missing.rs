//! Reporting a file that is not there.

use std::path::{Path, PathBuf};

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::registry::{Safety, Severity};
use super::super::sink::Sink;
use super::shapes::is_replaceable;
use crate::model::Text;

/// Report that the file `name` leads to is missing; `what` is what needs it.
///
/// Installed packages may be laid out otherwise than their sources. So a file of that name is looked for in the
/// package and around it.
pub(super) fn report(
    cx: &DocumentCx<'_>,
    out: &mut Sink<'_>,
    name: &Text,
    what: &str,
    missing: &Path,
    package: Option<&Path>,
) {
    let inside = package.and_then(|package| missing.strip_prefix(package).ok());
    let message = match (inside, package_name(&name.value)) {
        (Some(inside), Some(package)) => {
            format!("{what} is not found: package `{package}` has no `{}`", inside.display())
        }
        _ => format!("{what} is not found at `{}`", missing.display()),
    };
    let folder = missing.parent().unwrap_or(missing);
    let report = out.report(name.origin, message).group(Group::Value(folder.to_string_lossy().into()));
    let Some(found) = found_elsewhere(cx, name, missing, package) else {
        return report.help("correct the path, or add the file").done();
    };
    let uri = uri_of(cx, name, &found);
    let shown = shown(cx, name, &found);
    let points_to = missing.display();
    if inside.zip(package).is_some_and(|(inside, package)| is_installed(cx, &found, inside, package)) {
        let help = format!(
            "the file is `{shown}`, which the package installs to where the URI points, `{points_to}`"
        );
        return report.severity(Severity::Info).help(help).done();
    }
    let report = report.help(format!("a file of this name is `{shown}`; the URI points to `{points_to}`"));
    match uri.filter(|uri| is_replaceable(name, uri)) {
        Some(uri) => report.replace_with(Safety::Unsafe, format!("write `{uri}`"), uri).done(),
        None => report.done(),
    }
}

fn package_name(uri: &str) -> Option<&str> {
    uri.strip_prefix("package://")?.split('/').next()
}

fn found_elsewhere(
    cx: &DocumentCx<'_>,
    name: &Text,
    missing: &Path,
    package: Option<&Path>,
) -> Option<PathBuf> {
    let place = cx.expansion.place(name.origin)?;
    let from = cx.expansion.files.get(place.file.0 as usize)?.source.path.clone();
    cx.world.packages.namesake(missing, package, &from)
}

/// Whether installing seems to move a file to where it is looked for: it lies there but for folders in front, and
/// the build files speak of the first of these.
fn is_installed(cx: &DocumentCx<'_>, found: &Path, inside: &Path, package: &Path) -> bool {
    let Ok(source) = found.strip_prefix(package) else { return false };
    let first = source.components().next().map(|first| first.as_os_str().to_string_lossy().into_owned());
    let Some(first) = first.filter(|_| source.ends_with(inside)) else { return false };
    ["CMakeLists.txt", "setup.py"].iter().any(|file| {
        let text = cx.world.vfs.text(&package.join(file));
        text.is_ok_and(|file| file.text.contains(&first))
    })
}

/// A file as messages call it where `name` stands: as that text would name it, else from its package, else whole.
pub(super) fn shown(cx: &DocumentCx<'_>, name: &Text, file: &Path) -> String {
    let in_package = || {
        let package = cx.world.packages.containing(file)?;
        let inside = file.strip_prefix(&package.folder).ok()?.to_str()?;
        Some(format!("package://{}/{inside}", package.name))
    };
    uri_of(cx, name, file).or_else(in_package).unwrap_or_else(|| file.display().to_string())
}

/// How a file is named in place of `name`.
fn uri_of(cx: &DocumentCx<'_>, name: &Text, file: &Path) -> Option<String> {
    if name.value.starts_with("package://") {
        let package = cx.world.packages.containing(file)?;
        let inside = file.strip_prefix(&package.folder).ok()?.to_str()?;
        return Some(format!("package://{}/{inside}", package.name));
    }
    if name.value.contains("://") {
        return None;
    }
    let place = cx.expansion.place(name.origin)?;
    let source = &cx.expansion.files.get(place.file.0 as usize)?.source.path;
    Some(file.strip_prefix(source.parent()?).ok()?.to_str()?.to_owned())
}
