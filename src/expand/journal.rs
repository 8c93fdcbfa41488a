//! What the items of a root change of what is there already: undone when the next expansion goes back to a place in between,
//! done again when it passes over items that say the same.
use std::sync::Arc;

use ecow::EcoString;

use super::binding_info::{ArgumentValue, BindingId, BindingInfo};
use super::macro_table::{MacroDef, MacroEntry, Macros};
use super::names::NameTables;
use super::scope::{Binding, PropertyState, Scopes};
use super::symbols::DefinitionId;
use base::{SharedIdVec, SharedVec, TextRange};
use expr::Value;

/// Changes in the order in which they were made, and how often something changed that is not among them.
#[derive(Debug, Default)]
pub(super) struct Journal {
    pub changes: SharedVec<Change>,
    /// How often something changed in another way: no expansion goes back to a place before that.
    pub unclear: usize,
    /// What cannot be put back at all was stored: a namespace, a function.
    pub is_lost: bool,
}

/// A change of names of the document, or of a list entry that was there already.
#[derive(Clone, Debug)]
pub(super) enum Change {
    /// A property got a binding; with the one before.
    Property {
        name: EcoString,
        old: Option<Binding>,
        new: Binding,
    },
    /// A lazy property was evaluated; with what it was before.
    Forced {
        name: EcoString,
        info: BindingId,
        lazy: PropertyState,
        value: Value,
        reads: TextRange,
    },
    /// A macro was defined; with what had the name before.
    Macro {
        old: Option<MacroEntry>,
        new: Arc<MacroDef>,
    },
    /// An argument was declared.
    Argument {
        name: EcoString,
        value: ArgumentValue,
    },
    /// An argument that is given from outside was declared.
    Declared {
        info: BindingId,
        definition: DefinitionId,
    },
}

type Bindings = SharedIdVec<BindingId, BindingInfo>;

impl Change {
    /// The name that it defines in the document.
    pub fn defines(&self) -> Option<&EcoString> {
        match self {
            Self::Property { name, .. } | Self::Argument { name, .. } => Some(name),
            Self::Macro { new, .. } => Some(&new.name),
            Self::Forced { .. } | Self::Declared { .. } => None,
        }
    }

    /// The binding that was there already and that it changes.
    pub fn binding(&self) -> Option<BindingId> {
        match self {
            Self::Forced { info, .. } | Self::Declared { info, .. } => Some(*info),
            Self::Property { .. } | Self::Macro { .. } | Self::Argument { .. } => None,
        }
    }

    /// Make it again, but for what it did to a binding.
    pub fn redo(&self, names: &mut NameTables) {
        let top = &mut names.scopes.get_mut(Scopes::TOP).vars;
        match self {
            Self::Property { name, new, .. } => top.insert(name.clone(), new.clone()),
            Self::Forced { name, value, .. } => {
                if let Some(binding) = top.get_mut(name) {
                    binding.state = PropertyState::Ready(value.clone());
                }
            }
            Self::Macro { new, .. } => {
                let entry = MacroEntry::Macro(Arc::clone(new));
                names.macros.put(Macros::TOP, &new.name, Some(entry));
            }
            Self::Argument { name, value } => {
                names.args.insert(name.clone(), value.clone());
            }
            Self::Declared { .. } => {}
        }
    }

    /// Do again what it did to a binding.
    pub fn redo_binding(&self, bindings: &mut Bindings) {
        match self {
            Self::Forced {
                info, value, reads, ..
            } => {
                if let Some(info) = bindings.get_mut(*info) {
                    (info.reads, info.value) = (*reads, Some(value.clone()));
                }
            }
            Self::Declared { info, definition } => {
                if let Some(info) = bindings.get_mut(*info) {
                    info.definition = Some(*definition);
                }
            }
            Self::Property { .. } | Self::Macro { .. } | Self::Argument { .. } => {}
        }
    }

    /// Take it back; what was changed later is back already.
    pub fn undo(&self, names: &mut NameTables, bindings: &mut Bindings) {
        let top = &mut names.scopes.get_mut(Scopes::TOP).vars;
        match self {
            Self::Property { name, old, .. } => match old {
                Some(old) => top.insert(name.clone(), old.clone()),
                None => top.remove(name),
            },
            Self::Forced { name, lazy, .. } => {
                if let Some(binding) = top.get_mut(name) {
                    binding.state = lazy.clone();
                }
            }
            Self::Macro { old, new } => names.macros.put(Macros::TOP, &new.name, old.clone()),
            Self::Argument { name, .. } => {
                names.args.remove(name);
            }
            Self::Declared { .. } => {}
        }
        self.undo_binding(bindings);
    }

    /// Take back what it did to a binding.
    pub fn undo_binding(&self, bindings: &mut Bindings) {
        match self {
            Self::Forced { info, .. } => {
                if let Some(info) = bindings.get_mut(*info) {
                    (info.reads, info.value) = (TextRange::default(), None);
                }
            }
            Self::Declared { info, .. } => {
                if let Some(info) = bindings.get_mut(*info) {
                    info.definition = None;
                }
            }
            Self::Property { .. } | Self::Macro { .. } | Self::Argument { .. } => {}
        }
    }
}
