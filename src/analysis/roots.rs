//! Which files are expanded, and with which arguments.

use std::path::PathBuf;

/// An entry of `[[roots]]`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RootSpec {
    /// A path or a glob, absolute.
    pub file: String,
    /// Arguments of every preset.
    pub args: Vec<(String, String)>,
    /// Named sets of further arguments; the file is expanded once with each.
    pub presets: Vec<Preset>,
}

/// A named set of arguments.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Preset {
    /// Its name.
    pub name: String,
    /// Its arguments, over those of the root.
    pub args: Vec<(String, String)>,
}

/// Why a file is expanded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Reason {
    /// It lies below a folder that is checked.
    Walked,
    /// It was named on the command line.
    Named,
    /// It is configured as a root.
    Root,
}

/// One expansion to be made.
#[derive(Clone, Debug)]
pub(super) struct Job {
    /// The file, absolute.
    pub(super) file: PathBuf,
    /// Why.
    pub(super) reason: Reason,
    /// Arguments; later ones win.
    pub(super) args: Vec<(String, String)>,
    /// Name of the preset.
    pub(super) preset: Option<String>,
}

impl RootSpec {
    /// The jobs of one file that this entry means.
    pub(super) fn jobs(&self, file: PathBuf, args: &[(String, String)]) -> Vec<Job> {
        let job = |preset: Option<&Preset>| {
            let of_preset = preset.map_or(&[][..], |preset| &preset.args);
            Job {
                file: file.clone(),
                reason: Reason::Root,
                args: self.args.iter().chain(of_preset).chain(args).cloned().collect(),
                preset: preset.map(|preset| preset.name.clone()),
            }
        };
        if self.presets.is_empty() {
            vec![job(None)]
        } else {
            self.presets.iter().map(|p| job(Some(p))).collect()
        }
    }
}
