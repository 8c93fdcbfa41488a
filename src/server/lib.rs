//! The language server: the protocol around the analysis.
//!
//! Nothing outside of this folder names the protocol's types. All that can happen is an event (`events`); one
//! thread owns all state and takes them in order (`main_loop`); what goes out unasked leaves through the `outbox`.

mod capabilities;
mod client;
mod client_requests;
mod contexts;
mod convert;
mod diagnostics;
mod documents;
mod embedded;
mod encoded_tokens;
mod events;
mod exit;
mod failure;
mod files;
mod framing;
mod installed;
mod installed_links;
mod lifecycle;
mod locations;
mod logging;
mod main_loop;
mod markup;
mod outbox;
mod preview;
mod publishing;
mod queue;
mod refreshing;
mod requests;
mod root_param;
mod scanning;
mod scheduler;
mod sent;
mod settings;
mod state;
mod transport;
mod views;

use tokio::runtime::Builder;

use analysis::AnalysisHost;
pub use embedded::Embedded;
use events::Handlers;
use exit::{Shutdown, Watched};
use expand::spawn_on_large_stack;
use logging::Log;
use outbox::Outbox;
use state::ServerState;
use transport::Outgoing;
use vfs::Environment;

/// Serve one client on standard input and output until it is gone; the exit code.
pub fn run(env: Environment) -> u8 {
    let Ok(runtime) = Builder::new_current_thread().enable_all().build() else {
        return 1;
    };
    runtime.block_on(serve(env))
}

/// What the service is given of a stream of bytes: messages with plain headers, whatever arrives.
pub fn reframe(input: &[u8]) -> Vec<u8> {
    let mut output = Vec::new();
    framing::bodies(input, |body, _| {
        output.extend(framing::framed(&body));
        true
    });
    output
}

async fn serve(env: Environment) -> u8 {
    let shutdown = Shutdown::default();
    let (queue, events, status) = queue::queue();
    let (outbox, notifications, requests) = Outbox::new();
    let announced = status.clone();
    let log = Log::start(&env, outbox.clone());
    tracing::info!(version = env!("CARGO_PKG_VERSION"), "server started");
    let mut state = ServerState::new(AnalysisHost::new(env, Vec::new()), outbox, status, log);
    state.shutdown = Some(shutdown.clone());
    #[cfg(feature = "preview")]
    events::from_pages(&mut state, queue.clone());
    if spawn_on_large_stack("analysis", move || main_loop::run(state, &events)).is_err() {
        return 1;
    }
    let (service, socket) = events::service(|client| {
        let start = |asked, timeout| drop(tokio::spawn(tokio::time::timeout(timeout, asked)));
        let asking = client_requests::run_client_requests(client, queue.clone(), requests, start);
        tokio::spawn(asking);
        Handlers { queue }
    });
    let service = Watched {
        inner: service,
        shutdown: shutdown.clone(),
    };
    let outgoing = Outgoing {
        notifications,
        socket,
    };
    transport::serve(service, outgoing, &shutdown, move || {
        announced.announce_edit()
    })
    .await;
    shutdown.code()
}
