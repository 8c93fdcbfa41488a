//! Checking, expanding and showing robots whose files are in memory: what the npm package and the playground are made
//! of.
//!
//! A [`Bench`] holds files. A [`Call`] comes as JSON and is answered as JSON. Nothing is decided here: checks are those
//! of `analysis`, expansions those of `expand`, models those of `preview`. With the feature `server`, what is called from
//! outside is the language server instead (`server::Embedded`).

mod bench;
mod calls;
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
mod exports;
#[cfg(test)]
mod tests;

pub use bench::Bench;
pub use calls::{Call, CheckCall, RobotParams};
