//! Evaluation of text, against values that Python gave for the same text.

mod behavior;
mod hostile;

use super::*;
use base::TextRange;

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

/// The properties that tests/oracle/eval_table.py defines too.
fn properties() -> Vec<(&'static str, Value)> {
    let list = |items: Vec<Value>| Value::list_from(items, false);
    let dict = |entries: Vec<(Value, Value)>| Value::dict_from(entries, false);
    let ints = |numbers: &[i64]| Value::list_from(numbers.iter().map(|&n| Value::Int(n)), false);
    let b = dict(vec![
        ("c".into(), Value::Float(2.5)),
        ("items".into(), Value::Int(7)),
        (
            "list".into(),
            list(vec![Value::Int(1), dict(vec![("k".into(), "v".into())])]),
        ),
    ]);
    let cfg = vec![
        ("a".into(), Value::Int(1)),
        ("b".into(), b),
        ("names".into(), list(vec!["front".into(), "rear".into()])),
        ("rows".into(), list(vec![ints(&[1, 2]), ints(&[3, 4])])),
        (Value::Int(3), "three".into()),
    ];
    vec![
        ("n", Value::Int(3)),
        ("x", Value::Float(1.5)),
        ("s", "hello world".into()),
        ("l", ints(&[3, 1, 2])),
        ("cfg", Value::dict_from(cfg, true)),
    ]
}

/// The `repr` of the value, or `! ` and the message of the first error.
fn outcome(text: &str) -> String {
    let parsed = parse(text);
    if let Some(error) = parsed.errors.first() {
        return format!("! {}", error.reference);
    }
    let mut host = TestHost {
        names: properties(),
        ..TestHost::default()
    };
    let result = evaluate(&parsed.expr, &mut host, &mut Budget::default());
    if let Some(undefined) = host.undefined.first() {
        let name = undefined.split('@').next().unwrap_or("");
        return format!("! name '{name}' is not defined");
    }
    match result {
        Ok(value) => display::repr(&value).map_or_else(|| "?".to_owned(), |text| text.to_string()),
        Err(error) => format!("! {}", error.message),
    }
    .replace('\n', "⏎")
}

/// Lines of a table whose outcome differs, except the expressions in `known`.
fn check(table: &str, known: &[&str]) {
    let mut found = Vec::new();
    for line in table.lines() {
        let Some((text, expected)) = line.split_once('\t') else {
            continue;
        };
        let got = outcome(text);
        assert!(
            got != expected || !known.contains(&text),
            "{text} is as in Python, so it is no exception"
        );
        if got != expected && !known.contains(&text) {
            found.push(format!("{text}\n  python: {expected}\n  ours:   {got}"));
        }
    }
    assert!(
        found.is_empty(),
        "{} differ:\n{}",
        found.len(),
        found.join("\n")
    );
}

#[test]
fn expressions() {
    // Limits of ours, and formatting of bytes.
    check(
        include_str!("../testdata/eval.txt"),
        &["1 << 10**20", "cbrt(27)"],
    );
}

#[test]
fn operators() {
    check(include_str!("../testdata/operators.txt"), &["b'x' % b'x'"]);
}

#[test]
fn formats() {
    check(include_str!("../testdata/format.txt"), &[]);
}

/// Whether two texts are floats next to each other.
fn neighbors(a: &str, b: &str) -> bool {
    let (Ok(a), Ok(b)) = (a.parse::<f64>(), b.parse::<f64>()) else {
        return false;
    };
    let place = |f: f64| f.to_bits().cast_signed();
    place(a).abs_diff(place(b)) <= 3
}

#[test]
fn math() {
    // C libraries disagree in the last digit of some functions; these are not from the C library here.
    let loose = |text: &str| ["cbrt", "erf"].iter().any(|name| text.starts_with(name));
    let everywhere = !cfg!(all(target_os = "linux", target_env = "gnu"));
    for line in include_str!("../testdata/math.txt").lines() {
        let Some((text, expected)) = line.split_once('\t') else {
            continue;
        };
        let got = outcome(text);
        let fine = got == expected || ((everywhere || loose(text)) && neighbors(&got, expected));
        assert!(fine, "{text}: {got}, in Python {expected}");
    }
}

#[test]
fn float_texts() {
    for line in include_str!("../testdata/floats.txt").lines() {
        let Some((bits, expected)) = line.split_once('\t') else {
            continue;
        };
        let float = f64::from_bits(bits.parse().unwrap());
        assert_eq!(float_repr::repr(float), expected);
    }
}

#[test]
fn external() {
    #[allow(clippy::disallowed_methods)]
    let Ok(path) = std::env::var("EVAL_TABLE") else {
        return;
    };
    #[allow(clippy::disallowed_methods)]
    check(&std::fs::read_to_string(path).unwrap(), &[]);
}
