//! Inlay hints.
use lsp_types::{
    InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams, TextDocumentIdentifier,
    TextDocumentPositionParams,
};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::navigation::asked;
use crate::requests::tokens::start_of;
use crate::state::ServerState;
use base::CancelFlag;
use ide::{self, HintKind, HintSettings};

/// What is needed to say more about a hint.
#[derive(Serialize, Deserialize)]
struct About {
    uri: lsp_types::Url,
    offset: u32,
    /// Whether it is about an expression: other hints say it all.
    value: bool,
}

pub fn hints(
    state: &mut ServerState,
    params: InlayHintParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<InlayHint>>, RequestFailure> {
    let uri = params.text_document.uri.clone();
    let asked = asked(state, &start_of(params.text_document), cancel)?;
    let document = &asked.source.document;
    let range = convert::text_range(document, params.range, state.encoding);
    let hint = |hint: ide::Hint| {
        let about = About {
            uri: uri.clone(),
            offset: hint.about,
            value: hint.kind == HintKind::Value,
        };
        InlayHint {
            position: convert::position(document, hint.offset, state.encoding),
            label: InlayHintLabel::String(hint.label),
            kind: match hint.kind {
                HintKind::Block => Some(InlayHintKind::PARAMETER),
                HintKind::Value | HintKind::End => None,
            },
            text_edits: None,
            tooltip: None,
            padding_left: Some(hint.kind != HintKind::Block),
            padding_right: Some(hint.kind == HintKind::Block),
            data: serde_json::to_value(about).ok(),
        }
    };
    Ok(Some(
        ide::hints(&asked.cx(), range, state.settings.hints)
            .into_iter()
            .map(hint)
            .collect(),
    ))
}

/// The same hint with all there is to say about its value.
pub fn resolve_hint(
    state: &mut ServerState,
    mut hint: InlayHint,
    cancel: &CancelFlag,
) -> Result<InlayHint, RequestFailure> {
    let about: Option<About> = hint
        .data
        .clone()
        .and_then(|data| serde_json::from_value(data).ok());
    let Some(About {
        uri,
        offset,
        value: true,
    }) = about
    else {
        return Ok(hint);
    };
    let position = hint.position;
    let text_document = TextDocumentIdentifier { uri };
    let asked = asked(
        state,
        &TextDocumentPositionParams {
            text_document,
            position,
        },
        cancel,
    )?;
    // the text may have changed since
    if offset < asked.offset {
        let value = ide::value_of(&asked.cx(), offset);
        hint.tooltip = value.map(|value| state.client.hover.tooltip(value));
    }
    Ok(hint)
}

/// Take over what settings say about hints: keys below `inlayHints`, nested or with dots.
pub(crate) fn settings(settings: &Value, into: &mut HintSettings) {
    if let Some(values) = setting(settings, "values").and_then(Value::as_bool) {
        into.values = values;
    }
    if let Some(names) = setting(settings, "paramNames").and_then(Value::as_str) {
        into.blocks = names != "never";
    }
    if let Some(most) = setting(settings, "maxLength").and_then(Value::as_u64) {
        into.most = most.clamp(1, 1000) as usize;
    }
}

fn setting<'s>(settings: &'s Value, name: &str) -> Option<&'s Value> {
    let nested = settings.get("inlayHints").and_then(|table| table.get(name));
    nested.or_else(|| settings.get(format!("inlayHints.{name}")))
}
