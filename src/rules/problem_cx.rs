//! A problem of the expansion where it is reported.
use base::Span;
use expand::Problem;
use vfs::Vfs;
use xml::Document;

/// A problem where it is reported.
pub(super) struct ProblemCx<'a> {
    pub problem: &'a Problem,
    /// The file that is wrong.
    pub document: &'a Document,
    /// The text that is reported.
    pub span: Span,
    /// For other files.
    pub vfs: &'a Vfs,
}
