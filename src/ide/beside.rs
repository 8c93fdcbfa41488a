//! Names of the robot in files beside it, such as its SRDF.

use ecow::EcoString;

use super::context::Cx;
use super::names::place;
use super::rename_robot::{NamePart, parts};
use super::robot_names::RobotNameKind;
use base::{FileId, Span, TextRange};
use project::{ProjectNameKind, Srdf, YamlSettings};

/// A name of a link, joint or group in a file beside the robot.
#[derive(Clone, Debug)]
pub struct BesideName {
    /// The name.
    pub value: EcoString,
    /// The text that says it.
    pub place: Span,
    /// Whether the thing is given there: a group, or a virtual joint.
    pub is_definition: bool,
    pub(super) kind: RobotNameKind,
    /// What it holds, in one line: of a group where it is given.
    pub(super) content: String,
    /// The parts of it that are written letter by letter.
    pub(super) parts: Vec<NamePart>,
}

impl From<ProjectNameKind> for RobotNameKind {
    fn from(kind: ProjectNameKind) -> Self {
        match kind {
            ProjectNameKind::Link => RobotNameKind::Link,
            ProjectNameKind::Joint => RobotNameKind::Joint,
            ProjectNameKind::Group => RobotNameKind::Group,
        }
    }
}

/// The names in an SRDF; `cx` is about its own expansion.
pub fn names_in_srdf(cx: &Cx<'_>, srdf: &Srdf) -> Vec<BesideName> {
    let named = srdf
        .names()
        .into_iter()
        .filter(|(text, ..)| text.is_known());
    named
        .filter_map(|(text, kind, is_definition)| {
            let group = srdf
                .group(&text.value)
                .filter(|_| kind == ProjectNameKind::Group && is_definition);
            Some(BesideName {
                value: text.value.clone(),
                place: place(cx, text.origin)?,
                is_definition,
                kind: kind.into(),
                content: group
                    .map(project::PlanningGroup::in_short)
                    .unwrap_or_default(),
                parts: parts(cx, text),
            })
        })
        .collect()
}

/// The names in a YAML file with this text.
pub fn names_in_settings(file: FileId, text: &str, settings: &YamlSettings) -> Vec<BesideName> {
    let name = |(named, kind): (&project::SpannedName, ProjectNameKind)| {
        // a quoted name is written inside of its quotes
        let written = named.range.slice(text);
        let before = written.find(named.name.as_str())? as u32;
        let start = named.range.start + before;
        let place = Span {
            file,
            range: TextRange::new(start, start + named.name.len() as u32),
        };
        let of = TextRange::new(0, named.name.len() as u32);
        let parts = vec![NamePart { of, written: place }];
        Some(BesideName {
            value: named.name.clone(),
            place,
            is_definition: false,
            kind: kind.into(),
            content: String::new(),
            parts,
        })
    };
    settings.names().into_iter().filter_map(name).collect()
}

impl BesideName {
    /// Whether its text is at an offset of the file.
    pub(super) fn is_at(&self, cx: &Cx<'_>, offset: u32) -> bool {
        let range = self.place.range;
        self.place.file == cx.source.id && range.start <= offset && offset <= range.end
    }
}
