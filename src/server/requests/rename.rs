//! Renaming names in all files that use them.

use super::navigation::asked;
use crate::convert::location;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::{Path, PathBuf};

use lsp_types::{
    AnnotatedTextEdit, ChangeAnnotation, DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier,
    PrepareRenameResponse, RenameParams, TextDocumentEdit, TextDocumentPositionParams, TextEdit, Url,
    WorkspaceEdit,
};

use super::navigation::Asked;
use crate::convert;
use crate::failure::Failure;
use crate::lifecycle::scan_all;
use crate::state::State;
use analysis::{Obstacle, RootChoice};
use base::limits::{QUICK_PROOF_EXPANSIONS, RENAME_ROBOTS};
use base::{CancelFlag, Span, TextRange};
use expand::SymbolKind;
use ide::{self, Cx, TextNames};
use workspace::config::{argument_places, files_named};
use workspace::is_built;

pub fn prepare_rename(
    state: &mut State,
    params: TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Option<PrepareRenameResponse>, Failure> {
    let asked = asked(state, &params, cancel)?;
    let found = ide::renameable(&asked.cx(), &asked.names(state), asked.offset);
    Ok(found.map(|(range, placeholder)| {
        let range = convert::range(&asked.source.document, range, state.encoding);
        PrepareRenameResponse::RangeWithPlaceholder { range, placeholder }
    }))
}

pub fn rename(
    state: &mut State,
    params: RenameParams,
    cancel: &CancelFlag,
) -> Result<Option<WorkspaceEdit>, Failure> {
    scan_all(state, cancel)?;
    let asked = asked(state, &params.text_document_position, cancel)?;
    let new = params.new_name.as_str();
    let names = asked.names(state);
    let mut spans = ide::rename(&asked.cx(), &names, asked.offset, new).map_err(Failure::Refused)?;
    let kind = ide::kind_at(&asked.cx(), &names, asked.offset);
    match kind {
        Some(_) => {
            in_other_robots(state, &asked, &mut spans, cancel)?;
            admit_new_name(state, &asked, kind, new, &spans, cancel)?;
            spans.extend(in_presets(state, &asked));
        }
        None => in_further_robots(state, &asked, new, &mut spans, cancel)?,
    }
    spans.sort_by_key(|span| (span.file, span.range.start));
    spans.dedup();
    let mut edits: BTreeMap<Url, Vec<TextEdit>> = BTreeMap::new();
    for span in spans {
        let path = state.world.session().vfs.path(span.file);
        admit_edit(state, &path)?;
        if let Some(place) = location(state, span) {
            edits.entry(place.uri).or_default().push(TextEdit::new(place.range, new.to_owned()));
        }
    }
    Ok(Some(annotated(state, edits)))
}

/// Whether robots stay what they are when a name of xacro is another one; names of links and joints are meant to change
/// them.
fn admit_new_name(
    state: &mut State,
    asked: &Asked,
    kind: Option<SymbolKind>,
    new: &str,
    spans: &[Span],
    cancel: &CancelFlag,
) -> Result<(), Failure> {
    let Some(first) = spans.first() else { return Ok(()) };
    let vfs = state.world.session().vfs.clone();
    let document = vfs.document(&vfs.path(first.file)).map_err(|_| Failure::Cancelled)?;
    let old = document.document.slice(first.range);
    let mut replaced: BTreeMap<PathBuf, Vec<(TextRange, String)>> = BTreeMap::new();
    for span in spans {
        let path = vfs.path(span.file).to_path_buf();
        replaced.entry(path).or_default().push((span.range, new.to_owned()));
    }
    let mut roots = vec![asked.analyzed.root.clone()];
    for path in replaced.keys() {
        let further = state.world.context(path).candidates.into_iter().map(|(root, _)| root);
        roots.extend(further.filter(|root| !roots.contains(root)).collect::<Vec<_>>());
    }
    roots.truncate(QUICK_PROOF_EXPANSIONS);
    let argument = (kind == Some(SymbolKind::Argument)).then_some((old.as_str(), new));
    let replaced = replaced.into_iter().collect();
    let changed = state.world.session().changed_robot(replaced, &roots, argument, cancel);
    if cancel.is_cancelled() {
        return Err(Failure::Cancelled);
    }
    let Some(Obstacle { robot, condition }) = changed else { return Ok(()) };
    let shown = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let condition = condition.map(|(file, line, taken)| {
        format!(
            ", {} at {}:{line}",
            if taken { "with the condition taken" } else { "without the condition" },
            shown(&file)
        )
    });
    let (robot, condition) = (shown(&robot), condition.unwrap_or_default());
    Err(Failure::Refused(format!("the name `{new}` would change the robot `{robot}`{condition}")))
}

/// Whether a file may be changed with the user's consent, which for files outside of the workspace the client has
/// to ask for.
fn admit_edit(state: &State, path: &Path) -> Result<(), Failure> {
    if is_ours(state, path) {
        return Ok(());
    }
    let shown = path.display();
    if state.world.session().is_installed(path) || path.iter().any(is_built) {
        return Err(Failure::Refused(format!("`{shown}` is in an install folder and is not changed")));
    }
    match state.client.change_annotations {
        true => Ok(()),
        false => Err(Failure::Refused(format!("`{shown}` is not in the workspace and is not changed"))),
    }
}

/// The texts of links, joints and materials in the other robots that read the files to be changed.
fn in_further_robots(
    state: &mut State,
    asked: &Asked,
    new: &str,
    spans: &mut Vec<Span>,
    cancel: &CancelFlag,
) -> Result<(), Failure> {
    let first = spans.clone();
    let files: BTreeSet<_> = first.iter().map(|span| span.file).collect();
    let paths = files.into_iter().map(|file| state.world.session().vfs.path(file));
    let paths: Vec<_> = paths.collect();
    let mut roots = Vec::new();
    for path in paths {
        for (root, _) in state.world.context(&path).candidates {
            if root != asked.analyzed.root && !roots.contains(&root) {
                roots.push(root);
            }
        }
    }
    for root in roots.into_iter().take(RENAME_ROBOTS) {
        let analyzed = state.world.analyzed(&root, cancel).ok_or(Failure::Cancelled)?;
        let (expansion, robot) = (&analyzed.expansion, analyzed.robot.as_ref());
        let session = state.world.session();
        let settings = session.settings(&root.file);
        let names = TextNames::of(expansion, session.surroundings(&settings.config));
        for span in &first {
            let file = expansion.files.iter().find(|file| file.source.id == span.file);
            let Some(source) = file.map(|file| &*file.source) else { continue };
            let cx = Cx { source, expansion, robot, kinematics: analyzed.kinematics.as_ref(), pinned: None };
            if ide::renameable(&cx, &names, span.range.start).is_some_and(|(range, _)| range == span.range) {
                spans.extend(ide::rename(&cx, &names, span.range.start, new).map_err(Failure::Refused)?);
            }
        }
    }
    Ok(())
}

/// Where configuration files, and comments that name a root, give the argument at a place a value, for robots that
/// read it.
fn in_presets(state: &mut State, asked: &Asked) -> Vec<Span> {
    let cx = asked.cx();
    let definition = cx.symbol_at(asked.offset).map(|(id, _)| id);
    let argument = definition.and_then(|id| Some((id, cx.expansion.symbols.get(id)?)));
    let Some((id, argument)) = argument.filter(|(_, it)| it.kind == SymbolKind::Argument) else {
        return Vec::new();
    };
    let Some(target) = ide::definition_of(&cx, id) else { return Vec::new() };
    let path = state.world.session().vfs.path(target.name.file);
    let roots: Vec<PathBuf> =
        state.world.context(&path).candidates.into_iter().map(|(r, _)| r.file).collect();
    let session = state.world.session();
    let configs: BTreeSet<PathBuf> =
        roots.iter().flat_map(|root| session.settings(root).config.files.clone()).collect();
    let mut found = Vec::new();
    for config in configs {
        let (Ok(text), Some(folder)) = (session.vfs.text(&config), config.parent()) else { continue };
        let (id, folder) = (session.vfs.file_id(&config), folder.to_path_buf());
        let reads = |file: &str| {
            let files = files_named(file, &folder, &session.vfs);
            files.iter().any(|file| roots.contains(&session.vfs.absolute(file)))
        };
        let places = argument_places(&text.text, &argument.name, reads);
        found.extend(places.into_iter().map(|range| Span { file: id, range }));
    }
    let known = state.world.known_files().into_iter();
    let comments = known.filter_map(|file| state.world.commented_argument(&file, &argument.name));
    found.extend(comments.filter(|(root, _)| roots.contains(root)).map(|(_, span)| span));
    found
}

/// The same name in the other robots that read the files to be changed.
fn in_other_robots(
    state: &mut State,
    asked: &Asked,
    spans: &mut Vec<Span>,
    cancel: &CancelFlag,
) -> Result<(), Failure> {
    let vfs = state.world.session().vfs.clone();
    let Some(first) = spans.first().copied() else { return Ok(()) };
    let document = vfs.document(&vfs.path(first.file)).map_err(|_| Failure::Cancelled)?;
    let name = document.document.slice(first.range);
    // what one robot adds may concern those that were looked at before
    loop {
        let before = spans.len();
        let mut seen = vec![asked.analyzed.root.clone()];
        while let Some(root) = unseen_root(state, spans, &seen).filter(|_| seen.len() < RENAME_ROBOTS) {
            let analyzed = state.world.analyzed(&root, cancel).ok_or(Failure::Cancelled)?;
            let session = state.world.session();
            let settings = session.settings(&root.file);
            let names = TextNames::of(&analyzed.expansion, session.surroundings(&settings.config));
            let cx = Cx { expansion: &analyzed.expansion, ..asked.cx() };
            *spans = ide::places(&cx, &names, spans, &name);
            seen.push(root);
        }
        if spans.len() == before {
            return Ok(());
        }
    }
}

/// A robot that reads one of the files and was not looked at.
fn unseen_root(state: &mut State, spans: &[Span], seen: &[RootChoice]) -> Option<RootChoice> {
    let files: BTreeSet<_> = spans.iter().map(|span| span.file).collect();
    files.into_iter().find_map(|file| {
        let path = state.world.session().vfs.path(file);
        let mut roots = state.world.context(&path).candidates.into_iter().map(|(root, _)| root);
        roots.find(|root| !seen.contains(root))
    })
}

/// Files that may be changed: open ones, and those of the workspace that no tool has built.
pub fn is_ours(state: &State, path: &Path) -> bool {
    let inside = state.world.folders().iter().filter_map(|folder| path.strip_prefix(folder).ok());
    state.documents.contains_key(path) || inside.into_iter().any(|path| !path.iter().any(is_built))
}

/// Edits that say of files which the user does not see that they are changed too, where the client shows that.
fn annotated(state: &State, edits: BTreeMap<Url, Vec<TextEdit>>) -> WorkspaceEdit {
    let mut edit = workspace_edit(state, edits);
    let Some(DocumentChanges::Edits(documents)) = &mut edit.document_changes else { return edit };
    if !state.client.change_annotations {
        return edit;
    }
    let mut annotations = HashMap::new();
    for document in documents {
        let path = state.path(&document.text_document.uri);
        if state.documents.contains_key(&path) {
            continue;
        }
        let outside = !is_ours(state, &path);
        let (id, label) = match outside {
            true => ("outside", "in files outside the workspace"),
            false => ("closed", "in files that are not open"),
        };
        let (annotation_id, label) = (id.to_owned(), label.to_owned());
        let annotation = ChangeAnnotation { label, needs_confirmation: Some(outside), description: None };
        annotations.insert(annotation_id.clone(), annotation);
        for edit in &mut document.edits {
            if let OneOf::Left(text_edit) = edit.clone() {
                let annotation_id = annotation_id.clone();
                *edit = OneOf::Right(AnnotatedTextEdit { text_edit, annotation_id });
            }
        }
    }
    edit.change_annotations = (!annotations.is_empty()).then_some(annotations);
    edit
}

/// Edits with the versions they were made for, where the client takes that.
pub fn workspace_edit(state: &State, edits: BTreeMap<Url, Vec<TextEdit>>) -> WorkspaceEdit {
    if !state.client.document_changes {
        let changes: HashMap<Url, Vec<TextEdit>> = edits.into_iter().collect();
        return WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() };
    }
    let edit = |(uri, edits): (Url, Vec<TextEdit>)| {
        let version = state.documents.get(&state.path(&uri)).and_then(|open| open.version);
        let text_document = OptionalVersionedTextDocumentIdentifier { uri, version };
        TextDocumentEdit { text_document, edits: edits.into_iter().map(OneOf::Left).collect() }
    };
    let changes = DocumentChanges::Edits(edits.into_iter().map(edit).collect());
    WorkspaceEdit { document_changes: Some(changes), ..WorkspaceEdit::default() }
}
