//! Which robot a file beside it is for.
//!
//! First counts what another file says: the setup assistant of MoveIt, the `<parameters>` of a plugin, a launch file that
//! names both. Else a robot of the same name is meant, in the same package before others; then most of the names have to
//! fit. From likeness alone nothing is concluded.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;

use super::super::includers::{includers, is_included};
use super::super::root_config::RootConfig;
use super::super::roots::variants;
use super::super::session::Session;
use super::paired::{MOST_ROBOTS, Pairing};
use super::robots::{collects, extended, is_robot, robot_name, stem};
use super::sort::{Sort, beside_around, beside_settings, sort};
use base::FastSet;
use facts::parts_where;
use project::{Assistant, SpannedName};
use workspace::{RobotCall, has_name};

/// The robots that a file beside them may be for.
pub(in super::super) fn pairing_of(session: &Session, path: &Path) -> Arc<Pairing> {
    if let Some(known) = session.pairings().get(path) {
        return known.clone();
    }
    let made = Arc::new(paired_by_text(session, path));
    session.pairings().insert(path.to_owned(), made.clone());
    made
}

/// The files beside robots around a path. Where there are many, it is found out for all of them at once which robots they are
/// for: none waits for another.
pub(super) fn paired_around(session: &Session, path: &Path) -> Arc<Vec<PathBuf>> {
    /// Fewer are done before other threads have begun.
    const MANY: usize = 16;
    let around = beside_around(session, path);
    let are_new = around.len() >= MANY && {
        let known = session.pairings();
        around.iter().any(|file| !known.contains_key(file))
    };
    if are_new {
        // what all of them ask for is made once
        is_included(session, path);
        around.par_iter().for_each(|file| {
            pairing_of(session, file);
        });
    }
    around
}

fn paired_by_text(session: &Session, path: &Path) -> Pairing {
    if is_loaded_by_xacro(session, path) {
        return Pairing::default();
    }
    let by_name = || match sort(path) {
        Some(Sort::Srdf) => of_the_name(session, path),
        _ => of_the_srdf(session, path),
    };
    // one of several files of a name is meant where the text says its folder as well
    let by_folder = || {
        let found =
            || by_parameters(session, path, true).or_else(|| by_launch(session, path, true));
        is_one_of_several(session, path).then(found)?
    };
    let named = by_assistant(session, path).or_else(by_folder);
    named
        .or_else(|| by_parameters(session, path, false))
        .or_else(|| by_launch(session, path, false))
        .unwrap_or_else(by_name)
}

/// Whether another folder of the package has a file of the same name.
pub(in super::super) fn is_one_of_several(session: &Session, path: &Path) -> bool {
    let is_near = near(session, path);
    let is_other = |other: &PathBuf| {
        other.file_name() == path.file_name() && other.parent() != path.parent() && is_near(other)
    };
    sort(path) == Some(Sort::Yaml) && beside_around(session, path).iter().any(is_other)
}

/// Whether a description of the package loads a YAML file: it holds numbers for xacro, and its keys are no names of the
/// robot.
fn is_loaded_by_xacro(session: &Session, path: &Path) -> bool {
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
        return false;
    };
    let loads = |file: &PathBuf| {
        let text = session.vfs.text(file);
        text.is_ok_and(|text| has_name(&text.text, name)) && !has_parameters(session, file)
    };
    if is_for_manager(session, path) {
        return false;
    }
    let is_near = near(session, path);
    let all = session.callers.descriptions(path);
    let mut near = all.iter().filter(|file| is_near(file));
    sort(path) == Some(Sort::Yaml) && near.any(loads)
}

/// Whether a file lists controllers for a controller manager.
pub(in super::super) fn is_for_manager(session: &Session, path: &Path) -> bool {
    let settings = (sort(path) == Some(Sort::Yaml))
        .then(|| beside_settings(session, path))
        .flatten();
    settings.is_some_and(|settings| !settings.listed.is_empty())
}

/// The robot that `.setup_assistant` in the same package names.
fn by_assistant(session: &Session, path: &Path) -> Option<Pairing> {
    let package = session.packages.containing(path)?;
    let file = package.folder.join(".setup_assistant");
    let settings = session
        .vfs
        .is_file(&file)
        .then(|| beside_settings(session, &file))??;
    let assistant = settings.assistant.as_ref()?;
    if sort(path) == Some(Sort::Srdf)
        && assistant
            .srdf
            .as_ref()
            .map(|srdf| package.folder.join(srdf.name.as_str()))
            .is_some_and(|srdf| session.vfs.absolute(&srdf) != path)
    {
        return None;
    }
    if path != file && names_another_srdf(session, assistant, &package.folder) {
        return None;
    }
    let (name, urdf) = (assistant.package.as_ref()?, assistant.urdf.as_ref()?);
    let folder = session.packages.find(&name.name, path).ok()?.path;
    let file = session
        .packages
        .present(&folder.join(urdf.name.as_str()))
        .into_owned();
    let file = vfs::without_parents(&session.vfs.absolute(&file));
    let srdf = assistant
        .srdf
        .as_ref()
        .map_or("", |srdf| srdf.name.as_str());
    let wrappers = wrappers(session, &package.folder, srdf);
    if !wrappers.is_empty() {
        return Pairing::named(wrappers);
    }
    let file = extended(session, &package.folder).unwrap_or(file);
    let root = RootConfig {
        args: assistant.given(),
        ..RootConfig::plain(&file)
    };
    // what the assistant was given once may have given way to others
    let loaded = loaded_in(session, &package.folder, path);
    let mut same = loaded.iter().filter(|other| other.file == file).peekable();
    let mut roots = vec![root];
    if same.peek().is_none() {
        roots.extend(loaded);
    } else if assistant.given().is_empty() && same.all(|other| !other.args.is_empty()) {
        // nobody takes its defaults
        roots = loaded;
    }
    roots.truncate(MOST_ROBOTS);
    session.vfs.is_file(&file).then(|| Pairing::named(roots))?
}

/// Whether the assistant names an SRDF that is not there while the package has another one: it was copied with the package.
fn names_another_srdf(session: &Session, assistant: &Assistant, package: &Path) -> bool {
    let is_gone = |srdf: &SpannedName| !session.vfs.is_file(&package.join(srdf.name.as_str()));
    let is_other = |file: &PathBuf| sort(file) == Some(Sort::Srdf) && file.starts_with(package);
    assistant.srdf.as_ref().is_some_and(is_gone)
        && beside_around(session, &package.join("_"))
            .iter()
            .any(is_other)
}

/// The robots that launch files of a package load.
fn loaded_in(session: &Session, package: &Path, path: &Path) -> Vec<RootConfig> {
    let calls = session.callers.calls(path);
    let own = calls
        .iter()
        .filter(|call| call.call.caller.starts_with(package));
    let mut found: Vec<RootConfig> = Vec::new();
    for root in own.filter_map(|call| started(session, call)) {
        if !found.contains(&root) {
            found.push(root);
        }
    }
    found
}

/// The robots in `config` of a package that have the name of its SRDF, where there are several: for left and right hands, say.
fn wrappers(session: &Session, package: &Path, srdf: &str) -> Vec<RootConfig> {
    let config = package.join("config");
    let name = robot_name(session, &package.join(srdf));
    let names = session.vfs.list_dir(&config);
    let files = names
        .iter()
        .filter(|entry| !entry.is_dir && entry.name.ends_with(".urdf.xacro"))
        .map(|entry| config.join(&entry.name));
    let mut found: Vec<PathBuf> = files
        .filter(|file| name.is_some() && robot_name(session, file) == name)
        .collect();
    found.truncate(MOST_ROBOTS);
    if found.len() < 2 {
        found.clear();
    }
    found.iter().map(|by| RootConfig::plain(by)).collect()
}

/// The robots with a plugin that names the file, and its folder where that is asked for.
fn by_parameters(session: &Session, path: &Path, with_folder: bool) -> Option<Pairing> {
    let name = path.file_name()?.to_str()?;
    if sort(path) != Some(Sort::Yaml) {
        return None;
    }
    // a file for a controller manager is nothing else to a robot than parameters of its plugin
    let is_for_manager = is_for_manager(session, path);
    let says = |file: &&PathBuf| {
        session.vfs.text(file).is_ok_and(|text| {
            has_name(&text.text, name)
                && (is_for_manager || has_parameters(session, file))
                && (!with_folder || has_folder(&text.text, path))
                && may_mean(session, file, path)
        })
    };
    let all = session.callers.descriptions(path);
    let naming = all.iter().filter(says).take(MOST_ROBOTS);
    let roots = naming.flat_map(|file| roots_reading(session, file));
    Pairing::named(roots.flat_map(|root| ways_of(session, &root)).collect())
}

/// Whether a description names a file of parameters for a plugin.
fn has_parameters(session: &Session, file: &Path) -> bool {
    session.vfs.document(file).is_ok_and(|source| {
        let mut parts = parts_where(&source.document, |marks| marks.parameters);
        parts.next().is_some()
    })
}

/// Whether a text that names a file without its folder may mean this one: it lies in the same package, or the text
/// says the package.
fn may_mean(session: &Session, by: &Path, path: &Path) -> bool {
    match (
        session.packages.containing(path),
        session.packages.containing(by),
    ) {
        (Some(own), Some(other)) if own.folder == other.folder => true,
        (Some(own), _) => session
            .vfs
            .text(by)
            .is_ok_and(|text| has_name(&text.text, &own.name)),
        (None, _) => path
            .parent()
            .and_then(Path::parent)
            .is_some_and(|near| by.starts_with(near)),
    }
}

/// The only robot that launch files of the package start.
fn started_near(session: &Session, path: &Path) -> Vec<RootConfig> {
    let calls = session.callers.calls(path);
    let is_near = near(session, path);
    let near = calls.iter().filter(|call| is_near(&call.call.caller));
    let roots: Vec<RootConfig> = near.filter_map(|call| started(session, call)).collect();
    let is_one = roots
        .windows(2)
        .all(|pair| matches!(pair, [a, b] if a.file == b.file));
    if is_one { roots } else { Vec::new() }
}

/// The robot that a launch file calls.
fn started(session: &Session, call: &RobotCall) -> Option<RootConfig> {
    let file = call
        .target
        .as_ref()
        .filter(|file| is_robot(session, file) || collects(session, file))?;
    let args = call.call.args.iter().filter_map(|argument| {
        let value = argument.given(&session.packages, &call.call.caller)?;
        Some((argument.name.clone(), value))
    });
    Some(RootConfig {
        args: args.collect(),
        ..RootConfig::plain(file)
    })
}

/// The robots that a launch file calls which names the file, or builds the configuration of its package.
pub(super) fn by_launch(session: &Session, path: &Path, with_folder: bool) -> Option<Pairing> {
    let name = path.file_name()?.to_str()?;
    let package = session.packages.containing(path)?;
    let says = |call: &RobotCall| {
        let caller = &call.call.caller;
        let Ok(text) = session.vfs.text(caller) else {
            return false;
        };
        let is_it = has_name(&text.text, name) && may_mean(session, caller, path);
        if with_folder {
            return is_it && has_folder(&text.text, path);
        }
        is_it
            || text.text.contains("MoveItConfigsBuilder")
                && (has_name(&text.text, &package.name) || caller.starts_with(&package.folder))
                && sort(path) != Some(Sort::Srdf)
    };
    let mut roots: Vec<RootConfig> = Vec::new();
    // a file that is loaded for a robot elsewhere, too, may be for that one alone
    let mut is_named = true;
    let calls = session.callers.calls(path);
    for group in calls.chunk_by(|a, b| a.call.caller == b.call.caller) {
        if !group.first().is_some_and(says) {
            continue;
        }
        is_named &= group.iter().all(|call| call.target.is_some());
        for root in group.iter().filter_map(|call| started(session, call)) {
            if !roots.contains(&root) {
                roots.push(root);
            }
        }
    }
    Pairing::named(roots).map(|found| Pairing { is_named, ..found })
}

/// The robots in a file of the same name in the same folder, `arm.urdf` for `arm.srdf`; else those of the name that an
/// SRDF says in the same package; else those of the name and those in a file of the same name elsewhere.
fn of_the_name(session: &Session, path: &Path) -> Pairing {
    let all = session.callers.descriptions(path);
    let is_it = |file: &&PathBuf| stem(file) == stem(path) && is_robot(session, file);
    let of_the_stem: Vec<&PathBuf> = all.iter().filter(is_it).collect();
    let mut beside = of_the_stem.clone();
    beside.retain(|file| file.parent() == path.parent());
    let found = if beside.is_empty() {
        let named = of_the_robot_name(session, path, &all);
        let is_near = near(session, path);
        let mut near = named.clone();
        near.retain(|file| is_near(file));
        if near.is_empty() {
            // copies share names: a file of the same name may be meant as well
            let further = named.into_iter().filter(|file| !of_the_stem.contains(file));
            of_the_stem.iter().copied().chain(further).collect()
        } else {
            near
        }
    } else {
        beside
    };
    let mut roots: Vec<RootConfig> = found
        .iter()
        .flat_map(|file| ways_of(session, file))
        .collect();
    roots.extend(loaded_namesakes(session, path, &roots));
    roots.truncate(MOST_ROBOTS);
    Pairing {
        roots,
        ..Pairing::default()
    }
}

/// The robots elsewhere whose name an SRDF says and that launch files of its package load; others are known already.
fn loaded_namesakes(session: &Session, path: &Path, known: &[RootConfig]) -> Vec<RootConfig> {
    let (Some(package), Some(name)) =
        (session.packages.containing(path), robot_name(session, path))
    else {
        return Vec::new();
    };
    let mut loaded = loaded_in(session, &package.folder, path);
    loaded.retain(|root| {
        robot_name(session, &root.file).as_ref() == Some(&name)
            && !known.iter().any(|one| one.file == root.file)
    });
    loaded
}

/// The robots whose name an SRDF says.
fn of_the_robot_name<'a>(session: &Session, path: &Path, all: &'a [PathBuf]) -> Vec<&'a PathBuf> {
    let Some(name) = robot_name(session, path) else {
        return Vec::new();
    };
    let is_it = |file: &&PathBuf| {
        robot_name(session, file).as_ref() == Some(&name)
            && (is_robot(session, file) || sort(file).is_none() && collects(session, file))
    };
    all.iter().filter(is_it).collect()
}

/// Whether launch files load a robot whose name an SRDF says: it may be the one that they load with the SRDF.
pub(in super::super) fn is_named_as_launched(session: &Session, path: &Path) -> bool {
    let all = session.callers.descriptions(path);
    let named = of_the_robot_name(session, path, &all);
    named.into_iter().any(|file| session.callers.launch(file))
}

/// The robots of the SRDFs in the same package; without any, the robots there.
fn of_the_srdf(session: &Session, path: &Path) -> Pairing {
    let is_near = near(session, path);
    let all = beside_around(session, path);
    let srdfs: Vec<&PathBuf> = all
        .iter()
        .filter(|file| sort(file) == Some(Sort::Srdf) && is_near(file))
        .collect();
    let mut found = Pairing::default();
    if let [only] = srdfs.as_slice() {
        (found.is_named, found.srdf) = (pairing_of(session, only).is_named, Some((*only).clone()));
    }
    for pairing in srdfs.iter().map(|srdf| pairing_of(session, srdf)) {
        let new = pairing
            .roots
            .iter()
            .filter(|root| !found.roots.contains(root))
            .cloned();
        found.roots.extend(new.collect::<Vec<_>>());
        if found.roots.len() >= MOST_ROBOTS {
            break;
        }
    }
    if found.roots.is_empty() {
        let all = session.callers.descriptions(path);
        let robots = all
            .iter()
            .filter(|file| is_near(file) && is_robot(session, file));
        found
            .roots
            .extend(robots.flat_map(|file| ways_of(session, file)));
    }
    if found.roots.is_empty() {
        found.roots = started_near(session, path);
    }
    found.roots.truncate(MOST_ROBOTS);
    found
}

/// A robot as the configuration and launch files expand it; else with its defaults.
fn ways_of(session: &Session, file: &Path) -> Vec<RootConfig> {
    let settings = session.settings(file);
    let mut ways: Vec<RootConfig> = Vec::new();
    for root in &settings.config.roots {
        if root
            .files(&session.vfs)
            .iter()
            .any(|listed| session.vfs.absolute(listed) == file)
        {
            let variants = variants(&session.callers, root, file).into_iter();
            ways.extend(variants.map(|one| RootConfig {
                file: file.to_owned(),
                args: one.args,
                preset: one.preset,
            }));
        }
    }
    if ways.is_empty() {
        ways.push(RootConfig::plain(file));
    }
    ways
}

/// Whether a file is in the package of `path`; without one, in its folder.
fn near(session: &Session, path: &Path) -> impl Fn(&Path) -> bool {
    let own = home(session, path);
    move |file| own.as_ref().is_none_or(|home| file.starts_with(home)) && home(session, file) == own
}

/// The package of a file; without one, its folder.
fn home(session: &Session, path: &Path) -> Option<PathBuf> {
    let package = session
        .packages
        .containing(path)
        .map(|package| package.folder);
    package.or_else(|| path.parent().map(Path::to_owned))
}

/// The robots that include a description, or are it: the nearest first, those of one distance by path.
fn roots_reading(session: &Session, file: &Path) -> Vec<PathBuf> {
    const MOST_LEVELS: usize = 6;
    let mut reading = vec![file.to_owned()];
    let mut begin = 0;
    for _ in 0..MOST_LEVELS {
        let last = reading.get(begin..).unwrap_or_default();
        let above: BTreeSet<PathBuf> = last
            .iter()
            .flat_map(|file| includers(session, file))
            .collect();
        begin = reading.len();
        let known: FastSet<PathBuf> = reading.iter().cloned().collect();
        reading.extend(above.into_iter().filter(|file| !known.contains(file)));
    }
    reading.retain(|file| is_robot(session, file) || collects(session, file));
    reading
}

/// Whether a text has the name of the folder of a file.
fn has_folder(text: &str, file: &Path) -> bool {
    let folder = file.parent().and_then(Path::file_name);
    folder
        .and_then(|folder| folder.to_str())
        .is_some_and(|folder| has_name(text, folder))
}
