//! How deep expressions may be, how long they may run, and how large their values may be.

use xacro_lsp::base::limits::*;
use xacro_lsp::expr;

use super::reached;

#[test]
fn expression_depth() {
    let deep = format!("<link name=\"${{{}True}}\"/>", "not ".repeat(300));
    reached(
        &deep,
        &[],
        &[
            "r.urdf.xacro:2:",
            "expression is nested more than 240 levels deep",
        ],
    );
}

#[test]
fn brackets() {
    let deep = format!(
        "<link name=\"${{{}1{}}}\"/>",
        "(".repeat(201),
        ")".repeat(201)
    );
    reached(
        &deep,
        &[],
        &["brackets are nested more than 200 levels deep"],
    );
}

#[test]
fn expression_errors() {
    let texts = [
        "f(a b), ",
        "[1 2], ",
        "'a' 'b' c, ",
        "__a + ",
        "a.__b + ",
        "(1 +), ",
        "f'{a b}' + ",
        "lambda, ",
    ];
    let counts = texts.map(|text| expr::parse(&text.repeat(100)).errors.len());
    // those of f-strings are found in their own small expressions
    let plain: Vec<usize> = counts.into_iter().filter(|&count| count != 100).collect();
    assert_eq!(
        plain.into_iter().max(),
        Some(EXPRESSION_ERRORS),
        "{counts:?}"
    );
}

#[test]
fn eval_steps() {
    let endless = "<link name=\"${len([i for i in python.range(10**6)])}\"/>";
    let config = [("xacro-lint.toml", "[limits]\neval-steps = 1000\n")];
    reached(
        endless,
        &config,
        &[
            "more than the limit of 1000 steps",
            "raise `eval-steps` under `[limits]`",
        ],
    );
    reached(endless, &[], &["more than the limit of 1000000 steps"]);
}

#[test]
fn eval_depth() {
    reached(
        "<link name=\"${(lambda f: f(f))(lambda f: f(f))}\"/>",
        &[],
        &["maximum recursion depth exceeded"],
    );
}

#[test]
fn eval_value_bytes() {
    reached(
        "<link name=\"${'a' * 10**9}\"/>",
        &[],
        &["the limit is 64 MB"],
    );
}

#[test]
fn integer_bits() {
    reached(
        "<link name=\"${10**10**8}\"/>",
        &[],
        &["the limit is 1048576 bits"],
    );
}

#[test]
fn integer_digits() {
    reached(
        "<link name=\"${int('9' * 5000)}\"/>",
        &[],
        &["Exceeds the limit (4300 digits)"],
    );
}

#[test]
fn key_depth() {
    let deep = "<link name=\"${[(t := ())] and [t := (t,) for _ in python.range(10**4)] and python.set([t])}\"/>";
    reached(
        deep,
        &[],
        &["maximum recursion depth exceeded while hashing a tuple"],
    );
    let wide = "<link name=\"${[(t := ())] and [t := (t, t) for _ in python.range(60)] and python.hash(t)}\"/>";
    reached(
        wide,
        &[],
        &["maximum recursion depth exceeded while hashing a tuple"],
    );
}

#[test]
fn shown_depth() {
    let deep =
        "<link name=\"${[(t := [])] and [t := [t] for _ in python.range(10**4)] and str(t)}\"/>";
    reached(
        deep,
        &[],
        &["maximum recursion depth exceeded while getting the repr"],
    );
}
