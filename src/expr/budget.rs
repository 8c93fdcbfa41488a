//! What one evaluation may cost.

use super::stop::{Eval, Stop};
use base::limits::{EVAL_VALUE_BYTES, INTEGER_BITS};

/// What one element of a list, tuple, set or dict counts, in bytes.
pub(crate) const ITEM_BYTES: u64 = 32;

/// What is left to spend; one budget may serve many evaluations.
#[derive(Clone, Debug)]
pub struct Budget {
    /// Elementary steps: nodes evaluated, items visited.
    pub steps: u64,
    /// Bytes of values built.
    pub bytes: u64,
    /// How deep nodes and calls may nest.
    pub depth: u32,
    total_steps: u64,
    total_bytes: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Self::new(10_000_000, 256 << 20, 600)
    }
}

impl Budget {
    /// A budget of so many steps, bytes and levels.
    ///
    /// 600 levels fit a thread stack of 2 MB; a level is one node inside another, and a call is about four of them.
    pub fn new(steps: u64, bytes: u64, depth: u32) -> Self {
        Self {
            steps,
            bytes,
            depth,
            total_steps: steps,
            total_bytes: bytes,
        }
    }

    /// Spend one step.
    #[inline]
    pub(crate) fn step(&mut self) -> Eval<()> {
        match self.steps.checked_sub(1) {
            Some(left) => {
                self.steps = left;
                Ok(())
            }
            None => Err(self.out_of_steps()),
        }
    }

    /// Spend `count` steps.
    pub(crate) fn steps(&mut self, count: u64) -> Eval<()> {
        match self.steps.checked_sub(count) {
            Some(left) => {
                self.steps = left;
                Ok(())
            }
            None => Err(self.out_of_steps()),
        }
    }

    /// Spend the memory of a text of `len` bytes, before it is built.
    pub(crate) fn text(&mut self, len: u128) -> Eval<()> {
        self.spend(len, len, "characters")
    }

    /// Spend the memory of a text that is put together outside of an expression; whether there was enough.
    pub fn charge(&mut self, bytes: usize) -> bool {
        self.text(bytes as u128).is_ok()
    }

    /// Spend the memory of a container with `len` items, before it is built.
    pub(crate) fn items(&mut self, len: u128) -> Eval<()> {
        self.spend(len.saturating_mul(u128::from(ITEM_BYTES)), len, "items")
    }

    /// Allow an integer of `bits` bits, before it is computed.
    pub(crate) fn int_bits(&mut self, bits: u128) -> Eval<()> {
        if bits > u128::from(INTEGER_BITS) {
            let limit = INTEGER_BITS;
            return Err(Stop::budget(format!(
                "value has {bits} bits; the limit is {limit} bits"
            )));
        }
        self.spend(bits / 8, bits, "bits")
    }

    /// How long a text may still be, in bytes.
    pub(crate) fn text_limit(&self) -> u64 {
        EVAL_VALUE_BYTES.min(self.bytes)
    }

    /// Refuse a text that has grown to `len` bytes, whose parts were paid for.
    pub(crate) fn grown(&self, len: usize) -> Eval<()> {
        if len as u64 > EVAL_VALUE_BYTES {
            let limit = EVAL_VALUE_BYTES >> 20;
            return Err(Stop::budget(format!(
                "value has {len} characters; the limit is {limit} MB"
            )));
        }
        Ok(())
    }

    fn spend(&mut self, bytes: u128, count: u128, unit: &str) -> Eval<()> {
        if bytes > u128::from(EVAL_VALUE_BYTES) {
            let limit = EVAL_VALUE_BYTES >> 20;
            return Err(Stop::budget(format!(
                "value has {count} {unit}; the limit is {limit} MB"
            )));
        }
        let bytes = u64::try_from(bytes).unwrap_or(u64::MAX);
        // A step per 256 bytes keeps long texts from being walked for free.
        self.steps(bytes / 256)?;
        match self.bytes.checked_sub(bytes) {
            Some(left) => {
                self.bytes = left;
                Ok(())
            }
            None => Err(Stop::budget(format!(
                "evaluation needs more than the limit of {} MB",
                self.total_bytes >> 20
            ))),
        }
    }

    fn out_of_steps(&mut self) -> Stop {
        self.steps = 0;
        Stop::budget(format!(
            "evaluation takes more than the limit of {} steps",
            self.total_steps
        ))
    }
}
