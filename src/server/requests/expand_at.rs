//! What one place expands to, and which call of a macro is looked at.
use lsp_types::{Range, TextDocumentPositionParams};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::contexts::context_changed;
use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::asked::Asked;
use crate::requests::navigation::asked;
use crate::root_param::{RootParam, chosen};
use crate::state::ServerState;
use base::CancelFlag;

#[derive(Clone, Debug, Deserialize)]
pub(crate) struct ExpandAtParams {
    #[serde(flatten)]
    pub at: TextDocumentPositionParams,
    pub root: Option<RootParam>,
    /// Which of the ways that lead there, from 0.
    pub instance: Option<usize>,
}

/// What a place expands to.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ExpandedLocation {
    pub kind: &'static str,
    pub title: String,
    pub range: Range,
    pub expanded: String,
    pub instances: usize,
}

#[derive(Clone, Debug, Deserialize)]
pub(crate) struct SetInstanceParams {
    #[serde(flatten)]
    pub at: TextDocumentPositionParams,
    /// Which call of the macro, from 0; none: all of them again.
    pub instance: Option<usize>,
}

pub fn expand_at(
    state: &mut ServerState,
    params: ExpandAtParams,
    cancel: &CancelFlag,
) -> Result<Option<ExpandedLocation>, RequestFailure> {
    let mut asked = asked(state, &params.at, cancel)?.on_name();
    if let Some(root) = params.root {
        let root = chosen(state, root)?;
        let analyzed = state
            .host
            .analyzed(&root, cancel)
            .ok_or(RequestFailure::Cancelled)?;
        asked = Asked {
            analyzed,
            selected_frame: None,
            ..asked
        };
    }
    let found = ide::expand_at(
        &asked.cx(),
        asked.analyzed.written(),
        asked.offset,
        params.instance,
    );
    Ok(found.map(|found| ExpandedLocation {
        kind: found.kind,
        title: found.title,
        range: convert::range(&asked.source.document, found.range, state.encoding),
        expanded: found.expanded,
        instances: found.instances,
    }))
}

pub fn set_instance(
    state: &mut ServerState,
    params: SetInstanceParams,
    cancel: &CancelFlag,
) -> Result<Value, RequestFailure> {
    let asked = asked(state, &params.at, cancel)?;
    let root = asked.analyzed.root.file.clone();
    match params.instance {
        None => {
            state.selected_instances.remove(&root);
        }
        Some(index) => {
            let selected =
                ide::select_instance(&asked.cx(), asked.offset, index).map_err(|count| {
                    RequestFailure::Invalid(match count {
                        0 => "no called macro here".to_owned(),
                        _ => format!("unknown call {index}: the macro is called {count} times"),
                    })
                })?;
            state.selected_instances.insert(root, selected);
        }
    }
    context_changed(state, cancel);
    Ok(Value::Null)
}
