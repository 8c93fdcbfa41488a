//! Renaming names in all files that use them.

use std::collections::{BTreeMap, HashMap};

use lsp_types::{
    DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier, PrepareRenameResponse, RenameParams,
    TextDocumentEdit, TextDocumentPositionParams, TextEdit, Url, WorkspaceEdit,
};

use super::convert;
use super::engine::Engine;
use super::failure::Failure;
use super::navigation::Asked;
use crate::base::limits::RENAME_ROBOTS;
use crate::base::{CancelFlag, Span};
use crate::ide::{self, Cx};

impl Engine {
    pub fn prepare_rename(
        &mut self,
        params: TextDocumentPositionParams,
        cancel: &CancelFlag,
    ) -> Result<Option<PrepareRenameResponse>, Failure> {
        let asked = self.asked(&params, cancel)?;
        let found = ide::renameable(&asked.cx(), asked.offset);
        Ok(found.map(|(range, placeholder)| {
            let range = convert::range(&asked.source.document, range, self.encoding);
            PrepareRenameResponse::RangeWithPlaceholder { range, placeholder }
        }))
    }

    pub fn rename(
        &mut self,
        params: RenameParams,
        cancel: &CancelFlag,
    ) -> Result<Option<WorkspaceEdit>, Failure> {
        let asked = self.asked(&params.text_document_position, cancel)?;
        let refuse = |message: String| Failure::Refused(message);
        let mut spans = ide::rename(&asked.cx(), asked.offset, &params.new_name).map_err(refuse)?;
        spans.extend(self.in_other_robots(&asked, cancel)?);
        spans.sort_by_key(|span| (span.file, span.range.start));
        spans.dedup();
        let mut edits: BTreeMap<Url, Vec<TextEdit>> = BTreeMap::new();
        for span in spans {
            let path = self.world.session().vfs.path(span.file);
            if !self.is_ours(&path) {
                let message = format!("`{}` is not part of the workspace and is not changed", path.display());
                return Err(Failure::Refused(message));
            }
            if let Some(place) = self.location(span) {
                edits.entry(place.uri).or_default().push(TextEdit::new(place.range, params.new_name.clone()));
            }
        }
        Ok(Some(self.workspace_edit(edits)))
    }

    /// Uses in the other robots that reach the definition.
    fn in_other_robots(&mut self, asked: &Asked, cancel: &CancelFlag) -> Result<Vec<Span>, Failure> {
        let Some((id, _)) = asked.cx().symbol_at(asked.offset) else { return Ok(Vec::new()) };
        let Some(target) = ide::definition_of(&asked.cx(), id) else { return Ok(Vec::new()) };
        let path = self.world.session().vfs.path(target.name.file);
        let candidates = self.world.context(&path).candidates;
        let mut found = Vec::new();
        for (root, _) in candidates.into_iter().take(RENAME_ROBOTS) {
            let analyzed = self.world.analyzed(&root, cancel).ok_or(Failure::Cancelled)?;
            let cx = Cx { expansion: &analyzed.expansion, ..asked.cx() };
            if let Some(id) = ide::definition_at(&cx, target.name) {
                found.extend(ide::places(&cx, id));
            }
        }
        Ok(found)
    }

    /// Files that may be changed: open ones, and those of the workspace that no tool has built.
    pub fn is_ours(&self, path: &std::path::Path) -> bool {
        const BUILT: [&str; 4] = ["install", "build", "log", "devel"];
        let inside = self.world.folders().iter().filter_map(|folder| path.strip_prefix(folder).ok());
        let built = |path: &std::path::Path| path.iter().any(|part| BUILT.iter().any(|name| part == *name));
        self.documents.contains_key(path) || inside.into_iter().any(|path| !built(path))
    }

    /// Edits with the versions they were made for, where the client takes that.
    pub fn workspace_edit(&self, edits: BTreeMap<Url, Vec<TextEdit>>) -> WorkspaceEdit {
        if !self.client.document_changes {
            let changes: HashMap<Url, Vec<TextEdit>> = edits.into_iter().collect();
            return WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() };
        }
        let edit = |(uri, edits): (Url, Vec<TextEdit>)| {
            let version = self.documents.get(&self.path(&uri)).map(|open| open.version);
            let text_document = OptionalVersionedTextDocumentIdentifier { uri, version };
            TextDocumentEdit { text_document, edits: edits.into_iter().map(OneOf::Left).collect() }
        };
        let changes = DocumentChanges::Edits(edits.into_iter().map(edit).collect());
        WorkspaceEdit { document_changes: Some(changes), ..WorkspaceEdit::default() }
    }
}
