//! Launch files and scripts in Python, read as text: what calls xacro, and the values that the text itself says.
//!
//! The program is walked from top to bottom as if every branch were taken. A variable that branches set differently, that a
//! loop sets, or that anything sets that is not understood, is unknown from then on. Nothing is executed.

mod assign;
mod builtins;
mod calls;
mod expressions;
mod methods;
mod scope;
mod statements;
mod unstarted;
mod value;

use std::path::Path;

use base::limits::{LAUNCH_DEPTH, LAUNCH_STEPS};
use base::{FastSet, TextRange};

use self::scope::{VariableScopes, Variables, joined};
use self::statements::{PythonKeyword, Statement, statements};
use self::unstarted::{Assignment, leave_out};
use self::value::PythonValue;
use super::{CommandForm, LaunchCommand, LaunchFile, UnresolvedArgument};

/// What a program calls.
pub(super) fn read(path: &Path, text: &str) -> LaunchFile {
    let parsed = statements(text);
    let mut reader = PythonReader {
        path,
        text,
        functions: Vec::new(),
        evaluated: FastSet::default(),
        active: Vec::new(),
        scopes: VariableScopes::default(),
        deferred: Vec::new(),
        returned: Vec::new(),
        assumed: Vec::new(),
        noticed: None,
        steps: LAUNCH_STEPS,
        depth: 0,
        base: 0,
        assignments: Vec::new(),
        found: LaunchFile::of(path),
    };
    reader.scopes.enter(Variables::default(), 0);
    reader.block(&parsed);
    reader.run_deferred();
    reader.run_functions();
    leave_out(&mut reader.found, text, &reader.assignments);
    reader.found
}

/// A function of the file.
#[derive(Clone, Copy)]
struct PythonFunction<'s> {
    statement: &'s Statement,
    /// The frame that it is written in.
    outer: usize,
}

/// A function that the launch system calls later.
struct Deferred {
    /// The frame that gives it.
    frame: usize,
    number: usize,
    args: Vec<PythonValue>,
    named: Vec<(String, PythonValue)>,
}

struct PythonReader<'s> {
    path: &'s Path,
    text: &'s str,
    functions: Vec<PythonFunction<'s>>,
    /// Functions that were read with somebody's arguments.
    evaluated: FastSet<usize>,
    /// Functions that are being read.
    active: Vec<usize>,
    scopes: VariableScopes,
    /// Functions that the launch system calls later.
    deferred: Vec<Deferred>,
    /// What the functions that are being read return.
    returned: Vec<Option<PythonValue>>,
    /// Arguments of the launch file that the branches around have decided.
    assumed: Vec<String>,
    /// The arguments that a condition reads.
    noticed: Option<Vec<String>>,
    steps: usize,
    depth: usize,
    /// Where the statement stands that is being read.
    base: u32,
    assignments: Vec<Assignment>,
    found: LaunchFile,
}

impl<'s> PythonReader<'s> {
    /// Whether there is budget left; takes some of it.
    fn spend(&mut self, steps: usize) -> bool {
        self.steps = self.steps.saturating_sub(steps);
        self.steps > 0
    }

    fn block(&mut self, block: &'s [Statement]) {
        let mut at = 0;
        while let Some(statement) = block.get(at) {
            if !self.spend(1) {
                return;
            }
            let chain = block.get(at + 1..).unwrap_or_default();
            let chain = chain
                .iter()
                .take_while(|next| continues(statement, next))
                .count();
            match statement.keyword {
                Some(PythonKeyword::If) => {
                    self.branches(block.get(at..=at + chain).unwrap_or_default())
                }
                Some(PythonKeyword::Try) => {
                    self.attempts(block.get(at..=at + chain).unwrap_or_default())
                }
                Some(PythonKeyword::Loop) => {
                    self.repeated(statement);
                    block
                        .get(at + 1..=at + chain)
                        .unwrap_or_default()
                        .iter()
                        .for_each(|s| self.block(&s.body));
                }
                _ => self.statement(statement),
            }
            at += chain + 1;
        }
    }

    /// `if`, `elif`, `else`: each from the same start.
    fn branches(&mut self, chain: &'s [Statement]) {
        let assumed = self.assumed.len();
        let mut results: Vec<Variables> = Vec::new();
        let mut has_else = false;
        for branch in chain {
            if branch.keyword == Some(PythonKeyword::Else) {
                has_else = true;
            } else {
                let test = self.conditions_of(branch);
                self.assumed.extend(test);
            }
            let before = self.scopes.own();
            if !self.spend(before.len() + 1) {
                break;
            }
            self.block(&branch.body);
            let after = self.scopes.replace(before);
            if !leaves(&branch.body) {
                results.push(after);
            }
        }
        self.assumed.truncate(assumed);
        if !has_else {
            results.push(self.scopes.own());
        }
        self.settle(results);
    }

    /// `try` and what follows: an exception may come after any statement, so what `except` sets may hold, or not.
    fn attempts(&mut self, chain: &'s [Statement]) {
        let mut results: Vec<Variables> = Vec::new();
        let mut body: Option<Variables> = None;
        for part in chain {
            match part.keyword {
                Some(PythonKeyword::Except) => {
                    let before = self.scopes.own();
                    self.block(&part.body);
                    let after = self.scopes.replace(before);
                    if !leaves(&part.body) {
                        results.push(after);
                    }
                }
                Some(PythonKeyword::Try) => {
                    self.block(&part.body);
                    body = (!leaves(&part.body)).then(|| self.scopes.own());
                }
                _ => {}
            }
        }
        results.extend(body);
        self.settle(results);
        for part in chain.iter().filter(|p| {
            matches!(
                p.keyword,
                Some(PythonKeyword::Else | PythonKeyword::Finally)
            )
        }) {
            self.block(&part.body);
        }
    }

    /// Go on with what the ways to this point agree on.
    fn settle(&mut self, results: Vec<Variables>) {
        if let Some(all) = results.into_iter().reduce(joined) {
            self.scopes.replace(all);
        }
    }

    /// A loop: what it sets is unknown in it and behind it.
    fn repeated(&mut self, statement: &'s Statement) {
        self.forget_assigned(statement, 0);
        self.conditions_of(statement);
        self.block(&statement.body);
        self.forget_assigned(statement, 0);
    }

    /// What a statement and those below it set is not known.
    fn forget_assigned(&mut self, statement: &'s Statement, depth: usize) {
        for name in assign::assigned(self.text, statement) {
            // a function of a module is no change of the module
            if statement.keyword.is_some()
                || !matches!(self.scopes.get(name), Some(PythonValue::Outer(_)))
            {
                self.scopes.set(name, PythonValue::Unknown);
            }
        }
        if depth < LAUNCH_DEPTH && self.spend(1) {
            statement
                .body
                .iter()
                .for_each(|below| self.forget_assigned(below, depth + 1));
        }
    }

    /// The arguments of the launch file that the condition of a statement reads.
    fn conditions_of(&mut self, statement: &'s Statement) -> Vec<String> {
        let code = statement.range.slice(self.text);
        let word = code
            .split(|c: char| !c.is_alphanumeric())
            .next()
            .unwrap_or("");
        let test = TextRange::new(
            statement.range.start + word.len() as u32,
            statement.range.end,
        );
        let outer = self.noticed.replace(Vec::new());
        if word == "for" {
            if let Some((_, iterated)) = code.split_once(" in ") {
                let start = statement.range.end - iterated.len() as u32;
                self.value_at(TextRange::new(start, statement.range.end));
            }
        } else {
            self.value_at(test);
        }
        let own = std::mem::replace(&mut self.noticed, outer).unwrap_or_default();
        if let Some(outer) = &mut self.noticed {
            outer.extend(own.iter().cloned());
        }
        own
    }

    /// Read functions that nothing in the file calls: first what the launch system calls, then the others.
    fn run_functions(&mut self) {
        let named = |function: &PythonFunction<'_>, text: &str, name: &str| {
            let head = function.statement.range.slice(text);
            head.split(['(', ' ']).nth(1) == Some(name)
        };
        for entry in ["generate_launch_description", "generate_test_description"] {
            let number = self
                .functions
                .iter()
                .position(|f| f.outer == 0 && named(f, self.text, entry));
            if let Some(number) = number.filter(|number| !self.evaluated.contains(number)) {
                self.call(number, Vec::new(), Vec::new());
            }
        }
        let mut number = 0;
        while number < self.functions.len() && self.steps > 0 {
            if !self.evaluated.contains(&number) {
                self.call(
                    number,
                    Vec::new(),
                    vec![("**".to_owned(), PythonValue::Unknown)],
                );
            }
            number += 1;
        }
    }

    /// Read the functions that the launch system calls when the function that gave them is done.
    fn run_deferred(&mut self) {
        let depth = self.scopes.depth();
        while let Some(at) = self.deferred.iter().position(|later| later.frame >= depth) {
            let Deferred {
                number,
                args,
                named,
                ..
            } = self.deferred.remove(at);
            self.call(number, args, named);
        }
    }

    fn record(&mut self, range: TextRange, what: CommandForm) {
        let assumed = self.assumed.clone();
        LaunchCommand::at(range, what, assumed).add_to(&mut self.found.commands);
    }

    fn load(&mut self, range: TextRange, what: CommandForm) {
        let assumed = self.assumed.clone();
        LaunchCommand::at(range, what, assumed).add_to(&mut self.found.loads);
    }

    fn file(&mut self, range: TextRange, what: CommandForm) {
        let assumed = self.assumed.clone();
        LaunchCommand::at(range, what, assumed).add_to(&mut self.found.files);
    }

    /// Pairs of a dictionary as what a call gives.
    fn given(pairs: Vec<(String, PythonValue)>) -> Vec<UnresolvedArgument> {
        pairs
            .into_iter()
            .map(|(name, value)| UnresolvedArgument {
                name,
                range: None,
                value: value.written(),
            })
            .collect()
    }
}

/// Whether a statement belongs to the one before: `else` to `if`.
fn continues(first: &Statement, next: &Statement) -> bool {
    match first.keyword {
        Some(PythonKeyword::If) => matches!(
            next.keyword,
            Some(PythonKeyword::Elif | PythonKeyword::Else)
        ),
        Some(PythonKeyword::Loop) => next.keyword == Some(PythonKeyword::Else),
        Some(PythonKeyword::Try) => {
            matches!(
                next.keyword,
                Some(PythonKeyword::Except | PythonKeyword::Else | PythonKeyword::Finally)
            )
        }
        _ => false,
    }
}

/// Whether control never comes out at the end of a block.
fn leaves(block: &[Statement]) -> bool {
    block.last().is_some_and(|last| {
        matches!(
            last.keyword,
            Some(PythonKeyword::Return | PythonKeyword::Leave)
        )
    })
}
