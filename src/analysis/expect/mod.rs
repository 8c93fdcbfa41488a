//! Tests of robots: every configured root under each combination of its arguments, compared with what the
//! configuration expects of it.

mod case;
mod context;
mod evaluate;
mod expands_to;
mod outcome;
mod run;
mod snapshot;

pub(super) use context::filled;
pub use outcome::{TestCase, TestOptions, Tests, Update, test_name};
pub use run::test;
pub(super) use snapshot::{entry_at, worded};

#[cfg(test)]
mod tests;
