//! The commands in a `CMakeLists.txt`, by their text alone.

use base::TextRange;

/// A command: its name in small letters, and its arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct CMakeCommand {
    pub(super) name: String,
    pub(super) arguments: Vec<CMakeArgument>,
}

/// An argument before its variables are replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct CMakeArgument {
    pub(super) text: String,
    /// Whether it is one argument whatever its value: in quotes or brackets.
    pub(super) is_quoted: bool,
    /// Where it stands in the file, with its quotes or brackets.
    pub(super) range: TextRange,
}

/// The commands of a file in order. What is no command is passed over.
pub(super) fn commands(text: &str) -> Vec<CMakeCommand> {
    let mut reader = CommandReader { text, rest: text };
    let mut found = Vec::new();
    while !reader.rest.is_empty() {
        reader.skip_blanks();
        let name = reader.take(|c| c.is_alphanumeric() || c == '_');
        if name.is_empty() {
            reader.skip_char();
            continue;
        }
        reader.skip_blanks();
        if reader.rest.starts_with('(') {
            reader.skip_char();
            let arguments = reader.arguments();
            found.push(CMakeCommand {
                name: name.to_lowercase(),
                arguments,
            });
        }
    }
    found
}

struct CommandReader<'t> {
    text: &'t str,
    rest: &'t str,
}

impl<'t> CommandReader<'t> {
    fn skip_char(&mut self) {
        let mut chars = self.rest.chars();
        chars.next();
        self.rest = chars.as_str();
    }

    fn take(&mut self, is_part: impl Fn(char) -> bool) -> &'t str {
        let end = self.rest.find(|c| !is_part(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }

    /// Pass over blanks and comments.
    fn skip_blanks(&mut self) {
        loop {
            self.take(char::is_whitespace);
            let Some(comment) = self.rest.strip_prefix('#') else {
                return;
            };
            self.rest = comment;
            if self.bracket().is_none() {
                self.take(|c| c != '\n');
            }
        }
    }

    /// The arguments up to the closing parenthesis.
    fn arguments(&mut self) -> Vec<CMakeArgument> {
        let mut found = Vec::new();
        let mut depth = 0_u32;
        loop {
            self.skip_blanks();
            let Some(next) = self.rest.chars().next() else {
                return found;
            };
            match next {
                ')' if depth == 0 => {
                    self.skip_char();
                    return found;
                }
                '(' | ')' => {
                    depth = if next == '(' { depth + 1 } else { depth - 1 };
                    self.skip_char();
                }
                _ => found.push(self.argument(next)),
            }
        }
    }

    /// The argument that begins with `first`.
    fn argument(&mut self, first: char) -> CMakeArgument {
        let start = self.at();
        let (text, is_quoted) = match first {
            '"' => (self.quoted(), true),
            '[' => match self.bracket() {
                Some(text) => (text, true),
                None => (self.plain(), false),
            },
            _ => (self.plain(), false),
        };
        CMakeArgument {
            text,
            is_quoted,
            range: TextRange::new(start, self.at()),
        }
    }

    /// How much of the file is read.
    fn at(&self) -> u32 {
        (self.text.len() - self.rest.len()) as u32
    }

    fn quoted(&mut self) -> String {
        self.skip_char();
        let mut text = String::new();
        loop {
            text.push_str(self.take(|c| c != '"' && c != '\\'));
            let is_escape = self.rest.starts_with('\\');
            self.skip_char();
            if !is_escape {
                return text;
            }
            text.extend(self.rest.chars().next().filter(|&c| c != '\n'));
            self.skip_char();
        }
    }

    fn plain(&mut self) -> String {
        let mut text = String::new();
        loop {
            text.push_str(
                self.take(|c| !c.is_whitespace() && !matches!(c, '(' | ')' | '#' | '"' | '\\')),
            );
            if !self.rest.starts_with('\\') {
                break;
            }
            self.skip_char();
            text.extend(self.rest.chars().next());
            self.skip_char();
        }
        if text.is_empty() {
            self.skip_char();
        }
        text
    }

    /// `[[text]]` or `[==[text]==]`.
    fn bracket(&mut self) -> Option<String> {
        let inner = self.rest.strip_prefix('[')?;
        let signs = inner.len() - inner.trim_start_matches('=').len();
        let text = inner.get(signs..)?.strip_prefix('[')?;
        let close = format!("]{}]", "=".repeat(signs));
        let (text, rest) = text.split_once(&close)?;
        self.rest = rest;
        Some(text.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::commands;

    #[test]
    fn texts() {
        let table = [
            (
                "install(DIRECTORY a b\n  DESTINATION c)",
                "install: DIRECTORY|a|b|DESTINATION|c",
            ),
            (
                "INSTALL ( FILES \"a b\" # c)\n d)",
                "install: FILES|'a b'|d",
            ),
            ("#[[ install(x) ]] project(p)", "project: p"),
            ("# install(x)\nproject(p)", "project: p"),
            ("if(NOT (A OR B)) endif()", "if: NOT|A|OR|B; endif: "),
            ("set(a \"x\\\"y\" [=[z]]=])", "set: a|'x\"y'|'z]'"),
            ("set(a [0-9])", "set: a|[0-9]"),
            (
                "list(APPEND a \\\"b\\\") project(p)",
                "list: APPEND|a|\"b\"; project: p",
            ),
            ("set(a \"open", "set: a|'open'"),
            ("half(a", "half: a"),
            ("+ x y(z)", "y: z"),
        ];
        for (text, expected) in table {
            let found: Vec<String> = commands(text)
                .iter()
                .map(|command| {
                    let arguments = command.arguments.iter().map(|argument| {
                        if argument.is_quoted {
                            format!("'{}'", argument.text)
                        } else {
                            argument.text.clone()
                        }
                    });
                    format!(
                        "{}: {}",
                        command.name,
                        arguments.collect::<Vec<_>>().join("|")
                    )
                })
                .collect();
            assert_eq!(found.join("; "), expected, "{text}");
        }
    }
}
