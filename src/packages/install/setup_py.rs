//! What the `data_files` of a `setup.py` install. The file is read, never run: tuples of a destination and a list of
//! files count where both can be worked out from the text.

use std::cell::Cell;
use std::path::Path;

use super::{Build, InstallSource, tidy};
use base::FastMap;
use base::limits::{BUILD_BYTES, BUILD_DEPTH};
use vfs::Vfs;

/// Name of the build files of Python.
pub(super) const SETUP_PY: &str = "setup.py";

/// Read the build file of a folder into `build`.
pub(super) fn read(vfs: &Vfs, folder: &Path, build: &mut Build) {
    let path = folder.join(SETUP_PY);
    build.files.push(path.clone());
    let Ok(file) = vfs.text(&path) else { return };
    let (found, is_all) = data_files(&file.text);
    let walks = ["walk(", "rglob", "**", "listdir", "for "]
        .iter()
        .any(|word| file.text.contains(word));
    build.is_opaque |= walks || !is_all;
    for (destination, files) in found {
        for file in files {
            let path = tidy(&folder.join(&file));
            let to = tidy(Path::new(&destination));
            if vfs::has_magic(&file) {
                build.add(to, InstallSource::Files(path));
            } else if let Some(name) = path.file_name() {
                build.add(to.join(name), InstallSource::Path(path.clone()));
            }
        }
    }
}

/// Destinations below `share` with their files, and whether these are all; names of files may be patterns.
fn data_files(text: &str) -> (Vec<(String, Vec<String>)>, bool) {
    let tokens = tokens(text);
    let mut names: FastMap<&str, SetupPyValue> = FastMap::default();
    let mut found = Vec::new();
    let (mut is_all, left) = (true, Cell::new(BUILD_BYTES as usize));
    for at in 0..tokens.len() {
        let mut reader = SetupPyReader {
            tokens: &tokens,
            at,
            names: &names,
            left: &left,
            depth: 0,
        };
        match (tokens.get(at), tokens.get(at + 1)) {
            (Some(SetupPyToken::Name(name)), Some(SetupPyToken::Sign('='))) => {
                reader.at += 2;
                if let Some(value) = reader.value() {
                    names.insert(name, value);
                }
            }
            (Some(SetupPyToken::Sign('(' | '[')), _) => {
                reader.at += 1;
                let Some(SetupPyValue::Text(to)) = reader.value().filter(|_| !reader.is_at(')'))
                else {
                    continue;
                };
                if !(to.starts_with("share/") && reader.skip(',')) {
                    continue;
                }
                match reader.value() {
                    Some(SetupPyValue::List(files)) => found.push((to, files)),
                    _ => is_all = false,
                }
            }
            _ => {}
        }
    }
    (found, is_all)
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum SetupPyToken<'t> {
    Name(&'t str),
    Text(String),
    Sign(char),
}

/// A value that the text gives.
#[derive(Clone, Debug)]
enum SetupPyValue {
    Text(String),
    List(Vec<String>),
}

fn tokens(text: &str) -> Vec<SetupPyToken<'_>> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let behind = rest.get(first.len_utf8()..).unwrap_or_default();
        if first == '#' {
            rest = behind
                .get(behind.find('\n').unwrap_or(behind.len())..)
                .unwrap_or_default();
        } else if first == '\'' || first == '"' {
            let quote = if rest.starts_with("'''") || rest.starts_with("\"\"\"") {
                3
            } else {
                1
            };
            let (mark, body) = rest.split_at(quote);
            let (inner, after) = body.split_once(mark).unwrap_or((body, ""));
            found.push(SetupPyToken::Text(inner.to_owned()));
            rest = after;
        } else if first.is_alphanumeric() || first == '_' {
            let end = rest
                .find(|c: char| !c.is_alphanumeric() && c != '_')
                .unwrap_or(rest.len());
            let (name, after) = rest.split_at(end);
            found.push(SetupPyToken::Name(name));
            rest = after;
        } else {
            found.extend((!first.is_whitespace()).then_some(SetupPyToken::Sign(first)));
            rest = behind;
        }
    }
    found
}

struct SetupPyReader<'r, 't> {
    tokens: &'r [SetupPyToken<'t>],
    at: usize,
    names: &'r FastMap<&'t str, SetupPyValue>,
    /// How much more is put together, in bytes.
    left: &'r Cell<usize>,
    depth: u32,
}

impl<'t> SetupPyReader<'_, 't> {
    fn is_at(&self, sign: char) -> bool {
        self.tokens.get(self.at) == Some(&SetupPyToken::Sign(sign))
    }

    fn skip(&mut self, sign: char) -> bool {
        let is_at = self.is_at(sign);
        self.at += usize::from(is_at);
        is_at
    }

    /// Values joined by `+`.
    fn value(&mut self) -> Option<SetupPyValue> {
        let mut value = self.part()?;
        while self.skip('+') {
            value = match (value, self.part()?) {
                (SetupPyValue::Text(a), SetupPyValue::Text(b)) => SetupPyValue::Text(a + &b),
                (SetupPyValue::List(a), SetupPyValue::List(b)) => {
                    SetupPyValue::List([a, b].concat())
                }
                _ => return None,
            };
        }
        let size = match &value {
            SetupPyValue::Text(text) => text.len(),
            SetupPyValue::List(items) => items.iter().map(String::len).sum::<usize>() + items.len(),
        };
        self.left.set(self.left.get().checked_sub(size)?);
        Some(value)
    }

    fn part(&mut self) -> Option<SetupPyValue> {
        let token = self.tokens.get(self.at)?;
        self.at += 1;
        match token {
            SetupPyToken::Text(text) => {
                let mut text = text.clone();
                while let Some(SetupPyToken::Text(more)) = self.tokens.get(self.at) {
                    text.push_str(more);
                    self.at += 1;
                }
                Some(SetupPyValue::Text(text))
            }
            SetupPyToken::Sign('[') => {
                let items = self.items(']')?;
                Some(SetupPyValue::List(items))
            }
            SetupPyToken::Name(name) => self.named(name),
            SetupPyToken::Sign(_) => None,
        }
    }

    /// A variable, a text with variables in it, or a call.
    fn named(&mut self, first: &'t str) -> Option<SetupPyValue> {
        if let (true, Some(SetupPyToken::Text(text))) =
            (first.eq_ignore_ascii_case("f"), self.tokens.get(self.at))
        {
            self.at += 1;
            return self.formatted(text).map(SetupPyValue::Text);
        }
        let mut name = first;
        while self.is_at('.') {
            self.at += 1;
            let Some(SetupPyToken::Name(member)) = self.tokens.get(self.at) else {
                return None;
            };
            name = member;
            self.at += 1;
        }
        if !self.skip('(') {
            return self.names.get(name).cloned();
        }
        let mut arguments = self.items(')')?;
        match name {
            "join" => Some(SetupPyValue::Text(arguments.join("/"))),
            "glob" => {
                arguments.truncate(1);
                Some(SetupPyValue::List(arguments))
            }
            _ => None,
        }
    }

    /// The texts up to a closing sign; arguments by name are passed over.
    fn items(&mut self, close: char) -> Option<Vec<String>> {
        self.depth += 1;
        if self.depth > BUILD_DEPTH {
            return None;
        }
        let mut items = Vec::new();
        while !self.skip(close) {
            if let (Some(SetupPyToken::Name(_)), Some(SetupPyToken::Sign('='))) =
                (self.tokens.get(self.at), self.tokens.get(self.at + 1))
            {
                self.at += 3;
            } else {
                match self.value()? {
                    SetupPyValue::Text(text) => items.push(text),
                    SetupPyValue::List(_) => return None,
                }
            }
            if !self.skip(',') && !self.is_at(close) {
                return None;
            }
        }
        self.depth -= 1;
        Some(items)
    }

    fn formatted(&self, text: &str) -> Option<String> {
        let mut out = String::new();
        let mut rest = text;
        while let Some((before, behind)) = rest.split_once('{') {
            let (name, after) = behind.split_once('}')?;
            let SetupPyValue::Text(value) = self.names.get(name.trim())? else {
                return None;
            };
            out.push_str(before);
            out.push_str(value);
            rest = after;
        }
        out.push_str(rest);
        Some(out)
    }
}

#[cfg(test)]
mod tests {
    use super::data_files;

    #[test]
    fn destinations_and_files() {
        let table = [
            (
                "data_files=[('share/p', ['package.xml'])]",
                "share/p: package.xml",
            ),
            (
                "n = 'p'\nx=[(os.path.join('share', n, 'urdf'), glob('urdf/*'))]",
                "share/p/urdf: urdf/*",
            ),
            (
                "n = 'p'\nx=[('share/' + n + '/urdf', glob.glob('d/urdf/*.xacro'))]",
                "share/p/urdf: d/urdf/*.xacro",
            ),
            (
                "n = 'p'\nx.append((f'share/{n}/m', ['a.stl', 'b.stl']))",
                "share/p/m: a.stl b.stl",
            ),
            (
                "x=[('share/p/a', glob('a/*') + ['b/c']),]",
                "share/p/a: a/* b/c",
            ),
            (
                "x=[('share/p/a', glob(join('a', '*'), recursive=True))]",
                "share/p/a: a/*",
            ),
            (
                "x=[('share/' 'p', [\"package.xml\",])]",
                "share/p: package.xml",
            ),
            ("x=[('share/' + unknown, ['a'])]", ""),
            ("x=[('share/p', files())]", ""),
            ("x=[('lib/p', ['a'])]", ""),
            ("# x=[('share/p', ['a'])]", ""),
            ("x=[('share/p', ['a'", ""),
            ("x = '", ""),
        ];
        for (text, expected) in table {
            let found: Vec<String> = data_files(text)
                .0
                .iter()
                .map(|(to, files)| format!("{to}: {}", files.join(" ")))
                .collect();
            assert_eq!(found.join("; "), expected, "{text}");
        }
    }
}
