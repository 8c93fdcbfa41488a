//! What is known of the values of a program.

use ecow::EcoString;

use crate::launch::text::Text;

/// A value of a program, as far as its text says it.
#[derive(Clone, Debug, Default)]
pub(super) enum Value {
    /// Not known.
    #[default]
    Unknown,
    /// `None`
    None,
    /// A string or a substitution of the launch system.
    Text(Text),
    /// A number or truth value, as `str` writes it.
    Number(String),
    /// A list or tuple.
    List(Vec<Value>),
    /// A dictionary; `open` when it may hold further keys.
    Dict {
        pairs: Vec<(String, Value)>,
        open: bool,
    },
    /// A function of the file, by number.
    Function(usize),
    /// A name that the file does not define, with its module in front: `xacro.process_file`.
    Outer(EcoString),
    /// A method that is looked up in a value: `'a'.join`, `builder.robot_description`.
    Method(Box<Value>, EcoString),
    /// A description that was opened or parsed.
    Document(Text),
    /// A builder of MoveIt configurations, with the package that it reads.
    Builder(Text),
}

impl Value {
    /// Text that is written down.
    pub fn plain(text: impl Into<String>) -> Self {
        Value::Text(Text::plain(text, None))
    }

    /// The text that a string, substitution, or list of substitutions stands for.
    pub fn text(self) -> Text {
        match self {
            Value::Text(text) => text,
            Value::List(parts) => Text::concat(parts.into_iter().map(Value::text)),
            _ => Text::opaque(),
        }
    }

    /// The text that `str` makes of a value.
    pub fn written(self) -> Text {
        match self {
            Value::Text(text) => text,
            Value::Number(text) => Text::plain(text, None),
            _ => Text::opaque(),
        }
    }

    /// How much is held, for the limits.
    pub fn weight(&self) -> usize {
        1 + match self {
            Value::Text(text) | Value::Document(text) | Value::Builder(text) => {
                text.0.len() + text.len() / 64
            }
            Value::List(values) => values.iter().map(Value::weight).sum(),
            Value::Dict { pairs, .. } => pairs.iter().map(|(_, value)| value.weight() + 1).sum(),
            Value::Method(value, _) => value.weight(),
            _ => 0,
        }
    }

    /// The value behind a branch, of the values that its sides give.
    pub fn join(self, other: Value) -> Value {
        match (self, other) {
            (Value::Text(a), Value::Text(b)) if a == b => Value::Text(a),
            (Value::Number(a), Value::Number(b)) if a == b => Value::Number(a),
            (Value::Outer(a), Value::Outer(b)) if a == b => Value::Outer(a),
            (Value::Document(a), Value::Document(b)) if a == b => Value::Document(a),
            (Value::Builder(a), Value::Builder(b)) if a == b => Value::Builder(a),
            (Value::Function(a), Value::Function(b)) if a == b => Value::Function(a),
            (Value::None, Value::None) => Value::None,
            (Value::List(a), Value::List(b)) if a.len() == b.len() => {
                Value::List(a.into_iter().zip(b).map(|(a, b)| a.join(b)).collect())
            }
            (
                Value::Dict {
                    pairs: a,
                    open: open_a,
                },
                Value::Dict {
                    pairs: mut b,
                    open: open_b,
                },
            ) => {
                let mut open = open_a || open_b || a.len() != b.len();
                let mut pairs = Vec::new();
                for (name, value) in a {
                    match b.iter().position(|(other, _)| *other == name) {
                        Some(at) => {
                            let (_, other) = b.swap_remove(at);
                            pairs.push((name, value.join(other)));
                        }
                        None => open = true,
                    }
                }
                Value::Dict { pairs, open }
            }
            _ => Value::Unknown,
        }
    }

    /// A dictionary with an entry set.
    pub fn set(pairs: &mut Vec<(String, Value)>, name: String, value: Value) {
        match pairs.iter_mut().find(|(known, _)| *known == name) {
            Some((_, old)) => *old = value,
            None => pairs.push((name, value)),
        }
    }

    /// Put another dictionary over the pairs of one; whether it may hold further keys.
    pub fn spread(pairs: &mut Vec<(String, Value)>, other: Value) -> bool {
        match other {
            Value::Dict { pairs: new, open } => {
                new.into_iter()
                    .for_each(|(name, value)| Self::set(pairs, name, value));
                open
            }
            // pairs in tuples, as `launch_arguments` takes them
            Value::List(items) => {
                let mut open = false;
                for item in items {
                    match item {
                        Value::List(pair) if pair.len() == 2 => {
                            let mut pair = pair.into_iter();
                            let (name, value) = (pair.next(), pair.next());
                            match name.and_then(|name| name.text().literal()) {
                                Some(name) => Self::set(pairs, name, value.unwrap_or_default()),
                                None => open = true,
                            }
                        }
                        _ => open = true,
                    }
                }
                if open {
                    Self::forget(pairs);
                }
                open
            }
            Value::None => false,
            _ => {
                Self::forget(pairs);
                true
            }
        }
    }

    /// Values that further keys may have replaced are not known.
    pub fn forget(pairs: &mut [(String, Value)]) {
        for (_, value) in pairs {
            *value = Value::Unknown;
        }
    }
}
