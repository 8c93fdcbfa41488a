//! The documentation says what is true: every block of code of the pages is run or read by what it is for, every
//! link leads somewhere, every page is in the book.
//!
//! What a block is for stands in its first line, and in a comment above it:
//!
//! * `console`: commands behind `$ ` with what they print. `UPDATE=1` writes the answers again. A line `...` stands for
//!   lines that were left out, `[exit 1]` for an exit code.
//! * `sh`: commands alone; they have to work.
//! * `toml`, `json`, `yaml`, `xml`: read by what reads them.
//! * `text`: no code.
//! * `<!-- in FOLDER -->`: the commands are run in that folder of the examples.
//! * A line above it that holds a name in backticks and a colon: the block is that file; the commands of the same section
//!   are run beside it.
//! * `<!-- run: NAME -->`: the tests of editors or packages take it from the page.
//! * `not-run: reason` in the first line: cannot be run here. `tests/docs/not-run.txt` lists these.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

mod blocks;
#[cfg(unix)]
mod commands;
mod consumers;
mod data;
mod links;
mod pages;
mod picture;
mod summary;
