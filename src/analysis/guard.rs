//! A fix that causes new errors is taken back.
use super::report::Report;
use base::FastSet;
use rules::{Category, Finding, Severity, Trait};

/// Whether fixes of findings in the report before led to errors in what was expanded before.
pub(super) fn harms(before: &Report, after: &Report, made: &[usize]) -> bool {
    let (old, new) = (before.errors(), after.errors());
    let known: FastSet<&(&str, String)> = old.iter().collect();
    if new.iter().all(|error| known.contains(error)) {
        return false;
    }
    let mut fixed = made
        .iter()
        .filter_map(|&number| before.findings.get(number));
    if fixed
        .clone()
        .any(|finding| finding.rule.has(Trait::Reveals))
    {
        return false;
    }
    // a value that is known now may be wrong, and another name is another message; one error for another is no loss
    !fixed.any(|finding| is_value(finding) || finding.rule.category == Category::Consumers)
        || new.len() > old.len()
}

/// Whether what was wrong gave no value.
fn is_value(finding: &Finding) -> bool {
    finding.severity == Severity::Error
        && matches!(finding.rule.category, Category::Xacro | Category::Xml)
}
