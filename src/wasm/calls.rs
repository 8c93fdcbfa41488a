//! What may be asked, as it comes in JSON.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use analysis::{CheckOptions, Overrides, Setup};
use preview::Location;

/// A question.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "call", rename_all = "camelCase")]
pub enum Call {
    /// The findings, as `check --format json` prints them.
    Check(CheckCall),
    /// The files as `check --fix` leaves them, as far as they differ.
    Fix(CheckCall),
    /// The expanded text of a robot, its source map and its problems.
    Expand(RobotParams),
    /// The robots among the files.
    Robots,
    /// The paths of all files.
    Files,
    /// The model of a robot for the viewer; null while it is as it was.
    Model(RobotParams),
    /// What a place of the source made, or the place of a link or joint.
    Select {
        /// A link.
        #[serde(default)]
        link: Option<String>,
        /// A joint.
        #[serde(default)]
        joint: Option<String>,
        /// A place.
        #[serde(default)]
        location: Option<Location>,
    },
    /// The version of the program.
    Version,
}

/// A robot: a file, with arguments over its defaults.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct RobotParams {
    /// The file, relative to the folder of all files.
    pub file: String,
    /// Arguments, as `name:=value` gives them on the command line.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub args: BTreeMap<String, String>,
    /// Folders that are searched for packages first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub package_path: Vec<PathBuf>,
}

/// What to check and how: the options of `xacro-lint check` of the same names.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct CheckCall {
    /// Files and folders; all files where it is empty.
    #[serde(default)]
    pub paths: Vec<PathBuf>,
    /// Files that are robots even if they look like macro libraries.
    #[serde(default)]
    pub entry: Vec<PathBuf>,
    /// Arguments.
    #[serde(default)]
    pub args: BTreeMap<String, String>,
    /// Run only these rules.
    #[serde(default)]
    pub select: Option<Vec<String>>,
    /// Also run these rules.
    #[serde(default)]
    pub extend_select: Option<Vec<String>>,
    /// Do not run these rules.
    #[serde(default)]
    pub ignore: Option<Vec<String>>,
    /// Enable the rules of these profiles.
    #[serde(default)]
    pub profile: Option<Vec<String>>,
    /// Report what these programs reject, change or ignore (`--for`).
    #[serde(default, rename = "for")]
    pub consumers: Option<Vec<String>>,
    /// Folders that are searched for packages first.
    #[serde(default)]
    pub package_path: Vec<PathBuf>,
    /// This configuration file instead of the nearest one.
    #[serde(default)]
    pub config: Option<PathBuf>,
    /// Report each location of a cause by itself.
    #[serde(default)]
    pub no_group: bool,
    /// Of `fix`: apply fixes that may change numbers or names, too.
    #[serde(default)]
    pub unsafe_fixes: bool,
}

impl CheckCall {
    /// What is checked.
    ///
    /// # Errors
    /// When there is no rule, profile or consumer of a name.
    pub(super) fn options(&self) -> Result<CheckOptions, String> {
        let selectors = [&self.select, &self.extend_select, &self.ignore];
        let mut names = selectors.into_iter().flatten().flatten();
        if let Some(unknown) =
            names.find(|name| *name != "ALL" && rules::find(name).next().is_none())
        {
            return Err(rules::unknown_selector(unknown));
        }
        let paths = if self.paths.is_empty() && self.entry.is_empty() {
            vec![PathBuf::from(".")]
        } else {
            self.paths.clone()
        };
        Ok(CheckOptions {
            paths,
            entries: self.entry.clone(),
            args: self.args.clone().into_iter().collect(),
            ..CheckOptions::default()
        })
    }

    /// The session for it.
    pub(super) fn setup(&self, options: &CheckOptions, cwd: &std::path::Path) -> Setup {
        Setup {
            about: options
                .paths
                .iter()
                .chain(&options.entries)
                .next()
                .cloned()
                .unwrap_or_default(),
            folders: options.paths.iter().map(|path| cwd.join(path)).collect(),
            package_path: self.package_path.clone(),
            overrides: Overrides {
                config: self.config.clone(),
                select: self.select.clone(),
                extend_select: self.extend_select.clone(),
                ignore: self.ignore.clone(),
                profiles: self.profile.clone(),
                consumers: self.consumers.clone(),
                ..Overrides::default()
            },
        }
    }
}
