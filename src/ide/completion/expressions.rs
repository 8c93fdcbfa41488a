//! Inside of `${…}` and `$(…)`.

use super::evaluate::{Evaluator, keys};
use super::inherited;
use super::item::{Completion, Completions, ItemKind, Topic, fits};
use super::members;
use super::paths;
use super::scope::{CompletionScope, PropertyInfo};
use super::substitutions;
use crate::typed::{CodeContext, Opened, Typed, UnclosedCode, attr_text, cursor, unclosed};
use base::limits::COMPLETIONS;
use expand::parse_params;
use expr::{BuiltinKind, Value, display, global_symbols};

/// What fits into the expression that the text in front of the cursor ends in; none when it ends in none.
pub(super) fn expression(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Option<Completions> {
    Some(match unclosed(typed.before)? {
        UnclosedCode::Dollar => dollar(typed, typed.offset - 1),
        UnclosedCode::Code { code, is_eval } => self::code(scope, typed, code, is_eval),
        UnclosedCode::Substitution(inner) => substitutions::substitution(scope, typed, inner),
    })
}

/// Behind a `$`.
fn dollar(typed: &Typed<'_>, start: u32) -> Completions {
    let items = [
        ("${}", "\\${$1}$0", "an expression"),
        ("$(arg )", "\\$(arg $1)$0", "the value of an argument"),
        ("$(find )", "\\$(find $1)$0", "the folder of a package"),
    ]
    .map(|(label, snippet, detail)| {
        Completion::new(ItemKind::Snippet, label)
            .snippet(snippet)
            .detail(detail)
            .rank(0)
    });
    Completions::new(start, typed.offset, 0, items.into())
}

/// In an expression; `is_eval`: of `$(eval)`, where arguments are the names.
fn code(scope: &CompletionScope<'_>, typed: &Typed<'_>, code: &str, is_eval: bool) -> Completions {
    match cursor(code) {
        CodeContext::Outside => Completions::default(),
        CodeContext::Text { start, opened } => match opened {
            Opened::Index(object) => answer(
                typed,
                code,
                start,
                entries(scope, typed, object, |key| match key {
                    Value::Str(text) => Some(text.to_string()),
                    _ => None,
                }),
            ),
            Opened::Call("load_yaml" | "xacro.load_yaml") => {
                let within = code.get(start..).unwrap_or("");
                paths::in_text(scope, typed, within, paths::WantedFile::Yaml)
            }
            Opened::Call("xacro.arg") => {
                answer(typed, code, start, substitutions::arguments(scope, typed))
            }
            Opened::Call(_) | Opened::Nothing => Completions::default(),
        },
        CodeContext::Member { object, start } => {
            answer(typed, code, start, members(scope, typed, object))
        }
        CodeContext::Name { start, opened } => {
            let word = code.get(start..).unwrap_or("");
            let (mut items, more) = names(scope, typed, word, is_eval);
            if let Opened::Index(object) = opened {
                let quoted = entries(scope, typed, object, |key| {
                    display::repr(key).map(|text| text.to_string())
                });
                items.extend(quoted.into_iter().map(|item| item.rank(0)));
            }
            Completions {
                more,
                ..answer(typed, code, start, items)
            }
        }
    }
}

/// Items for the word of the code that begins at `start`.
fn answer(typed: &Typed<'_>, code: &str, start: usize, items: Vec<Completion>) -> Completions {
    let begin = typed.offset - (code.len() - start) as u32;
    let rest = typed.rest_of_word(members::is_word);
    Completions::new(begin, typed.offset, rest, items)
}

/// The keys of what an expression stands for.
fn entries(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    object: &str,
    spelled: impl Fn(&Value) -> Option<String>,
) -> Vec<Completion> {
    let value = Evaluator::new(scope, typed.offset).code(object);
    let keys = keys(&value)
        .into_iter()
        .filter_map(|(key, shown)| Some((spelled(&key)?, shown)));
    keys.map(|(key, shown)| {
        Completion::new(ItemKind::Key, key)
            .note(shown.unwrap_or_default())
            .rank(1)
    })
    .collect()
}

/// What can stand behind a dot.
fn members(scope: &CompletionScope<'_>, typed: &Typed<'_>, object: &str) -> Vec<Completion> {
    let symbols = global_symbols()
        .filter(|symbol| {
            symbol
                .namespace
                .is_some_and(|module| module.name() == object)
        })
        .map(|symbol| global(&symbol));
    let mut items: Vec<Completion> = symbols.collect();
    let prefix = format!("{object}.");
    let mut evaluator = Evaluator::new(scope, typed.offset);
    for property in scope.properties(typed.offset) {
        if let Some(name) = property
            .name
            .strip_prefix(&prefix)
            .filter(|_| !property.is_block)
        {
            let value = evaluator.shown(&property.name).unwrap_or_default();
            items.push(
                Completion::new(ItemKind::Property, name)
                    .note(value)
                    .rank(1),
            );
        }
    }
    let value = evaluator.code(object);
    let dotted = match &value {
        Value::Dict(dict) => dict.is_yaml() || object.contains('.'),
        _ => false,
    };
    if dotted {
        let keys = keys(&value).into_iter();
        items.extend(keys.filter_map(|(key, shown)| {
            match key {
                Value::Str(name) if expr::is_identifier(&name) => Some(
                    Completion::new(ItemKind::Key, name)
                        .note(shown.unwrap_or_default())
                        .rank(1),
                ),
                _ => None,
            }
        }));
    } else if matches!(value, Value::Unknown) {
        items.extend(members::seen(scope, typed, object));
    }
    items
}

/// Names that an expression can begin with, and whether some that do not fit to `word` were left out.
fn names(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    word: &str,
    is_eval: bool,
) -> (Vec<Completion>, bool) {
    let mut items = Vec::new();
    let mut more = false;
    if is_eval {
        items.extend(substitutions::arguments(scope, typed));
    } else {
        items.extend(parameters(typed));
        let mut found = scope.properties(typed.offset);
        more = found.len() > COMPLETIONS;
        found.retain(|property| !more || fits(word, &property.name));
        items.extend(properties(scope, &found));
        items.extend(inherited::names(scope, typed));
    }
    let bare =
        global_symbols().filter(|symbol| symbol.namespace.is_none() && symbol.deprecated.is_none());
    items.extend(bare.map(|symbol| global(&symbol)));
    (items, more)
}

fn parameters(typed: &Typed<'_>) -> Vec<Completion> {
    let macros = typed
        .open
        .iter()
        .filter(|open| open.name() == "xacro:macro");
    let params = macros
        .filter_map(|open| parse_params(&attr_text(*open, "params")?))
        .flatten();
    let values = params.filter(|param| !param.is_block());
    values
        .map(|param| {
            let default = param
                .default
                .as_ref()
                .map(|(text, _)| format!("default {text}"));
            let note = default.unwrap_or_else(|| "parameter".to_owned());
            Completion::new(ItemKind::Parameter, param.name.as_str())
                .note(note)
                .detail("parameter")
                .rank(0)
        })
        .collect()
}

/// Properties; their values follow when it is known which are shown.
fn properties(scope: &CompletionScope<'_>, found: &[PropertyInfo]) -> Vec<Completion> {
    let own = &scope.sources.source.path;
    let mut items: Vec<Completion> = Vec::new();
    let mut seen = base::FastSet::default();
    let named =
        |property: &&PropertyInfo| !property.name.is_empty() && !property.name.contains('$');
    for property in found
        .iter()
        .filter(|property| !property.is_block)
        .filter(named)
    {
        if !seen.insert(property.name.clone()) {
            continue;
        }
        let here = scope
            .files
            .get(property.file)
            .is_some_and(|file| file.source.path == *own);
        let rank = if property.local {
            0
        } else {
            2 - u8::from(here)
        };
        let name = property.name.to_string();
        match name.split_once('.') {
            Some((namespace, _)) => {
                items.push(
                    Completion::new(ItemKind::Module, namespace)
                        .note("namespace")
                        .rank(2),
                );
            }
            None => {
                let item = Completion::new(ItemKind::Property, name.as_str()).detail("property");
                items.push(item.rank(rank).about(Topic::Property { name }));
            }
        }
    }
    items
}

/// Note the values of properties.
pub(super) fn show_values(scope: &CompletionScope<'_>, offset: u32, items: &mut [Completion]) {
    let mut evaluator = None;
    for item in items {
        if let Some(Topic::Property { name }) = &item.topic {
            let evaluator = evaluator.get_or_insert_with(|| Evaluator::new(scope, offset));
            item.note = evaluator.shown(name).unwrap_or_default();
        }
    }
}

fn global(symbol: &expr::GlobalSymbol) -> Completion {
    let module = symbol.namespace.map_or("", expr::Module::name).to_owned();
    let (kind, rank) = match symbol.kind {
        BuiltinKind::Constant => (ItemKind::Constant, 4),
        BuiltinKind::Function | BuiltinKind::Type => (ItemKind::Function, 4),
        BuiltinKind::Namespace => (ItemKind::Module, 3),
    };
    let item = Completion::new(kind, symbol.name)
        .detail(symbol.doc)
        .rank(rank)
        .about(Topic::Symbol {
            module,
            name: symbol.name.to_owned(),
        });
    match symbol.kind {
        BuiltinKind::Function | BuiltinKind::Type => item
            .note(format!("({})", symbol.params))
            .snippet(format!("{}($1)$0", symbol.name)),
        BuiltinKind::Constant => {
            let value = expr::global_symbol(symbol.name);
            item.note(
                value
                    .as_ref()
                    .and_then(super::evaluate::shown)
                    .unwrap_or_default(),
            )
        }
        BuiltinKind::Namespace => item,
    }
}
