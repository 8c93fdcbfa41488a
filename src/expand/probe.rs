//! Macros that nothing calls: evaluated with parameters whose values are unknown. Properties that nothing reads.
//!
//! Most files of a description only define macros, so a plain expansion never evaluates them. What does not
//! depend on a parameter can be judged all the same.
use std::sync::Arc;

use super::expander::Expander;
use super::expansion::Probe;
use super::macro_table::MacroDef;
use super::names::EvalContext;
use super::origin::Origin;
use super::problem::Problem;
use super::symbols::UseKind;
use base::FastSet;

impl Expander<'_> {
    /// Evaluate the macros that nothing calls. What is found there changes nothing about the document.
    pub fn probe_macros(&mut self) {
        if !self.request.probe || self.flow.stopped {
            return;
        }
        let mut found = self.speculate(|expander| {
            // a macro that is called by a later one need not be evaluated by itself
            let (mut called, mut seen) = (FastSet::default(), 0);
            for (def, cx) in std::mem::take(&mut expander.probing.macros)
                .into_iter()
                .rev()
            {
                let uses = &expander.result.index.symbols.uses;
                let new = uses.range(seen..uses.len());
                let calls = new.filter(|used| used.kind == UseKind::Call);
                called.extend(calls.map(|used| used.definition));
                seen = uses.len();
                if !called.contains(&def.definition) {
                    expander.probe_macro(&def, cx);
                }
            }
        });
        for problem in &mut found {
            problem.probed = true;
        }
        self.problems.list.append(&mut found);
    }

    /// Evaluate the properties that nothing reads, for editors that show their values. Nothing is reported.
    pub fn probe_properties(&mut self) {
        if !self.request.probe || self.flow.stopped {
            return;
        }
        self.speculate(|expander| {
            expander.probing.quiet = true;
            for (scope, name, place) in expander.names.scopes.unread() {
                expander.value_of(scope, &name, place);
                expander.names.reads.clear();
            }
            expander.probing.quiet = false;
        });
    }

    /// Evaluate what the document does not need, and return the problems that were found. Nothing that the document or
    /// its checks depend on is different afterwards; values, symbols and the record of what was read are kept.
    fn speculate(&mut self, evaluate: impl FnOnce(&mut Self)) -> Vec<Problem> {
        let (flow, gaps, budget) = (self.flow, self.gaps, self.guards.budget.clone());
        let complete = self.result.complete;
        let (messages, includes) = (self.result.messages.len(), self.result.includes.len());
        let problems = self.problems.list.len();
        evaluate(self);
        (self.flow, self.gaps, self.guards.budget) = (flow, gaps, budget);
        self.result.complete = complete;
        self.result.messages.truncate(messages);
        self.result.includes.truncate(includes);
        self.problems.list.split_off(problems)
    }

    fn probe_macro(&mut self, def: &Arc<MacroDef>, cx: EvalContext) {
        let at = Origin {
            frame: cx.frame,
            ..def.origin
        };
        let (scope, macros) = (
            self.names.scopes.push(cx.scope, false),
            self.names.macros.push(Some(cx.macros)),
        );
        let body_cx = EvalContext {
            scope,
            macros,
            frame: cx.frame,
        };
        for param in def.params.iter() {
            self.bind_unknown(param, at, body_cx);
        }
        let content = self.container(at);
        self.guards
            .calls
            .push((Arc::as_ptr(def) as usize, self.flow.conditions));
        self.eval_body(def, content, body_cx);
        self.guards.calls.pop();
        self.result.index.probes.push(Probe {
            definition: def.definition,
            content,
        });
    }
}
