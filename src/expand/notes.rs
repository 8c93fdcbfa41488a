//! What is noted of definitions, uses and values while evaluation goes on.
use std::sync::Arc;

use ecow::EcoString;

use super::binding_info::{ArgumentValue, BindingId};
use super::evaluations::Evaluation;
use super::expander::Expander;
use super::journal::Change;
use super::macro_table::{MacroDef, MacroEntry, Macros, MacrosId};
use super::origin::Origin;
use super::plain::holds_still;
use super::scope::{Binding, PropertyState, Scopes};
use super::symbols::{Definition, DefinitionId, SymbolKind, Use, UseKind};
use base::TextRange;
use expr::{ScopeId, Value};

impl Expander<'_> {
    /// Note what the expression at `at` gave; `mark` is how many reads there were before. Answers with their part of
    /// all reads.
    pub fn note_value(&mut self, at: Origin, value: &Value, mark: usize) -> TextRange {
        let reads = self.keep_reads(mark);
        let kept = &mut self.result.index.evaluations;
        if self.request.probe && !kept.is_full() {
            kept.add(Evaluation {
                at,
                value: value.clone(),
                reads,
            });
        }
        reads
    }

    /// Note all reads since there were `mark`; answers with their part of all reads.
    pub fn keep_reads(&mut self, mark: usize) -> TextRange {
        let all = &mut self.result.index.reads;
        let start = all.len() as u32;
        all.extend(self.names.reads.get(mark..).unwrap_or(&[]));
        TextRange::new(start, all.len() as u32)
    }

    /// The same, when nobody else is interested in them.
    pub fn take_reads(&mut self, mark: usize) -> TextRange {
        let reads = self.keep_reads(mark);
        self.names.reads.truncate(mark);
        reads
    }

    /// Note that the text at `at` gives a name.
    pub fn define(&mut self, kind: SymbolKind, name: &EcoString, at: Origin) -> DefinitionId {
        self.define_part(kind, name, at, None)
    }

    /// Note a parameter of `of`.
    pub fn define_part(
        &mut self,
        kind: SymbolKind,
        name: &EcoString,
        at: Origin,
        of: Option<DefinitionId>,
    ) -> DefinitionId {
        let (conditional, in_macro) = (self.flow.conditions > 0, !self.guards.calls.is_empty());
        let definition = Definition {
            kind,
            name: name.clone(),
            place: at.into(),
            of,
            conditional,
            in_macro,
        };
        self.result.index.symbols.add(definition)
    }

    /// Note that the text at `at` refers to a definition.
    pub fn note_use(&mut self, at: Origin, definition: Option<DefinitionId>, kind: UseKind) {
        if !self.request.probe {
            return;
        }
        if let Some(definition) = definition {
            self.result.index.symbols.add_use(
                Use {
                    place: at.into(),
                    definition,
                    kind,
                },
                self.probing.quiet,
            );
        }
    }

    /// Note that the text at `at` reads a binding.
    pub fn note_read(&mut self, at: Origin, binding: BindingId, kind: UseKind) {
        if !self.request.probe {
            return;
        }
        let definition = self
            .result
            .index
            .bindings
            .get(binding)
            .and_then(|info| info.definition);
        self.note_use(at, definition, kind);
    }

    /// Note that a scope gets a binding.
    pub(super) fn note_bound(&mut self, scope: ScopeId, name: &EcoString, new: &Binding) {
        if scope != Scopes::TOP || !self.steps.keeps {
            return;
        }
        if let PropertyState::Ready(value) = &new.state {
            self.steps.journal.is_lost |= !holds_still(value);
        }
        let old = self.names.scopes.get(scope).vars.get(name);
        let change = Change::Property {
            name: name.clone(),
            old: old.map(|(_, binding)| binding.clone()),
            new: new.clone(),
        };
        self.steps.journal.changes.push(change);
    }

    /// Note that a lazy property of the document has a value now.
    pub(super) fn note_evaluated(
        &mut self,
        name: &EcoString,
        (info, reads): (BindingId, TextRange),
        value: &Value,
    ) {
        let binding = self.names.scopes.get(Scopes::TOP).vars.get(name);
        let Some((_, binding)) = binding.filter(|_| self.steps.keeps) else {
            return;
        };
        let change = Change::Forced {
            name: name.clone(),
            info,
            lazy: binding.state.clone(),
            value: value.clone(),
            reads,
        };
        self.steps.journal.is_lost |= !holds_still(value);
        self.steps.journal.changes.push(change);
    }

    /// Note that a macro is defined where another one or none was.
    pub(super) fn note_defined(
        &mut self,
        at: MacrosId,
        old: Option<MacroEntry>,
        new: &Arc<MacroDef>,
    ) {
        if at == Macros::TOP && self.steps.keeps {
            let new = Arc::clone(new);
            self.steps.journal.changes.push(Change::Macro { old, new });
        }
    }

    /// Note that an argument is declared.
    pub(super) fn note_declared(&mut self, name: &EcoString, value: &ArgumentValue) {
        if self.steps.keeps {
            let (name, value) = (name.clone(), value.clone());
            let change = Change::Argument { name, value };
            self.steps.journal.changes.push(change);
        }
    }

    /// An argument that is given from outside is declared: the first declaration is the one that counts.
    pub(super) fn declare_given(&mut self, info: BindingId, definition: DefinitionId) {
        let given = self.result.index.bindings.get_mut(info);
        if let Some(given) = given.filter(|given| given.definition.is_none()) {
            given.definition = Some(definition);
            let change = Change::Declared { info, definition };
            self.steps.journal.changes.push(change);
        }
    }
}
