//! Inside of `$(…)`: commands, arguments, packages.

use super::item::{Completion, Completions, ItemKind};
use super::scope::Scope;
use crate::typed::Typed;
use workspace::Step;

/// The commands, what each needs, and what it gives.
const COMMANDS: &[(&str, &str, &str)] = &[
    ("arg", " ", "the value of an argument"),
    ("find", " ", "the folder of a package"),
    ("env", " ", "an environment variable"),
    ("optenv", " ", "an environment variable, or a default"),
    ("eval", " ", "a Python expression that can use arguments by name"),
    ("dirname", "", "not supported by xacro 2: use a relative path"),
    ("cwd", "", "the working directory"),
];

/// What fits behind `$(` and what was typed since.
pub(super) fn substitution(scope: &Scope<'_>, typed: &Typed, inner: &str) -> Completions {
    let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-');
    let rest = typed.rest_of_word(is_word);
    let Some((command, word)) = inner.split_once(' ') else {
        let start = typed.offset - inner.len() as u32;
        let items = COMMANDS.iter().enumerate().map(|(place, (name, behind, detail))| {
            let item = Completion::new(ItemKind::Function, *name).text(format!("{name}{behind}"));
            item.detail(*detail).rank(place as u8)
        });
        return Completions::new(start, typed.offset, rest, items.collect());
    };
    let word = word.trim_start();
    let mut items = match command {
        "arg" => arguments(scope, typed),
        "find" => packages(scope),
        _ => Vec::new(),
    };
    if word.contains(' ') {
        items.clear();
    }
    let closed = typed.after.get(rest as usize..).is_some_and(|after| after.starts_with(')'));
    if !closed {
        items.iter_mut().for_each(|item| item.text.push(')'));
    }
    Completions::new(typed.offset - word.len() as u32, typed.offset, rest, items)
}

/// The arguments of the context with their values.
pub(super) fn arguments(scope: &Scope<'_>, _: &Typed) -> Vec<Completion> {
    let all = scope.arguments().into_iter();
    all.map(|(name, value)| {
        let note = value.unwrap_or_else(|| "no default".to_owned());
        Completion::new(ItemKind::Argument, name).note(super::item::shortened(&note, 40)).detail("argument")
    })
    .collect()
}

/// The packages that can be named: those of the workspace first.
pub(super) fn packages(scope: &Scope<'_>) -> Vec<Completion> {
    let own = scope.sources.packages.containing(&scope.sources.source.path).map(|package| package.name);
    let all = scope.sources.packages.all(&scope.sources.source.path).into_iter();
    all.filter(|entry| !entry.shadowed)
        .map(|entry| {
            let rank = match entry.step {
                _ if Some(&entry.name) == own.as_ref() => 0,
                Step::OwnPackage | Step::PackagePath | Step::Workspace => 1,
                _ => 2,
            };
            let note = super::item::shortened(&entry.path.to_string_lossy(), 60);
            Completion::new(ItemKind::Package, entry.name).note(note).rank(rank)
        })
        .collect()
}
