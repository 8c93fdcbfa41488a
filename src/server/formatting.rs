//! Formatting of documents and ranges.

use std::path::Path;

use lsp_types::{DocumentFormattingParams, DocumentRangeFormattingParams, FormattingOptions, TextEdit};

use super::convert;
use super::engine::Engine;
use super::failure::Failure;
use base::{CancelFlag, TextRange};
use ide::{self, Indent};
use workspace::config::Format;
use xml::Document;

impl Engine {
    pub fn format(
        &mut self,
        params: DocumentFormattingParams,
        _: &CancelFlag,
    ) -> Result<Option<Vec<TextEdit>>, Failure> {
        let (path, source) = self.source(&params.text_document.uri)?;
        let edits = ide::format(&source.document, &indent(&params.options), &self.format_options(&path));
        Ok(Some(self.text_edits(&source.document, edits)))
    }

    pub fn format_range(
        &mut self,
        params: DocumentRangeFormattingParams,
        _: &CancelFlag,
    ) -> Result<Option<Vec<TextEdit>>, Failure> {
        let (path, source) = self.source(&params.text_document.uri)?;
        let document = &source.document;
        let range = convert::text_range(document, params.range, self.encoding);
        let edits = ide::format_range(document, range, &indent(&params.options), &self.format_options(&path));
        Ok(Some(self.text_edits(document, edits)))
    }

    fn format_options(&self, path: &Path) -> Format {
        self.world.session().settings(path).config.format.clone()
    }

    fn text_edits(&self, document: &Document, edits: Vec<(TextRange, String)>) -> Vec<TextEdit> {
        let edit = |(range, text)| TextEdit::new(convert::range(document, range, self.encoding), text);
        edits.into_iter().map(edit).collect()
    }
}

/// The steps of indentation that an editor asks for.
fn indent(options: &FormattingOptions) -> Indent {
    let columns = options.tab_size.min(16) as usize;
    if options.insert_spaces { Indent::blanks(columns) } else { Indent::tabs(columns) }
}
