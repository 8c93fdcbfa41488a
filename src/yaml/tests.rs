//! Against the stored answers of PyYAML (`tests/oracle/yaml_cases.py` writes them).

use super::error::repr;
use super::{YamlKind, YamlNode, load};

/// Python's `repr` of a value.
fn show(node: &YamlNode) -> String {
    let list = |items: &[YamlNode]| items.iter().map(show).collect::<Vec<_>>().join(", ");
    match &node.kind {
        YamlKind::Null => "None".to_owned(),
        YamlKind::Bool(true) => "True".to_owned(),
        YamlKind::Bool(false) => "False".to_owned(),
        YamlKind::Int(value) => value.to_string(),
        YamlKind::Float(value) => float(*value),
        YamlKind::Str(text) => repr(text),
        YamlKind::Timestamp { repr, .. } => repr.clone(),
        YamlKind::Binary(bytes) => {
            // As characters, of which `repr` shows those that are not ASCII.
            let text = repr(
                &bytes
                    .iter()
                    .map(|&byte| char::from(byte))
                    .collect::<String>(),
            );
            let escaped = text.chars().map(|c| match c {
                '\u{80}'.. => format!("\\x{:02x}", c as u32),
                c => c.to_string(),
            });
            format!("b{}", escaped.collect::<String>())
        }
        YamlKind::List(items) => format!("[{}]", list(items)),
        YamlKind::Map(items) => {
            let items: Vec<String> = items
                .iter()
                .map(|(key, value)| format!("{}: {}", show(key), show(value)))
                .collect();
            format!("{{{}}}", items.join(", "))
        }
        YamlKind::Set(items) if items.is_empty() => "set()".to_owned(),
        YamlKind::Set(items) => {
            let mut items: Vec<String> = items.iter().map(show).collect();
            items.sort();
            format!("{{{}}}", items.join(", "))
        }
        YamlKind::Pairs(items) => {
            let items: Vec<String> = items
                .iter()
                .map(|(key, value)| format!("({}, {})", show(key), show(value)))
                .collect();
            format!("[{}]", items.join(", "))
        }
        YamlKind::Tagged { unit, text } => format!("Unit({}, {})", repr(unit.name()), repr(text)),
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
    load(text, "f.yaml")
        .map(|node| show(&node))
        .map_err(|error| {
            assert!(
                error.range.end as usize <= text.len()
                    && text.is_char_boundary(error.range.start as usize)
            );
            assert!(
                !error.short.is_empty() && !error.short.contains('\n'),
                "{}",
                error.short
            );
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
                && found
                    .as_ref()
                    .is_err_and(|error| error.contains("recursive"));
            if found != expected && !recursive {
                wrong.push(format!(
                    "{text:?}\n  expected {expected:?}\n  found    {found:?}"
                ));
            }
        }
    }
    assert!(count > 700);
    assert!(
        wrong.is_empty(),
        "{} of {count}:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

fn short(text: &str) -> String {
    load(text, "f.yaml").unwrap_err().short
}

#[test]
fn values_know_their_place() {
    let text = "a: 1\nlist:\n  - x  # first\n  - 'y'\n\n# end\nmap: {k: [1, 2]}\nnone:\nalias: &v 7\nagain: *v\n";
    let YamlKind::Map(items) = load(text, "f.yaml").unwrap().kind else {
        panic!("a mapping")
    };
    let places: Vec<(&str, &str)> = items
        .iter()
        .map(|(key, value)| (key.range.slice(text), value.range.slice(text)))
        .collect();
    let expected = [
        ("a", "1"),
        ("list", "- x  # first\n  - 'y'"),
        ("map", "{k: [1, 2]}"),
        ("none", ""),
        ("alias", "&v 7"),
        ("again", "&v 7"),
    ];
    assert_eq!(places, expected);
    assert_eq!(
        items[3].1.range.start as usize,
        text.find("none:").unwrap() + 5
    );
}

#[test]
fn errors_blame_a_part_of_the_text() {
    let table = [
        (
            "a: 1\nspeed 2\nb: 3\n",
            "speed 2",
            "while scanning a simple key: could not find expected ':'",
        ),
        ("a: *gone\n", "*gone", "found undefined alias 'gone'"),
        (
            "a: !nope 1\n",
            "!nope 1",
            "could not determine a constructor for the tag '!nope'",
        ),
        (
            "a: [1, 2\nb: 3\n",
            ":",
            "while parsing a flow sequence: expected ',' or ']', but got ':'",
        ),
        (
            "a:\n\tb: 1\n",
            "\t",
            "while scanning for the next token: found character '\\t' that cannot start any token",
        ),
        (
            "a: !!int x\n",
            "!!int x",
            "invalid literal for int() with base 10: 'x'",
        ),
    ];
    for (text, blamed, message) in table {
        let error = load(text, "f.yaml").unwrap_err();
        assert_eq!(
            (error.range.slice(text), error.short.as_str()),
            (blamed, message)
        );
    }
}

#[test]
fn nesting_is_limited() {
    let deep = |count: usize| format!("{}{}", "[".repeat(count), "]".repeat(count));
    assert!(load(&deep(190), "f.yaml").is_ok());
    assert_eq!(
        short(&deep(100_000)),
        "found more than 200 levels of nesting"
    );
    assert_eq!(
        short(&"- ".repeat(100_000)),
        "found more than 200 levels of nesting"
    );
    assert_eq!(
        short(&"? ".repeat(100_000)),
        "found more than 200 levels of nesting"
    );
}

#[test]
fn multiplication_is_limited() {
    let lines = |first: &str, next: &dyn Fn(usize) -> String| {
        let rest: Vec<String> = (1..12).map(next).collect();
        format!("{first}\n{}", rest.join("\n"))
    };
    let lists = lines("a0: &a0 [x, x]", &|n| {
        format!(
            "a{n}: &a{n} [{}]",
            vec![format!("*a{}", n - 1); 9].join(", ")
        )
    });
    assert_eq!(short(&lists), "found more than 500000 values");
    let merges = lines("a0: &a0 {x: 1}", &|n| {
        format!(
            "a{n}: &a{n} {{<<: [{}]}}",
            vec![format!("*a{}", n - 1); 9].join(", ")
        )
    });
    assert!(short(&merges).starts_with("found more than 500000"));
}

#[test]
fn recursion_is_an_error() {
    for text in [
        "a: &x [*x]",
        "&a {k: *a}",
        "a: &a {<<: {k: *a}}",
        "&a [[[*a]]]",
        "a: &a\n  <<: *a\n  b: 1",
    ] {
        assert!(load(text, "f.yaml").is_err(), "{text}");
    }
    let chain: String = (1..200)
        .map(|n| format!("k{n}: &a{n} {{<<: *a{}}}, ", n - 1))
        .collect();
    assert_eq!(
        short(&format!("{{k0: &a0 {{}}, {chain} <<: *a199}}")),
        "found more than 100 merges into each other"
    );
}
