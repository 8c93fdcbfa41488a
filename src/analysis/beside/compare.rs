//! Findings in files beside robots.
use std::cell::LazyCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::super::options::CheckOptions;
use super::super::root_analysis::RootAnalysis;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::files::{Beside, Robots, Sort, sort};
use super::fitting::{Paired, all_names_of, has_choices};
use super::paired::Pairing;
use super::spelled::Prefixes;
use base::limits::FILES_BESIDE;
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

impl Session {
    /// The files beside robots that a check is about.
    pub(in super::super) fn beside_files(&self, options: &CheckOptions) -> Vec<PathBuf> {
        let paths = options
            .paths
            .iter()
            .chain(&options.entries)
            .map(|path| self.vfs.absolute(path));
        let below = |path: PathBuf| {
            if self.vfs.is_dir(&path) {
                let around = self.beside_around(&path.join("_"));
                around
                    .iter()
                    .filter(|file| file.starts_with(&path))
                    .cloned()
                    .collect()
            } else if sort(&path).is_some() {
                vec![path]
            } else {
                Vec::new()
            }
        };
        let mut found: Vec<PathBuf> = paths.flat_map(below).collect();
        found.sort();
        found.dedup();
        found
    }

    /// The files beside a robot.
    pub(in super::super) fn beside_of(&self, root: &Path) -> Vec<PathBuf> {
        self.paired_around(root)
            .iter()
            .filter(|file| self.pairing(file).roots.iter().any(|own| own.file == root))
            .cloned()
            .collect()
    }

    /// What has to be expanded to judge files beside robots: their robots, and the SRDFs beside these.
    pub(in super::super) fn beside_roots(&self, paths: &[PathBuf]) -> Vec<RootConfig> {
        let mut found: FastSet<RootConfig> = FastSet::default();
        for path in paths {
            let pairing = self.pairing(path);
            let Some(around) = self.of_the_same(path, &pairing) else {
                continue;
            };
            let srdfs = around.iter().filter(|file| sort(file) == Some(Sort::Srdf));
            found.extend(srdfs.map(|file| RootConfig::plain(file)));
            found.extend(pairing.roots.iter().cloned());
        }
        let mut found: Vec<RootConfig> = found.into_iter().collect();
        found.sort();
        found
    }

    /// What there is to say about files beside robots.
    pub(in super::super) fn beside_findings(
        &self,
        paths: &[PathBuf],
        cancel: &CancelFlag,
        robots: &Robots,
    ) -> ComparisonResult {
        let mut found = ComparisonResult::default();
        let mut read: FastMap<PathBuf, Option<Beside>> = FastMap::default();
        for path in paths.iter().filter(|_| !cancel.is_cancelled()) {
            let Some(own) = self.beside_once(path, &mut read, robots) else {
                continue;
            };
            found
                .findings
                .extend(self.assistant_findings(&own, robots, cancel));
            // a part of others is for the robots of these, whatever it is called
            let is_part = |srdf: &Srdf| srdf.groups.is_empty() && self.is_included(path);
            if own.srdf().is_some_and(|(_, srdf)| is_part(srdf)) {
                continue;
            }
            let pairing = self.pairing(path);
            // without a robot it is compared with the SRDF alone
            let paired = self.paired(&own, &pairing, robots).unwrap_or_default();
            let Some(around) = self.of_the_same(path, &pairing) else {
                continue;
            };
            let around = around.iter().filter(|other| *other != path);
            let around: Vec<Beside> = around
                .filter_map(|other| self.beside_once(other, &mut read, robots))
                .collect();
            let mut said = self.check_names(&own, &paired, &around, cancel);
            let has_ignored = |one: &Arc<RootAnalysis>| has_ignored_tags(&one.expansion);
            // what is missing in the robot has its cause there
            if !said.is_empty() && paired.robots.iter().any(has_ignored) {
                said = self.check_names(&own, &Paired::default(), &around, cancel);
            }
            self.leave_out_groups_above(path, &mut said);
            found.findings.extend(said);
            if !paired.robots.is_empty() {
                found.files.push(path.clone());
            }
        }
        found
    }

    /// Leave out that a part of an SRDF lacks a group which what includes the part has.
    fn leave_out_groups_above(&self, part: &Path, findings: &mut Vec<Finding>) {
        let is_about_group = |finding: &Finding| finding.rule == named::SRDF_UNKNOWN_GROUP;
        if !findings.iter().any(is_about_group) {
            return;
        }
        let sources = self.includers(part).into_iter();
        let sources = sources.filter_map(|file| self.vfs.document(&file).ok());
        let groups: FastSet<String> = sources.flat_map(|source| groups_of(&source)).collect();
        let Ok(own) = self.vfs.document(part) else {
            return;
        };
        findings.retain(|finding| {
            !is_about_group(finding) || !groups.contains(&own.document.slice(finding.span.range))
        });
    }

    fn beside_once(
        &self,
        path: &Path,
        read: &mut FastMap<PathBuf, Option<Beside>>,
        robots: &Robots,
    ) -> Option<Beside> {
        if let Some(known) = read.get(path) {
            return known.clone();
        }
        let made = self.beside(path, robots);
        read.insert(path.to_owned(), made.clone());
        made
    }

    /// The files beside the same robots, this one too. None for very many, such as a generated SRDF for each combination of
    /// tools: to compare each with all others would take the square of them.
    fn of_the_same(&self, path: &Path, pairing: &Pairing) -> Option<Vec<PathBuf>> {
        let is_same = |other: &&PathBuf| {
            *other == path
                || pairing.srdf.as_ref() == Some(other)
                || self.is_for_one_of(other, &pairing.roots)
        };
        let around = self.paired_around(path);
        let same = around.iter().filter(is_same);
        let found: Vec<PathBuf> = same.take(FILES_BESIDE + 1).cloned().collect();
        (found.len() <= FILES_BESIDE).then_some(found)
    }

    /// Whether a file beside robots is for one of these.
    fn is_for_one_of(&self, file: &Path, roots: &[RootConfig]) -> bool {
        !roots.is_empty()
            && self
                .pairing(file)
                .roots
                .iter()
                .any(|root| roots.contains(root))
    }

    fn check_names(
        &self,
        own: &Beside,
        paired: &Paired,
        around: &[Beside],
        cancel: &CancelFlag,
    ) -> Vec<Finding> {
        let started = self.started_controllers(own, paired);
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
            let mut names = self.further_names(&paired.robots, cancel);
            names.extend(&all_names_of(&paired.unused));
            srdfs.clone().for_each(|(srdf, _)| {
                self.add_spelled(&srdf.root.file, Prefixes::Kept, &mut names)
            });
            if let Some((_, srdf)) = own.srdf() {
                self.add_robots_with(srdf, own, &paired.robots, &mut names);
            }
            names
        };
        let has_variants = srdfs.clone().any(|(srdf, _)| has_choices(&srdf.expansion));
        let has_all_groups = srdfs.clone().all(|(srdf, _)| is_whole(&srdf.expansion));
        let has_controllers = matches!(own.content(), BesideContent::Settings(settings) if !settings.controllers.is_empty());
        let is_ros2 = self.packages.generation(&own.path) == Some(RosVersion::Ros2);
        let settings = self.settings(&own.path);
        let cx = rules::BesideCx::new(
            (own.file, own.content(), expansion),
            &robots,
            &contents,
            &further,
            self.rule_env(&settings.config),
        )
        .in_ros2(is_ros2)
        .with_own_joints(has_controllers && !is_ros2 && self.packages.registers_joints(&own.path))
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
    fn started_controllers(&self, own_file: &Beside, paired: &Paired) -> Vec<Vec<EcoString>> {
        let controllers = own_file.settings().map(|settings| &settings.controllers);
        let Some(controllers) =
            controllers.filter(|all| !all.is_empty() && paired.robots.len() > 1)
        else {
            return Vec::new();
        };
        let callers = |robot: &Arc<RootAnalysis>| {
            let calls = self.robot_calls(&robot.root.file);
            calls.into_iter().map(|one| one.call.caller).collect()
        };
        let all: Vec<FastSet<PathBuf>> = paired.robots.iter().map(callers).collect();
        let others = LazyCell::new(|| self.controllers_around(&own_file.path));
        let names = |callers: &FastSet<PathBuf>| {
            let is_own =
                |caller: &&PathBuf| all.iter().filter(|one| one.contains(*caller)).count() <= 1;
            let own: Vec<&PathBuf> = callers.iter().filter(is_own).collect();
            let elsewhere: Vec<FastSet<EcoString>> = own
                .iter()
                .map(|caller| self.configured_elsewhere(caller, &own_file.path, &others))
                .collect();
            let is_named = |name: &EcoString| {
                let mut all = own.iter().zip(&elsewhere);
                all.any(|(caller, others)| !others.contains(name) && self.says(caller, name))
            };
            let names = controllers.iter().map(|one| one.name.name.clone());
            names.filter(is_named).collect()
        };
        all.iter().map(names).collect()
    }

    /// The names of the other files around one that configure controllers, and these controllers.
    fn controllers_around(&self, file: &Path) -> Vec<(String, Vec<EcoString>)> {
        let around = self.beside_around(file);
        let configured = |other: &PathBuf| {
            let settings = self.beside_settings(other)?;
            let all = settings.controllers.iter().map(|one| one.name.name.clone());
            Some((name_of(other)?, all.collect()))
        };
        let others = around.iter().filter(|other| *other != file);
        others.filter_map(configured).collect()
    }

    /// The controllers that have their parameters in files which a launch file names; none where it names this file.
    fn configured_elsewhere(
        &self,
        launch: &Path,
        file: &Path,
        others: &[(String, Vec<EcoString>)],
    ) -> FastSet<EcoString> {
        if name_of(file).is_some_and(|name| self.says(launch, &name)) {
            return FastSet::default();
        }
        let named = others.iter().filter(|(name, _)| self.says(launch, name));
        named.flat_map(|(_, all)| all.iter().cloned()).collect()
    }

    /// The names that robots have with other values of their switches, and those that their texts spell out.
    fn further_names(&self, paired: &[Arc<RootAnalysis>], cancel: &CancelFlag) -> RobotNames {
        let mut names = RobotNames::default();
        for analyzed in paired {
            self.add_spelled(&analyzed.root.file, Prefixes::Of(analyzed), &mut names);
            match analyzed.further.get() {
                Some(known) => names.extend(known),
                None => {
                    let made = self.names_otherwise(analyzed, cancel);
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
    pub(in super::super) fn is_in_launched(&self, file: &Path, finding: &Finding) -> bool {
        let name = finding.message.split('`').nth(1).unwrap_or_default();
        let mut names = RobotNames::default();
        for root in self
            .by_launch(file, false)
            .iter()
            .flat_map(|pairing| &pairing.roots)
        {
            self.add_spelled(&root.file, Prefixes::Kept, &mut names);
        }
        names.links.contains(name)
    }
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
