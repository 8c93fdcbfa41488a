//! The tools: which command each runs, and what may be asked of it.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Map, Value, json};

use super::super::io::Io;
use super::super::picture;
use super::arguments::{ArgumentKind, Parameter};
use vfs::Environment;

/// Most bytes of an answer: what reads it has to hold all of it at once.
const MOST_BYTES: usize = 400_000;

/// A command that only reads.
pub(super) struct Tool {
    pub(super) name: &'static str,
    description: &'static str,
    /// The words of the command line that are always the same.
    command: &'static [&'static str],
    parameters: &'static [Parameter],
    /// Whether the answer is a picture, and not what the command prints.
    is_picture: bool,
}

const fn required(name: &'static str, kind: ArgumentKind, description: &'static str) -> Parameter {
    Parameter {
        name,
        kind,
        description,
        is_required: true,
    }
}

const fn optional(name: &'static str, kind: ArgumentKind, description: &'static str) -> Parameter {
    Parameter {
        is_required: false,
        ..required(name, kind, description)
    }
}

const FILE: Parameter = required(
    "file",
    ArgumentKind::Path,
    "The xacro or URDF file, relative to the folder of the server",
);
const PATHS: Parameter = optional(
    "paths",
    ArgumentKind::Paths,
    "Files and folders, relative to the folder of the server; default: all of it",
);
const ARGS: Parameter = optional(
    "args",
    ArgumentKind::RobotArguments,
    "Arguments of the robot by name, as in name:=value",
);
const SELECT: Parameter = optional(
    "select",
    ArgumentKind::Names("--select"),
    "Only these rules, by code or name",
);
const CONSUMERS: Parameter = optional(
    "for",
    ArgumentKind::Consumers,
    "Programs that will read the robot, such as gazebo, mujoco, drake",
);

/// All tools.
pub(super) const TOOLS: &[Tool] = &[
    Tool {
        name: "check",
        description: "Find defects in robot descriptions. Returns a JSON array: rule, severity, message, place, help and \
                      fix of each finding, at the source text that caused it, behind macros and includes too. Also \
                      checks launch files, SRDF and controller settings beside the robots.",
        command: &["check", "--format=json", "--exit-zero"],
        parameters: &[PATHS, ARGS, SELECT, CONSUMERS],
        is_picture: false,
    },
    Tool {
        name: "explain",
        description: "The page of a rule: what it means, an example, and how to correct it.",
        command: &["explain"],
        parameters: &[required(
            "rule",
            ArgumentKind::Word,
            "Code or name of the rule",
        )],
        is_picture: false,
    },
    Tool {
        name: "fix_diff",
        description: "The changes that the fixes of findings would make, as a patch. Nothing is written.",
        command: &["fix", "--diff", "--exit-zero"],
        parameters: &[
            PATHS,
            SELECT,
            optional(
                "unsafe_fixes",
                ArgumentKind::Flag("--unsafe-fixes"),
                "Include fixes that may change numbers or names; show those to a person first",
            ),
        ],
        is_picture: false,
    },
    Tool {
        name: "expand",
        description: "The URDF that xacro makes of a file.",
        command: &["expand"],
        parameters: &[FILE, ARGS],
        is_picture: false,
    },
    Tool {
        name: "tree",
        description: "The tree of links and joints of a robot, as JSON.",
        command: &["tree", "--format=json"],
        parameters: &[FILE, ARGS],
        is_picture: false,
    },
    Tool {
        name: "consumers",
        description: "What the programs that read URDF (RViz, MoveIt, Gazebo, MuJoCo, Drake and others) reject, change or \
                      ignore of a robot.",
        command: &["consumers", "--format=json"],
        parameters: &[FILE, ARGS, CONSUMERS],
        is_picture: false,
    },
    Tool {
        name: "render",
        description: "A picture of a robot.",
        command: &["render", "--output=picture.png"],
        parameters: &[
            FILE,
            ARGS,
            optional(
                "view",
                ArgumentKind::Choice("--view", &["iso", "front", "side", "top"]),
                "Where the robot is seen from; default: iso",
            ),
            optional(
                "frames",
                ArgumentKind::Flag("--frames"),
                "Also draw the frames of links",
            ),
            optional(
                "collision",
                ArgumentKind::Flag("--collision"),
                "Draw collision instead of visual geometry",
            ),
            optional(
                "joints",
                ArgumentKind::Pairs("--joint"),
                "Positions of joints by name: radians, degrees as \"90deg\", meters",
            ),
        ],
        is_picture: true,
    },
];

impl Tool {
    /// What `tools/list` says of it.
    pub(super) fn declaration(&self) -> Value {
        let properties = self.parameters.iter();
        let properties: Map<String, Value> = properties
            .map(|own| (own.name.to_owned(), own.schema()))
            .collect();
        let required = self.parameters.iter().filter(|own| own.is_required);
        let required: Vec<&str> = required.map(|own| own.name).collect();
        json!({
            "name": self.name,
            "description": self.description,
            "inputSchema": {
                "type": "object",
                "properties": properties,
                "required": required,
                "additionalProperties": false,
            },
            "annotations": { "readOnlyHint": true, "openWorldHint": false },
        })
    }

    /// The command line of a call.
    ///
    /// # Errors
    /// What is wrong with the arguments, for who asked.
    pub(super) fn command_line(
        &self,
        arguments: Option<&Value>,
        env: &Environment,
        package_path: &[String],
    ) -> Result<Vec<String>, String> {
        let none = Map::new();
        let given = match arguments {
            None | Some(Value::Null) => &none,
            Some(Value::Object(given)) => given,
            Some(_) => return Err("arguments must be an object".into()),
        };
        let names: Vec<&str> = self.parameters.iter().map(|own| own.name).collect();
        if let Some(unknown) = given.keys().find(|name| !names.contains(&name.as_str())) {
            return Err(format!(
                "unknown argument `{unknown}` of `{}`: it has `{}`",
                self.name,
                names.join("`, `")
            ));
        }
        let mut words: Vec<String> = self.command.iter().map(|&word| word.to_owned()).collect();
        for own in self.parameters {
            match given.get(own.name) {
                Some(value) => words.extend(own.words(value, env)?),
                None if own.is_required => {
                    return Err(format!(
                        "argument `{}` of `{}` is missing",
                        own.name, self.name
                    ));
                }
                None => {}
            }
        }
        let reads_robots = self.parameters.iter().any(|own| own.kind.is_path());
        if reads_robots {
            words.extend(
                package_path
                    .iter()
                    .map(|path| format!("--package-path={path}")),
            );
        }
        Ok(words)
    }

    /// Run the command: what it prints as the content of an answer.
    ///
    /// # Errors
    /// What it says when it cannot be carried out.
    pub(super) fn run(&self, words: &[String], env: &Environment) -> Result<Vec<Value>, String> {
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let mut nothing = std::io::empty();
        let mut io = Io::plain(&mut out, &mut err, &mut nothing);
        io.is_read = false;
        let mut content = Vec::new();
        let code = if self.is_picture {
            let (code, picture) = picture::drawn(words, env, &mut io);
            content.extend(picture.map(|png| {
                json!({ "type": "image", "data": STANDARD.encode(png), "mimeType": "image/png" })
            }));
            code
        } else {
            super::super::run(words, env, &mut io)
        };
        let (out, err) = (String::from_utf8_lossy(&out), String::from_utf8_lossy(&err));
        if out.len() > MOST_BYTES {
            return Err(format!(
                "the answer has {} kB, more than {} kB: name fewer files, or select rules",
                out.len() / 1000,
                MOST_BYTES / 1000
            ));
        }
        let texts = [out.trim_end(), err.trim_end()];
        let texts = texts.iter().filter(|text| !text.is_empty());
        if code > 1 || code == 1 && content.is_empty() && out.is_empty() {
            let texts: Vec<&str> = texts.copied().collect();
            return Err(texts.join("\n"));
        }
        content.extend(texts.map(|said| text(said)));
        Ok(content)
    }
}

/// A text of an answer.
pub(super) fn text(said: &str) -> Value {
    json!({ "type": "text", "text": said })
}
