//! Paths as descriptions write them.

use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};

use base::paths::HERE;

/// The way from a folder to a path; both absolute.
pub fn relative(folder: &Path, path: &Path) -> PathBuf {
    let (from, to): (Vec<Component<'_>>, Vec<Component<'_>>) =
        (folder.components().collect(), path.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let up = std::iter::repeat_n(Component::ParentDir, from.len() - common);
    up.chain(to.into_iter().skip(common)).collect()
}

/// Whether the letters alone tell that a path is absolute and has nothing in it to be tidied up.
pub(super) fn is_tidy(path: &Path) -> bool {
    let bytes = path.as_os_str().as_encoded_bytes();
    let is_plain = |slash: usize| {
        let step = bytes.get(slash + 1..).unwrap_or_default();
        !matches!(
            step,
            [] | [b'/', ..] | [b'.'] | [b'.', b'/', ..] | [b'.', b'.'] | [b'.', b'.', b'/', ..]
        )
    };
    !cfg!(windows) && bytes.starts_with(b"/") && memchr::memchr_iter(b'/', bytes).all(is_plain)
}

/// A path with `folder/..` taken out, by its text alone: links are not followed, and nothing has to exist.
pub fn without_parents(path: &Path) -> PathBuf {
    if is_tidy(path) {
        return path.to_owned();
    }
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

/// A path as it is shown and written: see [`base::paths::System::slashed`].
pub fn slashed(path: &Path) -> String {
    HERE.slashed(&path.to_string_lossy()).into_owned()
}

/// A path spelled as it is shown; as it is where it is no text.
pub fn spelled(path: PathBuf) -> PathBuf {
    match path.to_str().map(|text| HERE.slashed(text)) {
        Some(Cow::Owned(slashed)) => slashed.into(),
        Some(Cow::Borrowed(slashed)) if slashed.len() < path.as_os_str().len() => slashed.into(),
        _ => path,
    }
}

/// A path relative to `cwd` when it lies below, with `/` between its parts.
pub fn shown_path(path: &Path, cwd: &Path) -> String {
    let path = path.strip_prefix(cwd).unwrap_or(path);
    // a name must not begin a line of its own
    slashed(path).replace('\n', "␊")
}

#[cfg(test)]
mod tests {
    use super::{is_tidy, relative, slashed, without_parents};
    use std::path::Path;

    #[test]
    fn parents() {
        for (path, expected) in [
            ("/a/../b", "/b"),
            ("/a/b/../../../c", "/c"),
            ("/a/./b//c/..", "/a/b"),
            ("/..", "/"),
        ] {
            assert_eq!(
                without_parents(Path::new(path)),
                Path::new(expected),
                "{path}"
            );
        }
    }

    #[test]
    #[cfg(not(windows))]
    fn tidy_paths() {
        for path in ["/a/b", "/a/.b", "/a/..b/c.x", "/a b"] {
            assert!(is_tidy(Path::new(path)), "{path}");
        }
        for path in [
            "a/b", "/", "/a/", "/a//b", "/a/./b", "/a/.", "/a/../b", "/..", "",
        ] {
            assert!(!is_tidy(Path::new(path)), "{path}");
        }
    }

    #[test]
    fn relative_paths() {
        for (path, folder, expected) in [
            ("/a/b/c.x", "/a/b", "c.x"),
            ("/a/b/c.x", "/a/d/e", "../../b/c.x"),
            ("/a/c.x", "/a/d", "../c.x"),
        ] {
            assert_eq!(
                slashed(&relative(Path::new(folder), Path::new(path))),
                expected
            );
        }
    }
}
