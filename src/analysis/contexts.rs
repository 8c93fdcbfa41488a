//! The contexts of a check: the configured roots, each with each of its presets, and how findings speak of them.

use std::path::{Path, PathBuf};

use indexmap::IndexSet;

use super::context::RootChoice;
use super::job::Outcome;
use super::roots::Job;
use super::world::World;
use base::{FastSet, FileId, Span, TextRange};
use rules::Related;
use vfs::SourceFile;
use workspace::config::Variant;

/// Contexts listed with a finding.
const MOST_PLACES: usize = 10;

/// One expansion among those of a check.
pub(super) struct Run {
    /// The file of the root.
    file: PathBuf,
    /// Its arguments; later ones win.
    args: Vec<(String, String)>,
    /// Whether it is a context, as others are of the same files.
    is_context: bool,
    /// Whether it gives a robot, and everything of it is known.
    is_whole_robot: bool,
    /// The descriptions that were read.
    reads: FastSet<FileId>,
    /// The start of the root.
    start: Option<Span>,
}

impl Run {
    pub(super) fn of(outcome: &Outcome) -> Self {
        let Job { file, args, .. } = outcome.job.clone();
        let reads = outcome.files.iter().map(|file| file.id).collect();
        let start = outcome.files.first().map(|source| start(source));
        let is_whole_robot = outcome.is_robot && outcome.complete;
        Self { file, args, is_context: outcome.is_context, is_whole_robot, reads, start }
    }
}

fn start(source: &SourceFile) -> Span {
    let root = source.document.root();
    let range = root.map(|root| TextRange::new(root.start_tag_range().start, root.name_range().end));
    Span { file: source.id, range: range.unwrap_or_default() }
}

/// The runs of a check, by number.
pub(super) struct Contexts {
    runs: Vec<Run>,
    /// The file names that several roots have: these are called by their paths.
    ambiguous: FastSet<String>,
}

impl Contexts {
    pub(super) fn of(runs: Vec<Run>) -> Self {
        let mut files: Vec<&PathBuf> = runs.iter().map(|run| &run.file).collect();
        files.sort_unstable();
        files.dedup();
        let mut seen = FastSet::default();
        let again = files.into_iter().map(|file| name(file)).filter(|name| !seen.insert(name.clone()));
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
        let same_root = |run: &Run| by.iter().filter_map(own).any(|own| own.file == run.file);
        let could = |run: &Run| if is_read { run.reads.contains(&file) } else { same_root(run) };
        let numbered = self.runs.iter().enumerate();
        numbered.filter(|(_, run)| run.is_context && could(run)).map(|(number, _)| number).collect()
    }

    /// How many whole robots read a file besides those of the runs `but`.
    pub(super) fn other_robots(&self, file: FileId, but: &[usize]) -> usize {
        let own: FastSet<&PathBuf> = but.iter().filter_map(|&n| Some(&self.runs.get(n)?.file)).collect();
        let reads = |run: &&Run| run.is_whole_robot && run.reads.contains(&file) && !own.contains(&run.file);
        self.runs.iter().filter(reads).map(|run| &run.file).collect::<FastSet<_>>().len()
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
            Some(Related { span: self.runs.get(number)?.start?, message, is_call: false })
        };
        runs.iter().filter_map(place).take(MOST_PLACES).collect()
    }

    fn label(&self, number: usize) -> Option<String> {
        let run = self.runs.get(number)?;
        let short = name(&run.file);
        let long = || run.file.display().to_string();
        let name = if self.ambiguous.contains(&short) { long() } else { short };
        Some(label(name, &run.args))
    }
}

fn name(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// A root with its arguments, as one writes them on a command line; later arguments win.
pub(super) fn label(mut text: String, args: &[(String, String)]) -> String {
    for (number, (name, value)) in args.iter().enumerate() {
        if !args.iter().skip(number + 1).any(|(later, _)| later == name) {
            text.push_str(&format!(" {name}:={value}"));
        }
    }
    text
}

impl RootChoice {
    /// For people: the name of the file and the arguments.
    pub fn label(&self) -> String {
        label(name(&self.file), &self.args)
    }
}

impl World {
    /// Every configured root with each of its presets, by the configurations that hold for files and for the folders.
    pub(super) fn configured_contexts(&self, paths: &[&PathBuf]) -> Vec<RootChoice> {
        let session = self.session();
        let of_folders = self.folders().iter().map(|folder| session.folder_settings(folder));
        let mut found: IndexSet<RootChoice> = IndexSet::new();
        for settings in of_folders.chain(paths.iter().map(|path| session.settings(path))) {
            for root in &settings.config.roots {
                for file in root.files(&session.vfs) {
                    let file = session.vfs.absolute(&file);
                    let choice = |Variant { preset, args }| RootChoice { file: file.clone(), args, preset };
                    found.extend(session.variants(root, &file).into_iter().map(choice));
                }
            }
        }
        found.into_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn the_last_value_of_an_argument_counts() {
        let args =
            [("a", "1"), ("b", "2"), ("a", "3")].map(|(name, value)| (name.to_owned(), value.to_owned()));
        assert_eq!(label("r.xacro".to_owned(), &args), "r.xacro b:=2 a:=3");
    }
}
