//! Macros: tables of definitions, and their parameters.
#![allow(clippy::indexing_slicing)] // ids are made by these tables only and never outlive them
use std::cell::RefCell;
use std::sync::Arc;

use ecow::EcoString;

use super::origin::Origin;
use super::scope::SrcRef;
use super::symbols::DefinitionId;
use base::{FastMap, Id, IdVec, TextRange};

/// A macro table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct MacrosId(u32);

base::ids!(MacrosId);

#[derive(Clone, Debug)]
pub(super) enum MacroEntry {
    Macro(Arc<MacroDef>),
    Namespace(MacrosId),
}

#[derive(Clone, Debug, Default)]
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
    pub params: MacroParams,
}

/// A parameter specification.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MacroParam {
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

impl MacroParam {
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
pub(super) struct MacroParams {
    list: Vec<MacroParam>,
    /// Of each name, the first one.
    first: FastMap<EcoString, usize>,
    /// Of each name, the last one that says which value it has when a call gives none.
    fallback: FastMap<EcoString, usize>,
}

impl MacroParams {
    pub fn new(list: Vec<MacroParam>) -> Self {
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

    pub fn iter(&self) -> std::slice::Iter<'_, MacroParam> {
        self.list.iter()
    }

    /// What a parameter is when a call does not give it.
    pub fn fallback(&self, name: &str) -> Option<&MacroParam> {
        self.list.get(*self.fallback.get(name)?)
    }
}

/// The parameters that a call has not given yet.
pub(super) struct OpenParams<'p> {
    params: &'p MacroParams,
    given: Vec<bool>,
}

impl<'p> OpenParams<'p> {
    pub fn new(params: &'p MacroParams) -> Self {
        Self {
            params,
            given: vec![false; params.list.len()],
        }
    }

    /// Give the first one of that name.
    pub fn take(&mut self, name: &str) -> Option<&'p MacroParam> {
        let first = *self.params.first.get(name)?;
        let mut from = self.params.list.iter().zip(&mut self.given).skip(first);
        let (param, given) = from.find(|(param, given)| !**given && param.name == name)?;
        *given = true;
        Some(param)
    }

    /// Those that are left, in order.
    pub fn left(self) -> Vec<&'p MacroParam> {
        let left = self
            .params
            .iter()
            .zip(self.given)
            .filter(|(_, given)| !given);
        left.map(|(param, _)| param).collect()
    }
}

/// What is looked up outside of a step.
#[derive(Debug)]
pub(super) struct MacroWatch {
    /// The first table of the step.
    floor: MacrosId,
    /// The macros of the document.
    names: Vec<(EcoString, Option<SrcRef>)>,
    /// Something else was read or written.
    unclear: bool,
}

/// All macro tables of an expansion.
#[derive(Debug)]
pub(super) struct Macros {
    pub(super) list: IdVec<MacrosId, MacroTable>,
    pub(super) watch: Option<RefCell<MacroWatch>>,
}

impl Macros {
    pub const TOP: MacrosId = MacrosId(0);

    pub fn new() -> Self {
        Self {
            list: IdVec::from(vec![MacroTable::default()]),
            watch: None,
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    pub fn push(&mut self, parent: Option<MacrosId>) -> MacrosId {
        self.list.push(MacroTable {
            parent,
            ..MacroTable::default()
        })
    }

    fn table(&self, id: MacrosId) -> &MacroTable {
        &self.list.as_slice()[id.index()]
    }

    fn table_mut(&mut self, id: MacrosId) -> &mut MacroTable {
        &mut self.list.as_mut_slice()[id.index()]
    }

    pub fn define(&mut self, at: MacrosId, def: MacroDef) -> Arc<MacroDef> {
        self.note_change(at);
        let def = Arc::new(def);
        self.table_mut(at)
            .entries
            .insert(def.name.clone(), MacroEntry::Macro(def.clone()));
        def
    }

    pub fn define_namespace(&mut self, at: MacrosId, name: EcoString, table: MacrosId) {
        self.note_change(at);
        self.table_mut(at)
            .entries
            .insert(name, MacroEntry::Namespace(table));
    }

    /// What the table itself holds of a name.
    pub fn own(&self, at: MacrosId, name: &str) -> Option<&MacroEntry> {
        self.table(at).entries.get(name)
    }

    /// Put an entry into a table, or take it away.
    pub fn put(&mut self, at: MacrosId, name: &EcoString, entry: Option<MacroEntry>) {
        let entries = &mut self.table_mut(at).entries;
        match entry {
            Some(entry) => entries.insert(name.clone(), entry),
            None => entries.remove(name),
        };
    }

    /// Take the table of the document away.
    pub fn take_top(&mut self) -> MacroTable {
        std::mem::take(self.table_mut(Self::TOP))
    }

    /// Replace the table of the document.
    pub fn put_top(&mut self, table: MacroTable) {
        *self.table_mut(Self::TOP) = table;
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
            let table = self.table(id);
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
            let table = self.table(id);
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

    /// Count tables that were not made.
    pub fn skip(&mut self, count: usize) {
        self.list
            .extend(std::iter::repeat_with(MacroTable::default).take(count));
    }

    /// Write down from now on what tables that are there say to new ones.
    pub fn watch(&mut self) {
        let floor = self.list.next_id();
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
            watch.unclear |= at < watch.floor;
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
        if found.is_some_and(|(id, _)| id >= watch.floor) {
            return;
        }
        let parent = |&id: &MacrosId| self.table(id).parent;
        let entry = std::iter::successors(Some(from), parent).find(|&id| id < watch.floor);
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
