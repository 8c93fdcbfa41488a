//! Statements other than branches and loops: definitions, imports, assignments.

use base::TextRange;

use super::statements::{PythonKeyword, Statement};
use super::unstarted::Assignment;
use super::value::PythonValue;
use super::{PythonFunction, PythonReader};

impl<'s> PythonReader<'s> {
    pub(super) fn statement(&mut self, statement: &'s Statement) {
        match statement.keyword {
            Some(PythonKeyword::Def) => self.define(statement),
            Some(PythonKeyword::Import) => self.import(statement),
            Some(PythonKeyword::From) => self.import_from(statement),
            Some(PythonKeyword::Return) => self.returns(statement),
            Some(PythonKeyword::Global) => {
                let names = statement
                    .range
                    .slice(self.text)
                    .split([' ', ',', '['])
                    .skip(1);
                names
                    .filter(|name| !name.is_empty())
                    .for_each(|name| self.scopes.forget(name));
            }
            Some(PythonKeyword::With) => self.with(statement),
            Some(PythonKeyword::Class) => self.class(statement),
            Some(PythonKeyword::Leave | PythonKeyword::Other) => self.block(&statement.body),
            // parts that stand alone in broken text
            Some(_) => self.block(&statement.body),
            None => self.assign(statement.range),
        }
    }

    fn define(&mut self, statement: &'s Statement) {
        let head = statement.range.slice(self.text);
        let name = head.trim_start_matches("def").trim_start();
        let name = name
            .split(|c: char| !(c.is_alphanumeric() || c == '_'))
            .next()
            .unwrap_or("");
        let known = self
            .functions
            .iter()
            .position(|f| f.statement.range == statement.range);
        let outer = self.scopes.depth();
        let number = known.unwrap_or(self.functions.len());
        match self.functions.get_mut(number) {
            Some(function) => function.outer = outer,
            None => self.functions.push(PythonFunction { statement, outer }),
        }
        // two functions of one name: which one is meant is decided elsewhere
        self.scopes.set(name, PythonValue::Function(number));
    }

    /// Methods are read as functions that nobody calls; what the class sets is not seen from outside.
    fn class(&mut self, statement: &'s Statement) {
        let before = self.scopes.own();
        self.block(&statement.body);
        self.scopes.replace(before);
        let head = statement.range.slice(self.text);
        let name = head.split([' ', '(', ':']).nth(1).unwrap_or("");
        self.scopes.set(name, PythonValue::Unknown);
    }

    fn import(&mut self, statement: &'s Statement) {
        let names = statement
            .range
            .slice(self.text)
            .split_once(' ')
            .map_or("", |(_, names)| names);
        for name in without_comment(names).split(',') {
            let (module, alias) = name.split_once(" as ").unwrap_or((name, name));
            let (module, alias) = (module.trim(), alias.trim());
            if alias == module {
                let top = module.split('.').next().unwrap_or(module);
                self.scopes.set(top, PythonValue::Outer(top.into()));
            } else {
                self.scopes.set(alias, PythonValue::Outer(module.into()));
            }
        }
    }

    fn import_from(&mut self, statement: &'s Statement) {
        let code = statement.range.slice(self.text);
        let Some((module, names)) = code.split_once(" import") else {
            return;
        };
        let module = module.trim_start_matches("from").trim();
        let lines = names.lines().map(without_comment);
        let names: Vec<&str> = lines.flat_map(|line| line.split(',')).collect();
        for name in names {
            let name =
                name.trim_matches(|c: char| c.is_whitespace() || matches!(c, '(' | ')' | '\\'));
            let (name, alias) = name.split_once(" as ").unwrap_or((name, name));
            if !name.is_empty() && name != "*" {
                self.scopes.set(
                    alias.trim(),
                    PythonValue::Outer(format!("{module}.{}", name.trim()).into()),
                );
            }
        }
    }

    fn returns(&mut self, statement: &'s Statement) {
        let code = statement.range.slice(self.text);
        let value = if code.trim() == "return" {
            PythonValue::None
        } else {
            self.value_at(TextRange::new(
                statement.range.start + 6,
                statement.range.end,
            ))
        };
        if let Some(returned) = self.returned.last_mut() {
            *returned = Some(match returned.take() {
                Some(before) => before.join(value),
                None => value,
            });
        }
    }

    /// `with open(path) as f:`
    fn with(&mut self, statement: &'s Statement) {
        let code = statement.range.slice(self.text);
        let head = code.len() - code.trim_start_matches("with").len();
        match code.rsplit_once(" as ") {
            Some((value, name)) if !value.contains(" as ") => {
                let start = statement.range.start;
                let value = self.value_at(TextRange::new(
                    start + head as u32,
                    start + value.len() as u32,
                ));
                self.scopes.set(name.trim(), value);
            }
            _ => assigned(self.text, statement)
                .for_each(|name| self.scopes.set(name, PythonValue::Unknown)),
        }
        self.block(&statement.body);
    }

    /// An assignment, or an expression by itself.
    fn assign(&mut self, range: TextRange) {
        let code = range.slice(self.text);
        let Some((target, augmented, start)) = split_assignment(code) else {
            self.value_at(range);
            return;
        };
        let whole = TextRange::new(range.start + start as u32, range.end);
        let value = self.value_at(whole);
        // a type behind the name
        let target = target.split(':').next().unwrap_or(target).trim();
        if augmented.is_none() && is_name(target) {
            self.assignments.push(Assignment {
                name: target.to_owned(),
                start: range.start + (code.len() - code.trim_start().len()) as u32,
                value: whole,
            });
        }
        if let Some(operator) = augmented {
            self.augment(target, operator, value);
        } else {
            // `a = b = value`: each further name means the same value, and so does a name on the right
            let source = TextRange::new(range.start + start as u32, range.end)
                .slice(self.text)
                .trim();
            let names: Vec<&str> = target.split('=').map(str::trim).collect();
            for target in names.iter().filter(|target| is_name(target)) {
                let others = names.iter().copied().chain(Some(source));
                others
                    .filter(|o| is_name(o) && o != target)
                    .for_each(|other| self.scopes.alias(target, other));
            }
            names
                .into_iter()
                .for_each(|target| self.bind(target, value.clone()));
        }
    }

    fn bind(&mut self, target: &'s str, value: PythonValue) {
        let inner = target.trim_matches(['(', ')']);
        if is_name(target) {
            let value = if self.spend(value.weight()) {
                value
            } else {
                PythonValue::Unknown
            };
            self.scopes.set(target, value);
        } else if inner.contains(',') && inner.split(',').all(|name| is_name(name.trim())) {
            let names: Vec<&str> = inner.split(',').map(str::trim).collect();
            let values = match value {
                PythonValue::List(values) if values.len() == names.len() => values,
                _ => vec![PythonValue::Unknown; names.len()],
            };
            names
                .into_iter()
                .zip(values)
                .for_each(|(name, value)| self.scopes.set(name, value));
        } else if let Some((name, key)) = target.split_once('[').filter(|(name, _)| is_name(name)) {
            let key = key.trim_end_matches(']').trim();
            let quoted = ['"', '\'']
                .iter()
                .find_map(|q| key.strip_prefix(*q)?.strip_suffix(*q));
            let key = quoted.filter(|key| !key.contains(['"', '\'', '\\', '{']));
            self.change(name, |old| match (old, key) {
                (PythonValue::Dict { mut pairs, open }, Some(key)) => {
                    PythonValue::set(&mut pairs, key.to_owned(), value);
                    PythonValue::Dict { pairs, open }
                }
                _ => PythonValue::Unknown,
            });
        } else {
            // targets of any other form: every name in them
            words(target).for_each(|name| self.scopes.set(name, PythonValue::Unknown));
        }
    }

    fn augment(&mut self, target: &'s str, operator: char, value: PythonValue) {
        self.change(target, |old| match (old, value) {
            (PythonValue::Text(mut a), PythonValue::Text(b)) if operator == '+' => {
                a.push(b);
                PythonValue::Text(a)
            }
            (PythonValue::List(mut a), PythonValue::List(b)) if operator == '+' => {
                a.extend(b);
                PythonValue::List(a)
            }
            (PythonValue::Dict { mut pairs, open }, other @ PythonValue::Dict { .. })
                if operator == '|' =>
            {
                let open = PythonValue::spread(&mut pairs, other) || open;
                PythonValue::Dict { pairs, open }
            }
            _ => PythonValue::Unknown,
        });
    }

    /// Change the list or dictionary that a variable holds. Another variable that may hold the same one is unknown then.
    pub(super) fn change(&mut self, name: &str, change: impl FnOnce(PythonValue) -> PythonValue) {
        let old = self.scopes.get(name).cloned().unwrap_or_default();
        let weight = old.weight();
        let new = change(old);
        let new = if self.spend(weight + new.weight()) {
            new
        } else {
            PythonValue::Unknown
        };
        let is_own = self.scopes.has_own(name);
        if is_own {
            self.scopes.set(name, new);
        } else {
            // what is changed lies in a frame around this one
            self.scopes.forget(name);
        }
        self.scopes.forget_aliases(name);
    }
}

fn is_name(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_alphanumeric() || c == '_')
}

/// The names that a statement sets, as far as its text tells; too many rather than too few.
pub(super) fn assigned<'t>(text: &'t str, statement: &Statement) -> impl Iterator<Item = &'t str> {
    let code = statement.range.slice(text);
    let targets = match statement.keyword {
        Some(PythonKeyword::Loop) => code.split_once(" in ").map_or("", |(targets, _)| targets),
        // `with open(x) as file`, `except KeyError as error`: what is opened or raised is only read
        Some(PythonKeyword::With | PythonKeyword::Except) => {
            code.split_once(" as ").map_or("", |(_, targets)| targets)
        }
        Some(
            PythonKeyword::Def
            | PythonKeyword::Class
            | PythonKeyword::Import
            | PythonKeyword::From
            | PythonKeyword::Global,
        ) => code,
        Some(_) => "",
        None => split_assignment(code).map_or_else(|| mutated(code), |(target, ..)| target),
    };
    words(targets)
}

/// Methods that change the list, dictionary or set they are called on.
const CHANGING: [&str; 14] = [
    "add",
    "append",
    "clear",
    "discard",
    "extend",
    "insert",
    "pop",
    "popitem",
    "remove",
    "reverse",
    "setdefault",
    "sort",
    "update",
    "difference_update",
];

/// The variable that a call changes: `x` of `x.append(y)`.
fn mutated(code: &str) -> &str {
    let Some((name, call)) = code.split_once('.') else {
        return "";
    };
    let method = call.split('(').next().unwrap_or_default();
    if is_name(name) && CHANGING.contains(&method) {
        name
    } else {
        ""
    }
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_'))
        .filter(|word| !word.is_empty())
}

fn without_comment(line: &str) -> &str {
    line.split('#').next().unwrap_or(line)
}

/// The target of an assignment, the operator of one like `+=`, and where the value starts.
fn split_assignment(code: &str) -> Option<(&str, Option<char>, usize)> {
    let bytes = code.as_bytes();
    let mut at = code.find('=')?;
    let mut last = None;
    loop {
        let target = code.get(..at)?;
        // what stands in brackets, strings or lambdas is no assignment
        let is_open =
            target.matches(['(', '[', '{']).count() != target.matches([')', ']', '}']).count();
        let before = bytes.get(at.wrapping_sub(1)).copied().unwrap_or(0);
        if is_open
            || target.matches(['"', '\'']).count() % 2 == 1
            || bytes.get(at + 1) == Some(&b'=')
        {
            break;
        }
        if matches!(before, b'=' | b'!' | b'<' | b'>' | b':') || has_word(target, "lambda") {
            break;
        }
        if let operator @ (b'+' | b'-' | b'*' | b'/' | b'|' | b'&' | b'%' | b'^' | b'@') = before {
            let target = target.get(..target.len() - 1)?.trim_end();
            return last
                .is_none()
                .then_some((target, Some(operator as char), at + 1));
        }
        if !is_target(target.rsplit('=').next().unwrap_or(target)) {
            break;
        }
        last = Some((target, None, at + 1));
        match code.get(at + 1..).and_then(|rest| rest.find('=')) {
            Some(next) => at += next + 1,
            None => break,
        }
    }
    last
}

/// Whether a text can stand in front of `=`: names, items and attributes, a type behind one.
fn is_target(text: &str) -> bool {
    let text = text.trim();
    let name = text
        .split([':', '[', '.', ',', '(', '*'])
        .next()
        .unwrap_or("");
    let starts = text.starts_with(['(', '[', '*']) || !name.is_empty();
    let is_call = text
        .split('[')
        .next()
        .is_some_and(|head| head.contains('(') && !head.starts_with('('));
    starts
        && !is_call
        && !text.contains(['+', '{', '%'])
        && !has_word(text, "if")
        && !has_word(text, "in")
}

fn has_word(text: &str, word: &str) -> bool {
    words(text).any(|found| found == word)
}
