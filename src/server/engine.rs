//! The analysis thread: it alone owns the state, and works off one job after the other.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use lsp_types::{MessageType, Url};

use super::client::ClientFacts;
use super::convert;
use super::failure::Failure;
use super::letterbox::{Job, Pressure};
use super::outbox::Outbox;
use analysis::World;
use base::Encoding;
use vfs::{Environment, SourceFile};

/// An open document.
#[derive(Clone, Debug)]
pub(super) struct OpenDocument {
    /// Its name as the client spells it.
    pub uri: Url,
    /// Its version, when the client counts them.
    pub version: Option<i32>,
}

/// The state of the server.
pub(super) struct Engine {
    pub world: World,
    pub client: ClientFacts,
    pub encoding: Encoding,
    pub outbox: Outbox,
    pub pressure: Pressure,
    /// Open documents by path.
    pub documents: BTreeMap<PathBuf, OpenDocument>,
    /// What was published last.
    pub published: super::publishing::Published,
    /// The files that the client was told findings of when it asked for those of the workspace.
    pub reported: BTreeSet<PathBuf>,
    /// The semantic tokens that were sent last, by path.
    pub sent_tokens: BTreeMap<PathBuf, super::tokens::Sent>,
    /// Macro calls that the user picked, by root.
    pub pins: BTreeMap<PathBuf, ide::Pin>,
    /// Under which root the client was told that each open file is shown.
    pub told: BTreeMap<PathBuf, serde_json::Value>,
    /// Which hints are shown.
    pub hint_settings: ide::HintSettings,
    /// When diagnostics are to be made.
    pub due: Option<Instant>,
    /// The pause after the last edit before diagnostics are made.
    pub delay: Duration,
    /// Whether completions may hold places to fill in, as far as the user says.
    pub snippets: bool,
    /// What is shown in 3D.
    pub previews: super::preview::Previews,
    /// Where others may post jobs.
    pub letterbox: Option<super::letterbox::Letterbox>,
    /// The client is ready for requests.
    pub initialized: bool,
    /// The token of the progress that is shown.
    pub progress: Option<String>,
    /// The settings that the client began with: they hold where it has none.
    pub first_settings: serde_json::Value,
    /// What the user was told about settings.
    pub warned: std::collections::BTreeSet<String>,
    /// Whether the user was told of an internal fault.
    fault_shown: bool,
}

impl Engine {
    /// How long an edit takes at most from its message to its job.
    const ON_ITS_WAY: Duration = Duration::from_millis(2);
    /// How long an answer waits for a look at the workspace.
    pub const SCAN_FIRST: Duration = Duration::from_millis(200);
    /// The pause after the last edit unless configured: so long that letters of one stroke come together, too short to
    /// be noticed.
    pub const DELAY: Duration = Duration::from_millis(20);

    pub fn new(env: Environment, outbox: Outbox, pressure: Pressure) -> Self {
        Self {
            world: World::new(env, Vec::new()),
            client: ClientFacts::default(),
            encoding: Encoding::Utf16,
            outbox,
            pressure,
            documents: BTreeMap::new(),
            published: super::publishing::Published::default(),
            reported: BTreeSet::new(),
            sent_tokens: BTreeMap::new(),
            pins: BTreeMap::new(),
            told: BTreeMap::new(),
            hint_settings: ide::HintSettings::default(),
            due: None,
            delay: Self::DELAY,
            snippets: true,
            previews: super::preview::Previews::default(),
            letterbox: None,
            initialized: false,
            progress: None,
            first_settings: serde_json::json!({}),
            warned: std::collections::BTreeSet::new(),
            fault_shown: false,
        }
    }

    /// Work off jobs until nobody can post one any more.
    pub fn run(mut self, jobs: &Receiver<Job>) {
        loop {
            let job = match self.pause() {
                None => jobs.recv().map_err(|_| RecvTimeoutError::Disconnected),
                Some(pause) => jobs.recv_timeout(pause),
            };
            match job {
                Ok(job) => {
                    self.pressure.taken();
                    self.guarded(job);
                }
                Err(RecvTimeoutError::Timeout) => {
                    self.pressure.forget_announced();
                    self.guarded(Box::new(Self::idle));
                }
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
    }

    /// How long to wait for a job before idle work; none: for ever.
    fn pause(&self) -> Option<Duration> {
        if self.previews.due && !self.previews.views.is_empty() {
            return Some(Duration::ZERO);
        }
        if let Some(due) = self.due {
            let rest = due.saturating_duration_since(Instant::now());
            return Some(if self.pressure.is_edit_announced() { rest.max(Self::ON_ITS_WAY) } else { rest });
        }
        (self.initialized && !self.world.is_scanned()).then_some(Duration::ZERO)
    }

    /// What is done when nobody waits for anything.
    fn idle(&mut self) {
        if self.previews.due && !self.previews.views.is_empty() {
            return self.make_previews();
        }
        if self.due.is_some_and(|due| due <= Instant::now()) {
            return self.make_diagnostics();
        }
        if self.due.is_none() && self.initialized && !self.world.is_scanned() {
            self.scan();
        }
    }

    /// Run a job; a panic in it is logged and ends that job only.
    fn guarded(&mut self, job: Job) {
        let Err(panic) = catch_unwind(AssertUnwindSafe(|| job(self))) else { return };
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("unknown fault");
        let message = format!("internal fault: {text}; please report it with the file that caused it");
        self.outbox.log_as(MessageType::ERROR, message.clone());
        if !std::mem::replace(&mut self.fault_shown, true) {
            self.outbox.show(MessageType::ERROR, message);
        }
    }

    /// Fail as a fault of ours would.
    #[cfg(debug_assertions)]
    #[allow(clippy::panic, reason = "that is what it is for")]
    pub fn fail(&mut self, (): (), _: &base::CancelFlag) -> Result<serde_json::Value, Failure> {
        panic!("this job was asked to fail")
    }

    /// A check is wanted after the pause.
    pub fn schedule(&mut self) {
        self.previews.due = true;
        self.due = Some(Instant::now() + self.delay);
    }

    /// The path of a document.
    pub fn path(&self, uri: &Url) -> PathBuf {
        convert::path(uri)
    }

    /// How a file is called towards the client: as the client called it, if it did.
    pub fn uri(&self, path: &Path) -> Option<Url> {
        let open = self.documents.get(path).map(|document| document.uri.clone());
        open.or_else(|| Url::from_file_path(path).ok())
    }

    /// A document that the client may ask about.
    pub fn source(&self, uri: &Url) -> Result<(PathBuf, Arc<SourceFile>), Failure> {
        let path = self.path(uri);
        let known = self.documents.contains_key(&path);
        let source = if known || self.may_read(&path) { self.world.document(&path) } else { None };
        let source =
            source.ok_or_else(|| Failure::Invalid(format!("`{uri}` is not open and cannot be read")))?;
        Ok((path, source))
    }

    /// Files may be read that lie in a workspace folder or take part in something open.
    pub fn may_read(&self, path: &Path) -> bool {
        self.documents.contains_key(path)
            || self.world.folders().iter().any(|folder| path.starts_with(folder))
            || self.world.session().packages.containing(path).is_some()
    }
}
