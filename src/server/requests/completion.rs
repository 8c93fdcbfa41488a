//! What helps while somebody types: completion, signatures, end tags and indentation.
use std::path::PathBuf;
use std::sync::Arc;

use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionItemLabelDetails, CompletionList,
    CompletionParams, CompletionResponse, CompletionTextEdit, DocumentOnTypeFormattingParams,
    InsertReplaceEdit, InsertTextFormat, ParameterInformation, ParameterLabel, Range,
    SignatureHelp, SignatureHelpParams, SignatureInformation, TextEdit, Url,
};
use serde::{Deserialize, Serialize};

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::beside::robots_described;
use crate::requests::configuration::is_about_config;
use crate::requests::formatting::indent;
use crate::requests::launch::is_about_launch;
use crate::requests::{beside, configuration, launch};
use crate::state::ServerState;
use analysis::{RootAnalysis, RootConfig, is_settings};
use base::{CancelFlag, TextRange};
use ide::{
    self, Completion, CompletionScope, CompletionSources, Completions, ItemKind, Signature, Topic,
};
use vfs::SourceFile;

/// What comes back when an item is looked at.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ResolveData {
    uri: Url,
    topic: Topic,
}

/// What an answer is taken from, kept alive.
struct CompletionSnapshot {
    source: Arc<SourceFile>,
    root: RootConfig,
    analyzed: Vec<Arc<RootAnalysis>>,
    roots: Vec<PathBuf>,
    /// Of an SRDF: the robots that it is for.
    described: Vec<Arc<RootAnalysis>>,
}

pub fn completion(
    state: &mut ServerState,
    params: CompletionParams,
    cancel: &CancelFlag,
) -> Result<Option<CompletionResponse>, RequestFailure> {
    let at = params.text_document_position;
    if is_about_launch(state, &at) {
        return launch::completion(state, &at);
    }
    if is_about_config(state, &at) {
        return configuration::completion(state, &at, cancel);
    }
    if is_settings(&state.path(&at.text_document.uri)) {
        let found = beside::completions(state, &at, cancel)?;
        return Ok(found.map(|(source, found)| list(state, &source, &found, &at.text_document.uri)));
    }
    let kept = kept(state, &at.text_document.uri, cancel)?;
    let document = &kept.source.document;
    let offset = convert::offset(document, at.position, state.encoding);
    let trigger = params.context.and_then(|context| context.trigger_character);
    let trigger = trigger.and_then(|text| text.chars().next());
    let found = scoped(state, &kept, |scope| {
        ide::completions(scope, offset, trigger)
    });
    Ok(Some(list(
        state,
        &kept.source,
        &found,
        &at.text_document.uri,
    )))
}

fn list(
    state: &ServerState,
    source: &SourceFile,
    found: &Completions,
    uri: &Url,
) -> CompletionResponse {
    let range = |range: TextRange| convert::range(&source.document, range, state.encoding);
    let replaced = ReplacedRanges {
        insert: range(found.insert),
        replace: range(found.replace),
    };
    let item =
        |(place, item): (usize, &Completion)| completion_item(state, replaced, place, item, uri);
    let items = found.items.iter().enumerate().map(item).collect();
    CompletionResponse::List(CompletionList {
        is_incomplete: found.more,
        items,
    })
}

/// The file with everything that names in it are taken from.
fn kept(
    state: &mut ServerState,
    uri: &Url,
    cancel: &CancelFlag,
) -> Result<CompletionSnapshot, RequestFailure> {
    let (path, source) = state.source(uri)?;
    let context = analysis::context(&mut state.host, &path);
    let root = context.root.unwrap_or_else(|| RootConfig::plain(&path));
    let mut analyzed = state.host.while_typing(&root, &path, cancel);
    if cancel.is_cancelled() {
        return Err(RequestFailure::Cancelled);
    }
    let mut roots: Vec<PathBuf> = context
        .candidates
        .into_iter()
        .map(|(root, _)| root.file)
        .collect();
    roots.dedup();
    let described = robots_described(state, &path, &source, cancel);
    if !described.is_empty() {
        // its groups are given in the text that is edited
        let own = state
            .host
            .analyzed(&root, cancel)
            .ok_or(RequestFailure::Cancelled)?;
        analyzed.retain(|known| !Arc::ptr_eq(known, &own));
        analyzed.insert(0, own);
    }
    Ok(CompletionSnapshot {
        source,
        root,
        analyzed,
        roots,
        described,
    })
}

fn scoped<T>(
    state: &ServerState,
    kept: &CompletionSnapshot,
    work: impl FnOnce(&CompletionScope<'_>) -> T,
) -> T {
    let expansions: Vec<_> = kept
        .analyzed
        .iter()
        .map(|known| (&known.expansion, known.robot.as_ref()))
        .collect();
    let described: Vec<_> = kept
        .described
        .iter()
        .filter_map(|known| Some((&known.expansion, known.robot.as_ref()?)))
        .collect();
    let session = state.host.session();
    work(&CompletionScope::new(CompletionSources {
        source: &kept.source,
        root: &kept.root.file,
        expansions: &expansions,
        vfs: &session.vfs,
        packages: &session.packages,
        folders: state.host.folders(),
        roots: &kept.roots,
        described: &described,
    }))
}

/// What the items of a list take the place of.
#[derive(Clone, Copy)]
struct ReplacedRanges {
    /// What is typed of the word.
    insert: Range,
    /// The whole word.
    replace: Range,
}

fn completion_item(
    state: &ServerState,
    replaced: ReplacedRanges,
    place: usize,
    item: &Completion,
    uri: &Url,
) -> CompletionItem {
    let snippet = item
        .snippet
        .as_ref()
        .filter(|_| state.client.completion.snippets && state.settings.snippets);
    let text = snippet.unwrap_or(&item.text).clone();
    let edit = if state.client.completion.insert_replace {
        CompletionTextEdit::InsertAndReplace(InsertReplaceEdit {
            new_text: text,
            insert: replaced.insert,
            replace: replaced.replace,
        })
    } else {
        CompletionTextEdit::Edit(TextEdit::new(replaced.insert, text))
    };
    let note = Some(item.note.clone()).filter(|note| !note.is_empty());
    let detail = Some(item.detail.clone()).filter(|detail| !detail.is_empty());
    let details = note.clone().map(|note| CompletionItemLabelDetails {
        detail: None,
        description: Some(note),
    });
    let topic = item.topic.clone().map(|topic| ResolveData {
        uri: uri.clone(),
        topic,
    });
    CompletionItem {
        label: item.label.clone(),
        label_details: details.filter(|_| state.client.completion.label_details),
        kind: Some(kind(item.kind)),
        detail: detail.or_else(|| note.filter(|_| !state.client.completion.label_details)),
        sort_text: Some(format!("{place:04}")),
        insert_text_format: snippet.map(|_| InsertTextFormat::SNIPPET),
        text_edit: Some(edit),
        data: topic.and_then(|origin| serde_json::to_value(origin).ok()),
        ..CompletionItem::default()
    }
}

/// The item with its documentation. What comes back need not be what was sent: an item whose data says nothing
/// stays as it is.
pub fn resolve_completion(
    state: &mut ServerState,
    mut item: CompletionItem,
    cancel: &CancelFlag,
) -> Result<CompletionItem, RequestFailure> {
    let origin = item
        .data
        .clone()
        .and_then(|data| serde_json::from_value::<ResolveData>(data).ok());
    let Some(origin) = origin.filter(|_| item.documentation.is_none()) else {
        return Ok(item);
    };
    let Ok(kept) = kept(state, &origin.uri, cancel) else {
        return Ok(item);
    };
    let text = scoped(state, &kept, |scope| {
        ide::documentation(scope, &origin.topic)
    });
    item.documentation = text.map(|text| state.client.completion.item_docs.documentation(text));
    Ok(item)
}

pub fn signature_help(
    state: &mut ServerState,
    params: SignatureHelpParams,
    cancel: &CancelFlag,
) -> Result<Option<SignatureHelp>, RequestFailure> {
    let at = params.text_document_position_params;
    let kept = kept(state, &at.text_document.uri, cancel)?;
    let offset = convert::offset(&kept.source.document, at.position, state.encoding);
    let found = scoped(state, &kept, |scope| ide::signature_help(scope, offset));
    Ok(found.map(|found| SignatureHelp {
        active_signature: Some(0),
        active_parameter: found.active,
        signatures: vec![signature(state, found)],
    }))
}

fn signature(state: &ServerState, found: Signature) -> SignatureInformation {
    let label = &found.label;
    let parameter = |range: &TextRange| ParameterInformation {
        label: if state.client.completion.label_offsets {
            ParameterLabel::LabelOffsets([
                utf16_width(label, range.start),
                utf16_width(label, range.end),
            ])
        } else {
            ParameterLabel::Simple(range.slice(label).to_owned())
        },
        documentation: None,
    };
    let docs = Some(found.docs).filter(|docs| !docs.is_empty());
    SignatureInformation {
        parameters: Some(found.parameters.iter().map(parameter).collect()),
        documentation: docs.map(|docs| state.client.completion.signature_docs.documentation(docs)),
        active_parameter: found.active,
        label: found.label,
    }
}

/// The UTF-16 code units of a text before a byte.
fn utf16_width(text: &str, end: u32) -> u32 {
    let before = text.get(..end as usize).unwrap_or("");
    before.encode_utf16().count() as u32
}

pub fn on_type(
    state: &mut ServerState,
    params: DocumentOnTypeFormattingParams,
    _: &CancelFlag,
) -> Result<Option<Vec<TextEdit>>, RequestFailure> {
    let at = params.text_document_position;
    let (_, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let Some(character) = params.ch.chars().next() else {
        return Ok(None);
    };
    let unit = indent(&params.options, &source.document).unit;
    let edits = ide::on_type(&source.document, offset, character, &unit).into_iter();
    let edits: Vec<TextEdit> = edits
        .map(|edit| {
            TextEdit::new(
                convert::range(&source.document, edit.range, state.encoding),
                edit.text,
            )
        })
        .collect();
    Ok((!edits.is_empty()).then_some(edits))
}

fn kind(kind: ItemKind) -> CompletionItemKind {
    match kind {
        ItemKind::Element => CompletionItemKind::STRUCT,
        ItemKind::Directive => CompletionItemKind::KEYWORD,
        ItemKind::Macro | ItemKind::Function => CompletionItemKind::FUNCTION,
        ItemKind::Attribute => CompletionItemKind::FIELD,
        ItemKind::Choice => CompletionItemKind::ENUM_MEMBER,
        ItemKind::Link => CompletionItemKind::CLASS,
        ItemKind::Joint => CompletionItemKind::EVENT,
        ItemKind::Group | ItemKind::Controller => CompletionItemKind::INTERFACE,
        ItemKind::Color => CompletionItemKind::COLOR,
        ItemKind::Property | ItemKind::Constant => CompletionItemKind::CONSTANT,
        ItemKind::Parameter | ItemKind::Argument => CompletionItemKind::VARIABLE,
        ItemKind::Block | ItemKind::Snippet => CompletionItemKind::SNIPPET,
        ItemKind::Module | ItemKind::Package => CompletionItemKind::MODULE,
        ItemKind::Key => CompletionItemKind::PROPERTY,
        ItemKind::File => CompletionItemKind::FILE,
        ItemKind::Folder => CompletionItemKind::FOLDER,
    }
}
