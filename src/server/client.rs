//! What the client can do.

use lsp_types::{InitializeParams, ResourceOperationKind};

/// What the client can do.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ClientFacts {
    /// It asks for diagnostics; they are not pushed then.
    pub pulls_diagnostics: bool,
    /// It can be told to ask for diagnostics again.
    pub refreshes_diagnostics: bool,
    pub refreshes_tokens: bool,
    pub refreshes_hints: bool,
    pub refreshes_lenses: bool,
    /// It answers `workspace/configuration`.
    pub configuration: bool,
    /// It watches files when asked to.
    pub watches_files: bool,
    /// It tells of settings when asked to.
    pub registers_settings: bool,
    /// It shows progress.
    pub progress: bool,
    /// It shows a document when asked to.
    pub shows_documents: bool,
    /// It takes edits with versions.
    pub document_changes: bool,
    /// It shows what an edit says about itself, and asks before it makes some.
    pub change_annotations: bool,
    /// It asks for the edits of an action when the action is picked.
    pub resolves_actions: bool,
    /// It shows actions that cannot be made, with the reason.
    pub disabled_actions: bool,
    /// It makes files that an edit asks for.
    pub creates_files: bool,
    /// It renames files that an edit asks for.
    pub renames_files: bool,
    /// It takes links with the range they start from.
    pub links: bool,
    /// It fills in the places of snippets.
    pub snippets: bool,
    /// It lets the user choose whether a completion replaces the rest of the word.
    pub insert_replace: bool,
    /// It shows more beside the label of a completion.
    pub label_details: bool,
    /// It takes the places of parameters in the label of a signature.
    pub label_offsets: bool,
}

impl ClientFacts {
    pub fn of(params: &InitializeParams) -> Self {
        let capabilities = &params.capabilities;
        let workspace = capabilities.workspace.clone().unwrap_or_default();
        let text = capabilities.text_document.clone().unwrap_or_default();
        let item = text.completion.as_ref().and_then(|completion| completion.completion_item.clone());
        let item = item.unwrap_or_default();
        let signature = text.signature_help.as_ref().and_then(|help| help.signature_information.clone());
        let parameter = signature.and_then(|signature| signature.parameter_information);
        let action = text.code_action.clone().unwrap_or_default();
        let yes = |flag: Option<Option<bool>>| flag.flatten().unwrap_or(false);
        let edit = workspace.workspace_edit.clone().unwrap_or_default();
        let operations = edit.resource_operations.unwrap_or_default();
        let versions = edit.document_changes.unwrap_or(false);
        let operation = |kind| versions && operations.contains(&kind);
        Self {
            pulls_diagnostics: text.diagnostic.is_some() && !is_neovim(params) && !refuses_to_pull(params),
            refreshes_diagnostics: yes(workspace.diagnostic.as_ref().map(|d| d.refresh_support)),
            refreshes_tokens: yes(workspace.semantic_tokens.as_ref().map(|d| d.refresh_support)),
            refreshes_hints: yes(workspace.inlay_hint.as_ref().map(|d| d.refresh_support)),
            refreshes_lenses: yes(workspace.code_lens.as_ref().map(|d| d.refresh_support)),
            configuration: workspace.configuration.unwrap_or(false),
            watches_files: yes(workspace.did_change_watched_files.as_ref().map(|w| w.dynamic_registration)),
            registers_settings: yes(workspace
                .did_change_configuration
                .as_ref()
                .map(|w| w.dynamic_registration)),
            progress: capabilities.window.as_ref().and_then(|w| w.work_done_progress).unwrap_or(false),
            shows_documents: capabilities
                .window
                .as_ref()
                .and_then(|window| window.show_document.as_ref())
                .is_some_and(|show| show.support),
            document_changes: yes(workspace.workspace_edit.as_ref().map(|e| e.document_changes)),
            change_annotations: versions && edit.change_annotation_support.is_some(),
            resolves_actions: action.data_support.unwrap_or(false)
                && action.resolve_support.is_some_and(|s| s.properties.iter().any(|p| p == "edit")),
            disabled_actions: action.disabled_support.unwrap_or(false),
            creates_files: operation(ResourceOperationKind::Create),
            renames_files: operation(ResourceOperationKind::Rename),
            links: text.definition.as_ref().and_then(|d| d.link_support).unwrap_or(false),
            snippets: item.snippet_support.unwrap_or(false),
            insert_replace: item.insert_replace_support.unwrap_or(false),
            label_details: item.label_details_support.unwrap_or(false),
            label_offsets: parameter.and_then(|p| p.label_offset_support).unwrap_or(false),
        }
    }
}

/// Neovim asks again for the file that was edited only, also when it is told to ask for all.
fn is_neovim(params: &InitializeParams) -> bool {
    params.client_info.as_ref().is_some_and(|client| client.name == "Neovim")
}

/// Whether the options say `diagnostics.pull: false`: what is pushed of an edit can be said in two steps.
fn refuses_to_pull(params: &InitializeParams) -> bool {
    let options = params.initialization_options.as_ref();
    let own = options.map(|options| options.get("xacro").unwrap_or(options));
    own.and_then(|own| own.pointer("/diagnostics/pull")).is_some_and(|pull| pull == false)
}
