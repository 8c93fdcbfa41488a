//! What goes out to the client without being asked for.
//!
//! Notifications are written as they are: made into bytes once, by who sends them. Requests go through tower-lsp, which
//! assigns the replies to them.
use lsp_types::notification::{LogMessage, Notification, ShowMessage};
use lsp_types::{
    LogMessageParams, MessageType, Range, Registration, ShowMessageParams, Url, WorkspaceEdit,
};
use serde::Serialize;
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

/// A request to the client.
pub(super) enum ClientRequest {
    /// Capabilities to be registered.
    Register(Vec<Registration>),
    /// Ask for the settings of each folder (none: of the whole workspace).
    Configuration(Vec<Option<Url>>),
    /// The client should ask again for these.
    Refresh(&'static [Refresh]),
    /// A progress token to be made.
    CreateProgress(String),
    /// A document to be shown to the user.
    #[cfg_attr(
        not(feature = "preview"),
        allow(dead_code, reason = "asked for by the preview in a browser")
    )]
    ShowDocument(Url, Range),
    /// A page to be shown outside of the editor.
    #[cfg_attr(
        not(feature = "preview"),
        allow(dead_code, reason = "asked for by the preview in a browser")
    )]
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
    requests: UnboundedSender<ClientRequest>,
}

impl Outbox {
    /// An outbox, the notifications to be written, and the requests to be made.
    pub fn new() -> (
        Self,
        UnboundedReceiver<Vec<u8>>,
        UnboundedReceiver<ClientRequest>,
    ) {
        let (notifications, written) = unbounded_channel();
        let (requests, asked) = unbounded_channel();
        (
            Self {
                notifications,
                requests,
            },
            written,
            asked,
        )
    }

    /// Send a notification.
    pub fn notify(&self, method: &str, params: &impl Serialize) {
        self.notify_encoded(notification(method, params));
    }

    /// Send a notification that is JSON already.
    pub fn notify_encoded(&self, notification: Vec<u8>) {
        let _ = self.notifications.send(notification);
    }

    /// Send a request.
    pub fn request(&self, request: ClientRequest) {
        let _ = self.requests.send(request);
    }

    /// Write a line to the client's log.
    pub fn log(&self, message: impl Into<String>) {
        self.log_as(MessageType::LOG, message);
    }

    /// Write a line of some weight to the client's log.
    pub fn log_as(&self, typ: MessageType, message: impl Into<String>) {
        self.notify(
            LogMessage::METHOD,
            &LogMessageParams {
                typ,
                message: message.into(),
            },
        );
    }

    /// Show the user a line.
    pub fn show(&self, typ: MessageType, message: impl Into<String>) {
        self.notify(
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
