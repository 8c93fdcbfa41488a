//! Attributes, items and methods of values.

use base::TextRange;
use ecow::EcoString;

use super::PythonReader;
use super::value::PythonValue;
use crate::launch::CommandForm;
use crate::launch::text::Text;

/// `value.name`
pub(super) fn attribute(value: PythonValue, name: &EcoString) -> PythonValue {
    match value {
        PythonValue::Outer(module) => PythonValue::Outer(format!("{module}.{name}").into()),
        PythonValue::Text(text) if name == "parent" => PythonValue::Text(parent(&text)),
        PythonValue::Text(text) if name == "parents" => {
            PythonValue::Method(Box::new(PythonValue::Text(text)), name.clone())
        }
        PythonValue::Text(_)
        | PythonValue::List(_)
        | PythonValue::Dict { .. }
        | PythonValue::Builder(_)
        | PythonValue::Document(_) => PythonValue::Method(Box::new(value), name.clone()),
        // of the context that a function is called with
        _ if matches!(
            name.as_str(),
            "launch_configurations" | "perform_substitution"
        ) =>
        {
            PythonValue::Outer(name.clone())
        }
        _ => PythonValue::Unknown,
    }
}

/// `value[index]`
pub(super) fn item(value: PythonValue, index: &PythonValue) -> PythonValue {
    let key = match index {
        PythonValue::Text(text) => text.literal(),
        PythonValue::Number(number) => Some(number.clone()),
        _ => None,
    };
    match (value, key) {
        (PythonValue::Outer(name), Some(key)) if name.ends_with("launch_configurations") => {
            PythonValue::Text(Text::argument(&key))
        }
        (PythonValue::Dict { pairs, open: _ }, Some(key)) => {
            // a key that is there was not replaced by what else the dictionary may hold: that is forgotten at once
            pairs
                .into_iter()
                .find(|(name, _)| *name == key)
                .map(|(_, value)| value)
                .unwrap_or_default()
        }
        (PythonValue::List(values), Some(key)) => {
            let at = key.parse::<usize>().ok();
            at.and_then(|at| values.into_iter().nth(at))
                .unwrap_or_default()
        }
        (PythonValue::Method(text, name), Some(key)) if name == "parents" => {
            match (*text, key.parse::<usize>()) {
                (PythonValue::Text(text), Ok(count)) if count < 20 => {
                    PythonValue::Text((0..=count).fold(text, |path, _| parent(&path)))
                }
                _ => PythonValue::Unknown,
            }
        }
        _ => PythonValue::Unknown,
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
pub(super) fn percent(format: PythonValue, values: PythonValue) -> PythonValue {
    let Some(format) = format.text().literal() else {
        return PythonValue::Unknown;
    };
    let mut values = match values {
        PythonValue::List(values) => values,
        one => vec![one],
    }
    .into_iter();
    let mut parts = format.split('%');
    let mut text = Text::plain(parts.next().unwrap_or(""), None);
    for part in parts {
        let (Some(rest), Some(value)) = (part.strip_prefix('s'), values.next()) else {
            return PythonValue::Unknown;
        };
        text.push(value.written());
        text.push(Text::plain(rest, None));
    }
    PythonValue::Text(text)
}

/// `'{} {name}'.format(...)`
fn format(pattern: &str, args: &[PythonValue], named: &[(String, PythonValue)]) -> Option<Text> {
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

impl PythonReader<'_> {
    /// A call of a method.
    pub(super) fn method(
        &mut self,
        range: TextRange,
        value: PythonValue,
        name: &str,
        args: Vec<PythonValue>,
        named: Vec<(String, PythonValue)>,
    ) -> PythonValue {
        match (value, name) {
            (
                PythonValue::Text(text),
                "perform" | "as_posix" | "absolute" | "resolve" | "__str__",
            ) => PythonValue::Text(text),
            // `FindPackageShare('arm').find('arm')`
            (PythonValue::Text(text), "find") => match args.into_iter().next() {
                Some(PythonValue::Text(name)) if text == Text::share(name.clone()) => {
                    PythonValue::Text(text)
                }
                _ => PythonValue::Text(Text::opaque()),
            },
            (PythonValue::Text(text), "format") => {
                let made = text
                    .literal()
                    .and_then(|pattern| format(&pattern, &args, &named));
                made.map_or(PythonValue::Unknown, PythonValue::Text)
            }
            (PythonValue::Text(text), "joinpath") => PythonValue::Text(Text::joined(
                std::iter::once(text).chain(args.into_iter().map(PythonValue::text)),
            )),
            (PythonValue::Text(text), "join") => match (text.literal(), args.into_iter().next()) {
                (Some(between), Some(PythonValue::List(items))) => {
                    let items = items.into_iter().map(PythonValue::written).enumerate();
                    PythonValue::Text(Text::concat(items.flat_map(|(number, item)| {
                        let lead = if number > 0 { &*between } else { "" };
                        [Text::plain(lead, None), item]
                    })))
                }
                _ => PythonValue::Unknown,
            },
            (PythonValue::Text(text), "lower" | "upper" | "strip") => {
                let changed = text.literal().map(|text| match name {
                    "lower" => text.to_lowercase(),
                    "upper" => text.to_uppercase(),
                    _ => text.trim().to_owned(),
                });
                changed
                    .filter(|_| args.is_empty())
                    .map_or(PythonValue::Unknown, PythonValue::plain)
            }
            (PythonValue::Text(text), "open") => self.opened(range, text, args.into_iter().next()),
            (PythonValue::Text(text), "read_text" | "read_bytes") => self.opened(range, text, None),
            (value @ PythonValue::Dict { .. }, "items" | "copy")
            | (value @ PythonValue::List(_), "copy") => value,
            (PythonValue::Dict { pairs, .. }, "get") => {
                let key = args.first().cloned().and_then(|key| key.text().literal());
                let value = key.and_then(|key| pairs.into_iter().find(|(name, _)| *name == key));
                value.map(|(_, value)| value).unwrap_or_default()
            }
            (PythonValue::Builder(package), "robot_description" | "robot_description_semantic") => {
                self.built_description(range, &package, args, named);
                PythonValue::Builder(package)
            }
            (PythonValue::Builder(package), _) => PythonValue::Builder(package),
            _ => PythonValue::Unknown,
        }
    }

    /// `MoveItConfigsBuilder(...).robot_description(file_path=..., mappings=...)`, and the same with the SRDF.
    fn built_description(
        &mut self,
        range: TextRange,
        package: &Text,
        args: Vec<PythonValue>,
        named: Vec<(String, PythonValue)>,
    ) {
        let mut given = super::builtins::PythonArgs::new(args, named);
        let file = given.take(0, "file_path");
        let mappings = given.take(1, "mappings");
        let file = match file {
            Some(PythonValue::Text(path)) => Text::joined([Text::share(package.clone()), path]),
            _ => Text::opaque(),
        };
        self.process(range, file, mappings, given.open);
    }

    /// A robot that is made with mappings.
    pub(super) fn process(
        &mut self,
        range: TextRange,
        file: Text,
        mappings: Option<PythonValue>,
        open: bool,
    ) {
        let (mappings, is_open) = match mappings {
            Some(PythonValue::Dict { pairs, open }) => (Self::given(pairs), open),
            None | Some(PythonValue::None) => (Vec::new(), open),
            Some(_) => (Vec::new(), true),
        };
        self.record(
            range,
            CommandForm::Process {
                file,
                mappings,
                open: open || is_open,
            },
        );
    }
}
