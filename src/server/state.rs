//! The state of the server: what is open, what was said, what is due.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use lsp_types::Url;

use crate::client::ResolvedCapabilities;
use crate::convert;
use crate::exit::Shutdown;
use crate::failure::RequestFailure;
use crate::installed_links::InstalledLinks;
use crate::logging::Log;
use crate::outbox::Outbox;
use crate::queue::QueueStatus;
use crate::scheduler::{Cause, DiagnosticsScheduler};
use crate::sent::Sent;
use analysis::AnalysisHost;
use base::Encoding;
use vfs::SourceFile;

/// An open document.
#[derive(Clone, Debug)]
pub(super) struct OpenDocument {
    /// Its name as the client spells it.
    pub uri: Url,
    /// Its version, when the client counts them.
    pub version: Option<i32>,
}

/// Settings of the user that concern the server alone.
pub(super) struct ServerSettings {
    /// Which hints are shown.
    pub hints: ide::HintSettings,
    /// Whether completions may hold placeholders, as far as the user says.
    pub snippets: bool,
    /// The settings that the client began with: they hold where it has none.
    pub initial: serde_json::Value,
}

/// The state of the server.
pub(super) struct ServerState {
    pub host: AnalysisHost,
    pub client: ResolvedCapabilities,
    pub encoding: Encoding,
    pub outbox: Outbox,
    pub status: QueueStatus,
    /// Open documents by path.
    pub documents: BTreeMap<PathBuf, OpenDocument>,
    /// Which of them are open through links in an install space.
    pub installed: InstalledLinks,
    pub sent: Sent,
    pub diagnostics: DiagnosticsScheduler,
    pub settings: ServerSettings,
    /// Macro calls that the user selected, by root.
    pub selected_instances: BTreeMap<PathBuf, ide::SelectedInstance>,
    /// Where the last lines of the log are.
    pub log: Log,
    /// What is shown in 3D.
    pub previews: crate::views::Previews,
    /// How the process ends; none where it is not ours to end.
    pub shutdown: Option<Shutdown>,
    /// The client is ready for requests.
    pub initialized: bool,
    /// The token of the progress that is shown.
    pub progress: Option<String>,
}

impl ServerState {
    /// How long an answer waits for the scan of the workspace.
    pub const SCAN_FIRST: Duration = Duration::from_millis(200);
    /// How often progress is reported while an answer waits for all of it.
    pub const SCAN_REPORT: Duration = Duration::from_millis(100);

    pub fn new(host: AnalysisHost, outbox: Outbox, status: QueueStatus, log: Log) -> Self {
        Self {
            host,
            client: ResolvedCapabilities::default(),
            encoding: Encoding::Utf16,
            outbox,
            status,
            documents: BTreeMap::new(),
            installed: InstalledLinks::default(),
            sent: Sent::default(),
            diagnostics: DiagnosticsScheduler::default(),
            settings: ServerSettings {
                hints: ide::HintSettings::default(),
                snippets: true,
                initial: serde_json::json!({}),
            },
            selected_instances: BTreeMap::new(),
            log,
            previews: crate::views::Previews::default(),
            shutdown: None,
            initialized: false,
            progress: None,
        }
    }

    /// Something changed: models are to be made, and diagnostics after the pause.
    pub fn schedule(&mut self, cause: Cause) {
        self.previews.due = true;
        self.diagnostics.after_pause(cause);
    }

    /// The path of a document.
    pub fn path(&self, uri: &Url) -> PathBuf {
        self.installed.source(convert::path(uri))
    }

    /// How a file is called towards the client: as the client called it, if it did.
    pub fn uri(&self, path: &Path) -> Option<Url> {
        let open = self
            .documents
            .get(path)
            .map(|document| document.uri.clone());
        open.or_else(|| convert::file_uri(path))
    }

    /// A document that the client may ask about.
    pub fn source(&self, uri: &Url) -> Result<(PathBuf, Arc<SourceFile>), RequestFailure> {
        let path = self.path(uri);
        let known = self.documents.contains_key(&path);
        let source = if known || self.may_read(&path) {
            self.host.document(&path)
        } else {
            None
        };
        let source = source.ok_or_else(|| {
            RequestFailure::Invalid(format!("cannot read `{uri}`, which is not open"))
        })?;
        Ok((path, source))
    }

    /// Files may be read that lie in a workspace folder or take part in something open.
    pub fn may_read(&self, path: &Path) -> bool {
        self.documents.contains_key(path)
            || self
                .host
                .folders()
                .iter()
                .any(|folder| path.starts_with(folder))
            || self.host.session().packages.containing(path).is_some()
    }
}
