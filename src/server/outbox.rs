//! What goes out to the client without being asked for: one task, in order.

use std::time::Duration;

use lsp_types::notification::Notification;
use lsp_types::{Diagnostic, MessageType, Range, Registration, ShowDocumentParams, Url};
use serde_json::Value;
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tower_lsp::Client;

use super::engine::Engine;
use super::letterbox::Letterbox;

/// A message to the client.
pub(super) enum Message {
    /// The findings in a file, for the version they were computed for.
    Diagnostics(Url, Vec<Diagnostic>, Option<i32>),
    /// A line for the log.
    Log(MessageType, String),
    /// A line for the user.
    Show(MessageType, String),
    /// Capabilities to be registered.
    Register(Vec<Registration>),
    /// Ask for the settings of each folder (none: of the whole workspace).
    Configuration(Vec<Option<Url>>),
    /// The client should ask again for these.
    Refresh(&'static [Refresh]),
    /// A progress token to be made.
    CreateProgress(String),
    /// A document to be shown to the user.
    ShowDocument(Url, Range),
    /// A notification of our own.
    Custom(&'static str, Value),
}

/// What a client can be told to ask for again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refresh {
    Diagnostics,
    SemanticTokens,
    InlayHints,
    CodeLens,
}

/// Where messages to the client are put.
#[derive(Clone)]
pub(super) struct Outbox(UnboundedSender<Message>);

/// Requests to the client wait no longer than this for an answer.
const PATIENCE: Duration = Duration::from_secs(10);

impl Outbox {
    /// An outbox, and what is to be sent.
    pub fn new() -> (Self, UnboundedReceiver<Message>) {
        let (sender, receiver) = unbounded_channel();
        (Self(sender), receiver)
    }

    /// Send a message.
    pub fn send(&self, message: Message) {
        // the other end is gone only when the process ends
        let _ = self.0.send(message);
    }

    /// Write a line to the client's log.
    pub fn log(&self, text: impl Into<String>) {
        self.send(Message::Log(MessageType::LOG, text.into()));
    }
}

/// Send messages until the process ends.
pub(super) async fn deliver(client: Client, letterbox: Letterbox, mut messages: UnboundedReceiver<Message>) {
    while let Some(message) = messages.recv().await {
        match message {
            Message::Diagnostics(uri, diagnostics, version) => {
                client.publish_diagnostics(uri, diagnostics, version).await;
            }
            Message::Log(kind, text) => client.log_message(kind, text).await,
            Message::Show(kind, text) => client.show_message(kind, text).await,
            Message::Custom(method, params) => custom(&client, method, params).await,
            // what waits for an answer must not hold up what follows
            request => drop(tokio::spawn(ask(client.clone(), letterbox.clone(), request))),
        }
    }
}

async fn ask(client: Client, letterbox: Letterbox, message: Message) {
    let asked = async {
        match message {
            Message::Register(registrations) => drop(client.register_capability(registrations).await),
            Message::Configuration(scopes) => configuration(&client, &letterbox, scopes).await,
            Message::Refresh(what) => refresh(&client, what).await,
            Message::ShowDocument(uri, range) => {
                let selection = Some(range);
                let params = ShowDocumentParams { uri, external: None, take_focus: Some(true), selection };
                let _ = client.show_document(params).await;
            }
            Message::CreateProgress(token) => {
                let token = lsp_types::NumberOrString::String(token);
                let params = lsp_types::WorkDoneProgressCreateParams { token };
                let created = client.send_request::<lsp_types::request::WorkDoneProgressCreate>(params).await;
                letterbox.tell(created.is_ok(), Engine::progress_created);
            }
            _ => {}
        }
    };
    let _ = tokio::time::timeout(PATIENCE, asked).await;
}

async fn configuration(client: &Client, letterbox: &Letterbox, scopes: Vec<Option<Url>>) {
    let items = scopes.iter().map(|scope| lsp_types::ConfigurationItem {
        scope_uri: scope.clone(),
        section: Some("xacro".to_owned()),
    });
    if let Ok(values) = client.configuration(items.collect()).await {
        letterbox.tell((scopes, values), Engine::configured);
    }
}

async fn refresh(client: &Client, what: &[Refresh]) {
    for kind in what {
        let _ = match kind {
            Refresh::Diagnostics => client.workspace_diagnostic_refresh().await,
            Refresh::SemanticTokens => client.semantic_tokens_refresh().await,
            Refresh::InlayHints => client.inlay_hint_refresh().await,
            Refresh::CodeLens => client.code_lens_refresh().await,
        };
    }
}

/// Notifications whose names are known at run time only, as types.
macro_rules! customs {
    ($($name:ident $method:literal,)*) => {
        $(
            enum $name {}
            impl Notification for $name {
                type Params = Value;
                const METHOD: &'static str = $method;
            }
        )*
        async fn custom(client: &Client, method: &str, params: Value) {
            match method {
                $($method => client.send_notification::<$name>(params).await,)*
                _ => {}
            }
        }
    };
}

customs! {
    ContextChanged "xacro/contextChanged",
    PreviewModel "xacro/preview/model",
    PreviewSelect "xacro/preview/select",
    Progress "$/progress",
}
