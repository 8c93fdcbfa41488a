//! What the program prints, in the transcripts and on the pages: each error and warning with its help.

use std::fs;
use std::path::PathBuf;

use super::{HEADLINE, complain, files, prose, root, wrong_line};

/// The findings in a text with their source lines: `error[RULE]: MESSAGE`, lines that begin with a number, `|`, `-->`,
/// `:::` or `=`, and an empty line.
fn findings(text: &str) -> Vec<(String, Option<String>)> {
    let mut found: Vec<(String, Option<String>)> = Vec::new();
    let mut is_open = false;
    for line in text.lines() {
        let severity = ["error[", "warning[", "info[", "hint["]
            .iter()
            .find(|name| line.starts_with(**name));
        if let (Some(_), Some((_, message))) = (severity, line.split_once("]: ")) {
            // without a source line there is a path before the message, and no help
            is_open = !message.contains(".xacro: ") && !message.contains(".urdf: ");
            if is_open {
                found.push((message.to_owned(), None));
            }
        } else if let Some(help) = line
            .trim_start()
            .strip_prefix("= help: ")
            .filter(|_| is_open)
        {
            found.last_mut().unwrap().1 = Some(help.to_owned());
        } else if line.is_empty() {
            is_open = false;
        }
    }
    found
}

#[test]
fn printed_findings_follow_the_style_guide() {
    let mut paths: Vec<PathBuf> = vec![root().join("README.md")];
    for (folder, ending) in [("docs", ".md"), ("tests/cli", ".txt")] {
        files(&root().join(folder), ending, &mut paths);
    }
    let (mut wrong, mut count) = (Vec::new(), 0);
    for path in paths {
        for (message, help) in findings(&fs::read_to_string(&path).unwrap()) {
            count += 1;
            let mut say =
                |what: String| wrong.push(format!("{}: `{message}`: {what}", path.display()));
            match &help {
                Some(help) => wrong_line(help).into_iter().for_each(&mut say),
                None => say("no help".to_owned()),
            }
            wrong_line(&message).into_iter().for_each(&mut say);
            if prose(&message).chars().count() > HEADLINE {
                say("too long".to_owned());
            }
        }
    }
    assert!(count > 80, "only {count} findings");
    complain("printed", &wrong);
}
