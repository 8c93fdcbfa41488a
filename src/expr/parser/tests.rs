use super::MAX_DEPTH;
use crate::expr::dump::dump;
use crate::expr::parse;

/// Nested far beyond any limit: an error, no overflow, and quick.
#[test]
fn deep_nesting_is_an_error() {
    let n = 100_000;
    for (open, middle, close) in [
        ("(", "1", ")"),
        ("[", "1", "]"),
        ("{", "1", "}"),
        ("{1:", "1", "}"),
        ("f(", "1", ")"),
        ("f(a=", "1", ")"),
        ("a[", "1", "]"),
        ("-", "1", ""),
        ("not ", "1", ""),
        ("lambda: ", "1", ""),
        ("lambda a=", "1: 1", ""),
        ("1 if 1 else ", "1", ""),
        ("2**", "1", ""),
        ("", "1", "+1"),
        ("", "a", ".b"),
        ("", "a", "()"),
        ("", "a", "[1]"),
        ("", "a", " < b"),
        ("[x for x in ", "1", "]"),
        ("[x ", "", "for x in y "),
        ("(a := ", "1", ")"),
        ("f(*", "1", ")"),
        ("f(**", "1", ")"),
    ] {
        let text = format!("{}{middle}{}", open.repeat(n), close.repeat(n));
        let parsed = parse(&text);
        // Comparisons do not nest.
        assert_eq!(parsed.errors.is_empty(), close == " < b", "{open}{middle}{close}");
        let clone = parsed.expr.clone();
        drop(clone);
    }
    let flat = format!("1{}", "+1".repeat(MAX_DEPTH as usize - 10));
    assert_eq!(parse(&flat).errors, []);
}

/// A line of a table: JSON text, tab, the rest.
fn rows(table: &'static str) -> impl Iterator<Item = (String, &'static str)> {
    table.lines().map(|line| {
        let (input, rest) = line.split_once('\t').unwrap();
        (serde_json::from_str(input).unwrap(), rest)
    })
}

/// Trees and ranges are those of CPython.
#[test]
fn valid_expressions() {
    let mut wrong = Vec::new();
    for (text, rest) in rows(include_str!("../testdata/valid.txt")) {
        let (tree, ranges) = rest.split_once('\t').unwrap();
        let parsed = parse(&text);
        let (found, found_ranges) = dump(&parsed.expr);
        let found_ranges: Vec<String> =
            found_ranges.iter().map(|r| format!("{}:{}", r.start, r.end)).collect();
        if !parsed.errors.is_empty() {
            wrong.push(format!("{text:?}: {:?}", parsed.errors));
        } else if found != tree {
            wrong.push(format!("{text:?}\n  want {tree}\n  got  {found}"));
        } else if ranges != "-" && found_ranges.join(" ") != ranges {
            wrong.push(format!("{text:?} {tree}\n  want {ranges}\n  got  {}", found_ranges.join(" ")));
        }
    }
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong.join("\n"));
}

/// The first error has the text of CPython.
#[test]
fn invalid_expressions() {
    let mut wrong = Vec::new();
    for (text, rest) in rows(include_str!("../testdata/invalid.txt")) {
        let want: String = serde_json::from_str(rest).unwrap();
        let errors = parse(&text).errors;
        let got = errors.first().map_or("no error", |e| &e.reference);
        if got != want {
            wrong.push(format!("{text:?}\n  want {want}\n  got  {got}"));
        }
    }
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong.join("\n"));
}
