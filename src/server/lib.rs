//! The language server: the protocol around the analysis.
//!
//! Nothing outside of this folder names the protocol's types. Handlers only post jobs (`queue`); one thread
//! owns all state and works them off (`state`); what goes out unasked leaves through the `outbox`.

mod capabilities;
mod client;
mod client_requests;
mod contexts;
mod convert;
mod diagnostics;
mod documents;
mod embedded;
mod exit;
mod failure;
mod files;
mod framing;
mod handlers;
mod installed;
mod installed_links;
mod lifecycle;
mod locations;
mod logging;
mod main_loop;
mod mapping;
mod markup;
mod outbox;
mod preview;
mod publishing;
mod queue;
mod refreshing;
mod requests;
mod root_param;
mod roots;
mod scanning;
mod sent;
mod settings;
mod state;
mod transport;
mod views;

use tokio::runtime::Builder;
use tower_lsp::{Client, ClientSocket, LspService};

use analysis::World;
pub use embedded::Embedded;
use exit::{Shutdown, Watched};
use expand::spawn_on_large_stack;
use handlers::Handlers;
use logging::Log;
use outbox::Outbox;
use state::State;
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
    let (queue, jobs, status) = queue::queue();
    let (outbox, notifications, requests) = Outbox::new();
    let announced = status.clone();
    let log = Log::start(&env, outbox.clone());
    tracing::info!(version = env!("CARGO_PKG_VERSION"), "server started");
    let mut state = State::new(World::new(env, Vec::new()), outbox, status, log);
    state.queue = Some(queue.clone());
    if spawn_on_large_stack("analysis", move || main_loop::run(state, &jobs)).is_err() {
        return 1;
    }
    let (post, exit) = (queue.clone(), shutdown.clone());
    let (service, socket) = service(move |client| {
        let start = |asked, timeout| drop(tokio::spawn(tokio::time::timeout(timeout, asked)));
        let asking = client_requests::run_client_requests(client, post.clone(), requests, start);
        tokio::spawn(asking);
        Handlers {
            queue: post,
            shutdown: Some(exit),
        }
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

/// The protocol around handlers.
fn service(handlers: impl FnOnce(Client) -> Handlers) -> (LspService<Handlers>, ClientSocket) {
    let service = LspService::build(handlers)
        .custom_method("xacro/expand", Handlers::expand)
        .custom_method("xacro/expandAt", Handlers::expand_at)
        .custom_method("xacro/setInstance", Handlers::set_instance)
        .custom_method("xacro/toSource", Handlers::to_source)
        .custom_method("xacro/toExpanded", Handlers::to_expanded)
        .custom_method("xacro/roots", Handlers::roots)
        .custom_method("xacro/setRoot", Handlers::set_root)
        .custom_method("xacro/tree", Handlers::tree)
        .custom_method("xacro/preview/subscribe", Handlers::preview_subscribe)
        .custom_method("xacro/preview/unsubscribe", Handlers::preview_unsubscribe)
        .custom_method("xacro/preview/setRoot", Handlers::preview_root)
        .custom_method("xacro/preview/mesh", Handlers::preview_mesh)
        .custom_method("xacro/preview/urdf", Handlers::preview_urdf)
        .custom_method("xacro/preview/select", Handlers::preview_select)
        .custom_method("xacro/log", Handlers::log)
        .custom_method("$/setTrace", Handlers::set_trace)
        .custom_method(framing::BAD_MESSAGE, Handlers::bad_message);
    // not in what users run
    #[cfg(debug_assertions)]
    let service = service.custom_method("xacro/debug/fail", Handlers::fail);
    service.finish()
}
