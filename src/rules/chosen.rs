//! Which rules run.
use std::cell::OnceCell;

use super::consumers::Tally;
use super::rule::Rule;
use super::sink::Sink;
use base::CancelFlag;

/// Which rules run, and until when.
#[derive(Clone, Copy)]
pub struct Chosen<'a> {
    /// The rules that run, in this order.
    pub rules: &'a [&'static Rule],
    /// Set to stop early; findings are missing then.
    pub cancel: &'a CancelFlag,
    /// Where to put what programs reject or change that nobody named, when somebody wants to know.
    pub tally: Option<&'a OnceCell<Tally>>,
}

impl Chosen<'_> {
    /// Apply them in order.
    pub(super) fn run(self, sink: &mut Sink<'_>, mut apply: impl FnMut(&Rule, &mut Sink<'_>)) {
        for &rule in self
            .rules
            .iter()
            .take_while(|_| !self.cancel.is_cancelled())
        {
            sink.set_rule(rule);
            apply(rule, sink);
        }
    }
}
