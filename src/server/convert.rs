//! Between our terms and those of the protocol.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use lsp_types::{Location, Position, Range, Url};

use crate::state::State;
use base::{Encoding, FastMap, FileId, LineCol, Span, TextRange};
use vfs::SourceFile;
use xml::Document;

/// The path a document is kept under. What is no file keeps its whole name, below no folder.
pub(super) fn path(uri: &Url) -> PathBuf {
    let file = (uri.scheme() == "file")
        .then(|| uri.to_file_path().ok())
        .flatten();
    file.filter(|path| !path.to_string_lossy().contains('\0'))
        .unwrap_or_else(|| Path::new("/").join(uri.as_str().replace(['/', '\0'], "_")))
}

/// A position in the encoding agreed with the client.
pub(super) fn position(document: &Document, offset: u32, encoding: Encoding) -> Position {
    let LineCol { line, col } = document.line_col(offset, encoding);
    Position::new(line, col)
}

/// A range.
pub(super) fn range(document: &Document, range: TextRange, encoding: Encoding) -> Range {
    Range::new(
        position(document, range.start, encoding),
        position(document, range.end, encoding),
    )
}

/// The byte offset of a position.
pub(super) fn offset(document: &Document, position: Position, encoding: Encoding) -> u32 {
    document.offset(
        LineCol {
            line: position.line,
            col: position.character,
        },
        encoding,
    )
}

/// The bytes of a range; the right way round.
pub(super) fn text_range(document: &Document, range: Range, encoding: Encoding) -> TextRange {
    let (a, b) = (
        offset(document, range.start, encoding),
        offset(document, range.end, encoding),
    );
    TextRange::new(a.min(b), a.max(b))
}

/// The bytes that an edit replaces. Where an edit begins or ends between the halves of a surrogate pair, clients that
/// count so keep no half of it: the character belongs to what is in front of the place.
pub(super) fn edited_range(document: &Document, range: Range, encoding: Encoding) -> TextRange {
    let behind = |position: Position| {
        let at = offset(document, position, encoding);
        let back = document.line_col(at, encoding);
        let is_inside = encoding == Encoding::Utf16
            && (back.line, back.col + 1) == (position.line, position.character)
            && document
                .slice(TextRange::new(at, at + 4))
                .chars()
                .next()
                .is_some_and(|c| c.len_utf16() == 2);
        if is_inside { at + 4 } else { at }
    };
    let (a, b) = (behind(range.start), behind(range.end));
    TextRange::new(a.min(b), a.max(b))
}

/// A file as the client knows it, and what it holds.
type File = (Url, Option<Arc<SourceFile>>);

/// Places in files, for an answer that names many of them: each is worked out once.
pub(super) struct Places<'e> {
    pub state: &'e State,
    files: FastMap<FileId, Option<File>>,
    ranges: FastMap<Span, Range>,
}

impl Places<'_> {
    /// A place in a file.
    pub fn location(&mut self, span: Span) -> Option<Location> {
        self.place(span)
            .map(|(uri, range)| Location::new(uri.clone(), range))
    }

    fn place(&mut self, span: Span) -> Option<(&Url, Range)> {
        let state = self.state;
        let file = self
            .files
            .entry(span.file)
            .or_insert_with(|| file(state, span.file));
        let (uri, source) = file.as_ref()?;
        let range = self.ranges.entry(span).or_insert_with(|| match source {
            Some(source) => range(&source.document, span.range, state.encoding),
            None => Range::default(),
        });
        Some((uri, *range))
    }
}

/// Places in files as they are now.
pub fn places(state: &State) -> Places<'_> {
    Places {
        state,
        files: FastMap::default(),
        ranges: FastMap::default(),
    }
}

/// A place in a file.
pub fn location(state: &State, span: Span) -> Option<Location> {
    places(state).location(span)
}

fn file(state: &State, id: FileId) -> Option<File> {
    let path = state.world.session().vfs.path(id);
    Some((state.uri(&path)?, state.world.document(&path)))
}
