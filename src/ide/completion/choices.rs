//! Values of attributes: words to choose from, names, useful numbers.

use super::attributes::spec_of_tag;
use super::directives::directive;
use super::expressions::expression;
use super::item::{Completion, Completions, ItemKind, escaped};
use super::names::{self, WantedName, blocks, flows_into, materials};
use super::paths;
use super::scope::CompletionScope;
use super::semantic;
use super::substitutions;
use super::tags::is_directive;
use crate::typed::Typed;
use rules::schema::{AttributeKind, ElementSpec};
use xml::Node;

/// What the types of joints do.
const JOINT_TYPES: &[(&str, &str)] = &[
    ("revolute", "rotates about the axis, with limits"),
    ("continuous", "rotates about the axis, without limits"),
    ("prismatic", "slides along the axis, with limits"),
    ("fixed", "does not move"),
    ("floating", "moves freely: six degrees of freedom"),
    ("planar", "moves in the plane normal to the axis"),
];

/// Names of interfaces that most hardware has.
const INTERFACES: &[&str] = &["position", "velocity", "effort", "acceleration"];

/// The attribute whose value is typed.
#[derive(Clone, Copy)]
pub(super) struct AttributeContext<'a> {
    /// What is known of its element.
    pub spec: Option<&'static ElementSpec>,
    /// Its start tag.
    pub tag: Node<'a>,
    /// Its name.
    pub attribute: &'a str,
}

/// Values of an attribute of a start tag.
pub(super) fn values(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: Node<'_>,
    attribute: &str,
) -> Completions {
    if let Some(found) = expression(scope, typed) {
        return found;
    }
    let spec = spec_of_tag(scope, typed, tag);
    if let Some(wanted) = file_wanted(spec, tag, attribute) {
        return paths::in_text(scope, typed, typed.before, wanted);
    }
    let items = match directive(tag.name()) {
        Some(_) => of_directive(scope, typed, tag, attribute),
        None if tag.name().starts_with("xacro:") => of_call(scope, typed, tag, attribute),
        None if scope.is_semantic => semantic::values(
            scope,
            typed,
            AttributeContext {
                spec,
                tag,
                attribute,
            },
        ),
        None => of_element(
            scope,
            typed,
            AttributeContext {
                spec,
                tag,
                attribute,
            },
        ),
    };
    whole_value(typed, items)
}

/// Items for all of a value.
fn whole_value(typed: &Typed<'_>, items: Vec<Completion>) -> Completions {
    let start = typed.offset - typed.before.len() as u32;
    Completions::new(start, typed.offset, typed.rest_of_value(), items)
}

/// The files that an attribute names.
fn file_wanted(
    spec: Option<&ElementSpec>,
    tag: Node<'_>,
    attribute: &str,
) -> Option<paths::WantedFile> {
    match (tag.name(), attribute) {
        ("xacro:include", "filename") => return Some(paths::WantedFile::Description),
        (name, _) if is_directive(name) => return None,
        _ => {}
    }
    let named = spec.and_then(|spec| spec.attribute(attribute));
    match (tag.name(), named.map(|attribute| attribute.kind)) {
        ("texture", Some(AttributeKind::Uri)) => Some(paths::WantedFile::Picture),
        ("mesh", _) if attribute == "filename" => Some(paths::WantedFile::Mesh),
        _ => None,
    }
}

fn of_directive(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: Node<'_>,
    attribute: &str,
) -> Vec<Completion> {
    match (tag.name(), attribute) {
        ("xacro:insert_block", "name") => blocks(scope, typed),
        ("xacro:if" | "xacro:unless", "value") => conditions(scope, typed),
        ("xacro:call", "macro") => {
            let macros = scope.macros().into_iter();
            macros
                .map(|info| Completion::new(ItemKind::Macro, info.name))
                .collect()
        }
        (name, _) => {
            let all = directive(name)
                .map(|directive| directive.attributes)
                .unwrap_or_default();
            let words = all
                .iter()
                .find(|given| given.name == attribute)
                .map_or(&[][..], |given| given.words);
            words_to_choose(words)
        }
    }
}

/// Words as they are.
pub(super) fn words_to_choose(words: &[&str]) -> Vec<Completion> {
    words
        .iter()
        .map(|word| Completion::new(ItemKind::Choice, *word))
        .collect()
}

/// An expression, and the arguments that are true or false.
fn conditions(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<Completion> {
    let mut items = vec![
        Completion::new(ItemKind::Snippet, "${}")
            .snippet("\\${$1}$0")
            .rank(0),
    ];
    items.extend(
        substitutions::arguments(scope, typed)
            .into_iter()
            .filter(|item| is_truth(&item.note))
            .map(|item| {
                let text = format!("$(arg {})", item.label);
                Completion::new(ItemKind::Argument, text)
                    .note(item.note)
                    .rank(1)
            }),
    );
    items
}

/// Whether a value is true or false.
fn is_truth(text: &str) -> bool {
    matches!(
        text.to_ascii_lowercase().as_str(),
        "true" | "false" | "0" | "1"
    )
}

/// Arguments of macro calls: names, when that is what the macro makes of them.
fn of_call(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: Node<'_>,
    attribute: &str,
) -> Vec<Completion> {
    let Some(info) = scope.called(tag.name()) else {
        return Vec::new();
    };
    let mut items = match flows_into(scope, &info, attribute) {
        Some(wanted) => names::names(scope, typed, wanted, false),
        None => Vec::new(),
    };
    let param = info.params.iter().find(|param| param.name == attribute);
    if let Some((default, _)) = param.and_then(|param| param.default.as_ref()) {
        let value = default.trim_matches('\'').to_owned();
        if !value.is_empty() {
            let snippet = escaped(&value);
            items.push(
                Completion::new(ItemKind::Choice, value)
                    .snippet(snippet)
                    .note("default")
                    .rank(4),
            );
        }
    }
    items
}

fn of_element(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    AttributeContext {
        spec,
        tag,
        attribute,
    }: AttributeContext<'_>,
) -> Vec<Completion> {
    if tag.name() == "material" && attribute == "name" {
        return materials(scope, typed);
    }
    if tag.name().ends_with("_interface") && attribute == "name" {
        return words_to_choose(INTERFACES);
    }
    if attribute == "frame_id" || attribute == "frame_name" {
        return names::names(scope, typed, WantedName::Link, false);
    }
    let Some(kind) = spec
        .and_then(|spec| spec.attribute(attribute))
        .map(|given| given.kind)
    else {
        return Vec::new();
    };
    if let Some(wanted) = WantedName::of(kind) {
        return names::names(scope, typed, wanted, tag.name() == "child");
    }
    match kind {
        AttributeKind::Choice(words) => words
            .iter()
            .map(|word| Completion::new(ItemKind::Choice, *word).detail(meaning(word)))
            .collect(),
        _ => numbers(tag.name(), attribute),
    }
}

fn meaning(word: &str) -> &'static str {
    JOINT_TYPES
        .iter()
        .find(|(name, _)| *name == word)
        .map_or("", |(_, meaning)| meaning)
}

/// A few values that people often write.
fn numbers(tag: &str, attribute: &str) -> Vec<Completion> {
    let values: &[(&str, &str)] = match (tag, attribute) {
        ("axis", "xyz") => &[
            ("1 0 0", "along x"),
            ("0 1 0", "along y"),
            ("0 0 1", "along z"),
            ("-1 0 0", "along -x"),
            ("0 -1 0", "along -y"),
            ("0 0 -1", "along -z"),
        ],
        (_, "xyz") => &[("0 0 0", "m"), ("0 0 0.1", "m"), ("${x} ${y} ${z}", "m")],
        (_, "rpy") => &[
            ("0 0 0", "rad"),
            ("${pi/2} 0 0", "90° about x"),
            ("0 ${pi/2} 0", "90° about y"),
            ("0 0 ${pi/2}", "90° about z"),
            ("0 0 ${pi}", "180° about z"),
            (
                "${-pi/2} 0 ${-pi/2}",
                "from a camera frame to its optical frame",
            ),
        ],
        ("box", "size") => &[("0.1 0.1 0.1", "m"), ("1 1 1", "m")],
        ("mesh", "scale") => &[
            ("1 1 1", "meters"),
            ("0.001 0.001 0.001", "millimeters to meters"),
        ],
        (_, "rgba") => &[
            ("0.8 0.8 0.8 1", "light gray"),
            ("0.2 0.2 0.2 1", "dark gray"),
            ("1 1 1 1", "white"),
            ("0 0 0 1", "black"),
            ("0.8 0 0 1", "red"),
            ("0 0.6 0 1", "green"),
            ("0 0 0.8 1", "blue"),
            ("1 0.5 0 1", "orange"),
        ],
        _ => &[],
    };
    let item = |(place, (value, note)): (usize, &(&str, &str))| {
        let snippet = format!("{}$0", escaped(value));
        Completion::new(ItemKind::Snippet, *value)
            .snippet(snippet)
            .note(*note)
            .rank(place as u8)
    };
    values.iter().enumerate().map(item).collect()
}
