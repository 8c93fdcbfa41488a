//! Where an editor shows a finding in the body of a macro: at the call whose argument is wrong, or that is the only
//! one in which it holds; else in the body, and once more as a note at the calls in files that are open.
use std::path::Path;

use indexmap::IndexMap;

use super::report::Report;
use base::Span;
use ecow::{EcoString, EcoVec};
use rules::{CallSite, Finding, Related, Severity};
use vfs::Vfs;

/// Calls that get a note, of one finding.
const MOST_NOTES: usize = 10;

/// Show the findings of a report where an editor shows them: each in one place, with a note at the calls that lead to it.
pub(super) fn place(report: &mut Report, vfs: &Vfs, is_open: impl Fn(&Path) -> bool) {
    let open = |span: Span| is_open(&vfs.path(span.file));
    let mut placed: Vec<Finding> = Vec::new();
    let mut calls: IndexMap<Span, Leads> = IndexMap::new();
    for finding in std::mem::take(&mut report.findings) {
        let moves = |site: &&CallSite| site.argument.is_some() || finding.partial;
        let moved: Vec<Finding> = finding
            .call_sites
            .iter()
            .filter(moves)
            .map(|site| at_call(&finding, site))
            .collect();
        if moved.is_empty() || moved.len() < finding.call_sites.len() {
            for call in noted(&finding, &moved, vfs, open) {
                let noted = &mut calls.entry(call).or_default().noted;
                noted.push(as_in(&finding, call));
            }
            // the calls are told apart from here on: nobody asks for them again
            let finding = Finding {
                call_sites: EcoVec::new(),
                ..finding
            };
            let leads = closed(&finding, open).map(|call| calls.entry(call).or_default());
            placed.extend(match leads {
                Some(leads) => leads.take_over(finding),
                None => Some(finding),
            });
        }
        placed.extend(moved);
    }
    placed.extend(
        calls
            .into_iter()
            .filter_map(|(call, leads)| leads.note(call, vfs)),
    );
    for span in placed.iter().map(|finding| finding.span) {
        report
            .paths
            .entry(span.file)
            .or_insert_with(|| vfs.path(span.file));
    }
    placed.sort_by_cached_key(|found| {
        (
            vfs.path(found.span.file),
            found.span.range.start,
            found.rule.code,
        )
    });
    report.findings = placed;
}

/// A finding as it reads in one call: a message that names a link or joint names that of the call. Where the macro is called
/// further inside, and its calls differ, which of them belong to this one is not known: no name is better than another's.
fn as_in(finding: &Finding, call: Span) -> Finding {
    let sites = &finding.call_sites;
    let message = match sites.iter().find(|site| site.call == call) {
        Some(site) => site.message.to_string(),
        None if sites.iter().all(|site| site.message == finding.message) => finding.message.clone(),
        None => format!("`{}` in what it expands to", finding.rule.name),
    };
    Finding {
        message,
        call_sites: EcoVec::new(),
        ..finding.clone()
    }
}

/// What a call or an include in an open file leads to.
#[derive(Default)]
struct Leads {
    /// An error in a file that is not open: what leads there is the text that the author sees, so it is shown there.
    error: Option<Finding>,
    /// How many more such errors there are, which are shown in their own file.
    more: usize,
    /// What is shown in an open file.
    noted: Vec<Finding>,
}

impl Leads {
    /// Show an error of a closed file here; returned when there is one already.
    fn take_over(&mut self, error: Finding) -> Option<Finding> {
        if self.error.is_none() {
            self.error = Some(error);
            return None;
        }
        self.more += 1;
        Some(error)
    }

    /// The one finding that is shown at the call: the error, or a hint.
    fn note(self, call: Span, vfs: &Vfs) -> Option<Finding> {
        let Some(error) = self.error else {
            return hint(self.noted, call);
        };
        let message = match (self.more, vfs.path(error.span.file).file_name()) {
            (more @ 1.., Some(file)) => {
                format!(
                    "{} (and {more} more in `{}`)",
                    error.message,
                    file.to_string_lossy()
                )
            }
            _ => error.message.clone(),
        };
        let cause = Related {
            span: error.span,
            message: "caused here".to_owned(),
            is_call: false,
        };
        let others = error
            .related
            .iter()
            .filter(|related| related.span != call)
            .cloned();
        let related = std::iter::once(cause)
            .chain(others)
            .chain(self.noted.iter().map(place_of))
            .collect();
        Some(Finding {
            span: call,
            message,
            related,
            similar: None,
            fix: None,
            group: None,
            ..error
        })
    }
}

/// A hint at a call that leads to findings which are shown elsewhere.
fn hint(findings: Vec<Finding>, call: Span) -> Option<Finding> {
    let mut related: Vec<Related> = findings.iter().map(place_of).collect();
    related.first_mut()?.message = "it is reported here".to_owned();
    let count = findings.len();
    let first = findings.into_iter().next()?;
    let message = match count {
        1 => format!("this call causes: {}", first.message),
        _ => format!("this call causes {count} problems: {}", first.message),
    };
    let severity = Severity::Hint;
    let no_help = Finding {
        help: None,
        similar: None,
        fix: None,
        ..first
    };
    Some(Finding {
        severity,
        message,
        span: call,
        related,
        group: None,
        ..no_help
    })
}

fn place_of(finding: &Finding) -> Related {
    Related {
        span: finding.span,
        message: finding.message.clone(),
        is_call: false,
    }
}

/// Where an error in a file that is not open is shown instead: at the first call or include in an open one.
fn closed(finding: &Finding, open: impl Fn(Span) -> bool) -> Option<Span> {
    if finding.severity != Severity::Error || open(finding.span) {
        return None;
    }
    finding
        .related
        .iter()
        .find(|related| related.is_call && open(related.span))
        .map(|call| call.span)
}

/// A finding at the call that caused it.
fn at_call(finding: &Finding, site: &CallSite) -> Finding {
    let body = Related {
        span: finding.span,
        message: format!("here in macro `{}`", site.name),
        is_call: false,
    };
    let span = site.argument.unwrap_or(site.call);
    let others = finding
        .related
        .iter()
        .filter(|related| related.span != span && related.span != site.call);
    let own = |related: &&Related| {
        !related.is_call
            || finding
                .call_sites
                .iter()
                .all(|site| site.call != related.span)
    };
    let alone = finding.call_sites.len() == 1;
    Finding {
        span,
        message: site.message.to_string(),
        help: site.help.as_ref().map(EcoString::to_string),
        related: std::iter::once(body)
            .chain(others.filter(own).cloned())
            .collect(),
        similar: finding
            .similar
            .clone()
            .filter(|_| site.help.as_deref() == finding.help.as_deref()),
        fix: finding.fix.clone().filter(|_| alone),
        call_sites: EcoVec::new(),
        ..finding.clone()
    }
}

/// The calls in open files that lead to a finding, but for one that takes it over.
fn noted(
    finding: &Finding,
    moved: &[Finding],
    vfs: &Vfs,
    open: impl Fn(Span) -> bool + Copy,
) -> Vec<Span> {
    if finding.severity < Severity::Warning {
        return Vec::new();
    }
    let takes_over = closed(finding, open);
    let calls = finding
        .related
        .iter()
        .filter(|related| related.is_call && open(related.span));
    let spans = calls.map(|call| call.span).filter(|&call| {
        let told = moved.iter().any(|other| other.span == call) || call == finding.span;
        Some(call) != takes_over && !told && is_call_tag(call, vfs)
    });
    spans.take(MOST_NOTES).collect()
}

/// Whether the tag at a span calls a macro.
fn is_call_tag(span: Span, vfs: &Vfs) -> bool {
    const OTHERS: [&str; 3] = ["<xacro:include", "<xacro:insert_block", "<xacro:property"];
    let Ok(source) = vfs.document(&vfs.path(span.file)) else {
        return false;
    };
    let text = source.document.slice(span.range);
    text.starts_with("<xacro:") && !OTHERS.contains(&text.as_ref())
}
