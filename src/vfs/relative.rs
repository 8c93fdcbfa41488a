//! Paths as descriptions write them.

use std::path::{Component, Path, PathBuf};

/// The way from a folder to a path; both absolute.
pub fn relative(folder: &Path, path: &Path) -> PathBuf {
    let (from, to): (Vec<Component<'_>>, Vec<Component<'_>>) =
        (folder.components().collect(), path.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let up = std::iter::repeat_n(Component::ParentDir, from.len() - common);
    up.chain(to.into_iter().skip(common)).collect()
}

/// A path with `folder/..` taken out, by its text alone: links are not followed, and nothing has to exist.
pub fn without_parents(path: &Path) -> PathBuf {
    let mut clean = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => {
                clean.pop();
            }
            other => clean.push(other),
        }
    }
    clean
}

/// A path with slashes, on every system.
pub fn slashed(path: &Path) -> String {
    let text = path.to_string_lossy();
    if std::path::MAIN_SEPARATOR == '/' {
        text.into_owned()
    } else {
        text.replace(std::path::MAIN_SEPARATOR, "/")
    }
}

#[cfg(test)]
mod tests {
    use super::{relative, slashed, without_parents};
    use std::path::Path;

    #[test]
    fn parents() {
        for (path, expected) in
            [("/a/../b", "/b"), ("/a/b/../../../c", "/c"), ("/a/./b//c/..", "/a/b"), ("/..", "/")]
        {
            assert_eq!(without_parents(Path::new(path)), Path::new(expected), "{path}");
        }
    }

    #[test]
    fn relative_paths() {
        for (path, folder, expected) in
            [("/a/b/c.x", "/a/b", "c.x"), ("/a/b/c.x", "/a/d/e", "../../b/c.x"), ("/a/c.x", "/a/d", "../c.x")]
        {
            assert_eq!(slashed(&relative(Path::new(folder), Path::new(path))), expected);
        }
    }
}
