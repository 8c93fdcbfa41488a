//! The arguments that descriptions declare.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::includes::reach;
use super::session::Session;
use base::FastSet;
use facts::{FactKind, MentionKind, facts_of};
use vfs::SourceFile;
use workspace::has_name;

/// Descriptions that are read for the arguments of one robot.
const MOST_FILES: usize = 500;

/// The arguments that a description knows.
#[derive(Default)]
pub(super) struct KnownArguments {
    pub(super) names: FastSet<EcoString>,
    /// Whether all that may be included was read, and each name is written out.
    pub(super) complete: bool,
    /// The files that were read.
    pub(super) files: Vec<Arc<SourceFile>>,
}

impl KnownArguments {
    /// The arguments that a description and everything that it may include declare or read, in any branch.
    pub(super) fn of(session: &Session, robot: &Path) -> Self {
        let mut known = Self {
            complete: true,
            ..Self::default()
        };
        let mut seen: FastSet<PathBuf> = FastSet::default();
        let mut open = vec![robot.to_owned()];
        while let Some(path) = open.pop() {
            if !seen.insert(path.clone()) {
                continue;
            }
            let Ok(source) = session.vfs.document(&path) else {
                known.complete = false;
                continue;
            };
            if seen.len() > MOST_FILES || !source.document.errors().is_empty() {
                known.complete = false;
            }
            if seen.len() > MOST_FILES {
                break;
            }
            known.names.extend(arguments(&source));
            known.files.push(source.clone());
            let reach = reach(&source, &session.packages);
            known.complete &= !reach.anything;
            for files in reach.files(&session.vfs) {
                known.complete &= !files.is_empty();
                open.extend(files);
            }
        }
        known.complete &= !known.names.iter().any(|name| name.contains('$'));
        known
    }

    /// Whether a description has no arguments, and not even a comment about one of this name: it has no variants.
    pub(super) fn never_had(&self, name: &str) -> bool {
        let mut files = self.files.iter();
        self.names.is_empty() && !files.any(|file| has_name(&file.document.text(), name))
    }

    /// The arguments that are declared, each with its default where it has one.
    pub(super) fn defaults(&self) -> Vec<(String, Option<String>)> {
        let mut found = Vec::new();
        for file in &self.files {
            let entities = file.document.entities();
            for (_, item) in file.document.parts() {
                for node in item.all_nodes().filter(|node| node.name() == "xacro:arg") {
                    let Some(name) = node.attr("name") else {
                        continue;
                    };
                    let default = node
                        .attr("default")
                        .map(|default| default.value(entities).into_owned());
                    found.push((name.raw().to_owned(), default));
                }
            }
        }
        found
    }
}

/// The arguments that a file declares or reads, as they are written.
pub(super) fn arguments(file: &SourceFile) -> Vec<EcoString> {
    let mut names = Vec::new();
    for (_, item) in file.document.parts() {
        let facts = facts_of(item);
        let declared = facts
            .named
            .iter()
            .filter(|fact| fact.kind == FactKind::Argument);
        names.extend(declared.map(|fact| fact.name.clone()));
        let read = facts
            .mentions()
            .filter(|mention| mention.kind == MentionKind::Argument);
        names.extend(read.map(|mention| mention.name.clone()));
    }
    names
}
