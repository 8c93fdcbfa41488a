//! Quick fixes and refactorings.
//!
//! Fixes are taken from the findings for the text as it is now, never from what a client sends along: a
//! diagnostic may be older than the text, and its data may come from anywhere.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOptions, CodeActionOrCommand, CodeActionParams, Command,
    Diagnostic, DocumentChangeOperation, DocumentChanges, NumberOrString, RenameFile, ResourceOp,
    TextDocumentPositionParams, TextEdit, Url, WorkDoneProgressOptions, WorkspaceEdit,
};
use serde_json::json;

use super::convert;
use super::engine::Engine;
use super::failure::Failure;
use crate::analysis::{apply, choose};
use crate::base::{CancelFlag, Span, TextRange};
use crate::facts::{FactKind, facts};
use crate::ide::{self, Action, ActionKind, MacroFile};
use crate::rules::{Edit, Finding, Safety};
use crate::vfs::SourceFile;
use crate::workspace::config::find_config;
use crate::xml::Document;

/// All safe fixes of a file at once.
const FIX_ALL: CodeActionKind = CodeActionKind::new("source.fixAll.xacro");
/// Files offered for an include, at most.
const MOST_FILES: usize = 5;
/// Diagnostics that fixes are looked for, at most.
const MOST_DIAGNOSTICS: usize = 50;

/// The kinds of actions there are.
pub(super) fn offered() -> CodeActionOptions {
    CodeActionOptions {
        code_action_kinds: Some(vec![
            CodeActionKind::QUICKFIX,
            CodeActionKind::REFACTOR_EXTRACT,
            CodeActionKind::REFACTOR_INLINE,
            CodeActionKind::REFACTOR_REWRITE,
            FIX_ALL,
        ]),
        resolve_provider: Some(true),
        work_done_progress_options: WorkDoneProgressOptions::default(),
    }
}

impl Engine {
    pub fn actions(
        &mut self,
        params: CodeActionParams,
        cancel: &CancelFlag,
    ) -> Result<Option<Vec<CodeActionOrCommand>>, Failure> {
        let (path, source) = self.source(&params.text_document.uri)?;
        let only = params.context.only.as_deref();
        let mut found = Vec::new();
        if wants(only, &CodeActionKind::QUICKFIX) {
            found.extend(self.quick_fixes(&params, &path, &source, cancel)?);
        }
        if ["extract", "inline", "rewrite"].iter().any(|kind| wants(only, &refactor(kind))) {
            let actions = self.refactor_actions(&params.text_document.uri, params.range, cancel)?;
            let actions =
                actions.into_iter().filter(|action| action.kind.as_ref().is_some_and(|k| wants(only, k)));
            found.extend(actions.collect::<Vec<_>>());
        }
        if self.client.renames_files && wants(only, &CodeActionKind::QUICKFIX) {
            found.extend(self.renamed_to_xacro(&params, &path));
        }
        // asked for by name only: it needs the findings of the whole file
        if only.is_some() && wants(only, &FIX_ALL) {
            found.extend(self.fix_all(&path, &source, cancel)?);
        }
        Ok(Some(found.into_iter().map(CodeActionOrCommand::CodeAction).collect()))
    }

    /// A file with tags of xacro gets a name that says so.
    fn renamed_to_xacro(&self, params: &CodeActionParams, path: &Path) -> Option<CodeAction> {
        let shown =
            params.context.diagnostics.iter().find(|shown| rule(shown) == Some("xacro-tags-in-urdf"))?;
        let is_urdf = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("urdf"));
        let name = path.file_stem().filter(|_| is_urdf)?.to_str()?;
        let new = path.with_file_name(format!("{name}.urdf.xacro"));
        if !self.is_ours(path) || self.world.session().vfs.exists(&new) {
            return None;
        }
        let rename = ResourceOp::Rename(RenameFile {
            old_uri: params.text_document.uri.clone(),
            new_uri: Url::from_file_path(&new).ok()?,
            options: None,
            annotation_id: None,
        });
        let changes = Some(DocumentChanges::Operations(vec![DocumentChangeOperation::Op(rename)]));
        Some(CodeAction {
            title: format!("rename the file to `{name}.urdf.xacro`"),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(vec![shown.clone()]),
            edit: Some(WorkspaceEdit { document_changes: changes, ..WorkspaceEdit::default() }),
            ..CodeAction::default()
        })
    }

    /// The fixes of the diagnostics that the client shows.
    fn quick_fixes(
        &mut self,
        params: &CodeActionParams,
        path: &Path,
        source: &Arc<SourceFile>,
        cancel: &CancelFlag,
    ) -> Result<Vec<CodeAction>, Failure> {
        let shown: Vec<(&Diagnostic, &str)> = params
            .context
            .diagnostics
            .iter()
            .filter_map(|shown| Some((shown, rule(shown)?)))
            .take(MOST_DIAGNOSTICS)
            .collect();
        if shown.is_empty() {
            return Ok(Vec::new());
        }
        let findings = self.findings_in(path, cancel)?;
        let mut found: Vec<CodeAction> = Vec::new();
        for (diagnostic, rule) in shown {
            let range = convert::text_range(&source.document, diagnostic.range, self.encoding);
            let here = |finding: &&Finding| finding.rule.name == rule && finding.span.range == range;
            let Some(finding) = findings.iter().find(here) else { continue };
            let mut actions: Vec<(Action, bool)> = Vec::new();
            if let Some(fix) = &finding.fix {
                let (title, edits) = (fix.message.clone(), fix.edits.clone());
                let action = Action { title, kind: ActionKind::Fix, edits };
                actions.push((action, fix.safety == Safety::Safe));
            }
            if finding.fix.is_none() {
                let near = finding.help.as_deref().and_then(|help| ide::suggested(source, range, help));
                actions.extend(near.map(|action| (action, false)));
            }
            if rule == "undefined-macro" {
                self.world.scan(|| cancel.is_cancelled());
                let more = ide::include_macro(source, range, |name| self.files_with_macro(path, name));
                actions.extend(more.into_iter().map(|action| (action, false)));
            }
            actions.extend(self.with_meaning(params, finding, cancel)?.map(|action| (action, false)));
            let more = ide::quick_fixes(source, rule, range);
            actions.extend(more.into_iter().map(|action| (action, false)));
            actions.extend(self.ignored_in_project(path, rule).map(|action| (action, false)));
            found.extend(self.mesh_rewritten(params, diagnostic, rule, cancel)?);
            for (action, preferred) in actions {
                let made = self.action(action, Some(diagnostic));
                found.extend(made.map(|made| CodeAction { is_preferred: preferred.then_some(true), ..made }));
            }
        }
        Ok(found)
    }

    /// The mesh that a finding names, written anew by a command: no edit of text can do that.
    fn mesh_rewritten(
        &mut self,
        params: &CodeActionParams,
        diagnostic: &Diagnostic,
        rule: &str,
        cancel: &CancelFlag,
    ) -> Result<Option<CodeAction>, Failure> {
        let title = match rule {
            "ascii-stl" => "write the mesh as binary STL",
            "binary-stl-solid-header" => "change the header of the mesh",
            _ => return Ok(None),
        };
        let at = TextDocumentPositionParams::new(params.text_document.clone(), diagnostic.range.start);
        let asked = self.asked(&at, cancel)?;
        let mesh = self.about_files(&asked, ide::file_definition).map(|(_, place)| place.path);
        let uri = mesh.filter(|path| self.is_ours(path)).and_then(|path| self.uri(&path));
        let action = |uri| CodeAction {
            title: title.to_owned(),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(vec![diagnostic.clone()]),
            command: Some(Command {
                title: title.to_owned(),
                command: "xacro.rewriteMesh".to_owned(),
                arguments: Some(vec![json!({ "uri": uri })]),
            }),
            ..CodeAction::default()
        };
        Ok(uri.map(action))
    }

    /// Fixes that need to know what names mean.
    fn with_meaning(
        &mut self,
        params: &CodeActionParams,
        finding: &Finding,
        cancel: &CancelFlag,
    ) -> Result<Option<Action>, Failure> {
        if !matches!(finding.rule.name, "shadowed-builtin" | "use-before-definition") {
            return Ok(None);
        }
        let at = TextDocumentPositionParams::new(params.text_document.clone(), params.range.start);
        let asked = self.asked(&at, cancel)?;
        if finding.rule.name == "shadowed-builtin" {
            return Ok(ide::other_name(&asked.cx(), finding.span.range));
        }
        let given = finding.related.iter().find(|related| related.span.file == finding.span.file);
        Ok(given.and_then(|given| ide::before_use(&asked.cx(), finding.span.range, given.span.range)))
    }

    /// A rule switched off in the configuration file that holds for a file; none where there is no such file.
    fn ignored_in_project(&self, path: &Path, rule: &str) -> Option<Action> {
        let vfs = &self.world.session().vfs;
        let config = find_config(vfs, path.parent()?)?;
        let (range, content) = ide::ignored_in_config(&vfs.text(&config).ok()?.text, rule)?;
        let edits = vec![Edit { span: Span { file: vfs.file_id(&config), range }, content }];
        Some(Action { title: format!("switch `{rule}` off in the project"), kind: ActionKind::Fix, edits })
    }

    fn findings_in(&mut self, path: &Path, cancel: &CancelFlag) -> Result<Vec<Finding>, Failure> {
        let report = self.world.report(&[path.to_path_buf()], cancel).ok_or(Failure::Cancelled)?;
        let own = report.findings.iter().filter(|finding| report.path(finding.span.file) == path);
        Ok(own.cloned().collect())
    }

    /// Known files that define a macro, as an include in the file at `path` names them.
    fn files_with_macro(&self, path: &Path, name: &str) -> Vec<MacroFile> {
        let packages = &self.world.session().packages;
        let defines = |document: &Document| {
            facts(document).any(|(_, facts)| facts.of(FactKind::Macro).any(|fact| fact.name == name))
        };
        let files = self.world.known_files().into_iter().filter(|file| file != path);
        let files = files.filter(|file| self.world.document(file).is_some_and(|own| defines(&own.document)));
        let include = |file: std::path::PathBuf| {
            let beside = file.parent() == path.parent();
            let filename = match packages.containing(&file) {
                Some(package) if !beside => {
                    let inside = file.strip_prefix(&package.folder).ok()?.to_str()?.to_owned();
                    format!("$(find {})/{inside}", package.name)
                }
                _ if beside => file.file_name()?.to_str()?.to_owned(),
                _ => file.to_str()?.to_owned(),
            };
            Some(MacroFile { filename })
        };
        files.filter_map(include).take(MOST_FILES).collect()
    }

    /// All safe fixes of a file that change nothing else and leave its syntax whole.
    fn fix_all(
        &mut self,
        path: &Path,
        source: &SourceFile,
        cancel: &CancelFlag,
    ) -> Result<Option<CodeAction>, Failure> {
        let findings = self.findings_in(path, cancel)?;
        let own = |edit: &Edit| edit.span.file == source.id;
        let plan = choose(&findings, |fix| fix.safety == Safety::Safe && fix.edits.iter().all(own));
        let Some(edits) = plan.edits.get(&source.id) else { return Ok(None) };
        let changed = Document::parse(&apply(&source.document.text(), edits));
        if changed.errors().len() > source.document.errors().len() {
            return Ok(None);
        }
        let edit = |(range, content): &(TextRange, String)| Edit {
            span: Span { file: source.id, range: *range },
            content: content.clone(),
        };
        let title = "fix all that can be fixed safely".to_owned();
        let action = Action { title, kind: ActionKind::Fix, edits: edits.iter().map(edit).collect() };
        Ok(self.action(action, None).map(|made| CodeAction { kind: Some(FIX_ALL), ..made }))
    }

    /// An action for the client; none when it would change a file that is not the user's.
    pub(super) fn action(&self, action: Action, diagnostic: Option<&Diagnostic>) -> Option<CodeAction> {
        Some(CodeAction {
            title: action.title,
            kind: Some(kind(action.kind)),
            diagnostics: diagnostic.map(|diagnostic| vec![diagnostic.clone()]),
            edit: Some(self.edits_of(&action.edits)?),
            ..CodeAction::default()
        })
    }

    fn edits_of(&self, edits: &[Edit]) -> Option<WorkspaceEdit> {
        let mut changes: BTreeMap<Url, Vec<TextEdit>> = BTreeMap::new();
        for edit in edits {
            let path = self.world.session().vfs.path(edit.span.file);
            let place = self.location(edit.span).filter(|_| self.is_ours(&path))?;
            changes.entry(place.uri).or_default().push(TextEdit::new(place.range, edit.content.clone()));
        }
        (!changes.is_empty()).then(|| self.workspace_edit(changes))
    }
}

/// The rule of one of our diagnostics.
fn rule(diagnostic: &Diagnostic) -> Option<&str> {
    match &diagnostic.code {
        Some(NumberOrString::String(code)) if diagnostic.source.as_deref() == Some("xacro") => Some(code),
        _ => None,
    }
}

/// Whether a client that asks for these kinds wants this one; a kind stands for all below it.
fn wants(only: Option<&[CodeActionKind]>, kind: &CodeActionKind) -> bool {
    let Some(only) = only else { return true };
    only.iter().any(|wanted| {
        let below = kind.as_str().strip_prefix(wanted.as_str());
        wanted.as_str().is_empty() || below.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    })
}

fn refactor(name: &str) -> CodeActionKind {
    CodeActionKind::from(format!("refactor.{name}"))
}

pub(super) fn kind(kind: ActionKind) -> CodeActionKind {
    match kind {
        ActionKind::Fix => CodeActionKind::QUICKFIX,
        ActionKind::Extract => CodeActionKind::REFACTOR_EXTRACT,
        ActionKind::Inline => CodeActionKind::REFACTOR_INLINE,
        ActionKind::Rewrite => CodeActionKind::REFACTOR_REWRITE,
    }
}
