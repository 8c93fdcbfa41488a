//! The messages of the protocol. Each handler posts one job; nothing else happens here.

use lsp_types::*;
use serde_json::Value;
use tower_lsp::jsonrpc::Result;
use tower_lsp::{LanguageServer, async_trait};

use super::engine::Engine;
use super::exit::Shutdown;
use super::expand_at::{ExpandAtParams, ExpandedPlace, SetInstanceParams};
use super::expansion::{ExpandParams, Expanded};
use super::letterbox::Letterbox;
use super::mapping::{Instances, Sources, ToExpandedParams, ToSourceParams};
use super::preview::{Mesh, MeshParams, SelectParams, ShowParams, SubscribeParams, Subscribed, ViewParams};
use super::roots::{Roots, RootsParams, SetRootParams, Tree, TreeParams};

/// The protocol side of the server.
pub(super) struct Handlers {
    pub letterbox: Letterbox,
    pub shutdown: Shutdown,
}

impl Handlers {
    pub async fn expand_at(&self, params: ExpandAtParams) -> Result<Option<ExpandedPlace>> {
        self.letterbox.ask(params, Engine::expand_at).await
    }

    pub async fn set_instance(&self, params: SetInstanceParams) -> Result<Value> {
        self.letterbox.ask(params, Engine::set_instance).await
    }

    pub async fn to_source(&self, params: ToSourceParams) -> Result<Sources> {
        self.letterbox.ask(params, Engine::sources_of).await
    }

    pub async fn to_expanded(&self, params: ToExpandedParams) -> Result<Instances> {
        self.letterbox.ask(params, Engine::instances_of).await
    }

    pub async fn roots(&self, params: RootsParams) -> Result<Roots> {
        self.letterbox.ask(params, Engine::roots).await
    }

    pub async fn set_root(&self, params: SetRootParams) -> Result<Value> {
        self.letterbox.ask(params, Engine::set_root).await
    }

    pub async fn tree(&self, params: TreeParams) -> Result<Tree> {
        self.letterbox.ask(params, Engine::tree).await
    }

    pub async fn preview_subscribe(&self, params: SubscribeParams) -> Result<Subscribed> {
        self.letterbox.ask(params, Engine::subscribe).await
    }

    pub async fn preview_unsubscribe(&self, params: ViewParams) -> Result<Value> {
        self.letterbox.ask(params, Engine::unsubscribe).await
    }

    pub async fn preview_root(&self, params: ShowParams) -> Result<Value> {
        self.letterbox.ask(params, Engine::show_root).await
    }

    pub async fn preview_mesh(&self, params: MeshParams) -> Result<Mesh> {
        self.letterbox.ask(params, Engine::preview_mesh).await
    }

    pub async fn preview_select(&self, params: SelectParams) {
        self.letterbox.tell(params, Engine::selected);
    }

    pub async fn bad_message(&self, params: Value) {
        self.letterbox.tell(params, Engine::bad_message);
    }

    /// A job that fails, for the test that the server lives on.
    #[cfg(debug_assertions)]
    pub async fn fail(&self, _: Value) -> Result<Value> {
        self.letterbox.ask((), Engine::fail).await
    }

    pub async fn expand(&self, params: ExpandParams) -> Result<Expanded> {
        self.letterbox.ask(params, Engine::expand).await
    }
}

#[async_trait]
impl LanguageServer for Handlers {
    async fn initialize(&self, params: InitializeParams) -> Result<InitializeResult> {
        self.letterbox.ask((params, self.shutdown.clone()), Engine::initialize).await
    }

    async fn initialized(&self, _: InitializedParams) {
        self.letterbox.tell((), Engine::client_ready);
    }

    async fn shutdown(&self) -> Result<()> {
        Ok(())
    }

    async fn did_open(&self, params: DidOpenTextDocumentParams) {
        self.letterbox.tell(params, Engine::opened);
    }

    async fn did_change(&self, params: DidChangeTextDocumentParams) {
        self.letterbox.tell_edit(params, Engine::changed);
    }

    async fn did_save(&self, params: DidSaveTextDocumentParams) {
        self.letterbox.tell(params, Engine::saved);
    }

    async fn did_close(&self, params: DidCloseTextDocumentParams) {
        self.letterbox.tell(params, Engine::closed);
    }

    async fn did_change_watched_files(&self, params: DidChangeWatchedFilesParams) {
        self.letterbox.tell(params, Engine::watched);
    }

    async fn did_change_workspace_folders(&self, params: DidChangeWorkspaceFoldersParams) {
        self.letterbox.tell(params, Engine::folders_changed);
    }

    async fn did_change_configuration(&self, params: DidChangeConfigurationParams) {
        self.letterbox.tell(params, Engine::settings_changed);
    }

    async fn diagnostic(&self, params: DocumentDiagnosticParams) -> Result<DocumentDiagnosticReportResult> {
        self.letterbox.ask(params, Engine::pull_diagnostics).await
    }

    async fn workspace_diagnostic(
        &self,
        params: WorkspaceDiagnosticParams,
    ) -> Result<WorkspaceDiagnosticReportResult> {
        self.letterbox.ask(params, Engine::pull_workspace).await
    }

    async fn completion(&self, params: CompletionParams) -> Result<Option<CompletionResponse>> {
        self.letterbox.ask(params, Engine::completion).await
    }

    async fn completion_resolve(&self, params: CompletionItem) -> Result<CompletionItem> {
        self.letterbox.ask(params, Engine::resolve_completion).await
    }

    async fn signature_help(&self, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
        self.letterbox.ask(params, Engine::signature_help).await
    }

    async fn code_action(&self, params: CodeActionParams) -> Result<Option<CodeActionResponse>> {
        self.letterbox.ask(params, Engine::actions).await
    }

    async fn code_action_resolve(&self, params: CodeAction) -> Result<CodeAction> {
        self.letterbox.ask(params, Engine::resolve_action).await
    }

    async fn formatting(&self, params: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.letterbox.ask(params, Engine::format).await
    }

    async fn range_formatting(&self, params: DocumentRangeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
        self.letterbox.ask(params, Engine::format_range).await
    }

    async fn on_type_formatting(
        &self,
        params: DocumentOnTypeFormattingParams,
    ) -> Result<Option<Vec<TextEdit>>> {
        self.letterbox.ask(params, Engine::on_type).await
    }

    async fn document_symbol(&self, params: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
        self.letterbox.ask(params, Engine::symbols).await
    }

    async fn folding_range(&self, params: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
        self.letterbox.ask(params, Engine::folding).await
    }

    async fn selection_range(&self, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
        self.letterbox.ask(params, Engine::selections).await
    }

    async fn linked_editing_range(
        &self,
        params: LinkedEditingRangeParams,
    ) -> Result<Option<LinkedEditingRanges>> {
        self.letterbox.ask(params, Engine::linked_editing).await
    }

    async fn hover(&self, params: HoverParams) -> Result<Option<Hover>> {
        self.letterbox.ask(params, Engine::hover).await
    }

    async fn goto_definition(&self, params: GotoDefinitionParams) -> Result<Option<GotoDefinitionResponse>> {
        self.letterbox.ask(params, Engine::definition).await
    }

    async fn goto_declaration(&self, params: GotoDefinitionParams) -> Result<Option<GotoDefinitionResponse>> {
        self.letterbox.ask(params, Engine::declaration).await
    }

    async fn goto_type_definition(
        &self,
        params: GotoDefinitionParams,
    ) -> Result<Option<GotoDefinitionResponse>> {
        self.letterbox.ask(params, Engine::type_definition).await
    }

    async fn goto_implementation(
        &self,
        params: GotoDefinitionParams,
    ) -> Result<Option<GotoDefinitionResponse>> {
        self.letterbox.ask(params, Engine::implementation).await
    }

    async fn will_rename_files(&self, params: RenameFilesParams) -> Result<Option<WorkspaceEdit>> {
        self.letterbox.ask(params, Engine::will_rename_files).await
    }

    async fn did_rename_files(&self, params: RenameFilesParams) {
        self.letterbox.tell(params, Engine::files_renamed);
    }

    async fn did_create_files(&self, params: CreateFilesParams) {
        self.letterbox.tell(params, Engine::files_created);
    }

    async fn did_delete_files(&self, params: DeleteFilesParams) {
        self.letterbox.tell(params, Engine::files_deleted);
    }

    async fn prepare_rename(
        &self,
        params: TextDocumentPositionParams,
    ) -> Result<Option<PrepareRenameResponse>> {
        self.letterbox.ask(params, Engine::prepare_rename).await
    }

    async fn rename(&self, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
        self.letterbox.ask(params, Engine::rename).await
    }

    async fn references(&self, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
        self.letterbox.ask(params, Engine::references).await
    }

    async fn document_highlight(
        &self,
        params: DocumentHighlightParams,
    ) -> Result<Option<Vec<DocumentHighlight>>> {
        self.letterbox.ask(params, Engine::highlights).await
    }

    async fn semantic_tokens_full(
        &self,
        params: SemanticTokensParams,
    ) -> Result<Option<SemanticTokensResult>> {
        self.letterbox.ask(params, Engine::tokens).await
    }

    async fn semantic_tokens_full_delta(
        &self,
        params: SemanticTokensDeltaParams,
    ) -> Result<Option<SemanticTokensFullDeltaResult>> {
        self.letterbox.ask(params, Engine::tokens_delta).await
    }

    async fn semantic_tokens_range(
        &self,
        params: SemanticTokensRangeParams,
    ) -> Result<Option<SemanticTokensRangeResult>> {
        self.letterbox.ask(params, Engine::tokens_range).await
    }

    async fn document_link(&self, params: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
        self.letterbox.ask(params, Engine::links).await
    }

    async fn inlay_hint(&self, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
        self.letterbox.ask(params, Engine::hints).await
    }

    async fn inlay_hint_resolve(&self, params: InlayHint) -> Result<InlayHint> {
        self.letterbox.ask(params, Engine::resolve_hint).await
    }

    async fn document_color(&self, params: DocumentColorParams) -> Result<Vec<ColorInformation>> {
        self.letterbox.ask(params, Engine::colours).await
    }

    async fn color_presentation(&self, params: ColorPresentationParams) -> Result<Vec<ColorPresentation>> {
        self.letterbox.ask(params, Engine::colour_texts).await
    }

    async fn code_lens(&self, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
        self.letterbox.ask(params, Engine::lenses).await
    }

    async fn code_lens_resolve(&self, params: CodeLens) -> Result<CodeLens> {
        self.letterbox.ask(params, Engine::resolve_lens).await
    }

    async fn prepare_call_hierarchy(
        &self,
        params: CallHierarchyPrepareParams,
    ) -> Result<Option<Vec<CallHierarchyItem>>> {
        self.letterbox.ask(params, Engine::prepare_calls).await
    }

    async fn incoming_calls(
        &self,
        params: CallHierarchyIncomingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
        self.letterbox.ask(params, Engine::incoming_calls).await
    }

    async fn outgoing_calls(
        &self,
        params: CallHierarchyOutgoingCallsParams,
    ) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
        self.letterbox.ask(params, Engine::outgoing_calls).await
    }

    async fn symbol(&self, params: WorkspaceSymbolParams) -> Result<Option<Vec<SymbolInformation>>> {
        self.letterbox.ask(params, Engine::workspace_symbols).await
    }

    async fn execute_command(&self, params: ExecuteCommandParams) -> Result<Option<Value>> {
        self.letterbox.ask(params, Engine::command).await
    }
}
