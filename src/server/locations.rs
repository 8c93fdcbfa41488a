//! Locations in files, as the client knows them.
use std::sync::Arc;

use lsp_types::{Location, Range, Url};

use crate::convert::range;
use crate::state::ServerState;
use base::{FastMap, FileId, Span};
use vfs::SourceFile;

/// A file as the client knows it, and what it holds.
type ClientFile = (Url, Option<Arc<SourceFile>>);

/// Places in files, for an answer that names many of them: each is worked out once.
pub(super) struct LocationCache<'e> {
    pub state: &'e ServerState,
    files: FastMap<FileId, Option<ClientFile>>,
    ranges: FastMap<Span, Range>,
}

impl LocationCache<'_> {
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
pub fn places(state: &ServerState) -> LocationCache<'_> {
    LocationCache {
        state,
        files: FastMap::default(),
        ranges: FastMap::default(),
    }
}

/// A place in a file.
pub fn location(state: &ServerState, span: Span) -> Option<Location> {
    places(state).location(span)
}

fn file(state: &ServerState, id: FileId) -> Option<ClientFile> {
    let path = state.host.session().vfs.path(id);
    Some((state.uri(&path)?, state.host.document(&path)))
}
