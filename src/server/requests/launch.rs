//! Requests about launch files, where a client opens one: names of arguments of robots are answered for and nothing else.
use std::path::PathBuf;
use std::sync::Arc;

use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionResponse, CompletionTextEdit,
    TextDocumentPositionParams, TextEdit,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::asked::Asked;
use crate::root_param::active_root;
use crate::state::ServerState;
use analysis::is_launch;
use base::{CancelFlag, Span, TextRange};
use expand::SymbolKind;
use ide::{Cx, NavigationTarget, definition_of};
use vfs::SourceFile;

/// The name of an argument in a launch file.
pub struct LaunchArgumentName {
    /// The launch file.
    pub source: Arc<SourceFile>,
    /// Where the name stands in it.
    pub range: TextRange,
    /// The declaration in the robot.
    pub target: NavigationTarget,
    /// The same as a place in the robot.
    pub asked: Asked,
}

/// Whether a request is about a launch file.
pub fn is_about_launch(state: &ServerState, at: &TextDocumentPositionParams) -> bool {
    is_launch(&state.path(&at.text_document.uri))
}

/// The argument whose name stands at a place in a launch file, where a robot declares it.
pub fn launched(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Option<LaunchArgumentName>, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let Some(name) = analysis::launch_name_at(state.host.session(), &path, offset) else {
        return Ok(None);
    };
    for robot in &name.robots {
        let root = active_root(state, robot);
        let analyzed = state
            .host
            .analyzed(&root, cancel)
            .ok_or(RequestFailure::Cancelled)?;
        let Some(first) = analyzed
            .expansion
            .files
            .first()
            .map(|file| file.source.clone())
        else {
            continue;
        };
        let mut asked = Asked {
            source: first,
            around: analyzed.clone(),
            analyzed,
            offset: 0,
            beside: Vec::new(),
            selected_frame: None,
        };
        let Some(target) = declaration(&asked.cx(), &name.name) else {
            continue;
        };
        let path = state
            .host
            .session()
            .vfs
            .path(target.name.file)
            .to_path_buf();
        let Some(declaring) = state.host.document(&path) else {
            continue;
        };
        (asked.source, asked.offset) = (declaring, target.name.range.start);
        return Ok(Some(LaunchArgumentName {
            source,
            range: name.span.range,
            target,
            asked,
        }));
    }
    Ok(None)
}

/// Where a robot declares an argument.
fn declaration(cx: &Cx<'_>, name: &str) -> Option<NavigationTarget> {
    let mut symbols = cx.expansion.index.symbols.iter();
    let (id, _) =
        symbols.find(|(_, given)| given.kind == SymbolKind::Argument && given.name == name)?;
    definition_of(cx, id)
}

/// Where launch files spell the argument at a place, with the robots that share its declaration.
pub fn in_launch_files(state: &mut ServerState, asked: &Asked) -> (Vec<Span>, Vec<PathBuf>) {
    let cx = asked.cx();
    let definition = cx
        .symbol_at(asked.offset)
        .and_then(|(id, _)| Some((id, cx.expansion.index.symbols.get(id)?)));
    let Some((id, argument)) = definition.filter(|(_, it)| it.kind == SymbolKind::Argument) else {
        return Default::default();
    };
    let Some(target) = definition_of(&cx, id) else {
        return Default::default();
    };
    let path = state.host.session().vfs.path(target.name.file);
    let candidates = analysis::context(&mut state.host, &path)
        .candidates
        .into_iter();
    let mut robots: Vec<PathBuf> = candidates.map(|(root, _)| root.file).collect();
    robots.dedup();
    (
        analysis::launch_places(state.host.session(), &robots, &argument.name),
        robots,
    )
}

/// The arguments that may be given at a place in a launch file.
pub fn completion(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
) -> Result<Option<CompletionResponse>, RequestFailure> {
    let (path, source) = state.source(&at.text_document.uri)?;
    let offset = convert::offset(&source.document, at.position, state.encoding);
    let Some(found) = analysis::launch_choices_at(state.host.session(), &path, offset) else {
        return Ok(None);
    };
    let range = convert::range(&source.document, found.range, state.encoding);
    let sign = if found.with_sign { ":=" } else { "" };
    let item = |(name, default): (String, Option<String>)| CompletionItem {
        kind: Some(CompletionItemKind::VARIABLE),
        detail: default.map(|default| format!("default: `{default}`")),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(
            range,
            format!("{name}{sign}"),
        ))),
        label: name,
        ..CompletionItem::default()
    };
    let items = found.arguments.into_iter().map(item).collect();
    Ok(Some(CompletionResponse::List(CompletionList {
        is_incomplete: false,
        items,
    })))
}
