//! Attributes, items and methods of values.

use base::TextRange;
use ecow::EcoString;

use super::Reader;
use super::value::Value;
use crate::launch::What;
use crate::launch::text::Text;

/// `value.name`
pub(super) fn attribute(value: Value, name: &EcoString) -> Value {
    match value {
        Value::Outer(module) => Value::Outer(format!("{module}.{name}").into()),
        Value::Text(text) if name == "parent" => Value::Text(parent(&text)),
        Value::Text(text) if name == "parents" => {
            Value::Method(Box::new(Value::Text(text)), name.clone())
        }
        Value::Text(_)
        | Value::List(_)
        | Value::Dict { .. }
        | Value::Builder(_)
        | Value::Document(_) => Value::Method(Box::new(value), name.clone()),
        // of the context that a function is called with
        _ if matches!(
            name.as_str(),
            "launch_configurations" | "perform_substitution"
        ) =>
        {
            Value::Outer(name.clone())
        }
        _ => Value::Unknown,
    }
}

/// `value[index]`
pub(super) fn item(value: Value, index: &Value) -> Value {
    let key = match index {
        Value::Text(text) => text.literal(),
        Value::Number(number) => Some(number.clone()),
        _ => None,
    };
    match (value, key) {
        (Value::Outer(name), Some(key)) if name.ends_with("launch_configurations") => {
            Value::Text(Text::argument(&key))
        }
        (Value::Dict { pairs, open: _ }, Some(key)) => {
            // a key that is there was not replaced by what else the dictionary may hold: that is forgotten at once
            pairs
                .into_iter()
                .find(|(name, _)| *name == key)
                .map(|(_, value)| value)
                .unwrap_or_default()
        }
        (Value::List(values), Some(key)) => {
            let at = key.parse::<usize>().ok();
            at.and_then(|at| values.into_iter().nth(at))
                .unwrap_or_default()
        }
        (Value::Method(text, name), Some(key)) if name == "parents" => {
            match (*text, key.parse::<usize>()) {
                (Value::Text(text), Ok(count)) if count < 20 => {
                    Value::Text((0..=count).fold(text, |path, _| parent(&path)))
                }
                _ => Value::Unknown,
            }
        }
        _ => Value::Unknown,
    }
}

/// The folder around a path.
pub(super) fn parent(path: &Text) -> Text {
    match path.literal() {
        Some(path) => Text::plain(
            path.trim_end_matches('/')
                .rsplit_once('/')
                .map_or("", |(up, _)| up),
            None,
        ),
        None => Text::opaque(),
    }
}

/// `'%s' % value`
pub(super) fn percent(format: Value, values: Value) -> Value {
    let Some(format) = format.text().literal() else {
        return Value::Unknown;
    };
    let mut values = match values {
        Value::List(values) => values,
        one => vec![one],
    }
    .into_iter();
    let mut parts = format.split('%');
    let mut text = Text::plain(parts.next().unwrap_or(""), None);
    for part in parts {
        let (Some(rest), Some(value)) = (part.strip_prefix('s'), values.next()) else {
            return Value::Unknown;
        };
        text.push(value.written());
        text.push(Text::plain(rest, None));
    }
    Value::Text(text)
}

/// `'{} {name}'.format(...)`
fn format(pattern: &str, args: &[Value], named: &[(String, Value)]) -> Option<Text> {
    let mut parts = pattern.split('{');
    let mut text = Text::plain(parts.next()?, None);
    for (number, part) in parts.enumerate() {
        let (field, rest) = part.split_once('}')?;
        let value = match field {
            "" => args.get(number),
            field => match field.parse::<usize>() {
                Ok(at) => args.get(at),
                Err(_) => named
                    .iter()
                    .find(|(name, _)| name == field)
                    .map(|(_, value)| value),
            },
        };
        text.push(value?.clone().written());
        text.push(Text::plain(rest, None));
    }
    (!pattern.contains("{{") && !pattern.contains("}}")).then_some(text)
}

impl Reader<'_> {
    /// A call of a method.
    pub(super) fn method(
        &mut self,
        range: TextRange,
        value: Value,
        name: &str,
        args: Vec<Value>,
        named: Vec<(String, Value)>,
    ) -> Value {
        match (value, name) {
            (Value::Text(text), "perform" | "as_posix" | "absolute" | "resolve" | "__str__") => {
                Value::Text(text)
            }
            // `FindPackageShare('arm').find('arm')`
            (Value::Text(text), "find") => match args.into_iter().next() {
                Some(Value::Text(name)) if text == Text::share(name.clone()) => Value::Text(text),
                _ => Value::Text(Text::opaque()),
            },
            (Value::Text(text), "format") => {
                let made = text
                    .literal()
                    .and_then(|pattern| format(&pattern, &args, &named));
                made.map_or(Value::Unknown, Value::Text)
            }
            (Value::Text(text), "joinpath") => Value::Text(Text::joined(
                std::iter::once(text).chain(args.into_iter().map(Value::text)),
            )),
            (Value::Text(text), "join") => match (text.literal(), args.into_iter().next()) {
                (Some(between), Some(Value::List(items))) => {
                    let items = items.into_iter().map(Value::written).enumerate();
                    Value::Text(Text::concat(items.flat_map(|(number, item)| {
                        let lead = if number > 0 { &*between } else { "" };
                        [Text::plain(lead, None), item]
                    })))
                }
                _ => Value::Unknown,
            },
            (Value::Text(text), "lower" | "upper" | "strip") => {
                let changed = text.literal().map(|text| match name {
                    "lower" => text.to_lowercase(),
                    "upper" => text.to_uppercase(),
                    _ => text.trim().to_owned(),
                });
                changed
                    .filter(|_| args.is_empty())
                    .map_or(Value::Unknown, Value::plain)
            }
            (Value::Text(text), "open") => Value::Document(text),
            (value @ Value::Dict { .. }, "items" | "copy") | (value @ Value::List(_), "copy") => {
                value
            }
            (Value::Dict { pairs, .. }, "get") => {
                let key = args.first().cloned().and_then(|key| key.text().literal());
                let value = key.and_then(|key| pairs.into_iter().find(|(name, _)| *name == key));
                value.map(|(_, value)| value).unwrap_or_default()
            }
            (Value::Builder(package), "robot_description" | "robot_description_semantic") => {
                self.built_description(range, &package, args, named);
                Value::Builder(package)
            }
            (Value::Builder(package), _) => Value::Builder(package),
            _ => Value::Unknown,
        }
    }

    /// `MoveItConfigsBuilder(...).robot_description(file_path=..., mappings=...)`, and the same with the SRDF.
    fn built_description(
        &mut self,
        range: TextRange,
        package: &Text,
        args: Vec<Value>,
        named: Vec<(String, Value)>,
    ) {
        let mut given = super::builtins::Args::new(args, named);
        let file = given.take(0, "file_path");
        let mappings = given.take(1, "mappings");
        let file = match file {
            Some(Value::Text(path)) => Text::joined([Text::share(package.clone()), path]),
            _ => Text::opaque(),
        };
        self.process(range, file, mappings, given.open);
    }

    /// A robot that is made with mappings.
    pub(super) fn process(
        &mut self,
        range: TextRange,
        file: Text,
        mappings: Option<Value>,
        open: bool,
    ) {
        let (mappings, is_open) = match mappings {
            Some(Value::Dict { pairs, open }) => (Self::given(pairs), open),
            None | Some(Value::None) => (Vec::new(), open),
            Some(_) => (Vec::new(), true),
        };
        self.record(
            range,
            What::Process {
                file,
                mappings,
                open: open || is_open,
            },
        );
    }
}
