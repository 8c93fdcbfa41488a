//! How deep and how large YAML may be.

use super::reached;

/// A robot that loads `f.yaml`.
const LOADS: &str = "<xacro:property name=\"p\" value=\"${xacro.load_yaml('f.yaml')}\"/>\n<link name=\"${len(p)}\"/>";

#[test]
fn yaml_depth() {
    let deep = format!("a: {}{}\n", "[".repeat(300), "]".repeat(300));
    reached(
        LOADS,
        &[("f.yaml", &deep)],
        &["more than 200 levels of nesting"],
    );
}

#[test]
fn yaml_nodes() {
    let mut text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n".to_owned();
    for n in 1..7 {
        let uses = vec![format!("*a{}", n - 1); 10].join(", ");
        text.push_str(&format!("a{n}: &a{n} [{uses}]\n"));
    }
    reached(LOADS, &[("f.yaml", &text)], &["more than 500000 values"]);
}

#[test]
fn yaml_merges() {
    let text = format!("a: {}{{x: 1}}{}\n", "{<<: ".repeat(150), "}".repeat(150));
    reached(
        LOADS,
        &[("f.yaml", &text)],
        &["more than 100 merges into each other"],
    );
}
