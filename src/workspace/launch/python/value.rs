//! What is known of the values of a program.

use ecow::EcoString;

use crate::launch::text::Text;

/// A value of a program, as far as its text says it.
#[derive(Clone, Debug, Default)]
pub(super) enum PythonValue {
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
    List(Vec<PythonValue>),
    /// A dictionary; `open` when it may hold further keys.
    Dict {
        pairs: Vec<(String, PythonValue)>,
        open: bool,
    },
    /// A function of the file, by number.
    Function(usize),
    /// A name that the file does not define, with its module in front: `xacro.process_file`.
    Outer(EcoString),
    /// A method that is looked up in a value: `'a'.join`, `builder.robot_description`.
    Method(Box<PythonValue>, EcoString),
    /// A description that was opened or parsed.
    Document(Text),
    /// A builder of MoveIt configurations, with the package that it reads.
    Builder(Text),
    /// What a command of the file prints, by number.
    Output(usize),
}

impl PythonValue {
    /// Text that is written down.
    pub fn plain(text: impl Into<String>) -> Self {
        PythonValue::Text(Text::plain(text, None))
    }

    /// The text that a string, substitution, or list of substitutions stands for.
    pub fn text(self) -> Text {
        match self {
            PythonValue::Text(text) => text,
            PythonValue::List(parts) => Text::concat(parts.into_iter().map(PythonValue::text)),
            _ => Text::opaque(),
        }
    }

    /// The text that `str` makes of a value.
    pub fn written(self) -> Text {
        match self {
            PythonValue::Text(text) => text,
            PythonValue::Number(text) => Text::plain(text, None),
            _ => Text::opaque(),
        }
    }

    /// How much is held, for the limits.
    pub fn weight(&self) -> usize {
        1 + match self {
            PythonValue::Text(text) | PythonValue::Document(text) | PythonValue::Builder(text) => {
                text.0.len() + text.len() / 64
            }
            PythonValue::List(values) => values.iter().map(PythonValue::weight).sum(),
            PythonValue::Dict { pairs, .. } => {
                pairs.iter().map(|(_, value)| value.weight() + 1).sum()
            }
            PythonValue::Method(value, _) => value.weight(),
            _ => 0,
        }
    }

    /// The value behind a branch, of the values that its sides give.
    pub fn join(self, other: PythonValue) -> PythonValue {
        match (self, other) {
            (PythonValue::Text(a), PythonValue::Text(b)) if a == b => PythonValue::Text(a),
            (PythonValue::Number(a), PythonValue::Number(b)) if a == b => PythonValue::Number(a),
            (PythonValue::Outer(a), PythonValue::Outer(b)) if a == b => PythonValue::Outer(a),
            (PythonValue::Document(a), PythonValue::Document(b)) if a == b => {
                PythonValue::Document(a)
            }
            (PythonValue::Builder(a), PythonValue::Builder(b)) if a == b => PythonValue::Builder(a),
            (PythonValue::Function(a), PythonValue::Function(b)) if a == b => {
                PythonValue::Function(a)
            }
            (PythonValue::Output(a), PythonValue::Output(b)) if a == b => PythonValue::Output(a),
            (PythonValue::None, PythonValue::None) => PythonValue::None,
            (PythonValue::List(a), PythonValue::List(b)) if a.len() == b.len() => {
                PythonValue::List(a.into_iter().zip(b).map(|(a, b)| a.join(b)).collect())
            }
            (
                PythonValue::Dict {
                    pairs: a,
                    open: open_a,
                },
                PythonValue::Dict {
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
                PythonValue::Dict { pairs, open }
            }
            _ => PythonValue::Unknown,
        }
    }

    /// A dictionary with an entry set.
    pub fn set(pairs: &mut Vec<(String, PythonValue)>, name: String, value: PythonValue) {
        match pairs.iter_mut().find(|(known, _)| *known == name) {
            Some((_, old)) => *old = value,
            None => pairs.push((name, value)),
        }
    }

    /// Put another dictionary over the pairs of one; whether it may hold further keys.
    pub fn spread(pairs: &mut Vec<(String, PythonValue)>, other: PythonValue) -> bool {
        match other {
            PythonValue::Dict { pairs: new, open } => {
                new.into_iter()
                    .for_each(|(name, value)| Self::set(pairs, name, value));
                open
            }
            // pairs in tuples, as `launch_arguments` takes them
            PythonValue::List(items) => {
                let mut open = false;
                for item in items {
                    match item {
                        PythonValue::List(pair) if pair.len() == 2 => {
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
            PythonValue::None => false,
            _ => {
                Self::forget(pairs);
                true
            }
        }
    }

    /// Values that further keys may have replaced are not known.
    pub fn forget(pairs: &mut [(String, PythonValue)]) {
        for (_, value) in pairs {
            *value = PythonValue::Unknown;
        }
    }
}
