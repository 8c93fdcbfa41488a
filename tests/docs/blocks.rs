//! Every block has somebody who checks it.

use std::fs;

use crate::pages::{self, root};

/// Languages whose blocks are read or run by these tests.
const CHECKED: &[&str] = &["console", "sh", "toml", "json", "yaml", "xml"];

/// The tests that take blocks out of pages.
fn texts_of_other_tests() -> String {
    let mut texts = String::new();
    for folder in ["tests/editors", "tests/nvim", "tests/packaging"] {
        for entry in fs::read_dir(root().join(folder)).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path
                .extension()
                .is_some_and(|ending| ending == "py" || ending == "lua")
            {
                texts.push_str(&fs::read_to_string(path).unwrap());
            }
        }
    }
    texts
}

#[test]
fn every_block_is_checked_by_somebody() {
    let tests = texts_of_other_tests();
    let mut wrong = Vec::new();
    for block in pages::told().iter().flat_map(pages::blocks) {
        let place = &block.place;
        let language = block.language.as_str();
        match block.remark("run:") {
            Some(name)
                if ['"', '\'']
                    .iter()
                    .all(|quote| !tests.contains(&format!("{quote}{name}{quote}"))) =>
            {
                wrong.push(format!("{place}: no test takes `{name}`"));
            }
            Some(_) => {}
            None if language.is_empty() => {
                wrong.push(format!("{place}: say the language, or `text`"))
            }
            None if block.not_run.is_some()
                || language == "text"
                || CHECKED.contains(&language) => {}
            None => wrong.push(format!(
                "{place}: nobody checks `{language}`: say `not-run: reason`"
            )),
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
            let Some(reason) = &block.not_run else {
                continue;
            };
            assert!(reason.contains(' '), "{}: give a reason", block.place);
            let first = block
                .text
                .lines()
                .find(|line| !line.trim().is_empty())
                .unwrap_or("");
            list.push_str(&format!(
                "{} ({}): {reason}\n    {}\n",
                page.path,
                block.language,
                first.trim()
            ));
        }
    }
    pages::up_to_date("tests/docs/not-run.txt", &list);
}
