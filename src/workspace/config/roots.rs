//! Entry files and the arguments they are run with.

use std::path::{Path, PathBuf};

use super::Place;
use super::pattern::{Pattern, is_pattern};
use vfs::Vfs;

/// Names and values of xacro arguments, in order.
pub type Args = Vec<(String, String)>;

/// One `[[roots]]` entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// Path or glob, as written.
    pub file: String,
    /// The folder it starts from.
    pub folder: PathBuf,
    /// Arguments of every run.
    pub args: Args,
    /// Named sets of arguments, in order.
    pub presets: Vec<(String, Args)>,
    /// Where the entry stands.
    pub place: Place,
    /// Where arguments are given, with their names: those of every run, and those of the presets.
    pub given: Vec<(String, Place)>,
}

/// One run of a root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The name of the preset; `None` for the run with the plain arguments.
    pub preset: Option<String>,
    /// All arguments.
    pub args: Args,
}

/// The files that exist of a path or glob that starts from a folder, sorted.
pub fn files_named(name: &str, folder: &Path, vfs: &Vfs) -> Vec<PathBuf> {
    if is_pattern(name) {
        return Pattern::new(&format!("./{name}"), folder).files(vfs);
    }
    let file = folder.join(name);
    if vfs.is_file(&file) { vec![file] } else { Vec::new() }
}

impl Root {
    /// The entry files that exist, sorted.
    pub fn files(&self, vfs: &Vfs) -> Vec<PathBuf> {
        files_named(&self.file, &self.folder, vfs)
    }

    /// The runs: one with the plain arguments, unless there are none of these but presets; then one per
    /// preset, whose arguments go over the plain ones.
    pub fn variants(&self) -> Vec<Variant> {
        let plain = self.presets.is_empty() || !self.args.is_empty();
        let default = plain.then(|| Variant { preset: None, args: self.args.clone() });
        let presets = self.presets.iter().map(|(name, preset)| {
            let mut args = self.args.clone();
            args.retain(|(arg, _)| preset.iter().all(|(other, _)| other != arg));
            args.extend(preset.iter().cloned());
            Variant { preset: Some(name.clone()), args }
        });
        default.into_iter().chain(presets).collect()
    }
}
