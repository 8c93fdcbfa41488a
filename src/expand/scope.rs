//! Symbol tables: chains of properties, and chains of macros.
#![allow(clippy::indexing_slicing)] // ids are made by these tables only and never outlive them

use std::cell::RefCell;
use std::sync::Arc;

use ecow::EcoString;
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

use super::origin::{Origin, SrcId};
use super::symbols::DefinitionId;
use super::tree::XId;
use super::watch::{MacroWatch, Watch};
use base::{FastMap, TextRange};
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
pub(super) struct Place {
    /// The text as it is written, and the frame it was reached through.
    pub origin: Origin,
    /// Whether it is an attribute value (character data otherwise).
    pub is_attr: bool,
}

/// What a property scope knows of a name.
#[derive(Clone, Debug)]
pub(super) struct Binding {
    pub state: State,
    /// Index in the expansion's list of bindings.
    pub info: u32,
}

/// The life of a property.
#[derive(Clone, Debug)]
pub(super) enum State {
    /// Not evaluated yet: evaluated on first use, in the scope that holds it.
    Lazy(EcoString, Place),
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
#[derive(Debug, Default)]
pub(super) struct Scope {
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
#[derive(Debug, Default)]
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

    fn remove(&mut self, name: &str) {
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

/// All property scopes of an expansion; none is ever dropped, since lambdas may keep one.
#[derive(Debug)]
pub(super) struct Scopes {
    pub(super) list: Vec<Scope>,
    pub(super) watch: Option<RefCell<Watch>>,
}

impl Scopes {
    pub const TOP: ScopeId = ScopeId(0);

    pub fn new() -> Self {
        Self {
            list: vec![Scope::default()],
            watch: None,
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    pub fn push(&mut self, parent: ScopeId, is_namespace: bool) -> ScopeId {
        let id = ScopeId(self.list.len() as u32);
        self.list.push(Scope {
            parent: Some(parent),
            is_namespace,
            ..Scope::default()
        });
        id
    }

    pub fn get(&self, id: ScopeId) -> &Scope {
        &self.list[id.0 as usize]
    }

    pub fn get_mut(&mut self, id: ScopeId) -> &mut Scope {
        &mut self.list[id.0 as usize]
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
        let found = self.holder_of(id, name);
        if let Some(watch) = &self.watch {
            self.note_lookup(watch, id, name, found);
        }
        found
    }

    fn holder_of(&self, id: ScopeId, name: &str) -> Option<ScopeId> {
        let mut at = Some(id);
        while let Some(id) = at {
            let scope = self.get(id);
            if scope.vars.get(name).is_some() {
                return Some(id);
            }
            at = scope.parent;
        }
        None
    }

    /// The binding of `name` visible from `id`, and the scope that holds it.
    pub fn find(&self, id: ScopeId, name: &str) -> Option<(ScopeId, &Binding)> {
        let holder = self.holder(id, name)?;
        self.get(holder)
            .vars
            .get(name)
            .map(|(_, binding)| (holder, binding))
    }

    /// What a scope holds itself, as the dict that it is in the reference: properties without a value yet as text.
    pub fn entries(&self, id: ScopeId) -> Vec<(EcoString, Value)> {
        self.note_unclear();
        let scope = self.get(id);
        let value = |binding: &Binding| match &binding.state {
            State::Lazy(text, _) => Value::Str(text.clone()),
            State::Ready(value) => value.clone(),
            State::Block(_) => Value::Unknown,
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
        for (id, scope) in (0..).map(ScopeId).zip(&self.list) {
            let lazy = |(name, binding): (&EcoString, &Binding)| match &binding.state {
                State::Lazy(_, place) => Some((id, name.clone(), place.origin)),
                _ => None,
            };
            found.extend(scope.vars.iter().filter_map(lazy));
        }
        found.sort_by(|(a, name, _), (b, other, _)| a.0.cmp(&b.0).then_with(|| name.cmp(other)));
        found
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
}

/// A macro table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MacrosId(pub u32);

#[derive(Debug)]
pub(super) enum MacroEntry {
    Macro(Arc<MacroDef>),
    Namespace(MacrosId),
}

#[derive(Debug, Default)]
pub(super) struct MacroTable {
    pub(super) parent: Option<MacrosId>,
    entries: FastMap<EcoString, MacroEntry>,
}

/// A macro definition.
#[derive(Debug)]
pub(super) struct MacroDef {
    pub name: EcoString,
    pub body: SrcRef,
    /// Where it stands: range of its `name` value.
    pub origin: Origin,
    pub definition: DefinitionId,
    pub params: Params,
}

/// A parameter specification.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Param {
    /// Its name; that of a block begins with `*` or `**`.
    pub name: EcoString,
    /// Where it stands in the (decoded) `params` text.
    pub range: TextRange,
    /// Where it stands in the source, and its definition; none when the list was not read from a tag.
    pub definition: Option<(Origin, DefinitionId)>,
    /// `^`: take the caller's property of the same name.
    pub forward: bool,
    /// The default, where there is one, and where it stands in that text.
    pub default: Option<(EcoString, TextRange)>,
    /// Where the default stands in the source.
    pub default_at: Option<Origin>,
}

impl Param {
    /// A parameter without default that no list names.
    pub(super) fn named(name: EcoString) -> Self {
        let range = TextRange::default();
        Self {
            name,
            range,
            definition: None,
            forward: false,
            default: None,
            default_at: None,
        }
    }

    /// One of the names in a name that is none, with the default if it is the last one. The places stay inside the whole.
    pub(super) fn part(&self, name: &str, is_last: bool) -> Self {
        let start = self.range.start + self.name.find(name).unwrap_or(0) as u32;
        let part = Self {
            name: name.into(),
            range: TextRange::new(start, start + name.len() as u32),
            ..self.clone()
        };
        if is_last {
            part
        } else {
            Self {
                default: None,
                forward: false,
                ..part
            }
        }
    }

    /// Whether a call gives it as a child element.
    pub fn is_block(&self) -> bool {
        self.name.starts_with('*')
    }
}

/// The parameters of a macro.
#[derive(Debug, Default)]
pub(super) struct Params {
    list: Vec<Param>,
    /// Of each name, the first one.
    first: FastMap<EcoString, usize>,
    /// Of each name, the last one that says which value it has when a call gives none.
    fallback: FastMap<EcoString, usize>,
}

impl Params {
    pub fn new(list: Vec<Param>) -> Self {
        let (mut first, mut fallback) = (FastMap::default(), FastMap::default());
        for (index, param) in list.iter().enumerate() {
            first.entry(param.name.clone()).or_insert(index);
            if param.forward || param.default.is_some() {
                fallback.insert(param.name.clone(), index);
            }
        }
        Self {
            list,
            first,
            fallback,
        }
    }

    pub fn iter(&self) -> std::slice::Iter<'_, Param> {
        self.list.iter()
    }

    /// What a parameter is when a call does not give it.
    pub fn fallback(&self, name: &str) -> Option<&Param> {
        self.list.get(*self.fallback.get(name)?)
    }
}

/// The parameters that a call has not given yet.
pub(super) struct Open<'p> {
    params: &'p Params,
    given: Vec<bool>,
}

impl<'p> Open<'p> {
    pub fn new(params: &'p Params) -> Self {
        Self {
            params,
            given: vec![false; params.list.len()],
        }
    }

    /// Give the first one of that name.
    pub fn take(&mut self, name: &str) -> Option<&'p Param> {
        let first = *self.params.first.get(name)?;
        let mut from = self.params.list.iter().zip(&mut self.given).skip(first);
        let (param, given) = from.find(|(param, given)| !**given && param.name == name)?;
        *given = true;
        Some(param)
    }

    /// Those that are left, in order.
    pub fn left(self) -> Vec<&'p Param> {
        let left = self
            .params
            .iter()
            .zip(self.given)
            .filter(|(_, given)| !given);
        left.map(|(param, _)| param).collect()
    }
}

/// All macro tables of an expansion.
#[derive(Debug)]
pub(super) struct Macros {
    pub(super) list: Vec<MacroTable>,
    pub(super) watch: Option<RefCell<MacroWatch>>,
}

impl Macros {
    pub const TOP: MacrosId = MacrosId(0);

    pub fn new() -> Self {
        Self {
            list: vec![MacroTable::default()],
            watch: None,
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    pub fn push(&mut self, parent: Option<MacrosId>) -> MacrosId {
        let id = MacrosId(self.list.len() as u32);
        self.list.push(MacroTable {
            parent,
            ..MacroTable::default()
        });
        id
    }

    pub fn define(&mut self, at: MacrosId, def: MacroDef) -> Arc<MacroDef> {
        self.note_change(at);
        let def = Arc::new(def);
        self.list[at.0 as usize]
            .entries
            .insert(def.name.clone(), MacroEntry::Macro(def.clone()));
        def
    }

    pub fn define_namespace(&mut self, at: MacrosId, name: EcoString, table: MacrosId) {
        self.note_change(at);
        self.list[at.0 as usize]
            .entries
            .insert(name, MacroEntry::Namespace(table));
    }

    fn entry(&self, at: MacrosId, name: &str) -> Option<&MacroEntry> {
        let found = self.entry_of(at, name);
        if let Some(watch) = &self.watch {
            self.note_lookup(watch, at, name, found);
        }
        found.map(|(_, entry)| entry)
    }

    fn entry_of(&self, at: MacrosId, name: &str) -> Option<(MacrosId, &MacroEntry)> {
        let mut at = Some(at);
        while let Some(id) = at {
            let table = &self.list[id.0 as usize];
            if let Some(entry) = table.entries.get(name) {
                return Some((id, entry));
            }
            at = table.parent;
        }
        None
    }

    /// The macro called `name` in the chain from `at`.
    pub fn find(&self, at: MacrosId, name: &str) -> Option<Arc<MacroDef>> {
        match self.entry(at, name)? {
            MacroEntry::Macro(def) => Some(def.clone()),
            MacroEntry::Namespace(_) => None,
        }
    }

    /// The table of namespace `name` in the chain from `at`.
    pub fn namespace(&self, at: MacrosId, name: &str) -> Option<MacrosId> {
        match self.entry(at, name)? {
            MacroEntry::Namespace(id) => Some(*id),
            MacroEntry::Macro(_) => None,
        }
    }

    /// The table that the last part of a dotted `name` is looked up in, the part before it, and the last part itself; the
    /// table at hand and the whole name where the part before is no namespace.
    pub fn inside<'n>(&self, at: MacrosId, name: &'n str) -> (MacrosId, &'n str, &'n str) {
        let split = name.rfind('.').map(|dot| name.split_at(dot + 1));
        let Some((path, own)) = split else {
            return (at, "", name);
        };
        let mut steps = path.trim_end_matches('.').split('.');
        match steps.try_fold(at, |table, step| self.namespace(table, step)) {
            Some(table) => (table, path, own),
            None => (at, "", name),
        }
    }

    /// Every macro name that can be called from `at` without a namespace, for suggestions.
    pub fn visible_names(&self, at: MacrosId) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        let mut at = Some(at);
        while let Some(id) = at {
            let table = &self.list[id.0 as usize];
            names.extend(
                table
                    .entries
                    .iter()
                    .filter_map(|(name, entry)| match entry {
                        MacroEntry::Macro(_) => Some(name.as_str()),
                        MacroEntry::Namespace(_) => None,
                    }),
            );
            at = table.parent;
        }
        names.sort_unstable();
        names.dedup();
        names
    }
}
