//! Links: those to files and headings lead there, those to elsewhere look like addresses.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use crate::pages::{self, Line, Page, root};

/// Letters that headings and links lose: what is code is no link.
fn without_code(line: &str) -> String {
    line.split('`')
        .enumerate()
        .filter(|(i, _)| i % 2 == 0)
        .map(|(_, part)| part)
        .collect::<Vec<_>>()
        .join(" ")
}

/// Targets of links and pictures, with their lines.
fn links(page: &Page) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (number, (line, kind)) in pages::lines(page).into_iter().enumerate() {
        if !matches!(kind, Line::Prose) {
            continue;
        }
        let line = without_code(line);
        let inline = line
            .match_indices("](")
            .map(|(at, _)| line[at + 2..].split(')').next().unwrap_or(""));
        let named = line
            .strip_prefix('[')
            .and_then(|rest| rest.split_once("]: "))
            .map(|(_, target)| target);
        let tags = ["src=\"", "href=\"", "srcset=\""]
            .into_iter()
            .flat_map(|attribute| {
                line.match_indices(attribute)
                    .map(move |(at, _)| at + attribute.len())
                    .collect::<Vec<_>>()
            });
        let tags = tags.map(|at| line[at..].split('"').next().unwrap_or(""));
        found.extend(
            inline
                .chain(named)
                .chain(tags)
                .map(|target| (number + 1, target.trim().to_owned())),
        );
    }
    found
}

/// The name that GitHub and mdBook give a heading.
pub fn anchor(heading: &str) -> String {
    // a link in a heading counts with its text
    let mut text = String::new();
    let mut rest = heading;
    while let Some((before, after)) = rest.split_once("](") {
        text.push_str(before);
        rest = after.split_once(')').map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    let kept = text
        .trim()
        .chars()
        .filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.map(|c| {
        if c == ' ' {
            '-'
        } else {
            c.to_ascii_lowercase()
        }
    })
    .collect()
}

fn anchors(page: &Page) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for (line, kind) in pages::lines(page) {
        let heading = line.trim_start_matches('#');
        if matches!(kind, Line::Prose) && heading.len() < line.len() && heading.starts_with(' ') {
            let name = anchor(heading);
            let before = found.iter().filter(|other| **other == name).count();
            found.push(if before == 0 {
                name
            } else {
                format!("{name}-{before}")
            });
        }
    }
    found
}

/// `a/b/../c` without going up and down.
fn flat(path: &Path) -> PathBuf {
    let mut flat = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => assert!(flat.pop(), "{}", path.display()),
            Component::CurDir => {}
            part => flat.push(part),
        }
    }
    flat
}

fn wrong_with(
    page: &Page,
    target: &str,
    anchors: &BTreeMap<String, Vec<String>>,
) -> Option<String> {
    if let Some((scheme, rest)) = target.split_once("://") {
        let host = rest.split('/').next().unwrap_or("");
        let plain = !target.contains([' ', '<', '>', '"']) && host.contains('.');
        return (scheme != "https" || !plain)
            .then(|| "is no address that begins with https".to_owned());
    }
    let (file, heading) = target.split_once('#').unwrap_or((target, ""));
    let path = if file.is_empty() {
        PathBuf::from(&page.path)
    } else {
        flat(&page.folder().join(file))
    };
    let name = path.to_str().unwrap().replace('\\', "/");
    if !root().join(&path).exists() {
        return Some("leads nowhere".to_owned());
    }
    if page.path.starts_with("docs/") && !name.starts_with("docs/") {
        return Some("leads out of the book".to_owned());
    }
    let known = anchors
        .get(&name)
        .is_some_and(|names| names.iter().any(|anchor| anchor == heading));
    (!heading.is_empty() && !known).then(|| format!("there is no heading `{heading}`"))
}

#[test]
fn links_lead_somewhere() {
    let pages = pages::all();
    let anchors = pages
        .iter()
        .map(|page| (page.path.clone(), anchors(page)))
        .collect();
    let (mut wrong, mut count) = (Vec::new(), 0);
    for page in &pages {
        for (line, target) in links(page) {
            count += 1;
            if let Some(why) = wrong_with(page, &target, &anchors) {
                wrong.push(format!("{}:{line}: `{target}` {why}", page.path));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 300, "only {count} links were seen");
}

#[test]
fn headings_get_the_names_that_are_linked() {
    assert_eq!(
        anchor(" `xacro: unbound prefix`, and what to do"),
        "xacro-unbound-prefix-and-what-to-do"
    );
    assert_eq!(anchor(" See [the page](a.md)"), "see-the-page");
}
