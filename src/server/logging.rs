//! The log of the server: on standard error as `XACRO_LOG` asks for, at the client as `$/setTrace` asks for, and the last
//! lines of it for reports of defects. It names files, never folders or texts.
use std::collections::VecDeque;
use std::fmt::{Debug, Write};
use std::sync::{Arc, Mutex, PoisonError};

use lsp_types::notification::{LogTrace, Notification};
use lsp_types::{LogTraceParams, TraceValue};
use tracing::field::{Field, Visit};
use tracing::level_filters::LevelFilter;
use tracing::{Event, Level, Subscriber};
use tracing_subscriber::filter::{Filtered, Targets};
use tracing_subscriber::layer::{Context, Identity, Layered, SubscriberExt};
use tracing_subscriber::{Layer, Registry, fmt};

use crate::outbox::Outbox;
use base::clock::Instant;
use base::limits::LOG_LINES;
use vfs::Environment;

/// The variable that says what is written to standard error.
const VARIABLE: &str = "XACRO_LOG";

/// What is logged for the client and for reports.
#[derive(Clone)]
pub(super) struct Log(Arc<LogState>);

struct LogState {
    outbox: Outbox,
    start: Instant,
    trace: Mutex<TraceValue>,
    last: Mutex<VecDeque<String>>,
}

impl Log {
    /// Begin to log, on standard error as well. Once a process: a second log gets no events.
    pub fn start(env: &Environment, outbox: Outbox) -> Self {
        let asked: Result<Option<Targets>, _> = env.var(VARIABLE).map(str::parse).transpose();
        let unreadable = asked.is_err();
        let shown = asked.unwrap_or_else(|_| Some(own())).map(|targets| {
            fmt::layer()
                .with_ansi(false)
                .with_writer(std::io::stderr)
                .with_filter(targets)
        });
        let log = Self::begin(outbox, shown);
        if unreadable {
            let levels = "`error`, `warn`, `info`, `debug` or `trace`";
            tracing::warn!(
                "`{VARIABLE}` is not one of {levels}, nor a list such as `server=debug`; using `debug`"
            );
        }
        log
    }

    /// Begin to log for the client and for reports alone.
    pub fn without_output(outbox: Outbox) -> Self {
        Self::begin(outbox, None::<Identity>)
    }

    fn begin<L>(outbox: Outbox, shown: Option<L>) -> Self
    where
        L: Layer<Layered<Filtered<Self, Targets, Registry>, Registry>> + Send + Sync,
    {
        let log = Self(Arc::new(LogState {
            outbox,
            start: Instant::now(),
            trace: Mutex::new(TraceValue::Off),
            last: Mutex::default(),
        }));
        let layers = tracing_subscriber::registry()
            .with(log.clone().with_filter(own()))
            .with(shown);
        let _ = tracing::subscriber::set_global_default(layers);
        log
    }

    /// Tell the client as much as it asks for.
    pub fn set_trace(&self, trace: TraceValue) {
        *self.0.trace.lock().unwrap_or_else(PoisonError::into_inner) = trace;
    }

    /// The last lines, the newest at the end.
    pub fn last(&self) -> Vec<String> {
        self.0
            .last
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .iter()
            .cloned()
            .collect()
    }

    fn keep(&self, line: String) {
        let mut last = self.0.last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.len() >= LOG_LINES {
            last.pop_front();
        }
        last.push_back(line);
    }
}

/// What we say ourselves.
fn own() -> Targets {
    Targets::new().with_target("server", LevelFilter::DEBUG)
}

impl<S: Subscriber> Layer<S> for Log {
    fn on_event(&self, event: &Event<'_>, _: Context<'_, S>) {
        let mut text = EventText::default();
        event.record(&mut text);
        let trace = *self.0.trace.lock().unwrap_or_else(PoisonError::into_inner);
        let is_told = match trace {
            TraceValue::Off => false,
            TraceValue::Messages => *event.metadata().level() <= Level::INFO,
            TraceValue::Verbose => true,
        };
        if is_told {
            let verbose = (trace == TraceValue::Verbose && !text.fields.is_empty())
                .then(|| text.fields.clone());
            let params = LogTraceParams {
                message: text.message.clone(),
                verbose,
            };
            self.0.outbox.notify(LogTrace::METHOD, &params);
        }
        let level = event.metadata().level().as_str().to_lowercase();
        let EventText { message, fields } = text;
        let fields = if fields.is_empty() {
            fields
        } else {
            format!(" ({fields})")
        };
        self.keep(format!(
            "{:.3} s {level}: {message}{fields}",
            self.0.start.elapsed().as_secs_f64()
        ));
    }
}

/// An event as text: its message, and its fields as `name=value`.
#[derive(Default)]
struct EventText {
    message: String,
    fields: String,
}

impl Visit for EventText {
    fn record_debug(&mut self, field: &Field, value: &dyn Debug) {
        if field.name() == "message" {
            let _ = write!(self.message, "{value:?}");
        } else {
            let blank = if self.fields.is_empty() { "" } else { " " };
            let _ = write!(self.fields, "{blank}{}={value:?}", field.name());
        }
    }
}
