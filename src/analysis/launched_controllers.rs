//! Controllers that launch files start, compared with the files of parameters that say what they are.
use std::path::{Path, PathBuf};

use super::beside::{beside_around, beside_settings};
use super::includers::is_for_tests;
use super::kept::is_launch_left_over;
use super::session::Session;
use super::uses::is_example_of_driver;
use base::Span;
use packages::nearest;
use project::SpannedName;
use rules::{Finding, Severity, spawned_controller_not_found};
use workspace::launch::SpawnedController;
use workspace::{SpawnedControllers, has_name};

/// A controller of a file of parameters, with its type, and where it stands.
struct KnownController {
    name: String,
    span: Span,
}

/// What is started in vain by the launch files below a folder that are asked for.
pub(super) fn findings_of_spawners(
    session: &Session,
    top: &Path,
    is_asked: impl Fn(&PathBuf) -> bool,
) -> Vec<Finding> {
    let spawned = session.callers.spawned_below(top);
    let asked = spawned
        .iter()
        .filter(|one| is_asked(&one.file) && !session.settings(&one.file).excludes(&one.file));
    asked.flat_map(|one| unknown(session, one)).collect()
}

fn unknown(session: &Session, spawned: &SpawnedControllers) -> Vec<Finding> {
    let Ok(text) = session.vfs.text(&spawned.file) else {
        return Vec::new();
    };
    // nearly all names stand in some file, which need not be understood for it
    let is_said = |name: &str| {
        text.text.contains(&format!("{name}.type")) || is_in_some_file(session, spawned, name)
    };
    let unsaid = spawned.controllers.iter().filter(|one| !is_said(&one.name));
    let unsaid: Vec<&SpawnedController> = unsaid.collect();
    if unsaid.is_empty() {
        return Vec::new();
    }
    let known = controllers_for(session, &spawned.file, &text.text);
    let Some(first) = known.first() else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for one in unsaid {
        let name = one.name.as_str();
        let span = Span {
            file: session.vfs.file_id(&spawned.file),
            range: one.range,
        };
        let near = nearest(name, known.iter().map(|known| known.name.as_str()));
        found.push(spawned_controller_not_found(
            span,
            name,
            (&first.name, first.span),
            near,
        ));
    }
    let is_idle = || {
        is_launch_left_over(session, &spawned.file)
            || is_for_tests(session, &spawned.file)
            || is_example_of_driver(session, &spawned.file)
    };
    if !found.is_empty() && is_idle() {
        for finding in &mut found {
            finding.severity = finding.severity.min(Severity::Info);
        }
    }
    found
}

/// The controllers of the files of parameters in the package of a launch file, and of those that it names.
fn controllers_for(session: &Session, launch: &Path, text: &str) -> Vec<KnownController> {
    let package = session.packages.containing(launch);
    let is_for_it = |file: &&PathBuf| {
        let name = file.file_name().and_then(|name| name.to_str());
        package
            .as_ref()
            .is_some_and(|package| file.starts_with(&package.folder))
            || name.is_some_and(|name| has_name(text, name))
    };
    let around = beside_around(session, launch);
    let mut found = Vec::new();
    for file in around.iter().filter(is_for_it) {
        let Some(settings) = beside_settings(session, file) else {
            continue;
        };
        let listed = settings.listed.iter().map(|one| &one.name);
        let with_class = settings
            .controllers
            .iter()
            .filter(|one| one.class.is_some());
        let names = listed.chain(with_class.map(|one| &one.name));
        let file = session.vfs.file_id(file);
        found.extend(names.map(|SpannedName { name, range }| KnownController {
            name: name.to_string(),
            span: Span {
                file,
                range: *range,
            },
        }));
    }
    found
}

/// Whether any YAML file around a launch file has the name: it may be given to the controller manager in a way that is not seen.
fn is_in_some_file(session: &Session, spawned: &SpawnedControllers, name: &str) -> bool {
    let files = session.callers.beside(&spawned.file);
    files.iter().any(|file| {
        session
            .vfs
            .text(file)
            .is_ok_and(|text| has_name(&text.text, name))
    })
}
