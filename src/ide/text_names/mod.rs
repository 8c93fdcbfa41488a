//! Which definition a name means, told from the texts alone: for what no expansion evaluated.
//!
//! An expansion knows each name that it came by. It says nothing of branches that are not taken, of the other half of
//! `a if c else b`, of macros that nobody calls and blocks that nobody inserts. Here all texts of a robot are read as if
//! everything were evaluated: with the scopes of xacro (the whole document, namespaces of includes, macros, which see
//! what their callers see), but without values. Where that leaves a choice, the answer is the choice.

mod answers;
mod collect;
mod files;
mod readings;
mod resolve;
mod timing;
mod ways;

use ecow::EcoString;
use facts::{facts_of, is_keyword};

pub use answers::{definitions_by_text, definitions_elsewhere, occurrences};
pub use ways::{Documents, further_places};

use crate::locate::{LocatedNode, NodePart};
use base::{FastMap, FastSet, FileId, IdVec, Span};
use expand::{SymbolKind, UseKind};

/// What the names of a robot's texts may mean.
#[derive(Debug, Default)]
pub struct TextNames {
    given: IdVec<TextDefinitionId, TextDefinition>,
    used: IdVec<UsedId, TextUse>,
    scopes: IdVec<TextScopeId, TextScope>,
    /// The condition around each condition.
    guards: Vec<Guard>,
    /// The files that were read.
    files: FastSet<FileId>,
    /// Where each file is read.
    readings: FastMap<FileId, Vec<Reading>>,
    /// The files that several conditions bring in.
    several: FastSet<FileId>,
    /// By file, the tags of the includes that bring it in.
    included_at: FastMap<FileId, Vec<Span>>,
    /// The definitions of a name.
    by_name: FastMap<(Class, EcoString), Vec<TextDefinitionId>>,
    /// Where macros are called, and blocks inserted: the scopes that their content sees.
    entered_from: FastMap<TextScopeId, Vec<TextScopeId>>,
    /// The calls of macros.
    calls_of: FastMap<TextDefinitionId, Vec<UsedId>>,
    /// When each macro is called, the first time and the last.
    called_at: FastMap<TextDefinitionId, (u32, u32)>,
}

/// A definition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextDefinition {
    /// What it defines.
    pub kind: SymbolKind,
    /// Its name.
    pub name: EcoString,
    /// The text of the name.
    pub span: Span,
    /// All that belongs to it: its element, or the name of a parameter.
    pub whole: Span,
    /// Of a parameter: its macro.
    of: Option<TextDefinitionId>,
    /// The scopes that it stands in.
    scopes: Vec<TextScopeId>,
    /// `scope="parent"`: it goes to whoever calls this macro.
    handed_out: bool,
    /// Its place in the order of evaluation.
    order: u32,
    /// Whether it is made whenever the conditions around it are taken: no `default`, no second include.
    is_sure: bool,
    /// The innermost condition around it.
    guard: Guard,
    /// Whether it is made when a macro is called.
    is_in_body: bool,
}

/// A text that uses a name.
#[derive(Clone, Debug, PartialEq, Eq)]
struct TextUse {
    kind: UseKind,
    class: Class,
    name: EcoString,
    span: Span,
    /// The scopes that it stands in.
    scopes: Vec<TextScopeId>,
    /// Of `ns.name`: `ns`. Of what a call gives: the macro.
    of: EcoString,
    order: u32,
    /// The innermost condition around it.
    guard: Guard,
    /// The property whose value it stands in, when that is evaluated later than where it stands.
    lazy_in: Option<TextDefinitionId>,
    /// Whether it is the name in an end tag.
    is_end: bool,
}

impl TextUse {
    /// Where and when it is evaluated, as far as its text says.
    fn seen(&self) -> EvaluationPoint {
        EvaluationPoint {
            file: self.span.file,
            guard: self.guard,
            order: self.order,
        }
    }

    /// Of a call: the name of the macro with its namespaces.
    fn called(&self) -> EcoString {
        match self.of.as_str() {
            "" => self.name.clone(),
            of => ecow::eco_format!("{of}.{}", self.name),
        }
    }
}

/// Names of different classes have nothing to do with each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Class {
    Value,
    Block,
    Argument,
    Macro,
}

impl Class {
    fn of(kind: SymbolKind) -> Self {
        match kind {
            SymbolKind::Property | SymbolKind::Parameter | SymbolKind::Namespace => Class::Value,
            SymbolKind::BlockProperty | SymbolKind::BlockParameter => Class::Block,
            SymbolKind::Argument => Class::Argument,
            SymbolKind::Macro => Class::Macro,
        }
    }
}

/// A scope: index of [`TextNames::scopes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct TextScopeId(u32);

impl TextScopeId {
    /// The document.
    const TOP: TextScopeId = TextScopeId(0);
}

/// A definition: index of [`TextNames::given`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct TextDefinitionId(u32);

/// A use: index of [`TextNames::used`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct UsedId(u32);

base::ids!(TextScopeId, TextDefinitionId, UsedId);

/// A condition, with those around it and around the includes and macros that it stands in: index of [`TextNames::guards`],
/// counted from one; zero: none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Guard(u32);

/// One of several times that a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Reading {
    scope: TextScopeId,
    guard: Guard,
    order: u32,
}

/// Where and when something is evaluated that definitions may be sure for.
#[derive(Clone, Copy, Debug)]
struct EvaluationPoint {
    file: FileId,
    guard: Guard,
    order: u32,
}

/// What holds names.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum TextScope {
    /// The document.
    Top,
    /// An include with `ns`: its name with those around it, and the scope that includes.
    Namespace(EcoString, TextScopeId),
    /// The body of a macro, or the content of a block, by its definition.
    Body(TextDefinitionId),
    /// Where a macro is called: nothing of its own, for the defaults of parameters.
    Callers(TextDefinitionId),
}

/// What a name may mean.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Meaning<'a> {
    /// This definition.
    One(&'a TextDefinition),
    /// One of these: callers, conditions or the order of evaluation decide.
    OneOf(Vec<&'a TextDefinition>),
    /// No definition, as far as the texts say: it is computed, stands in a file that is not known, or nowhere.
    Unknown,
}

impl<'a> Meaning<'a> {
    /// The definitions that it may be.
    pub fn all(&self) -> &[&'a TextDefinition] {
        match self {
            Meaning::One(given) => std::slice::from_ref(given),
            Meaning::OneOf(given) => given,
            Meaning::Unknown => &[],
        }
    }
}

/// A text that gives or uses a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NameText {
    /// The text.
    pub span: Span,
    /// Whether the name is given there.
    pub is_definition: bool,
    /// Whether it is the name in an end tag.
    pub is_end: bool,
}

/// Whether a name of a property, macro, parameter or argument may stand at a place.
pub(crate) fn may_be_name(at: &LocatedNode<'_>) -> bool {
    let Some(node) = at.node else { return false };
    let tag = node.name().strip_prefix("xacro:");
    match at.part {
        NodePart::StartName | NodePart::EndName | NodePart::AttrName(_) => tag.is_some(),
        NodePart::AttrValue(_) if tag.is_some_and(is_keyword) => true,
        NodePart::AttrValue(_) | NodePart::Text => {
            let inside = at.offset.saturating_sub(at.base);
            let facts = facts_of(at.item);
            facts
                .mentions()
                .any(|mention| mention.range.touches(inside))
        }
        NodePart::InTag | NodePart::Verbatim | NodePart::Between => false,
    }
}

impl TextNames {
    /// Whether a file is among the texts.
    pub fn knows(&self, file: FileId) -> bool {
        self.files.contains(&file)
    }

    /// The name at an offset of a file, and what it means.
    pub fn at(&self, file: FileId, offset: u32) -> Option<(Span, Meaning<'_>)> {
        let mut given = self.given.iter();
        if let Some(given) =
            given.find(|given| given.span.file == file && given.span.range.touches(offset))
        {
            return Some((given.span, Meaning::One(given)));
        }
        let used = self.use_at(file, offset)?;
        Some((used.span, self.meaning(used)))
    }

    /// Whether conditions decide if the name at an offset of a file means a definition that it may mean.
    fn depends(&self, file: FileId, offset: u32, definition: Span) -> bool {
        let Some(used) = self.use_at(file, offset) else {
            return false;
        };
        let meaning = self.meaning(used);
        let mut meant = meaning.all().iter();
        let own = meant.find(|given| given.span == definition);
        own.is_some_and(|own| !self.is_sure(own, used.seen()))
    }

    fn use_at(&self, file: FileId, offset: u32) -> Option<&TextUse> {
        let here = |used: &&TextUse| used.span.file == file && used.span.range.touches(offset);
        let used = self.used.iter().filter(here);
        used.min_by_key(|used| used.span.range.len())
    }

    /// The texts that use one of these definitions, or may do so.
    pub fn uses_of(&self, definitions: &[Span]) -> Vec<Span> {
        let names: Vec<_> = self
            .given
            .iter()
            .filter(|given| definitions.contains(&given.span))
            .collect();
        let named = |used: &&TextUse| names.iter().any(|given| given.name == used.name);
        let is_it = |used: &&TextUse| {
            self.meaning(used)
                .all()
                .iter()
                .any(|given| definitions.contains(&given.span))
        };
        self.used
            .iter()
            .filter(|used| !used.is_end)
            .filter(named)
            .filter(is_it)
            .map(|used| used.span)
            .collect()
    }
}
