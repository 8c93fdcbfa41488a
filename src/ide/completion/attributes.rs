//! Names of attributes: those of URDF, of xacro's tags, and parameters of macros.

use super::directives::directive;
use super::item::{Completion, Completions, ItemKind, Topic, escaped};
use super::learned;
use super::scope::CompletionScope;
use super::tags::{is_required, spec_of};
use crate::typed::{Typed, is_name_char};
use rules::schema::{AttributeKind, AttributeSpec, ElementSpec};
use xml::Node;

/// The name that xacro's tags belong to.
const NAMESPACE: &str = "http://www.ros.org/wiki/xacro";

/// The element of URDF that a start tag stands for.
pub(super) fn spec_of_tag(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: Node<'_>,
) -> Option<&'static ElementSpec> {
    let mut names: Vec<&str> = typed.open.iter().map(|open| open.name()).collect();
    names.push(tag.name());
    spec_of(scope, &names)
}

/// Attributes that a start tag does not have yet.
pub(super) fn attributes(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: Node<'_>,
) -> Completions {
    let start = typed.offset - typed.before.len() as u32;
    let rest = typed.rest_of_word(is_name_char);
    let has_value = typed
        .after
        .get(rest as usize..)
        .is_some_and(|after| after.trim_start().starts_with('='));
    let mut items = if let Some(directive) = directive(tag.name()) {
        let all = directive.attributes.iter();
        all.map(|attribute| {
            let value = match attribute.words {
                [] => String::new(),
                words => format!("|{}|", words.join(",")),
            };
            attribute_item(attribute.name, attribute.required, &value).detail(attribute.docs)
        })
        .collect()
    } else if tag.name().starts_with("xacro:") {
        parameters(scope, typed, tag)
    } else {
        let spec = spec_of_tag(scope, typed, tag);
        let known = spec.map(of_urdf).unwrap_or_default();
        let rank = if known.is_empty() { 1 } else { 4 };
        let further = learned::attributes(scope, typed, tag.name())
            .into_iter()
            .map(|item| item.rank(rank));
        let mut items: Vec<Completion> = known.into_iter().chain(further).collect();
        if spec.is_none() {
            // what plugins and simulators read has names, too
            items.push(attribute_item("name", false, "").rank(5));
        }
        items
    };
    if typed.open.is_empty() {
        let text = format!("xmlns:xacro=\"{NAMESPACE}\"");
        let item = Completion::new(ItemKind::Attribute, "xmlns:xacro");
        items.push(item.text(text).rank(1).detail("the xacro namespace"));
    }
    items.retain(|item| !typed.has_attr(&item.label));
    if has_value {
        for item in &mut items {
            item.snippet = None;
            item.text = item.label.clone();
        }
    }
    Completions::new(start, typed.offset, rest, items)
}

/// `value`: nothing, or the words to choose from.
fn attribute_item(name: &str, required: bool, value: &str) -> Completion {
    let place = if value.is_empty() {
        "$1".to_owned()
    } else {
        format!("${{1{value}}}")
    };
    Completion::new(ItemKind::Attribute, name)
        .snippet(format!("{name}=\"{place}\"$0"))
        .rank(if required { 0 } else { 3 })
        .note(if required { "required" } else { "" })
}

fn of_urdf(spec: &'static ElementSpec) -> Vec<Completion> {
    let item = |attribute: &'static AttributeSpec| {
        let words = match attribute.kind {
            AttributeKind::Choice(words) => format!("|{}|", words.join(",")),
            _ => attribute
                .default
                .map_or(String::new(), |value| format!(":{}", escaped(value))),
        };
        attribute_item(attribute.name, attribute.required, &words)
            .note(facts_in_short(attribute))
            .detail(attribute.docs)
            .about(Topic::Attribute {
                element: spec.key.to_owned(),
                name: attribute.name.to_owned(),
            })
    };
    spec.attributes.iter().map(item).collect()
}

/// Unit and default, or that it is required.
fn facts_in_short(attribute: &AttributeSpec) -> String {
    let unit = attribute.unit.map(str::to_owned);
    let default = attribute.default.map(|value| format!("default {value}"));
    let required = attribute.required.then(|| "required".to_owned());
    let parts: Vec<String> = [unit, default, required].into_iter().flatten().collect();
    parts.join(", ")
}

/// The parameters of the macro that a tag calls; blocks are children, not attributes.
fn parameters(scope: &CompletionScope<'_>, typed: &Typed<'_>, tag: Node<'_>) -> Vec<Completion> {
    // of a macro whose file is missing, other calls say what it takes
    let Some(info) = scope.called(tag.name()) else {
        return learned::attributes(scope, typed, tag.name());
    };
    let values = info.params.iter().filter(|param| !param.is_block());
    values
        .map(|param| {
            let default = param
                .default
                .as_ref()
                .map(|(text, _)| format!("default {text}"));
            let note = match (default, param.forward) {
                (Some(default), false) => default,
                (Some(default), true) => format!("from the caller, {default}"),
                (None, true) => "from the caller".to_owned(),
                (None, false) => "required".to_owned(),
            };
            let about = Topic::Macro {
                name: info.name.clone(),
            };
            attribute_item(&param.name, is_required(param), "")
                .note(note)
                .about(about)
        })
        .collect()
}
