//! Where a text of a launch file is written, seen from where it is used.

use base::TextRange;

/// Where a text is written.
#[derive(Clone, Copy, Debug)]
pub(super) enum TextPlace {
    /// Where it is used.
    Here(TextRange),
    /// In the default of an argument, which says nothing of what it is used for.
    InDefault(TextRange),
    /// It is put together, or given from outside.
    Unknown,
}

impl TextPlace {
    /// The place of a text that stands where it is used, if it is known.
    pub fn at(range: Option<TextRange>) -> Self {
        range.map_or(Self::Unknown, Self::Here)
    }

    /// The same text, as the default of an argument.
    pub fn as_default(self) -> Self {
        match self {
            Self::Here(range) => Self::InDefault(range),
            other => other,
        }
    }

    /// The place, of a text that stands where it is used.
    pub fn here(self) -> Option<TextRange> {
        match self {
            Self::Here(range) => Some(range),
            _ => None,
        }
    }

    /// The place, whether or not the text is used there.
    pub fn written(self) -> Option<TextRange> {
        match self {
            Self::Here(range) | Self::InDefault(range) => Some(range),
            Self::Unknown => None,
        }
    }
}
