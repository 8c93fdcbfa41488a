//! Between our terms and those of the protocol.
use std::path::{Path, PathBuf};

use lsp_types::{Position, Range, Url};

use base::{Encoding, LineCol, TextRange};
use xml::Document;

/// The path a document is kept under. What is no file keeps its whole name, below no folder.
pub(super) fn path(uri: &Url) -> PathBuf {
    file_path(uri)
        .filter(|path| !path.to_string_lossy().contains('\0'))
        .unwrap_or_else(|| Path::new("/").join(uri.as_str().replace(['/', '\0'], "_")))
}

/// The path of a file, where a URI is that of one.
pub(super) fn file_path(uri: &Url) -> Option<PathBuf> {
    if uri.scheme() != "file" {
        return None;
    }
    #[cfg(any(unix, windows))]
    return uri.to_file_path().ok();
    // what a browser has for a system has no paths of its own
    #[cfg(not(any(unix, windows)))]
    return Some(
        packages::percent_decoded(uri.path())
            .unwrap_or_else(|| uri.path().to_owned())
            .into(),
    );
}

/// The name of a file without its folders.
pub(super) fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// The URI of a file.
pub(super) fn file_uri(path: &Path) -> Option<Url> {
    #[cfg(any(unix, windows))]
    return Url::from_file_path(path).ok();
    #[cfg(not(any(unix, windows)))]
    return Url::parse(&base::paths::HERE.file_uri(path.to_str()?)).ok();
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
/// count in UTF-16 remove the whole character: it belongs to the text before the edit.
pub(super) fn edited_range(document: &Document, range: Range, encoding: Encoding) -> TextRange {
    let a = edited_offset(document, range.start, encoding);
    let b = edited_offset(document, range.end, encoding);
    TextRange::new(a.min(b), a.max(b))
}

/// The byte offset of one end of an edit: behind the character when it lies between the halves of a surrogate pair.
fn edited_offset(document: &Document, position: Position, encoding: Encoding) -> u32 {
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
}
