//! Semantic tokens, all, changed or of a range.
use std::path::{Path, PathBuf};

use lsp_types::{
    SemanticToken, SemanticTokenModifier, SemanticTokenType, SemanticTokens, SemanticTokensDelta,
    SemanticTokensDeltaParams, SemanticTokensEdit, SemanticTokensFullDeltaResult,
    SemanticTokensFullOptions, SemanticTokensLegend, SemanticTokensOptions, SemanticTokensParams,
    SemanticTokensRangeParams, SemanticTokensRangeResult, SemanticTokensResult,
    TextDocumentIdentifier, TextDocumentPositionParams, WorkDoneProgressOptions,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::navigation::asked;
use crate::state::ServerState;
use base::{CancelFlag, Encoding, TextRange};
use ide::{self, HighlightToken, TokenKind};

/// The kinds in the order of their numbers.
const KINDS: &[(TokenKind, SemanticTokenType)] = &[
    (TokenKind::Macro, SemanticTokenType::MACRO),
    (TokenKind::Parameter, SemanticTokenType::PARAMETER),
    (TokenKind::Variable, SemanticTokenType::VARIABLE),
    (TokenKind::Property, SemanticTokenType::PROPERTY),
    (TokenKind::Keyword, SemanticTokenType::KEYWORD),
    (TokenKind::Function, SemanticTokenType::FUNCTION),
    (TokenKind::Number, SemanticTokenType::NUMBER),
    (TokenKind::String, SemanticTokenType::STRING),
    (TokenKind::Operator, SemanticTokenType::OPERATOR),
    (TokenKind::EnumMember, SemanticTokenType::ENUM_MEMBER),
    (TokenKind::Namespace, SemanticTokenType::NAMESPACE),
    (TokenKind::Class, SemanticTokenType::CLASS),
    (TokenKind::Event, SemanticTokenType::EVENT),
    (TokenKind::Comment, SemanticTokenType::COMMENT),
];

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
    let data = encoded(&asked.source.document.text(), &tokens, state.encoding);
    Ok(Some(SemanticTokensRangeResult::Tokens(SemanticTokens {
        result_id: None,
        data,
    })))
}

fn token_data(
    state: &mut ServerState,
    document: TextDocumentIdentifier,
    cancel: &CancelFlag,
) -> Result<(PathBuf, Vec<SemanticToken>), RequestFailure> {
    let asked = asked(state, &start_of(document), cancel)?;
    let whole = TextRange::new(0, u32::MAX);
    let tokens = ide::tokens(&asked.cx(), whole);
    let data = encoded(&asked.source.document.text(), &tokens, state.encoding);
    Ok((asked.source.path.to_path_buf(), data))
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

/// Pieces as the protocol has them: line by line, each relative to the one in front.
fn encoded(text: &str, tokens: &[HighlightToken], encoding: Encoding) -> Vec<SemanticToken> {
    let mut out = Vec::new();
    let (mut line, mut line_start, mut next_line) = (0, 0, line_end(text, 0));
    let (mut last_line, mut last_col) = (0, 0);
    // a place on the line and its column: lines may be as long as the file
    let mut known = (0, 0);
    for token in tokens {
        let kind = KINDS
            .iter()
            .position(|(kind, _)| *kind == token.kind)
            .unwrap_or(0) as u32;
        let mut start = token.range.start;
        while start < token.range.end {
            while let Some(next) = next_line.filter(|next| *next <= start) {
                (line, line_start, next_line) = (line + 1, next, line_end(text, next));
                known = (line_start, 0);
            }
            let end = next_line.unwrap_or(text.len() as u32).min(token.range.end);
            let piece = TextRange::new(start, end)
                .slice(text)
                .trim_end_matches(['\r', '\n']);
            let blank = (piece.len() - piece.trim_start().len()) as u32;
            let words = piece.trim();
            if !words.is_empty() {
                let at = start + blank;
                // tokens come in order
                let from = if known.0 <= at {
                    known
                } else {
                    (line_start, 0)
                };
                let col = from.1 + encoding.width(TextRange::new(from.0, at).slice(text));
                known = (at, col);
                out.push(SemanticToken {
                    delta_line: line - last_line,
                    delta_start: if line == last_line {
                        col - last_col
                    } else {
                        col
                    },
                    length: encoding.width(words),
                    token_type: kind,
                    token_modifiers_bitset: token.modifiers.0,
                });
                (last_line, last_col) = (line, col);
            }
            start = end.max(start + 1);
        }
    }
    out
}

/// The offset behind the end of the line that begins at `start`; none for the last line.
fn line_end(text: &str, start: u32) -> Option<u32> {
    let rest = text.get(start as usize..)?;
    let end = base::line_end(rest);
    let wide = rest.get(end..)?.starts_with("\r\n");
    (end < rest.len()).then_some(start + end as u32 + 1 + u32::from(wide))
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
