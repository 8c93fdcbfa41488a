//! What launch files say of robots that is not so: arguments that no robot knows, descriptions that are not there.
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::argument_places::argument_place;
use super::called_robots::CalledRobots;
use super::declared::KnownArguments;
use super::kept::is_launch_left_over;
use super::launch_values::{outside_choices, value_findings};
use super::launched_controllers::findings_of_spawners;
use super::launched_descriptions::LaunchedDescriptions;
use super::launched_files::{missing_file, uninstalled_file};
use super::launched_hardware::findings_of_hardware;
use super::launched_managers::findings_of_managers;
use super::launched_transforms::findings_of_transforms;
use super::launched_worlds::findings_of_worlds;
use super::options::CheckOptions;
use super::session::Session;
use super::uses::is_example_of_driver;
use super::walk::is_launch;
use base::{CancelFlag, FastSet};
use packages::nearest;
use rules::{Finding, Group, Severity, named, unknown_launch_argument};
use workspace::launch::LaunchCall;
use workspace::{RobotCall, has_name};

/// What is wrong in the calls of the launch files below the folders that are checked.
pub(super) fn launch_findings(session: &Session, options: &CheckOptions) -> Vec<Finding> {
    let mut known: BTreeMap<PathBuf, Arc<KnownArguments>> = BTreeMap::new();
    let mut found = Vec::new();
    // an editor asks about the files that it shows
    if !options.entries.is_empty() {
        return found;
    }
    let cancel = &options.cancel;
    let mut robots = CalledRobots::new(session, cancel);
    let folders = options.paths.iter().map(|path| session.vfs.absolute(path));
    for folder in folders.filter(|path| session.vfs.is_dir(path)) {
        findings_of_calls(
            session,
            &session.robot_calls(&folder),
            &options.cancel,
            &mut known,
            &mut found,
        );
        findings_of_loads(session, &session.callers.loads_below(&folder), &mut found);
        findings_of_files(session, &session.callers.opened_below(&folder), &mut found);
        found.extend(outside_choices(session, &folder, |_| true));
        found.extend(findings_of_transforms(
            session,
            cancel,
            &mut robots,
            &folder,
            |_| true,
        ));
        found.extend(findings_of_spawners(session, &folder, |_| true));
        found.extend(findings_of_hardware(
            session,
            cancel,
            &mut robots,
            &folder,
            |_| true,
        ));
        found.extend(findings_of_managers(
            session,
            cancel,
            &mut robots,
            &folder,
            |_| true,
        ));
        found.extend(findings_of_worlds(
            session,
            cancel,
            &mut robots,
            &folder,
            |_| true,
        ));
    }
    // folders may be inside of others
    let mut seen = FastSet::default();
    found.retain(|finding| seen.insert((finding.rule.code, finding.span, finding.message.clone())));
    found
}

/// What is wrong in the calls of robots that an editor shows, and in the launch files that it shows.
pub(super) fn shown_launch_findings(
    session: &Session,
    robots: &[PathBuf],
    shown: &[PathBuf],
    cancel: &CancelFlag,
) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut known: BTreeMap<PathBuf, Arc<KnownArguments>> = BTreeMap::new();
    let launch_files: Vec<&PathBuf> = shown.iter().filter(|path| is_launch(path)).collect();
    let mut calls: Vec<RobotCall> = Vec::new();
    for path in robots.iter().chain(launch_files.iter().copied()) {
        calls.extend(session.robot_calls(path));
    }
    calls.sort_by(|a, b| order(&a.call).cmp(&order(&b.call)));
    calls.dedup_by(|a, b| order(&a.call) == order(&b.call) && a.call.is_same(&b.call));
    findings_of_calls(session, &calls, cancel, &mut known, &mut found);
    let tops = launch_files
        .iter()
        .filter_map(|path| session.packages.sources_around(path));
    let mut called = CalledRobots::new(session, cancel);
    for top in tops.collect::<BTreeSet<PathBuf>>() {
        let mut loads = session.callers.loads_below(&top).to_vec();
        loads.retain(|load| launch_files.contains(&&load.call.caller));
        findings_of_loads(session, &loads, &mut found);
        let mut opened = session.callers.opened_below(&top).to_vec();
        opened.retain(|one| launch_files.contains(&&one.call.caller));
        findings_of_files(session, &opened, &mut found);
        found.extend(outside_choices(session, &top, |path| {
            launch_files.contains(&path)
        }));
        let is_shown = |path: &PathBuf| launch_files.contains(&path);
        found.extend(findings_of_transforms(
            session,
            cancel,
            &mut called,
            &top,
            is_shown,
        ));
        found.extend(findings_of_spawners(session, &top, is_shown));
        found.extend(findings_of_hardware(
            session,
            cancel,
            &mut called,
            &top,
            is_shown,
        ));
        found.extend(findings_of_managers(
            session,
            cancel,
            &mut called,
            &top,
            is_shown,
        ));
        found.extend(findings_of_worlds(
            session,
            cancel,
            &mut called,
            &top,
            is_shown,
        ));
    }
    found
}

/// What is wrong in calls, which are in the order of their places.
fn findings_of_calls(
    session: &Session,
    calls: &[RobotCall],
    cancel: &CancelFlag,
    known: &mut BTreeMap<PathBuf, Arc<KnownArguments>>,
    found: &mut Vec<Finding>,
) {
    for group in calls.chunk_by(|a, b| place(&a.call) == place(&b.call)) {
        if cancel.is_cancelled() {
            return;
        }
        let Some(call) = group.first().filter(|call| is_checked(session, call)) else {
            continue;
        };
        let before = found.len();
        findings_of(session, group, calls, known, found);
        found.extend(uninstalled_file(session, group));
        lower_left_over(session, &call.call.caller, found, before);
    }
    group_by_argument(found);
    for (robot, known) in &*known {
        let of =
            |call: &&RobotCall| call.target.as_ref() == Some(robot) && is_checked(session, call);
        let of: Vec<&RobotCall> = calls.iter().filter(of).collect();
        if !of.is_empty() {
            found.extend(value_findings(session, robot, known, &of));
        }
    }
}

/// What is wrong in descriptions that are loaded without xacro, which are in the order of the places.
fn findings_of_loads(session: &Session, loads: &[RobotCall], found: &mut Vec<Finding>) {
    for group in loads.chunk_by(|a, b| place(&a.call) == place(&b.call)) {
        let Some(load) = group.first().filter(|load| is_checked(session, load)) else {
            continue;
        };
        let before = found.len();
        found.extend(LaunchedDescriptions(session).missing_load(group));
        found.extend(LaunchedDescriptions(session).of_other_package(group));
        found.extend(LaunchedDescriptions(session).unexpanded_load(group));
        found.extend(uninstalled_file(session, group));
        lower_left_over(session, &load.call.caller, found, before);
    }
}

/// What is wrong in other files that are named, which are in the order of the places.
fn findings_of_files(session: &Session, opened: &[RobotCall], found: &mut Vec<Finding>) {
    for group in opened.chunk_by(|a, b| place(&a.call) == place(&b.call)) {
        let Some(one) = group.first().filter(|one| is_checked(session, one)) else {
            continue;
        };
        let before = found.len();
        found.extend(missing_file(session, group));
        found.extend(uninstalled_file(session, group));
        lower_left_over(session, &one.call.caller, found, before);
    }
}

/// What is found from a place on in a launch file that nobody runs is an info.
fn lower_left_over(session: &Session, caller: &Path, found: &mut [Finding], from: usize) {
    let is_idle = || is_launch_left_over(session, caller) || is_example_of_driver(session, caller);
    if found.len() > from && is_idle() {
        let own = found.iter_mut().skip(from);
        own.for_each(|one| one.severity = one.severity.min(Severity::Info));
    }
}

/// Whether the configuration does not exclude the launch file of a call.
fn is_checked(session: &Session, call: &RobotCall) -> bool {
    !session
        .settings(&call.call.caller)
        .excludes(&call.call.caller)
}

/// The values that launch files give to an argument of a robot, each with the names of the files.
pub fn launch_values(session: &Session, robot: &Path, name: &str) -> Vec<(String, String)> {
    let mut values: Vec<(String, Vec<String>)> = Vec::new();
    for call in session
        .robot_calls(robot)
        .iter()
        .filter(|call| call.target.as_deref() == Some(robot))
    {
        let caller = call.call.through.first().unwrap_or(&call.call.caller);
        let caller = caller
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        for argument in call
            .call
            .args
            .iter()
            .filter(|argument| argument.name == name)
        {
            let value = argument.value.shown();
            match values.iter_mut().find(|(known, _)| *known == value) {
                Some((_, files)) if files.contains(&caller) => {}
                Some((_, files)) => files.push(caller.clone()),
                None => values.push((value, vec![caller.clone()])),
            }
        }
    }
    values
        .into_iter()
        .map(|(value, files)| (value, in_short(&files)))
        .collect()
}

/// Of arguments that robots are given, those that none of them knows, each with a similar name. Where something of a
/// robot could not be read, it may know them all.
pub fn undeclared_arguments(
    session: &Session,
    robots: &[PathBuf],
    args: &[(String, String)],
) -> Vec<(String, Option<String>)> {
    if args.is_empty() {
        return Vec::new();
    }
    let known: Vec<KnownArguments> = robots
        .iter()
        .map(|robot| KnownArguments::of(session, robot))
        .collect();
    if !known.iter().all(|known| known.complete) {
        return Vec::new();
    }
    let names: FastSet<&str> = known
        .iter()
        .flat_map(|known| &known.names)
        .map(EcoString::as_str)
        .collect();
    let unknown = args
        .iter()
        .map(|(name, _)| name)
        .filter(|name| !names.contains(name.as_str()));
    let mut seen = FastSet::default();
    let unknown = unknown.filter(|name| seen.insert(*name));
    let with_near = |name: &String| {
        let near = nearest(name, names.iter().copied());
        (name.clone(), near.map(str::to_owned))
    };
    unknown.map(with_near).collect()
}

/// What is wrong in one call among others, with all the arguments that its launch file is included with.
fn findings_of(
    session: &Session,
    group: &[RobotCall],
    calls: &[RobotCall],
    known: &mut BTreeMap<PathBuf, Arc<KnownArguments>>,
    found: &mut Vec<Finding>,
) {
    let targets: Vec<&PathBuf> = group
        .iter()
        .filter_map(|call| call.target.as_ref())
        .collect();
    let is_there = |path: &&&PathBuf| session.vfs.is_file(path);
    found.extend(LaunchedDescriptions(session).missing_in(group));
    found.extend(LaunchedDescriptions(session).of_other_package(group));
    let robots: Vec<(&PathBuf, Arc<KnownArguments>)> = targets
        .iter()
        .filter(is_there)
        .map(|path| {
            let known = known
                .entry((*path).clone())
                .or_insert_with(|| Arc::new(KnownArguments::of(session, path)));
            (*path, known.clone())
        })
        .collect();
    let Some((robot, _)) = robots.first() else {
        return;
    };
    let mut seen: FastSet<&str> = FastSet::default();
    for argument in group.iter().flat_map(|call| &call.call.args) {
        let name = argument.name.as_str();
        if robots.iter().any(|(_, known)| known.names.contains(name)) || !seen.insert(name) {
            continue;
        }
        let is_certain =
            robots.len() == group.len() && robots.iter().all(|(_, known)| known.complete);
        let mut names = robots
            .iter()
            .flat_map(|(_, known)| &known.names)
            .map(EcoString::as_str);
        let Some(call) = group.first() else { continue };
        let span = argument_place(&session.vfs, &call.call, argument);
        let is_certain = is_certain && !is_used_otherwise(session, &call.call, name);
        let near = nearest(name, names.clone());
        // a value that is always the same, for a robot that knows nothing like it
        let is_idle = near.is_none()
            && argument.is_fixed(call.call.range)
            && !names.any(|known| is_like(known, name))
            || !tells_robots_apart(name) && robots.iter().all(|(_, known)| known.never_had(name))
            || is_for_the_robot(session, call, calls, name);
        found.push(unknown_launch_argument(
            span,
            name,
            robot,
            near,
            is_certain && !is_idle,
        ));
    }
}

/// Whether an argument is for several robots in one system: without it, all have the same names.
fn tells_robots_apart(name: &str) -> bool {
    ["prefix", "namespace"]
        .iter()
        .any(|word| name.contains(word))
}

/// Whether a launch file has another use for an argument that it passes in vain: it starts something only if it is set.
fn is_used_otherwise(session: &Session, call: &LaunchCall, name: &str) -> bool {
    let Ok(file) = session.vfs.text(&call.caller) else {
        return false;
    };
    [("Condition(", '\n'), (" if=\"", '"'), (" unless=\"", '"')]
        .into_iter()
        .any(|(before, after)| has_name_between(&file.text, name, before, after))
}

/// Whether a call makes an SRDF, and another one of its launch file makes a robot that knows the argument: both get one list.
fn is_for_the_robot(session: &Session, call: &RobotCall, calls: &[RobotCall], name: &str) -> bool {
    let is_srdf = |call: &RobotCall| {
        let target = call.target.as_deref().and_then(Path::file_name);
        target.is_some_and(|file| file.to_string_lossy().contains(".srdf"))
    };
    let gives = |other: &&RobotCall| {
        other.call.caller == call.call.caller
            && !is_srdf(other)
            && other.call.args.iter().any(|argument| argument.name == name)
    };
    let mut robots = calls
        .iter()
        .filter(gives)
        .filter_map(|other| other.target.as_deref());
    is_srdf(call) && robots.any(|robot| KnownArguments::of(session, robot).names.contains(name))
}

/// What is passed in vain to several robots is one mistake.
fn group_by_argument(found: &mut [Finding]) {
    const SEVERAL: usize = 3;
    let name = |finding: &Finding| {
        let is_it = finding.rule == named::UNKNOWN_LAUNCH_ARGUMENT && finding.group.is_some();
        let name = finding.message.split('`').nth(1).filter(|_| is_it)?;
        // infos make no group with warnings
        Some((name.to_owned(), finding.severity))
    };
    let mut count: BTreeMap<(String, Severity), usize> = BTreeMap::new();
    for name in found.iter().filter_map(name) {
        *count.entry(name).or_default() += 1;
    }
    for finding in found {
        if let Some(key) = name(finding).filter(|key| count.get(key) >= Some(&SEVERAL)) {
            finding.group = Some(Group::Value(format!("argument {}", key.0).into()));
        }
    }
}

/// Whether two names share most of their words.
fn is_like(a: &str, b: &str) -> bool {
    let (a, b) = (words(a), words(b));
    a.intersection(&b).count() * 2 > a.len().min(b.len())
}

fn words(name: &str) -> FastSet<String> {
    name.split('_').map(str::to_lowercase).collect()
}

/// Whether a text has a name soon behind `before`, in front of `after`.
fn has_name_between(text: &str, name: &str, before: &str, after: char) -> bool {
    const LONGEST: usize = 120;
    text.match_indices(before).any(|(at, _)| {
        let rest = text.get(at + before.len()..).unwrap_or_default();
        let end = rest.find(after).unwrap_or(0).min(LONGEST);
        rest.get(..end)
            .is_some_and(|condition| has_name(condition, name))
    })
}

/// The first names of a list, and how many there are besides.
fn in_short(names: &[String]) -> String {
    const MOST: usize = 3;
    let first = names
        .iter()
        .take(MOST)
        .cloned()
        .collect::<Vec<_>>()
        .join(", ");
    if names.len() > MOST {
        format!("{first} and {} more", names.len() - MOST)
    } else {
        first
    }
}

fn place(call: &LaunchCall) -> (&Path, u32, u32) {
    (&call.caller, call.range.start, call.range.end)
}

fn order(call: &LaunchCall) -> impl Ord + use<'_> {
    (place(call), &call.through)
}
