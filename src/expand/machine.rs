//! The state of one expansion, its entry point and its limits.

use std::path::Path;
use std::sync::Arc;

use ecow::EcoString;

use super::expansion::Expansion;
use super::kind::ProblemKind;
use super::late::Undefined;
use super::memo::{Kept, Recorder};
use super::origin::{FileIdx, Frame, FrameId, FrameKind, Origin};
use super::problem::{Problem, Problems, Severity};
use super::record::Read;
use super::replay::Before;
use super::request::{Request, World};
use super::resolve::{BindingInfo, LazyUse};
use super::scope::{MacroDef, Macros, MacrosId, Scopes};
use super::stack::with_stack;
use super::text::SplitText;
use super::tree::{XAttr, XId, XKind};
use base::clock::Instant;
use base::limits::{self, EVAL_DEPTH};
use base::{FastMap, FastSet};
use expr::{Budget, ScopeId, Value};

/// Expand a file. Never fails: what went wrong is in [`Expansion::problems`].
///
pub fn expand(world: World<'_>, request: &Request) -> Expansion {
    expand_again(world, request, None)
}

/// The same after an edit: macro calls of the root are taken over from the expansion `before` where nothing that they read
/// has changed. The result is the same as that of [`expand`].
pub fn expand_again(world: World<'_>, request: &Request, before: Option<&Expansion>) -> Expansion {
    let made = with_stack(|| Expander::new(world, request, Before::of(before, request)).run());
    #[cfg(debug_assertions)]
    if before.is_some() && !request.cancel.is_cancelled() {
        let fresh = with_stack(|| Expander::new(world, request, None).run());
        // a new edit may have cut it short
        if !request.cancel.is_cancelled() {
            super::verify::same(&made, &fresh);
        }
    }
    made
}

/// How to raise a limit of the configuration.
pub(super) fn raise(key: &str) -> String {
    format!("raise `{key}` under `[limits]` in xacro-lint.toml if the robot is really that large")
}

/// Where evaluation stands: the scope chains and the way that led here.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cx {
    pub scope: ScopeId,
    pub macros: MacrosId,
    pub frame: FrameId,
}

/// A file being processed: what relative names are relative to.
#[derive(Clone, Debug)]
pub(super) struct OpenFile {
    pub name: String,
    pub file: Option<FileIdx>,
    /// How many conditions stood around the include.
    pub conditions: u32,
}

/// The machine.
pub(super) struct Expander<'w> {
    pub world: World<'w>,
    pub request: &'w Request,
    pub result: Expansion,
    pub problems: Problems,
    pub scopes: Scopes,
    pub macros: Macros,
    /// Arguments: value (none when unknown) and binding.
    pub args: FastMap<EcoString, (Option<EcoString>, u32)>,
    pub open_files: Vec<OpenFile>,
    /// Files by absolute path.
    pub by_path: FastMap<Arc<Path>, FileIdx>,
    /// Texts of macros in their split form, and their bytes.
    pub texts: FastMap<EcoString, Arc<SplitText>>,
    pub text_bytes: usize,
    /// The one empty text node that stops comment removal; it moves around.
    pub marker: XId,
    pub budget: Budget,
    pub deadline: Instant,
    /// How many entries of folders may still be looked at for includes with stars.
    pub glob_entries: usize,
    /// Lazy properties being evaluated, outermost first.
    pub lazy_uses: Vec<LazyUse>,
    /// Bindings read since the mark of whoever is interested.
    pub reads: Vec<u32>,
    /// Room for the attributes of an element while they are evaluated.
    pub attrs: Vec<XAttr>,
    /// An include is missing: undefined names are then no news.
    pub include_missing: bool,
    /// Names that undefined ones were compared with.
    pub compared: usize,
    /// The content of a condition or call is missing, because it could not be decided.
    pub content_lost: bool,
    /// How often that happened.
    pub losses: u32,
    /// A variable of the environment has one of several values.
    pub guessed: bool,
    /// Files that are not well-formed.
    pub broken: FastSet<FileIdx>,
    /// Problems about undefined names, in case they turn out to be defined later.
    pub undefined: Undefined,
    /// Macros being expanded, and how many conditions stood around each call.
    pub calls: Vec<(usize, u32)>,
    /// For each include being processed: whether it is optional.
    pub optional_includes: Vec<bool>,
    /// A file is missing inside an optional include: wind up until that include.
    pub unwinding: bool,
    /// Conditionals (and computed calls and includes) around the current place.
    pub conditions: u32,
    /// Blocks inserted inside blocks.
    pub block_depth: u32,
    /// Inside how many conditionals whose value is unknown.
    pub unknown_conditions: u32,
    /// Elements open around the current one.
    pub nesting: u32,
    /// A limit was reached or the request was cancelled: wind up.
    pub stopped: bool,
    /// Macros that may be looked into although nothing calls them.
    pub idle_macros: Vec<(Arc<MacroDef>, Cx)>,
    /// Properties that nothing reads are being evaluated: what they read is not used by that.
    pub idle: bool,
    /// The last expansion of this root.
    pub before: Option<Before<'w>>,
    /// Whether steps are kept for the next expansion.
    pub keeps_steps: bool,
    /// The steps so far.
    pub steps: Vec<Kept>,
    /// What the step that is evaluated now reads.
    pub recorder: Option<Recorder>,
    /// How many steps were taken over.
    pub taken_over: usize,
    /// How many nodes were not made since steps were taken over.
    pub nodes_left_out: usize,
    ticks: u32,
}

impl<'w> Expander<'w> {
    /// Steps shown of the way to a problem.
    pub(super) const TRACE_STEPS: usize = 100;

    fn new(world: World<'w>, request: &'w Request, before: Option<Before<'w>>) -> Self {
        let mut result = Expansion {
            complete: true,
            ..Expansion::default()
        };
        result.frames.push(Frame {
            kind: FrameKind::Root,
            name: request.file.as_str().into(),
            call: Origin::NOWHERE,
            definition: None,
            depth: 0,
        });
        let marker = result.tree.add(XKind::Text, "\n\n".into(), Origin::NOWHERE);
        let limits = &request.limits;
        Self {
            world,
            request,
            result,
            problems: Problems::default(),
            scopes: Scopes::new(),
            macros: Macros::new(),
            args: FastMap::default(),
            open_files: Vec::new(),
            by_path: FastMap::default(),
            texts: FastMap::default(),
            text_bytes: 0,
            marker,
            budget: Budget::new(limits.eval_steps, limits.output_bytes, EVAL_DEPTH),
            deadline: Instant::now() + limits.expand_time,
            glob_entries: limits::GLOB_ENTRIES,
            lazy_uses: Vec::new(),
            reads: Vec::new(),
            attrs: Vec::new(),
            include_missing: false,
            compared: 0,
            content_lost: false,
            losses: 0,
            guessed: false,
            broken: FastSet::default(),
            undefined: Undefined::default(),
            calls: Vec::new(),
            optional_includes: Vec::new(),
            unwinding: false,
            conditions: 0,
            block_depth: 0,
            unknown_conditions: 0,
            nesting: 0,
            stopped: false,
            idle_macros: Vec::new(),
            idle: false,
            before,
            keeps_steps: request.keep && request.forced.is_empty(),
            steps: Vec::new(),
            recorder: None,
            taken_over: 0,
            nodes_left_out: 0,
            ticks: 0,
        }
    }

    fn run(mut self) -> Expansion {
        self.bind_arguments();
        self.expand_root();
        self.admit_unknown();
        self.probe_macros();
        self.probe_properties();
        self.result.arguments = self.argument_values();
        let broken = std::mem::take(&mut self.broken);
        // what the recovered tree of a broken file seems to say is not trusted
        let trusted = |p: &Problem| p.kind.is_about_text() || !broken.contains(&p.place.file);
        let (kept, doubtful) = std::mem::take(&mut self.problems.list)
            .into_iter()
            .partition(trusted);
        self.result.problems = kept;
        self.result.doubtful = doubtful;
        self.result.whole = !(self.content_lost || self.include_missing || self.stopped);
        self.result.complete &= !self.result.has_errors();
        if self.request.keep {
            // it will be looked at often; what it was made with is not needed any more
            (self.texts, self.scopes) = (FastMap::default(), Scopes::new());
            let ordinals = self.step_ordinals();
            let Expansion { tree, probes, .. } = &mut self.result;
            tree.compact(probes.iter_mut().map(|probe| &mut probe.content));
            self.result.memo = Some(Box::new(self.placed_steps(&ordinals)));
            self.result.shrink();
        }
        let result = std::mem::take(&mut self.result);
        if self.request.last {
            std::mem::forget(self);
        }
        result
    }

    fn argument_values(&self) -> Vec<(EcoString, EcoString)> {
        let known = |(name, (value, _)): (&EcoString, &(Option<EcoString>, u32))| {
            Some((name.clone(), value.clone()?))
        };
        let mut values: Vec<_> = self.args.iter().filter_map(known).collect();
        values.sort_unstable();
        values
    }

    /// What could not be computed has a cause that was reported. Should one be missing, that is said here: a
    /// document with a hole never passes for a good one.
    fn admit_unknown(&mut self) {
        let reported = self
            .problems
            .list
            .iter()
            .any(|problem| problem.severity == Severity::Error);
        let asked_for = self.guessed || !self.request.unknown_args.is_empty();
        if self.result.complete
            || reported
            || asked_for
            || self.stopped
            || self.result.root_error.is_some()
        {
            return;
        }
        let tree = &self.result.tree;
        let pieces = tree
            .below(XId::DOCUMENT)
            .flat_map(|id| &tree.get(id).attrs)
            .flat_map(|a| &a.pieces);
        let hole = pieces
            .filter(|piece| piece.unknown)
            .map(|piece| piece.source)
            .next();
        let root = tree
            .root()
            .map_or(Origin::NOWHERE, |root| tree.get(root).origin);
        let message = match hole {
            Some(_) => "expression uses an unsupported Python feature",
            None => "an expression in this file uses an unsupported Python feature",
        };
        self.error(
            ProblemKind::ExpressionError,
            hole.unwrap_or(root),
            message,
            message,
        );
    }

    fn bind_arguments(&mut self) {
        let request = self.request;
        for name in &request.unknown_args {
            let info = self.add_binding(BindingInfo::given(name, Value::Unknown));
            self.args.insert(name.as_str().into(), (None, info));
        }
        for (name, value) in &request.args {
            let info =
                self.add_binding(BindingInfo::given(name, Value::Str(value.as_str().into())));
            self.args
                .insert(name.as_str().into(), (Some(value.as_str().into()), info));
            self.result
                .record
                .add(Read::Arg(name.clone(), Some(value.clone())));
        }
    }

    fn expand_root(&mut self) {
        let name = self.request.file.clone();
        self.open_files.push(OpenFile {
            name: name.clone(),
            file: None,
            conditions: 0,
        });
        let Some(file) = self.load(&name, Origin::NOWHERE, None) else {
            return;
        };
        if let Some(open) = self.open_files.last_mut() {
            open.file = Some(file);
        }
        let cx = Cx {
            scope: Scopes::TOP,
            macros: Macros::TOP,
            frame: FrameId::ROOT,
        };
        self.eval_document(file, cx);
    }

    /// Note the passing of time at a node; true when expansion must wind up.
    pub fn tick(&mut self, at: Origin) -> bool {
        if self.stopped || self.unwinding {
            return true;
        }
        self.ticks += 1;
        if self.nodes_made() as u64 > self.request.limits.expand_nodes {
            let most = self.request.limits.expand_nodes;
            self.stop(
                at,
                format!("the expanded robot has more than {most} nodes"),
                Some("expand-nodes"),
            );
        } else if self.ticks.is_multiple_of(256) {
            if self.request.cancel.is_cancelled() {
                self.stopped = true;
                self.result.complete = false;
            } else if Instant::now() > self.deadline {
                let most = self.request.limits.expand_time.as_millis();
                self.stop(
                    at,
                    format!("the expansion takes more than {most} ms"),
                    Some("expand-ms"),
                );
            }
        }
        self.stopped
    }

    /// Wind up because a limit was reached; `key` is its name in the configuration, where it has one.
    pub(super) fn stop(&mut self, at: Origin, message: String, key: Option<&str>) {
        if self.stopped {
            return;
        }
        self.stopped = true;
        let mut problem = self.problem(ProblemKind::InfiniteMacroRecursion, at, message);
        if let Some(key) = key {
            problem = problem.help(raise(key));
        }
        self.problems.push(problem);
    }

    /// Enter a step: the frame for what the tag at `call` leads to.
    pub fn push_frame(
        &mut self,
        kind: FrameKind,
        name: EcoString,
        call: Origin,
        definition: Option<Origin>,
    ) -> FrameId {
        let outer = self
            .result
            .frames
            .get(call.frame.0 as usize)
            .map_or(0, |f| f.depth);
        let depth = outer + u32::from(kind == FrameKind::Macro);
        let id = FrameId(self.result.frames.len() as u32);
        self.result.frames.push(Frame {
            kind,
            name,
            call,
            definition,
            depth,
        });
        id
    }

    /// A new binding; its number goes into the pieces that read it.
    pub fn add_binding(&mut self, info: BindingInfo) -> u32 {
        let id = self.result.bindings.len() as u32;
        self.result.bindings.push(info);
        id
    }
}
