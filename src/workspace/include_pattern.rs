//! The files that an include may name, read off its text alone: packages are found, and every other expression stands for
//! anything.

use std::path::{Path, PathBuf};

use super::config::Pattern;
use base::paths::HERE;
use packages::Packages;
use vfs::{Vfs, without_parents};

/// Files that one include with a computed name may bring in.
const MOST_FILES: usize = 20;
/// Folders that one include has looked into.
const MOST_FOLDERS: usize = 60;

/// The file that an include names, when nothing has to be computed but packages, and there is one.
pub fn named_file(name: &str, from: &Path, packages: &Packages, vfs: &Vfs) -> Option<PathBuf> {
    let mut path = String::new();
    let mut rest = name;
    while let Some((before, after)) = rest.split_once("$(find ") {
        let (package, behind) = after.split_once(')')?;
        path.push_str(before);
        path.push_str(packages.find(package.trim(), from).ok()?.path.to_str()?);
        rest = behind;
    }
    path.push_str(rest);
    let plain = !path.contains(['$', '*', '?', '[']);
    let path = plain.then(|| without_parents(&from.parent().unwrap_or(from).join(path)))?;
    let path = packages.present(&path).into_owned();
    vfs.is_file(&path).then_some(path)
}

/// The files that an include with a computed name may bring in, with whatever arguments. None when there are too many, or too many
/// folders to look into: the name says too little then.
pub fn admitted_files(name: &str, from: &Path, packages: &Packages, vfs: &Vfs) -> Vec<PathBuf> {
    let pattern = name
        .contains('$')
        .then(|| include_pattern(name, from, packages))
        .flatten();
    let Some(pattern) = pattern.filter(|pattern| !pattern.start().1) else {
        return Vec::new();
    };
    few_files(&pattern, vfs)
}

/// The files that an include may name, as a pattern says: the one that is written out, or those in any folder that fits, if they are
/// few; else those in the folder in front of what is computed.
pub fn reached_files(pattern: &Pattern, vfs: &Vfs) -> Vec<PathBuf> {
    let found = if pattern.start().1 {
        Vec::new()
    } else {
        few_files(pattern, vfs)
    };
    if found.is_empty() {
        included_files(pattern, vfs)
    } else {
        found
    }
}

/// The files that a pattern matches; none when there are too many.
fn few_files(pattern: &Pattern, vfs: &Vfs) -> Vec<PathBuf> {
    let mut found = pattern.reached(vfs, MOST_FOLDERS);
    if found.len() > MOST_FILES {
        found.clear();
    }
    found
}

/// A file name with packages found and every other expression standing for anything. None when the name says
/// nothing about the file.
pub fn include_pattern(name: &str, from: &Path, packages: &Packages) -> Option<Pattern> {
    let mut pattern = String::new();
    let mut rest = name;
    while let Some(at) = rest.find('$') {
        let (before, after) = rest.split_at(at);
        pattern.push_str(before);
        let close = if after.starts_with("${") { '}' } else { ')' };
        let end = after.find(close)?;
        match after.get(2..end)?.trim().strip_prefix("find ") {
            Some(package) => pattern.push_str(&vfs::slashed(
                &packages.find(package.trim(), from).ok()?.path,
            )),
            // a whole step of the path may be several
            None if (pattern.is_empty() || pattern.ends_with('/'))
                && after.get(end + 1..)?.starts_with('/') =>
            {
                pattern.push_str("**");
            }
            None => pattern.push('*'),
        }
        rest = after.get(end + 1..)?;
    }
    pattern.push_str(rest);
    let folder = from.parent()?;
    let file = pattern.rsplit('/').next().unwrap_or("");
    let says_something = file.chars().any(|c| !matches!(c, '*' | '.'));
    says_something.then(|| {
        let root = HERE.root(&pattern);
        let pattern = tidy(pattern.get(root.len()..).unwrap_or(""), root);
        Pattern::new(
            &installed(&pattern, folder, packages).unwrap_or(pattern),
            folder,
        )
    })
}

/// The files that an include may name, as a pattern says: the one that is written out, or those in the folder that is
/// written in front of what is computed, and nowhere else.
pub fn included_files(pattern: &Pattern, vfs: &Vfs) -> Vec<PathBuf> {
    match pattern.start() {
        (path, true) if vfs.is_file(&path) => vec![path],
        (_, true) => Vec::new(),
        (start, false) => {
            let folder = if vfs.is_dir(&start) {
                Some(start.as_path())
            } else {
                start.parent()
            };
            let Some(folder) = folder else {
                return Vec::new();
            };
            let files = vfs.list_dir(folder);
            let paths = files
                .iter()
                .filter(|entry| !entry.is_dir)
                .map(|entry| folder.join(&entry.name));
            paths.filter(|path| pattern.matches(path)).collect()
        }
    }
}

/// A pattern whose folders only the build makes, as a pattern of the source tree.
fn installed(pattern: &str, folder: &Path, packages: &Packages) -> Option<String> {
    let end = pattern
        .find('*')
        .map_or(Some(pattern.len()), |star| pattern.get(..star)?.rfind('/'))?;
    let (start, rest) = pattern.split_at_checked(end)?;
    let start = folder.join(start);
    let present = packages.present(&start);
    (*present != *start).then(|| format!("{}{rest}", vfs::slashed(&present)))
}

/// What follows the root of a path, without `folder/..`, by its text alone.
fn tidy(path: &str, root: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path
        .split('/')
        .filter(|part| !part.is_empty() && *part != ".")
    {
        match parts.last() {
            Some(&last) if part == ".." && last != ".." => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    let lead = if root.is_empty() { "./" } else { root };
    format!("{lead}{}", parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::tidy;

    #[test]
    fn paths() {
        for (path, root, expected) in [
            ("./a/b.xacro", "", "./a/b.xacro"),
            ("./a/../b.xacro", "", "./b.xacro"),
            ("./../a/./b.xacro", "", "./../a/b.xacro"),
            ("ws/pkg/../b.xacro", "/", "/ws/b.xacro"),
            ("ws/pkg/../b.xacro", "C:/", "C:/ws/b.xacro"),
        ] {
            assert_eq!(tidy(path, root), expected);
        }
    }
}
