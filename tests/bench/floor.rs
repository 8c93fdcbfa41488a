//! The floor under every run: the files that go in are read and parsed, by roxmltree, and nothing else is done.
//!
//! `tests/bench/floor.py` compares the programs with it.

use std::path::PathBuf;

#[expect(
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "a program of its own, which reads as any program does"
)]
fn main() {
    // cargo adds an option when it runs a bench
    let paths = std::env::args_os()
        .skip(1)
        .filter(|argument| argument != "--bench")
        .map(PathBuf::from);
    let (mut bytes, mut nodes) = (0, 0);
    for path in paths {
        let Ok(text) = std::fs::read_to_string(&path) else {
            continue;
        };
        bytes += text.len();
        nodes +=
            roxmltree::Document::parse(&text).map_or(0, |document| document.descendants().count());
    }
    println!("{bytes} bytes, {nodes} nodes");
}
