//! The statements of a program in Python, as far as a launch file needs them: the rest is a text that is passed over.
//!
//! Lines are split and blocks nested here; what stands in a statement is left to the parser of expressions.

use base::TextRange;
use base::limits::LAUNCH_DEPTH;

/// A statement.
#[derive(Debug)]
pub(super) struct Statement {
    /// Where the line stands, without the block below it.
    pub(super) range: TextRange,
    /// Its first word, when this is a keyword of statements.
    pub(super) keyword: Option<PythonKeyword>,
    /// The statements below it.
    pub(super) body: Vec<Statement>,
}

/// The keywords that matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PythonKeyword {
    Def,
    Class,
    If,
    Elif,
    Else,
    Loop,
    Try,
    Except,
    Finally,
    With,
    Return,
    Leave,
    Import,
    From,
    Global,
    Other,
}

const KEYWORDS: [(&str, PythonKeyword); 24] = [
    ("def", PythonKeyword::Def),
    ("async", PythonKeyword::Other),
    ("class", PythonKeyword::Class),
    ("if", PythonKeyword::If),
    ("elif", PythonKeyword::Elif),
    ("else", PythonKeyword::Else),
    ("for", PythonKeyword::Loop),
    ("while", PythonKeyword::Loop),
    ("try", PythonKeyword::Try),
    ("except", PythonKeyword::Except),
    ("finally", PythonKeyword::Finally),
    ("with", PythonKeyword::With),
    ("return", PythonKeyword::Return),
    ("raise", PythonKeyword::Leave),
    ("break", PythonKeyword::Leave),
    ("continue", PythonKeyword::Leave),
    ("import", PythonKeyword::Import),
    ("from", PythonKeyword::From),
    ("global", PythonKeyword::Global),
    ("nonlocal", PythonKeyword::Global),
    ("del", PythonKeyword::Global),
    ("assert", PythonKeyword::Other),
    ("pass", PythonKeyword::Other),
    ("match", PythonKeyword::Other),
];

/// A line of the program, with its bytes, its indentation, and the colon that ends the head of a block.
struct Line {
    range: TextRange,
    indent: usize,
    colon: Option<usize>,
}

/// The statements of a text.
pub(super) fn statements(text: &str) -> Vec<Statement> {
    let lines = lines(text);
    let mut top: Vec<Statement> = Vec::new();
    // open blocks: the indentation of their heads
    let mut open: Vec<(usize, Statement)> = Vec::new();
    for line in lines {
        while open
            .last()
            .is_some_and(|(indent, _)| *indent >= line.indent)
        {
            close(&mut open, &mut top);
        }
        let (statement, is_head) = statement(text, &line);
        if is_head && open.len() < LAUNCH_DEPTH {
            open.push((line.indent, statement));
        } else {
            siblings(&mut open, &mut top).push(statement);
        }
    }
    while !open.is_empty() {
        close(&mut open, &mut top);
    }
    top
}

fn siblings<'s>(
    open: &'s mut [(usize, Statement)],
    top: &'s mut Vec<Statement>,
) -> &'s mut Vec<Statement> {
    match open.last_mut() {
        Some((_, parent)) => &mut parent.body,
        None => top,
    }
}

fn close(open: &mut Vec<(usize, Statement)>, top: &mut Vec<Statement>) {
    if let Some((_, done)) = open.pop() {
        siblings(open, top).push(done);
    }
}

/// The statement of a line, and whether a block follows; `if x: y` holds its block itself.
fn statement(text: &str, line: &Line) -> (Statement, bool) {
    let code = line.range.slice(text);
    let word = code
        .split(|c: char| !(c.is_alphanumeric() || c == '_'))
        .next()
        .unwrap_or("");
    let mut keyword = KEYWORDS
        .iter()
        .find(|(known, _)| *known == word)
        .map(|(_, keyword)| *keyword);
    if word == "match" && (line.colon.is_none() || !code.trim_end().ends_with(':')) {
        keyword = None;
    }
    let mut range = line.range;
    if word == "async" {
        let rest = code.get(word.len()..).unwrap_or("");
        range.start = range.end - rest.trim_start().len() as u32;
        let inner = Line {
            range,
            indent: line.indent,
            colon: line.colon,
        };
        return if rest.trim().is_empty() {
            (plain(range, keyword), false)
        } else {
            statement(text, &inner)
        };
    }
    let takes_block = matches!(
        keyword,
        Some(
            PythonKeyword::Def
                | PythonKeyword::Class
                | PythonKeyword::If
                | PythonKeyword::Elif
                | PythonKeyword::Else
                | PythonKeyword::Loop
                | PythonKeyword::Try
                | PythonKeyword::Except
                | PythonKeyword::Finally
                | PythonKeyword::With
                | PythonKeyword::Other
        )
    );
    let Some(colon) = line.colon.filter(|_| takes_block) else {
        return (plain(range, keyword), false);
    };
    let head = TextRange::new(range.start, colon as u32);
    let behind = text.get(colon + 1..range.end as usize).unwrap_or("");
    let mut made = plain(head, keyword);
    if behind.trim().is_empty() || behind.trim_start().starts_with('#') {
        return (made, true);
    }
    let start = range.end - behind.trim_start().len() as u32;
    let inner = TextRange::new(start, range.end);
    let code = inner.slice(text);
    let word = code
        .split(|c: char| !(c.is_alphanumeric() || c == '_'))
        .next()
        .unwrap_or("");
    let keyword = KEYWORDS
        .iter()
        .find(|(known, _)| *known == word)
        .map(|(_, keyword)| *keyword);
    made.body.push(plain(inner, keyword));
    (made, false)
}

fn plain(range: TextRange, keyword: Option<PythonKeyword>) -> Statement {
    Statement {
        range,
        keyword,
        body: Vec::new(),
    }
}

/// The lines of a program: what brackets, strings and backslashes hold together is one.
fn lines(text: &str) -> Vec<Line> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let indent_start = at;
        while matches!(bytes.get(at), Some(b' ' | b'\t' | 0x0c)) {
            at += 1;
        }
        let mut scan = LineScanner {
            bytes,
            at,
            depth: 0,
            lambdas: 0,
            colon: None,
        };
        let indent = at - indent_start;
        loop {
            let start = scan.at;
            scan.colon = None;
            let more = scan.line();
            let range = TextRange::new(start as u32, scan.code_end(start) as u32);
            let lead = range.slice(text).len() - range.slice(text).trim_start().len();
            let range = TextRange::new(range.start + lead as u32, range.end);
            if !range.is_empty() && !range.slice(text).starts_with('#') {
                found.push(Line {
                    range,
                    indent,
                    colon: scan.colon,
                });
            }
            if !more {
                break;
            }
        }
        at = scan.at;
    }
    found
}

/// A walk over the bytes of one line.
struct LineScanner<'t> {
    bytes: &'t [u8],
    at: usize,
    depth: usize,
    lambdas: usize,
    colon: Option<usize>,
}

impl LineScanner<'_> {
    /// Go to the end of the line, or behind the `;` that ends a statement; whether it was one.
    fn line(&mut self) -> bool {
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b'#' => self.comment(),
                b'\n' if self.depth == 0 => {
                    self.at += 1;
                    return false;
                }
                b'\\' => {
                    self.at += if self.bytes.get(self.at + 1) == Some(&b'\r') {
                        3
                    } else {
                        2
                    }
                }
                b'"' | b'\'' => self.at = string_end(self.bytes, self.at),
                b'a'..=b'z' | b'A'..=b'Z' | b'_' | 0x80.. => self.word(),
                b';' if self.depth == 0 => {
                    self.at += 1;
                    return true;
                }
                _ => self.sign(byte),
            }
        }
        self.at = self.at.min(self.bytes.len());
        false
    }

    fn sign(&mut self, byte: u8) {
        match byte {
            b'(' | b'[' | b'{' => self.depth += 1,
            b')' | b']' | b'}' => self.depth = self.depth.saturating_sub(1),
            b':' if self.depth == 0 && self.bytes.get(self.at + 1) != Some(&b'=') => {
                match self.lambdas.checked_sub(1) {
                    Some(left) => self.lambdas = left,
                    None => self.colon = self.colon.or(Some(self.at)),
                }
            }
            _ => {}
        }
        self.at += 1;
    }

    fn word(&mut self) {
        let start = self.at;
        while self
            .bytes
            .get(self.at)
            .is_some_and(|b| b.is_ascii_alphanumeric() || *b == b'_' || *b >= 0x80)
        {
            self.at += 1;
        }
        if self.depth == 0 && self.bytes.get(start..self.at) == Some(b"lambda") {
            self.lambdas += 1;
        }
    }

    fn comment(&mut self) {
        while self.bytes.get(self.at).is_some_and(|byte| *byte != b'\n') {
            self.at += 1;
        }
    }

    /// The end of the code that starts at `start`: without the line end, `;` and white space behind it.
    fn code_end(&self, start: usize) -> usize {
        let mut end = self.at;
        while end > start
            && self
                .bytes
                .get(end - 1)
                .is_some_and(|b| b.is_ascii_whitespace() || *b == b';')
        {
            end -= 1;
        }
        end
    }
}

/// The offset behind the string that starts at `at`; one that is not closed ends with its line, a triple one with the text.
fn string_end(bytes: &[u8], at: usize) -> usize {
    let quote = bytes.get(at).copied().unwrap_or(b'"');
    let is_triple = bytes.get(at + 1) == Some(&quote) && bytes.get(at + 2) == Some(&quote);
    let mut at = at + if is_triple { 3 } else { 1 };
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\\' => at += 1,
            b'\n' if !is_triple => return at,
            _ if byte != quote => {}
            _ if !is_triple => return at + 1,
            _ if bytes.get(at + 1) == Some(&quote) && bytes.get(at + 2) == Some(&quote) => {
                return at + 3;
            }
            _ => {}
        }
        at += 1;
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::{Statement, statements};

    fn shown(text: &str, statements: &[Statement]) -> String {
        let one = |s: &Statement| {
            let body = if s.body.is_empty() {
                String::new()
            } else {
                format!("{{{}}}", shown(text, &s.body))
            };
            format!("<{}>{body}", s.range.slice(text))
        };
        statements.iter().map(one).collect()
    }

    #[test]
    fn lines_and_blocks() {
        for (text, expected) in [
            ("a = 1\nb = 2\n", "<a = 1><b = 2>"),
            ("a = 1; b = 2", "<a = 1><b = 2>"),
            ("f(\n  1,\n  2)\nb", "<f(\n  1,\n  2)><b>"),
            ("def f(a):\n  x = 1\n\n  y\nz", "<def f(a)>{<x = 1><y>}<z>"),
            ("if a: b = 1\nelse:\n  c", "<if a>{<b = 1>}<else>{<c>}"),
            (
                "a = ':' # x:\nb = \"\"\"\nx: (\n\"\"\"\nc",
                "<a = ':' # x:><b = \"\"\"\nx: (\n\"\"\"><c>",
            ),
            ("a = 1 + \\\n  2\nb", "<a = 1 + \\\n  2><b>"),
            ("f = lambda x: x\ng", "<f = lambda x: x><g>"),
            ("async def f():\n  x", "<def f()>{<x>}"),
            ("x = (1\ny = 2", "<x = (1\ny = 2>"),
            ("'open\nb", "<'open><b>"),
        ] {
            assert_eq!(shown(text, &statements(text)), expected, "{text}");
        }
    }
}
