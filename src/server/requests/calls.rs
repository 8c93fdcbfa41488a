//! Which macro calls which.
use lsp_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem,
    CallHierarchyOutgoingCall, CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams,
    SymbolKind, TextDocumentIdentifier, TextDocumentPositionParams,
};

use crate::failure::RequestFailure;
use crate::locations::location;
use crate::requests::asked::Asked;
use crate::requests::navigation::asked;
use crate::state::ServerState;
use base::{CancelFlag, Span};
use ide::{self, CallParticipant};

pub fn prepare_calls(
    state: &mut ServerState,
    params: CallHierarchyPrepareParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<CallHierarchyItem>>, RequestFailure> {
    let asked = asked(state, &params.text_document_position_params, cancel)?;
    let found = ide::macro_at(&asked.cx(), asked.offset);
    Ok(found
        .and_then(|id| call_item(state, &asked, &CallParticipant::Macro(id)))
        .map(|item| vec![item]))
}

pub fn incoming_calls(
    state: &mut ServerState,
    params: CallHierarchyIncomingCallsParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<CallHierarchyIncomingCall>>, RequestFailure> {
    let (asked, caller) = asked_about(state, &params.item, cancel)?;
    let Some(CallParticipant::Macro(id)) = caller else {
        return Ok(Some(Vec::new()));
    };
    let calls = ide::incoming(&asked.cx(), id)
        .into_iter()
        .filter_map(|calls| {
            Some(CallHierarchyIncomingCall {
                from: call_item(state, &asked, &calls.other)?,
                from_ranges: ranges(state, calls.at),
            })
        });
    Ok(Some(calls.collect()))
}

pub fn outgoing_calls(
    state: &mut ServerState,
    params: CallHierarchyOutgoingCallsParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<CallHierarchyOutgoingCall>>, RequestFailure> {
    let (asked, caller) = asked_about(state, &params.item, cancel)?;
    let Some(caller) = caller else {
        return Ok(Some(Vec::new()));
    };
    let calls = ide::outgoing(&asked.cx(), &caller)
        .into_iter()
        .filter_map(|calls| {
            Some(CallHierarchyOutgoingCall {
                to: call_item(state, &asked, &calls.other)?,
                from_ranges: ranges(state, calls.at),
            })
        });
    Ok(Some(calls.collect()))
}

/// The macro or file that an item stands for, as things are now.
fn asked_about(
    state: &mut ServerState,
    item: &CallHierarchyItem,
    cancel: &CancelFlag,
) -> Result<(Asked, Option<CallParticipant>), RequestFailure> {
    let text_document = TextDocumentIdentifier {
        uri: item.uri.clone(),
    };
    let at = TextDocumentPositionParams {
        text_document,
        position: item.selection_range.start,
    };
    let asked = asked(state, &at, cancel)?;
    let caller = match item.kind {
        SymbolKind::FILE => Some(CallParticipant::File(asked.source.id)),
        _ => ide::macro_at(&asked.cx(), asked.offset).map(CallParticipant::Macro),
    };
    Ok((asked, caller))
}

fn call_item(
    state: &ServerState,
    asked: &Asked,
    caller: &CallParticipant,
) -> Option<CallHierarchyItem> {
    let cx = asked.cx();
    let target = ide::caller_target(&cx, caller)?;
    let (whole, name) = (
        location(state, target.whole)?,
        location(state, target.name)?,
    );
    let path = state.host.session().vfs.path(target.whole.file);
    let file = path.file_name()?.to_string_lossy().into_owned();
    let (name_text, kind, detail) = match caller {
        CallParticipant::Macro(id) => (
            cx.expansion.index.symbols.get(*id)?.name.to_string(),
            SymbolKind::FUNCTION,
            Some(file),
        ),
        CallParticipant::File(_) => (file, SymbolKind::FILE, None),
    };
    Some(CallHierarchyItem {
        name: name_text,
        kind,
        tags: None,
        detail,
        uri: whole.uri,
        range: whole.range,
        selection_range: name.range,
        data: None,
    })
}

fn ranges(state: &ServerState, spans: Vec<Span>) -> Vec<lsp_types::Range> {
    spans
        .into_iter()
        .filter_map(|span| Some(location(state, span)?.range))
        .collect()
}
