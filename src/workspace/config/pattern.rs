//! Globs of files, relative to the folder of a configuration file.

use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};

use base::limits::{GLOB_ALTERNATIVES, GLOB_FOLDERS};
use base::paths::HERE;
use packages::is_built;
use vfs::{Vfs, Wildcard, covers, has_magic};

/// A glob: `*`, `?`, `[...]` inside a name, `**` for any number of folders, `{a,b}` for alternatives. One
/// without a slash matches names in every folder. What lies below a folder that matches, matches.
#[derive(Clone, Debug)]
pub struct Pattern {
    text: String,
    folder: PathBuf,
    alternatives: Vec<Vec<Segment>>,
}

#[derive(Clone, Debug)]
enum Segment {
    AnyDepth,
    Name(Wildcard),
}

impl Segment {
    fn is_any_depth(&self) -> bool {
        matches!(self, Segment::AnyDepth)
    }

    fn takes(&self, name: &str) -> bool {
        match self {
            Segment::AnyDepth => true,
            Segment::Name(wildcard) => wildcard.matches(name),
        }
    }
}

impl Pattern {
    /// The pattern `text` in a file of `folder` (absolute).
    pub fn new(text: &str, folder: &Path) -> Self {
        let mut folder = folder.to_owned();
        let mut rest = text;
        loop {
            if let Some(behind) = rest.strip_prefix("./") {
                rest = behind;
            } else if let Some(behind) = rest.strip_prefix("../") {
                rest = behind;
                folder.pop();
            } else {
                break;
            }
        }
        let root = HERE.root(rest);
        if !root.is_empty() {
            folder = PathBuf::from(root);
            rest = rest.get(root.len()..).unwrap_or("");
        }
        // `./a` is the one in the folder, `a` is any below it
        let is_anchored = rest.len() < text.len();
        let mut alternatives = Vec::new();
        expand_braces(rest, &mut alternatives);
        let alternatives = alternatives
            .iter()
            .map(|text| segments(text, is_anchored))
            .collect();
        Self {
            text: text.to_owned(),
            folder,
            alternatives,
        }
    }

    /// As it is written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether `path` (absolute), or a folder it lies in, matches.
    pub fn matches(&self, path: &Path) -> bool {
        let Ok(relative) = path.strip_prefix(&self.folder) else {
            return false;
        };
        self.alternatives
            .iter()
            .any(|segments| covers_folder(segments, relative))
    }

    /// The longest path that everything that matches begins with, and whether it is the only one that does.
    pub fn start(&self) -> (PathBuf, bool) {
        let mut start = self.folder.clone();
        let [segments] = self.alternatives.as_slice() else {
            return (start, false);
        };
        for segment in segments {
            match segment {
                Segment::Name(name) if name.literal().is_some() => start.extend(name.literal()),
                _ => return (start, false),
            }
        }
        (start, true)
    }

    /// The files below the folder that match, sorted. Hidden folders and those of build tools are left out.
    pub fn files(&self, vfs: &Vfs) -> Vec<PathBuf> {
        let (mut found, mut folders, mut seen) = (Vec::new(), vec![self.folder.clone()], 0);
        while let Some(folder) = folders.pop() {
            seen += 1;
            if seen > GLOB_FOLDERS {
                break;
            }
            for entry in vfs.list_dir(&folder).iter() {
                let path = folder.join(&entry.name);
                let skipped = entry.name.starts_with('.') || is_built(&entry.name);
                if !entry.is_dir {
                    found.extend(self.covers(&self.names(&path)).then_some(path));
                } else if !skipped && vfs.is_own_folder(&path) {
                    folders.push(path);
                }
            }
        }
        found.sort();
        found
    }

    /// The files that match, found by listing only the folders that may lead to one; none when more than `most` would have to be
    /// listed.
    pub fn reached(&self, vfs: &Vfs, most: usize) -> Vec<PathBuf> {
        let (mut found, mut left) = (Vec::new(), most);
        for segments in &self.alternatives {
            reach(vfs, &self.folder, segments, &mut left, &mut found);
        }
        found.sort();
        found.dedup();
        if left == 0 { Vec::new() } else { found }
    }

    /// The names on the way from the folder to `path`; none when it lies elsewhere.
    fn names<'p>(&self, path: &'p Path) -> Vec<Cow<'p, str>> {
        path.strip_prefix(&self.folder)
            .map(|relative| names_of(relative).collect())
            .unwrap_or_default()
    }

    fn covers(&self, names: &[Cow<'_, str>]) -> bool {
        self.alternatives
            .iter()
            .any(|segments| covers_all(segments, names))
    }
}

/// Add the files below a folder that segments lead to, while folders may still be listed.
fn reach(
    vfs: &Vfs,
    folder: &Path,
    segments: &[Segment],
    left: &mut usize,
    found: &mut Vec<PathBuf>,
) {
    let Some((first, rest)) = segments.split_first() else {
        return;
    };
    let literal = match first {
        Segment::Name(name) => name.literal(),
        Segment::AnyDepth => None,
    };
    if let Some(name) = literal {
        let path = folder.join(name);
        if rest.is_empty() {
            found.extend(vfs.is_file(&path).then_some(path));
        } else {
            reach(vfs, &path, rest, left, found);
        }
        return;
    }
    if first.is_any_depth() {
        reach(vfs, folder, rest, left, found);
    }
    if *left == 0 {
        return;
    }
    *left -= 1;
    for entry in vfs.list_dir(folder).iter() {
        let skipped = entry.name.starts_with('.') || is_built(&entry.name);
        let path = folder.join(&entry.name);
        if skipped || !first.takes(&entry.name) {
            continue;
        }
        if !entry.is_dir {
            if rest.is_empty() {
                found.push(path);
            }
        } else if vfs.is_own_folder(&path) {
            let below = if first.is_any_depth() { segments } else { rest };
            reach(vfs, &path, below, left, found);
        }
    }
}

/// Whether segments cover the names of a path, none left.
fn covers_all(segments: &[Segment], names: &[Cow<'_, str>]) -> bool {
    !names.is_empty()
        && covers(segments, names, Segment::is_any_depth, |segment, name| {
            segment.takes(name)
        })
}

/// The names of a relative path.
fn names_of(path: &Path) -> impl Iterator<Item = Cow<'_, str>> {
    path.components().filter_map(|component| match component {
        Component::Normal(name) => Some(name.to_string_lossy()),
        _ => None,
    })
}

/// Whether segments cover the names of a relative path, or those of a folder it lies in.
fn covers_folder(segments: &[Segment], path: &Path) -> bool {
    if segments.iter().any(Segment::is_any_depth) {
        let names: Vec<_> = names_of(path).collect();
        return (1..=names.len()).any(|count| {
            names
                .get(..count)
                .is_some_and(|names| covers_all(segments, names))
        });
    }
    // as many names as segments, so there is nothing to try
    let mut names = names_of(path);
    !segments.is_empty()
        && segments
            .iter()
            .all(|segment| names.next().is_some_and(|name| segment.takes(&name)))
}

fn segments(text: &str, is_anchored: bool) -> Vec<Segment> {
    let text = text.trim_end_matches('/');
    let anywhere =
        (!is_anchored && !text.is_empty() && !text.contains('/')).then_some(Segment::AnyDepth);
    let named = text
        .split('/')
        .filter(|name| !name.is_empty() && *name != ".")
        .map(|name| match name {
            "**" => Segment::AnyDepth,
            name => Segment::Name(Wildcard::new(name)),
        });
    anywhere.into_iter().chain(named).collect()
}

/// `a{b,c}` as `ab` and `ac`; braces without a comma, or not closed, are letters.
fn expand_braces(text: &str, out: &mut Vec<String>) {
    let group = text.find('{').and_then(|open| {
        let close = open + text.get(open..)?.find('}')?;
        let inner = text.get(open + 1..close)?;
        inner
            .contains(',')
            .then_some((text.get(..open)?, inner, text.get(close + 1..)?))
    });
    match group {
        Some((before, inner, behind)) => {
            for choice in inner.split(',') {
                if out.len() < GLOB_ALTERNATIVES {
                    expand_braces(&format!("{before}{choice}{behind}"), out);
                }
            }
        }
        None => out.push(text.to_owned()),
    }
}

/// Whether a text is a pattern, not a path.
pub(super) fn is_pattern(text: &str) -> bool {
    has_magic(text) || text.contains('{') && text.contains(',')
}

#[cfg(test)]
mod tests {
    use super::Pattern;
    use std::path::Path;
    use vfs::testing::Tree;

    #[test]
    fn matching() {
        let table = [
            ("*.xacro", "a.xacro", true),
            ("*.xacro", "sub/a.xacro", true),
            ("*.xacro", "a.urdf", false),
            ("./*.xacro", "a.xacro", true),
            ("./*.xacro", "sub/a.xacro", false),
            ("../ws/a.xacro", "a.xacro", true),
            ("../ws/a.xacro", "sub/a.xacro", false),
            ("test", "test/a.xacro", true),
            ("test", "sub/test/a.xacro", true),
            ("test/", "test/a.xacro", true),
            ("/ws/test", "test/a.xacro", true),
            ("/test", "test/a.xacro", false),
            ("sub/*.xacro", "sub/a.xacro", true),
            ("sub/*.xacro", "sub/deep/a.xacro", false),
            ("sub/*.xacro", "other/sub/a.xacro", false),
            ("sub/**/*.xacro", "sub/a.xacro", true),
            ("sub/**/*.xacro", "sub/x/y/a.xacro", true),
            ("**/urdf/*.xacro", "a/b/urdf/r.xacro", true),
            ("**/urdf/*.xacro", "urdf/r.xacro", true),
            ("vendor/**", "vendor/x/y", true),
            ("vendor/**", "vendors/x", false),
            ("*.{xacro,urdf}", "a.urdf", true),
            ("*.{xacro,urdf}", "a.srdf", false),
            ("{a,b}/{c,d}.x", "b/c.x", true),
            ("{a}", "{a}", true),
            ("a{b", "a{b", true),
            ("[ab].x", "b.x", true),
            ("[!ab].x", "b.x", false),
            ("", "a", false),
        ];
        for (pattern, path, expected) in table {
            let pattern = Pattern::new(pattern, Path::new("/ws"));
            assert_eq!(
                pattern.matches(&Path::new("/ws").join(path)),
                expected,
                "{} {path}",
                pattern.text()
            );
        }
        assert!(Pattern::new("../other/*.x", Path::new("/ws")).matches(Path::new("/other/a.x")));
        assert!(!Pattern::new("*", Path::new("/ws")).matches(Path::new("/elsewhere/a.x")));
        let braces = "{a,b}".repeat(100);
        assert!(!Pattern::new(&braces, Path::new("/ws")).matches(Path::new("/ws/a")));
    }

    #[test]
    fn starts() {
        for (pattern, expected) in [
            ("./a/b.x", ("/ws/a/b.x", true)),
            ("./a/*.x", ("/ws/a", false)),
            ("../a/b?/c.x", ("/a", false)),
            ("./{a,b}/c.x", ("/ws", false)),
            ("b.x", ("/ws", false)),
            ("./b.x", ("/ws/b.x", true)),
            ("/a/b.x", ("/a/b.x", true)),
        ] {
            let (start, is_whole) = Pattern::new(pattern, Path::new("/ws")).start();
            assert_eq!((start.to_str().unwrap(), is_whole), expected, "{pattern}");
        }
    }

    #[test]
    fn files() {
        let tree = Tree::new();
        for file in [
            "a.xacro",
            "sub/b.xacro",
            "sub/c.urdf",
            "build/d.xacro",
            ".git/e.xacro",
        ] {
            tree.write(file, "");
        }
        let found = Pattern::new("**/*.xacro", tree.root()).files(tree.vfs());
        assert_eq!(found, [tree.path("a.xacro"), tree.path("sub/b.xacro")]);
    }

    #[test]
    fn only_folders_that_may_lead_to_a_match_are_listed() {
        let tree = Tree::new();
        for file in [
            "arm/g6/urdf/a.xacro",
            "arm/g7/urdf/a.xacro",
            "arm/g7/b.xacro",
            "arm/build/urdf/a.xacro",
            "leg/urdf/a.xacro",
        ] {
            tree.write(file, "");
        }
        let reached =
            |pattern: &str, most| Pattern::new(pattern, tree.root()).reached(tree.vfs(), most);
        let both = [
            tree.path("arm/g6/urdf/a.xacro"),
            tree.path("arm/g7/urdf/a.xacro"),
        ];
        assert_eq!(reached("./arm/*/urdf/a.xacro", 10), both);
        assert_eq!(reached("./arm/**/urdf/*.xacro", 20), both);
        assert_eq!(
            reached("./arm/g7/*.xacro", 2),
            [tree.path("arm/g7/b.xacro")]
        );
        // more than one folder would have to be listed
        assert_eq!(
            reached("./arm/*/*/a.xacro", 2),
            Vec::<std::path::PathBuf>::new()
        );
    }
}
