//! Command lines: split as a shell does, and what they say when they call xacro.

use super::DESCRIPTIONS;
use super::place::TextPlace;
use super::resolve::{Bit, CallArgument, CommandWord};

/// What a command line says.
pub(super) struct ParsedCommand {
    pub file: CommandWord,
    pub args: Vec<CallArgument>,
    pub open: bool,
}

/// The words of a command line; none when quotes are left open.
pub(super) fn split(line: &CommandWord) -> Option<Vec<CommandWord>> {
    let mut split = WordSplitter::default();
    for bit in &line.0 {
        match bit {
            Bit::Text(text, at) => {
                for c in text.chars() {
                    split.take(c, *at);
                }
                split.settle(*at);
            }
            other => {
                split.word.0.push(other.clone());
                split.is_open = true;
            }
        }
    }
    split.finish()
}

#[derive(Default)]
struct WordSplitter {
    words: Vec<CommandWord>,
    word: CommandWord,
    text: String,
    /// Whether a word has begun: empty quotes are a word.
    is_open: bool,
    quote: Option<char>,
    is_escaped: bool,
}

impl WordSplitter {
    fn take(&mut self, c: char, at: TextPlace) {
        if self.is_escaped {
            self.is_escaped = false;
            // inside of quotes, a backslash only hides quotes and itself
            if self.quote.is_some() && !matches!(c, '"' | '\\') {
                self.text.push('\\');
            }
            self.text.push(c);
            return;
        }
        match (self.quote, c) {
            (None | Some('"'), '\\') => (self.is_escaped, self.is_open) = (true, true),
            (Some(quote), c) if c == quote => self.quote = None,
            (Some(_), c) => self.text.push(c),
            (None, '"' | '\'') => (self.quote, self.is_open) = (Some(c), true),
            (None, c) if c.is_whitespace() => self.end(at),
            (None, c) => {
                self.text.push(c);
                self.is_open = true;
            }
        }
    }

    fn settle(&mut self, at: TextPlace) {
        if !self.text.is_empty() {
            self.word
                .0
                .push(Bit::Text(std::mem::take(&mut self.text), at));
        }
    }

    fn end(&mut self, at: TextPlace) {
        self.settle(at);
        if std::mem::take(&mut self.is_open) {
            self.words.push(std::mem::take(&mut self.word));
        }
    }

    fn finish(mut self) -> Option<Vec<CommandWord>> {
        self.end(TextPlace::Unknown);
        (self.quote.is_none() && !self.is_escaped).then_some(self.words)
    }
}

/// Options of xacro that take a word.
const WITH_VALUE: [&str; 4] = ["-o", "--output", "--root-dir", "--verbosity"];

/// Options of programs that take the name of a file to write.
const WITH_OUTPUT: [&str; 3] = ["-o", "--output", "--out"];

/// What the words of a command say when it calls xacro.
pub(super) fn of_words(words: Vec<CommandWord>) -> Option<ParsedCommand> {
    let mut words = words.into_iter().peekable();
    let mut program = words.next()?.shown();
    if matches!(
        base_name(&program),
        "rosrun" | "ros2" | "python3" | "python" | "sudo"
    ) {
        let mut is_xacro = false;
        while let Some(word) = words.peek().map(CommandWord::shown) {
            if !matches!(
                word.as_str(),
                "run" | "xacro" | "xacro.py" | "--prefix" | "-m"
            ) {
                break;
            }
            is_xacro |= word.starts_with("xacro");
            words.next();
        }
        program = if is_xacro {
            "xacro".to_owned()
        } else {
            program
        };
    }
    if !is_xacro_program(&program) {
        return None;
    }
    let (mut file, mut args, mut open) = (None, Vec::new(), false);
    while let Some(word) = words.next() {
        let shown = word.shown();
        if ends_command(&shown) {
            break;
        }
        if WITH_VALUE.contains(&shown.as_str()) {
            words.next();
        } else if shown.starts_with('-') && !shown.contains(":=") {
            continue;
        } else if let Some((name, range, value)) = assignment(&word) {
            match name {
                Some(name) if name.starts_with('_') => {}
                Some(name) => args.push(CallArgument {
                    name,
                    range,
                    value,
                    is_word: true,
                }),
                None => open = true,
            }
        } else if file.is_none() {
            file = Some(word);
        } else if !word.is_known() {
            open = true;
        }
    }
    Some(ParsedCommand {
        file: file?,
        args,
        open,
    })
}

/// The words of a command that name descriptions, in front of what it prints to.
pub(super) fn descriptions_of(words: Vec<CommandWord>) -> Vec<CommandWord> {
    let mut named: Vec<CommandWord> = Vec::new();
    let mut is_output = false;
    for word in words {
        let shown = word.shown();
        if ends_command(&shown) {
            break;
        }
        let is_description = DESCRIPTIONS.iter().any(|ending| shown.ends_with(ending));
        if is_description && !is_output {
            named.push(word);
        }
        is_output = WITH_OUTPUT.contains(&shown.as_str());
    }
    named
}

/// Whether a word is the program xacro.
pub(super) fn is_xacro(word: &CommandWord) -> bool {
    is_xacro_program(&word.shown())
}

/// Whether a program is xacro.
pub(super) fn is_xacro_program(program: &str) -> bool {
    // roslaunch takes `$(find xacro)xacro.py` as well
    let name = base_name(program);
    let name = name.strip_prefix("$(find xacro)").unwrap_or(name);
    matches!(name, "xacro" | "xacro.py")
}

fn base_name(program: &str) -> &str {
    program.rsplit('/').next().unwrap_or(program)
}

/// Whether a word of a shell ends a command.
fn ends_command(word: &str) -> bool {
    matches!(
        word,
        ">" | ">>" | "|" | "||" | "&&" | "&" | ";" | "2>" | "2>&1" | "<"
    ) || word.starts_with('>')
}

type Assignment = (Option<String>, Option<base::TextRange>, CommandWord);

/// `name:=value`; the name is none where it is computed.
fn assignment(word: &CommandWord) -> Option<Assignment> {
    let mut before = String::new();
    let mut is_known = true;
    for (number, bit) in word.0.iter().enumerate() {
        let Bit::Text(text, at) = bit else {
            is_known = false;
            continue;
        };
        // the sign may be split over two texts
        let mut joined = text.clone();
        let starts_sign = before.ends_with(':') && text.starts_with('=');
        if starts_sign {
            before.pop();
            joined.insert(0, ':');
        }
        let Some((name, value)) = joined.split_once(":=") else {
            before.push_str(text);
            continue;
        };
        before.push_str(name);
        let first = (!value.is_empty()).then(|| Bit::Text(value.to_owned(), *at));
        let rest = word.0.get(number + 1..).unwrap_or_default().iter().cloned();
        let is_name = is_known && !before.is_empty();
        return Some((
            is_name.then(|| before.trim().to_owned()),
            at.here(),
            CommandWord(first.into_iter().chain(rest).collect()),
        ));
    }
    None
}
