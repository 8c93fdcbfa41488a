//! Reading files beside robots.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::super::root_analysis::RootAnalysis;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use base::{FastMap, FileId};
use project::{Srdf, YamlSettings, may_be_settings};
use rules::{BesideContent, is_semantic_name};

/// A file beside a robot, read.
#[derive(Clone)]
pub struct Beside {
    /// Its path.
    pub path: PathBuf,
    /// Its number.
    pub file: FileId,
    /// What it says.
    pub(super) read: ParsedBeside,
}

/// What a file beside a robot says.
#[derive(Clone)]
pub(super) enum ParsedBeside {
    /// A semantic description, with its expansion.
    Srdf(Arc<RootAnalysis>, Arc<Srdf>),
    /// YAML.
    Settings(Arc<YamlSettings>),
}

/// What a file beside a robot is by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sort {
    /// SRDF, or a xacro file that gives one.
    Srdf,
    /// YAML.
    Yaml,
}

/// What a file beside a robot may be, by its name.
pub(crate) fn sort(path: &Path) -> Option<Sort> {
    let name = path.file_name()?.to_str()?;
    let ending = name
        .rsplit_once('.')
        .map_or("", |(_, ending)| ending)
        .to_ascii_lowercase();
    if is_semantic_name(path) {
        return Some(Sort::Srdf);
    }
    (["yaml", "yml"].contains(&ending.as_str()) || name == ".setup_assistant").then_some(Sort::Yaml)
}

/// Whether a file is YAML that may hold settings of a robot, by its name.
pub fn is_settings(path: &Path) -> bool {
    sort(path) == Some(Sort::Yaml)
}

/// What a YAML file is for, in one word: the first that it says something about.
fn kind_of(settings: &YamlSettings) -> &'static str {
    let kinds = [
        (settings.assistant.is_some(), "setup-assistant"),
        (
            !settings.listed.is_empty() || !settings.controllers.is_empty(),
            "controllers",
        ),
        (!settings.moveit.is_empty(), "moveit-controllers"),
        (!settings.limits.is_empty(), "joint-limits"),
        (!settings.kinematics.is_empty(), "kinematics"),
        (!settings.planners.is_empty(), "planners"),
    ];
    kinds
        .into_iter()
        .find(|(is_it, _)| *is_it)
        .map_or("servo", |(_, kind)| kind)
}

impl Beside {
    /// What it is for, in one word.
    pub fn kind(&self) -> &'static str {
        self.settings().map_or("srdf", kind_of)
    }

    /// What it says, for rules.
    pub(super) fn content(&self) -> BesideContent<'_> {
        match &self.read {
            ParsedBeside::Srdf(_, srdf) => BesideContent::Srdf(srdf),
            ParsedBeside::Settings(settings) => BesideContent::Settings(settings),
        }
    }

    /// The SRDF with its expansion.
    pub fn srdf(&self) -> Option<(&RootAnalysis, &Srdf)> {
        match &self.read {
            ParsedBeside::Srdf(analyzed, srdf) => Some((analyzed, srdf)),
            ParsedBeside::Settings(_) => None,
        }
    }

    /// The settings.
    pub fn settings(&self) -> Option<&YamlSettings> {
        match &self.read {
            ParsedBeside::Settings(settings) => Some(settings),
            ParsedBeside::Srdf(..) => None,
        }
    }

    /// The different names of links, joints and groups.
    pub(super) fn names(&self) -> Vec<(project::ProjectNameKind, EcoString)> {
        let mut found: Vec<_> = match (self.srdf(), self.settings()) {
            (Some((_, srdf)), _) => srdf
                .names()
                .into_iter()
                .filter_map(|(text, kind, _)| Some((kind, text.name()?.clone())))
                .collect(),
            (_, Some(settings)) => settings
                .names()
                .into_iter()
                .map(|(name, kind)| (kind, name.name.clone()))
                .collect(),
            _ => Vec::new(),
        };
        found.sort_unstable_by(|(a, one), (b, two)| (*a as u8, one).cmp(&(*b as u8, two)));
        found.dedup();
        found
    }
}

impl Session {
    /// The files beside a robot, each with a word for what it is for; without those that say nothing of it.
    pub fn files_beside(&self, root: &Path) -> Vec<(PathBuf, &'static str)> {
        let kind = |file: &Path| match sort(file)? {
            Sort::Srdf => Some("srdf"),
            Sort::Yaml => Some(kind_of(&*self.beside_settings(file)?)),
        };
        let files = self.beside_of(&self.vfs.absolute(root)).into_iter();
        files
            .filter_map(|file| kind(&file).map(|kind| (file, kind)))
            .collect()
    }

    /// A file beside robots; none when it says nothing about one, or is broken.
    pub(super) fn beside(&self, path: &Path, robots: &Robots) -> Option<Beside> {
        let read = match sort(path)? {
            Sort::Srdf => {
                let analyzed = robots.get(&RootConfig::plain(path))?.clone();
                let srdf = Srdf::of(&analyzed.expansion)?;
                ParsedBeside::Srdf(analyzed, Arc::new(srdf))
            }
            Sort::Yaml => ParsedBeside::Settings(self.beside_settings(path)?),
        };
        Some(Beside {
            path: path.to_owned(),
            file: self.vfs.file_id(path),
            read,
        })
    }

    /// Whether a file may say something about a robot: an SRDF, or YAML with words of settings.
    pub(in super::super) fn is_about_robots(&self, path: &Path) -> bool {
        match sort(path) {
            Some(Sort::Srdf) => true,
            Some(Sort::Yaml) => self
                .vfs
                .text(path)
                .is_ok_and(|text| may_be_settings(&text.text)),
            None => false,
        }
    }

    /// The settings in a YAML file; none when it has none, or is broken.
    pub(in super::super) fn beside_settings(&self, path: &Path) -> Option<Arc<YamlSettings>> {
        let text = self.vfs.text(path).ok()?;
        if !may_be_settings(&text.text) {
            return None;
        }
        let yaml = self.vfs.yaml(path, "").ok()?;
        Some(Arc::new(YamlSettings::read(
            &text.text,
            yaml.value.as_ref().ok()?,
        )?))
    }
}

/// Robots and SRDFs, expanded.
pub(in super::super) type Robots = FastMap<RootConfig, Arc<RootAnalysis>>;
