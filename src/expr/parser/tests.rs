use proptest::prelude::*;

use crate::ast::{Expr, ExprKind};
use crate::dump::dump;
use crate::visit::children;
use crate::{ExprErrorKind, parse};
use base::TextRange;
use base::limits::EXPRESSION_DEPTH;

/// Nested far beyond any limit: an error, no overflow, and quick.
#[test]
fn deep_nesting_is_an_error() {
    let n = 20_000;
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
        ("[*", "1", "]"),
        ("[a.b = ", "1", "]"),
        ("[1 := ", "1", "]"),
        ("[a for *a, *b[", "1", "] in c]"),
        ("a[1:", "1", "]"),
        ("[-", "1", "]"),
        ("f(-[", "1", "])"),
        ("[lambda: ", "1", "]"),
        ("(1 if ", "1", " else 1)"),
        ("[x for [*x] in ", "1", "]"),
    ] {
        let text = format!("{}{middle}{}", open.repeat(n), close.repeat(n));
        let parsed = parse(&text);
        // Comparisons do not nest.
        assert_eq!(
            parsed.errors.is_empty(),
            close == " < b",
            "{open}{middle}{close}"
        );
        assert!(
            height(&parsed.expr) <= EXPRESSION_DEPTH + 1,
            "{open}{middle}{close}: {}",
            height(&parsed.expr)
        );
    }
    let flat = format!("1{}", "+1".repeat(EXPRESSION_DEPTH as usize - 10));
    assert_eq!(parse(&flat).errors, []);
}

fn height(expr: &Expr) -> u32 {
    let mut below = 0;
    children(expr, &mut |child| below = below.max(height(child)));
    below + 1
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
        let found_ranges: Vec<String> = found_ranges
            .iter()
            .map(|r| format!("{}:{}", r.start, r.end))
            .collect();
        if !parsed.errors.is_empty() {
            wrong.push(format!("{text:?}: {:?}", parsed.errors));
        } else if found != tree {
            wrong.push(format!("{text:?}\n  want {tree}\n  got  {found}"));
        } else if ranges != "-" && found_ranges.join(" ") != ranges {
            wrong.push(format!(
                "{text:?} {tree}\n  want {ranges}\n  got  {}",
                found_ranges.join(" ")
            ));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} wrong\n{}",
        wrong.len(),
        wrong.join("\n")
    );
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
    assert!(
        wrong.is_empty(),
        "{} wrong\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

/// What is typed so far is in the tree, holes are `?`.
#[test]
fn half_typed_text_has_a_tree() {
    for (text, tree, ours) in [
        ("a +", "(+ a ?)", "expected a value"),
        ("a + b *", "(+ a (* b ?))", "expected a value"),
        ("a.", "(. a )", "expected the name of an attribute"),
        (
            "(a.b.) + 1",
            "(+ (. (. a b) ) 1)",
            "expected the name of an attribute",
        ),
        (
            "x.is",
            "(. x is)",
            "keyword `is` is not allowed as an attribute",
        ),
        ("f(1,", "(call f 1)", "unclosed `(`"),
        (
            "f(a.",
            "(call f (. a ))",
            "expected the name of an attribute",
        ),
        ("f(a, k=", "(call f a k=?)", "expected a value"),
        ("f(,a)", "(call f ? a)", "expected an argument before `,`"),
        ("d['a'", "(index d \"a\")", "unclosed `[`"),
        ("d['a", "(index d \"a\")", "string has no closing `'`"),
        ("d[", "(index d ?)", "expected an index"),
        ("d[]", "(index d ?)", "expected an index"),
        ("d[1:", "(index d (slice 1 _ _))", "unclosed `[`"),
        ("[1, 2", "(list 1 2)", "unclosed `[`"),
        ("[a b]", "(list a b)", "expected a comma or an operator"),
        (
            "(a, [b)",
            "(tuple a (list b))",
            "`)` does not close the `[` before it",
        ),
        ("(a]", "a", "`]` does not close the `(` before it"),
        ("a)", "a", "unmatched `)`"),
        ("{a: b, c", "(dict a b c ?)", "expected `:` and a value"),
        (
            "a if b",
            "(if b a ?)",
            "expected `else` and a value after `if`",
        ),
        ("a if b else", "(if b a ?)", "expected a value"),
        ("lambda", "(lambda () ?)", "expected `:` with a value"),
        (
            "lambda x, y",
            "(lambda (arg:x arg:y) ?)",
            "expected `:` with a value",
        ),
        ("[x for", "(list-comp x for ? ?)", "expected a value"),
        ("[x for y in", "(list-comp x for y ?)", "expected a value"),
        (
            "[x.a for x, y in z.",
            "(list-comp (. x a) for (tuple x y) (. z ))",
            "expected the name of an attribute",
        ),
        (
            "[a, b for a in c]",
            "(list-comp (tuple a b) for a c)",
            "several values before `for` must be in parentheses",
        ),
        (
            "a b.c",
            "(tuple a (. b c))",
            "unexpected `b`; an operator may be missing",
        ),
        (
            "a = b.c",
            "(tuple a (. b c))",
            "assignment with `=` is not allowed; use `==` to compare",
        ),
        (
            "(a = b)",
            "(cmp a == b)",
            "assignment with `=` is not allowed; use `==` to compare",
        ),
        ("not", "(not ?)", "expected a value"),
        ("", "?", "expected an expression"),
        (
            "0777",
            "?",
            "`0777` is not a number; leading zeros are not allowed",
        ),
    ] {
        let parsed = parse(text);
        assert_eq!(dump(&parsed.expr).0, tree, "{text}");
        assert_eq!(
            parsed.errors.first().map(|e| e.message.as_str()),
            Some(ours),
            "{text}"
        );
    }
}

/// A hole spans the blanks a cursor may stand in.
#[test]
fn holes_can_be_found_by_offset() {
    for (text, cursor) in [
        ("a + ", 4),
        ("a +  ", 4),
        ("f(a, k= )", 8),
        ("  a and  ", 8),
        ("[ ( a +  ) ]", 8),
    ] {
        let parsed = parse(text);
        assert!(
            innermost(&parsed.expr, cursor).kind == ExprKind::Missing,
            "{text:?}"
        );
    }
    let parsed = parse("x.  + 1");
    let ExprKind::Attribute { name_range, .. } = &innermost(&parsed.expr, 3).kind else {
        panic!()
    };
    assert!(name_range.touches(3));
}

fn innermost(expr: &Expr, offset: u32) -> &Expr {
    let mut found = expr;
    children(expr, &mut |child| {
        if child.range.touches(offset) {
            found = innermost(child, offset);
        }
    });
    found
}

/// Python, but not here.
#[test]
fn unsupported_expressions() {
    for text in [
        "'\\N{DIGIT ONE}'",
        "'\\ud800'",
        "(yield)",
        "await x",
        "[a async for a in b]",
    ] {
        let errors = parse(text).errors;
        assert_eq!(
            errors.first().map(|e| e.kind),
            Some(ExprErrorKind::NotSupported),
            "{text}"
        );
    }
}

/// Every range lies within the text and within its parent's.
fn check_ranges(text: &str) {
    let parsed = parse(text);
    let all = TextRange::new(0, text.len() as u32);
    for error in &parsed.errors {
        assert!(
            text.get(error.range.start as usize..error.range.end as usize)
                .is_some(),
            "{text:?} {error:?}"
        );
    }
    check_node(text, &parsed.expr, all);
}

fn check_node(text: &str, expr: &Expr, parent: TextRange) {
    assert!(
        parent.contains_range(expr.range),
        "{text:?}: {expr:?} outside of {parent:?}"
    );
    assert!(
        text.is_char_boundary(expr.range.start as usize)
            && text.is_char_boundary(expr.range.end as usize)
    );
    let inner = match &expr.kind {
        ExprKind::Attribute { name_range, .. } | ExprKind::NamedExpr { name_range, .. } => {
            *name_range
        }
        _ => expr.range,
    };
    assert!(
        expr.range.contains_range(inner),
        "{text:?}: {inner:?} outside of {expr:?}"
    );
    children(expr, &mut |child| check_node(text, child, expr.range));
}

#[test]
fn ranges_are_nested_in_all_tables() {
    let tables = [
        include_str!("../testdata/valid.txt"),
        include_str!("../testdata/invalid.txt"),
    ];
    for (text, _) in tables.into_iter().flat_map(rows) {
        check_ranges(&text);
        // Every way to have typed only a part of it.
        for (i, _) in text.char_indices().take(60) {
            check_ranges(&text[..i]);
            check_ranges(&text[i..]);
        }
    }
}

proptest! {
    #[test]
    fn any_text_has_a_tree(text in "\\PC{0,40}") {
        check_ranges(&text);
    }

    #[test]
    fn any_tokens_have_a_tree(words in prop::collection::vec(prop::sample::select(WORDS), 0..30)) {
        check_ranges(&words.concat());
        check_ranges(&words.join(" "));
    }
}

const WORDS: &[&str] = &[
    "a",
    "b",
    "é",
    "1",
    "0x",
    "1.5",
    "'s'",
    "'",
    "\"\"\"",
    "f'{",
    "}'",
    "f'{a!r:{b}}'",
    "b'x'",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "=",
    ":=",
    ".",
    "*",
    "**",
    "/",
    "+",
    "-",
    "~",
    "not",
    "in",
    "is",
    "if",
    "else",
    "for",
    "lambda",
    "and",
    "or",
    "==",
    "<",
    "\n",
    "\t",
    " ",
    "\\",
    "\\\n",
    "#",
    "None",
    "...",
    "yield",
    "await",
    "async",
    "print",
    "$",
    "!",
    "\u{a0}",
    "__x",
];

/// As many brackets as CPython allows, with room for what is in them.
#[test]
fn two_hundred_brackets_are_fine() {
    for (open, close) in [
        ("(", ")"),
        ("[", "]"),
        ("f(", ")"),
        ("a[", "]"),
        ("{1:", "}"),
    ] {
        let nested =
            |n: usize| parse(&format!("{}1 + a.b{}", open.repeat(n), close.repeat(n))).errors;
        assert_eq!(nested(200), [], "{open}");
        assert_eq!(
            nested(201).first().map(|e| e.reference.as_str()),
            Some("too many nested parentheses (<expression>, line 1)"),
            "{open}"
        );
    }
}
