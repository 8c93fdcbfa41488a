//! The action that sets an argument of the robot, for a finding that another value may settle.
use std::path::Path;

use lsp_types::{CodeAction, CodeActionKind, CodeActionParams, Command, Diagnostic};
use serde_json::json;

use crate::state::State;
use expand::Outside;
use rules::Finding;

/// Values that are offered, at most.
const MOST_VALUES: usize = 20;

/// The action, for clients that ask the user for the value.
pub(super) fn set_argument(
    state: &mut State,
    params: &CodeActionParams,
    path: &Path,
    finding: &Finding,
    shown: &Diagnostic,
) -> Option<CodeAction> {
    let Some(Outside::Argument(name)) = &finding.outside else {
        return None;
    };
    if !state.client.own.lens_commands {
        return None;
    }
    let values = known_values(state, path, name)?;
    let title = format!("Set argument `{name}`…");
    let argument =
        json!({ "textDocument": params.text_document, "name": name.as_str(), "values": values });
    Some(CodeAction {
        title: title.clone(),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![shown.clone()]),
        command: Some(Command {
            title,
            command: "xacro.setArgs".to_owned(),
            arguments: Some(vec![argument]),
        }),
        ..CodeAction::default()
    })
}

/// The values of an argument in presets and in calls of launch files, each once. `None` for a file that is seen
/// under no robot.
fn known_values(state: &mut State, path: &Path, name: &str) -> Option<Vec<String>> {
    let context = state.world.context(path);
    let root = context.root?;
    let presets = context
        .candidates
        .iter()
        .map(|(choice, _)| choice)
        .filter(|choice| choice.file == root.file);
    let calls = state.world.session().launched_roots(&root.file);
    let mut values: Vec<String> = Vec::new();
    for (known, value) in presets.chain(&calls).flat_map(|choice| &choice.args) {
        if known == name && !values.contains(value) {
            values.push(value.clone());
        }
    }
    values.truncate(MOST_VALUES);
    Some(values)
}
