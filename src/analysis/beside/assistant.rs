//! What `.setup_assistant` of MoveIt says, compared with the files that it names.
use std::path::{Path, PathBuf};

use super::super::declared::KnownArguments;
use super::super::options::CheckOptions;
use super::super::root_analysis::RootAnalysis;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::files::{Beside, Robots};
use super::robots::{extended, stem};
use super::sort::beside_around;
use base::{CancelFlag, Span, TextRange};
use expand::{Expansion, Problem, ProblemKind, Severity};
use packages::nearest;
use project::{Assistant, SpannedName};
use rules::{
    Finding, setup_assistant_file_not_found, setup_assistant_robot_fails,
    setup_assistant_unknown_argument,
};
use workspace::is_ignored_by_git;

/// What there is to say about a `.setup_assistant`.
pub(super) fn assistant_findings(
    session: &Session,
    own: &Beside,
    robots: &Robots,
    cancel: &CancelFlag,
) -> Vec<Finding> {
    let assistant = own
        .settings()
        .and_then(|settings| settings.assistant.as_ref());
    let package = session.packages.containing(&own.path);
    // copies elsewhere are read by nobody
    let is_read = package
        .as_ref()
        .is_some_and(|package| package.folder.join(".setup_assistant") == own.path);
    let Some(assistant) = assistant.filter(|_| is_read) else {
        return Vec::new();
    };
    // the assistant itself asks for another file
    let is_needed = || session.callers.build_package_for_moveit(&own.path);
    let mut found = Vec::new();
    if let (Some(srdf), Some(package)) = (&assistant.srdf, &package)
        && is_not_there(session, &package.folder.join(srdf.name.as_str()))
    {
        let finding = setup_assistant_file_not_found(span_of(own, srdf), &srdf.name, &package.name);
        // a program makes the SRDFs
        let is_source = |path: &PathBuf| {
            path.starts_with(&package.folder) && path.to_string_lossy().ends_with(".srdf.xacro")
        };
        let is_made = beside_around(session, &own.path).iter().any(is_source);
        found.push(at_most_info(
            finding,
            !is_needed() || is_made || is_for_windows(srdf),
        ));
    }
    let (Some(name), Some(urdf)) = (&assistant.package, &assistant.urdf) else {
        return found;
    };
    let Ok(folder) = session.packages.find(&name.name, &own.path) else {
        return found;
    };
    let file = session
        .packages
        .present(&folder.path.join(urdf.name.as_str()))
        .into_owned();
    let file = vfs::without_parents(&session.vfs.absolute(&file));
    if is_not_there(session, &file) {
        let finding = setup_assistant_file_not_found(span_of(own, urdf), &urdf.name, &name.name);
        found.push(at_most_info(finding, !is_needed() || is_for_windows(urdf)));
    }
    if session.vfs.is_file(&file) {
        found.extend(assistant_failure(
            session, own, assistant, &file, robots, cancel,
        ));
        found.extend(unread_arguments(session, own, assistant, &file));
    }
    found
}

/// Whether a file is not there, and nothing says that somebody makes it: Git leaves it out, or a file of the same name with
/// another ending is its source.
fn is_not_there(session: &Session, path: &Path) -> bool {
    let is_named = path.to_str().is_some_and(|path| !path.contains(['$', '{']));
    is_named
        && !session.vfs.exists(path)
        && session.packages.containing(path).is_some()
        && !is_ignored_by_git(&session.packages, path)
        && (is_xacro(&path.to_string_lossy()) || !has_source(session, path))
}

/// Whether a file in xacro beside a file has its name with another ending.
fn has_source(session: &Session, path: &Path) -> bool {
    let Some(stem_of_path) = stem(path) else {
        return false;
    };
    let folder = path.parent().unwrap_or(path);
    session.vfs.list_dir(folder).iter().any(|entry| {
        !entry.is_dir && stem(Path::new(&entry.name)) == Some(stem_of_path) && is_xacro(&entry.name)
    })
}

/// An error of the robot that the arguments cause.
fn assistant_failure(
    session: &Session,
    own: &Beside,
    assistant: &Assistant,
    file: &Path,
    robots: &Robots,
    cancel: &CancelFlag,
) -> Option<Finding> {
    let (arguments, args) = (assistant.arguments.as_ref()?, assistant.given());
    let with = robots.get(&RootConfig {
        args,
        ..RootConfig::plain(file)
    })?;
    let errors = errors(&with.expansion);
    if errors.is_empty()
        || errors
            .iter()
            .any(|error| error.kind == ProblemKind::PackageNotFound)
    {
        return None;
    }
    let options = CheckOptions {
        cancel: cancel.clone(),
        ..CheckOptions::default()
    };
    let plain = RootAnalysis::of(session, &RootConfig::plain(file), &options).expansion;
    let before: Vec<_> = plain
        .problems
        .iter()
        .map(|error| (error.kind, place(&plain, error)))
        .collect();
    let is_new = |error: &&&Problem| !before.contains(&(error.kind, place(&with.expansion, error)));
    let error = errors
        .iter()
        .find(is_new)
        .filter(|_| !cancel.is_cancelled())?;
    let span = Span {
        file: own.file,
        range: arguments.range,
    };
    let name = file.file_name()?.to_string_lossy();
    Some(setup_assistant_robot_fails(
        span,
        &name,
        (place(&with.expansion, error)?, &error.message),
    ))
}

/// Arguments that nothing in the robot reads.
fn unread_arguments(
    session: &Session,
    own: &Beside,
    assistant: &Assistant,
    file: &Path,
) -> Vec<Finding> {
    let Some(arguments) = &assistant.arguments else {
        return Vec::new();
    };
    let package = session.packages.containing(&own.path);
    let extended = package.and_then(|package| extended(session, &package.folder));
    let files: Vec<PathBuf> = [file.to_owned()].into_iter().chain(extended).collect();
    let known: Vec<_> = files
        .iter()
        .map(|file| KnownArguments::of(session, file))
        .collect();
    if !known.iter().all(|known| known.complete) {
        return Vec::new();
    }
    let shown = file.file_name().unwrap_or_default().to_string_lossy();
    let text = session.vfs.text(&own.path);
    let text = text.as_ref().map_or("", |text| &*text.text);
    let unknown = assistant.given().into_iter().map(|(name, _)| name);
    let unknown = unknown.filter(|name| {
        !known
            .iter()
            .any(|known| known.names.contains(name.as_str()))
    });
    let finding = |name: String| {
        let span = Span {
            file: own.file,
            range: place_of_argument(text, arguments.range, &name),
        };
        let names = known.iter().flat_map(|known| &known.names);
        let near = nearest(&name, names.map(|name| name.as_str()));
        setup_assistant_unknown_argument(span, &name, &shown, near)
    };
    unknown.map(finding).collect()
}

fn is_xacro(name: &str) -> bool {
    name.ends_with(".xacro")
}

/// The errors for which xacro gives no robot.
fn errors(expansion: &Expansion) -> Vec<&Problem> {
    let is_error = |problem: &&Problem| {
        problem.severity == Severity::Error && !problem.probed && !problem.excused
    };
    expansion.problems.iter().filter(is_error).collect()
}

fn place(expansion: &Expansion, problem: &Problem) -> Option<Span> {
    let file = expansion.files.get(problem.place.file)?.source.id;
    Some(Span {
        file,
        range: problem.place.range,
    })
}

/// A finding, as an info where `is_info`.
fn at_most_info(mut finding: Finding, is_info: bool) -> Finding {
    if is_info {
        finding.severity = finding.severity.min(rules::Severity::Info);
    }
    finding
}

/// Whether a path is written with backslashes, which separate folders on Windows.
fn is_for_windows(path: &SpannedName) -> bool {
    path.name.contains('\\')
}

fn span_of(own: &Beside, named: &SpannedName) -> Span {
    Span {
        file: own.file,
        range: named.range,
    }
}

/// The place of the name of an argument among those that `.setup_assistant` gives; all of them where it is not found.
fn place_of_argument(text: &str, arguments: TextRange, name: &str) -> TextRange {
    let written = arguments.slice(text);
    let Some(at) = written.find(&format!("{name}:=")) else {
        return arguments;
    };
    let start = arguments.start + at as u32;
    TextRange::new(start, start + name.len() as u32)
}
