//! Files that are made, renamed and deleted in the editor.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lsp_types::{
    CreateFilesParams, DeleteFilesParams, FileOperationFilter, FileOperationPattern,
    FileOperationPatternKind, FileOperationRegistrationOptions, MessageType, RenameFilesParams,
    TextDocumentIdentifier, TextEdit, Url, WorkspaceEdit,
    WorkspaceFileOperationsServerCapabilities,
};

use crate::convert;
use crate::failure::RequestFailure;
use crate::refreshing::refresh;
use crate::requests::navigation::asked;
use crate::requests::rename::{is_ours, workspace_edit};
use crate::requests::tokens::start_of;
use crate::scanning::scan_all;
use crate::scheduler::Cause;
use crate::state::ServerState;
use base::CancelFlag;
use base::limits::REWRITTEN_MESH_BYTES;
use ide::{self, Move};
use model::plain_stl;
use vfs::write_atomically;

/// The files whose names stand in descriptions.
const FILES: &str =
    "**/*.{xacro,urdf,srdf,sdf,yaml,yml,stl,STL,dae,DAE,obj,OBJ,glb,GLB,gltf,ply,png,jpg,jpeg}";

/// What the editor has to tell.
pub(super) fn offered() -> WorkspaceFileOperationsServerCapabilities {
    let options = Some(FileOperationRegistrationOptions {
        filters: vec![
            filter(FILES, FileOperationPatternKind::File),
            filter("**", FileOperationPatternKind::Folder),
        ],
    });
    WorkspaceFileOperationsServerCapabilities {
        did_create: options.clone(),
        will_create: None,
        did_rename: options.clone(),
        will_rename: options.clone(),
        did_delete: options,
        will_delete: None,
    }
}

/// The files or folders whose paths match a pattern.
fn filter(glob: &str, matches: FileOperationPatternKind) -> FileOperationFilter {
    FileOperationFilter {
        scheme: Some("file".to_owned()),
        pattern: FileOperationPattern {
            glob: glob.to_owned(),
            matches: Some(matches),
            options: None,
        },
    }
}

/// The edits that keep all names of files right.
pub fn will_rename_files(
    state: &mut ServerState,
    params: RenameFilesParams,
    cancel: &CancelFlag,
) -> Result<Option<WorkspaceEdit>, RequestFailure> {
    let moves: Vec<Move> = params
        .files
        .iter()
        .filter_map(|file| {
            Some(Move {
                old: path_of(&file.old_uri)?,
                new: path_of(&file.new_uri)?,
            })
        })
        .collect();
    scan_all(state, cancel)?;
    let mut files: Vec<PathBuf> = state.host.known_files();
    files.extend(state.documents.keys().cloned());
    files.sort();
    files.dedup();
    let mut edits: BTreeMap<Url, Vec<TextEdit>> = BTreeMap::new();
    files.retain(|file| is_ours(state, file) && may_name(state, file, &moves));
    for file in files {
        let Some(uri) = state.uri(&file) else {
            continue;
        };
        let asked = asked(
            state,
            &start_of(TextDocumentIdentifier { uri: uri.clone() }),
            cancel,
        )?;
        let session = state.host.session();
        let settings = session.settings(&file);
        let found = ide::renamed_files(&asked.cx(), session.rule_env(&settings.config), &moves);
        let edit = |(range, text)| {
            TextEdit::new(
                convert::range(&asked.source.document, range, state.encoding),
                text,
            )
        };
        if !found.is_empty() {
            edits.insert(uri, found.into_iter().map(edit).collect());
        }
    }
    warn_of_computed_includes(state, &moves, &edits);
    Ok((!edits.is_empty()).then(|| workspace_edit(state, edits)))
}

/// The path of a file that a client names.
fn path_of(uri: &str) -> Option<PathBuf> {
    convert::file_path(&Url::parse(uri).ok()?)
}

/// Tell the user which includes may mean a file that gets another name, and cannot follow it.
fn warn_of_computed_includes(
    state: &ServerState,
    moves: &[Move],
    edits: &BTreeMap<Url, Vec<TextEdit>>,
) {
    for each in moves
        .iter()
        .filter(|each| each.old.file_name() != each.new.file_name())
    {
        let mut left = state.host.computed_includers(&each.old);
        left.retain(|file| {
            let uri = state.uri(file);
            uri.is_none_or(|uri| !edits.contains_key(&uri))
        });
        if let Some(first) = left.first() {
            let message = format!(
                "`{}` may include `{}` by a computed name, which is not changed",
                convert::file_name(first),
                convert::file_name(&each.old)
            );
            state.outbox.show(MessageType::WARNING, message);
        }
    }
}

/// Whether a file moves itself, or its text holds the name of something that does.
fn may_name(state: &ServerState, file: &Path, moves: &[Move]) -> bool {
    let Some(source) = state.host.document(file) else {
        return false;
    };
    let text = source.document.text();
    moves.iter().any(|each| {
        // a package is named by its manifest, not by its folder
        file.starts_with(&each.old)
            || holds_name(&text, &each.old)
            || each.old.extension().is_none()
    })
}

/// Whether a text holds the name of a file.
fn holds_name(text: &str, path: &Path) -> bool {
    let name = path.file_name().map(|name| name.to_string_lossy());
    name.is_some_and(|name| text.contains(&*name))
}

/// Write a mesh of the workspace as binary STL whose header is not taken for text.
pub fn rewrite_mesh(
    state: &mut ServerState,
    mesh: &TextDocumentIdentifier,
) -> Result<(), RequestFailure> {
    let path = state.path(&mesh.uri);
    let is_stl = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("stl"));
    if !is_stl || !is_ours(state, &path) {
        return Err(refused(&path, "is not an STL file in the workspace"));
    }
    let bytes = state.host.session().vfs.bytes(&path, REWRITTEN_MESH_BYTES);
    let bytes =
        bytes.map_err(|error| refused(&path, &format!("cannot be read: {}", error.reason())))?;
    let Some(new) = plain_stl(&bytes) else {
        return Err(refused(&path, "needs no change"));
    };
    write_atomically(&path, &new)
        .map_err(|error| refused(&path, &format!("cannot be written: {error}")))?;
    state.host.changed_on_disk(&[path]);
    state.schedule(Cause::FilesChanged(1));
    refresh(state);
    Ok(())
}

/// Why a mesh is left as it is.
fn refused(mesh: &Path, reason: &str) -> RequestFailure {
    RequestFailure::Refused(format!("`{}` {reason}", vfs::slashed(mesh)))
}

pub fn files_renamed(state: &mut ServerState, params: RenameFilesParams) {
    let both = params
        .files
        .into_iter()
        .flat_map(|file| [file.old_uri, file.new_uri]);
    files_changed(state, both.collect());
}

pub fn files_created(state: &mut ServerState, params: CreateFilesParams) {
    files_changed(
        state,
        params.files.into_iter().map(|file| file.uri).collect(),
    );
}

pub fn files_deleted(state: &mut ServerState, params: DeleteFilesParams) {
    files_changed(
        state,
        params.files.into_iter().map(|file| file.uri).collect(),
    );
}

fn files_changed(state: &mut ServerState, uris: Vec<String>) {
    let paths: Vec<PathBuf> = uris
        .iter()
        .filter_map(|uri| convert::file_path(&Url::parse(uri).ok()?))
        .collect();
    state.host.changed_on_disk(&paths);
    state.schedule(Cause::FilesChanged(paths.len()));
    refresh(state);
}
