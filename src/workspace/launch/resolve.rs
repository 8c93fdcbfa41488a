//! From pieces to values: defaults of the launch file put in, commands split.

use std::path::{Path, PathBuf};

use base::limits::{LAUNCH_CALLS, LAUNCH_TEXT};
use base::{FastMap, TextRange};

use super::command::{self, ParsedCommand};
use super::place::TextPlace;
use super::text::{Text, TextPiece};
use super::{CommandForm, DeclaredArgument, LaunchCommand, LaunchFile, LaunchInclude};
use packages::Packages;

/// Defaults inside of defaults that are followed.
const MOST_DEFAULTS: usize = 8;

/// A call of a robot.
#[derive(Clone, Debug)]
pub struct LaunchCall {
    /// The file that calls.
    pub caller: PathBuf,
    /// The launch file that includes this one with other arguments, outermost first.
    pub through: Vec<PathBuf>,
    /// Where the call stands.
    pub range: TextRange,
    /// The description.
    pub file: CommandWord,
    /// The arguments, in order.
    pub args: Vec<CallArgument>,
    /// Whether there may be further arguments.
    pub open: bool,
    /// Whether launch reads the result as YAML.
    pub is_read_as_yaml: bool,
}

/// An argument that a call gives.
#[derive(Clone, Debug)]
pub struct CallArgument {
    /// Its name.
    pub name: String,
    /// Text that holds its name, where it is written: the name is the first `name:=` or quoted name in it.
    pub range: Option<TextRange>,
    /// Its value.
    pub value: CommandWord,
    /// Whether it is a word `name:=value` of a command. Without a value, xacro passes over such a word. Source: `load_mappings` in
    /// `cli.py` of xacro 2.1.1.
    pub is_word: bool,
}

/// A word of a command.
#[derive(Clone, Debug, Default)]
pub struct CommandWord(pub(super) Vec<Bit>);

/// A part of a word.
#[derive(Clone, Debug)]
pub(super) enum Bit {
    Text(String, TextPlace),
    Share(String),
    Opaque(Why),
}

/// Why a value is not known.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Why {
    /// The launch file computes it.
    Computed,
    /// Whoever starts the launch file gives it, by this argument.
    Required(String),
    /// A condition around the call decides it, by this argument.
    Decided(String),
}

/// What a launch file is given from outside.
#[derive(Clone, Debug, Default)]
pub(crate) struct LaunchContext {
    pub values: Vec<(String, CommandWord)>,
    pub through: Vec<PathBuf>,
}

/// The calls that a file makes when it is started by itself.
pub fn calls(file: &LaunchFile) -> Vec<LaunchCall> {
    calls_in(file, &LaunchContext::default())
}

pub(crate) fn calls_in(file: &LaunchFile, context: &LaunchContext) -> Vec<LaunchCall> {
    let mut found: Vec<LaunchCall> = Vec::new();
    for command in &file.commands {
        let resolver = Resolver::new(file, context, &command.assumed);
        let Some(called) = resolver.called(command) else {
            continue;
        };
        let call = LaunchCall {
            caller: file.path.clone(),
            through: context.through.clone(),
            range: command.range,
            file: called.file,
            args: called.args,
            open: called.open,
            is_read_as_yaml: command.is_read_as_yaml,
        };
        if !found
            .iter()
            .any(|known| known.range == call.range && known.is_same(&call))
        {
            found.push(call);
        }
    }
    found.truncate(LAUNCH_CALLS);
    found
}

/// The files that a launch file includes, each with what it is given.
pub(crate) fn included(
    file: &LaunchFile,
    context: &LaunchContext,
) -> Vec<(CommandWord, LaunchContext)> {
    let passed: Vec<Vec<(String, CommandWord)>> = file
        .includes
        .iter()
        .map(|one| passed(file, context, one))
        .collect();
    let given = |(number, include): (usize, &LaunchInclude)| {
        let resolver = Resolver::new(file, context, &include.assumed);
        let mut values: Vec<(String, CommandWord)> = Vec::new();
        if file.shares {
            let own = file.declared.iter().map(|declared| declared.name.clone());
            let own = own.chain(context.values.iter().map(|(name, _)| name.clone()));
            values.extend(own.map(|name| {
                let value = resolver.word(&Text::argument(&name));
                (name, value)
            }));
        }
        if file.shares {
            let others = passed
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != number);
            forget(&mut values, others.flat_map(|(_, passed)| passed));
        }
        for (name, value) in passed.get(number).into_iter().flatten() {
            values.retain(|(known, _)| known != name);
            values.push((name.clone(), value.clone()));
        }
        let through = context
            .through
            .iter()
            .cloned()
            .chain([file.path.clone()])
            .collect();
        (
            resolver.word(&include.file),
            LaunchContext { values, through },
        )
    };
    file.includes.iter().enumerate().map(given).collect()
}

/// The arguments that an include gives.
fn passed(
    file: &LaunchFile,
    context: &LaunchContext,
    include: &LaunchInclude,
) -> Vec<(String, CommandWord)> {
    let resolver = Resolver::new(file, context, &include.assumed);
    include
        .args
        .iter()
        .map(|(name, value)| (name.clone(), resolver.word(value)))
        .collect()
}

/// What one include is given stays set for those behind it in ROS 2, unless a group is around it: which of the values they
/// see is not known.
fn forget<'p>(
    values: &mut Vec<(String, CommandWord)>,
    others: impl Iterator<Item = &'p (String, CommandWord)>,
) {
    for (name, other) in others {
        match values.iter_mut().find(|(known, _)| known == name) {
            Some((_, value)) if value.shown() == other.shown() => {}
            Some((_, value)) => *value = CommandWord(vec![Bit::Opaque(Why::Computed)]),
            None => values.push((name.clone(), CommandWord(vec![Bit::Opaque(Why::Computed)]))),
        }
    }
}

/// The same of defaults: that of the file which is included first holds for those behind it.
pub(crate) fn forget_defaults<'f>(
    context: &mut LaunchContext,
    file: &LaunchFile,
    others: impl Iterator<Item = &'f LaunchFile>,
) {
    for other in others {
        for declared in &other.declared {
            let own = file.declared.iter().find(|own| own.name == declared.name);
            let Some(own) =
                own.filter(|own| !context.values.iter().any(|(name, _)| *name == own.name))
            else {
                continue;
            };
            let (first, second) = (default_of(own, file), default_of(declared, other));
            if first.is_none() || first != second {
                context.values.push((
                    own.name.clone(),
                    CommandWord(vec![Bit::Opaque(Why::Computed)]),
                ));
            }
        }
    }
}

/// The default of an argument by itself, where it is known.
fn default_of(declared: &DeclaredArgument, file: &LaunchFile) -> Option<String> {
    let none = LaunchContext::default();
    Resolver::new(file, &none, &[])
        .word(declared.default.as_ref()?)
        .literal()
}

/// A value that a launch file gives to an argument.
pub(crate) struct GivenValue {
    /// The launch file whose argument it is; none for its own.
    pub to: Option<CommandWord>,
    pub name: String,
    pub value: String,
    /// What gives it.
    pub range: TextRange,
}

/// The values that a launch file gives to its own arguments by their defaults, and to those of the files that it includes.
pub(crate) fn values_given(file: &LaunchFile) -> Vec<GivenValue> {
    let context = LaunchContext::default();
    let own = Resolver::new(file, &context, &[]);
    let defaults = file.declared.iter().filter_map(|declared| {
        let value = own.word(declared.default.as_ref()?).literal()?;
        Some(GivenValue {
            to: None,
            name: declared.name.clone(),
            value,
            range: declared.range,
        })
    });
    let included = file.includes.iter().flat_map(|include| {
        let resolver = Resolver::new(file, &context, &include.assumed);
        let to = resolver.word(&include.file);
        let given = |(name, value): &(String, Text)| {
            let value = resolver.word(value).literal()?;
            Some(GivenValue {
                to: Some(to.clone()),
                name: name.clone(),
                value,
                range: include.range,
            })
        };
        include.args.iter().filter_map(given).collect::<Vec<_>>()
    });
    defaults.chain(included).collect()
}

impl LaunchCall {
    /// Whether another call gives the same robot the same.
    pub fn is_same(&self, other: &Self) -> bool {
        let args = |call: &Self| -> Vec<(String, String)> {
            let mut args: Vec<_> = call
                .args
                .iter()
                .map(|arg| (arg.name.clone(), arg.value.shown()))
                .collect();
            args.sort();
            args
        };
        self.file.shown() == other.file.shown()
            && self.open == other.open
            && args(self) == args(other)
    }

    /// How many values of arguments are known.
    pub fn known(&self) -> usize {
        self.args.iter().filter(|arg| arg.value.is_known()).count()
    }
}

impl CallArgument {
    /// The value that xacro gets, where it is known and it gets one.
    pub fn given(&self, packages: &Packages, from: &Path) -> Option<String> {
        self.value
            .value(packages, from)
            .filter(|_| !self.is_left_out())
    }

    /// Whether xacro passes over it: it is a word without a value.
    pub fn is_left_out(&self) -> bool {
        let is_empty = |bit: &Bit| matches!(bit, Bit::Text(text, _) if text.trim().is_empty());
        self.is_word && self.value.0.iter().all(is_empty)
    }

    /// Whether nobody who starts the launch file can give another value: it stands in the call at `range`, or is computed.
    pub fn is_fixed(&self, range: TextRange) -> bool {
        self.value.0.iter().all(|bit| match bit {
            Bit::Text(_, at) => at.here().is_some_and(|at| range.contains_range(at)),
            Bit::Share(_) | Bit::Opaque(Why::Computed) => true,
            Bit::Opaque(_) => false,
        })
    }
}

impl CommandWord {
    fn push(&mut self, bit: Bit) {
        self.0.push(bit);
    }

    /// A text.
    pub fn plain(text: &str) -> Self {
        Self(vec![Bit::Text(text.to_owned(), TextPlace::Unknown)])
    }

    /// Whether all of it is known.
    pub fn is_known(&self) -> bool {
        !self.0.iter().any(|bit| matches!(bit, Bit::Opaque(_)))
    }

    /// Why it is not known.
    pub fn why(&self) -> Option<&Why> {
        self.0.iter().find_map(|bit| match bit {
            Bit::Opaque(why) => Some(why),
            _ => None,
        })
    }

    /// The text, where all of it is written down or a default.
    pub fn literal(&self) -> Option<String> {
        let plain = |bit: &Bit| {
            if let Bit::Text(text, _) = bit {
                Some(text.clone())
            } else {
                None
            }
        };
        self.0.iter().map(plain).collect()
    }

    /// For people: packages as `$(find name)`, `?` for what is not known.
    pub fn shown(&self) -> String {
        let shown = |bit: &Bit| match bit {
            Bit::Text(text, _) => text.clone(),
            Bit::Share(name) => format!("$(find {name})"),
            Bit::Opaque(_) => "?".to_owned(),
        };
        self.0.iter().map(shown).collect()
    }

    /// The value as the launch system hands it on, where it is known and all packages are found.
    pub fn value(&self, packages: &Packages, from: &Path) -> Option<String> {
        if let Some(at) = self.joined_share() {
            return Self(self.0.get(at..)?.to_vec()).value(packages, from);
        }
        let value = |bit: &Bit| match bit {
            Bit::Text(text, _) => Some(text.clone()),
            Bit::Share(name) => {
                let found = packages.find(name, from).ok()?;
                Some(vfs::slashed(&found.path))
            }
            Bit::Opaque(_) => None,
        };
        self.0.iter().map(value).collect()
    }

    /// Where a share folder follows the steps of another path: it takes their place.
    fn joined_share(&self) -> Option<usize> {
        let at = self
            .0
            .iter()
            .rposition(|bit| matches!(bit, Bit::Share(_)))?;
        let (first, before) = (self.0.first()?, self.0.get(..at)?.last()?);
        let is_path = match first {
            Bit::Share(_) => true,
            Bit::Text(text, _) => text.starts_with('/'),
            Bit::Opaque(_) => false,
        };
        let ends_step = matches!(before, Bit::Text(text, _) if text.ends_with('/'));
        (is_path && ends_step).then_some(at)
    }

    /// The file it names. Relative names start in the folder of the launch file.
    pub fn path(&self, packages: &Packages, from: &Path) -> Option<PathBuf> {
        let text = self.value(packages, from)?;
        // an absolute step replaces those before
        let text = text
            .rfind("//")
            .and_then(|at| text.get(at + 1..))
            .unwrap_or(&text);
        let text = text.strip_prefix("file:/").unwrap_or(text);
        let folder = from.parent().unwrap_or(from);
        (!text.is_empty()).then(|| vfs::without_parents(&folder.join(text)))
    }

    /// The package in front, and the text behind it.
    pub fn in_package(&self) -> Option<(&str, String)> {
        match self.0.split_first()? {
            (Bit::Share(name), rest) => Some((name, CommandWord(rest.to_vec()).shown())),
            _ => None,
        }
    }

    /// The name of the file that a path ends with, where it is known.
    pub fn file_name(&self) -> Option<&str> {
        let Some(Bit::Text(text, _)) = self.0.last() else {
            return None;
        };
        let is_whole = text.contains('/') || self.0.len() == 1;
        is_whole
            .then(|| text.rsplit('/').next().unwrap_or(text))
            .filter(|name| !name.is_empty())
    }

    /// Where the first of its texts stands.
    pub fn place(&self) -> Option<TextRange> {
        self.places().find_map(TextPlace::here)
    }

    /// Where the first of its texts stands, in the default of an argument if it is nowhere else.
    pub fn written(&self) -> Option<TextRange> {
        self.place()
            .or_else(|| self.places().find_map(TextPlace::written))
    }

    fn places(&self) -> impl Iterator<Item = TextPlace> + '_ {
        self.0.iter().filter_map(|bit| match bit {
            Bit::Text(_, at) => Some(*at),
            _ => None,
        })
    }

    fn plain_len(&self) -> usize {
        self.0
            .iter()
            .map(|bit| {
                if let Bit::Text(text, _) = bit {
                    text.len()
                } else {
                    1
                }
            })
            .sum()
    }
}

/// What the pieces of one command stand for.
pub(super) struct Resolver<'a> {
    file: &'a LaunchFile,
    context: &'a LaunchContext,
    assumed: &'a [String],
    declared: FastMap<&'a str, Option<&'a Text>>,
    /// Arguments whose values the file decides while it runs, or declares in two ways.
    unclear: Vec<&'a str>,
}

impl<'a> Resolver<'a> {
    pub fn new(file: &'a LaunchFile, context: &'a LaunchContext, assumed: &'a [String]) -> Self {
        let mut declared: FastMap<&str, Option<&Text>> = FastMap::default();
        let mut unclear: Vec<&str> = Vec::new();
        for argument in &file.declared {
            let default = argument.default.as_ref();
            if let Some(known) = declared.insert(&argument.name, default)
                && known != default
            {
                unclear.push(&argument.name);
            }
        }
        unclear.extend(file.set.iter().map(String::as_str));
        // a default that is written where the value is read counts where nothing declares the argument
        for (name, default) in file
            .defaults
            .iter()
            .filter(|(name, _)| !file.is_declared(name))
        {
            if let Some(known) = declared.insert(name, Some(default))
                && known != Some(default)
            {
                unclear.push(name);
            }
        }
        Self {
            file,
            context,
            assumed,
            declared,
            unclear,
        }
    }

    fn word(&self, text: &Text) -> CommandWord {
        let mut word = CommandWord::default();
        self.resolve(text, 0, &mut word);
        word
    }

    fn resolve(&self, text: &Text, depth: usize, word: &mut CommandWord) {
        for piece in &text.0 {
            if word.plain_len() > LAUNCH_TEXT || word.0.len() > 1_000 {
                word.push(Bit::Opaque(Why::Computed));
                return;
            }
            match piece {
                TextPiece::Plain(text, at) => {
                    word.push(Bit::Text(text.clone(), TextPlace::at(*at)));
                }
                TextPiece::Opaque => word.push(Bit::Opaque(Why::Computed)),
                TextPiece::Argument(name) => self.argument(name, depth, word),
                TextPiece::Share(package) => {
                    let mut inner = CommandWord::default();
                    self.resolve(package, depth + 1, &mut inner);
                    word.push(match inner.why().cloned() {
                        Some(why) => Bit::Opaque(why),
                        None => Bit::Share(inner.shown()),
                    });
                }
            }
        }
    }

    /// Whether the launch file sets an argument itself, whatever is given.
    fn is_fixed(&self, name: &str) -> bool {
        self.file
            .declared
            .iter()
            .any(|own| own.name == name && own.is_fixed)
    }

    fn argument(&self, name: &str, depth: usize, word: &mut CommandWord) {
        if self.assumed.iter().any(|assumed| assumed == name) {
            return word.push(Bit::Opaque(Why::Decided(name.to_owned())));
        }
        let given = self.context.values.iter().find(|(given, _)| given == name);
        if let Some((_, value)) = given.filter(|_| !self.is_fixed(name)) {
            let bare = |bit: &Bit| match bit {
                Bit::Text(text, _) => Bit::Text(text.clone(), TextPlace::Unknown),
                other => other.clone(),
            };
            return word.0.extend(value.0.iter().map(bare));
        }
        match self
            .declared
            .get(name)
            .filter(|_| !self.unclear.contains(&name))
        {
            Some(Some(default)) if depth < MOST_DEFAULTS => {
                let mut inner = CommandWord::default();
                self.resolve(default, depth + 1, &mut inner);
                word.0.extend(inner.0.into_iter().map(|bit| match bit {
                    Bit::Text(text, at) => Bit::Text(text, at.as_default()),
                    other => other,
                }));
            }
            Some(None) => word.push(Bit::Opaque(Why::Required(name.to_owned()))),
            _ => word.push(Bit::Opaque(Why::Computed)),
        }
    }

    /// The words of a command; none of a call from Python, and where quotes are left open.
    pub fn words(&self, command: &LaunchCommand) -> Option<Vec<CommandWord>> {
        match &command.what {
            CommandForm::Line(line) => command::split(&self.word(line)),
            CommandForm::Words(words) => Some(words.iter().map(|word| self.word(word)).collect()),
            CommandForm::Process { .. } => None,
        }
    }

    fn called(&self, command: &LaunchCommand) -> Option<ParsedCommand> {
        match &command.what {
            CommandForm::Line(_) | CommandForm::Words(_) => command::of_words(self.words(command)?),
            CommandForm::Process {
                file,
                mappings,
                open,
            } => {
                let args = mappings.iter().map(|given| CallArgument {
                    name: given.name.clone(),
                    range: given.range,
                    value: self.word(&given.value),
                    is_word: false,
                });
                Some(ParsedCommand {
                    file: self.word(file),
                    args: args.collect(),
                    open: *open,
                })
            }
        }
    }
}
