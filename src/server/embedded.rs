//! The server without threads, for a host that calls it: a page in a browser.
//!
//! The host hands messages over as they come, and calls `poll` until there is nothing to do. What is answered is what
//! the server on standard input answers: the same events are added, and taken by one caller.
use std::collections::VecDeque;
use std::future::{Future, poll_fn};
use std::path::PathBuf;
use std::pin::Pin;
use std::sync::Arc;
use std::sync::mpsc::Receiver;
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use futures_util::future::BoxFuture;
use futures_util::stream::FuturesUnordered;
use futures_util::{FutureExt, SinkExt, StreamExt};
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};
use tower::Service;
use tower_lsp::jsonrpc::{Request, Response};
use tower_lsp::{ClientSocket, LspService};

use crate::client_requests::run_client_requests;
use crate::events::{self, Event, Handlers};
use crate::framing::{self, Incoming};
use crate::logging::Log;
use crate::main_loop::{pause, take};
use crate::outbox::Outbox;
use crate::queue::queue;
use crate::state::ServerState;
use analysis::AnalysisHost;
use vfs::{Environment, Vfs};

/// A server that works while it is called.
pub struct Embedded {
    service: LspService<Handlers>,
    socket: ClientSocket,
    state: ServerState,
    events: Receiver<Event>,
    notifications: UnboundedReceiver<Vec<u8>>,
    /// Work that waits for an event or for the client; an answer where there is one.
    waiting: FuturesUnordered<BoxFuture<'static, Option<Response>>>,
    started: UnboundedReceiver<BoxFuture<'static, ()>>,
    answers: VecDeque<Response>,
}

impl Embedded {
    /// A server over the files of a host.
    pub fn new(vfs: Arc<Vfs>, env: Environment) -> Self {
        let (queue, events, status) = queue();
        let (outbox, notifications, requests) = Outbox::new();
        let (start, started) = unbounded_channel();
        let log = Log::without_output(outbox.clone());
        tracing::info!(version = env!("CARGO_PKG_VERSION"), "server started");
        let host = AnalysisHost::over(vfs, env, Vec::new());
        let state = ServerState::new(host, outbox, status, log);
        let (service, socket) = events::service(move |client| {
            let begin = start.clone();
            // a host that asks for nothing any more has dropped us: there is no clock to give up by
            let run = move |asked, _: Duration| drop(begin.send(asked));
            let asking = run_client_requests(client, queue.clone(), requests, run);
            let _ = start.send(Box::pin(asking) as BoxFuture<'static, ()>);
            Handlers { queue }
        });
        Self {
            service,
            socket,
            state,
            events,
            notifications,
            waiting: FuturesUnordered::new(),
            started,
            answers: VecDeque::new(),
        }
    }

    /// Take a message, as JSON. Its work is done by [`Embedded::poll`].
    pub fn receive(&mut self, message: &[u8]) {
        match framing::of_body(message) {
            Incoming::Response(reply) => drop(self.socket.send(reply).now_or_never()),
            Incoming::Request(request) => self.call(request),
        }
    }

    /// Call the service. With its first step a handler adds its event: they come in the order of the messages.
    fn call(&mut self, request: Request) {
        let ready = poll_fn(|cx| self.service.poll_ready(cx)).now_or_never();
        if !matches!(ready, Some(Ok(()))) {
            return;
        }
        let mut handler = self.service.call(request);
        match Pin::new(&mut handler).poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Ready(answer) => self.answers.extend(answer.ok().flatten()),
            Poll::Pending => self
                .waiting
                .push(Box::pin(handler.map(|answer| answer.ok().flatten()))),
        }
    }

    /// Do one piece of work: an event, or what is due when there is none. How long until there is more; none: not before
    /// the next message.
    pub fn poll(&mut self) -> Option<Duration> {
        if let Ok(event) = self.events.try_recv() {
            self.state.status.taken();
            take(&mut self.state, event);
        } else if pause(&self.state) == Some(Duration::ZERO) {
            take(&mut self.state, Event::Idle);
        }
        if self.state.status.has_waiting() {
            Some(Duration::ZERO)
        } else {
            pause(&self.state)
        }
    }

    /// The next message to the client, as JSON.
    pub fn outgoing(&mut self) -> Option<Vec<u8>> {
        self.go_on();
        if let Ok(notification) = self.notifications.try_recv() {
            return Some(notification);
        }
        if let Some(Some(request)) = self.socket.next().now_or_never() {
            return serde_json::to_vec(&request).ok();
        }
        serde_json::to_vec(&self.answers.pop_front()?).ok()
    }

    /// Go on with what waited for something that has come.
    fn go_on(&mut self) {
        loop {
            while let Ok(task) = self.started.try_recv() {
                self.waiting.push(Box::pin(task.map(|()| None)));
            }
            match self.waiting.next().now_or_never() {
                Some(Some(answer)) => self.answers.extend(answer),
                // everything that is left waits for the host
                _ if self.started.is_empty() => return,
                _ => {}
            }
        }
    }

    /// The files of which only the names are known, and whose content was asked for since the last call.
    pub fn wanted(&self) -> Vec<PathBuf> {
        self.state.host.session().vfs.take_wanted()
    }
}

#[cfg(test)]
mod tests;
