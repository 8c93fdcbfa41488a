//! Who may include whom, read off the texts alone: conditions and arguments are not looked at.

use std::path::Path;

use globset::{Glob, GlobMatcher};

use crate::vfs::SourceFile;
use crate::workspace::Packages;

/// The files that a file may include, as patterns of absolute paths.
pub(super) fn patterns(source: &SourceFile, packages: &Packages) -> Vec<GlobMatcher> {
    let document = &source.document;
    let nodes =
        document.parts().flat_map(|(_, item)| item.all_nodes()).filter(|node| node.name() == "xacro:include");
    let names = nodes.filter_map(|node| Some(node.attr("filename")?.value(document.entities()).into_owned()));
    names.filter_map(|name| pattern(&name, &source.path, packages)).collect()
}

/// A file name with packages found and every other expression standing for anything.
fn pattern(name: &str, from: &Path, packages: &Packages) -> Option<GlobMatcher> {
    let mut pattern = String::new();
    let mut rest = name;
    while let Some(at) = rest.find('$') {
        let (before, after) = rest.split_at(at);
        pattern.push_str(&globset::escape(before));
        let close = if after.starts_with("${") { '}' } else { ')' };
        let end = after.find(close)?;
        match after.get(2..end)?.trim().strip_prefix("find ") {
            Some(package) => {
                pattern.push_str(&globset::escape(packages.find(package.trim(), from).ok()?.path.to_str()?))
            }
            None => pattern.push('*'),
        }
        rest = after.get(end + 1..)?;
    }
    pattern.push_str(&globset::escape(rest));
    if !pattern.starts_with(['/', '*']) {
        pattern = format!("{}/{pattern}", globset::escape(from.parent()?.to_str()?));
    }
    Some(Glob::new(&tidy(&pattern)).ok()?.compile_matcher())
}

/// The path without `folder/..`, by its text alone.
fn tidy(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            ".." => {
                parts.pop();
            }
            "." => {}
            part => parts.push(part),
        }
    }
    parts.join("/")
}
