//! Everything that can happen to the server, in one place.
//!
//! The messages of the protocol are a table. A row of it names the event, the method of the service that adds it to
//! the queue, the parameters, the answer, and behind `=>` the function that the analysis thread calls for it. The
//! macro makes of the rows the types of the events, what adds them, and what calls the functions.
use lsp_types::*;
use serde_json::Value;
use tower_lsp::jsonrpc::Result;
use tower_lsp::{Client, ClientSocket, LanguageServer, LspService, async_trait};

use crate::documents::{bad_message, changed, closed, folders_changed, opened, saved, watched};
use crate::files::{files_created, files_deleted, files_renamed, will_rename_files};
use crate::framing;
use crate::lifecycle::{client_ready, initialize, last_lines, set_trace};
use crate::preview::{
    MeshData, MeshParams, SelectParams, ShowParams, SubscribeParams, Subscribed, ViewParams,
    preview_mesh, preview_urdf, selected, show_root, subscribe, unsubscribe,
};
use crate::queue::{Queue, Reply, reply};
use crate::requests::actions::actions;
use crate::requests::calls::{incoming_calls, outgoing_calls, prepare_calls};
use crate::requests::colors::{color_texts, colors};
use crate::requests::commands::command;
use crate::requests::completion::{completion, on_type, resolve_completion, signature_help};
use crate::requests::expand_at::{
    ExpandAtParams, ExpandedLocation, SetInstanceParams, expand_at, set_instance,
};
use crate::requests::expansion::{ExpandParams, ExpandedDocument, expand};
use crate::requests::formatting::{format, format_range};
use crate::requests::hints::{hints, resolve_hint};
use crate::requests::hover::hover;
use crate::requests::lenses::{lenses, resolve_lens};
use crate::requests::links::links;
use crate::requests::mapping::{
    Instances, SourceLocations, ToExpandedParams, ToSourceParams, instances_of, sources_of,
};
use crate::requests::navigation::{
    declaration, definition, highlights, implementation, type_definition,
};
use crate::requests::of_description::of_description;
use crate::requests::pull::{pull_diagnostics, pull_workspace};
use crate::requests::refactorings::resolve_action;
use crate::requests::references::references;
use crate::requests::rename::{prepare_rename, rename};
use crate::requests::roots::{
    FileRoots, RobotTree, RootsParams, SetRootParams, TreeParams, roots, set_root, tree,
};
use crate::requests::structure::{folding, linked_editing, selections, symbols};
use crate::requests::tokens::{tokens, tokens_delta, tokens_range};
use crate::requests::workspace_symbols::workspace_symbols;
use crate::settings::settings_changed;
use crate::state::ServerState;

/// What the analysis thread is told, one after the other.
pub(super) enum Event {
    /// The client asks.
    Request(IncomingRequest),
    /// The client tells.
    Notification(Notification),
    /// The client has answered a request of ours.
    ClientReply(ClientReply),
    /// A page of the preview says something.
    #[cfg(feature = "preview")]
    Viewer(preview::Received),
    /// Nobody has said anything for so long that other work is due.
    Idle,
}

/// Answers of the client that something follows from.
pub(super) enum ClientReply {
    /// Whether it made the token for the progress of the scan.
    ProgressCreated(bool),
    /// Settings by the folders that they were asked for.
    Settings(Vec<Option<Url>>, Vec<Value>),
}

/// The protocol side of the server: it adds events, and waits for answers. Nothing else happens here.
pub(super) struct Handlers {
    pub queue: Queue<Event>,
}

impl Handlers {
    async fn ask<P, R>(
        &self,
        params: P,
        request: fn(Box<P>, Reply<R>) -> IncomingRequest,
    ) -> Result<R> {
        let (reply, waiting) = reply();
        let request = request(Box::new(params), reply);
        self.queue.send(Event::Request(request));
        waiting.answer().await
    }

    fn tell(&self, notification: Notification) {
        self.queue.send(Event::Notification(notification));
    }
}

/// What pages of the preview say becomes events.
#[cfg(feature = "preview")]
pub(super) fn from_pages(state: &mut ServerState, queue: Queue<Event>) {
    let add = move |received| queue.send(Event::Viewer(received));
    state.previews.from_pages = Some(std::sync::Arc::new(add));
}

macro_rules! messages {
    (
        requests { $($ask:ident: $asking:ident($asked:ty) -> $answer:ty => $work:expr;)+ }
        notifications { $($tell:ident: $telling:ident($told:ty) => $taken:expr;)+ }
        own requests {
            $($(#[$if:meta])* $own_ask:ident: $ask_method:expr, $own_asking:ident($own_asked:ty) -> $own_answer:ty
                => $own_work:expr;)+
        }
        own notifications {
            $($own_tell:ident: $tell_method:expr, $own_telling:ident($own_told:ty) => $own_taken:expr;)+
        }
    ) => {
        /// What the client asks, with the way back of the answer.
        pub(super) enum IncomingRequest {
            $($ask(Box<$asked>, Reply<$answer>),)+
            $($(#[$if])* $own_ask(Box<$own_asked>, Reply<$own_answer>),)+
        }

        impl IncomingRequest {
            /// Answer it.
            pub fn answer(self, state: &mut ServerState) {
                match self {
                    $(Self::$ask(params, reply) => reply.answer(|cancel| $work(state, *params, cancel)),)+
                    $($(#[$if])* Self::$own_ask(params, reply) => {
                        reply.answer(|cancel| $own_work(state, *params, cancel));
                    })+
                }
            }
        }

        /// What the client tells.
        pub(super) enum Notification {
            $($tell($told),)+
            $($own_tell($own_told),)+
        }

        impl Notification {
            /// Do what follows from it.
            pub fn take(self, state: &mut ServerState) {
                match self {
                    $(Self::$tell(params) => $taken(state, params),)+
                    $(Self::$own_tell(params) => $own_taken(state, params),)+
                }
            }
        }

        #[async_trait]
        impl LanguageServer for Handlers {
            $(async fn $asking(&self, params: $asked) -> Result<$answer> {
                self.ask(params, IncomingRequest::$ask).await
            })+

            $(async fn $telling(&self, params: $told) {
                self.tell(Notification::$tell(params));
            })+

            async fn shutdown(&self) -> Result<()> {
                Ok(())
            }
        }

        impl Handlers {
            $($(#[$if])* async fn $own_asking(&self, params: $own_asked) -> Result<$own_answer> {
                self.ask(params, IncomingRequest::$own_ask).await
            })+

            $(async fn $own_telling(&self, params: $own_told) {
                self.tell(Notification::$own_tell(params));
            })+
        }

        /// The protocol around handlers.
        pub(super) fn service(
            handlers: impl FnOnce(Client) -> Handlers,
        ) -> (LspService<Handlers>, ClientSocket) {
            let service = LspService::build(handlers);
            $($(#[$if])* let service = service.custom_method($ask_method, Handlers::$own_asking);)+
            $(let service = service.custom_method($tell_method, Handlers::$own_telling);)+
            service.finish()
        }
    };
}

messages! {
    requests {
        Initialize: initialize(InitializeParams) -> InitializeResult => initialize;
        WillRenameFiles: will_rename_files(RenameFilesParams) -> Option<WorkspaceEdit> => will_rename_files;
        Diagnostics: diagnostic(DocumentDiagnosticParams) -> DocumentDiagnosticReportResult => pull_diagnostics;
        WorkspaceDiagnostics: workspace_diagnostic(WorkspaceDiagnosticParams) -> WorkspaceDiagnosticReportResult
            => pull_workspace;
        Completion: completion(CompletionParams) -> Option<CompletionResponse> => completion;
        ResolveCompletion: completion_resolve(CompletionItem) -> CompletionItem => resolve_completion;
        SignatureHelp: signature_help(SignatureHelpParams) -> Option<SignatureHelp> => of_description(signature_help);
        Hover: hover(HoverParams) -> Option<Hover> => hover;
        Actions: code_action(CodeActionParams) -> Option<CodeActionResponse> => of_description(actions);
        ResolveAction: code_action_resolve(CodeAction) -> CodeAction => resolve_action;
        Format: formatting(DocumentFormattingParams) -> Option<Vec<TextEdit>> => of_description(format);
        FormatRange: range_formatting(DocumentRangeFormattingParams) -> Option<Vec<TextEdit>>
            => of_description(format_range);
        OnType: on_type_formatting(DocumentOnTypeFormattingParams) -> Option<Vec<TextEdit>> => of_description(on_type);
        Symbols: document_symbol(DocumentSymbolParams) -> Option<DocumentSymbolResponse> => of_description(symbols);
        Folding: folding_range(FoldingRangeParams) -> Option<Vec<FoldingRange>> => of_description(folding);
        Selections: selection_range(SelectionRangeParams) -> Option<Vec<SelectionRange>> => of_description(selections);
        LinkedEditing: linked_editing_range(LinkedEditingRangeParams) -> Option<LinkedEditingRanges>
            => of_description(linked_editing);
        Definition: goto_definition(GotoDefinitionParams) -> Option<GotoDefinitionResponse> => definition;
        Declaration: goto_declaration(GotoDefinitionParams) -> Option<GotoDefinitionResponse>
            => of_description(declaration);
        TypeDefinition: goto_type_definition(GotoDefinitionParams) -> Option<GotoDefinitionResponse>
            => of_description(type_definition);
        Implementation: goto_implementation(GotoDefinitionParams) -> Option<GotoDefinitionResponse>
            => of_description(implementation);
        References: references(ReferenceParams) -> Option<Vec<Location>> => references;
        Highlights: document_highlight(DocumentHighlightParams) -> Option<Vec<DocumentHighlight>> => highlights;
        PrepareRename: prepare_rename(TextDocumentPositionParams) -> Option<PrepareRenameResponse> => prepare_rename;
        Rename: rename(RenameParams) -> Option<WorkspaceEdit> => rename;
        Tokens: semantic_tokens_full(SemanticTokensParams) -> Option<SemanticTokensResult> => of_description(tokens);
        TokensDelta: semantic_tokens_full_delta(SemanticTokensDeltaParams) -> Option<SemanticTokensFullDeltaResult>
            => of_description(tokens_delta);
        TokensRange: semantic_tokens_range(SemanticTokensRangeParams) -> Option<SemanticTokensRangeResult>
            => of_description(tokens_range);
        Links: document_link(DocumentLinkParams) -> Option<Vec<DocumentLink>> => of_description(links);
        Hints: inlay_hint(InlayHintParams) -> Option<Vec<InlayHint>> => of_description(hints);
        ResolveHint: inlay_hint_resolve(InlayHint) -> InlayHint => resolve_hint;
        Colors: document_color(DocumentColorParams) -> Vec<ColorInformation> => of_description(colors);
        ColorTexts: color_presentation(ColorPresentationParams) -> Vec<ColorPresentation> => color_texts;
        Lenses: code_lens(CodeLensParams) -> Option<Vec<CodeLens>> => of_description(lenses);
        ResolveLens: code_lens_resolve(CodeLens) -> CodeLens => resolve_lens;
        PrepareCalls: prepare_call_hierarchy(CallHierarchyPrepareParams) -> Option<Vec<CallHierarchyItem>>
            => of_description(prepare_calls);
        IncomingCalls: incoming_calls(CallHierarchyIncomingCallsParams) -> Option<Vec<CallHierarchyIncomingCall>>
            => incoming_calls;
        OutgoingCalls: outgoing_calls(CallHierarchyOutgoingCallsParams) -> Option<Vec<CallHierarchyOutgoingCall>>
            => outgoing_calls;
        WorkspaceSymbols: symbol(WorkspaceSymbolParams) -> Option<Vec<SymbolInformation>> => workspace_symbols;
        Command: execute_command(ExecuteCommandParams) -> Option<Value> => command;
    }
    notifications {
        Initialized: initialized(InitializedParams) => client_ready;
        Opened: did_open(DidOpenTextDocumentParams) => opened;
        Changed: did_change(DidChangeTextDocumentParams) => changed;
        Saved: did_save(DidSaveTextDocumentParams) => saved;
        Closed: did_close(DidCloseTextDocumentParams) => closed;
        FilesCreated: did_create_files(CreateFilesParams) => files_created;
        FilesRenamed: did_rename_files(RenameFilesParams) => files_renamed;
        FilesDeleted: did_delete_files(DeleteFilesParams) => files_deleted;
        FilesWatched: did_change_watched_files(DidChangeWatchedFilesParams) => watched;
        FoldersChanged: did_change_workspace_folders(DidChangeWorkspaceFoldersParams) => folders_changed;
        SettingsChanged: did_change_configuration(DidChangeConfigurationParams) => settings_changed;
    }
    own requests {
        Expand: "xacro/expand", expand(ExpandParams) -> ExpandedDocument => expand;
        ExpandAt: "xacro/expandAt", expand_at(ExpandAtParams) -> Option<ExpandedLocation> => expand_at;
        SetInstance: "xacro/setInstance", set_instance(SetInstanceParams) -> Value => set_instance;
        ToSource: "xacro/toSource", to_source(ToSourceParams) -> SourceLocations => sources_of;
        ToExpanded: "xacro/toExpanded", to_expanded(ToExpandedParams) -> Instances => instances_of;
        FileRoots: "xacro/roots", roots(RootsParams) -> FileRoots => roots;
        SetRoot: "xacro/setRoot", set_root(SetRootParams) -> Value => set_root;
        RobotTree: "xacro/tree", tree(TreeParams) -> RobotTree => tree;
        Subscribe: "xacro/preview/subscribe", preview_subscribe(SubscribeParams) -> Subscribed => subscribe;
        Unsubscribe: "xacro/preview/unsubscribe", preview_unsubscribe(ViewParams) -> Value => unsubscribe;
        ShowRoot: "xacro/preview/setRoot", preview_root(ShowParams) -> Value => show_root;
        MeshData: "xacro/preview/mesh", preview_mesh(MeshParams) -> MeshData => preview_mesh;
        Urdf: "xacro/preview/urdf", preview_urdf(ViewParams) -> Value => preview_urdf;
        LastLines: "xacro/log", log(Value) -> Vec<String> => last_lines;
        // not in what users run
        #[cfg(debug_assertions)]
        Fail: "xacro/debug/fail", fail(Value) -> Value => crate::lifecycle::fail;
    }
    own notifications {
        Selected: "xacro/preview/select", preview_select(SelectParams) => selected;
        SetTrace: "$/setTrace", set_trace(SetTraceParams) => set_trace;
        BadMessage: framing::BAD_MESSAGE, bad_message(Value) => bad_message;
    }
}
