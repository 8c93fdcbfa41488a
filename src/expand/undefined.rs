//! Names that are not defined, or not yet.
use ecow::EcoString;

use base::FastMap;
use expr::ScopeId;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum UndefinedKind {
    Property,
    Macro,
    Arg,
    Block,
}

impl UndefinedKind {
    pub(super) fn noun(self) -> &'static str {
        match self {
            UndefinedKind::Property => "property",
            UndefinedKind::Macro => "macro",
            UndefinedKind::Arg => "argument",
            UndefinedKind::Block => "block",
        }
    }
}

/// Problems about undefined names, by name.
pub(super) type Undefined = FastMap<(UndefinedKind, EcoString), Vec<Early>>;

/// A use of a name that was not defined yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Early {
    /// Its index in the list of problems.
    pub problem: usize,
    /// The scope that the name was looked up in.
    pub scope: ScopeId,
}

/// A name that is not defined.
#[derive(Clone, Debug)]
pub(super) struct UndefinedName<'n> {
    pub(super) kind: UndefinedKind,
    pub(super) name: &'n str,
    /// It is one that is there, spelled wrong: nothing from outside defines it.
    pub(super) is_misspelled: bool,
    /// The closest name that is there.
    pub(super) near: Option<EcoString>,
}
