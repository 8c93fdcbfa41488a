//! Names that are used first and defined later: not missing, only too late.

use ecow::EcoString;

use super::machine::Expander;
use super::origin::Origin;
use super::problem::{Problem, Step};
use crate::base::FastMap;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum NameKind {
    Property,
    Macro,
    Arg,
}

impl NameKind {
    fn noun(self) -> &'static str {
        match self {
            NameKind::Property => "property",
            NameKind::Macro => "macro",
            NameKind::Arg => "argument",
        }
    }
}

/// Problems about undefined names, by name: indices into the list of problems.
pub(super) type Undefined = FastMap<(NameKind, EcoString), Vec<usize>>;

impl Expander<'_> {
    /// Report a problem, unless expansion is on its way out of an optional include, or looks at what is not used.
    pub fn push(&mut self, problem: Problem) {
        if !self.unwinding && !self.idle {
            self.problems.push(problem);
        }
    }

    /// Whether a problem is known or not to be reported at all; a further call that leads to it is noted.
    pub fn is_repeated(&mut self, code: &'static str, at: Origin, message: &str) -> bool {
        if self.unwinding || self.idle {
            return true;
        }
        let Some(place) = self.result.place(at) else { return false };
        let Some(known) = self.problems.find(code, place, message) else { return false };
        if self.problems.wants_calls(known) {
            let call = self.trace(at, 1).pop();
            self.problems.add_call(known, call);
        }
        true
    }

    /// Report that a name is not defined (yet).
    pub fn push_undefined(&mut self, kind: NameKind, name: &str, problem: Problem) {
        let before = self.problems.list.len();
        self.push(problem);
        if self.problems.list.len() > before {
            self.undefined.entry((kind, name.into())).or_default().push(before);
        }
    }

    /// A name is defined at `at`: whoever complained about it before came too early.
    pub fn defined(&mut self, kind: NameKind, name: &EcoString, at: Origin) {
        if self.undefined.is_empty() {
            return;
        }
        let Some(early) = self.undefined.remove(&(kind, name.clone())) else { return };
        let Some(place) = self.result.place(at) else { return };
        let noun = kind.noun();
        let step = Step { place, message: format!("{noun} `{name}` is defined only here") };
        for i in early {
            let Some(problem) = self.problems.list.get_mut(i) else { continue };
            problem.code = "XAC037";
            problem.message = format!("{noun} `{name}` is used before it is defined");
            problem.help = Some(match kind {
                NameKind::Arg => format!(
                    "the file is read from top to bottom, attributes of the root element first: \
                     give `{name}:=...` from outside, or do not use `$(arg {name})` above its declaration"
                ),
                _ => "xacro reads from top to bottom: move the definition up".to_owned(),
            });
            problem.replacement = None;
            problem.trace.insert(0, step.clone());
        }
    }
}
