//! Names, and what they stand for while the document is evaluated.
use ecow::EcoString;

use super::binding_info::{ArgumentValue, BindingId, LazyUse};
use super::macro_table::{Macros, MacrosId};
use super::origin::FrameId;
use super::scope::Scopes;
use super::undefined::Undefined;
use base::FastMap;
use expr::ScopeId;

/// What names mean where something is evaluated, and the calls and includes that led there.
#[derive(Clone, Copy, Debug)]
pub(super) struct EvalContext {
    pub scope: ScopeId,
    pub macros: MacrosId,
    pub frame: FrameId,
}

/// Names and what they stand for.
pub(super) struct NameTables {
    pub scopes: Scopes,
    pub macros: Macros,
    /// Arguments: value (none when unknown) and binding.
    pub args: FastMap<EcoString, ArgumentValue>,
    /// Lazy properties being evaluated, outermost first.
    pub lazy_uses: Vec<LazyUse>,
    /// Bindings read since the mark of whoever is interested.
    pub reads: Vec<BindingId>,
    /// Problems about undefined names, in case they turn out to be defined later.
    pub undefined: Undefined,
    /// Names that undefined ones were compared with.
    pub compared: usize,
}

impl NameTables {
    pub(super) fn new() -> Self {
        Self {
            scopes: Scopes::new(),
            macros: Macros::new(),
            args: FastMap::default(),
            lazy_uses: Vec::new(),
            reads: Vec::new(),
            undefined: Undefined::default(),
            compared: 0,
        }
    }
}
