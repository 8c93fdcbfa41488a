//! Evaluation of text, against values that Python gave for the same text.

use super::*;
use crate::base::TextRange;

/// A host with a few properties that records what is reported to it.
#[derive(Default)]
struct TestHost {
    names: Vec<(&'static str, Value)>,
    undefined: Vec<String>,
    deprecated: Vec<String>,
}

impl Host for TestHost {
    fn lookup(&mut self, name: &str, _: TextRange) -> Lookup {
        let found = self.names.iter().find(|(known, _)| *known == name);
        found.map_or(Lookup::Missing, |(_, value)| Lookup::Found(value.clone()))
    }

    fn scope_attribute(&mut self, _: ScopeId, name: &str, range: TextRange) -> Lookup {
        self.lookup(name, range)
    }

    fn call(
        &mut self,
        function: HostFn,
        args: &[Value],
        _: &[(ecow::EcoString, Value)],
        _: TextRange,
    ) -> Result<Value, EvalError> {
        Ok(Value::from(format!("{function:?} of {}", args.len())))
    }

    fn deprecated(&mut self, name: &str, namespace: &str, _: TextRange) {
        self.deprecated.push(format!("{namespace}.{name}"));
    }

    fn undefined(&mut self, name: &str, range: TextRange) {
        self.undefined.push(format!("{name}@{range:?}"));
    }
}

/// The `repr` of the value, or the message of the error.
fn outcome(host: &mut TestHost, text: &str) -> String {
    let parsed = parse(text);
    if let Some(error) = parsed.errors.first() {
        return format!("! {}", error.reference);
    }
    match evaluate(&parsed.expr, host, &mut Budget::default()) {
        Ok(value) => display::repr(&value).map_or_else(|| "?".to_owned(), |text| text.to_string()),
        Err(error) => format!("! {}", error.message),
    }
}

#[test]
fn quick() {
    for text in [
        "1+2*3",
        "'a' * 3 + 'b'",
        "[x*2 for x in range(3)]",
        "sin(pi/2)",
        "1/0",
        "foo + 1",
        "max(1, 2.5)",
        "'%05.2f|%s' % (3.14159, [1,'a'])",
        "'{:>8.3f}'.format(2.5)",
        "2**100",
        "sorted([3,1,2], key=lambda x: -x)",
        "round(2.5)",
        "'a,b'.split(',')",
        "(lambda x, y=2: x*y)(3)",
        "math.sqrt(2)",
        "dict(a=1)['a']",
        "10**10**8",
        "[1,2][5]",
    ] {
        let mut host = TestHost::default();
        println!("{text} => {} {:?}", outcome(&mut host, text), host.undefined);
    }
}
