//! Lines above macros and the robot: how often it is called, commands.
use std::collections::BTreeMap;

use lsp_types::{
    CodeLens, CodeLensParams, Command, Location, TextDocumentIdentifier,
    TextDocumentPositionParams, Url,
};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::convert;
use crate::failure::RequestFailure;
use crate::locations::location;
use crate::requests::asked::Asked;
use crate::requests::navigation::asked;
use crate::requests::tokens::start_of;
use crate::state::ServerState;
use base::{CancelFlag, TextRange};

/// The macro whose calls a lens counts.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct CallsOf {
    uri: Url,
    position: lsp_types::Position,
    /// Which macro it was when the lens was made: text above it may have moved it since.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    of: Option<NamedMacro>,
}

/// A macro of a file: its name, and how many of that name stand in front of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct NamedMacro {
    name: String,
    before: usize,
}

pub fn lenses(
    state: &mut ServerState,
    params: CodeLensParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<CodeLens>>, RequestFailure> {
    if !state.client.shows_lenses() {
        return Ok(None);
    }
    let text_document = params.text_document.clone();
    let asked = asked(state, &start_of(params.text_document), cancel)?;
    let document = &asked.source.document;
    let mut found = Vec::new();
    if asked.analyzed.root.file == *asked.source.path
        && let Some(root) = document.root().filter(|_| asked.analyzed.robot.is_some())
    {
        let range = convert::range(document, root.name_range(), state.encoding);
        found.extend(root_lenses(
            state,
            &text_document,
            &shown_arguments(&asked),
            range,
        ));
    }
    if !state.client.own.lens_commands {
        return Ok(Some(found));
    }
    for (of, name) in macros(&asked) {
        let range = convert::range(document, name, state.encoding);
        let calls = CallsOf {
            uri: text_document.uri.clone(),
            position: range.start,
            of: Some(of),
        };
        found.push(CodeLens {
            range,
            command: None,
            data: serde_json::to_value(&calls).ok(),
        });
        let here = json!({ "textDocument": text_document, "position": range.start });
        found.push(lens(range, "Expand", "xacro.expandAt", here));
    }
    Ok(Some(found))
}

/// The arguments that a lens names: those that are given another value than their declaration says, or that have no
/// default; if there are none, all. In the order of their declarations.
fn shown_arguments(asked: &Asked) -> Vec<(&str, &str)> {
    let all = asked.analyzed.declared_arguments();
    let given = &asked.analyzed.root.args;
    let matters = |(name, value): &&(&str, &str)| {
        let declared = ide::declared_argument(&asked.analyzed.expansion, name);
        match declared.map(|(default, _)| default) {
            Some(Some(default)) => {
                given.iter().any(|(known, _)| known == name) && default != *value
            }
            Some(None) => true,
            None => false,
        }
    };
    let mattering: Vec<_> = all.iter().filter(matters).copied().collect();
    if mattering.is_empty() { all } else { mattering }
}

fn root_lenses(
    state: &ServerState,
    document: &TextDocumentIdentifier,
    arguments: &[(&str, &str)],
    range: lsp_types::Range,
) -> Vec<CodeLens> {
    const MOST: usize = 3;
    let here = json!({ "textDocument": document });
    if !state.client.own.lens_commands {
        // the only command whose result the server itself can have shown
        let shown = json!({ "textDocument": document, "show": true });
        return vec![lens(range, "Preview", "xacro.preview", shown)];
    }
    let mut found = vec![lens(range, "Preview", "xacro.preview", here.clone())];
    found.push(lens(range, "Expand", "xacro.expand", here.clone()));
    for (name, value) in arguments.iter().take(MOST) {
        found.push(lens(
            range,
            &format!("{name}:={} ▾", shown(value)),
            "xacro.setArgs",
            here.clone(),
        ));
    }
    found
}

/// The value of an argument as a lens has room for it: of a path that is absolute or long, the end.
fn shown(value: &str) -> String {
    const MOST: usize = 24;
    let is_long = value.starts_with('/') || value.chars().count() > MOST;
    match value.rsplit_once('/') {
        Some((folders, file)) if is_long && !folders.is_empty() && !file.is_empty() => {
            format!("…/{}", ide::cut(file, MOST))
        }
        _ => ide::cut(value, MOST),
    }
}

/// The lens with the number of calls.
pub fn resolve_lens(
    state: &mut ServerState,
    mut lens: CodeLens,
    cancel: &CancelFlag,
) -> Result<CodeLens, RequestFailure> {
    let calls: Option<CallsOf> = lens
        .data
        .clone()
        .and_then(|data| serde_json::from_value(data).ok());
    let Some(calls) = calls else { return Ok(lens) };
    let calls = where_now(state, calls, cancel)?;
    let (root, places) = calls_of(state, &calls, cancel)?;
    let calls_in = base::counted(places.len(), "call");
    let arguments = vec![json!(calls), json!(places)];
    lens.command = Some(Command {
        title: format!("{calls_in} in {root}"),
        command: "xacro.showReferences".to_owned(),
        arguments: Some(arguments),
    });
    Ok(lens)
}

/// The same macro at the place where it stands now.
fn where_now(
    state: &mut ServerState,
    calls: CallsOf,
    cancel: &CancelFlag,
) -> Result<CallsOf, RequestFailure> {
    let Some(of) = calls.of else { return Ok(calls) };
    let asked = asked(
        state,
        &start_of(TextDocumentIdentifier {
            uri: calls.uri.clone(),
        }),
        cancel,
    )?;
    let found = macros(&asked).find(|(known, _)| *known == of);
    let (_, name) = found.ok_or(RequestFailure::Outdated)?;
    let position = convert::position(&asked.source.document, name.start, state.encoding);
    Ok(CallsOf {
        uri: calls.uri,
        position,
        of: None,
    })
}

/// The calls of a macro, and the roots they were looked for in.
pub fn calls_of(
    state: &mut ServerState,
    of: &CallsOf,
    cancel: &CancelFlag,
) -> Result<(String, Vec<Location>), RequestFailure> {
    let text_document = TextDocumentIdentifier {
        uri: of.uri.clone(),
    };
    let at = TextDocumentPositionParams {
        text_document,
        position: of.position,
    };
    let asked = asked(state, &at, cancel)?;
    let cx = asked.cx();
    let calls = ide::macro_at(&cx, asked.offset)
        .map(|id| ide::calls_of(&cx, id))
        .unwrap_or_default();
    let places = calls
        .into_iter()
        .filter_map(|span| location(state, span))
        .collect();
    let candidates = analysis::context(&mut state.host, &asked.source.path).candidates;
    // of several roots, only the active one is counted
    let root = match candidates.len() {
        0 | 1 => "1 root".to_owned(),
        _ => convert::file_name(&asked.analyzed.root.file),
    };
    Ok((root, places))
}

/// The macros of a file, and where their names stand.
fn macros(asked: &Asked) -> impl Iterator<Item = (NamedMacro, TextRange)> {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    ide::macros_of(&asked.cx())
        .into_iter()
        .map(move |(_, range)| {
            let name = asked.source.document.slice(range);
            let count = seen.entry(name.clone()).or_default();
            let before = std::mem::replace(count, *count + 1);
            (NamedMacro { name, before }, range)
        })
}

/// A lens with a command.
fn lens(range: lsp_types::Range, title: &str, command: &str, argument: Value) -> CodeLens {
    CodeLens {
        range,
        command: Some(Command {
            title: title.to_owned(),
            command: command.to_owned(),
            arguments: Some(vec![argument]),
        }),
        data: None,
    }
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn of_long_paths_the_end_is_shown() {
        for (value, expected) in [
            ("left_", "left_"),
            ("/opt/robots/calibration.yaml", "…/calibration.yaml"),
            ("config/p.yaml", "config/p.yaml"),
            ("../../robots/arm/config/p.yaml", "…/p.yaml"),
            ("/p.yaml", "/p.yaml"),
        ] {
            assert_eq!(shown(value), expected);
        }
    }
}
