//! `xacro/expand`: the expanded document of a root.
use std::collections::BTreeMap;

use lsp_types::{Location, TextDocumentIdentifier, Url};
use serde::{Deserialize, Serialize};

use crate::failure::RequestFailure;
use crate::locations::location;
use crate::requests::mapping::{map_of, named};
use crate::root_param::{RootParam, chosen_or_active};
use crate::state::ServerState;
use analysis::AnalysisHost;
use base::clock::Instant;
use base::{CancelFlag, Span};
use expand::{Expansion, FileRange, Severity};
use ide::SourceMap;

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct ExpandParams {
    pub text_document: TextDocumentIdentifier,
    pub root: Option<RootParam>,
    #[serde(default)]
    pub args: BTreeMap<String, String>,
    #[serde(default)]
    pub source_map: bool,
    /// Expand what is on the disk instead of what is open, with these texts in place of some files: an earlier
    /// version to compare with.
    pub texts: Option<BTreeMap<Url, String>>,
}

/// The expanded document, and what kept it from being complete.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ExpandedDocument {
    pub ok: bool,
    pub urdf: String,
    pub root: RootParam,
    /// All arguments with the values they had.
    pub args: BTreeMap<String, String>,
    pub errors: Vec<ExpandError>,
    #[serde(rename = "sourceMap", skip_serializing_if = "Option::is_none")]
    pub source_map: Option<SourceMap>,
    /// How long it took, in milliseconds.
    pub ms: f64,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct ExpandError {
    pub message: String,
    pub code: String,
    pub location: Location,
    pub stack: Vec<StackEntry>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct StackEntry {
    pub name: String,
    pub location: Location,
}

pub fn expand(
    state: &mut ServerState,
    params: ExpandParams,
    cancel: &CancelFlag,
) -> Result<ExpandedDocument, RequestFailure> {
    let begin = Instant::now();
    let mut root = chosen_or_active(state, &params.text_document, params.root)?;
    for (name, value) in params.args {
        root.args.retain(|(known, _)| *known != name);
        root.args.push((name, value));
    }
    let other = params.texts.is_some();
    let analyzed = match params.texts {
        Some(texts) => earlier(state, texts).analyzed(&root, cancel),
        None => state.host.analyzed(&root, cancel),
    };
    let analyzed = analyzed.ok_or(RequestFailure::Cancelled)?;
    let expansion = &analyzed.expansion;
    Ok(ExpandedDocument {
        ok: !expansion.has_errors() && expansion.root_error.is_none(),
        urdf: analyzed.written().text.clone(),
        root: named(state, &root)?,
        args: expansion
            .arguments
            .iter()
            .map(|(n, v)| (n.to_string(), v.to_string()))
            .collect(),
        // places in texts that nobody sees lead nowhere
        errors: if other {
            Vec::new()
        } else {
            errors(state, expansion)
        },
        source_map: (params.source_map && !other).then(|| map_of(state, &analyzed)),
        ms: begin.elapsed().as_secs_f64() * 1e3,
    })
}

/// The files on the disk, with other texts for some.
fn earlier(state: &ServerState, texts: BTreeMap<Url, String>) -> AnalysisHost {
    let mut host = state.host.on_disk();
    for (uri, text) in texts {
        host.set_text(&state.path(&uri), text);
    }
    host
}

pub fn errors(state: &ServerState, expansion: &Expansion) -> Vec<ExpandError> {
    let place = |place: FileRange| {
        let file = expansion.files.get(place.file)?.source.id;
        location(
            state,
            Span {
                file,
                range: place.range,
            },
        )
    };
    let problems = expansion
        .problems
        .iter()
        .filter(|p| p.severity == Severity::Error && !p.probed);
    let error = problems.filter_map(|problem| {
        let stack = problem.trace.iter().filter_map(|step| {
            Some(StackEntry {
                name: step.message.clone(),
                location: place(step.place)?,
            })
        });
        let code = rules::rule_of(problem.kind).name;
        Some(ExpandError {
            message: problem.message.clone(),
            code: code.to_owned(),
            location: place(problem.place)?,
            stack: stack.collect(),
        })
    });
    error.collect()
}
