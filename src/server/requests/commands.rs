//! The operations of our own protocol as commands, for clients without custom requests.
use lsp_types::ExecuteCommandParams;
use serde_json::Value;

use crate::client::ResolvedCapabilities;
use crate::failure::RequestFailure;
use crate::files::rewrite_mesh;
use crate::preview::preview_page;
use crate::requests::actions::apply_offered;
use crate::requests::code_action::APPLY;
use crate::requests::expand_at::{expand_at, set_instance};
use crate::requests::expansion::expand;
use crate::requests::lenses::calls_of;
use crate::requests::roots::{set_args, set_root, tree};
use crate::scheduler::Cause;
use crate::state::ServerState;
use base::CancelFlag;

/// The commands for all clients.
const NAMES: &[&str] = &[
    "xacro.expand",
    "xacro.expandAt",
    "xacro.explain",
    "xacro.preview",
    "xacro.restartAnalysis",
    "xacro.rewriteMesh",
    "xacro.selectInstance",
    "xacro.selectRoot",
    "xacro.setArgs",
    "xacro.showReferences",
    "xacro.tree",
];

/// The commands that a client may run.
pub(crate) fn offered(client: &ResolvedCapabilities) -> impl Iterator<Item = &'static str> + use<> {
    let apply = (client.edits.on_request && !client.actions.literals).then_some(APPLY);
    NAMES.iter().copied().chain(apply)
}

pub fn command(
    state: &mut ServerState,
    params: ExecuteCommandParams,
    cancel: &CancelFlag,
) -> Result<Option<Value>, RequestFailure> {
    let argument = params.arguments.into_iter().next().unwrap_or(Value::Null);
    match params.command.as_str() {
        APPLY => apply_offered(state, parsed(argument)?).map(|()| None),
        "xacro.expand" => {
            expand(state, parsed(argument)?, cancel).map(|answer| serde_json::to_value(answer).ok())
        }
        "xacro.expandAt" => expand_at(state, parsed(argument)?, cancel)
            .map(|answer| serde_json::to_value(answer).ok()),
        "xacro.explain" => explain(&parsed::<Explained>(argument)?.rule).map(Some),
        "xacro.rewriteMesh" => rewrite_mesh(state, &parsed(argument)?).map(|()| None),
        "xacro.selectInstance" => set_instance(state, parsed(argument)?, cancel).map(Some),
        "xacro.setArgs" => {
            set_args(state, parsed(argument)?, cancel).map(|roots| serde_json::to_value(roots).ok())
        }
        "xacro.showReferences" => calls_of(state, &parsed(argument)?, cancel)
            .map(|(_, places)| serde_json::to_value(places).ok()),
        "xacro.selectRoot" => set_root(state, parsed(argument)?, cancel).map(Some),
        "xacro.tree" => {
            tree(state, parsed(argument)?, cancel).map(|tree| serde_json::to_value(tree).ok())
        }
        "xacro.preview" => preview_page(state, argument).map(Some),
        "xacro.restartAnalysis" => {
            state.host.reload();
            state.schedule(Cause::Restarted);
            Ok(None)
        }
        other => Err(RequestFailure::Invalid(format!(
            "unknown command `{other}`"
        ))),
    }
}

#[derive(serde::Deserialize)]
struct Explained {
    /// Name or code.
    rule: String,
}

/// The page of a rule, in Markdown.
fn explain(rule: &str) -> Result<Value, RequestFailure> {
    let known = rules::all().find(|known| known.name == rule || known.code == rule);
    let known = known.ok_or_else(|| RequestFailure::Invalid(rules::unknown_selector(rule)))?;
    Ok(Value::String(known.docs.to_owned()))
}

fn parsed<T: serde::de::DeserializeOwned>(argument: Value) -> Result<T, RequestFailure> {
    serde_json::from_value(argument).map_err(|error| RequestFailure::Invalid(error.to_string()))
}
