//! The messages of the protocol. Each handler posts one job; nothing else happens here.
use lsp_types::*;
use serde_json::Value;
use tower_lsp::jsonrpc::Result;
use tower_lsp::{LanguageServer, async_trait};

use crate::diagnostics::{pull_diagnostics, pull_workspace};
use crate::documents::{bad_message, changed, closed, folders_changed, opened, saved, watched};
use crate::exit::Shutdown;
use crate::files::{files_created, files_deleted, files_renamed, will_rename_files};
use crate::lifecycle::{client_ready, initialize};
use crate::mapping::{
    Instances, Sources, ToExpandedParams, ToSourceParams, instances_of, sources_of,
};
use crate::preview::{
    Mesh, MeshParams, SelectParams, ShowParams, SubscribeParams, Subscribed, ViewParams,
    preview_mesh, preview_urdf, selected, show_root, subscribe, unsubscribe,
};
use crate::queue::Queue;
use crate::requests::actions::actions;
use crate::requests::calls::{incoming_calls, outgoing_calls, prepare_calls};
use crate::requests::colors::{color_texts, colors};
use crate::requests::commands::command;
use crate::requests::completion::{completion, on_type, resolve_completion, signature_help};
use crate::requests::expand_at::{
    ExpandAtParams, ExpandedPlace, SetInstanceParams, expand_at, set_instance,
};
use crate::requests::expansion::{ExpandParams, Expanded, expand};
use crate::requests::formatting::{format, format_range};
use crate::requests::hints::{hints, resolve_hint};
use crate::requests::hover::hover;
use crate::requests::lenses::{lenses, resolve_lens};
use crate::requests::links::links;
use crate::requests::navigation::{
    declaration, definition, highlights, implementation, type_definition,
};
use crate::requests::of_description::{OfDocument, Work, of_description};
use crate::requests::refactorings::resolve_action;
use crate::requests::references::references;
use crate::requests::rename::{prepare_rename, rename};
use crate::requests::structure::{folding, linked_editing, selections, symbols};
use crate::requests::tokens::{tokens, tokens_delta, tokens_range};
use crate::requests::workspace_symbols::workspace_symbols;
use crate::roots::{Roots, RootsParams, SetRootParams, Tree, TreeParams, roots, set_root, tree};
use crate::settings::settings_changed;
use crate::state::State;

/// The protocol side of the server.
pub(super) struct Handlers {
    pub queue: Queue<State>,
    /// How the process ends; none where it is not ours to end.
    pub shutdown: Option<Shutdown>,
}

impl Handlers {
    /// A request that is answered for XML alone.
    async fn about_xml<P, R>(&self, params: P, work: Work<P, R>) -> Result<R>
    where
        P: OfDocument + Send + 'static,
        R: Default + Send + 'static,
    {
        self.queue.request((params, work), of_description).await
    }

    pub async fn expand_at(&self, params: ExpandAtParams) -> Result<Option<ExpandedPlace>> {
        self.queue.request(params, expand_at).await
    }

    pub async fn set_instance(&self, params: SetInstanceParams) -> Result<Value> {
        self.queue.request(params, set_instance).await
    }

    pub async fn to_source(&self, params: ToSourceParams) -> Result<Sources> {
        self.queue.request(params, sources_of).await
    }

    pub async fn to_expanded(&self, params: ToExpandedParams) -> Result<Instances> {
        self.queue.request(params, instances_of).await
    }

    pub async fn roots(&self, params: RootsParams) -> Result<Roots> {
        self.queue.request(params, roots).await
    }

    pub async fn set_root(&self, params: SetRootParams) -> Result<Value> {
        self.queue.request(params, set_root).await
    }

    pub async fn tree(&self, params: TreeParams) -> Result<Tree> {
        self.queue.request(params, tree).await
    }

    pub async fn preview_subscribe(&self, params: SubscribeParams) -> Result<Subscribed> {
        self.queue.request(params, subscribe).await
    }

    pub async fn preview_unsubscribe(&self, params: ViewParams) -> Result<Value> {
        self.queue.request(params, unsubscribe).await
    }

    pub async fn preview_root(&self, params: ShowParams) -> Result<Value> {
        self.queue.request(params, show_root).await
    }

    pub async fn preview_mesh(&self, params: MeshParams) -> Result<Mesh> {
        self.queue.request(params, preview_mesh).await
    }

    pub async fn preview_urdf(&self, params: ViewParams) -> Result<Value> {
        self.queue.request(params, preview_urdf).await
    }

    pub async fn preview_select(&self, params: SelectParams) {
        self.queue.notify(params, selected);
    }

    pub async fn log(&self, _: Value) -> Result<Vec<String>> {
        self.queue.request((), crate::lifecycle::last_lines).await
    }

    pub async fn set_trace(&self, params: SetTraceParams) {
        self.queue.notify(params, crate::lifecycle::set_trace);
    }

    pub async fn bad_message(&self, params: Value) {
        self.queue.notify(params, bad_message);
    }

    /// A job that fails, for the test that the server lives on.
    #[cfg(debug_assertions)]
    pub async fn fail(&self, _: Value) -> Result<Value> {
        self.queue.request((), crate::main_loop::fail).await
    }

    pub async fn expand(&self, params: ExpandParams) -> Result<Expanded> {
        self.queue.request(params, expand).await
    }
}

#[async_trait]
impl LanguageServer for Handlers {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        self.queue
            .request((params, self.shutdown.clone()), initialize)
            .await
    }

    async fn initialized(&self, _: InitializedParams) {
        self.queue.notify((), client_ready);
    }

    async fn shutdown(&self) -> Result<()> {
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        self.queue.notify(params, opened);
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        self.queue.notify_edit(params, changed);
    }

    async fn did_save(&self, params: DidSaveTextDocumentParams) {
        self.queue.notify(params, saved);
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        self.queue.notify(params, closed);
    }

    async fn did_change_watched_files(&self, params: DidChangeWatchedFilesParams) {
        self.queue.notify(params, watched);
    }

    async fn did_change_workspace_folders(&self, params: DidChangeWorkspaceFoldersParams) {
        self.queue.notify(params, folders_changed);
    }

    async fn did_change_configuration(&self, params: DidChangeConfigurationParams) {
        self.queue.notify(params, settings_changed);
    }

    async fn diagnostic(
        &self,
        params: DocumentDiagnosticParams,
    ) -> Result<DocumentDiagnosticReportResult> {
        self.queue.request(params, pull_diagnostics).await
    }

    async fn workspace_diagnostic(
        &self,
        params: WorkspaceDiagnosticParams,
    ) -> Result<WorkspaceDiagnosticReportResult> {
        self.queue.request(params, pull_workspace).await
    }

    async fn completion(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        self.queue.request(params, completion).await
    }

    async fn completion_resolve(&self, params: CompletionItem) -> Result<CompletionItem> {
        self.queue.request(params, resolve_completion).await
    }

    async fn signature_help(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        self.about_xml(params, signature_help).await
    }

    async fn code_action(&self, params: CodeActionParams) -> Result<Option<CodeActionResponse>> {
        self.about_xml(params, actions).await
    }

    async fn code_action_resolve(&self, params: CodeAction) -> Result<CodeAction> {
        self.queue.request(params, resolve_action).await
    }

    async fn formatting(&self, params: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.about_xml(params, format).await
    }

    async fn range_formatting(
        &self,
        params: DocumentRangeFormattingParams,
    ) -> Result<Option<Vec<TextEdit>>> {
        self.about_xml(params, format_range).await
    }

    async fn on_type_formatting(
        &self,
        params: DocumentOnTypeFormattingParams,
    ) -> Result<Option<Vec<TextEdit>>> {
        self.about_xml(params, on_type).await
    }

    async fn document_symbol(
        &self,
        params: DocumentSymbolParams,
    ) -> Result<Option<DocumentSymbolResponse>> {
        self.about_xml(params, symbols).await
    }

    async fn folding_range(&self, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
        self.about_xml(params, folding).await
    }

    async fn selection_range(
        &self,
        params: SelectionRangeParams,
    ) -> Result<Option<Vec<SelectionRange>>> {
        self.about_xml(params, selections).await
    }

    async fn linked_editing_range(
        &self,
        params: LinkedEditingRangeParams,
    ) -> Result<Option<LinkedEditingRanges>> {
        self.about_xml(params, linked_editing).await
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        self.queue.request(params, hover).await
    }

    async fn goto_definition(
        &self,
        params: GotoDefinitionParams,
    ) -> Result<Option<GotoDefinitionResponse>> {
        self.queue.request(params, definition).await
    }

    async fn goto_declaration(
        &self,
        params: GotoDefinitionParams,
    ) -> Result<Option<GotoDefinitionResponse>> {
        self.about_xml(params, declaration).await
    }

    async fn goto_type_definition(
        &self,
        params: GotoDefinitionParams,
    ) -> Result<Option<GotoDefinitionResponse>> {
        self.about_xml(params, type_definition).await
    }

    async fn goto_implementation(
        &self,
        params: GotoDefinitionParams,
    ) -> Result<Option<GotoDefinitionResponse>> {
        self.about_xml(params, implementation).await
    }

    async fn will_rename_files(&self, params: RenameFilesParams) -> Result<Option<WorkspaceEdit>> {
        self.queue.request(params, will_rename_files).await
    }

    async fn did_rename_files(&self, params: RenameFilesParams) {
        self.queue.notify(params, files_renamed);
    }

    async fn did_create_files(&self, params: CreateFilesParams) {
        self.queue.notify(params, files_created);
    }

    async fn did_delete_files(&self, params: DeleteFilesParams) {
        self.queue.notify(params, files_deleted);
    }

    async fn prepare_rename(
        &self,
        params: TextDocumentPositionParams,
    ) -> Result<Option<PrepareRenameResponse>> {
        self.queue.request(params, prepare_rename).await
    }

    async fn rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        self.queue.request(params, rename).await
    }

    async fn references(&self, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
        self.queue.request(params, references).await
    }

    async fn document_highlight(
        &self,
        params: DocumentHighlightParams,
    ) -> Result<Option<Vec<DocumentHighlight>>> {
        self.queue.request(params, highlights).await
    }

    async fn semantic_tokens_full(
        &self,
        params: SemanticTokensParams,
    ) -> Result<Option<SemanticTokensResult>> {
        self.about_xml(params, tokens).await
    }

    async fn semantic_tokens_full_delta(
        &self,
        params: SemanticTokensDeltaParams,
    ) -> Result<Option<SemanticTokensFullDeltaResult>> {
        self.about_xml(params, tokens_delta).await
    }

    async fn semantic_tokens_range(
        &self,
        params: SemanticTokensRangeParams,
    ) -> Result<Option<SemanticTokensRangeResult>> {
        self.about_xml(params, tokens_range).await
    }

    async fn document_link(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        self.about_xml(params, links).await
    }

    async fn inlay_hint(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        self.about_xml(params, hints).await
    }

    async fn inlay_hint_resolve(&self, params: InlayHint) -> Result<InlayHint> {
        self.queue.request(params, resolve_hint).await
    }

    async fn document_color(&self, params: DocumentColorParams) -> Result<Vec<ColorInformation>> {
        self.about_xml(params, colors).await
    }

    async fn color_presentation(
        &self,
        params: ColorPresentationParams,
    ) -> Result<Vec<ColorPresentation>> {
        self.queue.request(params, color_texts).await
    }

    async fn code_lens(&self, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
        self.about_xml(params, lenses).await
    }

    async fn code_lens_resolve(&self, params: CodeLens) -> Result<CodeLens> {
        self.queue.request(params, resolve_lens).await
    }

    async fn prepare_call_hierarchy(
        &self,
        params: CallHierarchyPrepareParams,
    ) -> Result<Option<Vec<CallHierarchyItem>>> {
        self.about_xml(params, prepare_calls).await
    }

    async fn incoming_calls(
        &self,
        params: CallHierarchyIncomingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
        self.queue.request(params, incoming_calls).await
    }

    async fn outgoing_calls(
        &self,
        params: CallHierarchyOutgoingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
        self.queue.request(params, outgoing_calls).await
    }

    async fn symbol(
        &self,
        params: WorkspaceSymbolParams,
    ) -> Result<Option<Vec<SymbolInformation>>> {
        self.queue.request(params, workspace_symbols).await
    }

    async fn execute_command(&self, params: ExecuteCommandParams) -> Result<Option<Value>> {
        self.queue.request(params, command).await
    }
}
