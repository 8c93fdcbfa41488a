//! Who may include whom, read off the texts alone: conditions and arguments are not looked at.

use std::path::Path;

use crate::vfs::SourceFile;
use crate::workspace::Packages;
use crate::workspace::config::Pattern;

/// The files that a file may include, as patterns of absolute paths.
pub(super) fn patterns(source: &SourceFile, packages: &Packages) -> Vec<Pattern> {
    let document = &source.document;
    let nodes =
        document.parts().flat_map(|(_, item)| item.all_nodes()).filter(|node| node.name() == "xacro:include");
    let names = nodes.filter_map(|node| Some(node.attr("filename")?.value(document.entities()).into_owned()));
    names.filter_map(|name| pattern(&name, &source.path, packages)).collect()
}

/// A file name with packages found and every other expression standing for anything. None when the name says
/// nothing about the file.
fn pattern(name: &str, from: &Path, packages: &Packages) -> Option<Pattern> {
    let mut pattern = String::new();
    let mut rest = name;
    while let Some(at) = rest.find('$') {
        let (before, after) = rest.split_at(at);
        pattern.push_str(before);
        let close = if after.starts_with("${") { '}' } else { ')' };
        let end = after.find(close)?;
        match after.get(2..end)?.trim().strip_prefix("find ") {
            Some(package) => pattern.push_str(packages.find(package.trim(), from).ok()?.path.to_str()?),
            None => pattern.push('*'),
        }
        rest = after.get(end + 1..)?;
    }
    pattern.push_str(rest);
    let folder = from.parent()?;
    let file = pattern.rsplit('/').next().unwrap_or("");
    let says_something = file.chars().any(|c| !matches!(c, '*' | '.'));
    says_something.then(|| Pattern::new(&tidy(&format!("./{pattern}"), pattern.starts_with('/')), folder))
}

/// An absolute path without `folder/..`, by its text alone.
pub(super) fn tidy_path(path: &Path) -> std::path::PathBuf {
    tidy(&path.to_string_lossy(), true).into()
}

/// The path without `folder/..`, by its text alone.
fn tidy(path: &str, absolute: bool) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/').filter(|part| !part.is_empty() && *part != ".") {
        match parts.last() {
            Some(&last) if part == ".." && last != ".." => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    let lead = if absolute { "/" } else { "./" };
    format!("{lead}{}", parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::tidy;

    #[test]
    fn paths() {
        for (path, absolute, expected) in [
            ("./a/b.xacro", false, "./a/b.xacro"),
            ("./a/../b.xacro", false, "./b.xacro"),
            ("./../a/./b.xacro", false, "./../a/b.xacro"),
            (".//ws/pkg/../b.xacro", true, "/ws/b.xacro"),
        ] {
            assert_eq!(tidy(path, absolute), expected);
        }
    }
}
