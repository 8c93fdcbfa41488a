//! Findings of which less is made: they are true, and of little account.
use rules::{Finding, Severity};

/// Make infos of findings that are worse.
pub(super) fn lower_to_infos(findings: &mut [Finding]) {
    findings
        .iter_mut()
        .for_each(|finding| finding.severity = finding.severity.min(Severity::Info));
}

/// Give findings of a kind at most the severity that is asked for when there are any, and return it.
pub(super) fn lower_where(
    findings: &mut [Finding],
    is_of_kind: impl Fn(&Finding) -> bool,
    most: impl FnOnce() -> Option<Severity>,
) -> Option<Severity> {
    let mut found = findings
        .iter_mut()
        .filter(|finding| is_of_kind(finding))
        .peekable();
    let most = found.peek().is_some().then(most).flatten()?;
    found.for_each(|finding| finding.severity = finding.severity.min(most));
    Some(most)
}
