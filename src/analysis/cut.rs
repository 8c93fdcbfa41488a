//! What errors keep from being checked, said at the error: without it, silence would look like success.
use std::path::Path;

use base::Span;
use expand::Expansion;
use rules::{Finding, Rule, Severity, losses, needs_whole};

/// Rules that are named, at most.
const NAMED: usize = 3;

/// What was not checked of a robot that errors left out a part of.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cut {
    /// The places of what left it out.
    pub at: Vec<Span>,
    /// The rules that did not run, by name.
    pub rules: Vec<&'static str>,
}

impl Cut {
    /// What is not checked of an expansion, of the rules that are wanted.
    pub(super) fn of(expansion: &Expansion, wanted: &[&'static Rule]) -> Self {
        let skipped = wanted.iter().filter(|rule| needs_whole(rule));
        let mut rules: Vec<_> = skipped.map(|rule| rule.name).collect();
        rules.sort_unstable();
        Self {
            at: losses(expansion),
            rules,
        }
    }

    /// The number of the finding that is about what left out a part: the first one, in the order of the expansion.
    pub fn cause(&self, findings: &[Finding]) -> Option<usize> {
        let shown = |finding: &Finding| finding.severity >= Severity::Warning;
        let is_at = |finding: &Finding, at: &Span| {
            finding.span.file == at.file && finding.span.range.touches(at.range.start)
        };
        let at = |place| {
            findings
                .iter()
                .position(|finding| shown(finding) && is_at(finding, place))
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
        (!named.is_empty()).then(|| {
            format!("until this is fixed, `{robot}` is not checked in full: rules about missing or unused parts did not run ({which})")
        })
    }
}
