//! Every block has somebody who checks it.

use std::fs;

use crate::pages::{self, root};

/// Languages whose blocks are read or run by these tests.
const CHECKED: &[&str] = &["console", "sh", "toml", "json", "yaml", "xml"];

#[test]
fn every_block_is_checked_by_somebody() {
    let editors = root().join("tests/editors/run.py");
    let neovim = root().join("tests/nvim/install_tests.lua");
    let tests = fs::read_to_string(editors).unwrap() + &fs::read_to_string(neovim).unwrap();
    let mut wrong = Vec::new();
    for block in pages::told().iter().flat_map(pages::blocks) {
        let place = &block.place;
        let language = block.language.as_str();
        let quoted = |name: &str, quote: char| format!("snippet({quote}{name}{quote})");
        match block.remark("run:") {
            // eglot and lsp-mode come out of a loop
            Some(name) if ['"', '\''].iter().all(|quote| !tests.contains(&quoted(name, *quote))) => {
                if !tests.contains(&format!("\"{name}\"")) {
                    wrong.push(format!("{place}: no test of the editors takes `{name}`"));
                }
            }
            Some(_) => {}
            None if language.is_empty() => wrong.push(format!("{place}: say the language, or `text`")),
            None if block.not_run.is_some() || language == "text" || CHECKED.contains(&language) => {}
            None if language == "mermaid" => wrong.push(format!("{place}: mdBook does not draw `mermaid`")),
            None => wrong.push(format!("{place}: nobody checks `{language}`: say `not-run: reason`")),
        }
        if language == "text" && block.text.lines().any(|line| line.starts_with("$ ")) {
            wrong.push(format!("{place}: a command with its answer is `console`"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What cannot be run stands in a list, so that it does not grow unseen.
#[test]
fn what_is_not_run_is_listed() {
    let mut list = String::new();
    for page in pages::told() {
        for block in pages::blocks(&page) {
            let Some(reason) = &block.not_run else { continue };
            assert!(reason.contains(' '), "{}: give a reason", block.place);
            let first = block.text.lines().find(|line| !line.trim().is_empty()).unwrap_or("");
            list.push_str(&format!("{} ({}): {reason}\n    {}\n", page.path, block.language, first.trim()));
        }
    }
    pages::up_to_date("tests/docs/not-run.txt", &list);
}
