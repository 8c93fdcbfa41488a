//! The seam between the evaluator and whoever evaluates: where names come from and errors go to.

use std::fmt;

use ecow::EcoString;

use super::Value;
use base::TextRange;

/// Opaque number of a property scope (`ns=` of an include); only the host knows what it stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScopeId(pub u32);

base::ids!(ScopeId);

/// What a host knows of a name.
#[derive(Clone, Debug)]
pub enum Lookup {
    /// The value; [`Value::Unknown`] when an error about it was reported before.
    Found(Value),
    /// No such name.
    Missing,
}

/// Functions of the `xacro.` namespace, and of `$(eval)`, that need the host.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum HostFn {
    LoadYaml,
    AbsFilename,
    Arg,
    Message,
    Warning,
    Error,
    PrintLocation,
    Fatal,
    /// `env(name)` of `$(eval)`.
    Env,
    /// `optenv(name, default)` of `$(eval)`.
    OptEnv,
    /// `find(package)` of `$(eval)`.
    Find,
    /// `dirname()` of `$(eval)`.
    Dirname,
}

/// The world an expression is evaluated in.
///
/// All ranges are offsets in the text that was parsed.
pub trait Host {
    /// A name of the property scopes (without the global symbols: the evaluator knows these).
    fn lookup(&mut self, name: &str, range: TextRange) -> Lookup;

    /// A name inside a scope value; [`Lookup::Missing`] when neither it nor its parents have it
    /// (the evaluator then tries the global symbols, as the reference does).
    fn scope_attribute(&mut self, scope: ScopeId, name: &str, range: TextRange) -> Lookup;

    /// A name used inside of a comprehension or lambda, where `$(eval)` sees less.
    fn lookup_inside(&mut self, name: &str, range: TextRange) -> Lookup {
        self.lookup(name, range)
    }

    /// What a scope value holds itself, in the order of the definitions: names and values, properties that were
    /// never used as their text. None when the host does not know.
    fn scope_entries(&mut self, _: ScopeId) -> Option<Vec<(EcoString, Value)>> {
        None
    }

    /// Whether a scope value or one of its parents has a name.
    fn scope_holds(&mut self, _: ScopeId, _: &str) -> bool {
        false
    }

    /// Call a function of the `xacro.` namespace, or of `$(eval)`.
    ///
    /// # Errors
    /// Whatever the function raises, with the message Python would give.
    fn call(
        &mut self,
        function: HostFn,
        args: &[Value],
        keywords: &[(EcoString, Value)],
        range: TextRange,
    ) -> Result<Value, EvalError>;

    /// A symbol was called by its bare name that should be called as `namespace.name`.
    fn deprecated(&mut self, name: &str, namespace: &str, range: TextRange);

    /// The scope names are looked up in now, for functions (`lambda`) that outlive the expression they stand in:
    /// when one is called from another scope, its free names are looked up here by
    /// [`scope_attribute`](Host::scope_attribute). Without an answer, the scope of the call serves.
    fn current_scope(&self) -> Option<ScopeId> {
        None
    }

    /// A name is not defined. Evaluation goes on with [`Value::Unknown`], so that one expression
    /// can report several.
    fn undefined(&mut self, name: &str, range: TextRange);
}

/// An exception of the evaluated expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EvalError {
    /// Python's class of it.
    pub kind: ErrorKind,
    /// Exactly what `str(exception)` gives in CPython 3.11.
    pub message: String,
    /// The narrowest part of the expression that is to blame.
    pub range: TextRange,
}

impl EvalError {
    /// An error without a place yet; the evaluator fills in the range of the failing node.
    pub fn new(kind: ErrorKind, message: impl Into<String>) -> Self {
        Self {
            kind,
            message: message.into(),
            range: TextRange::default(),
        }
    }

    /// The same error at `range`, unless it has a place already.
    #[must_use]
    pub fn at(mut self, range: TextRange) -> Self {
        if self.range == TextRange::default() {
            self.range = range;
        }
        self
    }
}

impl fmt::Display for EvalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// Classes of errors.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum ErrorKind {
    Name,
    Syntax,
    Type,
    Value,
    ZeroDivision,
    Overflow,
    Index,
    Key,
    /// A key that a YAML mapping does not have.
    YamlKey,
    Attribute,
    StopIteration,
    /// `RuntimeError`, such as a dict that changes while it is iterated.
    Runtime,
    Recursion,
    /// A name or attribute that starts with `__`.
    ForbiddenName,
    /// `xacro.fatal`, or another error raised by the host.
    Xacro,
    /// A file that cannot be read.
    Io,
    /// A limit of ours: steps, bytes or depth.
    Budget,
    /// An error that was reported already; say nothing more about it.
    Reported,
}
