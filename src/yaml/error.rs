//! Errors in the words of PyYAML.

use std::fmt;

use super::reader::{Mark, is_break_or_end};
use base::TextRange;

/// A text that cannot be loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct YamlError {
    /// What Python's `str(error)` gives; several lines, with places.
    pub message: String,
    /// The part of the text to blame.
    pub range: TextRange,
    /// The same in one line, without place.
    pub short: String,
}

impl fmt::Display for YamlError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for YamlError {}

/// An error on its way out.
#[derive(Clone, Debug)]
pub(super) enum RawError {
    /// A character that is not allowed anywhere.
    Character {
        c: char,
        index: usize,
        offset: usize,
    },
    /// An error with places.
    Marked(Box<Marked>),
    /// An exception of Python, raised while a value was made.
    Python { message: String, range: TextRange },
}

/// What was being done where, and what went wrong where.
#[derive(Clone, Debug)]
pub(super) struct Marked {
    context: Option<(String, Option<Mark>)>,
    problem: String,
    at: Mark,
    /// What to underline, when it is not the character at the problem.
    range: Option<TextRange>,
}

impl RawError {
    /// A problem at a place.
    pub(super) fn new(problem: impl Into<String>, at: Mark) -> Self {
        Self::Marked(Box::new(Marked {
            context: None,
            problem: problem.into(),
            at,
            range: None,
        }))
    }

    /// A problem at a place while doing something that began elsewhere.
    pub(super) fn within(context: &str, began: Mark, problem: impl Into<String>, at: Mark) -> Self {
        Self::Marked(Box::new(Marked {
            context: Some((context.to_owned(), Some(began))),
            problem: problem.into(),
            at,
            range: None,
        }))
    }

    /// The same with a place for the problem only.
    pub(super) fn during(context: &str, problem: impl Into<String>, at: Mark) -> Self {
        let context = Some((context.to_owned(), None));
        Self::Marked(Box::new(Marked {
            context,
            problem: problem.into(),
            at,
            range: None,
        }))
    }

    /// The same failure, with `range` as the part to blame.
    pub(super) fn blaming(mut self, range: TextRange) -> Self {
        if let Self::Marked(marked) = &mut self {
            marked.range = Some(range);
        }
        self
    }

    /// The error of file `name` with text `text`.
    pub(super) fn finish(self, text: &str, name: &str) -> YamlError {
        match self {
            Self::Character { c, index, offset } => {
                let problem = format!(
                    "unacceptable character #x{:04x}: special characters are not allowed",
                    c as u32
                );
                let start = offset as u32;
                YamlError {
                    message: format!("{problem}\n  in \"{name}\", position {index}"),
                    range: TextRange::new(start, start + c.len_utf8() as u32),
                    short: problem,
                }
            }
            Self::Python { message, range } => YamlError {
                short: message.clone(),
                message,
                range,
            },
            Self::Marked(marked) => marked.finish(text, name),
        }
    }
}

impl Marked {
    fn finish(self, text: &str, name: &str) -> YamlError {
        let place = |mark: Mark| {
            format!(
                "  in \"{name}\", line {}, column {}",
                mark.line + 1,
                mark.column + 1
            )
        };
        let mut lines = Vec::new();
        let mut short = self.problem.clone();
        if let Some((context, began)) = self.context {
            short = format!("{context}: {short}");
            lines.push(context);
            let elsewhere =
                began.filter(|began| (began.line, began.column) != (self.at.line, self.at.column));
            lines.extend(elsewhere.map(place));
        }
        lines.push(self.problem);
        lines.push(place(self.at));
        let range = self.range.unwrap_or_else(|| one_character(text, self.at));
        YamlError {
            message: lines.join("\n"),
            range,
            short,
        }
    }
}

/// The character at a mark; nothing at the end of a line.
fn one_character(text: &str, at: Mark) -> TextRange {
    let c = text
        .get(at.offset as usize..)
        .and_then(|rest| rest.chars().next());
    let length = c.filter(|&c| !is_break_or_end(c)).map_or(0, char::len_utf8);
    TextRange::new(at.offset, at.offset + length as u32)
}

/// Python's `repr` of a text.
pub(super) fn repr(text: &str) -> String {
    let quote = if text.contains('\'') && !text.contains('"') {
        '"'
    } else {
        '\''
    };
    let mut out = String::from(quote);
    for c in text.chars() {
        match c {
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            '\\' => out.push_str("\\\\"),
            c if c == quote => out.extend(['\\', c]),
            c if is_shown(c) => out.push(c),
            c => out.push_str(&match c as u32 {
                code @ 0..=0xFF => format!("\\x{code:02x}"),
                code @ 0x100..=0xFFFF => format!("\\u{code:04x}"),
                code => format!("\\U{code:08x}"),
            }),
        }
    }
    out.push(quote);
    out
}

/// Whether Python shows a character as it is: not a control, blank, format or private one.
fn is_shown(c: char) -> bool {
    let hidden = c.is_control()
        || c != ' ' && c.is_whitespace()
        || matches!(c, '\u{AD}' | '\u{600}'..='\u{605}' | '\u{61C}' | '\u{200B}'..='\u{200F}')
        || matches!(c, '\u{202A}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{E000}'..='\u{F8FF}')
        || matches!(c, '\u{FEFF}' | '\u{FFF0}'..='\u{FFFB}' | '\u{E0000}'..='\u{10FFFF}');
    !hidden
}
