use super::MAX_DEPTH;
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
