//! What the client can do.
use lsp_types::{
    CodeActionClientCapabilities, InitializeParams, ResourceOperationKind,
    TextDocumentClientCapabilities, WorkspaceClientCapabilities,
};
use serde_json::Value;

use crate::markup::MarkupFormat;

/// What the client can do.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ResolvedCapabilities {
    /// It asks for diagnostics; they are not pushed then.
    pub pulls_diagnostics: bool,
    /// What it can be told to ask for again.
    pub refresh: RefreshSupport,
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
    /// Which edits it makes.
    pub edits: EditSupport,
    /// Which actions it takes.
    pub actions: ActionSupport,
    /// It asks whether a name can be renamed before it is.
    pub prepares_rename: bool,
    /// It takes symbols that hold others.
    pub nested_symbols: bool,
    /// How many folds it shows, when it says so.
    pub most_folds: Option<usize>,
    /// It takes links with the range they start from.
    pub links: Links,
    /// What it shows while somebody types.
    pub completion: CompletionSupport,
    /// How texts on hover are written.
    pub hover: MarkupFormat,
    /// What it knows of our own protocol.
    pub own: CustomCapabilities,
}

/// What the client can be told to ask for again.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RefreshSupport {
    pub diagnostics: bool,
    pub tokens: bool,
    pub hints: bool,
    pub lenses: bool,
}

/// Which edits the client makes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct EditSupport {
    /// It takes edits with versions.
    pub versions: bool,
    /// It shows what an edit says about itself, and asks before it makes some.
    pub annotations: bool,
    /// It makes files that an edit asks for.
    pub creates_files: bool,
    /// It renames files that an edit asks for.
    pub renames_files: bool,
    /// It makes the edits that the server asks for.
    pub on_request: bool,
}

/// Which actions the client takes: what it says about these means nothing when it takes commands only.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ActionSupport {
    /// It takes actions that say more about themselves than the command to be run.
    pub literals: bool,
    /// It asks for the edits of an action when the action is selected.
    pub resolves: bool,
    /// It shows actions that cannot be made, with the reason.
    pub shows_disabled: bool,
}

/// What the client shows while somebody types.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CompletionSupport {
    /// It fills in the placeholders of snippets.
    pub snippets: bool,
    /// It lets the user choose whether a completion replaces the rest of the word.
    pub insert_replace: bool,
    /// It shows more beside the label of a completion.
    pub label_details: bool,
    /// It takes the ranges of parameters in the label of a signature.
    pub label_offsets: bool,
    /// How the documentation of completions is written.
    pub item_docs: MarkupFormat,
    /// How the documentation of signatures is written.
    pub signature_docs: MarkupFormat,
}

/// Which answers about places a client takes with the range they start from.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Links {
    pub definition: bool,
    pub declaration: bool,
    pub type_definition: bool,
    pub implementation: bool,
}

/// What of our own protocol is sent unasked or stands in answers, for clients that say that they know it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CustomCapabilities {
    /// It takes `xacro/contextChanged`.
    pub context_changed: bool,
    /// It runs the commands of lenses itself.
    pub lens_commands: bool,
    /// It opens `xacro-expanded:`.
    pub expanded_documents: bool,
}

/// A flag that is absent where the client does not know it.
fn is_set(flag: Option<Option<bool>>) -> bool {
    flag.flatten().unwrap_or(false)
}

impl ResolvedCapabilities {
    pub fn of(params: &InitializeParams) -> Self {
        let capabilities = &params.capabilities;
        let workspace = capabilities.workspace.clone().unwrap_or_default();
        let window = capabilities.window.clone().unwrap_or_default();
        let text = capabilities.text_document.clone().unwrap_or_default();
        let hover = text.hover.as_ref();
        let symbols = text.document_symbol.as_ref();
        let folding = text.folding_range.as_ref();
        let watched = workspace.did_change_watched_files.as_ref();
        let settings = workspace.did_change_configuration.as_ref();
        Self {
            pulls_diagnostics: text.diagnostic.is_some()
                && !is_neovim(params)
                && !refuses_to_pull(params),
            refresh: RefreshSupport::of(&workspace),
            configuration: workspace.configuration.unwrap_or(false),
            watches_files: is_set(watched.map(|watched| watched.dynamic_registration)),
            registers_settings: is_set(settings.map(|settings| settings.dynamic_registration)),
            progress: window.work_done_progress.unwrap_or(false),
            shows_documents: window.show_document.is_some_and(|show| show.support),
            edits: EditSupport::of(&workspace),
            actions: text
                .code_action
                .as_ref()
                .map_or_else(ActionSupport::default, ActionSupport::of),
            prepares_rename: is_set(text.rename.as_ref().map(|rename| rename.prepare_support)),
            nested_symbols: is_set(symbols.map(|s| s.hierarchical_document_symbol_support)),
            most_folds: folding
                .and_then(|folding| folding.range_limit)
                .map(|limit| limit as usize),
            links: Links::of(&text),
            completion: CompletionSupport::of(&text),
            hover: MarkupFormat::of(hover.and_then(|hover| hover.content_format.as_ref())),
            own: CustomCapabilities::of(params),
        }
    }

    /// Whether it can do anything with lenses: it runs their commands, or shows what the server tells it to.
    pub fn shows_lenses(&self) -> bool {
        self.own.lens_commands || self.shows_documents
    }
}

impl RefreshSupport {
    fn of(workspace: &WorkspaceClientCapabilities) -> Self {
        let tokens = workspace.semantic_tokens.as_ref();
        Self {
            diagnostics: is_set(workspace.diagnostic.as_ref().map(|d| d.refresh_support)),
            tokens: is_set(tokens.map(|tokens| tokens.refresh_support)),
            hints: is_set(workspace.inlay_hint.as_ref().map(|h| h.refresh_support)),
            lenses: is_set(workspace.code_lens.as_ref().map(|l| l.refresh_support)),
        }
    }
}

impl EditSupport {
    fn of(workspace: &WorkspaceClientCapabilities) -> Self {
        let edit = workspace.workspace_edit.clone().unwrap_or_default();
        let versions = edit.document_changes.unwrap_or(false);
        let operations = edit.resource_operations.as_deref().unwrap_or_default();
        // clients that make files take them in `documentChanges`, whether they check versions or not
        Self {
            versions,
            annotations: versions && edit.change_annotation_support.is_some(),
            creates_files: operations.contains(&ResourceOperationKind::Create),
            renames_files: operations.contains(&ResourceOperationKind::Rename),
            on_request: workspace.apply_edit.unwrap_or(false),
        }
    }
}

impl ActionSupport {
    fn of(action: &CodeActionClientCapabilities) -> Self {
        if action.code_action_literal_support.is_none() {
            return Self::default();
        }
        let resolves_edits = action
            .resolve_support
            .as_ref()
            .is_some_and(|support| support.properties.iter().any(|p| p == "edit"));
        Self {
            literals: true,
            resolves: action.data_support.unwrap_or(false) && resolves_edits,
            shows_disabled: action.disabled_support.unwrap_or(false),
        }
    }
}

impl CompletionSupport {
    fn of(text: &TextDocumentClientCapabilities) -> Self {
        let completion = text.completion.as_ref();
        let item = completion.and_then(|completion| completion.completion_item.as_ref());
        let signature = text
            .signature_help
            .as_ref()
            .and_then(|help| help.signature_information.as_ref());
        let parameter = signature.and_then(|signature| signature.parameter_information.as_ref());
        Self {
            snippets: is_set(item.map(|item| item.snippet_support)),
            insert_replace: is_set(item.map(|item| item.insert_replace_support)),
            label_details: is_set(item.map(|item| item.label_details_support)),
            label_offsets: is_set(parameter.map(|parameter| parameter.label_offset_support)),
            item_docs: MarkupFormat::of(item.and_then(|item| item.documentation_format.as_ref())),
            signature_docs: MarkupFormat::of(
                signature.and_then(|it| it.documentation_format.as_ref()),
            ),
        }
    }
}

impl Links {
    fn of(text: &TextDocumentClientCapabilities) -> Self {
        Self {
            definition: is_set(text.definition.map(|goto| goto.link_support)),
            declaration: is_set(text.declaration.map(|goto| goto.link_support)),
            type_definition: is_set(text.type_definition.map(|goto| goto.link_support)),
            implementation: is_set(text.implementation.map(|goto| goto.link_support)),
        }
    }
}

impl CustomCapabilities {
    /// What a client says below `experimental.xacro` of its capabilities, or below `client` of its options.
    fn of(params: &InitializeParams) -> Self {
        let experimental = params.capabilities.experimental.as_ref();
        let options = options(params).and_then(|options| options.get(CLIENT_OPTIONS));
        let said = [experimental.and_then(|own| own.get("xacro")), options];
        Self {
            context_changed: is_known(said, "contextChanged"),
            lens_commands: is_known(said, "lensCommands"),
            expanded_documents: is_known(said, "expandedDocuments"),
        }
    }
}

/// Whether what a client says of itself names a part of our protocol.
fn is_known(said: [Option<&Value>; 2], what: &str) -> bool {
    said.into_iter()
        .flatten()
        .any(|own| own.get(what) == Some(&Value::Bool(true)))
}

/// Where options say what the client knows; everything else in them is settings.
pub(super) const CLIENT_OPTIONS: &str = "client";

/// The options of `initialize`, without the section around them.
pub(super) fn options(params: &InitializeParams) -> Option<&Value> {
    let options = params.initialization_options.as_ref()?;
    Some(options.get("xacro").unwrap_or(options))
}

/// Neovim asks again for the file that was edited only, also when it is told to ask for all.
fn is_neovim(params: &InitializeParams) -> bool {
    params
        .client_info
        .as_ref()
        .is_some_and(|client| client.name == "Neovim")
}

/// Whether the options say `diagnostics.pull: false`: what is pushed of an edit can be said in two steps.
fn refuses_to_pull(params: &InitializeParams) -> bool {
    options(params)
        .and_then(|own| own.pointer("/diagnostics/pull"))
        .is_some_and(|pull| pull == false)
}
