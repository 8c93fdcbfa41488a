//! How the process ends: on `exit`, on a broken pipe, and when the client is gone.
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::task::{Context, Poll};
use std::time::Duration;

use tower::Service;
use tower_lsp::jsonrpc::Request;

use vfs::is_process_alive;

/// Whether `shutdown` was asked for: the exit code depends on it.
#[derive(Clone, Debug, Default)]
pub(super) struct Shutdown(Arc<AtomicBool>);

impl Shutdown {
    /// The exit code now: 0 behind `shutdown`, else 1.
    pub fn code(&self) -> u8 {
        u8::from(!self.0.load(Ordering::Relaxed))
    }

    /// End the process.
    pub fn end(&self) -> ! {
        std::process::exit(i32::from(self.code()))
    }
}

/// Notices `shutdown` and `exit` on their way to the service behind it, which never ends by itself.
pub(super) struct Watched<S> {
    pub inner: S,
    pub shutdown: Shutdown,
}

impl<S: Service<Request>> Service<Request> for Watched<S> {
    type Response = S::Response;
    type Error = S::Error;
    type Future = S::Future;

    fn poll_ready(&mut self, cx: &mut Context<'_>) -> Poll<Result<(), S::Error>> {
        self.inner.poll_ready(cx)
    }

    fn call(&mut self, request: Request) -> S::Future {
        match request.method() {
            "shutdown" => self.shutdown.0.store(true, Ordering::Relaxed),
            "exit" => {
                let shutdown = self.shutdown.clone();
                // replies that are on their way out may still leave
                std::thread::spawn(move || {
                    std::thread::sleep(Duration::from_millis(50));
                    shutdown.end()
                });
            }
            _ => {}
        }
        self.inner.call(request)
    }
}

/// End the process soon after the client's process has ended.
pub(super) fn watch_process(process: u32, shutdown: Shutdown) {
    std::thread::spawn(move || {
        while is_process_alive(process) {
            std::thread::sleep(Duration::from_secs(1));
        }
        shutdown.end()
    });
}
