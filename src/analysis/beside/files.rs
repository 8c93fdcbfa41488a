//! Reading files beside robots.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::super::root_analysis::RootAnalysis;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::sort::{Sort, beside_settings, sort};
use base::{FastMap, FileId};
use project::{Srdf, YamlSettings};
use rules::BesideContent;

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

/// What a YAML file is for, in one word: the first that it says something about.
pub(super) fn kind_of(settings: &YamlSettings) -> &'static str {
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

/// A file beside robots; none when it says nothing about one, or is broken.
pub(super) fn read_beside(session: &Session, path: &Path, robots: &Robots) -> Option<Beside> {
    let read = match sort(path)? {
        Sort::Srdf => {
            let analyzed = robots.get(&RootConfig::plain(path))?.clone();
            let srdf = Srdf::of(&analyzed.expansion)?;
            ParsedBeside::Srdf(analyzed, Arc::new(srdf))
        }
        Sort::Yaml => ParsedBeside::Settings(beside_settings(session, path)?),
    };
    Some(Beside {
        path: path.to_owned(),
        file: session.vfs.file_id(path),
        read,
    })
}

/// Robots and SRDFs, expanded.
pub(in super::super) type Robots = FastMap<RootConfig, Arc<RootAnalysis>>;
