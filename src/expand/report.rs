//! Reporting problems, and how expansion came to a place.
use super::expander::Expander;
use super::kind::ProblemKind;
use super::origin::{FileIdx, Frame, FrameKind, Origin};
use super::problem::{FileRange as ProblemPlace, Problem, TraceStep, step_message};
use base::{FastSet, TextRange};

impl Expander<'_> {
    /// A problem at `at`, with the way that led there.
    pub fn problem(&self, kind: ProblemKind, at: Origin, message: impl Into<String>) -> Problem {
        let place = self.result.place(at).unwrap_or(ProblemPlace {
            file: FileIdx(0),
            range: TextRange::default(),
        });
        Problem::new(kind, place, message).via(self.trace(at, Self::TRACE_STEPS))
    }

    /// Report an error at `at`; `reference` is what xacro says.
    pub fn error(
        &mut self,
        kind: ProblemKind,
        at: Origin,
        message: impl Into<String>,
        reference: impl Into<String>,
    ) {
        let problem = self.problem(kind, at, message).says(reference);
        self.push(problem);
    }

    /// Report a warning at `at`; `reference` is what xacro says.
    pub fn warn(
        &mut self,
        kind: ProblemKind,
        at: Origin,
        message: impl Into<String>,
        reference: impl Into<String>,
    ) {
        let problem = self.problem(kind, at, message).says(reference).warning();
        self.push(problem);
    }

    /// How expansion came to `at`, in at most `most` steps: uses of lazy properties, then the frames around the
    /// innermost use. Calls may be nested deeply: what is beyond is not worked out.
    pub(super) fn trace(&self, at: Origin, most: usize) -> Vec<TraceStep> {
        let mut steps = Vec::new();
        let mut from = at;
        for used in self.names.lazy_uses.iter().rev() {
            if steps.len() >= most {
                break;
            }
            let outside: FastSet<*const Frame> = self
                .result
                .frames_of(used.at)
                .map(std::ptr::from_ref)
                .collect();
            let own = self
                .result
                .frames_of(from)
                .take_while(|&frame| !outside.contains(&std::ptr::from_ref(frame)));
            self.add_steps(own, most, &mut steps);
            let message = format!("property `{}` is evaluated here", used.name);
            steps.extend(
                self.result
                    .place(used.at)
                    .map(|place| TraceStep { place, message }),
            );
            from = used.at;
        }
        self.add_steps(self.result.frames_of(from), most, &mut steps);
        steps.truncate(most);
        steps
    }

    fn add_steps<'f>(
        &self,
        frames: impl Iterator<Item = &'f Frame>,
        most: usize,
        steps: &mut Vec<TraceStep>,
    ) {
        let placed = frames.filter_map(|frame| {
            Some(TraceStep {
                place: self.result.place(frame.call)?,
                message: step_message(frame),
            })
        });
        let left = most.saturating_sub(steps.len());
        steps.extend(placed.take(left));
    }

    /// What the reference prints to say where it is.
    pub fn location_lines(&self, at: Origin) -> Vec<String> {
        let mut lines = Vec::new();
        let mut lead = "when instantiating macro:";
        for frame in self
            .result
            .frames_of(at)
            .filter(|f| f.kind == FrameKind::Macro)
        {
            let file = frame
                .definition
                .and_then(|origin| self.result.place(origin))
                .and_then(|place| self.result.files.get(place.file))
                .map_or("???", |file| file.name.as_str());
            lines.push(format!("{lead} {} ({file})", frame.name));
            lead = "instantiated from:";
        }
        let mut lead = if lines.is_empty() {
            "when processing file:"
        } else {
            "in file:"
        };
        for file in self.files.open.iter().rev() {
            lines.push(format!("{lead} {}", file.name));
            lead = "included from:";
        }
        lines
    }

    /// The name of the file being processed now.
    pub fn current_file(&self) -> &str {
        self.files.open.last().map_or("", |f| f.name.as_str())
    }
}
