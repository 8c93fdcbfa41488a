//! Findings in files beside robots.
use std::cell::LazyCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::super::includers::{includers, is_included};
use super::super::root_analysis::RootAnalysis;
use super::super::session::Session;
use super::super::texts::says;
use super::around::of_the_same;
use super::assistant::assistant_findings;
use super::files::{Beside, Robots, read_beside};
use super::fitting::{Paired, all_names_of, has_choices, paired};
use super::otherwise::names_otherwise;
use super::pairing::{by_launch, pairing_of};
use super::sort::{beside_around, beside_settings};
use super::spelled::{Prefixes, add_robots_with, add_spelled};
use base::{CancelFlag, FastMap, FastSet};
use packages::RosVersion;
use project::Srdf;
use rules::{
    BesideContent, Chosen, Finding, PairedRobot, RobotNames, all, check_beside, has_ignored_tags,
    is_whole, named,
};
use vfs::SourceFile;

/// What a comparison of files with their robots gave.
#[derive(Default)]
pub(in super::super) struct ComparisonResult {
    /// What is wrong.
    pub findings: Vec<Finding>,
    /// The files that were compared.
    pub files: Vec<PathBuf>,
}

/// What there is to say about files beside robots.
pub(in super::super) fn beside_findings(
    session: &Session,
    paths: &[PathBuf],
    cancel: &CancelFlag,
    robots: &Robots,
) -> ComparisonResult {
    let mut found = ComparisonResult::default();
    let mut read: FastMap<PathBuf, Option<Beside>> = FastMap::default();
    for path in paths.iter().filter(|_| !cancel.is_cancelled()) {
        let Some(own) = beside_once(session, path, &mut read, robots) else {
            continue;
        };
        found
            .findings
            .extend(assistant_findings(session, &own, robots, cancel));
        // a part of others is for the robots of these, whatever it is called
        let is_part = |srdf: &Srdf| srdf.groups.is_empty() && is_included(session, path);
        if own.srdf().is_some_and(|(_, srdf)| is_part(srdf)) {
            continue;
        }
        let pairing = pairing_of(session, path);
        // without a robot it is compared with the SRDF alone
        let paired = paired(session, &own, &pairing, robots).unwrap_or_default();
        let Some(around) = of_the_same(session, path, &pairing) else {
            continue;
        };
        let around = around.iter().filter(|other| *other != path);
        let around: Vec<Beside> = around
            .filter_map(|other| beside_once(session, other, &mut read, robots))
            .collect();
        let mut said = check_names(session, &own, &paired, &around, cancel);
        let has_ignored = |one: &Arc<RootAnalysis>| has_ignored_tags(&one.expansion);
        // what is missing in the robot has its cause there
        if !said.is_empty() && paired.robots.iter().any(has_ignored) {
            said = check_names(session, &own, &Paired::default(), &around, cancel);
        }
        leave_out_groups_above(session, path, &mut said);
        found.findings.extend(said);
        if !paired.robots.is_empty() {
            found.files.push(path.clone());
        }
    }
    found
}

/// Leave out that a part of an SRDF lacks a group which what includes the part has.
fn leave_out_groups_above(session: &Session, part: &Path, findings: &mut Vec<Finding>) {
    let is_about_group = |finding: &Finding| finding.rule == named::SRDF_UNKNOWN_GROUP;
    if !findings.iter().any(is_about_group) {
        return;
    }
    let sources = includers(session, part).into_iter();
    let sources = sources.filter_map(|file| session.vfs.document(&file).ok());
    let groups: FastSet<String> = sources.flat_map(|source| groups_of(&source)).collect();
    let Ok(own) = session.vfs.document(part) else {
        return;
    };
    findings.retain(|finding| {
        !is_about_group(finding) || !groups.contains(&own.document.slice(finding.span.range))
    });
}

fn beside_once(
    session: &Session,
    path: &Path,
    read: &mut FastMap<PathBuf, Option<Beside>>,
    robots: &Robots,
) -> Option<Beside> {
    if let Some(known) = read.get(path) {
        return known.clone();
    }
    let made = read_beside(session, path, robots);
    read.insert(path.to_owned(), made.clone());
    made
}

fn check_names(
    session: &Session,
    own: &Beside,
    paired: &Paired,
    around: &[Beside],
    cancel: &CancelFlag,
) -> Vec<Finding> {
    let started = started_controllers(session, own, paired);
    let robots: Vec<PairedRobot<'_>> = paired
        .robots
        .iter()
        .enumerate()
        .filter_map(|(number, one)| {
            let (expansion, robot, kinematics) =
                (&one.expansion, one.robot.as_ref()?, one.kinematics()?);
            Some(PairedRobot {
                expansion,
                robot,
                kinematics,
                started: started.get(number).map_or(&[], Vec::as_slice),
            })
        })
        .collect();
    let contents: Vec<BesideContent<'_>> = std::iter::once(own)
        .chain(around)
        .map(Beside::content)
        .collect();
    let srdfs = std::iter::once(own).chain(around).filter_map(Beside::srdf);
    let of_srdf = srdfs
        .clone()
        .next()
        .map(|(analyzed, _)| &analyzed.expansion);
    let own_srdf = own.srdf().map(|(analyzed, _)| &analyzed.expansion);
    let of_robot = robots.first().map(|first| first.expansion);
    let Some(expansion) = own_srdf.or(of_robot).or(of_srdf) else {
        return Vec::new();
    };
    let further = || {
        let mut names = further_names(session, &paired.robots, cancel);
        names.extend(&all_names_of(&paired.unused));
        srdfs.clone().for_each(|(srdf, _)| {
            add_spelled(session, &srdf.root.file, Prefixes::Kept, &mut names)
        });
        if let Some((_, srdf)) = own.srdf() {
            add_robots_with(session, srdf, own, &paired.robots, &mut names);
        }
        names
    };
    let has_variants = srdfs.clone().any(|(srdf, _)| has_choices(&srdf.expansion));
    let has_all_groups = srdfs.clone().all(|(srdf, _)| is_whole(&srdf.expansion));
    let has_controllers = matches!(own.content(), BesideContent::Settings(settings) if !settings.controllers.is_empty());
    let is_ros2 = session.packages.generation(&own.path) == Some(RosVersion::Ros2);
    let settings = session.settings(&own.path);
    let cx = rules::BesideCx::new(
        (own.file, own.content(), expansion),
        &robots,
        &contents,
        &further,
        session.rule_env(&settings.config),
    )
    .in_ros2(is_ros2)
    .with_own_joints(has_controllers && !is_ros2 && session.packages.registers_joints(&own.path))
    .with_variants(has_variants)
    .with_all_groups(has_all_groups);
    let rules: Vec<_> = all()
        .filter(|rule| settings.runs(rule, &own.path))
        .collect();
    check_beside(
        &cx,
        Chosen {
            rules: &rules,
            cancel,
            tally: None,
        },
    )
}

/// For each of several robots, the controllers of a file that launch files name which start this robot and none of the others.
fn started_controllers(
    session: &Session,
    own_file: &Beside,
    paired: &Paired,
) -> Vec<Vec<EcoString>> {
    let controllers = own_file.settings().map(|settings| &settings.controllers);
    let Some(controllers) = controllers.filter(|all| !all.is_empty() && paired.robots.len() > 1)
    else {
        return Vec::new();
    };
    let callers = |robot: &Arc<RootAnalysis>| {
        let calls = session.robot_calls(&robot.root.file);
        calls.into_iter().map(|one| one.call.caller).collect()
    };
    let all: Vec<FastSet<PathBuf>> = paired.robots.iter().map(callers).collect();
    let others = LazyCell::new(|| controllers_around(session, &own_file.path));
    let names = |callers: &FastSet<PathBuf>| {
        let is_own =
            |caller: &&PathBuf| all.iter().filter(|one| one.contains(*caller)).count() <= 1;
        let own: Vec<&PathBuf> = callers.iter().filter(is_own).collect();
        let elsewhere: Vec<FastSet<EcoString>> = own
            .iter()
            .map(|caller| configured_elsewhere(session, caller, &own_file.path, &others))
            .collect();
        let is_named = |name: &EcoString| {
            let mut all = own.iter().zip(&elsewhere);
            all.any(|(caller, others)| !others.contains(name) && says(&session.vfs, caller, name))
        };
        let names = controllers.iter().map(|one| one.name.name.clone());
        names.filter(is_named).collect()
    };
    all.iter().map(names).collect()
}

/// The names of the other files around one that configure controllers, and these controllers.
fn controllers_around(session: &Session, file: &Path) -> Vec<(String, Vec<EcoString>)> {
    let around = beside_around(session, file);
    let configured = |other: &PathBuf| {
        let settings = beside_settings(session, other)?;
        let all = settings.controllers.iter().map(|one| one.name.name.clone());
        Some((name_of(other)?, all.collect()))
    };
    let others = around.iter().filter(|other| *other != file);
    others.filter_map(configured).collect()
}

/// The controllers that have their parameters in files which a launch file names; none where it names this file.
fn configured_elsewhere(
    session: &Session,
    launch: &Path,
    file: &Path,
    others: &[(String, Vec<EcoString>)],
) -> FastSet<EcoString> {
    if name_of(file).is_some_and(|name| says(&session.vfs, launch, &name)) {
        return FastSet::default();
    }
    let named = others
        .iter()
        .filter(|(name, _)| says(&session.vfs, launch, name));
    named.flat_map(|(_, all)| all.iter().cloned()).collect()
}

/// The names that robots have with other values of their switches, and those that their texts spell out.
fn further_names(
    session: &Session,
    paired: &[Arc<RootAnalysis>],
    cancel: &CancelFlag,
) -> RobotNames {
    let mut names = RobotNames::default();
    for analyzed in paired {
        add_spelled(
            session,
            &analyzed.root.file,
            Prefixes::Of(analyzed),
            &mut names,
        );
        match analyzed.further.get() {
            Some(known) => names.extend(known),
            None => {
                let made = names_otherwise(session, analyzed, cancel);
                names.extend(&made);
                if !cancel.is_cancelled() {
                    let _ = analyzed.further.set(made);
                }
            }
        }
    }
    names
}

/// Whether the link of an SRDF that a finding is about is spelled out in a robot that a launch file loads beside it.
pub(in super::super) fn is_in_launched(session: &Session, file: &Path, finding: &Finding) -> bool {
    let name = finding.message.split('`').nth(1).unwrap_or_default();
    let mut names = RobotNames::default();
    for root in by_launch(session, file, false)
        .iter()
        .flat_map(|pairing| &pairing.roots)
    {
        add_spelled(session, &root.file, Prefixes::Kept, &mut names);
    }
    names.links.contains(name)
}

fn name_of(file: &Path) -> Option<String> {
    Some(file.file_name()?.to_str()?.to_owned())
}

/// The names of the groups that an SRDF writes out.
fn groups_of(source: &SourceFile) -> Vec<String> {
    let nodes = source
        .document
        .parts()
        .flat_map(|(_, item)| item.all_nodes());
    let groups = nodes.filter(|node| node.name() == "group");
    groups
        .filter_map(|node| Some(node.attr("name")?.raw().to_owned()))
        .collect()
}
