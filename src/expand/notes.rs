//! What is noted of definitions, uses and values while evaluation goes on.
use ecow::EcoString;

use super::binding_info::BindingId;
use super::evaluations::Evaluation;
use super::expander::Expander;
use super::origin::Origin;
use super::symbols::{Definition, DefinitionId, SymbolKind, Use, UseKind};
use base::TextRange;
use expr::Value;

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
}
