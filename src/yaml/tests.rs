//! Against the stored answers of PyYAML (`tests/oracle/yaml_cases.py` writes them).

use super::error::repr;
use super::{Kind, Node, load};

/// Python's `repr` of a value.
fn show(node: &Node) -> String {
    let list = |items: &[Node]| items.iter().map(show).collect::<Vec<_>>().join(", ");
    match &node.kind {
        Kind::Null => "None".to_owned(),
        Kind::Bool(true) => "True".to_owned(),
        Kind::Bool(false) => "False".to_owned(),
        Kind::Int(value) => value.to_string(),
        Kind::Float(value) => float(*value),
        Kind::Str(text) => repr(text),
        Kind::Timestamp { repr, .. } => repr.clone(),
        Kind::Binary(bytes) => {
            format!("b{}", repr(&bytes.iter().map(|&b| char::from(b)).collect::<String>()))
        }
        Kind::List(items) => format!("[{}]", list(items)),
        Kind::Map(items) => {
            let items: Vec<String> =
                items.iter().map(|(key, value)| format!("{}: {}", show(key), show(value))).collect();
            format!("{{{}}}", items.join(", "))
        }
        Kind::Set(items) if items.is_empty() => "set()".to_owned(),
        Kind::Set(items) => {
            let mut items: Vec<String> = items.iter().map(show).collect();
            items.sort();
            format!("{{{}}}", items.join(", "))
        }
        Kind::Pairs(items) => {
            let items: Vec<String> =
                items.iter().map(|(key, value)| format!("({}, {})", show(key), show(value))).collect();
            format!("[{}]", items.join(", "))
        }
        Kind::Tagged { unit, text } => format!("Unit({}, {})", repr(unit.name()), repr(text)),
    }
}

fn float(value: f64) -> String {
    if value.is_nan() || value.is_infinite() {
        return value.to_string().to_lowercase();
    }
    let scientific = format!("{value:e}");
    let (digits, exponent) = scientific.split_once('e').unwrap();
    match exponent.parse::<i32>().unwrap() {
        -4..=15 => format!("{value:?}"),
        exponent @ 16.. => format!("{digits}e+{exponent:02}"),
        exponent => format!("{digits}e-{:02}", -exponent),
    }
}

fn answer(text: &str) -> Result<String, String> {
    load(text, "f.yaml").map(|node| show(&node)).map_err(|error| {
        assert!(error.range.end as usize <= text.len() && text.is_char_boundary(error.range.start as usize));
        assert!(!error.short.is_empty() && !error.short.contains('\n'), "{}", error.short);
        error.message
    })
}

#[test]
fn all_cases_of_the_oracle() {
    let cases: serde_json::Value =
        serde_json::from_str(include_str!("../../tests/oracle/yaml_cases.json")).unwrap();
    let mut wrong = Vec::new();
    let mut count = 0;
    for section in ["scalars", "documents", "broken"] {
        for case in cases[section].as_array().unwrap() {
            count += 1;
            let text = case[0].as_str().unwrap();
            let expected = match (case[1].as_str(), case[2].as_str()) {
                (Some(value), _) => Ok(value.to_owned()),
                (None, error) => Err(error.unwrap().to_owned()),
            };
            let found = answer(text);
            // A value that contains itself is a value for Python, and an error here.
            let recursive = expected == Err("recursion".to_owned())
                && found.as_ref().is_err_and(|error| error.contains("recursive"));
            if found != expected && !recursive {
                wrong.push(format!("{text:?}\n  expected {expected:?}\n  found    {found:?}"));
            }
        }
    }
    assert!(count > 700);
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
}
