//! The contexts of a check: the configured roots, each with each of its presets, and how findings speak of them.
use std::path::PathBuf;

use ecow::EcoString;

use super::check_task::{CheckTask, LaunchCallSites};
use super::root_config::{label, short_name};
use super::root_result::RootResult;
use base::{FastSet, FileId, Span, TextRange};
use rules::Related;
use vfs::SourceFile;

/// Contexts listed with a finding.
const MOST_PLACES: usize = 10;

/// Arguments of a call that are named.
const MOST_ARGUMENTS: usize = 5;

/// One expansion among those of a check.
pub(super) struct ContextRun {
    /// The file of the root.
    file: PathBuf,
    /// Its arguments; later ones win.
    args: Vec<(String, String)>,
    /// The values of all arguments.
    values: Vec<(EcoString, EcoString)>,
    /// The calls in launch files that it is made for.
    called: Option<LaunchCallSites>,
    /// Whether it is a context, as others are of the same files.
    is_context: bool,
    /// Whether it has arguments of a caller, since it fails with the defaults.
    is_as_called: bool,
    /// Whether it gives a robot, and everything of it is known.
    is_whole_robot: bool,
    /// The descriptions that were read.
    reads: FastSet<FileId>,
    /// The start of the root.
    start: Option<Span>,
}

impl ContextRun {
    pub(super) fn of(result: &RootResult) -> Self {
        let CheckTask {
            file, args, called, ..
        } = result.task.clone();
        let reads = result.files.iter().map(|file| file.id).collect();
        let start = result.files.first().map(|source| start(source));
        let is_whole_robot = result.is_robot && result.complete;
        let (values, is_context) = (result.arguments.clone(), result.is_context);
        let is_as_called = result.is_as_called;
        Self {
            file,
            args,
            values,
            called,
            is_as_called,
            is_context,
            is_whole_robot,
            reads,
            start,
        }
    }
}

fn start(source: &SourceFile) -> Span {
    let root = source.document.root();
    let range =
        root.map(|root| TextRange::new(root.start_tag_range().start, root.name_range().end));
    Span {
        file: source.id,
        range: range.unwrap_or_default(),
    }
}

/// The runs of a check, by number.
pub(super) struct Contexts {
    runs: Vec<ContextRun>,
    /// The file names that several roots have: these are called by their paths.
    ambiguous: FastSet<String>,
}

impl Contexts {
    pub(super) fn of(runs: Vec<ContextRun>) -> Self {
        let mut files: Vec<&PathBuf> = runs.iter().map(|run| &run.file).collect();
        files.sort_unstable();
        files.dedup();
        let mut seen = FastSet::default();
        let again = files
            .into_iter()
            .map(|file| short_name(file))
            .filter(|name| !seen.insert(name.clone()));
        let ambiguous = again.collect();
        Self { runs, ambiguous }
    }

    /// The numbers of the contexts in which a finding in a file could have been made; none when those that made it,
    /// `by`, are not all contexts. Of a file that is no description, these are the presets of the same roots.
    pub(super) fn that_read(&self, file: FileId, by: &[usize]) -> Vec<usize> {
        let own = |number: &usize| self.runs.get(*number);
        if !by.iter().filter_map(own).all(|run| run.is_context) {
            return Vec::new();
        }
        let is_read = self.runs.iter().any(|run| run.reads.contains(&file));
        let could = |(_, run): &(usize, &ContextRun)| {
            if is_read {
                run.reads.contains(&file)
            } else {
                by.iter().filter_map(own).any(|own| own.file == run.file)
            }
        };
        let numbered = self.runs.iter().enumerate();
        numbered
            .filter(|(_, run)| run.is_context)
            .filter(could)
            .map(|(number, _)| number)
            .collect()
    }

    /// How many whole robots read a file besides those of the runs `but`.
    pub(super) fn other_robots(&self, file: FileId, but: &[usize]) -> usize {
        let own: FastSet<&PathBuf> = but
            .iter()
            .filter_map(|&n| Some(&self.runs.get(n)?.file))
            .collect();
        let reads = |run: &&ContextRun| {
            run.is_whole_robot && run.reads.contains(&file) && !own.contains(&run.file)
        };
        self.runs
            .iter()
            .filter(reads)
            .map(|run| &run.file)
            .collect::<FastSet<_>>()
            .len()
    }

    /// What the message of a finding ends with that these runs have: ` [root robot.urdf.xacro side:=right]`
    pub(super) fn suffix(&self, runs: &[usize]) -> String {
        let mut labels = runs.iter().filter_map(|&number| self.label(number));
        let first = labels.next().unwrap_or_default();
        match labels.count() {
            0 => format!(" [root {first}]"),
            more => format!(" [root {first} and {more} more]"),
        }
    }

    /// The places of these runs, when there are several: one is told by the message.
    pub(super) fn places(&self, runs: &[usize]) -> Vec<Related> {
        if runs.len() < 2 {
            return Vec::new();
        }
        let place = |&number: &usize| {
            let message = format!("with root {}", self.label(number)?);
            Some(Related {
                span: self.runs.get(number)?.start?,
                message,
                is_call: false,
            })
        };
        runs.iter().filter_map(place).take(MOST_PLACES).collect()
    }

    /// The numbers of the runs of the same robots that launch files call; none of robots that no launch file calls.
    pub(super) fn of_called(&self, file: FileId, by: &[usize]) -> Vec<usize> {
        let called = self
            .runs
            .iter()
            .filter(|run| run.called.is_some())
            .map(|run| &run.file);
        let called: FastSet<&PathBuf> = called.collect();
        let files: FastSet<&PathBuf> = by
            .iter()
            .filter_map(|&n| Some(&self.runs.get(n)?.file))
            .collect();
        let is_one = |(_, run): &(usize, &ContextRun)| {
            files.contains(&run.file) && called.contains(&run.file) && run.reads.contains(&file)
        };
        self.runs
            .iter()
            .enumerate()
            .filter(is_one)
            .map(|(number, _)| number)
            .collect()
    }

    /// How many calls in launch files these runs are made for, and how many there are of their robots; none when a run is made for
    /// another reason.
    fn call_counts(&self, runs: &[usize]) -> Option<(usize, usize)> {
        let called = |&number: &usize| {
            self.runs
                .get(number)
                .and_then(|run| Some((run, run.called.as_ref()?)))
        };
        let runs: Vec<(&ContextRun, &LaunchCallSites)> =
            runs.iter().map(called).collect::<Option<_>>()?;
        let own = runs.iter().map(|(_, called)| called.calls.len()).sum();
        let mut seen = FastSet::default();
        let robots = runs.iter().filter(|(run, _)| seen.insert(&run.file));
        Some((own, robots.map(|(_, called)| called.of).sum()))
    }

    /// Whether these runs are made for some calls in launch files, and there are others of their robots.
    pub(super) fn is_in_some_calls(&self, runs: &[usize]) -> bool {
        self.call_counts(runs).is_some_and(|(own, all)| own < all)
    }

    /// Whether these runs are of robots as they are without arguments, and nothing loads them so.
    pub(super) fn is_in_no_call(&self, runs: &[usize]) -> bool {
        let is_called_otherwise = |run: &ContextRun| {
            let is_of_it = |other: &&ContextRun| other.file == run.file;
            let mut calls = self
                .runs
                .iter()
                .filter(is_of_it)
                .filter_map(|other| other.called.as_ref());
            let is_plain = run.called.is_none() && !run.is_as_called && run.args.is_empty();
            is_plain && calls.next().is_some_and(|called| called.are_all)
        };
        runs.iter()
            .all(|&number| self.runs.get(number).is_some_and(is_called_otherwise))
    }

    /// What the message of a finding ends with that these runs have, when all of them are made for calls in launch files:
    /// ` [in 2 of 5 calls]`
    pub(super) fn calls(&self, runs: &[usize]) -> Option<String> {
        let (own, all) = self.call_counts(runs)?;
        let files: FastSet<&PathBuf> = runs
            .iter()
            .filter_map(|&number| Some(&self.runs.get(number)?.file))
            .collect();
        let is_as_called = |other: &ContextRun| other.is_as_called && files.contains(&other.file);
        if own == all && self.runs.iter().any(is_as_called) {
            return Some(String::new());
        }
        Some(match (own, all) {
            (_, 1) => " [in the only call]".to_owned(),
            (own, all) if own == all => format!(" [in all {all} calls]"),
            (own, all) => format!(" [in {own} of {all} calls]"),
        })
    }

    /// The calls in launch files that these runs are made for.
    pub(super) fn call_places(&self, runs: &[usize]) -> Vec<Related> {
        let runs = runs.iter().filter_map(|&number| self.runs.get(number));
        let places = runs.flat_map(|run| {
            let message = match self.differing(run) {
                args if args.is_empty() => "in this call".to_owned(),
                args => format!("in this call: {args}"),
            };
            let calls = run.called.iter().flat_map(|called| &called.calls);
            calls.map(move |&span| Related {
                span,
                message: message.clone(),
                is_call: false,
            })
        });
        places.take(MOST_PLACES).collect()
    }

    /// The first arguments of a call that are not those that the robot has without it.
    fn differing(&self, run: &ContextRun) -> String {
        let plain = self
            .runs
            .iter()
            .find(|other| other.called.is_none() && !other.is_as_called && other.file == run.file);
        let has = |(name, value): &&(String, String)| {
            !plain.is_some_and(|plain| {
                plain
                    .values
                    .iter()
                    .any(|(own, old)| own == name && old == value)
            })
        };
        let mut args: Vec<String> = run
            .args
            .iter()
            .filter(has)
            .map(|(name, value)| format!("{name}:={value}"))
            .collect();
        let more = args.len().saturating_sub(MOST_ARGUMENTS);
        args.truncate(MOST_ARGUMENTS);
        let more = if more > 0 {
            format!(" and {more} more")
        } else {
            String::new()
        };
        args.join(" ") + &more
    }

    fn label(&self, number: usize) -> Option<String> {
        let run = self.runs.get(number)?;
        let short = short_name(&run.file);
        let name = if self.ambiguous.contains(&short) {
            vfs::slashed(&run.file)
        } else {
            short
        };
        Some(label(name, &run.args))
    }
}
