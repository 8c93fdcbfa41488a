//! What a step looks up in the scopes and macro tables around it.
#![allow(clippy::indexing_slicing)] // ids are made by these tables only and never outlive them

use std::cell::RefCell;

use ecow::EcoString;

use super::memo::NamesRead;
use super::scope::{
    Binding, MacroEntry, MacroTable, Macros, MacrosId, Scope, Scopes, SrcRef, State,
};
use expr::{ScopeId, Value};

/// What is looked up outside of a step.
#[derive(Debug)]
pub(super) struct Watch {
    /// The first scope of the step.
    floor: u32,
    /// The names of the document as they were at first.
    names: NamesRead,
    /// An expression was evaluated in the scope of the document.
    evaluated: bool,
    /// Something else was read or written.
    unclear: bool,
}

impl Watch {
    /// Note that an expression is evaluated in a scope.
    pub fn note_evaluation(&mut self, id: ScopeId) {
        self.evaluated |= id == Scopes::TOP;
        self.unclear |= id != Scopes::TOP && id.0 < self.floor;
    }
}

impl Scopes {
    /// Count scopes that were not made.
    pub fn skip(&mut self, count: usize) {
        self.list
            .resize_with(self.list.len() + count, Scope::default);
    }

    /// Write down from now on what scopes that are there say to new ones.
    pub fn watch(&mut self) {
        let floor = self.list.len() as u32;
        self.watch = Some(RefCell::new(Watch {
            floor,
            names: Vec::new(),
            evaluated: false,
            unclear: false,
        }));
    }

    /// What was read of the scope of the document since then, and whether an expression was evaluated there; none when
    /// that is not all.
    pub fn unwatch(&mut self) -> Option<(NamesRead, bool)> {
        let watch = self.watch.take()?.into_inner();
        (!watch.unclear).then_some((watch.names, watch.evaluated))
    }

    /// Note that something is read or written that no name tells of.
    pub fn note_unclear(&self) {
        if let Some(watch) = &self.watch {
            watch.borrow_mut().unclear = true;
        }
    }

    /// Note that a scope is changed.
    pub fn note_change(&self, id: ScopeId) {
        if self
            .watch
            .as_ref()
            .is_some_and(|watch| id.0 < watch.borrow().floor)
        {
            self.note_unclear();
        }
    }

    /// Whether a property is left that nothing has evaluated, in a scope from the one of this number on.
    pub fn has_lazy_from(&self, start: usize) -> bool {
        let is_lazy = |binding: &Binding| matches!(binding.state, State::Lazy(..));
        let mut scopes = self.list.iter().skip(start);
        scopes.any(|scope| scope.vars.iter().any(|(_, binding)| is_lazy(binding)))
    }

    pub fn note_lookup(
        &self,
        watch: &RefCell<Watch>,
        from: ScopeId,
        name: &str,
        found: Option<ScopeId>,
    ) {
        let mut watch = watch.borrow_mut();
        if found.is_some_and(|id| id.0 >= watch.floor) {
            return;
        }
        let mut chain = std::iter::successors(Some(from), |&id| self.get(id).parent);
        let entry = chain.find(|id| id.0 < watch.floor);
        watch.unclear |= entry != Some(Self::TOP);
        if watch.names.iter().any(|(known, _)| known == name) {
            return;
        }
        let known = found.and_then(|id| self.get(id).vars.get(name));
        let (name, binding) = known.map_or_else(
            || (name.into(), None),
            |(n, b)| (n.clone(), Some(b.clone())),
        );
        watch.names.push((name, binding));
    }
}

/// What is looked up outside of a step.
#[derive(Debug)]
pub(super) struct MacroWatch {
    /// The first table of the step.
    floor: u32,
    /// The macros of the document.
    names: Vec<(EcoString, Option<SrcRef>)>,
    /// Something else was read or written.
    unclear: bool,
}

impl Macros {
    /// Count tables that were not made.
    pub fn skip(&mut self, count: usize) {
        self.list
            .resize_with(self.list.len() + count, MacroTable::default);
    }

    /// Write down from now on what tables that are there say to new ones.
    pub fn watch(&mut self) {
        let floor = self.list.len() as u32;
        self.watch = Some(RefCell::new(MacroWatch {
            floor,
            names: Vec::new(),
            unclear: false,
        }));
    }

    /// What was read since then; none when that is not all.
    pub fn unwatch(&mut self) -> Option<Vec<(EcoString, Option<SrcRef>)>> {
        let watch = self.watch.take()?.into_inner();
        (!watch.unclear).then_some(watch.names)
    }

    pub fn note_change(&mut self, at: MacrosId) {
        if let Some(watch) = &mut self.watch {
            let watch = watch.get_mut();
            watch.unclear |= at.0 < watch.floor;
        }
    }

    pub fn note_lookup(
        &self,
        watch: &RefCell<MacroWatch>,
        from: MacrosId,
        name: &str,
        found: Option<(MacrosId, &MacroEntry)>,
    ) {
        let mut watch = watch.borrow_mut();
        if found.is_some_and(|(id, _)| id.0 >= watch.floor) {
            return;
        }
        let parent = |&id: &MacrosId| self.list[id.0 as usize].parent;
        let entry = std::iter::successors(Some(from), parent).find(|id| id.0 < watch.floor);
        let def = match found {
            Some((_, MacroEntry::Macro(def))) => Some(def.body),
            Some((_, MacroEntry::Namespace(_))) => {
                watch.unclear = true;
                return;
            }
            None => None,
        };
        watch.unclear |= entry != Some(Self::TOP);
        if !watch.names.iter().any(|(known, _)| known == name) {
            watch.names.push((name.into(), def));
        }
    }
}

/// Whether a value is plain data that never changes: neither a container, which can be changed in place, nor a function.
pub(super) fn is_plain(value: &Value) -> bool {
    use Value::{Big, Bool, Float, Int, None, Str};
    matches!(value, None | Bool(_) | Int(_) | Big(_) | Float(_) | Str(_))
}

/// Whether two plain values are the same, of the same type.
pub(super) fn is_same_value(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::None, Value::None) | (Value::Unknown, Value::Unknown) => true,
        (Value::Bool(a), Value::Bool(b)) => a == b,
        (Value::Int(a), Value::Int(b)) => a == b,
        (Value::Big(a), Value::Big(b)) => a == b,
        (Value::Float(a), Value::Float(b)) => a.to_bits() == b.to_bits(),
        (Value::Str(a), Value::Str(b)) => a == b,
        _ => false,
    }
}
