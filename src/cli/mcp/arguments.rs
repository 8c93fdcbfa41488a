//! The arguments of a tool: what they are declared as, and the words of a command line that they become.

use std::path::Path;

use serde_json::{Map, Value, json};

use rules::consumers::{CONSUMERS, Consumer};
use vfs::{Environment, Vfs};

/// An argument of a tool.
pub(super) struct Parameter {
    pub(super) name: &'static str,
    pub(super) kind: ArgumentKind,
    pub(super) description: &'static str,
    pub(super) is_required: bool,
}

/// What an argument is, and how the command line has it.
#[derive(Clone, Copy, Debug)]
pub(super) enum ArgumentKind {
    /// A file or folder.
    Path,
    /// Files and folders.
    Paths,
    /// Arguments of the robot: an object whose values are texts, numbers or booleans.
    RobotArguments,
    /// A word.
    Word,
    /// Names, for an option that takes them with commas.
    Names(&'static str),
    /// Names of programs that read URDF, for the option `--for`.
    Consumers,
    /// One of these words, for an option.
    Choice(&'static str, &'static [&'static str]),
    /// Switches an option on.
    Flag(&'static str),
    /// An object of numbers or texts, for an option that takes `name=value`.
    Pairs(&'static str),
}

impl ArgumentKind {
    /// Whether it names what a command reads.
    pub(super) fn is_path(self) -> bool {
        matches!(self, Self::Path | Self::Paths)
    }
}

/// The names of all programs.
fn consumers() -> Vec<&'static str> {
    CONSUMERS.iter().map(|consumer| consumer.name).collect()
}

impl Parameter {
    /// Its JSON schema.
    pub(super) fn schema(&self) -> Value {
        let value = json!({ "type": ["string", "number", "boolean"] });
        let mut schema = match self.kind {
            ArgumentKind::Path | ArgumentKind::Word => json!({ "type": "string" }),
            ArgumentKind::Paths | ArgumentKind::Names(_) => {
                json!({ "type": "array", "items": { "type": "string" } })
            }
            ArgumentKind::RobotArguments | ArgumentKind::Pairs(_) => {
                json!({ "type": "object", "additionalProperties": value })
            }
            ArgumentKind::Consumers => {
                json!({ "type": "array", "items": { "type": "string", "enum": consumers() } })
            }
            ArgumentKind::Choice(_, words) => json!({ "type": "string", "enum": words }),
            ArgumentKind::Flag(_) => json!({ "type": "boolean" }),
        };
        if let Some(fields) = schema.as_object_mut() {
            fields.insert("description".into(), self.description.into());
        }
        schema
    }

    /// The words that a value becomes.
    ///
    /// # Errors
    /// When the value is of another kind, or names a file that may not be read.
    pub(super) fn words(&self, value: &Value, env: &Environment) -> Result<Vec<String>, String> {
        match self.kind {
            ArgumentKind::Word => Ok(vec![self.word(value)?]),
            ArgumentKind::Path => Ok(vec![self.path(value, env)?]),
            ArgumentKind::Paths => self
                .list(value)?
                .iter()
                .map(|value| self.path(value, env))
                .collect(),
            ArgumentKind::Names(option) => {
                let names: Result<Vec<String>, String> = self
                    .list(value)?
                    .iter()
                    .map(|value| self.word(value))
                    .collect();
                Ok(vec![format!("{option}={}", names?.join(","))])
            }
            ArgumentKind::Consumers => {
                let name = |value| {
                    let known = Consumer::named(&self.word(value)?);
                    let name = known.map(|consumer| consumer.name);
                    name.ok_or_else(|| {
                        self.wrong(&format!("names out of `{}`", consumers().join("`, `")))
                    })
                };
                let names: Result<Vec<&str>, String> = self.list(value)?.iter().map(name).collect();
                Ok(vec![format!("--for={}", names?.join(","))])
            }
            ArgumentKind::Choice(option, words) => match value.as_str() {
                Some(word) if words.contains(&word) => Ok(vec![format!("{option}={word}")]),
                _ => Err(self.wrong(&format!("one of `{}`", words.join("`, `")))),
            },
            ArgumentKind::Flag(option) => match value.as_bool() {
                Some(is_on) => Ok(is_on.then(|| option.to_owned()).into_iter().collect()),
                None => Err(self.wrong("true or false")),
            },
            ArgumentKind::RobotArguments => {
                let pair = |(name, value): (&String, &Value)| {
                    if name.starts_with('-') {
                        Err(self.wrong("an object whose names do not start with `-`"))
                    } else {
                        Ok(format!("{name}:={}", self.scalar(value)?))
                    }
                };
                self.object(value)?.iter().map(pair).collect()
            }
            ArgumentKind::Pairs(option) => {
                let pair = |(name, value): (&String, &Value)| {
                    Ok(format!("{option}={name}={}", self.scalar(value)?))
                };
                self.object(value)?.iter().map(pair).collect()
            }
        }
    }

    /// What is wrong with a value of another kind.
    fn wrong(&self, expected: &str) -> String {
        format!("argument `{}` must be {expected}", self.name)
    }

    /// A text that no command line takes for an option.
    fn word(&self, value: &Value) -> Result<String, String> {
        let word = value.as_str().filter(|word| !word.starts_with('-'));
        word.map(str::to_owned)
            .ok_or_else(|| self.wrong("text that does not start with `-`"))
    }

    fn list<'v>(&self, value: &'v Value) -> Result<&'v Vec<Value>, String> {
        value
            .as_array()
            .ok_or_else(|| self.wrong("an array of texts"))
    }

    fn object<'v>(&self, value: &'v Value) -> Result<&'v Map<String, Value>, String> {
        value.as_object().ok_or_else(|| self.wrong("an object"))
    }

    /// A path of a file or folder that may be read, as no command line takes it for something else.
    fn path(&self, value: &Value, env: &Environment) -> Result<String, String> {
        let path = value
            .as_str()
            .filter(|path| !path.is_empty() && !path.contains(":="))
            .ok_or_else(|| self.wrong("the path of a file or folder"))?;
        if !Vfs::of(env, 0).exists(Path::new(path)) {
            let folder = vfs::slashed(&env.cwd);
            return Err(format!(
                "cannot read `{path}`: it does not exist, or is outside of `{folder}`"
            ));
        }
        let is_plain = Path::new(path).is_absolute() || !path.starts_with('-');
        Ok(if is_plain {
            path.to_owned()
        } else {
            format!("./{path}")
        })
    }

    /// A value as a launch file would give it.
    fn scalar(&self, value: &Value) -> Result<String, String> {
        match value {
            Value::String(text) => Ok(text.clone()),
            Value::Number(_) | Value::Bool(_) => Ok(value.to_string()),
            _ => Err(format!(
                "argument `{}` must have texts, numbers or booleans as values",
                self.name
            )),
        }
    }
}
