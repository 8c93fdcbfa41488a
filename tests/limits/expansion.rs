//! How far the expansion of a robot may go: nodes, time, levels, files.

use xacro_lsp::base::limits::*;

use super::{LINK, check, reached};

/// A macro that makes as many links as it is told, ten calls deep.
const MANY: &str = "<xacro:macro name=\"m\" params=\"n p\"><xacro:if value=\"${n > 0}\"><link name=\"${p}\"/>\
    <xacro:m n=\"${n - 1}\" p=\"${p}a\"/><xacro:m n=\"${n - 1}\" p=\"${p}b\"/></xacro:if></xacro:macro>\n\
    <xacro:m n=\"30\" p=\"l\"/>";

#[test]
fn expand_nodes() {
    let config = [("xacro-lint.toml", "[limits]\nexpand-nodes = 100\n")];
    reached(
        MANY,
        &config,
        &[
            "the expanded robot has more than 100 nodes",
            "raise `expand-nodes` under `[limits]`",
        ],
    );
    // each node is made by at most a few expressions: their values are bounded with the nodes
    assert!(EVALUATIONS as u64 >= EXPAND_NODES);
}

#[test]
fn compared_names() {
    let names = COMPARED_NAMES / 1000;
    let properties: String = (0..names)
        .map(|n| format!("<xacro:property name=\"param{n}\" value=\"1\"/>"))
        .collect();
    // a name that is like another, behind so many that were compared before
    let said = |others: usize| {
        let wrong: String = (0..others)
            .map(|n| format!("<link name=\"${{abc{n}}}\"/>"))
            .collect();
        let called = "<xacro:macro name=\"wheel\"><link name=\"a\"/></xacro:macro><xacro:wheeel/>";
        let patient = [("xacro-lint.toml", "[limits]\nexpand-ms = 60000\n")];
        check(&format!("{properties}{wrong}{called}"), &patient)
    };
    let suggested = "did you mean `wheel`?";
    assert!(said(0).contains(suggested));
    let said = said(1000);
    assert!(
        said.contains("macro `wheeel` is not defined") && !said.contains(suggested),
        "{said}"
    );
}

#[test]
fn expand_ms() {
    let config = [("xacro-lint.toml", "[limits]\nexpand-ms = 1\n")];
    reached(
        MANY,
        &config,
        &[
            "the expansion takes more than 1 ms",
            "raise `expand-ms` under `[limits]`",
        ],
    );
}

#[test]
fn output_bytes() {
    let uses = "<link name=\"${p}\"/>\n".repeat(40);
    let body = format!("<xacro:property name=\"p\" value=\"${{'a' * 2 * 10**6}}\"/>\n{uses}");
    reached(&body, &[], &["64 MB"]);
}

#[test]
fn macro_depth() {
    let endless = "<xacro:macro name=\"m\" params=\"n\"><xacro:if value=\"${n > 0}\"><xacro:m n=\"${n + 1}\"/></xacro:if>\
                   </xacro:macro>\n<xacro:m n=\"1\"/>";
    reached(
        endless,
        &[],
        &[
            "nested more than 1000 levels deep: `m`",
            "raise `macro-depth` under `[limits]`",
        ],
    );
    // a workspace may raise it, but not beyond what the stack holds
    let config = [(
        "xacro-lint.toml",
        "[limits]\nmacro-depth = 10000\nexpand-ms = 60000\n",
    )];
    reached(endless, &config, &["nested more than 10000 levels deep"]);
}

#[test]
fn include_depth() {
    let endless = "<xacro:include filename=\"${'r'}.urdf.xacro\"/>\n<link name=\"a\"/>";
    reached(
        endless,
        &[],
        &[
            "includes are nested more than 500 levels deep",
            "raise `include-depth` under `[limits]`",
        ],
    );
    let config = [(
        "xacro-lint.toml",
        "[limits]\ninclude-depth = 10000\nexpand-ms = 60000\n",
    )];
    reached(
        endless,
        &config,
        &["includes are nested more than 10000 levels deep"],
    );
}

#[test]
fn glob_files() {
    let names: Vec<String> = (0..=GLOB_FILES)
        .map(|n| format!("parts/p{n}.xacro"))
        .collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (&**name, "<robot/>")).collect();
    let body = format!("<xacro:include filename=\"parts/*.xacro\"/>\n{LINK}");
    reached(
        &body,
        &files,
        &[
            "r.urdf.xacro:2:",
            "matches more than 1000 files, the limit for one include",
        ],
    );
    let (_, fewer) = files.split_first().unwrap();
    let said = check(&body, fewer);
    assert!(!said.contains("error["), "{said}");
}

#[test]
fn glob_entries() {
    // each `*/..` multiplies
    let pattern = "*/../".repeat(20);
    let names: Vec<String> = (0..10).map(|n| format!("d{n}/x.txt")).collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (&**name, "")).collect();
    let body = format!("<xacro:include filename=\"{pattern}*.xacro\"/>\n{LINK}");
    reached(&body, &files, &["r.urdf.xacro:2:", "is 200000"]);
    // patterns that are long and look at nothing
    for pattern in [
        "*/".repeat(1_000_000),
        format!("x{}", "[".repeat(1_000_000)),
        "*".repeat(1_000_000),
    ] {
        let body = format!("<xacro:include filename=\"gone/{pattern}\"/>\n{LINK}");
        assert!(
            check(&body, &files).contains("glob-include-no-match"),
            "{}",
            &pattern[..5]
        );
    }
}

#[test]
fn element_depth() {
    let count = ELEMENT_DEPTH as usize + 10;
    let deep = format!("{}{}", "<a>".repeat(count), "</a>".repeat(count));
    reached(
        &deep,
        &[],
        &["elements are nested more than 5000 levels deep"],
    );
}

#[test]
fn block_depth() {
    let endless = "<xacro:property name=\"b\"><xacro:insert_block name=\"b\"/></xacro:property>\n\
                   <xacro:insert_block name=\"b\"/>";
    reached(
        endless,
        &[],
        &["block `b` inserts itself (more than 500 levels)"],
    );
}

#[test]
fn lazy_depth() {
    let chain: String = (0..600)
        .map(|n| {
            format!(
                "<xacro:property name=\"p{n}\" value=\"${{p{} + 1}}\"/>\n",
                n + 1
            )
        })
        .collect();
    let body =
        format!("{chain}<xacro:property name=\"p600\" value=\"1\"/>\n<link name=\"${{p0}}\"/>");
    reached(&body, &[], &["more than 500 levels deep"]);
}
