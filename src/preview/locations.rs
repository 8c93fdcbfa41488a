//! Places of the source as messages write them.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use base::paths::HERE;
use base::{Encoding, LineCol, TextRange};
use expand::{Expansion, FileRange, FrameKind, Origin};

/// A line and a column, both from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LinePosition {
    /// The line.
    pub line: u32,
    /// The column, in the units agreed with the client.
    pub character: u32,
}

/// A range of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LineRange {
    /// Its first character.
    pub start: LinePosition,
    /// Behind its last one.
    pub end: LinePosition,
}

/// A range of a file, as the language server protocol writes it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Location {
    /// The file.
    pub uri: String,
    /// Where in it.
    pub range: LineRange,
}

impl Location {
    /// The first character of a file.
    pub fn start(uri: String) -> Self {
        let first = LinePosition {
            line: 0,
            character: 0,
        };
        Self {
            uri,
            range: LineRange {
                start: first,
                end: first,
            },
        }
    }
}

/// How a client names files and counts columns.
pub struct LocationFormat<'a> {
    /// The URI of a path.
    pub uri: &'a dyn Fn(&Path) -> Option<String>,
    /// The path of a URI.
    pub path: &'a dyn Fn(&str) -> Option<PathBuf>,
    /// The unit of columns.
    pub encoding: Encoding,
}

/// Places in one expansion.
pub(super) struct LocationMapper<'a> {
    pub names: &'a LocationFormat<'a>,
    pub expansion: &'a Expansion,
}

impl LocationMapper<'_> {
    /// Where an origin stands.
    pub fn of(&self, origin: Origin) -> Option<Location> {
        self.place(self.expansion.place(origin)?)
    }

    /// A place in a file of the expansion, in the text that was expanded.
    pub fn place(&self, place: FileRange) -> Option<Location> {
        let source = &self.expansion.files.get(place.file)?.source;
        let point = |offset| {
            let LineCol { line, col } = source.document.line_col(offset, self.names.encoding);
            LinePosition {
                line,
                character: col,
            }
        };
        let range = LineRange {
            start: point(place.range.start),
            end: point(place.range.end),
        };
        Some(Location {
            uri: (self.names.uri)(&source.path)?,
            range,
        })
    }

    /// The outermost macro call that led to an origin.
    pub fn call(&self, origin: Origin) -> Option<Location> {
        let calls = self
            .expansion
            .frames_of(origin)
            .filter(|frame| frame.kind == FrameKind::Macro);
        self.of(calls.last()?.call)
    }

    /// The path and the text range that a location names in a file of the expansion.
    pub fn range(&self, location: &Location) -> Option<(expand::FileIdx, TextRange)> {
        let path = (self.names.path)(&location.uri)?;
        let mut files = self.expansion.files.iter_ids();
        let (file, used) = files.find(|(_, used)| *used.source.path == *path)?;
        let document = &used.source.document;
        let [start, end] = [location.range.start, location.range.end].map(|point| {
            let at = LineCol {
                line: point.line,
                col: point.character,
            };
            document.offset(at, self.names.encoding)
        });
        let range = TextRange::new(start.min(end), start.max(end));
        Some((file, range))
    }
}

/// The URI of an absolute path, for hosts that have no names of their own.
pub fn file_uri(path: &Path) -> String {
    HERE.file_uri(&path.to_string_lossy())
}
