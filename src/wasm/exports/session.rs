//! A session with the language server, over files in memory.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use server::Embedded;
use vfs::{Environment, Vfs};
use workspace::config::Config;

use super::with;
use crate::bench::FOLDER;

/// What the functions are about.
pub(super) struct HostState {
    vfs: Arc<Vfs>,
    server: Embedded,
}

impl Default for HostState {
    fn default() -> Self {
        let cwd = PathBuf::from(FOLDER);
        let limit = Config::default().limits.file_bytes();
        let vfs = Arc::new(Vfs::in_memory(limit, cwd.clone()));
        let env = Environment {
            cwd,
            ..Environment::default()
        };
        let server = Embedded::new(vfs.clone(), env);
        Self { vfs, server }
    }
}

impl HostState {
    /// Put a file there, or take it away.
    pub(super) fn put(&mut self, path: &str, bytes: Option<Vec<u8>>) {
        self.vfs.put(Path::new(path), bytes);
    }
}

/// Put the name of the file whose path is the input, and whose content the host has; see `wanted`.
#[unsafe(no_mangle)]
extern "C" fn name() {
    with(|state| {
        let path = state.text();
        state.held.vfs.put_name(Path::new(&path));
    });
}

/// Take the message in the input. Its work is done by `poll`.
#[unsafe(no_mangle)]
extern "C" fn receive() {
    with(|state| {
        let message = std::mem::take(&mut state.input);
        state.held.server.receive(&message);
    });
}

/// Do one piece of work; milliseconds until there is more, or less than zero: not before the next message.
#[unsafe(no_mangle)]
extern "C" fn poll() -> f64 {
    let wait = with(|state| state.held.server.poll());
    wait.map_or(-1.0, |wait| wait.as_secs_f64() * 1000.0)
}

/// The next message to the client; its length, or zero when there is none.
#[unsafe(no_mangle)]
extern "C" fn outgoing() -> usize {
    with(|state| match state.held.server.outgoing() {
        Some(message) => state.answer(Ok(message)),
        None => 0,
    })
}

/// The paths, as a list in JSON, of files of which only the names were put and whose content was asked for since the
/// last call; its length, or zero when there are none.
#[unsafe(no_mangle)]
extern "C" fn wanted() -> usize {
    with(|state| {
        let wanted = state.held.server.wanted();
        if wanted.is_empty() {
            return 0;
        }
        state.answer(serde_json::to_vec(&wanted).map_err(|error| error.to_string()))
    })
}
