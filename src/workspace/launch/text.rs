//! Texts that a launch file puts together from pieces, of which some are not known.

use base::TextRange;
use base::limits::{LAUNCH_PIECES, LAUNCH_TEXT};

/// A text in pieces.
#[derive(Clone, Debug, Default)]
pub struct Text(pub Vec<TextPiece>);

/// A piece of a text.
#[derive(Clone, Debug)]
pub enum TextPiece {
    /// Text, and where it is written; a copy that was changed has no range.
    Plain(String, Option<TextRange>),
    /// The share folder of the package of that name.
    Share(Text),
    /// The value of an argument of the launch file.
    Argument(String),
    /// A value that is computed.
    Opaque,
}

impl PartialEq for TextPiece {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (TextPiece::Plain(a, _), TextPiece::Plain(b, _))
            | (TextPiece::Argument(a), TextPiece::Argument(b)) => a == b,
            (TextPiece::Share(a), TextPiece::Share(b)) => a == b,
            // two values that are not known may differ
            _ => false,
        }
    }
}

impl PartialEq for Text {
    fn eq(&self, other: &Self) -> bool {
        self.0.len() == other.0.len() && self.0.iter().zip(&other.0).all(|(a, b)| a == b)
    }
}

impl Text {
    /// Text that stands in the file.
    pub fn plain(text: impl Into<String>, at: Option<TextRange>) -> Self {
        Self(vec![TextPiece::Plain(text.into(), at)])
    }

    /// A value that is computed.
    pub fn opaque() -> Self {
        Self(vec![TextPiece::Opaque])
    }

    /// The value of an argument of the launch file.
    pub fn argument(name: &str) -> Self {
        Self(vec![TextPiece::Argument(name.to_owned())])
    }

    /// The share folder of a package.
    pub fn share(package: Text) -> Self {
        if package.depth() > 4 {
            Self::opaque()
        } else {
            Self(vec![TextPiece::Share(package)])
        }
    }

    /// The text, where all of it is written down.
    pub fn literal(&self) -> Option<String> {
        let plain = |piece: &TextPiece| match piece {
            TextPiece::Plain(text, _) => Some(text.clone()),
            _ => None,
        };
        self.0.iter().map(plain).collect()
    }

    /// Add a text behind this one; what grows beyond the limits is not known.
    pub fn push(&mut self, mut other: Text) {
        let ends = (self.0.last(), other.0.first());
        if let (Some(TextPiece::Opaque), Some(TextPiece::Opaque)) = ends {
            self.0.pop();
        }
        self.0.append(&mut other.0);
        if self.0.len() > LAUNCH_PIECES || self.len() > LAUNCH_TEXT {
            *self = Self::opaque();
        }
    }

    /// Texts one behind the other.
    pub fn concat(texts: impl IntoIterator<Item = Text>) -> Self {
        let mut all = Self::default();
        texts.into_iter().for_each(|text| all.push(text));
        all
    }

    /// Texts joined as the steps of a path.
    pub fn joined(steps: impl IntoIterator<Item = Text>) -> Self {
        let mut path = Self::default();
        for step in steps {
            let is_absolute =
                matches!(step.0.first(), Some(TextPiece::Plain(text, _)) if text.starts_with('/'));
            let ends_folder =
                matches!(path.0.last(), Some(TextPiece::Plain(text, _)) if text.ends_with('/'));
            if is_absolute || matches!(step.0.first(), Some(TextPiece::Share(_))) {
                path = Self::default();
            } else if !path.0.is_empty() && !ends_folder {
                path.push(Self::plain("/", None));
            }
            path.push(step);
        }
        path
    }

    /// The text without the places where it is written.
    pub fn without_places(self) -> Self {
        let place = |piece| match piece {
            TextPiece::Plain(text, _) => TextPiece::Plain(text, None),
            other => other,
        };
        Self(self.0.into_iter().map(place).collect())
    }

    /// The bytes that are held.
    pub fn len(&self) -> usize {
        let len = |piece: &TextPiece| match piece {
            TextPiece::Plain(text, _) | TextPiece::Argument(text) => text.len(),
            TextPiece::Share(text) => text.len() + 1,
            TextPiece::Opaque => 1,
        };
        self.0.iter().map(len).sum()
    }

    fn depth(&self) -> usize {
        let depth = |piece: &TextPiece| {
            if let TextPiece::Share(inner) = piece {
                inner.depth() + 1
            } else {
                0
            }
        };
        self.0.iter().map(depth).max().unwrap_or(0)
    }

    /// The arguments of the launch file that take part.
    pub fn arguments(&self, add: &mut impl FnMut(&str)) {
        for piece in &self.0 {
            match piece {
                TextPiece::Argument(name) => add(name),
                TextPiece::Share(inner)
                    if inner.0.iter().any(|p| !matches!(p, TextPiece::Share(_))) =>
                {
                    for piece in &inner.0 {
                        if let TextPiece::Argument(name) = piece {
                            add(name);
                        }
                    }
                }
                _ => {}
            }
        }
    }
}
