//! Whether evaluation goes on, and what it could not find out.

/// Whether evaluation goes on, and under which conditions.
#[derive(Clone, Copy, Default)]
pub(super) struct Flow {
    /// A limit was reached or the request was cancelled: wind up.
    pub stopped: bool,
    /// A file is missing inside an optional include: wind up until that include.
    pub unwinding: bool,
    /// Conditionals (and computed calls and includes) around the current element.
    pub conditions: u32,
    /// How many of these have an unknown value.
    pub unknown_conditions: u32,
}

impl Flow {
    /// Whether evaluation goes on without any condition.
    pub(super) fn is_calm(&self) -> bool {
        !(self.stopped || self.unwinding) && (self.conditions, self.unknown_conditions) == (0, 0)
    }
}

/// What could not be decided or read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Gaps {
    /// An include is missing: undefined names then have a cause that was reported.
    pub include_missing: bool,
    /// The content of a condition or call is missing, because it could not be decided.
    pub content_lost: bool,
    /// How often that happened.
    pub losses: u32,
    /// A variable of the environment has one of several values.
    pub guessed: bool,
}

impl Gaps {
    /// Whether the same is known to be missing, however often it was met.
    pub(super) fn is_same(self, other: Self) -> bool {
        Self {
            losses: other.losses,
            ..self
        } == other
    }
}
