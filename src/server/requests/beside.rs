//! Positions in files beside robots, and the names that these files hold.
use std::path::Path;
use std::sync::Arc;

use lsp_types::TextDocumentPositionParams;

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::asked::Asked;
use crate::requests::of_description::is_not_described;
use crate::state::ServerState;
use analysis::{Beside, RootAnalysis, RootConfig};
use base::CancelFlag;
use ide::{self, BesideName, BesideSources, Completions, Cx};
use project::word_at;
use vfs::SourceFile;

/// The names of the robot in the files beside it.
pub fn names_beside(
    state: &mut ServerState,
    root: &RootConfig,
    cancel: &CancelFlag,
) -> Result<Vec<BesideName>, RequestFailure> {
    let files = analysis::read_files_beside(&mut state.host, &root.file, cancel)
        .ok_or(RequestFailure::Cancelled)?;
    Ok(files
        .iter()
        .flat_map(|file| names_in(state, file))
        .collect())
}

/// The names in a file beside the robot.
fn names_in(state: &ServerState, beside: &Beside) -> Vec<BesideName> {
    if let Some((analyzed, srdf)) = beside.srdf() {
        return own_cx(analyzed)
            .map(|cx| ide::names_in_srdf(&cx, srdf))
            .unwrap_or_default();
    }
    let text = state.host.session().vfs.text(&beside.path);
    let names = |settings| {
        Some(ide::names_in_settings(
            beside.file,
            &text.ok()?.text,
            settings,
        ))
    };
    beside.settings().and_then(names).unwrap_or_default()
}

/// A file in its own expansion.
fn own_cx(analyzed: &RootAnalysis) -> Option<Cx<'_>> {
    let source = &analyzed.expansion.files.first()?.source;
    let (expansion, robot) = (&analyzed.expansion, analyzed.robot.as_ref());
    Some(Cx {
        source,
        expansion,
        robot,
        kinematics: analyzed.kinematics(),
        beside: &[],
        selected_frame: None,
    })
}

/// A position in a file beside a robot, under that robot; none where it is at a name of xacro, or at none at all.
pub fn asked_beside(
    state: &mut ServerState,
    (path, source): (&Path, &Arc<SourceFile>),
    offset: u32,
    cancel: &CancelFlag,
) -> Result<Option<Asked>, RequestFailure> {
    let roots = analysis::robots_beside(state.host.session(), path);
    if roots.is_empty() || is_at_xacro_name(path, source, offset) {
        return Ok(None);
    }
    // most places of YAML are at no name: no robot is expanded for them
    let own = analysis::read_file_beside(&mut state.host, path, cancel)
        .ok_or(RequestFailure::Cancelled)?;
    let names = own.map(|own| names_in(state, &own)).unwrap_or_default();
    if !names.iter().any(|name| name.place.range.touches(offset)) {
        return Ok(None);
    }
    for root in roots {
        let beside = names_beside(state, &root, cancel)?;
        let range =
            |name: &BesideName| name.place.file == source.id && name.place.range.touches(offset);
        if !beside.iter().any(range) {
            continue;
        }
        let analyzed = state
            .host
            .analyzed(&root, cancel)
            .ok_or(RequestFailure::Cancelled)?;
        let around = analyzed.clone();
        return Ok(Some(Asked {
            source: source.clone(),
            analyzed,
            around,
            offset,
            beside,
            selected_frame: None,
        }));
    }
    Ok(None)
}

/// Whether an expression names something at an offset: `$(arg name)` in the name of a link is an argument of the file itself.
fn is_at_xacro_name(path: &Path, source: &SourceFile, offset: u32) -> bool {
    let place = source.document.item_at(offset.saturating_sub(1));
    !is_not_described(path)
        && facts::facts_of(place.item)
            .mentions()
            .any(|mention| mention.range.shift(place.start).touches(offset))
}

/// What can be typed at a place of a YAML file beside robots.
pub fn completions(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Option<(Arc<SourceFile>, Completions)>, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let Ok(text) = state.host.session().vfs.text(&path) else {
        return Ok(None);
    };
    let name = convert::file_name(&path);
    if word_at(&name, &text.text, offset).is_none() {
        return Ok(None);
    }
    let robots = robots_named(state, &path, cancel);
    let mut beside: Vec<Beside> = Vec::new();
    for robot in &robots {
        let files = analysis::read_files_beside(&mut state.host, &robot.root.file, cancel)
            .ok_or(RequestFailure::Cancelled)?;
        beside.extend(files.into_iter().filter(|file| file.path != path));
    }
    let sources = BesideSources {
        robots: robots
            .iter()
            .filter_map(|known| Some((&known.expansion, known.robot.as_ref()?)))
            .collect(),
        srdfs: beside
            .iter()
            .filter_map(|file| Some(file.srdf()?.1))
            .collect(),
        settings: beside.iter().filter_map(Beside::settings).collect(),
    };
    let found = ide::completions_in_settings((&name, &text.text), offset, &sources);
    Ok(found.map(|found| (source, found)))
}

/// The robots that an SRDF is for, or may be for; none for other files.
pub fn robots_described(
    state: &mut ServerState,
    path: &Path,
    source: &SourceFile,
    cancel: &CancelFlag,
) -> Vec<Arc<RootAnalysis>> {
    if rules::is_semantic_file(path, &source.document) {
        robots_named(state, path, cancel)
    } else {
        Vec::new()
    }
}

/// The last expansions of the robots whose names may be used in a file beside robots.
fn robots_named(
    state: &mut ServerState,
    path: &Path,
    cancel: &CancelFlag,
) -> Vec<Arc<RootAnalysis>> {
    let roots = analysis::robots_to_name(state.host.session(), path);
    roots
        .iter()
        .flat_map(|root| {
            state
                .host
                .while_typing(root, path, cancel)
                .into_iter()
                .next()
        })
        .collect()
}
