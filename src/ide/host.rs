//! Evaluating expressions for people who look at them: with the names that are known, within a small budget, and
//! without a word about what is wrong.

use ecow::EcoString;

use base::TextRange;
use expr::ast::Expr;
use expr::{self, Budget, ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId, Value};

/// Where names get their values from.
pub(super) trait NameResolver {
    /// A property or parameter.
    fn name(&mut self, name: &str) -> Lookup;

    /// A member of a namespace.
    fn member(&mut self, name: &str) -> Lookup;

    /// `$(arg name)`; unknown when it is not known.
    fn argument_value(&mut self, name: &str) -> Value;

    /// `xacro.load_yaml(...)`; unknown unless files may be read.
    fn yaml(&mut self, args: &[Value]) -> Value;
}

const STEPS: u64 = 10_000;
const BYTES: u64 = 1 << 20;

/// The budget of one evaluation that may be nested `depth` deep.
pub(super) fn budget(depth: u32) -> Budget {
    Budget::new(STEPS, BYTES, depth)
}

/// The value of an expression; unknown when something in it is.
pub(super) fn evaluate(expr: &Expr, names: &mut impl NameResolver, depth: u32) -> Value {
    expr::evaluate(expr, &mut NamesHost(names), &mut budget(depth)).unwrap_or(Value::Unknown)
}

struct NamesHost<'a, N>(&'a mut N);

impl<N: NameResolver> Host for NamesHost<'_, N> {
    fn lookup(&mut self, name: &str, _: TextRange) -> Lookup {
        self.0.name(name)
    }

    fn scope_attribute(&mut self, _: ScopeId, name: &str, _: TextRange) -> Lookup {
        self.0.member(name)
    }

    fn call(
        &mut self,
        function: HostFn,
        args: &[Value],
        _: &[(EcoString, Value)],
        _: TextRange,
    ) -> Result<Value, EvalError> {
        match (function, args) {
            (HostFn::Arg, [Value::Str(name)]) => Ok(self.0.argument_value(name)),
            (HostFn::LoadYaml, _) => Ok(self.0.yaml(args)),
            (HostFn::Arg | HostFn::AbsFilename, _) => Ok(Value::Unknown),
            // messages and errors are for those who run xacro
            _ => Err(EvalError::new(ErrorKind::Reported, "")),
        }
    }

    fn deprecated(&mut self, _: &str, _: &str, _: TextRange) {}

    fn undefined(&mut self, _: &str, _: TextRange) {}
}
