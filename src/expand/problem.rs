//! What went wrong, where, and through which calls and includes expansion came there.
use ecow::EcoString;

use super::kind::ProblemKind;
use super::{Frame, FrameKind};
pub use base::Severity;
use base::TextRange;

/// A place in a file of the expansion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FileRange {
    /// Index of [`Expansion::files`].
    pub file: super::FileIdx,
    /// Absolute byte range.
    pub range: TextRange,
}

/// A step of the trace of a problem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TraceStep {
    /// Where it happened.
    pub place: FileRange,
    /// What happened there, e.g. "in this call of macro `leg`".
    pub message: String,
}

/// What is no part of this expansion and may make a problem go away.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outside {
    /// A file that includes this one, or a caller of the macro, may define a name.
    Includer,
    /// Whoever expands the file may give this argument.
    Argument(EcoString),
    /// The environment may hold a variable.
    Environment,
    /// Another value of an argument may name a file or package that is there.
    File,
}

/// What a fix needs to know of a problem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Detail {
    /// The parameters that a call does not give.
    MissingParams(Vec<EcoString>),
    /// The path of the file that was looked for.
    LookedFor(String),
    /// The macro that was meant to be called.
    Called(EcoString),
}

/// One cause, found once, however often expansion ran into it.
#[derive(Clone, Debug)]
pub struct Problem {
    /// What kind of problem it is.
    pub kind: ProblemKind,
    /// An error where the reference refuses the file, a warning where it prints one and goes on.
    pub severity: Severity,
    /// One line in our words: lower case, names the entity.
    pub message: String,
    /// What the reference says about it (may hold line feeds).
    pub reference: String,
    /// What to do, where there is something to say.
    pub help: Option<String>,
    /// Text that would fix it, in place of the text of `place`.
    pub replacement: Option<String>,
    /// What a fix needs to know beyond that.
    pub detail: Option<Detail>,
    /// What outside of this expansion may make it go away.
    pub outside: Option<Outside>,
    /// Found in a macro that nothing calls: the document does not suffer from it.
    pub probed: bool,
    /// An error of this run only: other arguments, or the build of the package, give what is missing.
    pub excused: bool,
    /// The text that is wrong.
    pub place: FileRange,
    /// How expansion came there, innermost step first.
    pub trace: Vec<TraceStep>,
    /// Further ways that lead to the same place: the calls behind the first one.
    pub more_calls: Vec<TraceStep>,
}

impl Problem {
    /// A problem at `place`; the builder methods add the rest.
    pub fn new(kind: ProblemKind, place: FileRange, message: impl Into<String>) -> Self {
        Self {
            kind,
            severity: Severity::Error,
            message: message.into(),
            reference: String::new(),
            help: None,
            replacement: None,
            detail: None,
            outside: None,
            probed: false,
            excused: false,
            place,
            trace: Vec::new(),
            more_calls: Vec::new(),
        }
    }

    /// The same as a warning.
    #[must_use]
    pub fn warning(mut self) -> Self {
        self.severity = Severity::Warning;
        self
    }

    /// As an error of this run only.
    #[must_use]
    pub fn excused(mut self) -> Self {
        self.excused = true;
        self
    }

    /// With the words of the reference.
    #[must_use]
    pub fn says(mut self, reference: impl Into<String>) -> Self {
        self.reference = reference.into();
        self
    }

    /// With advice.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// With a text to put in place of the wrong one.
    #[must_use]
    pub fn replace_with(mut self, text: impl Into<String>) -> Self {
        self.replacement = Some(text.into());
        self
    }

    /// With what a fix needs to know.
    #[must_use]
    pub fn detail(mut self, detail: Detail) -> Self {
        self.detail = Some(detail);
        self
    }

    /// With what outside of the expansion may make it go away.
    #[must_use]
    pub fn depends_on(mut self, outside: Outside) -> Self {
        self.outside = Some(outside);
        self
    }

    /// With a trace.
    #[must_use]
    pub fn via(mut self, trace: Vec<TraceStep>) -> Self {
        self.trace = trace;
        self
    }
}

/// What a frame means in a trace.
pub(super) fn step_message(frame: &Frame) -> String {
    match frame.kind {
        FrameKind::Root => "in this file".to_owned(),
        FrameKind::Include => "included here".to_owned(),
        FrameKind::Macro => format!("in this call of macro `{}`", frame.name),
        FrameKind::Block => format!("in block `{}` inserted here", frame.name),
    }
}
