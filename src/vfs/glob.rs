//! Shell patterns with the exact meaning of Python's `glob.glob` (3.11, not recursive).

use std::path::{Path, PathBuf};

use super::Vfs;

/// The sorted matches of `pattern`; a relative one starts at `base`.
pub(super) fn glob(vfs: &Vfs, pattern: &str, base: &Path) -> Vec<PathBuf> {
    if pattern.is_empty() {
        return Vec::new();
    }
    let mut found = expand(vfs, pattern, base, false);
    found.sort();
    found.into_iter().map(PathBuf::from).collect()
}

/// Whether a text has any of the characters that make it a pattern.
pub fn has_magic(text: &str) -> bool {
    text.contains(['*', '?', '['])
}

fn expand(vfs: &Vfs, pattern: &str, base: &Path, only_dirs: bool) -> Vec<String> {
    let (folder, name) = split(pattern);
    if !has_magic(pattern) {
        let path = base.join(pattern);
        let there = if name.is_empty() { vfs.is_dir(&base.join(folder)) } else { exists(&path) };
        return if there { vec![pattern.to_owned()] } else { Vec::new() };
    }
    let folders = if !folder.is_empty() && folder != pattern && has_magic(folder) {
        expand(vfs, folder, base, true)
    } else {
        vec![folder.to_owned()]
    };
    let mut found = Vec::new();
    for folder in folders {
        let names = if has_magic(name) {
            matching_names(vfs, &base.join(&folder), name, only_dirs)
        } else {
            literal_name(vfs, &base.join(&folder), name)
        };
        found.extend(names.iter().map(|name| join(&folder, name)));
    }
    found
}

/// Folder and last component, as `os.path.split` cuts them.
fn split(path: &str) -> (&str, &str) {
    let cut = path.rfind('/').map_or(0, |slash| slash + 1);
    let (folder, name) = path.split_at(cut);
    let trimmed = folder.trim_end_matches('/');
    (if trimmed.is_empty() { folder } else { trimmed }, name)
}

fn join(folder: &str, name: &str) -> String {
    if folder.is_empty() || folder.ends_with('/') {
        format!("{folder}{name}")
    } else {
        format!("{folder}/{name}")
    }
}

/// Also true for a link that leads nowhere.
fn exists(path: &Path) -> bool {
    path.symlink_metadata().is_ok()
}

fn literal_name(vfs: &Vfs, folder: &Path, name: &str) -> Vec<String> {
    let there = if name.is_empty() { vfs.is_dir(folder) } else { exists(&folder.join(name)) };
    if there { vec![name.to_owned()] } else { Vec::new() }
}

fn matching_names(vfs: &Vfs, folder: &Path, pattern: &str, only_dirs: bool) -> Vec<String> {
    let wildcard = Wildcard::new(pattern);
    vfs.list_dir(folder)
        .into_iter()
        .filter(|entry| entry.is_dir || !only_dirs)
        .map(|entry| entry.name)
        .filter(|name| pattern.starts_with('.') || !name.starts_with('.'))
        .filter(|name| wildcard.matches(name))
        .collect()
}

/// A pattern for one name: `*`, `?`, `[abc]`, `[!abc]`, as Python's `fnmatch` reads them.
#[derive(Clone, Debug)]
pub struct Wildcard(Vec<Token>);

impl Wildcard {
    /// The pattern `text`; every text is one.
    pub fn new(text: &str) -> Self {
        Self(compile(text))
    }

    /// The only name that fits, where there is only one.
    pub fn literal(&self) -> Option<String> {
        let letter = |token: &Token| match token {
            Token::Literal(letter) => Some(*letter),
            _ => None,
        };
        self.0.iter().map(letter).collect()
    }

    /// Whether the whole of `name` fits.
    pub fn matches(&self, name: &str) -> bool {
        let name: Vec<char> = name.chars().collect();
        covers(&self.0, &name, |token| matches!(token, Token::Many), |token, c| token.takes(*c))
    }
}

/// One element of a pattern.
#[derive(Clone, Debug)]
enum Token {
    Literal(char),
    Any,
    Many,
    Class { negated: bool, ranges: Vec<(char, char)> },
}

fn compile(pattern: &str) -> Vec<Token> {
    let chars: Vec<char> = pattern.chars().collect();
    let mut tokens = Vec::new();
    let mut rest = chars.as_slice();
    while let Some((&first, behind)) = rest.split_first() {
        rest = behind;
        tokens.push(match first {
            '*' => Token::Many,
            '?' => Token::Any,
            '[' => match class(behind) {
                Some((token, behind)) => {
                    rest = behind;
                    token
                }
                None => Token::Literal('['),
            },
            other => Token::Literal(other),
        });
    }
    tokens
}

/// The class behind a `[`, and what follows its `]`; `None` when it is not closed.
fn class(text: &[char]) -> Option<(Token, &[char])> {
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
    Some((Token::Class { negated, ranges }, behind.get(1..)?))
}

impl Token {
    fn takes(&self, c: char) -> bool {
        match self {
            Token::Literal(literal) => *literal == c,
            Token::Any | Token::Many => true,
            Token::Class { negated, ranges } => {
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
            assert_eq!(Wildcard::new(pattern).matches(name), expected, "{pattern} {name:?}");
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
            let found = tree.vfs().glob(pattern, &tree.path(root));
            let found: Vec<&str> = found.iter().filter_map(|path| path.to_str()).collect();
            let expected: Vec<&str> =
                case[1].as_array().unwrap().iter().filter_map(|path| path.as_str()).collect();
            if found != expected {
                wrong.push(format!("{pattern:?}\n  expected {expected:?}\n  found    {found:?}"));
            }
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
        let absolute = tree.path(root).join("s*/c.x");
        let found = tree.vfs().glob(absolute.to_str().unwrap(), tree.root());
        assert_eq!(found, [tree.path(root).join("sub/c.x")]);
    }
}
