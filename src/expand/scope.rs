//! Chains of property scopes.
#![allow(clippy::indexing_slicing)] // ids are made by these tables only and never outlive them
use std::cell::RefCell;

use ecow::EcoString;
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

use super::binding_info::BindingId;
use super::node::XId;
use super::origin::{Origin, SrcId};
use base::{Id, IdVec};
use expr::{ScopeId, Value};
use xml::NodeId;

/// An element of the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct SrcRef {
    pub src: SrcId,
    pub node: NodeId,
}

/// Text of the source that may hold expressions.
#[derive(Clone, Copy, Debug)]
pub(super) struct TextOrigin {
    /// The text as it is written, and the frame it was reached through.
    pub origin: Origin,
    /// Whether it is an attribute value (character data otherwise).
    pub is_attr: bool,
}

/// What a property scope knows of a name.
#[derive(Clone, Debug)]
pub(super) struct Binding {
    pub state: PropertyState,
    /// Its number in the expansion's list of bindings.
    pub info: BindingId,
}

/// The life of a property.
#[derive(Clone, Debug)]
pub(super) enum PropertyState {
    /// Not evaluated yet: evaluated on first use, in the scope that holds it.
    Lazy(EcoString, TextOrigin),
    /// Evaluated for good.
    Ready(Value),
    /// A block: `**name` properties and `*name` parameters.
    Block(Block),
}

/// What `insert_block` inserts.
#[derive(Clone, Copy, Debug)]
pub(super) enum Block {
    /// The unevaluated property element.
    Source(SrcRef),
    /// An evaluated child of a macro call.
    Built(XId),
}

/// A property scope.
#[derive(Clone, Debug, Default)]
pub(super) struct PropertyScope {
    pub parent: Option<ScopeId>,
    /// Made by `ns=` of an include.
    pub is_namespace: bool,
    pub vars: Vars,
    /// Lazy properties of this scope that are being evaluated right now.
    pub resolving: Vec<EcoString>,
    /// How many names there were when an expression was first evaluated here: Python puts `__builtins__` behind them.
    pub evaluated: Option<usize>,
}

/// The names of a scope. Most scopes are those of macro calls and hold a few, which are searched one by one; a robot
/// has thousands of them, and a table for each takes more room than all that is made of them.
#[derive(Clone, Debug, Default)]
pub(super) struct Vars {
    few: Vec<(EcoString, Binding)>,
    /// All, once they are not few.
    many: IndexMap<EcoString, Binding, FxBuildHasher>,
}

impl Vars {
    const FEW: usize = 12;

    pub fn get(&self, name: &str) -> Option<(&EcoString, &Binding)> {
        if !self.many.is_empty() {
            return self.many.get_key_value(name);
        }
        self.few
            .iter()
            .find(|(known, _)| known == name)
            .map(|(name, binding)| (name, binding))
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.few.len() + self.many.len()
    }

    pub fn get_mut(&mut self, name: &str) -> Option<&mut Binding> {
        if !self.many.is_empty() {
            return self.many.get_mut(name);
        }
        self.few
            .iter_mut()
            .find(|(known, _)| known == name)
            .map(|(_, binding)| binding)
    }

    pub fn insert(&mut self, name: EcoString, binding: Binding) {
        if let Some(known) = self.get_mut(&name) {
            *known = binding;
        } else if self.many.is_empty() && self.few.len() < Self::FEW {
            self.few.push((name, binding));
        } else {
            self.many.extend(std::mem::take(&mut self.few));
            self.many.insert(name, binding);
        }
    }

    pub(super) fn remove(&mut self, name: &str) {
        self.few.retain(|(known, _)| known != name);
        self.many.shift_remove(name);
    }

    /// In the order in which they were first defined.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&EcoString, &Binding)> {
        self.few
            .iter()
            .map(|(name, binding)| (name, binding))
            .chain(&self.many)
    }
}

/// Names of the document, each once, with what they said when they were first read.
pub(super) type NamesRead = Vec<(EcoString, Option<Binding>)>;

/// What is looked up outside of a step.
#[derive(Debug)]
pub(super) struct Watch {
    /// The first scope of the step.
    floor: ScopeId,
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
        self.unclear |= id != Scopes::TOP && id < self.floor;
    }
}

/// All property scopes of an expansion; none is ever dropped, since lambdas may keep one.
#[derive(Debug)]
pub(super) struct Scopes {
    pub(super) list: IdVec<ScopeId, PropertyScope>,
    pub(super) watch: Option<RefCell<Watch>>,
}

impl Scopes {
    pub const TOP: ScopeId = ScopeId(0);

    pub fn new() -> Self {
        Self {
            list: IdVec::from(vec![PropertyScope::default()]),
            watch: None,
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    pub fn push(&mut self, parent: ScopeId, is_namespace: bool) -> ScopeId {
        self.list.push(PropertyScope {
            parent: Some(parent),
            is_namespace,
            ..PropertyScope::default()
        })
    }

    pub fn get(&self, id: ScopeId) -> &PropertyScope {
        &self.list.as_slice()[id.index()]
    }

    pub fn get_mut(&mut self, id: ScopeId) -> &mut PropertyScope {
        &mut self.list.as_mut_slice()[id.index()]
    }

    /// How many scopes are around `id`.
    pub(super) fn depth(&self, id: ScopeId) -> i64 {
        std::iter::successors(self.get(id).parent, |&outer| self.get(outer).parent).count() as i64
    }

    /// Whether what `outer` holds is visible from `id`.
    pub fn sees(&self, id: ScopeId, outer: ScopeId) -> bool {
        std::iter::successors(Some(id), |&id| self.get(id).parent).any(|id| id == outer)
    }

    /// The scope in the chain from `id` that holds `name`.
    pub fn holder(&self, id: ScopeId, name: &str) -> Option<ScopeId> {
        self.find(id, name).map(|(holder, _)| holder)
    }

    /// The binding of `name` visible from `id`, and the scope that holds it.
    pub fn find(&self, id: ScopeId, name: &str) -> Option<(ScopeId, &Binding)> {
        let found = self.find_unnoted(id, name);
        if let Some(watch) = &self.watch {
            self.note_lookup(watch, id, name, found.map(|(holder, _)| holder));
        }
        found
    }

    fn find_unnoted(&self, id: ScopeId, name: &str) -> Option<(ScopeId, &Binding)> {
        let mut at = Some(id);
        while let Some(id) = at {
            let scope = self.get(id);
            if let Some((_, binding)) = scope.vars.get(name) {
                return Some((id, binding));
            }
            at = scope.parent;
        }
        None
    }

    /// What a scope holds itself, as the dict that it is in the reference: properties without a value yet as text.
    pub fn entries(&self, id: ScopeId) -> Vec<(EcoString, Value)> {
        self.note_unclear();
        let scope = self.get(id);
        let value = |binding: &Binding| match &binding.state {
            PropertyState::Lazy(text, _) => Value::Str(text.clone()),
            PropertyState::Ready(value) => value.clone(),
            PropertyState::Block(_) => Value::Unknown,
        };
        let mut entries: Vec<_> = scope
            .vars
            .iter()
            .map(|(name, binding)| (name.clone(), value(binding)))
            .collect();
        if let Some(place) = scope.evaluated {
            entries.insert(
                place.min(entries.len()),
                ("__builtins__".into(), Value::dict_from([], false)),
            );
        }
        entries
    }

    /// Note that an expression is evaluated in a scope.
    pub fn note_evaluation(&mut self, id: ScopeId) {
        if let Some(watch) = &mut self.watch {
            watch.get_mut().note_evaluation(id);
        }
        let scope = self.get_mut(id);
        scope.evaluated.get_or_insert(scope.vars.len());
    }

    /// Delete `name` from `id` and everything around it.
    pub fn remove_everywhere(&mut self, id: ScopeId, name: &str) {
        self.note_unclear();
        let mut at = Some(id);
        while let Some(id) = at {
            let scope = self.get_mut(id);
            scope.vars.remove(name);
            at = scope.parent;
        }
    }

    /// The properties that were never evaluated, by scope and name.
    pub fn unread(&self) -> Vec<(ScopeId, EcoString, Origin)> {
        let mut found = Vec::new();
        for (id, scope) in self.list.iter_ids() {
            let lazy = |(name, binding): (&EcoString, &Binding)| match &binding.state {
                PropertyState::Lazy(_, place) => Some((id, name.clone(), place.origin)),
                _ => None,
            };
            found.extend(scope.vars.iter().filter_map(lazy));
        }
        found.sort_by(|(a, name, _), (b, other, _)| a.cmp(b).then_with(|| name.cmp(other)));
        found
    }

    /// The scopes with a property that was never evaluated, but for that of the document.
    pub fn with_lazy(&self) -> impl Iterator<Item = ScopeId> {
        let has_lazy = |(_, scope): &(ScopeId, &PropertyScope)| {
            let mut bindings = scope.vars.iter().map(|(_, binding)| &binding.state);
            bindings.any(|state| matches!(state, PropertyState::Lazy(..)))
        };
        let scopes = self.list.iter_ids().skip(1).filter(has_lazy);
        scopes.map(|(id, _)| id)
    }

    /// Every name visible from `id`, for suggestions.
    pub fn visible_names(&self, id: ScopeId) -> Vec<&str> {
        self.visible(id, |name| (!name.starts_with('*')).then_some(name))
    }

    /// The names of all blocks seen from a scope, without their stars, sorted.
    pub fn visible_blocks(&self, id: ScopeId) -> Vec<&str> {
        self.visible(id, |name| {
            name.strip_prefix("**").or_else(|| name.strip_prefix('*'))
        })
    }

    fn visible<'a>(
        &'a self,
        id: ScopeId,
        shown: impl Fn(&'a str) -> Option<&'a str>,
    ) -> Vec<&'a str> {
        let mut names: Vec<&str> = Vec::new();
        let mut at = Some(id);
        while let Some(id) = at {
            names.extend(
                self.get(id)
                    .vars
                    .iter()
                    .filter_map(|(name, _)| shown(name.as_str())),
            );
            at = self.get(id).parent;
        }
        names.sort_unstable();
        names.dedup();
        names
    }

    /// Count scopes that were not made.
    pub fn skip(&mut self, count: usize) {
        self.list
            .extend(std::iter::repeat_with(PropertyScope::default).take(count));
    }

    /// Write down from now on what scopes that are there say to new ones.
    pub fn watch(&mut self) {
        let floor = self.list.next_id();
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
            .is_some_and(|watch| id < watch.borrow().floor)
        {
            self.note_unclear();
        }
    }

    /// Whether a property is left that nothing has evaluated, in a scope from the one of this number on.
    pub fn has_lazy_from(&self, start: usize) -> bool {
        let scopes = self.list.iter().skip(start);
        let mut bindings = scopes.flat_map(|scope| scope.vars.iter());
        bindings.any(|(_, binding)| matches!(binding.state, PropertyState::Lazy(..)))
    }

    pub fn note_lookup(
        &self,
        watch: &RefCell<Watch>,
        from: ScopeId,
        name: &str,
        found: Option<ScopeId>,
    ) {
        let mut watch = watch.borrow_mut();
        if found.is_some_and(|id| id >= watch.floor) {
            return;
        }
        let mut chain = std::iter::successors(Some(from), |&id| self.get(id).parent);
        let entry = chain.find(|&id| id < watch.floor);
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
