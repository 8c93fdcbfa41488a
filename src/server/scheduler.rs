//! When diagnostics are made, and why.
use std::path::PathBuf;
use std::time::Duration;

use crate::convert::file_name;
use base::clock::Instant;

/// Why files are checked.
#[derive(Clone, Debug)]
pub(super) enum Cause {
    Opened(PathBuf),
    Edited(PathBuf),
    Saved(PathBuf),
    Closed(PathBuf),
    /// Files that the client watches.
    FilesChanged(usize),
    FoldersChanged,
    SettingsChanged,
    /// Another robot is shown, or with other arguments.
    RobotSelected,
    /// All files of the workspace were read.
    Indexed,
    /// The user wants everything to be read again.
    Restarted,
    /// The client asks.
    Requested,
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Opened(path) => write!(f, "`{}` opened", file_name(path)),
            Self::Edited(path) => write!(f, "`{}` edited", file_name(path)),
            Self::Saved(path) => write!(f, "`{}` saved", file_name(path)),
            Self::Closed(path) => write!(f, "`{}` closed", file_name(path)),
            Self::FilesChanged(1) => f.write_str("1 file changed on disk"),
            Self::FilesChanged(count) => write!(f, "{count} files changed on disk"),
            Self::FoldersChanged => f.write_str("workspace folders changed"),
            Self::SettingsChanged => f.write_str("settings changed"),
            Self::RobotSelected => f.write_str("robot selected"),
            Self::Indexed => f.write_str("workspace indexed"),
            Self::Restarted => f.write_str("analysis restarted"),
            Self::Requested => f.write_str("requested by the editor"),
        }
    }
}

/// How far the diagnostics are.
#[derive(Debug)]
enum Phase {
    /// Nothing happened since they were made last.
    Current,
    /// They are to be made at a time, for the last of the reasons that there were since.
    Due { at: Instant, cause: Cause },
}

/// When diagnostics are made, and why.
#[derive(Debug)]
pub(super) struct DiagnosticsScheduler {
    phase: Phase,
    /// The pause after the last edit before they are made.
    delay: Duration,
    /// They are not made before, unless the settings come earlier: with other settings they are others.
    held: Option<Instant>,
}

impl Default for DiagnosticsScheduler {
    fn default() -> Self {
        Self {
            phase: Phase::Current,
            delay: Self::DELAY,
            held: None,
        }
    }
}

impl DiagnosticsScheduler {
    /// The pause after the last edit unless configured: so long that letters of one stroke come together, too short to
    /// be noticed.
    const DELAY: Duration = Duration::from_millis(20);

    /// How long the answer about settings may take. Clients answer in a few milliseconds, or never.
    const MOST_HELD: Duration = Duration::from_millis(500);

    /// Make none until the settings are there, which the client was asked for.
    pub fn hold_for_settings(&mut self) {
        self.held = Some(Instant::now() + Self::MOST_HELD);
    }

    /// The settings are there.
    pub fn release(&mut self) {
        self.held = None;
    }

    /// Have the next pauses last as long as the user says; none: as long as they do by default.
    pub fn set_delay(&mut self, delay: Option<Duration>) {
        self.delay = delay.unwrap_or(Self::DELAY);
    }

    /// Diagnostics are to be made after a pause, which begins again now.
    pub fn after_pause(&mut self, cause: Cause) {
        let at = Instant::now() + self.delay;
        self.phase = Phase::Due { at, cause };
    }

    /// Diagnostics are to be made as soon as nobody waits for anything else.
    pub fn at_once(&mut self, cause: Cause) {
        let at = Instant::now();
        self.phase = Phase::Due { at, cause };
    }

    /// Whether they are to be made, now or later.
    pub fn is_due(&self) -> bool {
        matches!(self.phase, Phase::Due { .. })
    }

    /// In how long they are to be made, if at all.
    pub fn rest(&self) -> Option<Duration> {
        match self.phase {
            Phase::Current => None,
            Phase::Due { at, .. } => {
                let at = self.held.map_or(at, |held| held.max(at));
                Some(at.saturating_duration_since(Instant::now()))
            }
        }
    }

    /// Why they are to be made, if they are.
    pub fn cause(&self) -> Option<&Cause> {
        match &self.phase {
            Phase::Current => None,
            Phase::Due { cause, .. } => Some(cause),
        }
    }

    /// They are made, or left to who asks for them; what they were made for.
    pub fn finish(&mut self) -> Option<Cause> {
        match std::mem::replace(&mut self.phase, Phase::Current) {
            Phase::Current => None,
            Phase::Due { cause, .. } => Some(cause),
        }
    }
}
