//! Publishing: diagnostics are encoded once, and sent when they say something new.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lsp_types::notification::{Notification, PublishDiagnostics};
use lsp_types::{Diagnostic, Range, Url};
use serde::Serialize;
use serde_json::value::{RawValue, to_raw_value};

use super::convert::Places;
use super::diagnostics::fingerprint;
use super::engine::Engine;
use super::outbox::notification;
use base::limits::{DIAGNOSTICS, RELATED};
use base::{FastMap, Span};
use rules::{Finding, Fix};

/// What the client was told last.
#[derive(Default)]
pub(super) struct Published {
    /// By path, a hash of the message.
    messages: BTreeMap<PathBuf, u64>,
    /// The findings of the file that was typed in last. A key changes one of them, or none.
    encoded: FastMap<Name, Encoded>,
}

/// What finds a diagnostic again after an edit: the code of its rule and where it begins.
type Name = (&'static str, u32, u32);

/// A finding as it was sent.
struct Encoded {
    finding: Finding,
    /// Its places, as the client counts.
    ranges: Vec<Range>,
    diagnostic: Box<RawValue>,
}

/// `PublishDiagnosticsParams` of diagnostics that are encoded already.
#[derive(Serialize)]
struct Params<'a> {
    uri: Url,
    diagnostics: &'a [&'a RawValue],
    #[serde(skip_serializing_if = "Option::is_none")]
    version: Option<i32>,
}

impl Published {
    /// Encode everything anew: files may be called otherwise than before.
    pub fn forget_names(&mut self) {
        self.encoded = FastMap::default();
    }
}

impl Engine {
    /// Send the findings of a first look, as far as they fit.
    pub fn publish_findings(&mut self, path: &Path, findings: Vec<Finding>) {
        let mut before = std::mem::take(&mut self.published.encoded);
        let mut places = self.places();
        let shown = findings.into_iter().take(DIAGNOSTICS);
        let encoded: Vec<_> = shown.filter_map(|finding| places.encoded(finding, &mut before)).collect();
        let diagnostics: Vec<&RawValue> = encoded.iter().map(|(_, one)| &*one.diagnostic).collect();
        self.publish_encoded(path.to_path_buf(), &diagnostics);
        self.published.encoded = encoded.into_iter().collect();
    }

    /// Send what differs from what was sent before.
    pub fn publish(&mut self, mut found: BTreeMap<PathBuf, Vec<Diagnostic>>) {
        for path in self.published.messages.keys() {
            found.entry(path.clone()).or_default();
        }
        for (path, diagnostics) in found {
            let raw: Vec<_> = diagnostics.iter().filter_map(|one| to_raw_value(one).ok()).collect();
            self.publish_encoded(path, &raw.iter().map(|one| &**one).collect::<Vec<_>>());
        }
    }

    /// A closed file has no diagnostics of its own any more.
    pub fn withdraw(&mut self, path: &Path, uri: Url) {
        self.published.forget_names();
        if self.published.messages.remove(path).is_some() {
            let none = Params { uri, diagnostics: &[], version: None };
            self.outbox.tell(PublishDiagnostics::METHOD, &none);
        }
    }

    fn publish_encoded(&mut self, path: PathBuf, diagnostics: &[&RawValue]) {
        let version = self.documents.get(&path).and_then(|open| open.version);
        let Some(uri) = self.uri(&path) else { return };
        let is_cleared = diagnostics.is_empty() && !self.documents.contains_key(&path);
        let message = notification(PublishDiagnostics::METHOD, &Params { uri, diagnostics, version });
        let hash = fingerprint(&message);
        if self.published.messages.get(&path) == Some(&hash) {
            return;
        }
        match is_cleared {
            true => self.published.messages.remove(&path),
            false => self.published.messages.insert(path, hash),
        };
        self.outbox.tell_encoded(&message);
    }
}

impl Places<'_> {
    /// A finding as it is sent: as it was before, when it says the same of the same places.
    fn encoded(&mut self, finding: Finding, before: &mut FastMap<Name, Encoded>) -> Option<(Name, Encoded)> {
        let start = self.range(finding.span)?.start;
        let name = (finding.rule.code, start.line, start.character);
        let ranges: Vec<_> = spans(&finding).map(|span| self.range(span).unwrap_or_default()).collect();
        let known = before.remove(&name);
        let known = known.filter(|known| known.ranges == ranges && says_the_same(&known.finding, &finding));
        let anew = |places: &mut Self| to_raw_value(&places.diagnostic(&finding)?).ok();
        let diagnostic = match known {
            Some(known) => {
                debug_assert_eq!(Some(known.diagnostic.get()), anew(self).as_deref().map(RawValue::get));
                known.diagnostic
            }
            None => anew(self)?,
        };
        Some((name, Encoded { finding, ranges, diagnostic }))
    }
}

/// The places that a diagnostic names.
fn spans(finding: &Finding) -> impl Iterator<Item = Span> {
    let related = finding.related.iter().take(RELATED).map(|related| related.span);
    let edits = finding.fix.iter().flat_map(|fix| &fix.edits).map(|edit| edit.span);
    std::iter::once(finding.span).chain(related).chain(edits)
}

/// Whether two findings differ at most in where their places are within files.
fn says_the_same(a: &Finding, b: &Finding) -> bool {
    (a.rule.code, a.severity, &a.message, &a.help) == (b.rule.code, b.severity, &b.message, &b.help)
        && spans(a).map(|span| span.file).eq(spans(b).map(|span| span.file))
        && a.related.iter().map(|one| &one.message).eq(b.related.iter().map(|one| &one.message))
        && match (&a.fix, &b.fix) {
            (Some(a), Some(b)) => says_the_same_fix(a, b),
            (a, b) => a.is_none() && b.is_none(),
        }
}

fn says_the_same_fix(a: &Fix, b: &Fix) -> bool {
    (a.safety, &a.message) == (b.safety, &b.message)
        && a.edits.iter().map(|edit| &edit.content).eq(b.edits.iter().map(|edit| &edit.content))
}
