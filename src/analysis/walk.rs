//! The descriptions below a folder.

use std::path::{Path, PathBuf};

use ignore::WalkBuilder;

use super::session::Session;

/// Folders that build tools make; nothing in them is a source.
const BUILT: [&str; 4] = ["build", "install", "log", "devel"];

/// The descriptions below `folder`, sorted by path. Left out are hidden files, what git ignores, the folders
/// of build tools and what the configuration excludes. None when `stop` said so first.
pub(super) fn descriptions(
    folder: &Path,
    session: &Session,
    stop: &dyn Fn() -> bool,
) -> Option<Vec<PathBuf>> {
    let top = folder.to_owned();
    let mut walk = WalkBuilder::new(folder);
    walk.require_git(false).filter_entry(move |entry| {
        let is_dir = entry.file_type().is_some_and(|kind| kind.is_dir());
        let built = entry.file_name().to_str().is_some_and(|name| BUILT.contains(&name));
        !(is_dir && built) || entry.path() == top
    });
    let entries = walk.build().take_while(|_| !stop());
    let files = entries.flatten().filter(|entry| !entry.file_type().is_some_and(|kind| kind.is_dir()));
    let files = files.map(ignore::DirEntry::into_path).filter(|path| is_description(path));
    let mut found: Vec<PathBuf> = files.filter(|path| !session.settings(path).excludes(path)).collect();
    found.sort();
    (!stop()).then_some(found)
}

/// Whether a file is a description, by its name: `.urdf` and `.xacro`, alone or in front of `.xml`.
pub(super) fn is_description(path: &Path) -> bool {
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else { return false };
    let name = name.strip_suffix(".xml").unwrap_or(name);
    [".urdf", ".xacro"].iter().any(|ending| name.ends_with(ending))
}

/// Whether a file is certainly no description, by its name: an editor opens configurations and manifests as well.
pub(super) fn is_something_else(path: &Path) -> bool {
    const ENDINGS: [&str; 4] = ["yaml", "yml", "toml", "json"];
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("");
    ENDINGS.contains(&ending) || path.file_name().is_some_and(|name| name == "package.xml")
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
