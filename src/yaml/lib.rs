//! YAML 1.1 with the exact meaning of PyYAML's `safe_load`, and with places.
//!
//! Own scanner and parser: what PyYAML accepts differs from every YAML 1.2 library (tabs, flow
//! collections at column 0, `?` in flow scalars, line separators, ...), and its messages are what the
//! reference prints.

mod collections;
mod compose;
mod construct;
mod error;
mod markup;
mod numbers;
mod reader;
mod resolve;
mod scanner;
#[cfg(test)]
mod tests;
mod text;
mod timestamp;
mod token;

use num_bigint::BigInt;

pub use error::YamlError;

use base::TextRange;
use construct::Keys;

/// A value and where it is written. A value reached through an alias has the place of its anchor.
#[derive(Clone, Debug, PartialEq)]
pub struct YamlNode {
    /// The value.
    pub kind: YamlKind,
    /// Its place in the text; for a collection, up to the end of its last item.
    pub range: TextRange,
}

/// The values `safe_load` makes, and the tagged scalars the reference adds.
#[derive(Clone, Debug, PartialEq)]
pub enum YamlKind {
    /// `None`
    Null,
    /// `bool`
    Bool(bool),
    /// `int`
    Int(BigInt),
    /// `float`
    Float(f64),
    /// `str`
    Str(String),
    /// `datetime.date` or `datetime.datetime`
    Timestamp {
        /// What Python's `str` gives.
        text: String,
        /// What Python's `repr` gives.
        repr: String,
    },
    /// `bytes`
    Binary(Vec<u8>),
    /// `list`
    List(Vec<YamlNode>),
    /// `dict`: merged, each key once (the place of the first, the value of the last), in Python's order
    Map(Vec<(YamlNode, YamlNode)>),
    /// `set`, in order of the text
    Set(Vec<YamlNode>),
    /// A list of two-tuples (`!!omap`, `!!pairs`)
    Pairs(Vec<(YamlNode, YamlNode)>),
    /// A scalar with a unit: its text is an expression
    Tagged {
        /// The unit.
        unit: Unit,
        /// The expression.
        text: String,
    },
}

/// Units of scalars (`!degrees 90`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Unit {
    Radians,
    Degrees,
    Meters,
    Millimeters,
    Foot,
    Inches,
}

impl Unit {
    /// All units.
    pub const ALL: [Unit; 6] = [
        Unit::Radians,
        Unit::Degrees,
        Unit::Meters,
        Unit::Millimeters,
        Unit::Foot,
        Unit::Inches,
    ];

    /// The tag without its `!`.
    pub fn name(self) -> &'static str {
        match self {
            Unit::Radians => "radians",
            Unit::Degrees => "degrees",
            Unit::Meters => "meters",
            Unit::Millimeters => "millimeters",
            Unit::Foot => "foot",
            Unit::Inches => "inches",
        }
    }

    /// What a value in this unit is multiplied with to give radians or meters.
    pub fn factor(self) -> f64 {
        match self {
            Unit::Radians | Unit::Meters => 1.0,
            Unit::Degrees => std::f64::consts::PI / 180.0,
            Unit::Millimeters => 0.001,
            Unit::Foot => 0.3048,
            Unit::Inches => 0.0254,
        }
    }
}

/// Load the one document of `text`; an empty text is `None`.
///
/// # Errors
/// Whatever PyYAML refuses, a value that contains itself, and values nested or multiplied beyond
/// reason. `name` is the file name in messages.
pub fn load(text: &str, name: &str) -> Result<YamlNode, YamlError> {
    load_with(text, name, Keys::Once)
}

/// Like [`load`], but a key that a mapping has several times is there each time, in the order of the text: readers of
/// parameters in ROS 2 put the values together.
///
/// # Errors
/// As those of [`load`].
pub fn load_repeated(text: &str, name: &str) -> Result<YamlNode, YamlError> {
    load_with(text, name, Keys::Repeated)
}

fn load_with(text: &str, name: &str, keys: Keys) -> Result<YamlNode, YamlError> {
    let tree = compose::compose(text).map_err(|error| error.finish(text, name))?;
    match tree {
        Some((tree, root)) => {
            construct::construct(tree, root, keys).map_err(|error| error.finish(text, name))
        }
        None => Ok(YamlNode {
            kind: YamlKind::Null,
            range: TextRange::default(),
        }),
    }
}
