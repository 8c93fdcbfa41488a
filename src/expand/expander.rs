//! The state of one expansion, its entry point and its limits.
use ecow::EcoString;

use super::before::Before;
use super::binding_info::ArgumentValue;
use super::binding_info::{BindingId, BindingInfo};
use super::expansion::Expansion;
use super::flow::{Flow, Gaps};
use super::kind::ProblemKind;
use super::macro_table::Macros;
use super::names::{EvalContext, NameTables};
use super::node::{XAttr, XId};
use super::origin::{Frame, FrameId, FrameKind, Origin};
use super::problem::{Problem, Severity};
use super::problems::Problems;
use super::record::Read;
use super::request::{Request, Sources};
use super::scope::Scopes;
use super::stack::with_stack;
use super::state::{Guards, IncludeFrame, Probing, ReadFiles, Steps};
use super::tree::XTree;
use base::FastMap;
use base::clock::Instant;
use expr::Value;

/// Expand a file. Never fails: what went wrong is in [`Expansion::problems`].
pub fn expand(sources: Sources<'_>, request: &Request) -> Expansion {
    expand_again(sources, request, None)
}

/// The same after an edit: macro calls of the root are taken over from the expansion `before` where nothing that they read
/// has changed. The result is the same as that of [`expand`].
pub fn expand_again(
    sources: Sources<'_>,
    request: &Request,
    before: Option<&Expansion>,
) -> Expansion {
    let run = |before| with_stack(|| Expander::new(sources, request, before).run());
    let made = run(Before::of(before, request)).or_else(|| run(None));
    let made = made.unwrap_or_default();
    #[cfg(debug_assertions)]
    if before.is_some() && !request.cancel.is_cancelled() {
        let fresh = run(None).unwrap_or_default();
        // a new edit may have cut it short
        if !request.cancel.is_cancelled() {
            super::verify::same(&made, &fresh);
        }
    }
    made
}

/// Whether the root element has an element: blank text in it means nothing then.
pub(super) fn has_elements(tree: &XTree) -> bool {
    tree.root()
        .is_some_and(|root| tree.elements(root).next().is_some())
}

/// How to raise a limit of the configuration.
pub(super) fn raise(key: &str) -> String {
    format!("raise `{key}` under `[limits]` in xacro-lint.toml if the robot is really that large")
}

/// The state of an expansion.
pub(super) struct Expander<'w> {
    pub sources: Sources<'w>,
    pub request: &'w Request,
    pub result: Expansion,
    pub problems: Problems,
    pub names: NameTables,
    pub files: ReadFiles,
    pub guards: Guards,
    pub flow: Flow,
    pub gaps: Gaps,
    pub probing: Probing,
    pub steps: Steps<'w>,
    /// The one empty text node that stops comment removal; it moves around.
    pub marker: XId,
    /// Room for the attributes of an element while they are evaluated.
    pub attrs: Vec<XAttr>,
}

impl<'w> Expander<'w> {
    /// Steps shown of the way to a problem.
    pub(super) const TRACE_STEPS: usize = 100;

    fn new(sources: Sources<'w>, request: &'w Request, before: Option<Before<'w>>) -> Self {
        let mut result = Expansion {
            complete: true,
            ..Expansion::default()
        };
        if let Some(before) = before {
            result.reserve_like(before.expansion);
        }
        result.frames.push(Frame {
            kind: FrameKind::Root,
            name: request.file.as_str().into(),
            call: Origin::NOWHERE,
            definition: None,
            depth: 0,
        });
        let marker = result.tree.add_marker();
        Self {
            sources,
            request,
            result,
            problems: Problems::default(),
            names: NameTables::new(),
            files: ReadFiles::new(),
            guards: Guards::new(request),
            flow: Flow::default(),
            gaps: Gaps::default(),
            probing: Probing::default(),
            steps: Steps::new(request, before),
            marker,
            attrs: Vec::new(),
        }
    }

    /// None when items were left out of which more is needed than was kept.
    fn run(mut self) -> Option<Expansion> {
        self.bind_arguments();
        self.expand_root();
        if self.steps.left_out > 0 && !has_elements(&self.result.tree) {
            // blank text between its items is part of such a document
            return None;
        }
        self.result.complete &= self.steps.checkpoints.iter().all(|one| one.is_complete);
        self.keep_open_scopes();
        self.admit_unknown();
        self.probe_macros();
        self.probe_properties();
        self.result.arguments = self.argument_values();
        let broken = &self.files.broken;
        // what the recovered tree of a broken file seems to say is not trusted
        let trusted = |p: &Problem| p.kind.is_about_text() || !broken.contains(&p.place.file);
        let (kept, untrusted) = std::mem::take(&mut self.problems.list)
            .into_iter()
            .partition(trusted);
        self.result.problems = kept;
        self.result.untrusted = untrusted;
        self.result.whole =
            !(self.gaps.content_lost || self.gaps.include_missing || self.flow.stopped);
        self.result.complete &= !self.result.has_errors();
        if self.request.keep {
            // it will be looked at often; what it was made with is not needed any more
            self.files.texts = FastMap::default();
            let resume = self.resume_state();
            self.names.scopes = Scopes::new();
            let Expansion { tree, index, .. } = &mut self.result;
            let beside = index.probes.iter_mut().map(|probe| &mut probe.content);
            let moved = tree.compact(beside);
            self.result.memo = Some(Box::new(self.memo(&moved, resume)));
            self.result.shrink();
        }
        let result = std::mem::take(&mut self.result);
        if self.request.last {
            std::mem::forget(self);
        }
        Some(result)
    }

    fn argument_values(&self) -> Vec<(EcoString, EcoString)> {
        let known =
            |(name, (value, _)): (&EcoString, &ArgumentValue)| Some((name.clone(), value.clone()?));
        let mut values: Vec<_> = self.names.args.iter().filter_map(known).collect();
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
        let asked_for = self.gaps.guessed || !self.request.unknown_args.is_empty();
        if self.result.complete
            || reported
            || asked_for
            || self.flow.stopped
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
            self.names.args.insert(name.as_str().into(), (None, info));
        }
        for (name, value) in &request.args {
            let info =
                self.add_binding(BindingInfo::given(name, Value::Str(value.as_str().into())));
            self.names
                .args
                .insert(name.as_str().into(), (Some(value.as_str().into()), info));
            self.result
                .record
                .add(Read::Arg(name.clone(), Some(value.clone())));
        }
    }

    fn expand_root(&mut self) {
        let name = self.request.file.clone();
        self.files.open.push(IncludeFrame {
            name: name.clone(),
            file: None,
            conditions: 0,
        });
        let Some(file) = self.load(&name, Origin::NOWHERE, None) else {
            return;
        };
        if let Some(open) = self.files.open.last_mut() {
            open.file = Some(file);
        }
        let cx = EvalContext {
            scope: Scopes::TOP,
            macros: Macros::TOP,
            frame: FrameId::ROOT,
        };
        self.eval_document(file, cx);
    }

    /// Note the passing of time at a node; true when expansion must wind up.
    pub fn tick(&mut self, at: Origin) -> bool {
        if self.flow.stopped || self.flow.unwinding {
            return true;
        }
        self.guards.ticks += 1;
        if self.nodes_made() as u64 > self.request.limits.expand_nodes {
            let most = self.request.limits.expand_nodes;
            self.stop(
                at,
                format!("the expanded robot has more than {most} nodes"),
                Some("expand-nodes"),
            );
        } else if self.guards.ticks.is_multiple_of(256) {
            if self.request.cancel.is_cancelled() {
                self.flow.stopped = true;
                self.result.complete = false;
            } else if Instant::now() > self.guards.deadline {
                let most = self.request.limits.expand_time.as_millis();
                self.stop(
                    at,
                    format!("the expansion takes more than {most} ms"),
                    Some("expand-ms"),
                );
            }
        }
        self.flow.stopped
    }

    /// Wind up because a limit was reached; `key` is its name in the configuration, where it has one.
    pub(super) fn stop(&mut self, at: Origin, message: String, key: Option<&str>) {
        if self.flow.stopped {
            return;
        }
        self.flow.stopped = true;
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
        let outer = self.result.frames.get(call.frame).map_or(0, |f| f.depth);
        let depth = outer + u32::from(kind == FrameKind::Macro);
        self.result.frames.push(Frame {
            kind,
            name,
            call,
            definition,
            depth,
        })
    }

    /// A new binding; its number goes into the pieces that read it.
    pub fn add_binding(&mut self, info: BindingInfo) -> BindingId {
        self.result.index.bindings.push(info)
    }
}
