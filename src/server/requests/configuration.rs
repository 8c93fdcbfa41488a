//! Requests about configuration files, where a client opens one.
use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionResponse, CompletionTextEdit,
    Documentation, HoverContents, TextDocumentPositionParams, TextEdit,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::state::ServerState;
use analysis::{ConfigChoice, ConfigChoiceKind, is_config};
use base::CancelFlag;

/// Whether a request is about a configuration file.
pub fn is_about_config(state: &ServerState, at: &TextDocumentPositionParams) -> bool {
    is_config(&state.path(&at.text_document.uri))
}

/// What may be written at a place in a configuration file.
pub fn completion(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Option<CompletionResponse>, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let found = analysis::config_choices_at(&mut state.host, &path, offset, cancel);
    if cancel.is_cancelled() {
        return Err(RequestFailure::Cancelled);
    }
    let Some(found) = found else { return Ok(None) };
    let range = convert::range(&source.document, found.range, state.encoding);
    let item = |(place, choice): (usize, ConfigChoice)| {
        let is_key = choice.kind == ConfigChoiceKind::Key;
        let (detail, docs) = if is_key {
            (String::new(), choice.detail)
        } else {
            (choice.detail, String::new())
        };
        CompletionItem {
            kind: Some(kind(choice.kind)),
            detail: Some(detail).filter(|detail| !detail.is_empty()),
            documentation: Some(docs)
                .filter(|docs| !docs.is_empty())
                .map(Documentation::String),
            sort_text: Some(format!("{place:04}")),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(range, choice.text))),
            // what is typed is the name, with or without quotes
            filter_text: Some(choice.name.clone()),
            label: choice.name,
            ..CompletionItem::default()
        }
    };
    let items = found.items.into_iter().enumerate().map(item).collect();
    Ok(Some(CompletionResponse::List(CompletionList {
        is_incomplete: false,
        items,
    })))
}

/// What a key says.
pub fn hover(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
) -> Result<Option<lsp_types::Hover>, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let found = analysis::config_key_at(state.host.session(), &path, offset);
    Ok(found.map(|(range, doc)| lsp_types::Hover {
        range: Some(convert::range(&source.document, range, state.encoding)),
        contents: HoverContents::Markup(state.client.hover.contents(doc.to_owned())),
    }))
}

fn kind(kind: ConfigChoiceKind) -> CompletionItemKind {
    match kind {
        ConfigChoiceKind::Key => CompletionItemKind::PROPERTY,
        ConfigChoiceKind::Argument => CompletionItemKind::VARIABLE,
        ConfigChoiceKind::Value => CompletionItemKind::VALUE,
        ConfigChoiceKind::Link => CompletionItemKind::CLASS,
        ConfigChoiceKind::Joint => CompletionItemKind::EVENT,
        ConfigChoiceKind::Rule => CompletionItemKind::ENUM_MEMBER,
        ConfigChoiceKind::File => CompletionItemKind::FILE,
        ConfigChoiceKind::Folder => CompletionItemKind::FOLDER,
    }
}
