//! Comments that speak to the linter and the server.

use super::item::{Completion, Completions, ItemKind, Topic};
use super::names::file_name;
use super::scope::CompletionScope;
use crate::typed::Typed;
use vfs::{relative, slashed};

const DIRECTIVES: &[(&str, &str)] = &[
    ("disable-next-line", "disable these rules for the next line"),
    ("disable", "disable these rules until `enable`"),
    ("enable", "enable these rules again"),
    ("disable-file", "disable these rules for this file"),
];

/// What fits into a comment: nothing, unless it begins as one of those.
pub(super) fn comment(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Completions {
    let text = typed.before.trim_start();
    if let Some(rest) = text.strip_prefix("xacro-lint:") {
        return lint(typed, rest.trim_start());
    }
    if let Some(rest) = text.strip_prefix("xacro-root:") {
        return root(scope, typed, rest.trim_start());
    }
    let begins = !text.is_empty()
        && ["xacro-lint:", "xacro-root:"]
            .iter()
            .any(|word| word.starts_with(text));
    let items = if begins {
        vec![
            Completion::new(ItemKind::Directive, "xacro-lint:")
                .text("xacro-lint: ")
                .rank(0),
            Completion::new(ItemKind::Directive, "xacro-root:")
                .text("xacro-root: ")
                .rank(1),
        ]
    } else {
        Vec::new()
    };
    Completions::new(typed.offset - text.len() as u32, typed.offset, 0, items)
}

fn lint(typed: &Typed<'_>, text: &str) -> Completions {
    let Some((_, selected)) = text.split_once(' ') else {
        let items = DIRECTIVES
            .iter()
            .enumerate()
            .map(|(place, (name, detail))| {
                Completion::new(ItemKind::Directive, *name)
                    .text(format!("{name} "))
                    .detail(*detail)
                    .rank(place as u8)
            });
        return answer(typed, text, items.collect());
    };
    if selected.contains(':') {
        // the reason, in the author's own words
        return Completions::default();
    }
    let word = selected.rsplit([',', ' ']).next().unwrap_or("");
    let items = rules::all().map(|rule| {
        Completion::new(ItemKind::Choice, rule.name)
            .note(rule.code)
            .detail(rule.summary())
            .about(Topic::Rule {
                name: rule.name.to_owned(),
            })
    });
    answer(typed, word, items.collect())
}

fn answer(typed: &Typed<'_>, word: &str, items: Vec<Completion>) -> Completions {
    let rest = typed.rest_of_word(|c| c.is_alphanumeric() || c == '-');
    Completions::new(typed.offset - word.len() as u32, typed.offset, rest, items)
}

fn root(scope: &CompletionScope<'_>, typed: &Typed<'_>, text: &str) -> Completions {
    if text.contains(' ') {
        return Completions::default();
    }
    let own = &scope.sources.source.path;
    let folder = own.parent().unwrap_or(own);
    let others = scope.sources.roots.iter().filter(|root| ***root != **own);
    let items = others.map(|root| {
        let name = slashed(&relative(folder, root));
        Completion::new(ItemKind::File, name).note(file_name(root))
    });
    let rest = typed.rest_of_word(|c| !c.is_whitespace());
    Completions::new(
        typed.offset - text.len() as u32,
        typed.offset,
        rest,
        items.collect(),
    )
}
