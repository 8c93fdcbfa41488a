//! What the client can do.

use lsp_types::{
    CodeActionClientCapabilities, CompletionItemCapability, GotoCapability, InitializeParams,
    ResourceOperationKind, TextDocumentClientCapabilities, WorkspaceEditClientCapabilities,
};
use serde_json::Value;

use crate::markup::Format;

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
    /// It makes the edits that the server asks for.
    pub applies_edits: bool,
    /// It takes actions that say more about themselves than the command to be run.
    pub action_literals: bool,
    /// It asks whether a name can be renamed before it is.
    pub prepares_rename: bool,
    /// It takes symbols that hold others.
    pub nested_symbols: bool,
    /// How many folds it shows, when it says so.
    pub most_folds: Option<usize>,
    /// It takes links with the range they start from.
    pub links: Links,
    /// It fills in the places of snippets.
    pub snippets: bool,
    /// It lets the user choose whether a completion replaces the rest of the word.
    pub insert_replace: bool,
    /// It shows more beside the label of a completion.
    pub label_details: bool,
    /// It takes the places of parameters in the label of a signature.
    pub label_offsets: bool,
    /// How texts on hover are written.
    pub hover: Format,
    /// How the documentation of completions is written.
    pub item_docs: Format,
    /// How the documentation of signatures is written.
    pub signature_docs: Format,
    /// What it knows of our own protocol.
    pub own: Own,
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
pub(super) struct Own {
    /// It takes `xacro/contextChanged`.
    pub context_changed: bool,
    /// It runs the commands of lenses itself.
    pub lens_commands: bool,
    /// It opens `xacro-expanded:`.
    pub expanded_documents: bool,
}

impl ClientFacts {
    pub fn of(params: &InitializeParams) -> Self {
        let capabilities = &params.capabilities;
        let workspace = capabilities.workspace.clone().unwrap_or_default();
        let window = capabilities.window.clone().unwrap_or_default();
        let text = capabilities.text_document.clone().unwrap_or_default();
        let yes = |flag: Option<Option<bool>>| flag.flatten().unwrap_or(false);
        let pulls = text.diagnostic.is_some() && !is_neovim(params) && !refuses_to_pull(params);
        let facts = Self {
            pulls_diagnostics: pulls,
            refreshes_diagnostics: yes(workspace.diagnostic.as_ref().map(|d| d.refresh_support)),
            refreshes_tokens: yes(workspace
                .semantic_tokens
                .as_ref()
                .map(|d| d.refresh_support)),
            refreshes_hints: yes(workspace.inlay_hint.as_ref().map(|d| d.refresh_support)),
            refreshes_lenses: yes(workspace.code_lens.as_ref().map(|d| d.refresh_support)),
            configuration: workspace.configuration.unwrap_or(false),
            watches_files: yes(workspace
                .did_change_watched_files
                .as_ref()
                .map(|w| w.dynamic_registration)),
            registers_settings: yes(workspace
                .did_change_configuration
                .as_ref()
                .map(|w| w.dynamic_registration)),
            progress: window.work_done_progress.unwrap_or(false),
            shows_documents: window.show_document.is_some_and(|show| show.support),
            applies_edits: workspace.apply_edit.unwrap_or(false),
            own: Own::of(params),
            ..Self::default()
        };
        let edit = workspace.workspace_edit.unwrap_or_default();
        facts
            .about_edits(&edit)
            .about_typing(&text)
            .about_text(&text)
            .about_actions(text.code_action)
    }

    /// Whether it can do anything with lenses: it runs their commands, or shows what the server tells it to.
    pub fn shows_lenses(&self) -> bool {
        self.own.lens_commands || self.shows_documents
    }

    /// What kinds of edits it makes.
    fn about_edits(self, edit: &WorkspaceEditClientCapabilities) -> Self {
        let versions = edit.document_changes.unwrap_or(false);
        let operations = edit.resource_operations.as_deref().unwrap_or_default();
        let operation = |kind| versions && operations.contains(&kind);
        Self {
            document_changes: versions,
            change_annotations: versions && edit.change_annotation_support.is_some(),
            creates_files: operation(ResourceOperationKind::Create),
            renames_files: operation(ResourceOperationKind::Rename),
            ..self
        }
    }

    /// What it shows while somebody types.
    fn about_typing(self, text: &TextDocumentClientCapabilities) -> Self {
        let item = text
            .completion
            .as_ref()
            .and_then(|completion| completion.completion_item.as_ref());
        let has = |flag: fn(&CompletionItemCapability) -> Option<bool>| {
            item.and_then(flag).unwrap_or(false)
        };
        let signature = text
            .signature_help
            .as_ref()
            .and_then(|help| help.signature_information.as_ref());
        let parameter = signature.and_then(|signature| signature.parameter_information.as_ref());
        Self {
            snippets: has(|item| item.snippet_support),
            insert_replace: has(|item| item.insert_replace_support),
            label_details: has(|item| item.label_details_support),
            label_offsets: parameter
                .and_then(|p| p.label_offset_support)
                .unwrap_or(false),
            item_docs: Format::of(item.and_then(|item| item.documentation_format.as_ref())),
            signature_docs: Format::of(signature.and_then(|it| it.documentation_format.as_ref())),
            ..self
        }
    }

    /// In which forms it takes what is said of a text.
    fn about_text(self, text: &TextDocumentClientCapabilities) -> Self {
        let links =
            |goto: Option<GotoCapability>| goto.and_then(|goto| goto.link_support).unwrap_or(false);
        let symbols = text.document_symbol.as_ref();
        let folds = text
            .folding_range
            .as_ref()
            .and_then(|folding| folding.range_limit);
        Self {
            hover: Format::of(
                text.hover
                    .as_ref()
                    .and_then(|hover| hover.content_format.as_ref()),
            ),
            links: Links {
                definition: links(text.definition),
                declaration: links(text.declaration),
                type_definition: links(text.type_definition),
                implementation: links(text.implementation),
            },
            nested_symbols: symbols
                .and_then(|s| s.hierarchical_document_symbol_support)
                .unwrap_or(false),
            most_folds: folds.map(|limit| limit as usize),
            prepares_rename: text
                .rename
                .as_ref()
                .and_then(|rename| rename.prepare_support)
                .unwrap_or(false),
            ..self
        }
    }

    /// Which actions it takes: what it says about these means nothing when it takes commands only.
    fn about_actions(self, action: Option<CodeActionClientCapabilities>) -> Self {
        let Some(action) = action.filter(|action| action.code_action_literal_support.is_some())
        else {
            return self;
        };
        Self {
            action_literals: true,
            resolves_actions: action.data_support.unwrap_or(false)
                && action
                    .resolve_support
                    .is_some_and(|s| s.properties.iter().any(|p| p == "edit")),
            disabled_actions: action.disabled_support.unwrap_or(false),
            ..self
        }
    }
}

impl Own {
    /// What a client says below `experimental.xacro` of its capabilities, or below `client` of its options.
    fn of(params: &InitializeParams) -> Self {
        let experimental = params.capabilities.experimental.as_ref();
        let options = options(params).and_then(|options| options.get(CLIENT_OPTIONS));
        let said = [experimental.and_then(|own| own.get("xacro")), options];
        let knows = |what: &str| {
            said.into_iter()
                .flatten()
                .any(|own| own.get(what) == Some(&Value::Bool(true)))
        };
        Self {
            context_changed: knows("contextChanged"),
            lens_commands: knows("lensCommands"),
            expanded_documents: knows("expandedDocuments"),
        }
    }
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
