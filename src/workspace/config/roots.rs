//! Entry files and the arguments they are run with.

use std::path::{Path, PathBuf};

use super::ConfigLocation;
use super::expect::Expectation;
use super::pattern::{Pattern, is_pattern};
use base::limits::MATRIX_RUNS;
use vfs::Vfs;

/// Names and values of xacro arguments, in order.
pub type XacroArgs = Vec<(String, String)>;

/// Names of xacro arguments, each with the values it takes, in order.
pub type Axes = Vec<(String, Vec<String>)>;

/// One `[[roots]]` entry.
#[derive(Clone, Debug, PartialEq)]
pub struct Root {
    /// Path or glob, as written.
    pub file: String,
    /// The folder it starts from.
    pub folder: PathBuf,
    /// Arguments of every run; there is a run for each combination of their values.
    pub args: Axes,
    /// Combinations that are left out.
    pub exclude: Vec<Axes>,
    /// Whether arguments also take the values that launch files declare as choices.
    pub launch_choices: bool,
    /// Named sets of arguments, in order.
    pub presets: Vec<(String, XacroArgs)>,
    /// What is expected of the robots.
    pub expect: Vec<Expectation>,
    /// Where the entry stands.
    pub place: ConfigLocation,
    /// Where arguments are given, with their names: those of every run, and those of the presets.
    pub given: Vec<(String, ConfigLocation)>,
}

/// One run of a root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The name of the preset; `None` for the run with the plain arguments.
    pub preset: Option<String>,
    /// All arguments.
    pub args: XacroArgs,
}

impl Variant {
    /// Whether each argument of `axes` is given one of its values.
    fn is_among(&self, axes: &Axes) -> bool {
        let has = |(name, values): &(String, Vec<String>)| {
            self.args
                .iter()
                .any(|(own, value)| own == name && values.contains(value))
        };
        axes.iter().all(has)
    }
}

/// The files that exist of a path or glob that starts from a folder, sorted.
pub fn files_named(name: &str, folder: &Path, vfs: &Vfs) -> Vec<PathBuf> {
    if is_pattern(name) {
        return Pattern::new(&format!("./{name}"), folder).files(vfs);
    }
    let file = folder.join(name);
    if vfs.is_file(&file) {
        vec![file]
    } else {
        Vec::new()
    }
}

impl Root {
    /// An entry without arguments.
    pub(super) fn new(folder: PathBuf, place: ConfigLocation) -> Self {
        Self {
            file: String::new(),
            folder,
            args: Axes::new(),
            exclude: Vec::new(),
            launch_choices: false,
            presets: Vec::new(),
            expect: Vec::new(),
            place,
            given: Vec::new(),
        }
    }

    /// The entry files that exist, sorted.
    pub fn files(&self, vfs: &Vfs) -> Vec<PathBuf> {
        files_named(&self.file, &self.folder, vfs)
    }

    /// The runs, at most [`MATRIX_RUNS`]: one for each combination of the arguments, unless there are none of these but
    /// presets; then the same per preset, whose arguments go over the others. `choices` are further arguments
    /// that the entry does not name.
    pub fn variants(&self, choices: &Axes) -> Vec<Variant> {
        let variants = self
            .sets(choices)
            .into_iter()
            .flat_map(|(preset, args, axes)| {
                let with = move |mut combined: XacroArgs| {
                    combined.extend(args.iter().cloned());
                    Variant {
                        preset: preset.clone(),
                        args: combined,
                    }
                };
                products(axes).map(with).collect::<Vec<_>>()
            });
        variants
            .take(MATRIX_RUNS)
            .filter(|variant| !self.exclude.iter().any(|axes| variant.is_among(axes)))
            .collect()
    }

    /// How many runs there would be without a limit, those left out counted.
    pub fn combinations(&self, choices: &Axes) -> u64 {
        let counts = self.sets(choices).into_iter().map(|(_, _, axes)| {
            axes.iter().fold(1, |count: u64, (_, values)| {
                count.saturating_mul(values.len() as u64)
            })
        });
        counts.fold(0, u64::saturating_add)
    }

    /// Sets of runs: the preset, its arguments, and all others with their values.
    fn sets(&self, choices: &Axes) -> Vec<(Option<String>, XacroArgs, Axes)> {
        let mut axes = self.args.clone();
        let is_new = |(name, values): &&(String, Vec<String>)| {
            !values.is_empty() && self.args.iter().all(|(own, _)| own != name)
        };
        axes.extend(choices.iter().filter(is_new).cloned());
        let plain = self.presets.is_empty() || !axes.is_empty();
        let plain = plain.then(|| (None, XacroArgs::new(), axes.clone()));
        let presets = self.presets.iter().map(|(name, args)| {
            let mut others = axes.clone();
            others.retain(|(arg, _)| args.iter().all(|(own, _)| own != arg));
            (Some(name.clone()), args.clone(), others)
        });
        plain.into_iter().chain(presets).collect()
    }
}

/// The first combinations of values; the last argument changes fastest.
fn products(axes: Axes) -> impl Iterator<Item = XacroArgs> {
    let total = axes.iter().fold(1, |count: usize, (_, values)| {
        count.saturating_mul(values.len())
    });
    (0..total.min(MATRIX_RUNS)).map(move |number| {
        let mut rest = number;
        let mut args: XacroArgs = Vec::with_capacity(axes.len());
        for (name, values) in axes.iter().rev() {
            let value = values
                .get(rest % values.len().max(1))
                .cloned()
                .unwrap_or_default();
            args.push((name.clone(), value));
            rest /= values.len().max(1);
        }
        args.reverse();
        args
    })
}
