//! The functions that the targets try.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a finding is a panic

#[path = "harness/mod.rs"]
mod harness;

pub use harness::*;
