//! Inside of `$(…)`: commands, arguments, packages.

use super::item::{Completion, Completions, ItemKind};
use super::scope::CompletionScope;
use crate::typed::Typed;
use packages::{PackageEntry, PackageSource};

/// The commands, what each needs, and what it gives.
const COMMANDS: &[(&str, &str, &str)] = &[
    ("arg", " ", "the value of an argument"),
    ("find", " ", "the folder of a package"),
    ("env", " ", "an environment variable"),
    ("optenv", " ", "an environment variable, or a default"),
    (
        "eval",
        " ",
        "a Python expression that can use arguments by name",
    ),
    (
        "dirname",
        "",
        "not supported by xacro 2: use a relative path",
    ),
    ("cwd", "", "the working directory"),
];

/// Descriptions that are looked through for packages.
const MOST_FILES: usize = 40;

/// What fits behind `$(` and what was typed since.
pub(super) fn substitution(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    inner: &str,
) -> Completions {
    let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-');
    let rest = typed.rest_of_word(is_word);
    let Some((command, word)) = inner.split_once(' ') else {
        let start = typed.offset - inner.len() as u32;
        let items = COMMANDS
            .iter()
            .enumerate()
            .map(|(place, (name, behind, detail))| {
                let item =
                    Completion::new(ItemKind::Function, *name).text(format!("{name}{behind}"));
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
    let closed = typed
        .after
        .get(rest as usize..)
        .is_some_and(|after| after.starts_with(')'));
    if !closed {
        items.iter_mut().for_each(|item| item.text.push(')'));
    }
    Completions::new(typed.offset - word.len() as u32, typed.offset, rest, items)
}

/// The arguments of the context with their values.
pub(super) fn arguments(scope: &CompletionScope<'_>, _: &Typed<'_>) -> Vec<Completion> {
    let all = scope.arguments().into_iter();
    all.map(|(name, value)| {
        let note = value.unwrap_or_else(|| "no default".to_owned());
        Completion::new(ItemKind::Argument, name)
            .note(super::item::shortened(&note, 40))
            .detail("argument")
    })
    .collect()
}

/// The packages that can be named: those of the workspace first.
pub(super) fn packages(scope: &CompletionScope<'_>) -> Vec<Completion> {
    let own = scope
        .sources
        .packages
        .containing(&scope.sources.source.path)
        .map(|package| package.name);
    let all = scope.sources.packages.all(&scope.sources.source.path);
    let declared = scope
        .sources
        .packages
        .declared(&scope.sources.source.path)
        .into_iter();
    let missing: Vec<Completion> = declared
        .filter(|name| !has(&all, name))
        .map(|name| {
            Completion::new(ItemKind::Package, name)
                .note("named in package.xml, not found")
                .rank(3)
        })
        .collect();
    let mentioned = mentioned(scope)
        .into_iter()
        .filter(|(name, _)| !has(&all, name));
    let mentioned: Vec<Completion> = mentioned
        .map(|(name, file)| {
            Completion::new(ItemKind::Package, name)
                .note(format!("named in {file}, not found"))
                .rank(4)
        })
        .collect();
    let known = all.into_iter();
    known
        .filter(|entry| !entry.shadowed)
        .map(|entry| {
            let rank = match entry.step {
                _ if Some(&entry.name) == own.as_ref() => 0,
                PackageSource::OwnPackage
                | PackageSource::PackagePath
                | PackageSource::Workspace => 1,
                _ => 2,
            };
            let note = super::item::shortened(&vfs::slashed(&entry.path), 60);
            Completion::new(ItemKind::Package, entry.name)
                .note(note)
                .rank(rank)
        })
        .chain(missing)
        .chain(mentioned)
        .collect()
}

fn has(packages: &[PackageEntry], name: &str) -> bool {
    packages.iter().any(|entry| entry.name == name)
}

/// The packages that descriptions in the folder of the file find, with the name of the first such file. What is typed is none.
fn mentioned(scope: &CompletionScope<'_>) -> Vec<(String, String)> {
    let own = &scope.sources.source.path;
    let Some(folder) = own.parent().filter(|folder| scope.may_list(folder)) else {
        return Vec::new();
    };
    let names = scope.sources.vfs.list_dir(folder);
    let files = names
        .iter()
        .filter(|entry| !entry.is_dir && entry.name.ends_with(".xacro"));
    let mut found: Vec<(String, String)> = Vec::new();
    for entry in files.take(MOST_FILES) {
        let path = folder.join(&entry.name);
        let source = scope
            .sources
            .vfs
            .document(&path)
            .ok()
            .filter(|source| source.path != *own);
        for (_, item) in source.iter().flat_map(|source| source.document.parts()) {
            let finds = item.text().split("$(find ").skip(1);
            for name in finds.filter_map(|rest| Some(rest.split_once(')')?.0.trim())) {
                let is_name = !name.is_empty()
                    && name
                        .chars()
                        .all(|c| c.is_alphanumeric() || matches!(c, '_' | '-'));
                if is_name && !found.iter().any(|(known, _)| known == name) {
                    found.push((name.to_owned(), entry.name.clone()));
                }
            }
        }
    }
    found
}
