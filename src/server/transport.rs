//! Messages in and out: one thread reads, and one writes.
//!
//! The thread that reads calls the service itself: what an edit does reaches the analysis without another thread in
//! between. Whatever takes longer than its first step, and all that goes out, is left to the thread that writes.
//! `tower_lsp::Server` would do, but its buffers stay as large as the longest message was, it passes each message
//! through more hands, and it stops reading while a hundred answers wait.
use std::future::poll_fn;
use std::io::{self, Write};
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll, Waker};

use futures_util::{SinkExt, StreamExt};
use serde::Serialize;
use tokio::runtime::Handle;
use tokio::sync::Semaphore;
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tower::Service;
use tower_lsp::ClientSocket;
use tower_lsp::jsonrpc::{Request, Response};

use crate::exit::Shutdown;
use crate::framing;
use crate::framing::Incoming;
use vfs::unbuffered_stdout;

/// Handlers only wait, so there may be many of them: a slow answer never holds back an edit.
const HANDLERS_AT_ONCE: usize = 1024;

/// What goes out unasked.
pub(super) struct Outgoing {
    /// Notifications, as JSON.
    pub notifications: UnboundedReceiver<Vec<u8>>,
    /// Requests, and where their replies go.
    pub socket: ClientSocket,
}

/// Serve one client on standard input and output until its input ends and everything is answered. `announce` is
/// called for each edit as soon as it is read.
pub(super) async fn serve<S>(
    service: S,
    Outgoing {
        notifications,
        socket,
    }: Outgoing,
    shutdown: &Shutdown,
    announce: impl Fn() + Send + 'static,
) where
    S: Service<Request, Response = Option<Response>, Future: Send + Unpin + 'static>
        + Send
        + 'static,
    S::Error: Send + 'static,
{
    let (outgoing, answers) = unbounded_channel();
    let (replies, replied) = unbounded_channel();
    let (requests, asked) = socket.split();
    let reader = MessageReader {
        service,
        replies,
        outgoing,
        runtime: Handle::current(),
        handlers: Arc::new(Semaphore::new(HANDLERS_AT_ONCE)),
    };
    std::thread::spawn(move || reader.read(announce));
    let passing_on = tokio::spawn(pass_on(replied, asked));
    write(answers, notifications, requests, shutdown).await;
    passing_on.abort();
}

/// Where messages come in.
struct MessageReader<S> {
    service: S,
    /// Replies to requests of ours, on their way to who asked.
    replies: UnboundedSender<Response>,
    /// Answers on their way out. When nobody holds this any more, everything is answered.
    outgoing: UnboundedSender<Response>,
    runtime: Handle,
    handlers: Arc<Semaphore>,
}

impl<S> MessageReader<S>
where
    S: Service<Request, Response = Option<Response>, Future: Send + Unpin + 'static>,
    S::Error: Send + 'static,
{
    /// Take messages until the input ends.
    fn read(mut self, announce: impl Fn()) {
        let runtime = self.runtime.clone();
        let _context = runtime.enter();
        framing::read(io::stdin().lock(), |message| {
            match message {
                Incoming::Response(reply) => drop(self.replies.send(reply)),
                Incoming::Request(request) => {
                    if request.method() == framing::EDIT {
                        announce();
                    }
                    self.call(request);
                }
            }
            true
        });
    }

    /// Call the service. With its first step a handler adds its event: they come in the order of the messages.
    fn call(&mut self, request: Request) {
        if self
            .runtime
            .block_on(poll_fn(|cx| self.service.poll_ready(cx)))
            .is_err()
        {
            return;
        }
        let mut handler = self.service.call(request);
        match Pin::new(&mut handler).poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Ready(answer) => send(&self.outgoing, answer),
            Poll::Pending => {
                let outgoing = self.outgoing.clone();
                let place = self.runtime.block_on(self.handlers.clone().acquire_owned());
                self.runtime.spawn(async move {
                    send(&outgoing, handler.await);
                    drop(place);
                });
            }
        }
    }
}

/// Send an answer, where there is one.
fn send<E>(outgoing: &UnboundedSender<Response>, answer: Result<Option<Response>, E>) {
    if let Ok(Some(response)) = answer {
        // the other end is gone only when the process ends
        let _ = outgoing.send(response);
    }
}

/// Hand replies to who asked.
async fn pass_on(
    mut replies: UnboundedReceiver<Response>,
    mut answers: impl SinkExt<Response> + Unpin,
) {
    while let Some(reply) = replies.recv().await {
        let _ = answers.send(reply).await;
    }
}

/// Write what goes out until everything is answered; a reader that is gone is a quiet end of the process.
async fn write(
    mut answers: UnboundedReceiver<Response>,
    mut notifications: UnboundedReceiver<Vec<u8>>,
    mut requests: impl StreamExt<Item = Request> + Unpin,
    shutdown: &Shutdown,
) {
    let Ok(mut output) = unbuffered_stdout() else {
        shutdown.end()
    };
    loop {
        let message = tokio::select! {
            biased;
            Some(notification) = notifications.recv() => framing::framed(&notification),
            Some(request) = requests.next() => encoded(&request),
            answer = answers.recv() => match answer {
                Some(answer) => encoded(&answer),
                None => return,
            },
        };
        if output.write_all(&message).is_err() {
            shutdown.end();
        }
    }
}

/// A message with its header.
fn encoded(message: &impl Serialize) -> Vec<u8> {
    framing::framed(&serde_json::to_vec(message).unwrap_or_default())
}
