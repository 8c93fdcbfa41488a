//! What the evaluation of a parsed expression costs. Compare the lines with each other, not with other machines.

use divan::Bencher;
use ecow::EcoString;
use xacro_lsp::base::TextRange;
use xacro_lsp::expr::{self, Budget, EvalError, Host, HostFn, Lookup, ScopeId, Value};

/// As they stand in robot descriptions.
const EXPRESSIONS: &[&str] = &[
    "a*2 + b",
    "pi/2",
    "-b",
    "radians(90)",
    "s + '_link'",
    "a == 3 and b > 1",
    "'%s_%d' % (s, a)",
    "'{:.3f}'.format(b)",
    "1/12.0 * a * (3*b**2 + 0.4**2)",
    "[i*b for i in l]",
    "l[0] + l[1]",
    "str(a) + 'a'",
    "sin(b)*cos(a)",
    "s.upper()",
    "' '.join([str(v) for v in l])",
];

/// A few properties.
struct Properties(Vec<(&'static str, Value)>);

impl Properties {
    fn new() -> Self {
        let list = Value::list_from([3, 1, 2].map(Value::Int), false);
        Self(vec![
            ("a", Value::Int(3)),
            ("b", Value::Float(1.5)),
            ("s", "wheel".into()),
            ("l", list),
        ])
    }
}

impl Host for Properties {
    fn lookup(&mut self, name: &str, _: TextRange) -> Lookup {
        match self.0.iter().find(|(known, _)| *known == name) {
            Some((_, value)) => Lookup::Found(value.clone()),
            None => Lookup::Missing,
        }
    }

    fn scope_attribute(&mut self, _: ScopeId, _: &str, _: TextRange) -> Lookup {
        Lookup::Missing
    }

    fn call(
        &mut self,
        _: HostFn,
        _: &[Value],
        _: &[(EcoString, Value)],
        _: TextRange,
    ) -> Result<Value, EvalError> {
        Ok(Value::None)
    }

    fn deprecated(&mut self, _: &str, _: &str, _: TextRange) {}

    fn undefined(&mut self, _: &str, _: TextRange) {}
}

#[divan::bench(args = EXPRESSIONS)]
fn expression(bencher: Bencher<'_, '_>, text: &str) {
    let parsed = expr::parse(text);
    let mut host = Properties::new();
    bencher.bench_local(|| {
        expr::evaluate(
            divan::black_box(&parsed.expr),
            &mut host,
            &mut Budget::default(),
        )
    });
}

/// Time must grow with the number of items, not faster.
#[divan::bench(args = [100, 1_000, 10_000])]
fn comprehension(bencher: Bencher<'_, '_>, items: usize) {
    let parsed = expr::parse(&format!("[i * 2 + a for i in python.range({items})]"));
    let mut host = Properties::new();
    bencher.counter(items).bench_local(|| {
        expr::evaluate(
            divan::black_box(&parsed.expr),
            &mut host,
            &mut Budget::default(),
        )
    });
}

#[divan::bench(args = [0.1, 1234.5678, 1e-7, 0.30000000000000004])]
fn float_text(value: f64) -> Option<expr::Str> {
    expr::display::to_str(&Value::Float(value))
}

#[divan::bench(args = ["42", "1.5", "0 0 0.5", "base_link", "true"])]
fn literal(text: &str) -> Value {
    expr::literal::from_text(text)
}

fn main() {
    divan::main();
}
