//! The language server: the protocol around the analysis.
//!
//! Nothing outside of this folder names the protocol's types. Handlers only post jobs (`letterbox`); one thread
//! owns all state and works them off (`engine`); what goes out unasked leaves through the `outbox`.

mod actions;
mod calls;
mod capabilities;
mod client;
mod colour;
mod commands;
mod completion;
mod convert;
mod diagnostics;
mod engine;
mod exit;
mod expand_at;
mod expansion;
mod failure;
mod files;
mod formatting;
mod framing;
mod handlers;
mod hints;
mod hover;
mod lenses;
mod letterbox;
mod lifecycle;
mod links;
mod mapping;
mod markup;
mod navigation;
mod outbox;
mod preview;
mod publishing;
mod refactorings;
mod references;
mod rename;
mod roots;
mod structure;
mod sync;
mod tokens;
mod transport;
mod workspace_symbols;

use tokio::runtime::Builder;
use tower_lsp::LspService;

use engine::Engine;
use exit::{Shutdown, Watched};
use expand::spawn_on_large_stack;
use handlers::Handlers;
use outbox::Outbox;
use transport::Outgoing;
use vfs::Environment;

/// Serve one client on standard input and output until it is gone; the exit code.
pub fn run(env: Environment) -> u8 {
    let Ok(runtime) = Builder::new_current_thread().enable_all().build() else { return 1 };
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
    let (letterbox, jobs, pressure) = letterbox::letterbox();
    let (outbox, notifications, questions) = Outbox::new();
    let announced = pressure.clone();
    let mut engine = Engine::new(env, outbox, pressure);
    engine.letterbox = Some(letterbox.clone());
    if spawn_on_large_stack("analysis", move || engine.run(&jobs)).is_err() {
        return 1;
    }
    let (post, exit) = (letterbox.clone(), shutdown.clone());
    let service = LspService::build(move |client| {
        tokio::spawn(outbox::ask_all(client, post.clone(), questions));
        Handlers { letterbox: post, shutdown: exit }
    })
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
    .custom_method("xacro/preview/select", Handlers::preview_select)
    .custom_method(framing::BAD_MESSAGE, Handlers::bad_message);
    // not in what users run
    #[cfg(debug_assertions)]
    let service = service.custom_method("xacro/debug/fail", Handlers::fail);
    let (service, socket) = service.finish();
    let service = Watched { inner: service, shutdown: shutdown.clone() };
    let outgoing = Outgoing { notifications, socket };
    transport::serve(service, outgoing, &shutdown, move || announced.announce_edit()).await;
    shutdown.code()
}
