//! The socket of a page: first it names the token, then each side tells the other what is new.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::body::Bytes;
use axum::extract::State;
use axum::extract::ws::{CloseFrame, Message, Utf8Bytes, WebSocket, WebSocketUpgrade};
use axum::http::StatusCode;
use axum::http::header::HeaderMap;
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use tokio::sync::watch::Receiver;

use super::guard;
use super::hub::{Hub, Received, ViewState};
use crate::messages::FromViewer;
use base::limits::SOCKET_MESSAGE;

/// A socket has this long to name the token.
const HELLO_TIME: Duration = Duration::from_secs(5);
/// How often a page is asked whether it is still there, and how long it may stay silent.
const PING: Duration = Duration::from_secs(20);
const SILENCE: Duration = Duration::from_secs(60);
/// A message has this long to leave.
const SEND_TIME: Duration = Duration::from_secs(30);

/// What the viewer knows these codes by.
const WRONG_TOKEN: u16 = 4001;
const NO_VIEW: u16 = 4004;

#[derive(Deserialize)]
#[serde(tag = "type", rename = "hello")]
struct Hello {
    token: String,
    id: u32,
}

/// `/socket`
pub(super) async fn open(
    State(hub): State<Arc<Hub>>,
    headers: HeaderMap,
    upgrade: WebSocketUpgrade,
) -> Response {
    // a page always says where it comes from; who does not is none of ours
    if !guard::same_origin(&headers) {
        return (
            StatusCode::FORBIDDEN,
            "the Origin header does not match this server",
        )
            .into_response();
    }
    let upgrade = upgrade
        .max_message_size(SOCKET_MESSAGE)
        .max_frame_size(SOCKET_MESSAGE);
    upgrade.on_upgrade(move |socket| talk(socket, hub))
}

async fn talk(socket: WebSocket, hub: Arc<Hub>) {
    let Some((mut socket, id, mut updates)) = greet(socket, &hub).await else {
        return;
    };
    (hub.receive)(Received {
        id,
        message: FromViewer::Ready,
    });
    let page = hub.pages.enter();
    let mut known = ViewState::default();
    // the page does not know yet what there is already
    updates.mark_changed();
    let mut seen = Instant::now();
    let mut ping = tokio::time::interval(PING);
    loop {
        tokio::select! {
            changed = updates.changed() => {
                if changed.is_err() {
                    return close(socket, NO_VIEW, "this view is closed").await;
                }
                let now = updates.borrow_and_update().clone();
                if tell(&mut socket, &mut known, now).await.is_break() {
                    return;
                }
            }
            message = socket.recv() => {
                let Some(Ok(message)) = message else { return };
                seen = Instant::now();
                listen(&hub, id, &message);
            }
            _ = ping.tick() => {
                let silent = seen.elapsed() > SILENCE;
                if silent || send(&mut socket, Message::Ping(Bytes::new())).await.is_break() {
                    return;
                }
            }
            () = page.lost() => return close(socket, NO_VIEW, "too many pages are open").await,
        }
    }
}

/// Wait for the token; the view that the page shows.
async fn greet(mut socket: WebSocket, hub: &Hub) -> Option<(WebSocket, u32, Receiver<ViewState>)> {
    let permit = hub.unauthenticated.enter();
    let hello = tokio::select! {
        hello = tokio::time::timeout(HELLO_TIME, socket.recv()) => hello,
        () = permit.lost() => return None,
    };
    let hello = match hello {
        Ok(Some(Ok(Message::Text(text)))) => serde_json::from_str::<Hello>(&text).ok(),
        _ => None,
    };
    let Some(hello) = hello.filter(|hello| guard::same(&hello.token, hub.token())) else {
        close(socket, WRONG_TOKEN, "the token is missing or wrong").await;
        return None;
    };
    match hub.updates(hello.id) {
        Some(updates) => Some((socket, hello.id, updates)),
        None => {
            close(socket, NO_VIEW, "this view is closed").await;
            None
        }
    }
}

/// Forward what a page sends; what makes no sense is ignored.
fn listen(hub: &Hub, id: u32, message: &Message) {
    if let Message::Text(text) = message
        && let Ok(message) = serde_json::from_str::<FromViewer>(text)
    {
        (hub.receive)(Received { id, message });
    }
}

/// Send what a page does not know yet.
async fn tell(socket: &mut WebSocket, known: &mut ViewState, now: ViewState) -> ControlFlow<()> {
    let differs = |a: &Option<Arc<str>>, b: &Option<Arc<str>>| match (a, b) {
        (Some(a), Some(b)) => !Arc::ptr_eq(a, b),
        (a, b) => a.is_some() != b.is_some(),
    };
    let gone: Option<Arc<str>> = Some(Arc::from(r#"{"type":"closed","side":"compare"}"#));
    let compare = if now.compare.is_some() {
        &now.compare
    } else {
        &gone
    };
    let parts = [
        (differs(&known.main, &now.main), &now.main),
        (differs(&known.compare, &now.compare), compare),
        (differs(&known.selection, &now.selection), &now.selection),
    ];
    for (_, text) in parts.into_iter().filter(|(differs, _)| *differs) {
        if let Some(text) = text {
            send(socket, Message::Text(Utf8Bytes::from(text.as_ref()))).await?;
        }
    }
    *known = now;
    ControlFlow::Continue(())
}

async fn send(socket: &mut WebSocket, message: Message) -> ControlFlow<()> {
    match tokio::time::timeout(SEND_TIME, socket.send(message)).await {
        Ok(Ok(())) => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    }
}

async fn close(mut socket: WebSocket, code: u16, reason: &'static str) {
    let frame = CloseFrame {
        code,
        reason: Utf8Bytes::from_static(reason),
    };
    let _ = send(&mut socket, Message::Close(Some(frame))).await;
}
