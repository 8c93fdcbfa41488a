//! Formatting of documents and ranges.
use std::path::Path;

use lsp_types::{
    DocumentFormattingParams, DocumentRangeFormattingParams, FormattingOptions, TextEdit,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::state::ServerState;
use base::{CancelFlag, TextRange};
use ide::{self, Indent};
use workspace::config::Format;
use xml::Document;

pub fn format(
    state: &mut ServerState,
    params: DocumentFormattingParams,
    _: &CancelFlag,
) -> Result<Option<Vec<TextEdit>>, RequestFailure> {
    let (path, source) = state.source(&params.text_document.uri)?;
    let edits = ide::format(
        &source.document,
        &indent(&params.options, &source.document),
        &format_options(state, &path),
    );
    Ok(Some(text_edits(state, &source.document, edits)))
}

pub fn format_range(
    state: &mut ServerState,
    params: DocumentRangeFormattingParams,
    _: &CancelFlag,
) -> Result<Option<Vec<TextEdit>>, RequestFailure> {
    let (path, source) = state.source(&params.text_document.uri)?;
    let document = &source.document;
    let range = convert::text_range(document, params.range, state.encoding);
    let edits = ide::format_range(
        document,
        range,
        &indent(&params.options, document),
        &format_options(state, &path),
    );
    Ok(Some(text_edits(state, document, edits)))
}

fn format_options(state: &ServerState, path: &Path) -> Format {
    state.host.session().settings(path).config.format.clone()
}

fn text_edits(
    state: &ServerState,
    document: &Document,
    edits: Vec<(TextRange, String)>,
) -> Vec<TextEdit> {
    let edit = |(range, text)| TextEdit::new(convert::range(document, range, state.encoding), text);
    edits.into_iter().map(edit).collect()
}

/// The steps of indentation that an editor asks for. Tabs are what some editors ask for when nobody has told them
/// anything: a file that uses blanks keeps them.
pub(super) fn indent(options: &FormattingOptions, document: &Document) -> Indent {
    let columns = options.tab_size.min(16) as usize;
    if options.insert_spaces {
        return Indent::blanks(columns);
    }
    let own = ide::own_indentation(document).filter(|own| own.unit != "\t");
    own.unwrap_or_else(|| Indent::tabs(columns))
}
