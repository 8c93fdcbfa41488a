//! The functions that a host of WebAssembly calls.
//!
//! Bytes go in and out through two buffers: `input(length)` makes room and says where; the functions read it from there
//! and leave their answer, a byte 0 or 1 for an error in front of it, at `output()`. The host gives the time by `now`.

#![allow(
    unsafe_code,
    reason = "only the attributes that name functions for the host are unsafe; no memory is touched by hand"
)]

#[cfg(not(feature = "server"))]
mod questions;
#[cfg(feature = "server")]
mod session;

use std::cell::RefCell;
use std::sync::Once;
use std::time::Duration;

#[cfg(not(feature = "server"))]
use questions::HostState;
#[cfg(feature = "server")]
use session::HostState;

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// Milliseconds since the host began.
    safe fn now() -> f64;
    /// Take the words of a panic: a text of so many bytes. The instance is of no use afterwards.
    safe fn panicked(text: *const u8, length: usize);
}

static STARTED: Once = Once::new();

#[derive(Default)]
struct ExportState {
    held: HostState,
    input: Vec<u8>,
    output: Vec<u8>,
}

thread_local! {
    static STATE: RefCell<ExportState> = RefCell::new(ExportState::default());
}

fn with<T>(work: impl FnOnce(&mut ExportState) -> T) -> T {
    STATE.with_borrow_mut(work)
}

/// Make room for so many bytes; where they are to be written.
#[unsafe(no_mangle)]
extern "C" fn input(length: usize) -> *mut u8 {
    STARTED.call_once(|| {
        base::clock::set_clock(|| Duration::from_secs_f64(now().max(0.0) / 1000.0));
        std::panic::set_hook(Box::new(|panic| {
            let text = panic.to_string();
            panicked(text.as_ptr(), text.len());
        }));
    });
    with(|state| {
        state.input = vec![0; length];
        state.input.as_mut_ptr()
    })
}

/// Where the last answer is.
#[unsafe(no_mangle)]
extern "C" fn output() -> *const u8 {
    with(|state| state.output.as_ptr())
}

/// Put the file whose path takes the first bytes of the input; the rest is its content.
#[unsafe(no_mangle)]
extern "C" fn put(path: usize) {
    with(|state| {
        let mut name = std::mem::take(&mut state.input);
        let content = name.split_off(path.min(name.len()));
        state
            .held
            .put(&String::from_utf8_lossy(&name), Some(content));
    });
}

/// Take away the file whose path is the input.
#[unsafe(no_mangle)]
extern "C" fn remove() {
    with(|state| {
        let path = state.text();
        state.held.put(&path, None);
    });
}

impl ExportState {
    /// The input as text.
    fn text(&mut self) -> String {
        String::from_utf8_lossy(&std::mem::take(&mut self.input)).into_owned()
    }

    /// Leave an answer; its length.
    fn answer(&mut self, answer: Result<Vec<u8>, String>) -> usize {
        let (mark, answer) = match answer {
            Ok(answer) => (0, answer),
            Err(message) => (1, message.into_bytes()),
        };
        self.output = [vec![mark], answer].concat();
        self.output.len()
    }
}
