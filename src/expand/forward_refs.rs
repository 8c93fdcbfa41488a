//! Names that are used first and defined later: not missing, only too late.
use ecow::EcoString;

use super::expander::Expander;
use super::kind::ProblemKind;
use super::origin::Origin;
use super::problem::{Outside, Problem, TraceStep};
use super::undefined::{Early, UndefinedKind, UndefinedName};
use base::limits::COMPARED_NAMES;
use expr::ScopeId;
use packages::{misspelled, nearest};

impl Expander<'_> {
    /// Whether names that are unknown are still compared with those there are.
    pub fn compares(&self) -> bool {
        self.names.compared < COMPARED_NAMES
    }

    /// What to report of a name that is not among those `known`. `None`: an include that is missing may define it, so it
    /// is reported only when it is misspelled.
    pub fn missing_name<'n>(
        &mut self,
        kind: UndefinedKind,
        name: &'n str,
        known: impl FnOnce(&Self) -> Vec<&str>,
    ) -> Option<UndefinedName<'n>> {
        let known = if self.compares() {
            known(self)
        } else {
            Vec::new()
        };
        let meant = misspelled(name, known.iter().copied());
        let is_misspelled = meant.is_some();
        let near = meant
            .or_else(|| nearest(name, known.iter().copied()))
            .map(EcoString::from);
        self.names.compared += known.len();
        if self.gaps.include_missing && !is_misspelled {
            self.result.complete = false;
            return None;
        }
        Some(UndefinedName {
            kind,
            name,
            is_misspelled,
            near,
        })
    }

    /// Report a problem, unless expansion is on its way out of an optional include, or looks at what is not used.
    pub fn push(&mut self, problem: Problem) {
        if !self.flow.unwinding && !self.probing.quiet {
            self.problems.push(problem);
        }
    }

    /// Whether a problem is known or not to be reported at all; a further call that leads to it is noted.
    pub fn is_repeated(&mut self, kind: ProblemKind, at: Origin, message: &str) -> bool {
        if self.flow.unwinding || self.probing.quiet {
            return true;
        }
        let Some(place) = self.result.place(at) else {
            return false;
        };
        let Some(known) = self.problems.find(kind, place, message) else {
            return false;
        };
        if self.problems.wants_calls(known) {
            let call = self.trace(at, 1).pop();
            self.problems.add_call(known, call);
        }
        true
    }

    /// Report that a name is not defined (yet) where `scope` sees it.
    pub fn push_undefined(
        &mut self,
        missing: UndefinedName<'_>,
        scope: ScopeId,
        mut problem: Problem,
    ) {
        let before = self.problems.list.len();
        let UndefinedName {
            kind,
            name,
            is_misspelled,
            ..
        } = missing;
        problem.outside = match kind {
            _ if is_misspelled => None,
            UndefinedKind::Arg => Some(Outside::Argument(name.into())),
            UndefinedKind::Property | UndefinedKind::Macro | UndefinedKind::Block => {
                Some(Outside::Includer)
            }
        };
        self.push(problem);
        if self.problems.list.len() > before {
            let early = Early {
                problem: before,
                scope,
            };
            self.names
                .undefined
                .entry((kind, name.into()))
                .or_default()
                .push(early);
        }
    }

    /// A name is defined at `at`, in `scope`: uses that see this scope came too early. A parameter of another macro that
    /// happens to have the name is no definition.
    pub fn defined(&mut self, kind: UndefinedKind, name: &EcoString, scope: ScopeId, at: Origin) {
        if self.names.undefined.is_empty() {
            return;
        }
        let Some(uses) = self.names.undefined.remove(&(kind, name.clone())) else {
            return;
        };
        let sees = |early: &Early| {
            kind == UndefinedKind::Arg || self.names.scopes.sees(early.scope, scope)
        };
        let (early, others): (Vec<Early>, Vec<Early>) = uses.into_iter().partition(sees);
        if !others.is_empty() {
            self.names.undefined.insert((kind, name.clone()), others);
        }
        let Some(place) = self.result.place(at) else {
            return;
        };
        let noun = kind.noun();
        let step = TraceStep {
            place,
            message: format!("{noun} `{name}` is defined here"),
        };
        for Early { problem, .. } in early {
            self.problems.changed += 1;
            let Some(problem) = self.problems.list.get_mut(problem) else {
                continue;
            };
            problem.kind = ProblemKind::UseBeforeDefinition;
            problem.message = format!("{noun} `{name}` is used before it is defined");
            problem.help = Some(match kind {
                UndefinedKind::Arg => format!(
                    "pass {name}:=..., or move <xacro:arg name=\"{name}\"> before `$(arg {name})`; xacro reads the \
                     attributes of the root element first"
                ),
                _ => {
                    "move the definition above its first use; xacro reads files from top to bottom"
                        .to_owned()
                }
            });
            problem.replacement = None;
            problem.trace.insert(0, step.clone());
        }
    }
}
