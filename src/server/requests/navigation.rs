//! Going to definitions, finding references.
use lsp_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, GotoDefinitionParams,
    GotoDefinitionResponse, Location, LocationLink, Range, TextDocumentPositionParams, Url,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::locations::location;
use crate::requests::asked::Asked;
use crate::requests::beside::{asked_beside, names_beside};
use crate::requests::branches::inside;
use crate::requests::launch::{is_about_launch, launched};
use crate::requests::of_description::is_not_described;
use crate::root_param::active_root;
use crate::state::ServerState;
use analysis::RootConfig;
use base::{CancelFlag, Span, TextRange};
use ide::{Cx, FileLocation, NavigationTarget};
use xml::Document;

/// A position of a request, under the active root of its file; a file that no root reaches is expanded by
/// itself.
pub fn asked(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Asked, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let root = active_root(state, &path);
    let mut analyzed = state
        .host
        .analyzed(&root, cancel)
        .ok_or(RequestFailure::Cancelled)?;
    let around = analyzed.clone();
    if !analyzed.includes(&path) {
        // the root reaches the file on paper only: a condition keeps it out
        analyzed = state
            .host
            .analyzed(&RootConfig::plain(&path), cancel)
            .ok_or(RequestFailure::Cancelled)?;
    }
    let selected = state.selected_instances.get(&analyzed.root.file);
    let selected_frame =
        selected.and_then(|selected| ide::selected_frame(&analyzed.expansion, selected));
    Ok(Asked {
        source,
        analyzed,
        around,
        offset,
        beside: Vec::new(),
        selected_frame,
    })
}

/// The same with the names in files beside the robot, for who asks what a name is; also in such a file. None in files that
/// describe no robot, at what is no name of one.
pub fn asked_for_name(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Option<Asked>, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let found = asked_beside(state, (&path, &source), offset, cancel)?;
    if found.is_some() || is_not_described(&path) {
        return Ok(found);
    }
    let asked = asked(state, at, cancel)?;
    let beside = names_beside(state, &asked.analyzed.root, cancel)?;
    Ok(Some(Asked { beside, ..asked }))
}

pub fn definition(
    state: &mut ServerState,
    params: GotoDefinitionParams,
    cancel: &CancelFlag,
) -> Result<Option<GotoDefinitionResponse>, RequestFailure> {
    let at = &params.text_document_position_params;
    if is_about_launch(state, at) {
        let found = launched(state, at, cancel)?;
        return Ok(found.and_then(|found| {
            let origin = convert::range(&found.source.document, found.range, state.encoding);
            places_of(
                state,
                origin,
                &[found.target],
                state.client.links.definition,
            )
        }));
    }
    let Some(asked) = asked_for_name(state, at, cancel)? else {
        return Ok(None);
    };
    let asked = asked.on_name();
    // a name of xacro comes first, then a file, then the link or joint that the whole text names
    let symbol = match asked.cx().symbol_at(asked.offset) {
        Some(_) => ide::definitions(&asked.cx(), asked.offset).map(|(range, mut targets)| {
            let names = asked.names(state);
            targets.extend(ide::definitions_elsewhere(
                &asked.cx(),
                &names,
                asked.offset,
            ));
            (range, targets)
        }),
        None => ide::definitions_by_text(&asked.cx(), &asked.names(state), asked.offset),
    };
    let file = if symbol.is_some() {
        None
    } else {
        about_files(state, &asked, ide::file_definition)
    };
    if let Some((origin, place)) = file {
        return Ok(file_target(
            state,
            &asked,
            origin,
            &place,
            state.client.links.definition,
        ));
    }
    let found = symbol.or_else(|| ide::definitions(&asked.cx(), asked.offset));
    let found = match found {
        Some(found) => Some(found),
        None => inside(state, &asked, cancel)?
            .and_then(|asked| ide::definitions(&asked.cx(), asked.offset)),
    };
    let Some((origin, targets)) = found else {
        return Ok(None);
    };
    let origin = convert::range(&asked.source.document, origin, state.encoding);
    Ok(places_of(
        state,
        origin,
        &targets,
        state.client.links.definition,
    ))
}

pub fn declaration(
    state: &mut ServerState,
    params: GotoDefinitionParams,
    cancel: &CancelFlag,
) -> Result<Option<GotoDefinitionResponse>, RequestFailure> {
    let asked = asked(state, &params.text_document_position_params, cancel)?;
    let found = ide::declaration(&asked.cx(), asked.offset);
    let Some((origin, target)) = found else {
        return Ok(None);
    };
    let origin = convert::range(&asked.source.document, origin, state.encoding);
    Ok(places_of(
        state,
        origin,
        &[target],
        state.client.links.declaration,
    ))
}

pub fn type_definition(
    state: &mut ServerState,
    params: GotoDefinitionParams,
    cancel: &CancelFlag,
) -> Result<Option<GotoDefinitionResponse>, RequestFailure> {
    let asked = asked(state, &params.text_document_position_params, cancel)?;
    let found = about_files(state, &asked, ide::type_definition);
    let links = state.client.links.type_definition;
    Ok(found.and_then(|(origin, place)| file_target(state, &asked, origin, &place, links)))
}

/// What a macro makes, in the expanded text; none for a client that could not open it.
pub fn implementation(
    state: &mut ServerState,
    params: GotoDefinitionParams,
    cancel: &CancelFlag,
) -> Result<Option<GotoDefinitionResponse>, RequestFailure> {
    if !state.client.own.expanded_documents {
        return Ok(None);
    }
    let asked = asked(state, &params.text_document_position_params, cancel)?;
    let written = asked.analyzed.written();
    let Some((origin, found)) = ide::implementations(&asked.cx(), written, asked.offset) else {
        return Ok(None);
    };
    let Some(uri) = expanded_uri(state, &asked.analyzed.root) else {
        return Ok(None);
    };
    let origin = convert::range(&asked.source.document, origin, state.encoding);
    let lines = ide::TextLines::of(&written.text, state.encoding);
    let links = found.into_iter().map(|range| {
        let range = crate::requests::mapping::expanded_range(&lines, range);
        LocationLink {
            origin_selection_range: Some(origin),
            target_uri: uri.clone(),
            target_range: range,
            target_selection_range: range,
        }
    });
    Ok(links_or_places(
        links.collect(),
        state.client.links.implementation,
    ))
}

/// The name of the expanded text of a root.
fn expanded_uri(state: &ServerState, root: &RootConfig) -> Option<Url> {
    let stem = root.file.file_name()?.to_string_lossy().into_owned();
    let stem = stem.split('.').next().unwrap_or("").to_owned();
    let mut uri = Url::parse(&format!("xacro-expanded:/{stem}.urdf")).ok()?;
    uri.query_pairs_mut()
        .append_pair("root", state.uri(&root.file)?.as_str());
    Some(uri)
}

/// What an answer about files says of a place.
pub fn about_files<T>(
    state: &ServerState,
    asked: &Asked,
    answer: impl Fn(&Cx<'_>, rules::RuleEnv<'_>, u32) -> Option<T>,
) -> Option<T> {
    let session = state.host.session();
    let settings = session.settings(&asked.source.path);
    answer(
        &asked.cx(),
        session.rule_env(&settings.config),
        asked.offset,
    )
}

fn file_target(
    state: &ServerState,
    asked: &Asked,
    origin: TextRange,
    place: &FileLocation,
    links: bool,
) -> Option<GotoDefinitionResponse> {
    let origin = convert::range(&asked.source.document, origin, state.encoding);
    let file = state.host.session().vfs.file_id(&place.path);
    let range = if place.range == TextRange::default() || !ide::is_text(&place.path) {
        Range::default()
    } else {
        location(
            state,
            Span {
                file,
                range: place.range,
            },
        )?
        .range
    };
    let link = LocationLink {
        origin_selection_range: Some(origin),
        target_uri: state.uri(&place.path)?,
        target_range: range,
        target_selection_range: range,
    };
    links_or_places(vec![link], links)
}

fn places_of(
    state: &ServerState,
    origin: Range,
    targets: &[NavigationTarget],
    links: bool,
) -> Option<GotoDefinitionResponse> {
    let found = targets
        .iter()
        .filter_map(|target| link(state, origin, target));
    links_or_places(found.collect(), links)
}

fn link(state: &ServerState, origin: Range, target: &NavigationTarget) -> Option<LocationLink> {
    let name = location(state, target.name)?;
    Some(LocationLink {
        origin_selection_range: Some(origin),
        target_uri: name.uri,
        target_range: location(state, target.whole)?.range,
        target_selection_range: name.range,
    })
}

pub fn highlights(
    state: &mut ServerState,
    params: DocumentHighlightParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<DocumentHighlight>>, RequestFailure> {
    let at = &params.text_document_position_params;
    let Some(asked) = asked_for_name(state, at, cancel)? else {
        return Ok(None);
    };
    let document = &asked.source.document;
    if let Some(tags) = ide::matching_tags(document, asked.offset) {
        // conditions come in numbers; their ends are found by folding
        let name = tags
            .first()
            .map(|tag| document.slice(*tag))
            .unwrap_or_default();
        if matches!(name.as_str(), "xacro:if" | "xacro:unless") {
            return Ok(Some(Vec::new()));
        }
        let tags = tags
            .into_iter()
            .map(|tag| highlight(state, document, tag, DocumentHighlightKind::TEXT));
        return Ok(Some(tags.collect()));
    }
    let uses = ide::occurrences(&asked.cx(), &asked.names(state), asked.offset).into_iter();
    let own = uses
        .filter(|used| used.span.file == asked.source.id)
        .map(|used| {
            let kind = if used.is_definition {
                DocumentHighlightKind::WRITE
            } else {
                DocumentHighlightKind::READ
            };
            highlight(state, document, used.span.range, kind)
        });
    Ok(Some(own.collect()))
}

fn highlight(
    state: &ServerState,
    document: &Document,
    range: TextRange,
    kind: DocumentHighlightKind,
) -> DocumentHighlight {
    DocumentHighlight {
        range: convert::range(document, range, state.encoding),
        kind: Some(kind),
    }
}

/// Targets as links, or as plain places for a request whose answers the client takes as such only.
fn links_or_places(found: Vec<LocationLink>, links: bool) -> Option<GotoDefinitionResponse> {
    if found.is_empty() {
        return None;
    }
    if links {
        return Some(GotoDefinitionResponse::Link(found));
    }
    let plain = found
        .into_iter()
        .map(|link| Location::new(link.target_uri, link.target_selection_range));
    Some(GotoDefinitionResponse::Array(plain.collect()))
}
