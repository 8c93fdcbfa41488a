//! Reporting files that are not there: one finding for those of a robot that are missing in one folder of a package.
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use indexmap::IndexMap;

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Safety, Severity};
use super::super::sink::{Reported, Sink};
use super::shapes::is_replaceable;
use model::AttrValue;
use vfs::{DirEntry, Vfs};
use workspace::is_ignored_by_git;

/// Endings of archives in which packages ship their meshes.
const ARCHIVES: [&str; 5] = ["7z", "rar", "tar.gz", "tgz", "zip"];

/// The missing files of a robot by package and folder.
#[derive(Default)]
pub(super) struct MissingFiles<'a>(IndexMap<(Option<PathBuf>, PathBuf), Vec<MissingFile<'a>>>);

/// A file that is not there.
struct MissingFile<'a> {
    /// The text that names it.
    name: &'a AttrValue,
    /// What needs it, for the message.
    what: String,
    /// Where it would be.
    path: PathBuf,
}

impl<'a> MissingFiles<'a> {
    /// Add the file at `path`, in the folder of a package if any; `what` needs it.
    pub(super) fn add(
        &mut self,
        name: &'a AttrValue,
        what: String,
        path: &Path,
        package: Option<&Path>,
    ) {
        let folder = path.parent().unwrap_or(path).to_owned();
        let group = self
            .0
            .entry((package.map(Path::to_owned), folder))
            .or_default();
        group.push(MissingFile {
            name,
            what,
            path: path.to_owned(),
        });
    }

    /// Report the files, those of one folder as one defect.
    pub(super) fn report(self, cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
        for ((package, folder), files) in self.0 {
            report(cx, out, &files, &folder, package.as_deref());
        }
    }
}

/// The first folder of a path that does not exist: all that would be below it has one cause. The folder itself where it exists.
fn first_missing<'p>(cx: &DocumentCx<'_>, folder: &'p Path) -> &'p Path {
    let missing = folder
        .ancestors()
        .take_while(|folder| !cx.world.vfs.is_dir(folder));
    missing.last().unwrap_or(folder)
}

/// Report the missing files of one folder.
fn report(
    cx: &DocumentCx<'_>,
    out: &mut Sink<'_>,
    files: &[MissingFile<'_>],
    folder: &Path,
    package: Option<&Path>,
) {
    let namesakes: Vec<Option<PathBuf>> = files
        .iter()
        .map(|file| namesake(cx, file, package))
        .collect();
    let is_one_folder = |found: &&PathBuf| {
        namesakes
            .iter()
            .all(|other| other.as_ref().and_then(|other| other.parent()) == found.parent())
    };
    // beside files that are there, one that is missing is not another one in a folder elsewhere
    let is_moved = |found: &&PathBuf| {
        let other = found.parent().unwrap_or(found);
        !cx.world.vfs.is_dir(folder) || other.starts_with(folder) || folder.starts_with(other)
    };
    let moved = namesakes
        .first()
        .and_then(Option::as_ref)
        .filter(is_one_folder)
        .filter(is_moved);
    let missing = first_missing(cx, folder);
    for (file, found) in files.iter().zip(&namesakes) {
        let report = out
            .report(file.name.origin, message(file, package))
            .group(Group::Thing(missing.to_string_lossy().into()));
        if let Some(argument) = cx.expansion.empty_argument(&file.name.pieces) {
            let help = format!("pass {argument}:=...; argument `{argument}` is empty by default");
            report.severity(Severity::Info).help(help).done();
            continue;
        }
        if !cx.world.vfs.is_dir(folder) && is_ignored_by_git(cx.world.packages, &file.path) {
            let help = "get the files that `.gitignore` leaves out, or correct the path";
            report.severity(Severity::Info).help(help).done();
            continue;
        }
        if cx.world.packages.is_in_a_build(&file.path) {
            let help = "build the package again, or correct the path: only an installed copy of the package was found";
            report.severity(Severity::Info).help(help).done();
            continue;
        }
        if let Some(archive) = archive_of(cx.world.vfs, &file.path, package) {
            let help = format!("unpack `{archive}`, or correct the path");
            report.severity(Severity::Info).help(help).done();
            continue;
        }
        let report = report.help("correct the path, or add the file");
        match found.as_ref().filter(|_| moved.is_some()) {
            Some(found) => found_elsewhere(cx, report, file, found, package).done(),
            None => report.done(),
        }
    }
}

/// A report with where the file is, and a fix if the source spells its name.
fn found_elsewhere<'s, 'a>(
    cx: &DocumentCx<'_>,
    report: Reported<'s, 'a>,
    file: &MissingFile<'_>,
    found: &Path,
    package: Option<&Path>,
) -> Reported<'s, 'a> {
    let place = found
        .parent()
        .map_or_else(String::new, |folder| shown(cx, file.name, folder));
    if is_installed(cx, found, &file.path, package) {
        let help = format!(
            "build the package; the file is in `{place}`, and the build seems to install it where the URI points"
        );
        return report.severity(Severity::Info).help(help);
    }
    let report = report.help(format!(
        "correct the path; a file of this name is in `{place}`"
    ));
    match uri_of(cx, file.name, found).filter(|uri| is_replaceable(file.name, uri)) {
        Some(uri) => report.replace_with(Safety::Unsafe, format!("replace with `{uri}`"), uri),
        None => report,
    }
}

/// The name of an archive in a package that is called like a missing file or a folder around it.
fn archive_of(vfs: &Vfs, missing: &Path, package: Option<&Path>) -> Option<String> {
    let package = package?;
    let parts = missing
        .ancestors()
        .take_while(|part| *part != package && part.starts_with(package));
    parts.into_iter().find_map(|part| {
        let names = [part.file_name(), part.file_stem()].map(|name| name.and_then(OsStr::to_str));
        let entries = vfs.list_dir(part.parent()?);
        let is_it = |entry: &&DirEntry| {
            let (stem, ending) = entry.name.split_once('.').unwrap_or((&entry.name, ""));
            !entry.is_dir && ARCHIVES.contains(&ending) && names.contains(&Some(stem))
        };
        entries.iter().find(is_it).map(|entry| entry.name.clone())
    })
}

fn message(file: &MissingFile<'_>, package: Option<&Path>) -> String {
    let what = &file.what;
    let inside = package.and_then(|package| file.path.strip_prefix(package).ok());
    match (inside, package_name(&file.name.value)) {
        (Some(inside), Some(package)) => {
            format!(
                "{what} not found: package `{package}` has no file `{}`",
                vfs::slashed(inside)
            )
        }
        _ => format!("{what} not found at `{}`", vfs::slashed(&file.path)),
    }
}

fn package_name(uri: &str) -> Option<&str> {
    uri.strip_prefix("package://")?.split('/').next()
}

fn namesake(
    cx: &DocumentCx<'_>,
    file: &MissingFile<'_>,
    package: Option<&Path>,
) -> Option<PathBuf> {
    let place = cx.expansion.place(file.name.origin)?;
    let from = cx.expansion.files.get(place.file)?.source.path.clone();
    cx.world.packages.namesake(&file.path, package, &from)
}

/// Whether the build may move a file to where it is looked for: it is there but for folders in front, and the build
/// installs files by rules that cannot be worked out.
fn is_installed(cx: &DocumentCx<'_>, found: &Path, missing: &Path, package: Option<&Path>) -> bool {
    let Some(package) = package else { return false };
    let (Ok(source), Ok(inside)) = (found.strip_prefix(package), missing.strip_prefix(package))
    else {
        return false;
    };
    source.ends_with(inside)
        && cx
            .world
            .packages
            .build_around(missing)
            .is_some_and(|build| build.is_opaque)
}

/// A file or folder as messages call it where `name` is: as that text would name it, else from its package, else
/// whole.
pub(super) fn shown(cx: &DocumentCx<'_>, name: &AttrValue, file: &Path) -> String {
    let in_package = || cx.world.packages.containing(file)?.uri(file);
    uri_of(cx, name, file)
        .or_else(in_package)
        .unwrap_or_else(|| vfs::slashed(file))
}

/// How a file is named in place of `name`.
fn uri_of(cx: &DocumentCx<'_>, name: &AttrValue, file: &Path) -> Option<String> {
    if name.value.starts_with("package://") {
        return cx.world.packages.containing(file)?.uri(file);
    }
    if name.value.contains("://") {
        return None;
    }
    let place = cx.expansion.place(name.origin)?;
    let source = &cx.expansion.files.get(place.file)?.source.path;
    let inside = file.strip_prefix(source.parent()?).ok()?;
    inside.to_str().map(|text| {
        if text.is_empty() {
            ".".to_owned()
        } else {
            vfs::slashed(inside)
        }
    })
}
