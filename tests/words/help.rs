//! Every error and warning has a help: proved in the source, for messages that no example produces too.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use super::{complain, files, root};

/// The functions of the sources of a folder, each with the place where it begins; tests are left out.
fn functions(folder: &str) -> Vec<(String, String)> {
    let mut paths: Vec<PathBuf> = Vec::new();
    files(&root().join(folder), ".rs", &mut paths);
    paths.sort();
    let mut found = Vec::new();
    for path in paths {
        let source = fs::read_to_string(&path).unwrap();
        let source = source.split("#[cfg(test)]\nmod tests {").next().unwrap();
        let mut function = String::new();
        let mut begin = 0;
        for (number, line) in source.lines().enumerate() {
            let code = line
                .trim_start()
                .trim_start_matches("pub ")
                .trim_start_matches("pub(super) ");
            let is_nested = line.starts_with("        ");
            if code.starts_with("fn ") && !is_nested {
                found.push((
                    format!("{}:{begin}", path.display()),
                    std::mem::take(&mut function),
                ));
                begin = number + 1;
            }
            function.push_str(line);
            function.push('\n');
        }
        found.push((format!("{}:{begin}", path.display()), function));
    }
    found
}

/// Whether a report that ends behind `text` has a help: in its own chain, behind the end of the report before it, or in
/// a variable that holds a report with one.
fn has_help(text: &str) -> bool {
    let own = text.rsplit(".done()").next().unwrap();
    let mut statements = text
        .split(';')
        .filter(|statement| statement.contains("let "));
    own.contains(".help(") || statements.any(|statement| statement.contains(".help("))
}

#[test]
fn every_report_of_a_rule_has_a_help() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (place, function) in functions("src/rules") {
        for (at, _) in function.match_indices(".done()") {
            count += 1;
            if !has_help(&function[..at]) {
                wrong.push(format!("{place}: a report without `.help(...)`"));
            }
        }
    }
    assert!(count > 200, "only {count} reports");
    complain("rules", &wrong);
}

#[test]
fn every_finding_that_is_put_together_has_a_help() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for folder in ["src/rules", "src/analysis"] {
        for (place, function) in functions(folder) {
            let is_put_together =
                function.contains("Finding::new(") && !function.contains("draft(&mut self");
            if is_put_together {
                count += 1;
                if !function.contains("help") {
                    wrong.push(format!("{place}: a `Finding` without `help`"));
                }
            }
        }
    }
    assert!(count > 5, "only {count} findings");
    complain("findings", &wrong);
}

/// The kinds of problems in a text that stand behind one of these calls.
fn kinds<'a>(text: &'a str, calls: &'a [&str]) -> impl Iterator<Item = &'a str> {
    calls.iter().flat_map(move |call| {
        text.match_indices(call).filter_map(move |(at, _)| {
            text[at + call.len()..]
                .trim_start()
                .strip_prefix("ProblemKind::")?
                .split(|c: char| !c.is_alphanumeric())
                .next()
        })
    })
}

#[test]
fn every_problem_of_the_expander_has_a_help() {
    let advice = fs::read_to_string(root().join("src/expand/advice.rs")).unwrap();
    let general: BTreeSet<&str> = advice
        .lines()
        .filter_map(|line| line.trim().strip_prefix("ProblemKind::")?.split_once(" =>"))
        .map(|(kind, _)| kind)
        .collect();
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (place, function) in functions("src/expand") {
        for kind in kinds(&function, &["problem(", "error(", "warn(", "Problem::new("]) {
            count += 1;
            if !general.contains(kind) && !function.contains("help(") {
                wrong.push(format!(
                    "{place}: {kind} has no help, here or in `advice.rs`"
                ));
            }
        }
    }
    assert!(count > 50, "only {count} problems");
    complain("expander", &wrong);
}

/// A syntax error of XML has its help behind a line feed, but for entities, which `SyntaxError::help` answers for.
#[test]
fn every_syntax_error_has_a_help() {
    let mut wrong = Vec::new();
    for (place, function) in functions("src/xml/parse") {
        for text in super::literals(&function).into_iter().map(|(_, text)| text) {
            let is_message = text.starts_with(char::is_lowercase) || text.starts_with('`');
            if is_message
                && !text.contains("\\n")
                && !text.ends_with("before this")
                && !text.ends_with("here")
            {
                wrong.push(format!("{place}: `{text}` has no help"));
            }
        }
    }
    complain("XML", &wrong);
}
