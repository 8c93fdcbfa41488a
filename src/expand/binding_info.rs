//! Properties, parameters and arguments that the expanded text refers to.
use ecow::EcoString;

use super::origin::Origin;
use super::symbols::DefinitionId;
use base::TextRange;
use expr::Value;

/// An instance of a property, parameter or argument: index of [`NameIndex::bindings`](super::NameIndex::bindings).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BindingId(u32);

base::ids!(BindingId);

/// Where a value that an expression read was given.
#[derive(Clone, Debug)]
pub struct BindingInfo {
    /// Its name.
    pub name: EcoString,
    /// What it is.
    pub kind: BindingKind,
    /// The text that gives the value; none for arguments from outside.
    pub origin: Option<Origin>,
    /// The definition it is an instance of.
    pub definition: Option<DefinitionId>,
    /// Bindings that were read to compute it: see [`Expansion::read_in`](super::Expansion::read_in).
    pub reads: TextRange,
    /// Its value; none for a block.
    pub value: Option<Value>,
}

/// The kinds of bindings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BindingKind {
    /// `xacro:property`
    Property,
    /// A macro parameter.
    Parameter,
    /// `xacro:arg`, or an argument from outside.
    Argument,
    /// The name of `ns=`.
    Namespace,
}

impl BindingInfo {
    /// An argument given from outside.
    pub fn given(name: &str, value: Value) -> Self {
        let (origin, definition, reads) = (None, None, TextRange::default());
        let value = Some(value);
        Self {
            name: name.into(),
            kind: BindingKind::Argument,
            origin,
            definition,
            reads,
            value,
        }
    }

    /// Something given by source text.
    pub fn new(name: EcoString, kind: BindingKind, origin: Origin) -> Self {
        Self {
            name,
            kind,
            origin: Some(origin),
            definition: None,
            reads: TextRange::default(),
            value: None,
        }
    }

    /// As an instance of a definition.
    pub fn of(mut self, definition: DefinitionId) -> Self {
        self.definition = Some(definition);
        self
    }
}

/// The value of an argument, where it is known, and its binding.
pub(super) type ArgumentValue = (Option<EcoString>, BindingId);

/// A lazy property being evaluated, and the text that asked for it.
#[derive(Clone, Debug)]
pub(super) struct LazyUse {
    pub name: EcoString,
    pub at: Origin,
}
