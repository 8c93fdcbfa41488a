//! What goes out to the client without being asked for.
//!
//! Notifications are written as they are: made into bytes once, by who sends them. Requests go through tower-lsp, which
//! knows whose the replies are.

use crate::lifecycle::{configured, progress_created};
use std::collections::HashMap;
use std::time::Duration;

use lsp_types::notification::{LogMessage, Notification, ShowMessage};
use lsp_types::{
    LogMessageParams, MessageActionItem, MessageType, Range, Registration, ShowDocumentParams,
    ShowMessageParams, Url, WorkspaceEdit,
};
use serde::Serialize;
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tower_lsp::Client;

use crate::framing::framed;
use crate::queue::Queue;

/// A request to the client.
pub(super) enum Question {
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
    /// A page to be shown outside of the editor.
    ShowPage(Url),
    /// Edits to be made.
    ApplyEdit(Box<WorkspaceEdit>),
    /// A message with the offer to show a document.
    Offer {
        message: String,
        action: &'static str,
        uri: Url,
    },
}

/// What a client can be told to ask for again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refresh {
    Diagnostics,
    SemanticTokens,
    InlayHints,
    CodeLens,
}

/// Where messages to the client are put. The other ends are gone only when the process ends.
#[derive(Clone)]
pub(super) struct Outbox {
    notifications: UnboundedSender<Vec<u8>>,
    questions: UnboundedSender<Question>,
}

/// Requests to the client wait no longer than this for an answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// Requests that the user answers wait longer.
const PATIENCE_WITH_USERS: Duration = Duration::from_secs(600);

impl Outbox {
    /// An outbox, the notifications to be written, and the requests to be made.
    pub fn new() -> (
        Self,
        UnboundedReceiver<Vec<u8>>,
        UnboundedReceiver<Question>,
    ) {
        let (notifications, written) = unbounded_channel();
        let (questions, asked) = unbounded_channel();
        (
            Self {
                notifications,
                questions,
            },
            written,
            asked,
        )
    }

    /// Send a notification.
    pub fn tell(&self, method: &str, params: &impl Serialize) {
        self.tell_encoded(&notification(method, params));
    }

    /// Send a notification that is JSON already.
    pub fn tell_encoded(&self, notification: &[u8]) {
        let _ = self.notifications.send(framed(notification));
    }

    /// Send a request.
    pub fn ask(&self, question: Question) {
        let _ = self.questions.send(question);
    }

    /// Write a line to the client's log.
    pub fn log(&self, message: impl Into<String>) {
        self.log_as(MessageType::LOG, message);
    }

    /// Write a line of some weight to the client's log.
    pub fn log_as(&self, typ: MessageType, message: impl Into<String>) {
        self.tell(
            LogMessage::METHOD,
            &LogMessageParams {
                typ,
                message: message.into(),
            },
        );
    }

    /// Show the user a line.
    pub fn show(&self, typ: MessageType, message: impl Into<String>) {
        self.tell(
            ShowMessage::METHOD,
            &ShowMessageParams {
                typ,
                message: message.into(),
            },
        );
    }
}

/// A notification as JSON.
pub(super) fn notification(method: &str, params: &impl Serialize) -> Vec<u8> {
    #[derive(Serialize)]
    struct Message<'a, P> {
        jsonrpc: &'a str,
        method: &'a str,
        params: &'a P,
    }
    serde_json::to_vec(&Message {
        jsonrpc: "2.0",
        method,
        params,
    })
    .unwrap_or_default()
}

/// Send requests until the process ends. What waits for an answer does not hold up what follows.
pub(super) async fn ask_all(
    client: Client,
    queue: Queue,
    mut questions: UnboundedReceiver<Question>,
) {
    while let Some(question) = questions.recv().await {
        let patience = match question {
            Question::Offer { .. } => PATIENCE_WITH_USERS,
            _ => PATIENCE,
        };
        let asked = ask(client.clone(), queue.clone(), question);
        drop(tokio::spawn(tokio::time::timeout(patience, asked)));
    }
}

async fn ask(client: Client, queue: Queue, question: Question) {
    match question {
        Question::Register(registrations) => drop(client.register_capability(registrations).await),
        Question::Configuration(scopes) => configuration(&client, &queue, scopes).await,
        Question::Refresh(what) => refresh(&client, what).await,
        Question::ShowDocument(uri, range) => {
            let selection = Some(range);
            let params = ShowDocumentParams {
                uri,
                external: None,
                take_focus: Some(true),
                selection,
            };
            let _ = client.show_document(params).await;
        }
        Question::ShowPage(uri) => {
            let external = Some(true);
            let params = ShowDocumentParams {
                uri,
                external,
                take_focus: None,
                selection: None,
            };
            let _ = client.show_document(params).await;
        }
        Question::Offer {
            message,
            action,
            uri,
        } => {
            let item = MessageActionItem {
                title: action.to_owned(),
                properties: HashMap::new(),
            };
            let chosen = client
                .show_message_request(MessageType::INFO, message, Some(vec![item]))
                .await;
            if let Ok(Some(_)) = chosen {
                let params = ShowDocumentParams {
                    uri,
                    external: None,
                    take_focus: Some(true),
                    selection: None,
                };
                let _ = client.show_document(params).await;
            }
        }
        Question::ApplyEdit(edit) => drop(client.apply_edit(*edit).await),
        Question::CreateProgress(token) => {
            let token = lsp_types::NumberOrString::String(token);
            let params = lsp_types::WorkDoneProgressCreateParams { token };
            let created = client
                .send_request::<lsp_types::request::WorkDoneProgressCreate>(params)
                .await;
            queue.notify(created.is_ok(), progress_created);
        }
    }
}

async fn configuration(client: &Client, queue: &Queue, scopes: Vec<Option<Url>>) {
    let items = scopes.iter().map(|scope| lsp_types::ConfigurationItem {
        scope_uri: scope.clone(),
        section: Some("xacro".to_owned()),
    });
    if let Ok(values) = client.configuration(items.collect()).await {
        queue.notify((scopes, values), configured);
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
