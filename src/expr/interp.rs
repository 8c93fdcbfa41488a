//! The state of one evaluation, and how names find their values.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::ast::Expr;
use super::budget::Budget;
use super::builtins;
use super::host::{EvalError, Host, Lookup, ScopeId};
use super::literal;
use super::stop::{Eval, Stop};
use super::value::{Closure, Locals, Str, Value};
use base::TextRange;

/// Evaluate an expression.
///
/// Names are looked up in the variables of the expression itself, then in `host`, then among the global symbols.
/// An undefined name is reported to `host` and the evaluation goes on with [`Value::Unknown`].
///
/// # Errors
/// The exception Python would raise, placed at the narrowest part of the expression to blame, or
/// [`ErrorKind::Budget`](super::ErrorKind::Budget) when `budget` is used up.
pub fn evaluate(expr: &Expr, host: &mut dyn Host, budget: &mut Budget) -> Result<Value, EvalError> {
    let mut interp = Interp {
        host,
        budget,
        env: None,
        top: None,
        scope: None,
        home: 0,
        elsewhere: None,
        at: expr.range,
    };
    match interp.eval(expr) {
        Ok(value) => Ok(value),
        Err(Stop::Unknown) => Ok(Value::Unknown),
        Err(Stop::Raise(error)) => Err(error.at(expr.range)),
    }
}

/// What a lambda or generator takes along from where it was written.
#[derive(Clone, Debug)]
pub(crate) struct ClosureContext {
    pub(crate) env: Option<Arc<Locals>>,
    pub(crate) scope: Option<ScopeId>,
    pub(crate) home: u64,
}

/// One evaluation under way.
pub(crate) struct Interp<'a> {
    pub(crate) host: &'a mut dyn Host,
    pub(crate) budget: &'a mut Budget,
    /// Variables of the comprehensions and lambdas around the current node.
    pub(crate) env: Option<Arc<Locals>>,
    /// Variables bound by `:=` outside of any lambda.
    top: Option<Arc<Locals>>,
    /// Where free names are looked up; none for the host's current scope.
    scope: Option<ScopeId>,
    /// Identifies this evaluation to the lambdas it creates; 0 before the first.
    home: u64,
    /// While a lambda of another evaluation runs: the place of its call, as its own places mean nothing here.
    elsewhere: Option<TextRange>,
    /// The call being evaluated.
    pub(crate) at: TextRange,
}

impl Interp<'_> {
    /// Where to report something about the node at `range`.
    pub(crate) fn place(&self, range: TextRange) -> TextRange {
        self.elsewhere.unwrap_or(range)
    }

    /// One level deeper; every success must be matched by [`Interp::up`].
    pub(crate) fn down(&mut self) -> Eval<()> {
        match self.budget.depth.checked_sub(1) {
            Some(left) => {
                self.budget.depth = left;
                Ok(())
            }
            None => Err(Stop::recursion("")),
        }
    }

    pub(crate) fn up(&mut self) {
        self.budget.depth += 1;
    }

    /// Python's `bool()`.
    pub(crate) fn truth(&mut self, value: &Value) -> Eval<bool> {
        match value {
            Value::Scope(_) => Ok(!self.entries(value)?.is_empty()),
            _ => literal::truth(value).ok_or(Stop::Unknown),
        }
    }

    /// What a lambda or generator written here takes along.
    pub(crate) fn context(&mut self) -> ClosureContext {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        if self.home == 0 {
            self.home = NEXT.fetch_add(1, Ordering::Relaxed);
        }
        let scope = self.scope.or_else(|| self.host.current_scope());
        ClosureContext {
            env: self.env.clone(),
            scope,
            home: self.home,
        }
    }

    /// Run `body` with the names of `context`.
    pub(crate) fn inside<T>(
        &mut self,
        context: ClosureContext,
        body: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let elsewhere = if context.home == self.home {
            self.elsewhere
        } else {
            Some(self.place(self.at))
        };
        let scope = if context.home == self.home {
            self.scope
        } else {
            context.scope
        };
        let at = self.at;
        let env = std::mem::replace(&mut self.env, context.env);
        let scope = std::mem::replace(&mut self.scope, scope);
        let elsewhere = std::mem::replace(&mut self.elsewhere, elsewhere);
        let result = body(self);
        (self.env, self.scope, self.elsewhere, self.at) = (env, scope, elsewhere, at);
        result
    }

    /// The value of a name.
    pub(crate) fn name(&mut self, name: &str, range: TextRange) -> Eval {
        if let Some(value) = self.local(name) {
            return Ok(value);
        }
        let place = self.place(range);
        let found = match self.scope {
            None if self.env.is_some() => self.host.lookup_inside(name, place),
            None => self.host.lookup(name, place),
            Some(scope) => self.host.scope_attribute(scope, name, place),
        };
        if let Lookup::Found(value) = found {
            return Ok(value);
        }
        if let Some(value) = builtins::global(name) {
            return Ok(value);
        }
        self.host.undefined(name, place);
        Ok(Value::Unknown)
    }

    fn local(&self, name: &str) -> Option<Value> {
        let mut frame = self.env.as_deref();
        while let Some(current) = frame {
            if let Some(value) = current.get(name) {
                return Some(value);
            }
            frame = current.parent.as_deref();
        }
        self.top.as_deref().and_then(|top| top.get(name))
    }

    /// `name := value`
    pub(crate) fn bind(&mut self, name: &Str, value: Value) {
        let mut frame = self.env.as_deref();
        while let Some(current) = frame.filter(|frame| frame.comprehension) {
            frame = current.parent.as_deref();
        }
        match frame {
            Some(frame) => frame.set(name, value),
            None => {
                let top = self
                    .top
                    .get_or_insert_with(|| Arc::new(Locals::new(None, false, Vec::new())));
                top.set(name, value);
            }
        }
    }

    /// The context in which the body of `closure` runs, with its own variables.
    pub(crate) fn closure_context(closure: &Closure, vars: Vec<(Str, Value)>) -> ClosureContext {
        let frame = Locals::new(closure.env.clone(), false, vars);
        ClosureContext {
            env: Some(Arc::new(frame)),
            scope: closure.scope,
            home: closure.home,
        }
    }
}
