//! The limits that a configuration can raise for one expansion.

use std::time::Duration;

use super::limits;

/// Budgets of one expansion; the defaults are those of the configuration's `[limits]`.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpansionLimits {
    /// Steps of expression evaluation.
    pub eval_steps: u64,
    /// Bytes of text made.
    pub output_bytes: u64,
    /// Nodes of the expanded document.
    pub expand_nodes: u64,
    /// Wall time.
    pub expand_time: Duration,
    /// Macro calls inside macro calls.
    pub macro_depth: u32,
    /// Includes inside includes.
    pub include_depth: u32,
}

impl Default for ExpansionLimits {
    fn default() -> Self {
        Self {
            eval_steps: limits::EVAL_STEPS,
            output_bytes: limits::OUTPUT_BYTES,
            expand_nodes: limits::EXPAND_NODES,
            expand_time: Duration::from_millis(limits::EXPAND_MS),
            macro_depth: limits::MACRO_DEPTH,
            include_depth: limits::INCLUDE_DEPTH,
        }
    }
}
