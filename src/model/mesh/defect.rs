//! What is wrong with a mesh file.

/// Why a mesh cannot be used, or not be judged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Defect {
    /// How bad it is.
    pub kind: DefectKind,
    /// What is wrong, as the end of a sentence that begins with the file.
    pub message: String,
}

/// Classes of defects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DefectKind {
    /// Readers refuse it, or show nothing.
    Corrupt,
    /// It has no bytes, or zeros in place of them: a copy that failed, or a place for a file that comes later.
    Empty,
    /// A note of Git LFS stands in its place.
    LfsPointer,
    /// It can be read, but strict readers refuse it.
    Untidy,
    /// It has `<` in an attribute, as some exporters write it; most readers do not mind.
    Unescaped,
    /// It takes more to read than a mesh of a robot should, and was given up.
    TooLarge,
    /// It may be good: it uses what is not read here.
    Unread,
}

impl Defect {
    pub(super) fn corrupt(message: impl Into<String>) -> Self {
        Self {
            kind: DefectKind::Corrupt,
            message: message.into(),
        }
    }

    /// A file has no bytes, or begins with so many zeros.
    pub(super) fn empty(zeros: usize) -> Self {
        let message = match zeros {
            0 => "the file is empty".to_owned(),
            zeros => format!("it begins with {zeros} zero bytes"),
        };
        Self {
            kind: DefectKind::Empty,
            message,
        }
    }

    /// A triangle has a corner that is none of the `count` vertices.
    pub(super) fn no_vertex(index: impl std::fmt::Display, count: usize) -> Self {
        Self::corrupt(format!(
            "vertex index {index} is out of range ({count} vertices)"
        ))
    }

    pub(super) fn untidy(message: impl Into<String>) -> Self {
        Self {
            kind: DefectKind::Untidy,
            message: message.into(),
        }
    }

    pub(super) fn unescaped(message: impl Into<String>) -> Self {
        Self {
            kind: DefectKind::Unescaped,
            message: message.into(),
        }
    }

    pub(super) fn too_large(message: impl Into<String>) -> Self {
        Self {
            kind: DefectKind::TooLarge,
            message: message.into(),
        }
    }

    pub(super) fn unread(message: impl Into<String>) -> Self {
        Self {
            kind: DefectKind::Unread,
            message: message.into(),
        }
    }
}
