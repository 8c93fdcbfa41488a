//! The result of a check.
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::cut::Cut;
use base::limits::DRAWN_LINE;
use base::{Encoding, FileId, Span};
use rules::consumers::Tally;
use rules::{Finding, Severity};
use vfs::{LoadError, SourceFile, Vfs};

/// What a check found.
#[derive(Debug, Default)]
pub struct Report {
    /// The findings, by path, position and code.
    pub findings: Vec<Finding>,
    /// The files that were read as descriptions.
    pub files: BTreeMap<FileId, Arc<SourceFile>>,
    /// Further files that findings are in, such as configurations and manifests, read as text.
    pub beside: BTreeMap<FileId, Arc<SourceFile>>,
    /// The files that findings are in, by number.
    pub paths: BTreeMap<FileId, Arc<Path>>,
    /// The files that were expanded as roots, in order, with the number of robots among them.
    pub roots: Vec<PathBuf>,
    /// Everything that was read or looked for, configurations too: when one of these changes, so may the findings.
    pub reads: BTreeSet<PathBuf>,
    /// How many of the roots are robots.
    pub robots: usize,
    /// The roots that would be robots if they had a name.
    pub nameless: Vec<PathBuf>,
    /// The robots some of whose packages were not found, with the names of these.
    pub incomplete: BTreeMap<PathBuf, BTreeSet<String>>,
    /// The robots that errors left out a part of: rules about what is missing or unused do not run on them.
    pub partial: BTreeMap<PathBuf, Cut>,
    /// The robots that programs reject or change which nobody named, with what they do; empty when it was not counted.
    pub consumers: BTreeMap<PathBuf, Tally>,
    /// The files beside robots, such as SRDF, that were compared with them.
    pub compared: Vec<PathBuf>,
    /// The robots that were checked in place of the files that were named, which are parts of them.
    pub part_of: Vec<PathBuf>,
    /// Paths named by the user that cannot be read.
    pub unreadable: Vec<Unreadable>,
    /// What was asked for and not checked, though it is there.
    pub skipped: Vec<Skipped>,
}

/// A file or folder that was not checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skipped {
    /// As it was asked for.
    pub path: PathBuf,
    /// Why it was not checked.
    pub reason: SkipReason,
}

/// Why a file or folder was not checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SkipReason {
    /// The configuration excludes a file that the user named.
    Excluded,
    /// The folder cannot be listed.
    Unreadable(LoadError),
    /// It belongs to a robot, and none that is whole is known.
    NoRobot,
    /// Places are reported by path, and this path is no text.
    NotUtf8,
}

impl Report {
    /// The errors, by rule and message: what tells one from another when places move.
    pub(super) fn errors(&self) -> Vec<(&'static str, String)> {
        let is_error = |finding: &&Finding| finding.severity == Severity::Error;
        let errors = self.findings.iter().filter(is_error);
        errors
            .map(|finding| (finding.rule.code, finding.message.clone()))
            .collect()
    }

    /// Read the files that findings and fixes are about and that no expansion reads, such as package.xml.
    pub(super) fn read_beside(&mut self, vfs: &Vfs) {
        let unread = self
            .paths
            .iter()
            .filter(|(id, _)| !self.files.contains_key(id));
        let read = unread.filter_map(|(_, path)| vfs.document(path).ok());
        let beside: Vec<_> = read.map(|file| (file.id, file)).collect();
        self.beside.extend(beside);
    }

    /// Note what was skipped below the folder `named` by the user.
    pub(super) fn skip(&mut self, skipped: Skipped, named: &Path) {
        match skipped.reason {
            SkipReason::Unreadable(error) if skipped.path == named => {
                self.unreadable.push(Unreadable {
                    path: skipped.path,
                    error,
                });
            }
            _ => self.skipped.push(skipped),
        }
    }
}

impl std::fmt::Display for SkipReason {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Excluded => f.write_str("it is excluded by the configuration"),
            Self::Unreadable(error) => write!(f, "cannot read the folder: {}", error.reason()),
            Self::NoRobot => f.write_str("no complete robot is known that it belongs to"),
            Self::NotUtf8 => f.write_str("its name is not valid UTF-8"),
        }
    }
}

/// A path named by the user that cannot be read.
#[derive(Clone, Debug)]
pub struct Unreadable {
    /// The path, absolute.
    pub path: PathBuf,
    /// What the system says.
    pub error: LoadError,
}

/// A place as people count: row and column from 1, columns in characters; the end is exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// Row and column of the first character.
    pub start: (u32, u32),
    /// Row and column behind the last character.
    pub end: (u32, u32),
}

impl Report {
    /// The path of a file that a finding is in.
    pub fn path(&self, file: FileId) -> &Path {
        self.paths.get(&file).map_or(Path::new(""), |path| path)
    }

    /// A file that findings may be in.
    pub fn source(&self, file: FileId) -> Option<&Arc<SourceFile>> {
        self.files.get(&file).or_else(|| self.beside.get(&file))
    }

    /// The line that a span begins in; empty when its file could not be read, or when nobody would read the line.
    pub fn line(&self, span: Span) -> String {
        let Some(file) = self.source(span.file) else {
            return String::new();
        };
        file.document
            .line_around(span.range.start, DRAWN_LINE as u32)
            .map_or_else(String::new, |(line, _)| line)
    }

    /// Rows and columns of a span; the start of the file when it could not be read.
    pub fn position(&self, span: Span) -> Position {
        let Some(file) = self.source(span.file) else {
            return Position {
                start: (1, 1),
                end: (1, 1),
            };
        };
        Position {
            start: row_and_column(file, span.range.start),
            end: row_and_column(file, span.range.end),
        }
    }
}

fn row_and_column(file: &SourceFile, offset: u32) -> (u32, u32) {
    let position = file.document.line_col(offset, Encoding::Utf32);
    (position.line + 1, position.col + 1)
}
