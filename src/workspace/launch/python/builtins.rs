//! Functions and classes that a launch file imports.

use base::TextRange;
use base::limits::LAUNCH_CALLS;

use super::methods::parent;
use super::value::Value;
use super::{Deferred, Reader};
use crate::launch::text::Text;
use crate::launch::{Declared, Include, What};

/// The arguments of a call.
pub(super) struct Args {
    positional: Vec<Option<Value>>,
    named: Vec<(String, Value)>,
    /// Whether there may be further ones.
    pub open: bool,
}

impl Args {
    pub fn new(positional: Vec<Value>, named: Vec<(String, Value)>) -> Self {
        let open = named.iter().any(|(name, _)| name == "**");
        Self {
            positional: positional.into_iter().map(Some).collect(),
            named,
            open,
        }
    }

    /// The argument at a place or of a name.
    pub fn take(&mut self, at: usize, name: &str) -> Option<Value> {
        let named = self.named.iter().position(|(known, _)| known == name);
        match named {
            Some(number) => Some(self.named.swap_remove(number).1),
            None => self.positional.get_mut(at).and_then(Option::take),
        }
    }

    fn text(&mut self, at: usize, name: &str) -> Text {
        self.take(at, name).map_or_else(Text::opaque, Value::text)
    }
}

impl Reader<'_> {
    /// A call of something that the file does not define.
    pub(super) fn outer(
        &mut self,
        range: TextRange,
        path: &str,
        args: Vec<Value>,
        named: Vec<(String, Value)>,
    ) -> Value {
        let count = args.len();
        let mut args = Args::new(args, named);
        let name = path.rsplit('.').next().unwrap_or(path);
        match name {
            "LaunchConfiguration" => self.configuration(args),
            "get" if path.contains("launch_configurations") => {
                match args.text(0, "key").literal() {
                    Some(name) if count == 1 => Value::Text(Text::argument(&name)),
                    _ => Value::Unknown,
                }
            }
            "perform_substitution" => Value::Text(args.text(0, "substitution")),
            "perform_substitutions" => Value::Text(args.text(1, "subs")),
            "normalize_to_list_of_substitutions" => Value::Text(args.text(0, "subs")),
            "DeclareLaunchArgument" => self.declare(range, args),
            "SetLaunchConfiguration" => {
                if let Some(name) = args.text(0, "name").literal() {
                    self.found.set.push(name);
                }
                Value::Unknown
            }
            "get_package_share_directory" | "get_package_share_path" | "FindPackageShare" => {
                Value::Text(Text::share(
                    args.text(0, "package_name").or(|| args.text(0, "package")),
                ))
            }
            "get_package_prefix" | "FindPackagePrefix" | "FindPackage" => {
                Value::Text(Text::opaque())
            }
            "PathJoinSubstitution" => match args.take(0, "substitutions") {
                Some(Value::List(steps)) => {
                    Value::Text(Text::joined(steps.into_iter().map(Value::text)))
                }
                _ => Value::Text(Text::opaque()),
            },
            "join" if path.ends_with("path.join") => {
                let steps = args.positional.into_iter().flatten().map(Value::text);
                Value::Text(Text::joined(steps.collect::<Vec<_>>()))
            }
            "Path" | "PurePath" | "PathSubstitution" if count == 1 => {
                Value::Text(args.text(0, "path"))
            }
            "Path" | "PurePath" => {
                let steps = args.positional.into_iter().flatten().map(Value::text);
                Value::Text(Text::joined(steps.collect::<Vec<_>>()))
            }
            "dirname" => Value::Text(parent(&args.text(0, "p"))),
            "abspath" | "realpath" | "normpath" | "expanduser" => Value::Text(args.text(0, "path")),
            "TextSubstitution" | "StringJoinSubstitution" => match args.take(0, "text") {
                Some(Value::Text(text)) => Value::Text(text),
                _ => Value::Text(Text::opaque()),
            },
            "str" if count == 1 => {
                Value::Text(args.take(0, "object").unwrap_or_default().written())
            }
            "dict" => {
                let (mut pairs, mut open) = (Vec::new(), args.open);
                if let Some(base) = args.take(0, "**") {
                    open |= Value::spread(&mut pairs, base);
                }
                let named = args.named.into_iter().filter(|(name, _)| name != "**");
                named.for_each(|(name, value)| Value::set(&mut pairs, name, value));
                Value::Dict { pairs, open }
            }
            "list" | "tuple" | "deepcopy" | "copy" if count == 1 => {
                args.take(0, "x").unwrap_or_default()
            }
            "FindExecutable" => match args.text(0, "name").literal() {
                Some(name) => Value::plain(name),
                None => Value::Text(Text::opaque()),
            },
            "Command" => {
                self.command(range, &mut args);
                Value::Unknown
            }
            "ExecuteProcess" | "run" | "Popen" | "check_output" | "check_call" | "call"
            | "getoutput" | "system" | "popen" => {
                let words = args.take(0, "cmd").or_else(|| args.take(0, "args"));
                self.words(range, words);
                Value::Unknown
            }
            "OpaqueFunction" => {
                self.defer(args);
                Value::Unknown
            }
            "IncludeLaunchDescription" => {
                self.include(range, args);
                Value::Unknown
            }
            "PythonLaunchDescriptionSource"
            | "XMLLaunchDescriptionSource"
            | "YAMLLaunchDescriptionSource"
            | "AnyLaunchDescriptionSource"
            | "FrontendLaunchDescriptionSource" => Value::Text(args.text(0, "launch_file_path")),
            "open" => Value::Document(args.text(0, "file")),
            "MoveItConfigsBuilder" => {
                let robot = args.text(0, "robot_name");
                match args
                    .take(2, "package_name")
                    .or_else(|| args.take(1, "package"))
                {
                    Some(Value::Text(package)) => Value::Builder(package),
                    Some(_) => Value::Builder(Text::opaque()),
                    None => {
                        Value::Builder(Text::concat([robot, Text::plain("_moveit_config", None)]))
                    }
                }
            }
            "process_file" | "process" if is_xacro(path) => {
                let file = args
                    .take(0, "input_file_name")
                    .map_or_else(Text::opaque, Value::text);
                let mappings = args.take(usize::MAX, "mappings");
                self.process(range, file, mappings, args.open);
                Value::Unknown
            }
            "parse" if is_xacro(path) => match (args.take(0, "inp"), args.take(1, "filename")) {
                (Some(Value::Document(file)), _) => Value::Document(file),
                (_, Some(Value::Text(file))) => Value::Document(file),
                _ => Value::Document(Text::opaque()),
            },
            "process_doc" if is_xacro(path) => {
                let file = match args.take(0, "doc") {
                    Some(Value::Document(file)) => file,
                    _ => Text::opaque(),
                };
                let mappings = args.take(usize::MAX, "mappings");
                self.process(range, file, mappings, args.open);
                Value::Unknown
            }
            _ => Value::Unknown,
        }
    }

    /// `LaunchConfiguration(name, default=...)`
    fn configuration(&mut self, mut args: Args) -> Value {
        let Some(name) = args.text(0, "variable_name").literal() else {
            return Value::Text(Text::opaque());
        };
        if let Some(default) = args
            .take(usize::MAX, "default")
            .filter(|_| self.found.defaults.len() < LAUNCH_CALLS)
        {
            let default = if let Value::None = default {
                Text::opaque()
            } else {
                default.text()
            };
            self.found.defaults.push((name.clone(), default));
        }
        Value::Text(Text::argument(&name))
    }

    fn declare(&mut self, range: TextRange, mut args: Args) -> Value {
        let Some(name) = args.text(0, "name").literal() else {
            return Value::Unknown;
        };
        let default = args.take(usize::MAX, "default_value");
        let choices = match args.take(usize::MAX, "choices") {
            Some(Value::List(values)) => values
                .into_iter()
                .map(|value| value.text().literal())
                .collect(),
            _ => None,
        };
        let is_open = args.open;
        let default = match default {
            None | Some(Value::None) if is_open => Some(Text::opaque()),
            None | Some(Value::None) => None,
            Some(value) => Some(value.text()),
        };
        self.found.declared.push(Declared {
            name,
            default,
            choices,
            range,
            is_fixed: false,
        });
        Value::Unknown
    }

    /// `Command([...])`: one text, split as a shell does.
    fn command(&mut self, range: TextRange, args: &mut Args) {
        let line = match args.take(0, "command") {
            Some(value @ (Value::Text(_) | Value::List(_))) => value.text(),
            _ => return,
        };
        self.record(range, What::Line(line));
    }

    /// The words of a command, or its text.
    fn words(&mut self, range: TextRange, words: Option<Value>) {
        match words {
            Some(Value::Text(line)) => {
                self.record(range, What::Line(crate::launch::shell::in_text(line)))
            }
            Some(Value::List(words)) => {
                self.record(
                    range,
                    What::Words(words.into_iter().map(Value::text).collect()),
                );
            }
            _ => {}
        }
    }

    fn defer(&mut self, mut args: Args) {
        let Some(Value::Function(number)) = args.take(0, "function") else {
            return;
        };
        let positional = match args.take(usize::MAX, "args") {
            Some(Value::List(values)) => values,
            None => Vec::new(),
            Some(_) => Vec::new(),
        };
        let mut named = match args.take(usize::MAX, "kwargs") {
            Some(Value::Dict { pairs, .. }) => pairs,
            _ => Vec::new(),
        };
        named.push(("**".to_owned(), Value::Unknown));
        // the context comes first
        let positional = std::iter::once(Value::Unknown).chain(positional).collect();
        let frame = self.scopes.depth();
        self.deferred.push(Deferred {
            frame,
            number,
            args: positional,
            named,
        });
    }

    fn include(&mut self, range: TextRange, mut args: Args) {
        let file = args.text(0, "launch_description_source");
        let (mut pairs, mut open) = (Vec::new(), args.open);
        if let Some(given) = args.take(1, "launch_arguments") {
            open |= Value::spread(&mut pairs, given);
        }
        let args = pairs
            .into_iter()
            .map(|(name, value)| (name, value.text()))
            .collect();
        self.found.includes.push(Include {
            file,
            args,
            open,
            range,
            assumed: self.assumed.clone(),
        });
    }
}

fn is_xacro(path: &str) -> bool {
    path.split('.').any(|part| part == "xacro")
}

impl Text {
    /// This text, or another where this one is not known at all.
    fn or(self, other: impl FnOnce() -> Text) -> Text {
        if matches!(self.0.as_slice(), [crate::launch::text::Piece::Opaque]) {
            other()
        } else {
            self
        }
    }
}
