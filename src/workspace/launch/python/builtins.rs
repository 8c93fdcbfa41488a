//! Functions and classes that a launch file imports.

use base::TextRange;
use base::limits::LAUNCH_CALLS;

use super::methods::parent;
use super::value::PythonValue;
use super::{Deferred, PythonReader};
use crate::launch::text::Text;
use crate::launch::{
    CONTROL_NODE, CommandForm, DeclaredArgument, LaunchCommand, LaunchInclude, SPAWNER,
    TRANSFORM_PUBLISHER,
};

/// What a condition around a node or an include may read.
const CONDITION: &str = "condition";

/// The spawner of controller_manager, and how it was called in Foxy.
const SPAWNERS: [&str; 2] = [SPAWNER, "spawner.py"];

/// The arguments of a call.
pub(super) struct PythonArgs {
    positional: Vec<Option<PythonValue>>,
    named: Vec<(String, PythonValue)>,
    /// Whether there may be further ones.
    pub open: bool,
}

impl PythonArgs {
    pub fn new(positional: Vec<PythonValue>, named: Vec<(String, PythonValue)>) -> Self {
        let open = named.iter().any(|(name, _)| name == "**");
        Self {
            positional: positional.into_iter().map(Some).collect(),
            named,
            open,
        }
    }

    /// The argument at a place or of a name.
    pub fn take(&mut self, at: usize, name: &str) -> Option<PythonValue> {
        let named = self.named.iter().position(|(known, _)| known == name);
        match named {
            Some(number) => Some(self.named.swap_remove(number).1),
            None => self.positional.get_mut(at).and_then(Option::take),
        }
    }

    fn text(&mut self, at: usize, name: &str) -> Text {
        self.take(at, name)
            .map_or_else(Text::opaque, PythonValue::text)
    }
}

impl PythonReader<'_> {
    /// A call of something that the file does not define.
    pub(super) fn outer(
        &mut self,
        range: TextRange,
        path: &str,
        args: Vec<PythonValue>,
        named: Vec<(String, PythonValue)>,
    ) -> PythonValue {
        let count = args.len();
        let mut args = PythonArgs::new(args, named);
        self.parameters_of(range, &args);
        self.arguments_of(range, &args);
        let name = path.rsplit('.').next().unwrap_or(path);
        match name {
            "LaunchConfiguration" => self.configuration(args),
            "get" if path.contains("launch_configurations") => {
                match args.text(0, "key").literal() {
                    Some(name) if count == 1 => PythonValue::Text(Text::argument(&name)),
                    _ => PythonValue::Unknown,
                }
            }
            "perform_substitution" => PythonValue::Text(args.text(0, "substitution")),
            "perform_substitutions" => PythonValue::Text(args.text(1, "subs")),
            "normalize_to_list_of_substitutions" => PythonValue::Text(args.text(0, "subs")),
            "DeclareLaunchArgument" => self.declare(range, args),
            "SetLaunchConfiguration" => {
                if let Some(name) = args.text(0, "name").literal() {
                    self.found.set.push(name);
                }
                PythonValue::Unknown
            }
            "get_package_share_directory" | "get_package_share_path" | "FindPackageShare" => {
                PythonValue::Text(Text::share(
                    args.text(0, "package_name").or(|| args.text(0, "package")),
                ))
            }
            "get_package_prefix" | "FindPackagePrefix" | "FindPackage" => {
                PythonValue::Text(Text::opaque())
            }
            "PathJoinSubstitution" => match args.take(0, "substitutions") {
                Some(PythonValue::List(steps)) => {
                    PythonValue::Text(Text::joined(steps.into_iter().map(PythonValue::text)))
                }
                _ => PythonValue::Text(Text::opaque()),
            },
            "join" if path.ends_with("path.join") => {
                let steps = args.positional.into_iter().flatten().map(PythonValue::text);
                PythonValue::Text(Text::joined(steps.collect::<Vec<_>>()))
            }
            "Path" | "PurePath" | "PathSubstitution" if count == 1 => {
                PythonValue::Text(args.text(0, "path"))
            }
            "Path" | "PurePath" => {
                let steps = args.positional.into_iter().flatten().map(PythonValue::text);
                PythonValue::Text(Text::joined(steps.collect::<Vec<_>>()))
            }
            "dirname" => PythonValue::Text(parent(&args.text(0, "p"))),
            "abspath" | "realpath" | "normpath" | "expanduser" => {
                PythonValue::Text(args.text(0, "path"))
            }
            "TextSubstitution" | "StringJoinSubstitution" => match args.take(0, "text") {
                Some(PythonValue::Text(text)) => PythonValue::Text(text),
                _ => PythonValue::Text(Text::opaque()),
            },
            "str" if count == 1 => {
                PythonValue::Text(args.take(0, "object").unwrap_or_default().written())
            }
            "dict" => {
                let (mut pairs, mut open) = (Vec::new(), args.open);
                if let Some(base) = args.take(0, "**") {
                    open |= PythonValue::spread(&mut pairs, base);
                }
                let named = args.named.into_iter().filter(|(name, _)| name != "**");
                named.for_each(|(name, value)| PythonValue::set(&mut pairs, name, value));
                PythonValue::Dict { pairs, open }
            }
            "list" | "tuple" | "deepcopy" | "copy" if count == 1 => {
                args.take(0, "x").unwrap_or_default()
            }
            "FindExecutable" => match args.text(0, "name").literal() {
                Some(name) => PythonValue::plain(name),
                None => PythonValue::Text(Text::opaque()),
            },
            "Command" => self.command(range, &mut args),
            "ExecuteProcess" | "run" | "Popen" | "check_output" | "check_call" | "call"
            | "getoutput" | "system" | "popen" => {
                let words = args.take(0, "cmd").or_else(|| args.take(0, "args"));
                self.words(range, words);
                PythonValue::Unknown
            }
            "OpaqueFunction" => {
                self.defer(args);
                PythonValue::Unknown
            }
            "IncludeLaunchDescription" => {
                self.include(range, args);
                PythonValue::Unknown
            }
            "PythonLaunchDescriptionSource"
            | "XMLLaunchDescriptionSource"
            | "YAMLLaunchDescriptionSource"
            | "AnyLaunchDescriptionSource"
            | "FrontendLaunchDescriptionSource" => {
                PythonValue::Text(args.text(0, "launch_file_path"))
            }
            "open" => {
                let file = args.text(0, "file");
                self.opened(range, file, args.take(1, "mode"))
            }
            "MoveItConfigsBuilder" => {
                let robot = args.text(0, "robot_name");
                match args
                    .take(2, "package_name")
                    .or_else(|| args.take(1, "package"))
                {
                    Some(PythonValue::Text(package)) => PythonValue::Builder(package),
                    Some(_) => PythonValue::Builder(Text::opaque()),
                    None => PythonValue::Builder(Text::concat([
                        robot,
                        Text::plain("_moveit_config", None),
                    ])),
                }
            }
            "process_file" | "process" if is_xacro(path) => {
                let file = args
                    .take(0, "input_file_name")
                    .map_or_else(Text::opaque, PythonValue::text);
                let mappings = args.take(usize::MAX, "mappings");
                self.process(range, file, mappings, args.open);
                PythonValue::Unknown
            }
            // a helper that many launch files import from beside them, after that of realsense-ros
            "to_urdf" => {
                let file = args
                    .take(0, "xacro_path")
                    .map_or_else(Text::opaque, PythonValue::text);
                let mappings = args.take(1, "parameters");
                self.process(range, file, mappings, args.open);
                PythonValue::Unknown
            }
            "parse" if is_xacro(path) => match (args.take(0, "inp"), args.take(1, "filename")) {
                (Some(PythonValue::Document(file)), _) => PythonValue::Document(file),
                (_, Some(PythonValue::Text(file))) => PythonValue::Document(file),
                _ => PythonValue::Document(Text::opaque()),
            },
            "process_doc" if is_xacro(path) => {
                let file = match args.take(0, "doc") {
                    Some(PythonValue::Document(file)) => file,
                    _ => Text::opaque(),
                };
                let mappings = args.take(usize::MAX, "mappings");
                self.process(range, file, mappings, args.open);
                PythonValue::Unknown
            }
            _ => PythonValue::Unknown,
        }
    }

    /// `LaunchConfiguration(name, default=...)`
    fn configuration(&mut self, mut args: PythonArgs) -> PythonValue {
        let Some(name) = args.text(0, "variable_name").literal() else {
            return PythonValue::Text(Text::opaque());
        };
        if let Some(default) = args
            .take(usize::MAX, "default")
            .filter(|_| self.found.defaults.len() < LAUNCH_CALLS)
        {
            let default = if let PythonValue::None = default {
                Text::opaque()
            } else {
                default.text()
            };
            self.found.defaults.push((name.clone(), default));
        }
        PythonValue::Text(Text::argument(&name))
    }

    fn declare(&mut self, range: TextRange, mut args: PythonArgs) -> PythonValue {
        let Some(name) = args.text(0, "name").literal() else {
            return PythonValue::Unknown;
        };
        let default = args.take(usize::MAX, "default_value");
        let choices = match args.take(usize::MAX, "choices") {
            Some(PythonValue::List(values)) => values
                .into_iter()
                .map(|value| value.text().literal())
                .collect(),
            _ => None,
        };
        let is_open = args.open;
        let default = match default {
            None | Some(PythonValue::None) if is_open => Some(Text::opaque()),
            None | Some(PythonValue::None) => None,
            Some(value) => Some(value.text()),
        };
        self.found.declared.push(DeclaredArgument {
            name,
            default,
            choices,
            range,
            is_fixed: false,
        });
        PythonValue::Unknown
    }

    /// `Command([...])`: one text, split as a shell does.
    fn command(&mut self, range: TextRange, args: &mut PythonArgs) -> PythonValue {
        let line = match args.take(0, "command") {
            Some(value @ (PythonValue::Text(_) | PythonValue::List(_))) => value.text(),
            _ => return PythonValue::Unknown,
        };
        let number = self.found.commands.len();
        self.record(range, CommandForm::Line(line));
        PythonValue::Output(number)
    }

    /// What a node gets as parameters: launch reads the output of a command in it as YAML.
    fn parameters_of(&mut self, range: TextRange, args: &PythonArgs) {
        let given = args.named.iter().find(|(name, _)| name == "parameters");
        let Some((_, PythonValue::List(given))) = given else {
            return;
        };
        for value in given {
            if let PythonValue::Text(text) = value {
                self.file(range, CommandForm::Words(vec![text.clone()]));
            }
            let PythonValue::Dict { pairs, .. } = value else {
                continue;
            };
            for (_, value) in pairs {
                if let PythonValue::Output(number) = value
                    && let Some(command) = self.found.commands.get_mut(*number)
                {
                    command.is_read_as_yaml = true;
                }
            }
        }
    }

    /// A file that is opened, to be read unless a mode says otherwise.
    pub(super) fn opened(
        &mut self,
        range: TextRange,
        file: Text,
        mode: Option<PythonValue>,
    ) -> PythonValue {
        let mode = mode.map(PythonValue::text);
        if mode.is_none_or(|mode| mode.literal().is_some_and(|mode| mode.starts_with('r'))) {
            self.load(range, CommandForm::Words(vec![file.clone()]));
        }
        PythonValue::Document(file)
    }

    /// What a node is started with: a spawner or a publisher is told its description, a node of ros2_control only has to be seen.
    fn arguments_of(&mut self, range: TextRange, args: &PythonArgs) {
        let given = args.named.iter().find(|(name, _)| name == "arguments");
        let words = match given {
            Some((_, PythonValue::List(words))) => Some(words.iter().cloned()),
            _ => None,
        };
        let is_of = |program: &str| {
            args.named.iter().any(|(name, value)| {
                name.ends_with("executable")
                    && matches!(value, PythonValue::Text(text) if text.literal().as_deref() == Some(program))
            })
        };
        let command = |words| {
            let mut command = LaunchCommand::at(range, words, self.assumed.clone());
            if args.named.iter().any(|(name, _)| name == CONDITION) {
                command.assumed.push(CONDITION.to_owned());
            }
            command
        };
        if is_of(CONTROL_NODE) {
            let command = command(CommandForm::Words(Vec::new()));
            return command.add_to(&mut self.found.control_nodes);
        }
        let Some(words) = words else { return };
        let words = CommandForm::Words(words.map(PythonValue::written).collect());
        let command = command(words.clone());
        if is_of(TRANSFORM_PUBLISHER) {
            command.add_to(&mut self.found.transforms);
        } else if SPAWNERS.into_iter().any(is_of) {
            command.add_to(&mut self.found.spawners);
        } else {
            self.file(range, words.clone());
            self.load(range, words);
        }
    }

    /// The words of a command, or its text.
    fn words(&mut self, range: TextRange, words: Option<PythonValue>) {
        match words {
            Some(PythonValue::Text(line)) => self.record(
                range,
                CommandForm::Line(crate::launch::shell::in_text(line)),
            ),
            Some(PythonValue::List(words)) => {
                self.record(
                    range,
                    CommandForm::Words(words.into_iter().map(PythonValue::text).collect()),
                );
            }
            _ => {}
        }
    }

    fn defer(&mut self, mut args: PythonArgs) {
        let Some(PythonValue::Function(number)) = args.take(0, "function") else {
            return;
        };
        let positional = match args.take(usize::MAX, "args") {
            Some(PythonValue::List(values)) => values,
            None => Vec::new(),
            Some(_) => Vec::new(),
        };
        let mut named = match args.take(usize::MAX, "kwargs") {
            Some(PythonValue::Dict { pairs, .. }) => pairs,
            _ => Vec::new(),
        };
        named.push(("**".to_owned(), PythonValue::Unknown));
        // the context comes first
        let positional = std::iter::once(PythonValue::Unknown)
            .chain(positional)
            .collect();
        let frame = self.scopes.depth();
        self.deferred.push(Deferred {
            frame,
            number,
            args: positional,
            named,
        });
    }

    fn include(&mut self, range: TextRange, mut args: PythonArgs) {
        let is_conditional = args.named.iter().any(|(name, _)| name == CONDITION);
        let file = args.text(0, "launch_description_source");
        let (mut pairs, mut open) = (Vec::new(), args.open);
        if let Some(given) = args.take(1, "launch_arguments") {
            open |= PythonValue::spread(&mut pairs, given);
        }
        let given = pairs.iter().map(|(_, value)| value);
        let files: Vec<Text> = given
            .cloned()
            .map(PythonValue::text)
            .chain([file.clone()])
            .collect();
        self.file(range, CommandForm::Words(files));
        let args = pairs
            .into_iter()
            .map(|(name, value)| (name, value.text()))
            .collect();
        let mut assumed = self.assumed.clone();
        assumed.extend(is_conditional.then(|| CONDITION.to_owned()));
        self.found.includes.push(LaunchInclude {
            file,
            args,
            open,
            range,
            assumed,
        });
    }
}

fn is_xacro(path: &str) -> bool {
    path.split('.').any(|part| part == "xacro")
}

impl Text {
    /// This text, or another where this one is not known at all.
    fn or(self, other: impl FnOnce() -> Text) -> Text {
        if matches!(self.0.as_slice(), [crate::launch::text::TextPiece::Opaque]) {
            other()
        } else {
            self
        }
    }
}
