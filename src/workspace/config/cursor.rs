//! Where in the text of a configuration file somebody types, as far as an unfinished text tells.

use toml_parser::Source;
use toml_parser::lexer::{Token, TokenKind};
use toml_parser::parser::{Event, EventKind, RecursionGuard, parse_document};

use base::TextRange;

/// Nesting depth of lists and tables in a text.
const DEPTH: u32 = 100;

/// A place where a key or a value may stand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConfigCursor {
    /// The keys that lead there. Lists have none.
    pub path: Vec<String>,
    /// What stands there.
    pub kind: ConfigCursorKind,
    /// The word there, without quotes.
    pub range: TextRange,
    /// The quote in front of the word.
    pub quote: Option<char>,
    /// The `file` of the entry of `roots` around the place.
    pub file: Option<String>,
}

/// What stands at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConfigCursorKind {
    /// The key of an entry.
    Key,
    /// A key in the header of a table.
    Header {
        /// Whether two brackets are open.
        is_list: bool,
    },
    /// A value.
    Value {
        /// Whether a list is open.
        in_list: bool,
    },
}

/// The place at an offset of a text; none in comments, in numbers, and where neither a key nor a value may begin.
pub fn place_at(text: &str, offset: u32) -> Option<ConfigCursor> {
    let before = text.get(..offset as usize)?;
    let (start, quote) = word(before)?;
    let lead = quote.map_or(0, char::len_utf8);
    let after = text.get(offset as usize..)?;
    let end = before.len() + rest(after, quote);
    let head = before.get(..start)?;
    let mut reader = TomlReader::read(head);
    let (path, kind) = reader.place()?;
    let mut file = reader
        .files
        .pop()
        .filter(|_| path.first().is_some_and(|first| first == "roots"))
        .flatten();
    if file.is_none() && reader.header == ["roots"] {
        file = file_below(after);
    }
    let range = TextRange::new((start + lead) as u32, end as u32);
    Some(ConfigCursor {
        path,
        kind,
        range,
        quote,
        file,
    })
}

/// Where the word at the end of a text begins, and the quote that it begins with.
fn word(before: &str) -> Option<(usize, Option<char>)> {
    let tokens = Source::new(before).lex().into_vec();
    let last = tokens
        .iter()
        .rev()
        .find(|token| token.kind() != TokenKind::Eof);
    let Some(last) = last else {
        return Some((before.len(), None));
    };
    let (start, end) = (last.span().start(), last.span().end());
    let quote = match last.kind() {
        TokenKind::BasicString => '"',
        TokenKind::LiteralString => '\'',
        TokenKind::Comment | TokenKind::MlBasicString | TokenKind::MlLiteralString => return None,
        TokenKind::Atom => return Some((start, None)),
        _ => return Some((before.len(), None)),
    };
    let is_open = end - start < 2 || !before.ends_with(quote);
    is_open.then_some((start, Some(quote)))
}

/// How much of a text still belongs to the word in front of it.
fn rest(after: &str, quote: Option<char>) -> usize {
    let line = after.lines().next().unwrap_or("");
    match quote {
        Some(quote) => line.find(quote).unwrap_or(0),
        None => line.find(|c: char| !is_bare(c)).unwrap_or(line.len()),
    }
}

/// Whether a character may stand in a key without quotes.
pub fn is_bare(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '-')
}

/// The `file` of a table in the lines below a place in it.
fn file_below(after: &str) -> Option<String> {
    let lines = after.get(after.find('\n')?..)?;
    let end = lines.find("\n[").unwrap_or(lines.len());
    let mut reader = TomlReader {
        header: vec!["roots".to_owned()],
        files: vec![None],
        ..TomlReader::new(lines.get(..end)?)
    };
    reader.run();
    reader.files.pop().flatten()
}

/// A table or list that is open.
#[derive(Default)]
struct OpenTable {
    keys: Vec<String>,
    is_list: bool,
    in_value: bool,
    /// Whether a value was read that no separator follows yet.
    is_done: bool,
}

/// Follows the events of a text to its end.
struct TomlReader<'t> {
    text: &'t str,
    header: Vec<String>,
    open_header: Option<bool>,
    levels: Vec<OpenTable>,
    /// The `file` of each entry of `roots`.
    files: Vec<Option<String>>,
}

impl<'t> TomlReader<'t> {
    fn new(text: &'t str) -> Self {
        let levels = vec![OpenTable::default()];
        Self {
            text,
            header: Vec::new(),
            open_header: None,
            levels,
            files: Vec::new(),
        }
    }

    fn read(text: &'t str) -> Self {
        let mut reader = Self::new(text);
        reader.run();
        reader
    }

    fn run(&mut self) {
        let tokens: Vec<Token> = Source::new(self.text).lex().into_vec();
        let mut events: Vec<Event> = Vec::new();
        parse_document(
            &tokens,
            &mut RecursionGuard::new(&mut events, DEPTH),
            &mut (),
        );
        for event in &events {
            self.follow(event);
        }
    }

    fn follow(&mut self, event: &Event) {
        // what the text lacks is still to be typed
        let is_open = matches!(
            event.kind(),
            EventKind::InlineTableOpen
                | EventKind::ArrayOpen
                | EventKind::StdTableOpen
                | EventKind::ArrayTableOpen
        );
        if event.span().is_empty() && !is_open {
            return;
        }
        match event.kind() {
            EventKind::StdTableOpen => self.header_opens(false),
            EventKind::ArrayTableOpen => self.header_opens(true),
            EventKind::StdTableClose | EventKind::ArrayTableClose => self.header_closes(),
            EventKind::InlineTableOpen => {
                if self.path() == ["roots"] {
                    self.files.push(None);
                }
                self.levels.push(OpenTable::default());
            }
            EventKind::ArrayOpen => {
                self.levels.push(OpenTable {
                    is_list: true,
                    in_value: true,
                    ..OpenTable::default()
                });
            }
            EventKind::InlineTableClose | EventKind::ArrayClose if self.levels.len() > 1 => {
                self.levels.pop();
                self.value_ends();
            }
            EventKind::SimpleKey => self.key(event),
            EventKind::KeyValSep => self.level().in_value = true,
            EventKind::Scalar => self.scalar(event),
            EventKind::ValueSep => self.entry_ends(),
            EventKind::Newline if self.levels.len() == 1 => self.entry_ends(),
            _ => {}
        }
    }

    fn level(&mut self) -> &mut OpenTable {
        if self.levels.is_empty() {
            self.levels.push(OpenTable::default());
        }
        let last = self.levels.len() - 1;
        #[allow(clippy::indexing_slicing, reason = "there is one")]
        &mut self.levels[last]
    }

    fn header_opens(&mut self, is_list: bool) {
        self.levels = vec![OpenTable::default()];
        self.header.clear();
        self.open_header = Some(is_list);
    }

    fn header_closes(&mut self) {
        if self.open_header.take() == Some(true) && self.header == ["roots"] {
            self.files.push(None);
        }
        self.level().is_done = true;
    }

    fn key(&mut self, event: &Event) {
        let text = self.raw(event);
        match self.open_header {
            Some(_) => self.header.push(text),
            None => self.level().keys.push(text),
        }
    }

    fn scalar(&mut self, event: &Event) {
        if self.path() == ["roots", "file"] {
            let text = self.raw(event);
            if let Some(file) = self.files.last_mut() {
                *file = Some(text);
            }
        }
        self.value_ends();
    }

    fn value_ends(&mut self) {
        self.level().is_done = true;
    }

    fn entry_ends(&mut self) {
        // a header that was not closed is none
        self.open_header = None;
        let level = self.level();
        level.is_done = false;
        if !level.is_list {
            level.in_value = false;
            level.keys.clear();
        }
    }

    /// The text of a key or string.
    fn raw(&self, event: &Event) -> String {
        let source = Source::new(self.text);
        let mut decoded = std::borrow::Cow::Borrowed("");
        if let Some(raw) = source.get(event) {
            match event.kind() {
                EventKind::SimpleKey => raw.decode_key(&mut decoded, &mut ()),
                _ => drop(raw.decode_scalar(&mut decoded, &mut ())),
            }
        }
        decoded.into_owned()
    }

    fn path(&self) -> Vec<String> {
        let keys = self.levels.iter().flat_map(|level| &level.keys);
        self.header.iter().chain(keys).cloned().collect()
    }

    fn place(&mut self) -> Option<(Vec<String>, ConfigCursorKind)> {
        let path = self.path();
        if let Some(is_list) = self.open_header {
            return Some((path, ConfigCursorKind::Header { is_list }));
        }
        let level = self.level();
        if level.is_done {
            return None;
        }
        let in_list = level.is_list;
        Some((
            path,
            if level.in_value {
                ConfigCursorKind::Value { in_list }
            } else {
                ConfigCursorKind::Key
            },
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::{ConfigCursorKind, place_at};

    /// The place at `|`, in short.
    fn place(text: &str) -> String {
        let offset = text.find('|').unwrap();
        let Some(place) = place_at(&text.replace('|', ""), offset as u32) else {
            return "none".to_owned();
        };
        let kind = match place.kind {
            ConfigCursorKind::Key => "key",
            ConfigCursorKind::Header { is_list: false } => "table",
            ConfigCursorKind::Header { is_list: true } => "list of tables",
            ConfigCursorKind::Value { in_list: false } => "value",
            ConfigCursorKind::Value { in_list: true } => "item",
        };
        let text = text.replace('|', "");
        let word = match place.range.slice(&text) {
            "" => String::new(),
            word => format!(" {word}"),
        };
        let file = place
            .file
            .map(|file| format!(" of {file}"))
            .unwrap_or_default();
        format!("{kind} `{}`{word}{file}", place.path.join("."))
    }

    #[test]
    fn places_of_keys() {
        for (text, expected) in [
            ("|", "key ``"),
            ("ta|", "key `` ta"),
            ("target = 'ros1'\nsel|ect = []", "key `` select"),
            ("format.|", "key `format`"),
            ("[form|", "table `` form"),
            ("[|]\n", "table ``"),
            ("[[ro|", "list of tables `` ro"),
            ("[[roots.|]]", "list of tables `roots`"),
            ("[format]\nline|", "key `format` line"),
            ("[format] li|", "none"),
            ("[[roots]]\nfile = 'a'\nargs = { |", "key `roots.args` of a"),
            (
                "[[roots]]\nfile = 'a'\nargs = { x = '1', si|",
                "key `roots.args` si of a",
            ),
            (
                "[[roots]]\nfile = 'a'\nargs = { x = [1, 2], \"si|\"",
                "key `roots.args` si of a",
            ),
            (
                "[[roots]]\nargs = { si| }\nfile = 'b'\n[[roots]]\nfile = 'c'",
                "key `roots.args` si of b",
            ),
            (
                "[[roots]]\nargs.s|\nfile = 'b'\n",
                "key `roots.args` s of b",
            ),
            (
                "[[roots]]\nfile = 'a'\n[roots.presets.left]\n|",
                "key `roots.presets.left` of a",
            ),
            (
                "[[roots]]\nfile = 'a'\n[[roots.expect]]\nwhen = { |",
                "key `roots.expect.when` of a",
            ),
            (
                "roots = [{ file = 'a' }, { file = 'b', exclude = [{ | }] }]",
                "key `roots.exclude` of b",
            ),
            ("[[roots]]\nfile = 'a'\n[format]\n|", "key `format`"),
            ("a = 1 |", "none"),
            ("# |", "none"),
        ] {
            assert_eq!(place(text), expected, "{text}");
        }
    }

    #[test]
    fn places_of_values() {
        for (text, expected) in [
            ("target = |", "value `target`"),
            ("target = \"ro|s2\"\n", "value `target` ros2"),
            ("target = \"ros2\"|", "none"),
            ("select = [\"a\", |", "item `select`"),
            ("select = ['a'|, 'b']", "none"),
            ("[[roots]]\nfile = 'urdf/|'", "value `roots.file` urdf/"),
            (
                "[[roots]]\nfile = 'a'\nargs = { side = \"l|",
                "value `roots.args.side` l of a",
            ),
            (
                "[[roots]]\nfile = 'a'\nargs = { side = [\"left\", \"|",
                "item `roots.args.side` of a",
            ),
            (
                "[[roots]]\nfile = 'a'\nargs.side = |\n",
                "value `roots.args.side` of a",
            ),
            ("a = '''|", "none"),
        ] {
            assert_eq!(place(text), expected, "{text}");
        }
    }

    #[test]
    fn deep_and_broken_texts() {
        for text in [
            "[".repeat(5000),
            "a = [".repeat(2000),
            "{ a = ".repeat(2000),
            "a = { b = [".repeat(900),
        ] {
            place_at(&text, text.len() as u32);
        }
        assert_eq!(place_at("ä", 1), None);
    }
}
