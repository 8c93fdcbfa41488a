//! `xacro/toSource` and `xacro/toExpanded`: jumping between the expanded text and its sources.
use std::sync::Arc;

use lsp_types::{
    Location, Position, Range, TextDocumentIdentifier, TextDocumentPositionParams, Url,
};
use serde::{Deserialize, Serialize};

use crate::failure::RequestFailure;
use crate::locations::location;
use crate::root_param::{RootParam, chosen_or_active};
use crate::state::ServerState;
use analysis::{RootAnalysis, RootConfig};
use base::{CancelFlag, TextRange};
use expand::{FrameId, FrameKind, MapKind, Origin};
use ide::{self, SourceMap, TextLines};

#[derive(Clone, Debug, Deserialize)]
pub(crate) struct ToSourceParams {
    /// The root file, or the file that is shown under it.
    pub root: Url,
    /// In the expanded text.
    pub position: Position,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct SourceLocations {
    /// The origin first, then outwards.
    pub locations: Vec<SourceLocation>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct SourceLocation {
    #[serde(flatten)]
    pub location: Location,
    pub role: &'static str,
}

#[derive(Clone, Debug, Deserialize)]
pub(crate) struct ToExpandedParams {
    #[serde(flatten)]
    pub at: TextDocumentPositionParams,
    pub root: Option<RootParam>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct Instances {
    pub root: RootParam,
    pub instances: Vec<InstanceRange>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct InstanceRange {
    /// In the expanded text.
    pub range: Range,
    pub label: String,
}

pub fn sources_of(
    state: &mut ServerState,
    params: ToSourceParams,
    cancel: &CancelFlag,
) -> Result<SourceLocations, RequestFailure> {
    let document = TextDocumentIdentifier { uri: params.root };
    let (_, analyzed) = shown_under(state, &document, None, cancel)?;
    let written = analyzed.written();
    let lines = TextLines::of(&written.text, state.encoding);
    let offset = lines.offset(params.position.line, params.position.character);
    let mut locations = Vec::new();
    let expansion = &analyzed.expansion;
    if let Some(entry) = ide::entry_at(written, offset) {
        let origin = ide::origin_of(expansion, entry);
        locations.extend(mapped(state, &analyzed, origin, "origin"));
        if entry.kind > MapKind::Attribute && origin != entry.origin {
            // the value was given by a call: the place in the macro comes second
            locations.extend(mapped(state, &analyzed, entry.origin, "argument"));
        }
        for (kind, call) in ide::steps(expansion, entry.origin) {
            let role = if kind == FrameKind::Include {
                "include"
            } else {
                "call"
            };
            locations.extend(mapped(state, &analyzed, call, role));
        }
    }
    Ok(SourceLocations { locations })
}

fn mapped(
    state: &ServerState,
    analyzed: &RootAnalysis,
    origin: Origin,
    role: &'static str,
) -> Option<SourceLocation> {
    let place = analyzed.expansion.place(origin)?;
    let file = analyzed.expansion.files.get(place.file)?.source.id;
    let location = location(
        state,
        base::Span {
            file,
            range: place.range,
        },
    )?;
    Some(SourceLocation { location, role })
}

pub fn instances_of(
    state: &mut ServerState,
    params: ToExpandedParams,
    cancel: &CancelFlag,
) -> Result<Instances, RequestFailure> {
    let (root, analyzed) = shown_under(state, &params.at.text_document, params.root, cancel)?;
    let (path, source) = state.source(&params.at.text_document.uri)?;
    let offset = crate::convert::offset(&source.document, params.at.position, state.encoding);
    let written = analyzed.written();
    let lines = TextLines::of(&written.text, state.encoding);
    let file = analyzed
        .expansion
        .files
        .position(|file| *file.source.path == *path);
    let found = file
        .map(|file| ide::instances(&analyzed.expansion, written, file, offset))
        .unwrap_or_default();
    let instance = |(out, frame): (TextRange, FrameId)| InstanceRange {
        range: expanded_range(&lines, out),
        label: label(state, &analyzed, frame),
    };
    Ok(Instances {
        root: named(state, &root)?,
        instances: found.into_iter().map(instance).collect(),
    })
}

/// A call in a few words: `unit @ robot.urdf.xacro:7`.
pub fn label(state: &ServerState, analyzed: &RootAnalysis, frame: FrameId) -> String {
    let Some(frame) = analyzed.expansion.frames.get(frame) else {
        return String::new();
    };
    let Some(place) = analyzed.expansion.place(frame.call) else {
        return frame.name.to_string();
    };
    let Some(file) = analyzed.expansion.files.get(place.file) else {
        return frame.name.to_string();
    };
    let line = file
        .source
        .document
        .line_col(place.range.start, state.encoding)
        .line
        + 1;
    let name = file
        .source
        .path
        .file_name()
        .unwrap_or_default()
        .to_string_lossy();
    format!("{} @ {name}:{line}", frame.name)
}

/// A root as the protocol names it.
pub fn named(state: &ServerState, root: &RootConfig) -> Result<RootParam, RequestFailure> {
    let uri = state
        .uri(&root.file)
        .ok_or_else(|| RequestFailure::Invalid("the root has no name".to_owned()))?;
    Ok(RootParam {
        uri,
        args: root.args.iter().cloned().collect(),
        preset: root.preset.clone(),
    })
}

/// The root that a request names or that the file is shown under, expanded.
pub fn shown_under(
    state: &mut ServerState,
    document: &TextDocumentIdentifier,
    root: Option<RootParam>,
    cancel: &CancelFlag,
) -> Result<(RootConfig, Arc<RootAnalysis>), RequestFailure> {
    let root = chosen_or_active(state, document, root)?;
    let analyzed = state
        .host
        .analyzed(&root, cancel)
        .ok_or(RequestFailure::Cancelled)?;
    Ok((root, analyzed))
}

/// The source map of an expansion, its files named by URI.
pub fn map_of(state: &ServerState, analyzed: &RootAnalysis) -> SourceMap {
    let name = |file: &expand::FileUse| {
        state
            .uri(&file.source.path)
            .map_or_else(|| file.name.clone(), |uri| uri.to_string())
    };
    ide::source_map(
        &analyzed.expansion,
        analyzed.written(),
        state.encoding,
        name,
    )
}

pub(crate) fn expanded_range(lines: &TextLines<'_>, range: TextRange) -> Range {
    Range::new(
        expanded_position(lines, range.start),
        expanded_position(lines, range.end),
    )
}

fn expanded_position(lines: &TextLines<'_>, offset: u32) -> Position {
    let [line, column] = lines.position(offset);
    Position::new(line, column)
}
