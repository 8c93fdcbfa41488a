//! Requests to the client, and what its answers lead to.
use std::collections::HashMap;
use std::time::Duration;

use futures_util::future::BoxFuture;
use lsp_types::{MessageActionItem, MessageType, ShowDocumentParams, Url};
use tokio::sync::mpsc::UnboundedReceiver;
use tower_lsp::Client;

use crate::events::{ClientReply, Event};
use crate::outbox::{ClientRequest, Refresh};
use crate::queue::Queue;

/// Requests to the client wait no longer than this for an answer.
const CLIENT_TIMEOUT: Duration = Duration::from_secs(10);

/// Requests that the user answers wait longer.
const USER_TIMEOUT: Duration = Duration::from_secs(600);

/// Send requests until the process ends. What waits for an answer does not hold up what follows: `start` runs it beside,
/// for as long as it says.
pub(super) async fn run_client_requests(
    client: Client,
    queue: Queue<Event>,
    mut requests: UnboundedReceiver<ClientRequest>,
    start: impl Fn(BoxFuture<'static, ()>, Duration),
) {
    while let Some(request) = requests.recv().await {
        let timeout = match request {
            ClientRequest::Offer { .. } => USER_TIMEOUT,
            _ => CLIENT_TIMEOUT,
        };
        let asked = run(client.clone(), queue.clone(), request);
        start(Box::pin(asked), timeout);
    }
}

async fn run(client: Client, queue: Queue<Event>, request: ClientRequest) {
    match request {
        ClientRequest::Register(registrations) => {
            drop(client.register_capability(registrations).await)
        }
        ClientRequest::Configuration(scopes) => configuration(&client, &queue, scopes).await,
        ClientRequest::Refresh(what) => send_refresh(&client, what).await,
        ClientRequest::ShowDocument(uri, range) => {
            let selection = Some(range);
            let params = ShowDocumentParams {
                uri,
                external: None,
                take_focus: Some(true),
                selection,
            };
            let _ = client.show_document(params).await;
        }
        ClientRequest::ShowPage(uri) => {
            let external = Some(true);
            let params = ShowDocumentParams {
                uri,
                external,
                take_focus: None,
                selection: None,
            };
            let _ = client.show_document(params).await;
        }
        ClientRequest::Offer {
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
        ClientRequest::ApplyEdit(edit) => drop(client.apply_edit(*edit).await),
        ClientRequest::CreateProgress(token) => {
            let token = lsp_types::NumberOrString::String(token);
            let params = lsp_types::WorkDoneProgressCreateParams { token };
            let created = client
                .send_request::<lsp_types::request::WorkDoneProgressCreate>(params)
                .await;
            queue.send(Event::ClientReply(ClientReply::ProgressCreated(
                created.is_ok(),
            )));
        }
    }
}

pub(super) async fn configuration(client: &Client, queue: &Queue<Event>, scopes: Vec<Option<Url>>) {
    let items = scopes.iter().map(|scope| lsp_types::ConfigurationItem {
        scope_uri: scope.clone(),
        section: Some("xacro".to_owned()),
    });
    if let Ok(values) = client.configuration(items.collect()).await {
        queue.send(Event::ClientReply(ClientReply::Settings(scopes, values)));
    }
}

async fn send_refresh(client: &Client, what: &[Refresh]) {
    for kind in what {
        let _ = match kind {
            Refresh::Diagnostics => client.workspace_diagnostic_refresh().await,
            Refresh::SemanticTokens => client.semantic_tokens_refresh().await,
            Refresh::InlayHints => client.inlay_hint_refresh().await,
            Refresh::CodeLens => client.code_lens_refresh().await,
        };
    }
}
