//! Renaming names in all files that use them.
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::{Path, PathBuf};

use lsp_types::{
    AnnotatedTextEdit, ChangeAnnotation, DocumentChanges, OneOf,
    OptionalVersionedTextDocumentIdentifier, PrepareRenameResponse, RenameParams, TextDocumentEdit,
    TextDocumentPositionParams, TextEdit, Url, WorkspaceEdit,
};

use crate::convert::{self, file_name};
use crate::failure::RequestFailure;
use crate::locations::location;
use crate::requests::asked::Asked;
use crate::requests::branches::{in_all_robots, inside};
use crate::requests::launch::{in_launch_files, launched};
use crate::requests::navigation::asked_for_name;
use crate::scanning::scan_all;
use crate::state::ServerState;
use analysis::{NewName, Obstacle, RootConfig};
use base::limits::{QUICK_PROOF_EXPANSIONS, RENAME_ROBOTS};
use base::{CancelFlag, Span, TextRange};
use expand::SymbolKind;
use ide::{self, Cx, TextNames};
use packages::is_built;
use workspace::config::{argument_places, files_named};

pub fn prepare_rename(
    state: &mut ServerState,
    params: TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Option<PrepareRenameResponse>, RequestFailure> {
    if let Some(found) = launched(state, &params, cancel)? {
        let range = convert::range(&found.source.document, found.range, state.encoding);
        let placeholder = found.source.document.slice(found.range);
        return Ok(Some(PrepareRenameResponse::RangeWithPlaceholder {
            range,
            placeholder,
        }));
    }
    let Some(asked) = asked_to_rename(state, &params, cancel)? else {
        return Ok(None);
    };
    let Some((range, placeholder)) =
        ide::renameable(&asked.cx(), &asked.names(state), asked.offset)
    else {
        let unseen = ide::unseen_name(&asked.cx(), asked.offset);
        return unseen.map_or(Ok(None), |reason| Err(RequestFailure::Refused(reason)));
    };
    let range = convert::range(&asked.source.document, range, state.encoding);
    Ok(Some(PrepareRenameResponse::RangeWithPlaceholder {
        range,
        placeholder,
    }))
}

pub fn rename(
    state: &mut ServerState,
    params: RenameParams,
    cancel: &CancelFlag,
) -> Result<Option<WorkspaceEdit>, RequestFailure> {
    scan_all(state, cancel)?;
    let Some(asked) = asked_to_rename(state, &params.text_document_position, cancel)? else {
        return Ok(None);
    };
    let new = params.new_name.as_str();
    let names = asked.names(state);
    let mut spans =
        ide::rename(&asked.cx(), &names, asked.offset, new).map_err(RequestFailure::Refused)?;
    let kind = ide::kind_at(&asked.cx(), &names, asked.offset);
    let old = ide::renameable(&asked.cx(), &names, asked.offset)
        .map(|(_, old)| old)
        .unwrap_or_default();
    let name = match kind {
        None => NewName::Robot { old: &old, new },
        Some(SymbolKind::Argument) => NewName::Argument { old: &old, new },
        Some(_) => NewName::Xacro,
    };
    match kind {
        Some(_) => in_other_robots(state, &asked, &mut spans, cancel)?,
        None => in_all_robots(state, &asked, (&old, new), &mut spans, cancel)?,
    }
    admit_new_name(state, &asked, name, new, &spans, cancel)?;
    if kind.is_some() {
        spans.extend(in_presets(state, &asked));
        spans.extend(in_calls(state, &asked, &old)?);
    }
    spans.sort_by_key(|span| (span.file, span.range.start));
    spans.dedup();
    let mut edits: BTreeMap<Url, Vec<TextEdit>> = BTreeMap::new();
    for span in spans {
        let path = state.host.session().vfs.path(span.file);
        admit_edit(state, &path)?;
        if let Some(place) = location(state, span) {
            edits
                .entry(place.uri)
                .or_default()
                .push(TextEdit::new(place.range, new.to_owned()));
        }
    }
    Ok(Some(annotated(state, edits)))
}

/// A place with a name; where nothing evaluated it, in the expansion that takes the branch around it.
fn asked_to_rename(
    state: &mut ServerState,
    at: &TextDocumentPositionParams,
    cancel: &CancelFlag,
) -> Result<Option<Asked>, RequestFailure> {
    if let Some(found) = launched(state, at, cancel)? {
        return Ok(Some(found.asked));
    }
    let Some(asked) = asked_for_name(state, at, cancel)? else {
        return Ok(None);
    };
    if ide::renameable(&asked.cx(), &asked.names(state), asked.offset).is_some() {
        return Ok(Some(asked));
    }
    Ok(Some(inside(state, &asked, cancel)?.unwrap_or(asked)))
}

/// Whether robots stay what they are but for the name.
fn admit_new_name(
    state: &mut ServerState,
    asked: &Asked,
    name: NewName<'_>,
    new: &str,
    spans: &[Span],
    cancel: &CancelFlag,
) -> Result<(), RequestFailure> {
    let vfs = state.host.session().vfs.clone();
    let mut replaced: BTreeMap<PathBuf, Vec<(TextRange, String)>> = BTreeMap::new();
    for span in spans {
        let path = vfs.path(span.file).to_path_buf();
        replaced
            .entry(path)
            .or_default()
            .push((span.range, new.to_owned()));
    }
    let mut roots = vec![asked.analyzed.root.clone()];
    for path in replaced.keys() {
        let further = analysis::context(&mut state.host, path)
            .candidates
            .into_iter()
            .map(|(root, _)| root);
        roots.extend(
            further
                .filter(|root| !roots.contains(root))
                .collect::<Vec<_>>(),
        );
    }
    roots.truncate(QUICK_PROOF_EXPANSIONS);
    let replaced = replaced.into_iter().collect();
    let changed = analysis::changed_robot(state.host.session(), replaced, &roots, name, cancel);
    if cancel.is_cancelled() {
        return Err(RequestFailure::Cancelled);
    }
    changed.map_or(Ok(()), |obstacle| {
        Err(RequestFailure::Refused(refusal(new, &obstacle)))
    })
}

/// Why a name is refused: the robot that would be another one.
fn refusal(new: &str, obstacle: &Obstacle) -> String {
    let condition = obstacle.condition.as_ref().map(|(file, line, taken)| {
        let how = if *taken {
            "with the condition taken"
        } else {
            "without the condition"
        };
        format!(", {how} at {}:{line}", file_name(file))
    });
    let (robot, condition) = (file_name(&obstacle.robot), condition.unwrap_or_default());
    let difference = obstacle
        .difference
        .as_ref()
        .map(|what| format!(": {what}"))
        .unwrap_or_default();
    format!("the name `{new}` would change the robot `{robot}`{condition}{difference}")
}

/// Whether a file may be changed with the user's consent, which for files outside of the workspace the client has
/// to ask for.
fn admit_edit(state: &ServerState, path: &Path) -> Result<(), RequestFailure> {
    if is_ours(state, path) {
        return Ok(());
    }
    let shown = vfs::slashed(path);
    if analysis::is_installed(state.host.session(), path) || path.iter().any(is_built) {
        return Err(RequestFailure::Refused(format!(
            "`{shown}` is in an install folder and is not changed"
        )));
    }
    if state.client.edits.annotations {
        Ok(())
    } else {
        Err(RequestFailure::Refused(format!(
            "`{shown}` is not in the workspace and is not changed"
        )))
    }
}

/// Where configuration files, and comments that name a root, give the argument at a place a value, for robots that
/// read it.
fn in_presets(state: &mut ServerState, asked: &Asked) -> Vec<Span> {
    let cx = asked.cx();
    let definition = cx.symbol_at(asked.offset).map(|(id, _)| id);
    let argument = definition.and_then(|id| Some((id, cx.expansion.index.symbols.get(id)?)));
    let Some((id, argument)) = argument.filter(|(_, it)| it.kind == SymbolKind::Argument) else {
        return Vec::new();
    };
    let Some(target) = ide::definition_of(&cx, id) else {
        return Vec::new();
    };
    let path = state.host.session().vfs.path(target.name.file);
    let roots: Vec<PathBuf> = analysis::context(&mut state.host, &path)
        .candidates
        .into_iter()
        .map(|(r, _)| r.file)
        .collect();
    let session = state.host.session();
    let configs: BTreeSet<PathBuf> = roots
        .iter()
        .flat_map(|root| session.settings(root).config.files.clone())
        .collect();
    let mut found = Vec::new();
    for config in configs {
        let (Ok(text), Some(folder)) = (session.vfs.text(&config), config.parent()) else {
            continue;
        };
        let (id, folder) = (session.vfs.file_id(&config), folder.to_path_buf());
        let reads = |file: &str| {
            let files = files_named(file, &folder, &session.vfs);
            files
                .iter()
                .any(|file| roots.contains(&session.vfs.absolute(file)))
        };
        let places = argument_places(&text.text, &argument.name, reads);
        found.extend(places.into_iter().map(|range| Span { file: id, range }));
    }
    let known = state.host.known_files().into_iter();
    let comments = known.filter_map(|file| {
        analysis::commented_argument(state.host.session(), &file, &argument.name)
    });
    found.extend(
        comments
            .filter(|(root, _)| roots.contains(root))
            .map(|(_, span)| span),
    );
    found
}

/// Where launch files spell the argument at a place.
fn in_calls(
    state: &mut ServerState,
    asked: &Asked,
    old: &str,
) -> Result<Vec<Span>, RequestFailure> {
    let (places, robots) = in_launch_files(state, asked);
    let session = state.host.session();
    for &place in &places {
        if let Some(other) = analysis::gives_to_another(session, place, &robots, old) {
            let caller = file_name(&session.vfs.path(place.file));
            let other = file_name(&other);
            return Err(RequestFailure::Refused(format!(
                "`{caller}` passes `{old}` to `{other}` as well"
            )));
        }
    }
    Ok(places)
}

/// The same name in the other robots that read the files to be changed.
fn in_other_robots(
    state: &mut ServerState,
    asked: &Asked,
    spans: &mut Vec<Span>,
    cancel: &CancelFlag,
) -> Result<(), RequestFailure> {
    let vfs = state.host.session().vfs.clone();
    let Some(first) = spans.first().copied() else {
        return Ok(());
    };
    let document = vfs
        .document(&vfs.path(first.file))
        .map_err(|_| RequestFailure::Cancelled)?;
    let name = document.document.slice(first.range);
    // what one robot adds may concern those that were looked at before
    loop {
        let before = spans.len();
        let mut seen = vec![asked.analyzed.root.clone()];
        while let Some(root) =
            unseen_root(state, spans, &seen).filter(|_| seen.len() < RENAME_ROBOTS)
        {
            let analyzed = state
                .host
                .analyzed(&root, cancel)
                .ok_or(RequestFailure::Cancelled)?;
            let session = state.host.session();
            let settings = session.settings(&root.file);
            let names = TextNames::of(&analyzed.expansion, session.rule_env(&settings.config));
            let cx = Cx {
                expansion: &analyzed.expansion,
                ..asked.cx()
            };
            *spans = ide::places(&cx, &names, spans, &name);
            seen.push(root);
        }
        if spans.len() == before {
            return Ok(());
        }
    }
}

/// A robot that reads one of the files and was not looked at.
fn unseen_root(state: &mut ServerState, spans: &[Span], seen: &[RootConfig]) -> Option<RootConfig> {
    let files: BTreeSet<_> = spans.iter().map(|span| span.file).collect();
    files.into_iter().find_map(|file| {
        let path = state.host.session().vfs.path(file);
        let mut roots = analysis::context(&mut state.host, &path)
            .candidates
            .into_iter()
            .map(|(root, _)| root);
        roots.find(|root| !seen.contains(root))
    })
}

/// Files that may be changed: open ones, and those of the workspace that no tool has built.
pub fn is_ours(state: &ServerState, path: &Path) -> bool {
    let inside = state
        .host
        .folders()
        .iter()
        .filter_map(|folder| path.strip_prefix(folder).ok());
    state.documents.contains_key(path) || inside.into_iter().any(|path| !path.iter().any(is_built))
}

/// Edits that say of files which the user does not see that they are changed too, where the client shows that.
fn annotated(state: &ServerState, edits: BTreeMap<Url, Vec<TextEdit>>) -> WorkspaceEdit {
    let mut edit = workspace_edit(state, edits);
    let Some(DocumentChanges::Edits(documents)) = &mut edit.document_changes else {
        return edit;
    };
    if !state.client.edits.annotations {
        return edit;
    }
    let mut annotations = HashMap::new();
    for document in documents {
        let path = state.path(&document.text_document.uri);
        if state.documents.contains_key(&path) {
            continue;
        }
        let outside = !is_ours(state, &path);
        let (id, label) = if outside {
            ("outside", "in files outside the workspace")
        } else {
            ("closed", "in files that are not open")
        };
        let (annotation_id, label) = (id.to_owned(), label.to_owned());
        let annotation = ChangeAnnotation {
            label,
            needs_confirmation: Some(outside),
            description: None,
        };
        annotations.insert(annotation_id.clone(), annotation);
        for edit in &mut document.edits {
            if let OneOf::Left(text_edit) = edit.clone() {
                let annotation_id = annotation_id.clone();
                *edit = OneOf::Right(AnnotatedTextEdit {
                    text_edit,
                    annotation_id,
                });
            }
        }
    }
    edit.change_annotations = (!annotations.is_empty()).then_some(annotations);
    edit
}

/// Edits with the versions they were made for, where the client takes that.
pub fn workspace_edit(state: &ServerState, edits: BTreeMap<Url, Vec<TextEdit>>) -> WorkspaceEdit {
    if !state.client.edits.versions {
        let changes: HashMap<Url, Vec<TextEdit>> = edits.into_iter().collect();
        return WorkspaceEdit {
            changes: Some(changes),
            ..WorkspaceEdit::default()
        };
    }
    let edit = |(uri, edits): (Url, Vec<TextEdit>)| {
        let version = state
            .documents
            .get(&state.path(&uri))
            .and_then(|open| open.version);
        let text_document = OptionalVersionedTextDocumentIdentifier { uri, version };
        TextDocumentEdit {
            text_document,
            edits: edits.into_iter().map(OneOf::Left).collect(),
        }
    };
    let changes = DocumentChanges::Edits(edits.into_iter().map(edit).collect());
    WorkspaceEdit {
        document_changes: Some(changes),
        ..WorkspaceEdit::default()
    }
}
