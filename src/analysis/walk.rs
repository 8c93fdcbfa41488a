//! The descriptions below a folder.

use std::path::{Path, PathBuf};

use ignore::WalkBuilder;
use ignore::overrides::{Override, OverrideBuilder};

/// Folders that build tools make; nothing in them is a source.
const BUILT: [&str; 4] = ["build", "install", "log", "devel"];

/// The descriptions below `folder`, sorted by path. Left out are hidden files, what git ignores, the folders
/// of build tools and what matches a glob of `exclude`.
pub(super) fn descriptions(folder: &Path, exclude: &[String]) -> Vec<PathBuf> {
    let top = folder.to_owned();
    let mut walk = WalkBuilder::new(folder);
    walk.overrides(excluded(folder, exclude)).require_git(false).filter_entry(move |entry| {
        let is_dir = entry.file_type().is_some_and(|kind| kind.is_dir());
        let built = entry.file_name().to_str().is_some_and(|name| BUILT.contains(&name));
        !(is_dir && built) || entry.path() == top
    });
    let files = walk.build().flatten().filter(|entry| !entry.file_type().is_some_and(|kind| kind.is_dir()));
    let mut found: Vec<PathBuf> =
        files.map(ignore::DirEntry::into_path).filter(|path| is_description(path)).collect();
    found.sort();
    found
}

fn excluded(folder: &Path, exclude: &[String]) -> Override {
    let mut globs = OverrideBuilder::new(folder);
    for glob in exclude {
        // a glob that makes no sense was reported when the configuration was read
        let _ = globs.add(&format!("!{glob}"));
    }
    globs.build().unwrap_or_else(|_| Override::empty())
}

/// Whether a file is a description, by its name: `.urdf` and `.xacro`, alone or in front of `.xml`.
pub(super) fn is_description(path: &Path) -> bool {
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else { return false };
    let name = name.strip_suffix(".xml").unwrap_or(name);
    [".urdf", ".xacro"].iter().any(|ending| name.ends_with(ending))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::is_description;

    #[test]
    fn names_of_descriptions() {
        for (name, expected) in [
            ("a.urdf", true),
            ("a.xacro", true),
            ("a.urdf.xacro", true),
            ("a.urdf.xml", true),
            ("a.xacro.xml", true),
            ("package.xml", false),
            ("a.srdf.xacro", true),
            ("a.sdf", false),
            ("urdf", false),
        ] {
            assert_eq!(is_description(Path::new(name)), expected, "{name}");
        }
    }
}
