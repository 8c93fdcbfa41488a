//! What errors keep from being checked, said at the error: without it, silence would look like success.
use std::path::Path;

use base::Span;
use expand::Expansion;
use model::Robot;
use rules::{Finding, Rule, Severity, is_whole, losses, needs_names, needs_whole, unknown_names};

/// Rules that are named, at most.
const NAMED: usize = 3;

/// Why a robot was not checked in full.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CutBy {
    /// Elements were left out.
    Loss,
    /// Names of links or joints could not be computed.
    Names,
}

/// What was not checked of a robot that errors left out a part of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cut {
    /// What left the part out.
    pub by: CutBy,
    /// The places of what left it out, or of what is missing in the names.
    pub at: Vec<Span>,
    /// The rules that did not run, by name.
    pub rules: Vec<&'static str>,
}

impl Cut {
    /// What is not checked of an expansion, of the rules that are wanted: where elements are left out, or where there was an
    /// error and the names of links or joints are not known.
    pub(super) fn of(
        expansion: &Expansion,
        robot: Option<&Robot>,
        wanted: &[&'static Rule],
        findings: &[Finding],
    ) -> Option<Self> {
        if !is_whole(expansion) {
            return Some(Self::new(
                CutBy::Loss,
                losses(expansion),
                wanted,
                needs_whole,
            ));
        }
        let is_error =
            |finding: &Finding| finding.severity == Severity::Error && finding.problem.is_some();
        let robot = robot.filter(|_| findings.iter().any(is_error))?;
        let at = unknown_names(expansion, robot);
        (!at.is_empty()).then(|| Self::new(CutBy::Names, at, wanted, needs_names))
    }

    fn new(
        by: CutBy,
        at: Vec<Span>,
        wanted: &[&'static Rule],
        is_skipped: impl Fn(&Rule) -> bool,
    ) -> Self {
        let skipped = wanted.iter().filter(|rule| is_skipped(rule));
        let mut rules: Vec<_> = skipped.map(|rule| rule.name).collect();
        rules.sort_unstable();
        Self { by, at, rules }
    }

    /// The number of the finding that is about what left out a part: the first one, in the order of the expansion.
    pub fn cause(&self, findings: &[Finding]) -> Option<usize> {
        let at = |place: &Span| {
            findings.iter().position(|finding| {
                finding.severity >= Severity::Warning
                    && finding.span.file == place.file
                    && finding.span.range.touches(place.range.start)
            })
        };
        let first_error = || {
            findings
                .iter()
                .position(|finding| finding.severity == Severity::Error)
        };
        self.at.iter().find_map(at).or_else(first_error)
    }

    /// The sentence of a help that says what was not checked of `robot`.
    pub fn sentence(&self, robot: &Path) -> Option<String> {
        let robot = robot.file_name()?.to_string_lossy().into_owned();
        let (named, more) = self.rules.split_at(NAMED.min(self.rules.len()));
        let named: Vec<String> = named.iter().map(|name| format!("`{name}`")).collect();
        let more = if more.is_empty() {
            String::new()
        } else {
            format!(" and {} more", more.len())
        };
        let which = format!("{}{more}", named.join(", "));
        let why = match self.by {
            CutBy::Loss => "rules about missing or unused parts did not run",
            CutBy::Names => {
                "names of links or joints cannot be computed, so rules that look up names did not run, or only in part"
            }
        };
        (!named.is_empty()).then(|| {
            format!("until this is fixed, `{robot}` is not checked in full: {why} ({which})")
        })
    }
}
