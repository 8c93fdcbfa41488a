//! Semantic tokens, all, changed or of a range.
use std::path::{Path, PathBuf};

use lsp_types::{
    SemanticToken, SemanticTokenModifier, SemanticTokens, SemanticTokensDelta,
    SemanticTokensDeltaParams, SemanticTokensEdit, SemanticTokensFullDeltaResult,
    SemanticTokensFullOptions, SemanticTokensLegend, SemanticTokensOptions, SemanticTokensParams,
    SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult,
    TextDocumentIdentifier, TextDocumentPositionParams, WorkDoneProgressOptions,
};

use crate::convert;
use crate::encoded_tokens::{EncodedPart, JoinedTokens, KINDS};
use crate::failure::RequestFailure;
use crate::requests::navigation::asked;
use crate::state::ServerState;
use base::CancelFlag;
use ide::{self, HighlightToken};

/// What the server offers.
pub(crate) fn offered() -> SemanticTokensOptions {
    // in the order of the bits of `Modifiers`
    let modifiers = vec![
        SemanticTokenModifier::DECLARATION,
        SemanticTokenModifier::READONLY,
        SemanticTokenModifier::DEPRECATED,
        SemanticTokenModifier::DEFAULT_LIBRARY,
        SemanticTokenModifier::new("unused"),
    ];
    SemanticTokensOptions {
        work_done_progress_options: WorkDoneProgressOptions::default(),
        legend: SemanticTokensLegend {
            token_types: KINDS.iter().map(|(_, kind)| kind.clone()).collect(),
            token_modifiers: modifiers,
        },
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Delta { delta: Some(true) }),
    }
}

pub fn tokens(
    state: &mut ServerState,
    params: SemanticTokensParams,
    cancel: &CancelFlag,
) -> Result<Option<SemanticTokensResult>, RequestFailure> {
    let (path, data) = token_data(state, params.text_document, cancel)?;
    let result_id = Some(remember(state, &path, &data));
    Ok(Some(SemanticTokensResult::Tokens(SemanticTokens {
        result_id,
        data,
    })))
}

pub fn tokens_delta(
    state: &mut ServerState,
    params: SemanticTokensDeltaParams,
    cancel: &CancelFlag,
) -> Result<Option<SemanticTokensFullDeltaResult>, RequestFailure> {
    let (path, data) = token_data(state, params.text_document, cancel)?;
    let known = state.sent.tokens.get(&path);
    let known = known.filter(|sent| sent.number.to_string() == params.previous_result_id);
    let edits = known.map(|sent| difference(&sent.data, &data));
    let result_id = Some(remember(state, &path, &data));
    Ok(Some(match edits {
        Some(edits) => {
            SemanticTokensFullDeltaResult::TokensDelta(SemanticTokensDelta { result_id, edits })
        }
        None => SemanticTokensFullDeltaResult::Tokens(SemanticTokens { result_id, data }),
    }))
}

pub fn tokens_range(
    state: &mut ServerState,
    params: SemanticTokensRangeParams,
    cancel: &CancelFlag,
) -> Result<Option<SemanticTokensRangeResult>, RequestFailure> {
    let (_, source) = state.source(&params.text_document.uri)?;
    let range = convert::text_range(&source.document, params.range, state.encoding);
    let asked = asked(state, &start_of(params.text_document), cancel)?;
    let tokens = ide::tokens(&asked.cx(), range);
    let mut joined = JoinedTokens::default();
    joined.add(&EncodedPart::of(
        &asked.source.document.text(),
        &tokens,
        state.encoding,
    ));
    let data = joined.data;
    Ok(Some(SemanticTokensRangeResult::Tokens(SemanticTokens {
        result_id: None,
        data,
    })))
}

/// The tokens of a whole document. Those of parts that are the same as the last time are taken over.
fn token_data(
    state: &mut ServerState,
    document: TextDocumentIdentifier,
    cancel: &CancelFlag,
) -> Result<(PathBuf, Vec<SemanticToken>), RequestFailure> {
    let asked = asked(state, &start_of(document), cancel)?;
    let path = asked.source.path.to_path_buf();
    let sent = state.sent.tokens.entry(path.clone()).or_default();
    let encoding = state.encoding;
    let encoded = |text: &str, tokens: &[HighlightToken]| EncodedPart::of(text, tokens, encoding);
    let mut joined = JoinedTokens::default();
    let cx = asked.cx();
    let parts = sent.kept.renew(&cx, encoded);
    parts.for_each(|part| joined.add(part));
    Ok((path, joined.data))
}

/// Keep what is sent; its name.
fn remember(state: &mut ServerState, path: &Path, data: &[SemanticToken]) -> String {
    // files that are closed are not asked about again
    let documents = &state.documents;
    state
        .sent
        .tokens
        .retain(|path, _| documents.contains_key(path));
    let sent = state.sent.tokens.entry(path.to_path_buf()).or_default();
    sent.number += 1;
    sent.data = data.to_vec();
    sent.number.to_string()
}

/// The start of a document, for requests about all of it.
pub(crate) fn start_of(text_document: TextDocumentIdentifier) -> TextDocumentPositionParams {
    TextDocumentPositionParams {
        text_document,
        position: lsp_types::Position::default(),
    }
}

/// What changed, as one edit; in numbers, five a piece.
fn difference(old: &[SemanticToken], new: &[SemanticToken]) -> Vec<SemanticTokensEdit> {
    let same = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let (old_rest, new_rest) = (
        old.get(same..).unwrap_or(&[]),
        new.get(same..).unwrap_or(&[]),
    );
    let behind = old_rest
        .iter()
        .rev()
        .zip(new_rest.iter().rev())
        .take_while(|(a, b)| a == b)
        .count();
    let removed = old_rest.len() - behind;
    let added = new_rest.get(..new_rest.len() - behind).unwrap_or(&[]);
    if removed == 0 && added.is_empty() {
        return Vec::new();
    }
    let edit = SemanticTokensEdit {
        start: 5 * same as u32,
        delete_count: 5 * removed as u32,
        data: (!added.is_empty()).then(|| added.to_vec()),
    };
    vec![edit]
}
