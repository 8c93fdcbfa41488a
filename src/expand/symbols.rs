//! Which definition each name of the source refers to: what editors jump to, and what is never used.
use ecow::EcoString;

use super::origin::{Origin, SrcId};
use super::part::part;
use super::places::{Places, ShortHash};
use base::{FastSet, Id, SharedIdVec, SharedVec, TextRange};

/// A definition: index of [`Symbols::definitions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct DefinitionId(pub u32);

base::ids!(DefinitionId);

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SymbolKind {
    /// `xacro:property` with a value.
    Property,
    /// `xacro:property` with content: a block.
    BlockProperty,
    /// A parameter of a macro.
    Parameter,
    /// A `*block` parameter of a macro.
    BlockParameter,
    /// `xacro:arg`
    Argument,
    /// `xacro:macro`
    Macro,
    /// `ns=` of an include.
    Namespace,
}

/// A text of the source: a range relative to its item, whatever way leads there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SourceRange {
    /// The item.
    pub src: SrcId,
    /// Bytes relative to the item.
    pub range: TextRange,
}

impl From<Origin> for SourceRange {
    fn from(origin: Origin) -> Self {
        Self {
            src: origin.src,
            range: origin.range,
        }
    }
}

/// A name given by text of the source, however often expansion came by.
#[derive(Clone, Debug)]
pub struct Definition {
    /// What it stands for.
    pub kind: SymbolKind,
    /// The name; a computed name has one definition for each result.
    pub name: EcoString,
    /// Its text.
    pub place: SourceRange,
    /// Of a parameter: its macro.
    pub of: Option<DefinitionId>,
    /// Whether a condition stands around it.
    pub conditional: bool,
    /// Whether it stands inside a macro.
    pub in_macro: bool,
}

/// How a name is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum UseKind {
    /// Its value is read.
    Read,
    /// The macro is called.
    Call,
    /// A call gives the parameter a value.
    Given,
    /// The block is inserted.
    Insert,
}

/// A text that refers to a definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Use {
    /// The name's text.
    pub place: SourceRange,
    /// What it refers to.
    pub definition: DefinitionId,
    /// How.
    pub kind: UseKind,
}

/// All definitions and uses of an expansion, each once, in the order in which they were met.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    /// What introduces a name: properties, macros, parameters, arguments.
    pub definitions: SharedIdVec<DefinitionId, Definition>,
    /// Texts that refer to a definition, but for [`Symbols::quiet_uses`].
    pub uses: SharedVec<Use>,
    /// Uses by properties that nothing reads.
    pub quiet_uses: Vec<Use>,
    known: Places,
    used: Places,
    quietly_used: FastSet<Use>,
    /// Definitions that were known and turned out to be conditional, in order.
    pub(super) made_conditional: Vec<DefinitionId>,
    /// How many uses were put back.
    restored_uses: usize,
    log: Option<SymbolLog>,
}

/// Definitions and uses of a part of an expansion, known ones too.
#[derive(Clone, Debug, Default)]
pub(super) struct SymbolLog {
    pub definitions: Vec<(Definition, DefinitionId)>,
    /// With whether they are uses by properties that nothing reads.
    pub uses: Vec<(Use, bool)>,
}

impl Symbols {
    /// The definition of an id.
    pub fn get(&self, id: DefinitionId) -> Option<&Definition> {
        self.definitions.get(id)
    }

    /// All definitions with their ids.
    pub fn iter(&self) -> impl Iterator<Item = (DefinitionId, &Definition)> {
        self.definitions.iter_ids()
    }

    /// The uses of a definition.
    pub fn uses_of(&self, definition: DefinitionId) -> impl Iterator<Item = &Use> {
        self.uses
            .iter()
            .filter(move |used| used.definition == definition)
    }

    /// All uses, also those by properties that nothing reads.
    pub fn all_uses(&self) -> impl Iterator<Item = &Use> {
        self.uses.iter().chain(&self.quiet_uses)
    }

    /// Put back what others had when they had so many definitions and uses, and so many had turned out to be conditional.
    pub(super) fn restore(
        &mut self,
        others: &Self,
        (definitions, uses, conditional): (usize, usize, usize),
    ) {
        (self.known, self.used) = (others.known.clone(), others.used.clone());
        let own = self.definitions.list_mut();
        own.extend_from(others.definitions.list(), 0..definitions);
        let (before, later) = others
            .made_conditional
            .split_at_checked(conditional)
            .unwrap_or_default();
        self.made_conditional.extend(before);
        self.set_conditional(later, false);
        self.uses.extend_from(&others.uses, 0..uses);
        self.restored_uses = self.uses.len();
    }

    /// Add what others added from some place on up to another one: each is how many definitions, uses and conditional ones they had.
    /// There are as many definitions as they had at the first place.
    pub(super) fn add_between(
        &mut self,
        others: &Self,
        from: (usize, usize, usize),
        to: (usize, usize, usize),
    ) {
        debug_assert_eq!(self.definitions.len(), from.0);
        let own = self.definitions.list_mut();
        own.extend_from(others.definitions.list(), from.0..to.0);
        let later = others.made_conditional.get(to.2..).unwrap_or_default();
        let later: Vec<DefinitionId> = later
            .iter()
            .copied()
            .filter(|id| (from.0..to.0).contains(&id.index()))
            .collect();
        self.set_conditional(&later, false);
        let made = part(&others.made_conditional, from.2..to.2);
        self.set_conditional(made, true);
        self.made_conditional.extend(made);
        let mut own = self.uses.range(self.restored_uses..self.uses.len());
        let is_among = |used| {
            others
                .place_of(used)
                .is_some_and(|at| (from.1..to.1).contains(&at))
        };
        // at the same places the table that both share knows them
        if self.uses.len() == from.1 && !own.any(is_among) {
            self.uses.extend_from(&others.uses, from.1..to.1);
        } else {
            let added = others.uses.range(from.1..to.1);
            added.for_each(|&used| self.add_use(used, false));
        }
    }

    fn set_conditional(&mut self, definitions: &[DefinitionId], conditional: bool) {
        for &id in definitions {
            if let Some(definition) = self.definitions.get_mut(id) {
                definition.conditional = conditional;
            }
        }
    }

    /// They are complete: the next expansion may share them.
    pub(super) fn finish(&mut self) {
        self.quietly_used = FastSet::default();
        self.known.finish(self.definitions.iter().map(hash_of));
        self.used.finish(self.uses.iter().map(ShortHash::of));
        self.definitions.list_mut().finish();
        self.uses.finish();
    }

    pub(super) fn start_log(&mut self) {
        self.log = Some(SymbolLog::default());
    }

    pub(super) fn take_log(&mut self) -> SymbolLog {
        self.log.take().unwrap_or_default()
    }

    /// The number of a definition that was met.
    pub(super) fn number_of(&self, definition: &Definition) -> Option<DefinitionId> {
        let is_at = |place: usize| {
            let known = self.definitions.list().get(place);
            known.is_some_and(|known| {
                known.place == definition.place && known.name == definition.name
            })
        };
        let found = self.known.find(hash_of(definition), is_at);
        found.map(DefinitionId::from_index)
    }

    /// Where a use stands that is not a quiet one.
    fn place_of(&self, used: &Use) -> Option<usize> {
        self.used.find(ShortHash::of(used), |place| {
            self.uses.get(place) == Some(used)
        })
    }

    pub(super) fn add(&mut self, definition: Definition) -> DefinitionId {
        let next = self.definitions.next_id();
        let id = self.number_of(&definition).unwrap_or(next);
        if let Some(log) = &mut self.log {
            log.definitions.push((definition.clone(), id));
        }
        if id == next {
            self.known.add(hash_of(&definition), next.index());
            self.definitions.push(definition);
        } else if definition.conditional
            && let Some(known) = self.definitions.get_mut(id)
            && !known.conditional
        {
            known.conditional = true;
            self.made_conditional.push(id);
        }
        id
    }

    pub(super) fn add_use(&mut self, used: Use, quiet: bool) {
        if let Some(log) = &mut self.log
            && !log.uses.contains(&(used, quiet))
        {
            log.uses.push((used, quiet));
        }
        if self.place_of(&used).is_some() || self.quietly_used.contains(&used) {
            return;
        }
        if quiet {
            self.quietly_used.insert(used);
            self.quiet_uses.push(used);
        } else {
            self.used.add(ShortHash::of(used), self.uses.len());
            self.uses.push(used);
        }
    }
}

/// The hash of what tells a definition from others: its text and its name.
fn hash_of(definition: &Definition) -> ShortHash {
    ShortHash::of((definition.place, definition.name.as_str()))
}
