//! Shell patterns with the exact meaning of Python's `glob.glob` (3.11, not recursive).

use std::path::{Path, PathBuf};

use super::Vfs;
use base::limits::GLOB_FILES;
use base::paths::HERE;

/// Why nobody knows all files of a pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TooMany {
    /// It matches more than [`GLOB_FILES`].
    Files,
    /// More has to be looked at than the caller allows.
    Entries,
}

/// The sorted matches of `pattern`; a relative one starts at `base`. What is looked at is taken off `left`.
pub(super) fn glob(
    vfs: &Vfs,
    pattern: &str,
    base: &Path,
    left: &mut usize,
) -> Result<Vec<PathBuf>, TooMany> {
    if pattern.is_empty() {
        return Ok(Vec::new());
    }
    let (start, names) = stages(pattern);
    let mut found = vec![start.to_owned()];
    for (index, name) in names.iter().enumerate().rev() {
        found = GlobStage {
            vfs,
            base,
            name,
            is_last: index == 0,
        }
        .run(&found, left)?;
    }
    if !has_magic(pattern) {
        // such a path is given back as it is spelled
        found = found.iter().map(|_| pattern.to_owned()).collect();
    }
    found.sort();
    Ok(found.into_iter().map(PathBuf::from).collect())
}

/// Whether a text has any of the characters that make it a pattern.
pub fn has_magic(text: &str) -> bool {
    text.contains(['*', '?', '['])
}

/// The folder that a pattern starts from, and the names below it, the last one first.
fn stages(pattern: &str) -> (&str, Vec<&str>) {
    let magic = pattern.find(['*', '?', '[']).unwrap_or(pattern.len());
    let (mut rest, mut names) = (pattern, Vec::new());
    loop {
        let (folder, name) = split(rest);
        names.push(name);
        if folder.len() <= magic || folder == rest {
            return (folder, names);
        }
        rest = folder;
    }
}

/// One name of a pattern, looked for in all folders that match what stands before it.
struct GlobStage<'a> {
    vfs: &'a Vfs,
    base: &'a Path,
    name: &'a str,
    is_last: bool,
}

impl GlobStage<'_> {
    fn run(&self, folders: &[String], left: &mut usize) -> Result<Vec<String>, TooMany> {
        let mut found = Vec::new();
        let wildcard = has_magic(self.name).then(|| Wildcard::new(&HERE.folded(self.name)));
        for folder in folders {
            let path = self.base.join(folder);
            match &wildcard {
                Some(wildcard) => {
                    for name in self.matching(&path, wildcard, left)? {
                        found.push(join(folder, &name));
                    }
                }
                None => {
                    *left = left.checked_sub(1).ok_or(TooMany::Entries)?;
                    if self.is_there(&path) {
                        found.push(join(folder, self.name));
                    }
                }
            }
            if self.is_last && found.len() > GLOB_FILES {
                return Err(TooMany::Files);
            }
        }
        Ok(found)
    }

    /// Whether a folder has this very name.
    fn is_there(&self, folder: &Path) -> bool {
        if self.name.is_empty() {
            return self.vfs.is_dir(folder);
        }
        // also true for a link that leads nowhere
        self.vfs
            .shared
            .disk
            .is_present(&self.vfs.absolute(&folder.join(self.name)))
    }

    fn matching(
        &self,
        folder: &Path,
        wildcard: &Wildcard,
        left: &mut usize,
    ) -> Result<Vec<String>, TooMany> {
        let mut names = Vec::new();
        for entry in self.vfs.shared.disk.entries(&self.vfs.absolute(folder)) {
            *left = left.checked_sub(1).ok_or(TooMany::Entries)?;
            let is_hidden = entry.name.starts_with('.') && !self.name.starts_with('.');
            if !is_hidden
                && (entry.is_dir || self.is_last)
                && wildcard.matches(&HERE.folded(&entry.name))
            {
                names.push(entry.name);
            }
        }
        Ok(names)
    }
}

/// Folder and last component, as `os.path.split` cuts them.
fn split(path: &str) -> (&str, &str) {
    let cut = path.rfind('/').map_or(0, |slash| slash + 1);
    let (folder, name) = path.split_at(cut);
    let trimmed = folder.trim_end_matches('/');
    // what a path begins with keeps its slash
    (
        if trimmed.len() < HERE.root(folder).len() {
            folder
        } else {
            trimmed
        },
        name,
    )
}

fn join(folder: &str, name: &str) -> String {
    if folder.is_empty() || folder.ends_with('/') {
        format!("{folder}{name}")
    } else {
        format!("{folder}/{name}")
    }
}

/// A pattern for one name: `*`, `?`, `[abc]`, `[!abc]`, as Python's `fnmatch` reads them.
#[derive(Clone, Debug)]
pub struct Wildcard {
    tokens: Vec<GlobToken>,
    literal: Option<String>,
}

impl Wildcard {
    /// The pattern `text`; every text is one.
    pub fn new(text: &str) -> Self {
        let letter = |token: &GlobToken| match token {
            GlobToken::Literal(letter) => Some(*letter),
            _ => None,
        };
        let tokens = compile(text);
        Self {
            literal: tokens.iter().map(letter).collect(),
            tokens,
        }
    }

    /// The only name that fits, where there is only one.
    pub fn literal(&self) -> Option<&str> {
        self.literal.as_deref()
    }

    /// Whether the whole of `name` fits.
    pub fn matches(&self, name: &str) -> bool {
        if let Some(literal) = &self.literal {
            return literal == name;
        }
        let name: Vec<char> = name.chars().collect();
        covers(
            &self.tokens,
            &name,
            |token| matches!(token, GlobToken::Many),
            |token, c| token.takes(*c),
        )
    }
}

/// One element of a pattern.
#[derive(Clone, Debug)]
enum GlobToken {
    Literal(char),
    Any,
    Many,
    Class {
        negated: bool,
        ranges: Vec<(char, char)>,
    },
}

fn compile(pattern: &str) -> Vec<GlobToken> {
    let chars: Vec<char> = pattern.chars().collect();
    let mut tokens = Vec::new();
    let mut rest = chars.as_slice();
    // without one, no class ends: that is not to be looked for at each `[`
    let last_close = chars.iter().rposition(|&c| c == ']').unwrap_or(0);
    while let Some((&first, behind)) = rest.split_first() {
        let may_close = chars.len() - rest.len() < last_close;
        rest = behind;
        tokens.push(match first {
            // several in a row are one
            '*' if matches!(tokens.last(), Some(GlobToken::Many)) => continue,
            '*' => GlobToken::Many,
            '?' => GlobToken::Any,
            '[' => match may_close.then(|| class(behind)).flatten() {
                Some((token, behind)) => {
                    rest = behind;
                    token
                }
                None => GlobToken::Literal('['),
            },
            other => GlobToken::Literal(other),
        });
    }
    tokens
}

/// The class behind a `[`, and what follows its `]`; `None` when it is not closed.
fn class(text: &[char]) -> Option<(GlobToken, &[char])> {
    let negated = text.first() == Some(&'!');
    let body = text.get(usize::from(negated)..)?;
    // A `]` right at the start is a member.
    let close = body.iter().skip(1).position(|&c| c == ']')? + 1;
    let (members, behind) = body.split_at_checked(close)?;
    let mut ranges = Vec::new();
    let mut members = members;
    while let Some((&low, rest)) = members.split_first() {
        members = match rest {
            ['-', high, rest @ ..] => {
                ranges.push((low, *high));
                rest
            }
            _ => {
                ranges.push((low, low));
                rest
            }
        };
    }
    Some((GlobToken::Class { negated, ranges }, behind.get(1..)?))
}

impl GlobToken {
    fn takes(&self, c: char) -> bool {
        match self {
            GlobToken::Literal(literal) => *literal == c,
            GlobToken::Any | GlobToken::Many => true,
            GlobToken::Class { negated, ranges } => {
                ranges.iter().any(|&(low, high)| low <= c && c <= high) != *negated
            }
        }
    }
}

/// Whether a pattern covers all items, where a star stands for any number of them and every other element
/// for one it takes. Only the last star seen is ever extended, so the time is at most the product of the
/// lengths.
pub fn covers<P, T>(
    pattern: &[P],
    items: &[T],
    is_star: impl Fn(&P) -> bool,
    takes: impl Fn(&P, &T) -> bool,
) -> bool {
    let (mut element, mut at) = (0, 0);
    let mut star: Option<(usize, usize)> = None;
    loop {
        match (pattern.get(element), items.get(at)) {
            (Some(one), _) if is_star(one) => {
                star = Some((element + 1, at));
                element += 1;
            }
            (Some(one), Some(item)) if takes(one, item) => {
                element += 1;
                at += 1;
            }
            (None, None) => return true,
            _ => match star {
                Some((behind, from)) if from < items.len() => {
                    star = Some((behind, from + 1));
                    (element, at) = (behind, from + 1);
                }
                _ => return false,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::Tree;
    use super::{Wildcard, split};

    #[test]
    fn names() {
        // pattern, name, whether `fnmatch.fnmatchcase` of CPython 3.11 accepts it
        let table = [
            ("*.xacro", "a.xacro", true),
            ("*.xacro", "a.xacro~", false),
            ("a*b*c", "aXbYbc", true),
            ("a*b*c", "aXbYb", false),
            ("**", "anything", true),
            ("?", "é", true),
            ("?", "", false),
            ("[abc]", "b", true),
            ("[!abc]", "b", false),
            ("[!abc]", "d", true),
            ("[a-c]x", "bx", true),
            ("[c-a]", "b", false),
            ("[!c-a]", "b", true),
            ("[]]", "]", true),
            ("[!]]", "]", false),
            ("[!]", "[!]", true),
            ("[", "[", true),
            ("[a", "[a", true),
            ("[]", "[]", true),
            ("[a-]", "-", true),
            ("[-a]", "-", true),
            ("[a-c-e]", "-", true),
            ("[a-c-e]", "d", false),
            ("[^a]", "^", true),
            ("[^a]", "b", false),
            ("[\\]", "\\", true),
            ("[!-a]", "-", false),
            ("[!-a]", "b", true),
            ("[--0]", "/", true),
            ("a.b", "axb", false),
        ];
        for (pattern, name, expected) in table {
            assert_eq!(
                Wildcard::new(pattern).matches(name),
                expected,
                "{pattern} {name:?}"
            );
        }
    }

    #[test]
    fn split_like_python() {
        let table = [
            ("a/b", ("a", "b")),
            ("b", ("", "b")),
            ("/b", ("/", "b")),
            ("a//b", ("a", "b")),
            ("//b", ("//", "b")),
            ("a/", ("a", "")),
            ("/", ("/", "")),
        ];
        for (path, expected) in table {
            assert_eq!(split(path), expected, "{path}");
        }
    }

    /// Against the stored answers of CPython (`tests/oracle/glob_cases.py` writes them). Other systems
    /// cannot hold all of these names.
    #[cfg(target_os = "linux")]
    #[test]
    fn all_cases_of_the_oracle() {
        let oracle: serde_json::Value =
            serde_json::from_str(include_str!("../../tests/oracle/glob_cases.json")).unwrap();
        let tree = Tree::new();
        // Nothing but the tree must be seen through `..`.
        let root = "one/two/three/four/five/six/root";
        for file in oracle["files"].as_array().unwrap() {
            match file.as_str().unwrap() {
                folder if folder.ends_with('/') => {
                    std::fs::create_dir_all(tree.path(root).join(folder)).unwrap()
                }
                file => tree.write(&format!("{root}/{file}"), ""),
            }
        }
        let mut wrong = Vec::new();
        for case in oracle["cases"].as_array().unwrap() {
            let pattern = case[0].as_str().unwrap();
            let found = tree
                .vfs()
                .glob(pattern, &tree.path(root), &mut 10_000)
                .unwrap();
            let found: Vec<&str> = found.iter().filter_map(|path| path.to_str()).collect();
            let expected: Vec<&str> = case[1]
                .as_array()
                .unwrap()
                .iter()
                .filter_map(|path| path.as_str())
                .collect();
            if found != expected {
                wrong.push(format!(
                    "{pattern:?}\n  expected {expected:?}\n  found    {found:?}"
                ));
            }
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
        let absolute = tree.path(root).join("s*/c.x");
        let found = tree
            .vfs()
            .glob(absolute.to_str().unwrap(), tree.root(), &mut 10_000);
        assert_eq!(found.unwrap(), [tree.path(root).join("sub/c.x")]);
    }
}
