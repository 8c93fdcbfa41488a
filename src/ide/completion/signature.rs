//! What a macro or function takes, and which of it is typed now.

use super::docs::{parameter, signature};
use super::scope::{CompletionScope, MacroInfo};
use super::tags::is_required;
use crate::typed::{Typed, Typing, UnclosedCode, is_name_char, open_call, typed, unclosed};
use base::TextRange;
use expr::{Module, global_symbols};

/// What a macro or function takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// All of it in a line.
    pub label: String,
    /// Where its parameters stand in the label, in bytes.
    pub parameters: Vec<TextRange>,
    /// The parameter that is typed now.
    pub active: Option<u32>,
    /// What it is good for.
    pub docs: String,
}

/// The signature of the call that is typed at `offset`: of a macro in a start tag, of a function in an expression.
pub fn signature_help(scope: &CompletionScope<'_>, offset: u32) -> Option<Signature> {
    let typed = typed(&scope.sources.source.document, offset);
    match &typed.what {
        Typing::Value(tag, name) => of_function(typed.before).or_else(|| {
            let info = scope.called(tag.name())?;
            Some(of_macro(&info, position(&info, name)))
        }),
        Typing::Attribute(tag) => {
            let info = scope.called(tag.name())?;
            let active = next(&info, &typed);
            Some(of_macro(&info, active))
        }
        Typing::Content => of_function(typed.before),
        _ => None,
    }
}

/// The signature of a function that is called at the end of a text.
fn of_function(before: &str) -> Option<Signature> {
    match unclosed(before)? {
        UnclosedCode::Code { code, .. } => of_code(code),
        UnclosedCode::Substitution(_) | UnclosedCode::Dollar => None,
    }
}

fn position(info: &MacroInfo, name: &str) -> Option<u32> {
    info.params
        .iter()
        .position(|param| param.name == name)
        .map(|place| place as u32)
}

/// The parameter whose name is typed; else the next one that is not given yet, the required ones first.
fn next(info: &MacroInfo, typed: &Typed<'_>) -> Option<u32> {
    let rest = typed.rest_of_word(is_name_char) as usize;
    let word = format!("{}{}", typed.before, typed.after.get(..rest).unwrap_or(""));
    if let Some(place) = position(info, &word) {
        return Some(place);
    }
    let mut free = info
        .params
        .iter()
        .filter(|param| !param.is_block() && !typed.has_attr(&param.name));
    let begun = free
        .clone()
        .find(|param| !word.is_empty() && param.name.starts_with(&word));
    let wanted = begun
        .or_else(|| free.clone().find(|param| is_required(param)))
        .or_else(|| free.next())?;
    position(info, &wanted.name)
}

fn of_macro(info: &MacroInfo, active: Option<u32>) -> Signature {
    let parameters: Vec<String> = info.params.iter().map(parameter).collect();
    let label = signature(info);
    let parameters = places(info.name.len() + 1, &parameters);
    Signature {
        label,
        parameters,
        active,
        docs: info.comment.clone(),
    }
}

fn of_code(code: &str) -> Option<Signature> {
    let (called, commas) = open_call(code)?;
    let (module, name) = called.rsplit_once('.').unwrap_or(("", called));
    let symbol = global_symbols().find(|symbol| {
        symbol.name == name
            && symbol.namespace.map_or("", Module::name) == module
            && !symbol.params.is_empty()
    })?;
    let parameters: Vec<String> = symbol.params.split(", ").map(str::to_owned).collect();
    let last = parameters.len().saturating_sub(1);
    Some(Signature {
        label: format!("{called}({})", symbol.params),
        parameters: places(called.len() + 1, &parameters),
        active: Some(commas.min(last) as u32),
        docs: symbol.doc.to_owned(),
    })
}

/// Where parameters stand that are joined by a comma and a blank.
fn places(start: usize, parameters: &[String]) -> Vec<TextRange> {
    let mut at = start;
    let mut place = |text: &String| {
        let range = TextRange::new(at as u32, (at + text.len()) as u32);
        at += text.len() + ", ".len();
        range
    };
    parameters.iter().map(&mut place).collect()
}
