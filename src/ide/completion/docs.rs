//! What there is to say about an item that is looked at.

use super::directives::directive;
use super::evaluate::Evaluator;
use super::item::Topic;
use super::names::file_name;
use super::scope::{CompletionScope, MacroInfo};
use expand::MacroParam;
use expr::global_symbols;
use rules::schema::{AttributeSpec, ElementSpec, every_element};

/// More about a topic, as Markdown; none when there is no such thing.
pub fn documentation(scope: &CompletionScope<'_>, topic: &Topic) -> Option<String> {
    match topic {
        Topic::Element { key } => every_element().find(|spec| spec.key == *key).map(element),
        Topic::Attribute { element, name } => {
            let attribute = every_element()
                .filter(|spec| spec.key == *element)
                .find_map(|spec| spec.attribute(name));
            attribute.map(of_attribute)
        }
        Topic::Directive { name } => directive(name).map(|directive| {
            let attributes = directive.attributes.iter().map(|attribute| {
                let required = if attribute.required { ", required" } else { "" };
                format!("- `{}`{required}: {}", attribute.name, attribute.docs)
            });
            let lines: Vec<String> = attributes.collect();
            format!("{}.\n\n{}", directive.summary, lines.join("\n"))
        }),
        Topic::Macro { name } => scope
            .macros()
            .into_iter()
            .find(|info| info.name == *name)
            .map(|i| of_macro(&i)),
        Topic::Property { name } => property(scope, name),
        Topic::Symbol { module, name } => {
            let is_it = |symbol: &expr::GlobalSymbol| {
                symbol.name == name && symbol.namespace.map_or("", expr::Module::name) == module
            };
            let symbol = global_symbols().find(is_it)?;
            let call = if symbol.params.is_empty() {
                String::new()
            } else {
                format!("({})", symbol.params)
            };
            Some(format!(
                "```python\n{}{call}\n```\n\n{}",
                symbol.name, symbol.doc
            ))
        }
        Topic::Rule { name } => {
            let rule = rules::all().find(|rule| rule.name == *name)?;
            Some(format!("{}\n\n{}", rule.headline(), rule.summary()))
        }
    }
}

fn element(spec: &'static ElementSpec) -> String {
    let mut lines = vec![format!("{}.", spec.docs), String::new()];
    if !spec.parents.is_empty() {
        let parents: Vec<String> = spec
            .parents
            .iter()
            .map(|parent| format!("`{parent}`"))
            .collect();
        lines.push(format!("In {}.", parents.join(", ")));
        lines.push(String::new());
    }
    lines.extend(
        spec.attributes
            .iter()
            .map(|attribute| format!("- `{}`: {}", attribute.name, of_attribute(attribute))),
    );
    lines.join("\n").trim_end().to_owned()
}

fn of_attribute(attribute: &'static AttributeSpec) -> String {
    let mut text = attribute.docs.to_owned();
    if let Some(unit) = attribute.unit {
        text.push_str(&format!(", in {unit}"));
    }
    if let Some(default) = attribute.default {
        text.push_str(&format!("; default `{default}`"));
    }
    if attribute.required {
        text.push_str("; required");
    }
    text
}

fn of_macro(info: &MacroInfo) -> String {
    let file = file_name(&info.file);
    let mut text = format!("```\n{}\n```\n\nin `{file}`", signature(info));
    if !info.comment.is_empty() {
        text.push_str("\n\n");
        text.push_str(&info.comment);
    }
    text
}

fn property(scope: &CompletionScope<'_>, name: &str) -> Option<String> {
    let all = scope.properties(0);
    let found = all.iter().rev().find(|property| property.name == name)?;
    let file = scope
        .files
        .get(found.file)
        .map(|file| file_name(&file.source.path))
        .unwrap_or_default();
    let value = found.value().unwrap_or_default();
    let mut text = format!("```\n{name} = {value}\n```\n\n");
    if let Some(shown) = Evaluator::new(scope, 0)
        .shown(name)
        .filter(|shown| *shown != value)
    {
        text.push_str(&format!("is `{shown}`, "));
    }
    text.push_str(&format!("in `{file}`"));
    let comment = found.comment();
    if !comment.is_empty() {
        text.push_str(&format!("\n\n{comment}"));
    }
    Some(text)
}

/// How a macro is called: `unit(name, axis='0 0 1', *at)`.
pub(super) fn signature(info: &MacroInfo) -> String {
    let params: Vec<String> = info.params.iter().map(parameter).collect();
    format!("{}({})", info.name, params.join(", "))
}

/// A parameter as a signature shows it.
pub(super) fn parameter(param: &MacroParam) -> String {
    match (&param.default, param.forward) {
        (Some((default, _)), false) => format!("{}={default}", param.name),
        (Some((default, _)), true) => format!("{}=^|{default}", param.name),
        (None, true) => format!("{}=^", param.name),
        (None, false) => param.name.to_string(),
    }
}
