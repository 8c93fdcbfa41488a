//! Messages in and out: one thread reads, one writes, and the service stands between them in one task.
//!
//! `tower_lsp::Server` would do, but its buffers stay as large as the longest message was, it passes each message
//! through one pipe more, and it stops reading while a hundred answers wait.

use std::future::poll_fn;
use std::io::{self, Write};
use std::task::Poll;

use futures_util::{SinkExt, StreamExt};
use serde::Serialize;
use tokio::sync::mpsc::{Receiver, Sender, channel};
use tokio::task::JoinSet;
use tower::Service;
use tower_lsp::ClientSocket;
use tower_lsp::jsonrpc::{Request, Response};

use super::exit::Shutdown;
use super::framing::{self, Incoming};
use crate::vfs::unbuffered_stdout;

/// Handlers only wait, so there may be many of them: a slow answer never holds back an edit.
const HANDLERS_AT_ONCE: usize = 1024;

/// Messages on their way in, and out.
const QUEUE: usize = 256;

/// Serve one client on standard input and output until its input ends and everything is answered. `announce` is
/// called for each edit as soon as it is read.
pub(super) async fn serve<S>(
    service: S,
    socket: ClientSocket,
    shutdown: Shutdown,
    announce: impl Fn() + Send + 'static,
) where
    S: Service<Request, Response = Option<Response>, Future: Send + Unpin + 'static>,
    S::Error: Send + 'static,
{
    let (incoming, messages) = channel(QUEUE);
    let (outgoing, written) = channel(QUEUE);
    std::thread::spawn(move || {
        framing::read(io::stdin().lock(), |message| {
            if message.is_edit() {
                announce();
            }
            incoming.blocking_send(message).is_ok()
        });
    });
    let writer = std::thread::spawn(move || write(written, &shutdown));
    let (mut requests, answers) = socket.split();
    let out = outgoing.clone();
    let telling = tokio::spawn(async move {
        while let Some(request) = requests.next().await {
            let _ = out.send(encoded(&request)).await;
        }
    });
    answer(service, messages, answers, outgoing).await;
    telling.abort();
    // what it holds of the way out is gone then, and the writer ends
    let _ = telling.await;
    let _ = writer.join();
}

/// Call the service for each message, in order.
async fn answer<S>(
    mut service: S,
    mut messages: Receiver<Incoming>,
    mut answers: impl SinkExt<Response> + Unpin,
    outgoing: Sender<Vec<u8>>,
) where
    S: Service<Request, Response = Option<Response>, Future: Send + Unpin + 'static>,
    S::Error: Send + 'static,
{
    let mut calls = JoinSet::new();
    while let Some(message) = messages.recv().await {
        let request = match message {
            Incoming::Request(request) => request,
            Incoming::Response(response) => {
                let _ = answers.send(response).await;
                continue;
            }
        };
        if poll_fn(|cx| service.poll_ready(cx)).await.is_err() {
            continue;
        }
        let mut call = service.call(request);
        // with its first step a handler posts its job: jobs are posted in the order of the messages
        let first = poll_fn(|cx| Poll::Ready(Future::poll(std::pin::Pin::new(&mut call), cx))).await;
        let out = outgoing.clone();
        if !matches!(first, Poll::Ready(Ok(None))) {
            calls.spawn(async move {
                let answer = match first {
                    Poll::Ready(answer) => answer,
                    Poll::Pending => call.await,
                };
                if let Ok(Some(response)) = answer {
                    let _ = out.send(encoded(&response)).await;
                }
            });
        }
        while calls.try_join_next().is_some() {}
        if calls.len() >= HANDLERS_AT_ONCE {
            calls.join_next().await;
        }
    }
    while calls.join_next().await.is_some() {}
}

/// A message with its header.
fn encoded(message: &impl Serialize) -> Vec<u8> {
    framing::framed(&serde_json::to_vec(message).unwrap_or_default())
}

/// Write messages until there are no more; a reader that is gone is a quiet end of the process.
fn write(mut messages: Receiver<Vec<u8>>, shutdown: &Shutdown) {
    let Ok(mut output) = unbuffered_stdout() else { shutdown.end() };
    while let Some(message) = messages.blocking_recv() {
        if output.write_all(&message).is_err() {
            shutdown.end();
        }
    }
}
