//! The actions that set an argument of the robot, for a finding that another value may settle.
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionParams, Command, Diagnostic, TextDocumentPositionParams,
};
use serde_json::json;

use crate::failure::RequestFailure;
use crate::requests::asked::Asked;
use crate::requests::navigation::asked;
use crate::state::ServerState;
use base::CancelFlag;
use expand::{Outside, ProblemKind};
use rules::Finding;

/// Values that are offered, at most.
const MOST_VALUES: usize = 20;

/// The actions, for clients that ask the user for the value.
pub(super) fn set_arguments(
    state: &mut ServerState,
    params: &CodeActionParams,
    finding: &Finding,
    shown: &Diagnostic,
    cancel: &CancelFlag,
) -> Result<Vec<CodeAction>, RequestFailure> {
    if !state.client.own.lens_commands || !may_be_settled(finding) {
        return Ok(Vec::new());
    }
    let document = params.text_document.clone();
    let at = TextDocumentPositionParams::new(document, params.range.start);
    let asked = asked(state, &at, cancel)?;
    let mut found = Vec::new();
    for name in arguments_of(&asked, finding) {
        let Some(values) = known_values(state, &asked, &name) else {
            continue;
        };
        let title = format!("Set argument `{name}`…");
        let argument =
            json!({ "textDocument": params.text_document, "name": name, "values": values });
        found.push(CodeAction {
            title: title.clone(),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(vec![shown.clone()]),
            command: Some(Command {
                title,
                command: "xacro.setArgs".to_owned(),
                arguments: Some(vec![argument]),
            }),
            ..CodeAction::default()
        });
    }
    Ok(found)
}

/// Whether another value of an argument may make a finding go away.
fn may_be_settled(finding: &Finding) -> bool {
    matches!(finding.outside, Some(Outside::Argument(_)))
        || matches!(
            finding.problem,
            Some(
                ProblemKind::ExpressionError
                    | ProblemKind::InvalidCondition
                    | ProblemKind::IncludeNotFound
                    | ProblemKind::GlobIncludeNoMatch
                    | ProblemKind::PackageNotFound
                    | ProblemKind::UndefinedProperty
            )
        )
}

/// The argument that a finding says to depend on, or else those that are read at its place.
fn arguments_of(asked: &Asked, finding: &Finding) -> Vec<String> {
    match &finding.outside {
        Some(Outside::Argument(name)) => vec![name.to_string()],
        _ => ide::arguments_behind(&asked.cx(), finding.span.range),
    }
}

/// The values of an argument in presets and in calls of launch files, then those that it may have by files and comments,
/// each once. `None` for a file that is seen under no robot.
fn known_values(state: &mut ServerState, asked: &Asked, name: &str) -> Option<Vec<String>> {
    let context = analysis::context(&mut state.host, &asked.source.path);
    let root = context.root?;
    let presets = context
        .candidates
        .iter()
        .map(|(choice, _)| choice)
        .filter(|choice| choice.file == root.file);
    let session = state.host.session();
    let calls = analysis::launched_roots(session, &root.file);
    let settings = session.settings(&asked.source.path);
    let around = session.rule_env(&settings.config);
    let given = presets.chain(&calls).flat_map(|choice| &choice.args);
    let given = given
        .filter(|(known, _)| known == name)
        .map(|(_, value)| value.clone());
    let mut values: Vec<String> = Vec::new();
    for value in given.chain(ide::possible_values(&asked.cx(), around, name)) {
        if !values.contains(&value) {
            values.push(value);
        }
    }
    values.truncate(MOST_VALUES);
    Some(values)
}
