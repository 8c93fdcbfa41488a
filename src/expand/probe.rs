//! Macros that nothing calls: looked into with parameters whose values are unknown. Properties that nothing reads.
//!
//! Most files of a description only define macros, so a plain expansion never looks into them. What does not
//! depend on a parameter can be judged all the same.

use std::sync::Arc;

use super::machine::{Cx, Expander};
use super::origin::Origin;
use super::scope::MacroDef;
use super::symbols::{DefinitionId, Use, UseKind};
use super::tree::XId;

/// What a macro gives that nothing calls.
#[derive(Clone, Copy, Debug)]
pub struct Probe {
    /// The macro.
    pub definition: DefinitionId,
    /// A node beside the document that holds the result.
    pub content: XId,
}

impl Expander<'_> {
    /// Look into the macros that nothing calls. What is found there changes nothing about the document.
    pub fn probe_macros(&mut self) {
        if !self.request.probe || self.stopped {
            return;
        }
        let before = (
            self.result.complete,
            self.content_lost,
            self.problems.list.len(),
        );
        // a macro that is called by a later one need not be looked into by itself
        for (def, cx) in std::mem::take(&mut self.idle_macros).into_iter().rev() {
            let is_call = |used: &Use| used.kind == UseKind::Call;
            if !self.result.symbols.uses_of(def.definition).any(is_call) {
                self.probe_macro(&def, cx);
            }
        }
        let known;
        (self.result.complete, self.content_lost, known) = before;
        for problem in self.problems.list.iter_mut().skip(known) {
            problem.probed = true;
        }
    }

    /// Evaluate the properties that nothing reads, for editors that show their values. Nothing is reported.
    pub fn probe_properties(&mut self) {
        if !self.request.probe || self.stopped {
            return;
        }
        let before = (
            self.result.complete,
            self.content_lost,
            self.include_missing,
            self.budget.clone(),
        );
        let (known, messages) = (self.problems.list.len(), self.result.messages.len());
        let includes = self.result.includes.len();
        self.idle = true;
        for (scope, name, place) in self.scopes.unread() {
            self.value_of(scope, &name, place);
            self.reads.clear();
        }
        self.idle = false;
        (
            self.result.complete,
            self.content_lost,
            self.include_missing,
            self.budget,
        ) = before;
        (self.stopped, self.unwinding) = (false, false);
        self.problems.list.truncate(known);
        self.result.messages.truncate(messages);
        self.result.includes.truncate(includes);
    }

    fn probe_macro(&mut self, def: &Arc<MacroDef>, cx: Cx) {
        let at = Origin {
            frame: cx.frame,
            ..def.origin
        };
        let (scope, macros) = (
            self.scopes.push(cx.scope, false),
            self.macros.push(Some(cx.macros)),
        );
        let body_cx = Cx {
            scope,
            macros,
            frame: cx.frame,
        };
        for param in def.params.iter() {
            self.bind_unknown(param, at, body_cx);
        }
        let content = self.container(at);
        self.calls
            .push((Arc::as_ptr(def) as usize, self.conditions));
        self.eval_body(def, content, body_cx);
        self.calls.pop();
        self.result.probes.push(Probe {
            definition: def.definition,
            content,
        });
    }
}
