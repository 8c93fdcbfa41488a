//! Shell scripts, and commands in the files of build servers.

use std::path::Path;

use base::TextRange;
use base::limits::LAUNCH_CALLS;

use super::text::{Text, TextPiece};
use super::{CommandForm, LaunchCommand, LaunchFile};

/// A shell script.
pub(super) fn script(path: &Path, text: &str) -> LaunchFile {
    let mut file = LaunchFile {
        shares: false,
        ..LaunchFile::of(path)
    };
    commands(text, &mut file);
    file
}

/// A file that holds commands among other things: those of a job, or of a launch file in YAML.
pub(super) fn embedded(path: &Path, text: &str) -> LaunchFile {
    script(path, text)
}

/// The commands of a text, one a line; a backslash goes on in the next one.
fn commands(text: &str, file: &mut LaunchFile) {
    let mut at = 0;
    while at < text.len() && file.commands.len() < LAUNCH_CALLS {
        let start = at;
        let rest = text.get(at..).unwrap_or("");
        let mut len = 0;
        for line in rest.split_inclusive('\n') {
            len += line.len();
            if !line.trim_end().ends_with('\\') {
                break;
            }
        }
        at += len.max(1);
        let line = text.get(start..start + len).unwrap_or("");
        if let Some(from) = call_start(line) {
            let range = TextRange::new(
                (start + from) as u32,
                (start + line.trim_end().len()) as u32,
            );
            let command = line_of(range.slice(text), range);
            file.commands.push(LaunchCommand {
                range,
                what: CommandForm::Line(command),
                assumed: Vec::new(),
                is_read_as_yaml: false,
            });
        }
    }
}

/// Where a line calls xacro as a program: the word is the first one, or stands behind something that starts a command.
fn call_start(line: &str) -> Option<usize> {
    let code = line.trim_start();
    if code.starts_with('#') {
        return None;
    }
    let mut from = 0;
    while let Some(found) = line.get(from..).and_then(|rest| rest.find("xacro")) {
        let at = from + found;
        let (before, after) = line.split_at(at);
        let behind = after.get("xacro".len()..).unwrap_or("");
        let behind = behind.strip_prefix(".py").unwrap_or(behind);
        if behind.starts_with([' ', '\t']) && starts_command(before) {
            return Some(at);
        }
        from = at + "xacro".len();
    }
    None
}

/// Whether a program may stand behind this text.
fn starts_command(before: &str) -> bool {
    let lead = before.trim_end();
    // a key of YAML, an item of a list, a substitution, another command
    let lead = lead
        .strip_suffix("rosrun xacro")
        .or_else(|| lead.strip_suffix("ros2 run xacro"))
        .unwrap_or(lead);
    let word = lead
        .rsplit([' ', '\t', '"', '\'', '='])
        .next()
        .unwrap_or("");
    let folders = before.ends_with('/') && !word.contains('.');
    let ends = [
        "", "|", "&&", "||", ";", "$(", "`", "-", "if", "!", "then", "do", "run:", "script:",
    ];
    let is_start =
        ends.contains(&word) || word.ends_with("$(") || word.ends_with('`') || word.ends_with(';');
    is_start && !folders || folders && before.trim_start().starts_with('/')
}

/// A command line with its variables, up to where the command ends.
fn line_of(line: &str, range: TextRange) -> Text {
    let mut text = Text::default();
    let mut plain = String::new();
    let mut quote = None;
    let mut chars = line.char_indices().peekable();
    let at = Some(range);
    while let Some((here, c)) = chars.next() {
        match c {
            '\\' if matches!(chars.peek(), Some((_, '\n' | '\r'))) => {
                chars.next();
                plain.push(' ');
            }
            '\'' if quote != Some('"') => {
                quote = if quote.is_some() { None } else { Some('\'') };
                plain.push(c);
            }
            '"' if quote != Some('\'') => {
                quote = if quote.is_some() { None } else { Some('"') };
                plain.push(c);
            }
            ')' | '`' | ';' | '|' | '>' | '&' if quote.is_none() => break,
            '#' if quote.is_none() && plain.ends_with(' ') => break,
            '$' if quote != Some('\'') => {
                text.push(Text::plain(std::mem::take(&mut plain), at));
                text.push(Text(vec![TextPiece::Opaque]));
                let len = variable(line.get(here + 1..).unwrap_or(""));
                while chars.peek().is_some_and(|(next, _)| *next < here + 1 + len) {
                    chars.next();
                }
            }
            '*' | '?' | '{' | '~' | '[' if quote.is_none() => {
                text.push(Text::plain(std::mem::take(&mut plain), at));
                text.push(Text::opaque());
            }
            _ => plain.push(c),
        }
    }
    if quote.is_some() {
        // a quote that was opened before the command ends it
        let end = plain.trim_end().trim_end_matches(['"', '\'']).to_owned();
        plain = if end.contains(['"', '\'']) {
            plain
        } else {
            end
        };
    }
    text.push(Text::plain(plain, at));
    text
}

/// A command that a program hands to a shell: its variables are not known.
pub(super) fn in_text(line: Text) -> Text {
    let pieces = line.0.into_iter().map(|piece| match piece {
        TextPiece::Plain(text, at) if text.contains(['$', '`', ';', '|', '&', '*', '>']) => {
            let range = at.unwrap_or_default();
            let pieces = line_of(&text, range)
                .0
                .into_iter()
                .map(|piece| match piece {
                    TextPiece::Plain(text, _) => TextPiece::Plain(text, at),
                    other => other,
                });
            Text(pieces.collect())
        }
        other => Text(vec![other]),
    });
    Text::concat(pieces)
}

/// The length of what stands behind `$`: a name, or something in brackets.
fn variable(text: &str) -> usize {
    let close = match text.chars().next() {
        Some('{') => '}',
        Some('(') => ')',
        _ => {
            return text
                .find(|c: char| !(c.is_alphanumeric() || c == '_'))
                .unwrap_or(text.len());
        }
    };
    let open = if close == ')' { '(' } else { '{' };
    let mut depth = 0usize;
    for (at, c) in text.char_indices() {
        if c == open {
            depth += 1;
        } else if c == close {
            depth -= 1;
            if depth == 0 {
                return at + 1;
            }
        }
    }
    text.len()
}
