//! The operations of our own protocol as commands, for clients without custom requests.

use lsp_types::ExecuteCommandParams;
use serde_json::Value;

use super::client::ClientFacts;
use super::engine::Engine;
use super::failure::Failure;
use base::CancelFlag;

/// Makes the edits of an action, for clients that take actions as commands only.
pub(super) const APPLY: &str = "xacro.applyEdit";

/// The commands for all clients.
const NAMES: &[&str] = &[
    "xacro.expand",
    "xacro.expandAt",
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
pub(super) fn offered(client: &ClientFacts) -> impl Iterator<Item = &'static str> + use<> {
    let apply = (client.applies_edits && !client.action_literals).then_some(APPLY);
    NAMES.iter().copied().chain(apply)
}

impl Engine {
    pub fn command(
        &mut self,
        params: ExecuteCommandParams,
        cancel: &CancelFlag,
    ) -> Result<Option<Value>, Failure> {
        let argument = params.arguments.into_iter().next().unwrap_or(Value::Null);
        match params.command.as_str() {
            APPLY => self.apply(parsed(argument)?).map(|()| None),
            "xacro.expand" => {
                self.expand(parsed(argument)?, cancel).map(|answer| serde_json::to_value(answer).ok())
            }
            "xacro.expandAt" => {
                self.expand_at(parsed(argument)?, cancel).map(|answer| serde_json::to_value(answer).ok())
            }
            "xacro.rewriteMesh" => self.rewrite_mesh(&parsed(argument)?).map(|()| None),
            "xacro.selectInstance" => self.set_instance(parsed(argument)?, cancel).map(Some),
            "xacro.setArgs" => {
                self.set_args(parsed(argument)?, cancel).map(|roots| serde_json::to_value(roots).ok())
            }
            "xacro.showReferences" => {
                self.calls_of(&parsed(argument)?, cancel).map(|(_, places)| serde_json::to_value(places).ok())
            }
            "xacro.selectRoot" => self.set_root(parsed(argument)?, cancel).map(Some),
            "xacro.tree" => self.tree(parsed(argument)?, cancel).map(|tree| serde_json::to_value(tree).ok()),
            "xacro.preview" => self.preview_page(argument).map(Some),
            "xacro.restartAnalysis" => {
                self.world.reload();
                self.schedule();
                Ok(None)
            }
            other => Err(Failure::Invalid(format!("there is no command `{other}`"))),
        }
    }
}

fn parsed<T: serde::de::DeserializeOwned>(argument: Value) -> Result<T, Failure> {
    serde_json::from_value(argument).map_err(|error| Failure::Invalid(error.to_string()))
}
