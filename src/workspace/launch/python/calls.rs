//! Calls of functions that the file defines.

use base::FastSet;
use base::limits::LAUNCH_CALL_DEPTH;
use expr::ast::{ExprKind, ParamKind};

use super::PythonReader;
use super::scope::Variables;
use super::value::PythonValue;

impl PythonReader<'_> {
    /// What a function of the file gives for some arguments.
    pub(super) fn call(
        &mut self,
        number: usize,
        args: Vec<PythonValue>,
        named: Vec<(String, PythonValue)>,
    ) -> PythonValue {
        let Some(function) = self.functions.get(number).copied() else {
            return PythonValue::Unknown;
        };
        let is_too_deep = self.active.len() >= LAUNCH_CALL_DEPTH || self.active.contains(&number);
        if is_too_deep || !self.spend(10) {
            return PythonValue::Unknown;
        }
        self.evaluated.insert(number);
        let variables = self.parameters(function.statement.range.slice(self.text), args, named);
        self.active.push(number);
        self.returned.push(None);
        let noticed = self.noticed.take();
        self.scopes.enter(variables, function.outer);
        self.block(&function.statement.body);
        self.run_deferred();
        self.scopes.leave();
        self.noticed = noticed;
        self.active.pop();
        let returned = self.returned.pop().flatten();
        let ends = !super::leaves(&function.statement.body);
        match returned {
            Some(value) if ends && !always_returns(&function.statement.body) => {
                value.join(PythonValue::None)
            }
            Some(value) => value,
            None => PythonValue::None,
        }
    }

    /// The variables that a function starts with. `head` is `def name(parameters) -> type`.
    fn parameters(
        &mut self,
        head: &str,
        args: Vec<PythonValue>,
        named: Vec<(String, PythonValue)>,
    ) -> Variables {
        let list = parameter_list(head);
        let parsed = expr::parse(&format!("lambda {list}: 0"));
        let ExprKind::Lambda(lambda) = &parsed.expr.kind else {
            return Variables::default();
        };
        let is_open = named.iter().any(|(name, _)| name == "**");
        let mut args = args.into_iter();
        let mut variables = Variables::default();
        let known: FastSet<&str> = lambda
            .params
            .iter()
            .map(|param| param.name.as_str())
            .collect();
        for param in &lambda.params {
            let given = named
                .iter()
                .find(|(name, _)| *name == *param.name)
                .map(|(_, value)| value.clone());
            let value = match param.kind {
                ParamKind::PositionalOnly | ParamKind::Normal => args.next().or(given),
                ParamKind::KeywordOnly => given,
                ParamKind::VarArgs if param.name.is_empty() => continue,
                ParamKind::VarArgs => {
                    Some(PythonValue::List(args.by_ref().collect())).filter(|_| !is_open)
                }
                ParamKind::VarKeywords => {
                    let rest = named
                        .iter()
                        .filter(|(name, _)| !known.contains(name.as_str()) && name != "**");
                    Some(PythonValue::Dict {
                        pairs: rest.cloned().collect(),
                        open: is_open,
                    })
                }
            };
            let value = match (value, &param.default) {
                (Some(value), _) => value,
                // somebody may give another one
                (None, Some(default)) if !is_open => self.value(default).without_places(),
                (None, _) => PythonValue::Unknown,
            };
            variables.insert(param.name.clone(), value);
        }
        variables
    }
}

/// What stands between the brackets behind a function's name, without the types: `a, b=1` of `def f(a: str, b: int = 1)`.
fn parameter_list(head: &str) -> String {
    let inner = head.split_once('(').map_or("", |(_, rest)| rest);
    let (mut depth, mut is_type, mut quote) = (0usize, false, None);
    let mut list = String::new();
    for c in inner.chars() {
        match (quote, c) {
            (Some(open), c) if open == c => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '(' | '[' | '{') => depth += 1,
            (None, ')') if depth == 0 => break,
            (None, ')' | ']' | '}') => depth = depth.saturating_sub(1),
            (None, ':') if depth == 0 => is_type = true,
            (None, ',' | '=') if depth == 0 => is_type = false,
            _ => {}
        }
        if !is_type {
            list.push(if c == '\n' { ' ' } else { c });
        }
    }
    list
}

/// Whether each way through a block ends with `return`, as far as its last statement tells.
fn always_returns(block: &[super::Statement]) -> bool {
    use super::PythonKeyword;
    let has_else = block
        .last()
        .is_some_and(|last| last.keyword == Some(PythonKeyword::Else));
    let parts = block.iter().rev().take_while(|part| {
        matches!(
            part.keyword,
            Some(PythonKeyword::If | PythonKeyword::Elif | PythonKeyword::Else)
        )
    });
    super::leaves(block)
        || has_else && parts.clone().all(|part| super::leaves(&part.body))
        || block.last().is_some_and(|last| {
            last.keyword == Some(PythonKeyword::With) && always_returns(&last.body)
        })
}

impl PythonValue {
    /// The value without the places where it is written: it comes from a text that was changed.
    fn without_places(self) -> Self {
        match self {
            PythonValue::Text(text) => PythonValue::Text(text.without_places()),
            PythonValue::List(values) => {
                PythonValue::List(values.into_iter().map(Self::without_places).collect())
            }
            other => other,
        }
    }
}
