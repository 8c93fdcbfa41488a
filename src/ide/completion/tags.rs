//! Names of elements: what may stand here, xacro's own tags, macros.

use std::path::{Path, PathBuf};

use super::directives::{directive, snippet};
use super::elements::whole_elements;
use super::item::{Completion, Completions, ItemKind, Topic, escaped};
use super::learned;
use super::scope::{CompletionScope, MacroInfo};
use crate::typed::{Typed, is_name_char};
use base::FastSet;
use ecow::EcoString;
use expand::MacroParam;
use facts::{FactKind, XACRO_TAGS, facts};
use rules::schema::{AttributeKind, AttributeSpec, ContentModel, ElementSpec, elements, robot};

/// The element that a chain of open elements ends in, as URDF sees it: tags of xacro are transparent. None where
/// anything may stand: in the blocks of macro calls, below unknown elements.
pub(super) fn spec_of(scope: &CompletionScope<'_>, names: &[&str]) -> Option<&'static ElementSpec> {
    let mut found: Option<&'static ElementSpec> = None;
    for name in names {
        found = match *name {
            "xacro:if" | "xacro:unless" | "xacro:macro" if found.is_some() => found,
            name if name.starts_with("xacro:") => None,
            "robot" => Some(scope.root_spec()),
            name => match found {
                Some(parent) => parent.child(name),
                None if scope.is_semantic => None,
                None => only(name),
            },
        };
    }
    found
}

/// The element of a name, when it is the same wherever it stands, as `origin` is.
fn only(name: &str) -> Option<&'static ElementSpec> {
    let mut all = elements().filter(|spec| spec.name == name);
    let first = all.next()?;
    all.all(|other| attribute_names(other).eq(attribute_names(first)) && other.key == first.key)
        .then_some(first)
}

fn attribute_names(spec: &ElementSpec) -> impl Iterator<Item = &'static str> {
    spec.attributes.iter().map(|attribute| attribute.name)
}

/// Which macros are the nearest: those that the file calls already or includes by itself, then those of its folder.
struct Near<'a> {
    folder: Option<&'a Path>,
    calls: FastSet<EcoString>,
    included: FastSet<PathBuf>,
}

impl<'a> Near<'a> {
    fn of(scope: &CompletionScope<'a>) -> Self {
        let source = scope.sources.source;
        let calls = facts(&source.document).flat_map(|(_, facts)| {
            facts
                .of(FactKind::Call)
                .map(|call| call.name.clone())
                .collect::<Vec<_>>()
        });
        Self {
            folder: source.path.parent(),
            calls: calls.collect(),
            included: scope.included_here(),
        }
    }

    fn rank(&self, info: &MacroInfo) -> u8 {
        if self.calls.contains(info.name.as_str()) || self.included.contains(&*info.file) {
            0
        } else if info.file.parent() == self.folder {
            1
        } else {
            // of the same robot, but no part of what this file works with: behind the elements of URDF
            4
        }
    }
}

/// The element around what is typed.
pub(super) fn parent_of(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
) -> Option<&'static ElementSpec> {
    let names: Vec<&str> = typed.open.iter().map(|open| open.name()).collect();
    spec_of(scope, &names)
}

/// Names of start tags. `lead` stands in front of each: nothing behind a `<`, else that.
pub(super) fn tags(scope: &CompletionScope<'_>, typed: &Typed<'_>, lead: &str) -> Completions {
    let word = typed
        .before
        .rfind(|c: char| !is_name_char(c))
        .map_or(0, |at| at + 1);
    let start = typed.offset - (typed.before.len() - word) as u32;
    let rest = typed.rest_of_word(is_name_char);
    // a tag that is complete but for its name keeps what it has
    let bare = lead.is_empty() && typed.tag_ends();
    let mut items = children(scope, typed);
    if !bare
        && !scope.is_semantic
        && parent_of(scope, typed).is_some_and(|parent| parent.name == "robot")
    {
        items.extend(whole_elements());
    }
    let around = typed
        .open
        .iter()
        .rev()
        .find(|open| !matches!(open.name(), "xacro:if" | "xacro:unless"));
    if let Some(around) =
        around.filter(|open| !open.name().starts_with("xacro:") && open.name() != "robot")
    {
        // what the schema knows was offered, or is there and stands there once
        let parent = parent_of(scope, typed);
        let mut further = learned::children(scope, typed, around.name());
        further.retain(|item| parent.is_none_or(|parent| parent.child(&item.label).is_none()));
        let rank = if parent.is_some() { 4 } else { 2 };
        items.extend(further.into_iter().map(|item| item.rank(rank)));
    }
    items.extend(XACRO_TAGS.iter().map(|tag| {
        let name = format!("xacro:{}", tag.name);
        Completion::new(ItemKind::Directive, &name)
            .snippet(format!("{name}{}", snippet(tag)))
            .detail(tag.summary)
            .rank(if typed.before.starts_with("xacro:") {
                2
            } else {
                6
            })
            .about(Topic::Directive { name })
    }));
    let near = Near::of(scope);
    items.extend(
        scope
            .macros()
            .iter()
            .map(|info| called(info).rank(near.rank(info))),
    );
    for item in &mut items {
        item.snippet = item
            .snippet
            .take()
            .filter(|_| !bare)
            .map(|text| format!("{lead}{text}"));
        item.text.insert_str(0, lead);
    }
    Completions::new(start, typed.offset, rest, items)
}

/// The name of the end tag: that of the element that is open.
pub(super) fn end_tag(typed: &Typed<'_>) -> Completions {
    let Some(open) = typed.open.last() else {
        return Completions::default();
    };
    let start = typed.offset - typed.before.len() as u32;
    let rest = typed.rest_of_word(is_name_char);
    let closed = typed
        .after
        .get(rest as usize..)
        .is_some_and(|after| after.trim_start().starts_with('>'));
    let end = if closed { "" } else { ">" };
    let item = Completion::new(ItemKind::Element, open.name())
        .text(format!("{}{end}", open.name()))
        .rank(0);
    Completions::new(start, typed.offset, rest, vec![item])
}

/// The elements of URDF that may stand here and do not yet.
fn children(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<Completion> {
    if typed.open.is_empty() {
        let xmlns = "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";
        let root = format!("robot name=\"$1\" {xmlns}>\n\t$0\n</robot>");
        return vec![element(scope.root_spec()).snippet(root).rank(0)];
    }
    let Some(parent) = parent_of(scope, typed) else {
        return if scope.is_semantic {
            Vec::new()
        } else {
            anything()
        };
    };
    let siblings = typed.siblings();
    let shape_is_there = parent.name == "geometry"
        && parent
            .children()
            .any(|shape| siblings.contains(&shape.name));
    let free = parent
        .children()
        .filter(|spec| spec.repeats || !(shape_is_there || siblings.contains(&spec.name)));
    free.map(|spec| {
        let missing = parent.required.contains(&spec.name) && !siblings.contains(&spec.name);
        element(spec)
            .rank(if missing { 0 } else { 3 })
            .note(if missing { "required" } else { "" })
    })
    .collect()
}

/// All elements of URDF, for places where nothing says which.
fn anything() -> Vec<Completion> {
    elements()
        .filter(|spec| spec.name != robot().name)
        .map(|spec| {
            element(spec).rank(match spec.name {
                "origin" | "link" | "joint" | "inertial" | "geometry" => 4,
                _ => 5,
            })
        })
        .collect()
}

fn element(spec: &'static ElementSpec) -> Completion {
    let mut places = PlaceholderCounter::default();
    Completion::new(ItemKind::Element, spec.name)
        .snippet(format!("{}$0", whole(spec, "", &mut places)))
        .detail(spec.docs)
        .about(Topic::Element {
            key: spec.key.to_owned(),
        })
}

/// Numbers the places to fill in.
#[derive(Default)]
struct PlaceholderCounter(u32);

impl PlaceholderCounter {
    fn next(&mut self, text: &str) -> String {
        self.0 += 1;
        match text {
            "" => format!("${}", self.0),
            text => format!("${{{}:{}}}", self.0, escaped(text)),
        }
    }

    fn choice(&mut self, words: &[&str]) -> String {
        self.0 += 1;
        format!("${{{}|{}|}}", self.0, words.join(","))
    }
}

/// An element with what it needs, behind its `<`.
fn whole(spec: &'static ElementSpec, indent: &str, places: &mut PlaceholderCounter) -> String {
    let attributes = spec
        .attributes
        .iter()
        .filter(|attribute| is_usual(spec, attribute));
    let attributes: String = attributes
        .map(|attribute| assignment(attribute, places))
        .collect();
    let needed: Vec<_> = spec
        .required
        .iter()
        .filter_map(|name| spec.child(name))
        .collect();
    let head = format!("{}{attributes}", spec.name);
    let deeper = format!("{indent}\t");
    if !needed.is_empty() {
        let inside: String = needed
            .iter()
            .map(|child| format!("\n{deeper}<{}", whole(child, &deeper, places)))
            .collect();
        return format!("{head}>{inside}\n{indent}</{}>", spec.name);
    }
    match (spec.content, spec.children().next().is_some()) {
        (ContentModel::Text, _) => format!("{head}>{}</{}>", places.next(""), spec.name),
        (_, true) | (ContentModel::Free, _) => {
            format!(
                "{head}>\n{deeper}{}\n{indent}</{}>",
                places.next(""),
                spec.name
            )
        }
        (ContentModel::Elements, false) => format!("{head}/>"),
    }
}

/// Whether people write an attribute nearly always.
fn is_usual(spec: &ElementSpec, attribute: &AttributeSpec) -> bool {
    let any_required = spec.attributes.iter().any(|attribute| attribute.required);
    match spec.name {
        "robot" | "link" | "visual" | "collision" => attribute.required,
        "limit" => matches!(attribute.name, "lower" | "upper" | "effort" | "velocity"),
        _ => {
            attribute.required
                || !any_required && (attribute.default.is_some() || spec.attributes.len() == 1)
        }
    }
}

fn assignment(attribute: &AttributeSpec, places: &mut PlaceholderCounter) -> String {
    let value = match attribute.kind {
        AttributeKind::Choice(words) => places.choice(words),
        _ => places.next(attribute.default.unwrap_or("")),
    };
    format!(" {}=\"{value}\"", attribute.name)
}

/// A call of a macro with what it requires.
fn called(info: &MacroInfo) -> Completion {
    let tag = format!("xacro:{}", info.name);
    let mut places = PlaceholderCounter::default();
    let required = info
        .params
        .iter()
        .filter(|param| !param.is_block() && is_required(param));
    let attributes: String = required
        .map(|param| format!(" {}=\"{}\"", param.name, places.next("")))
        .collect();
    let blocks: Vec<String> = info
        .params
        .iter()
        .filter(|param| param.is_block())
        .map(|param| block(&param.name, &mut places))
        .collect();
    let snippet = match blocks.as_slice() {
        [] => format!("{tag}{attributes}/>$0"),
        blocks => format!("{tag}{attributes}>\n\t{}\n</{tag}>$0", blocks.join("\n\t")),
    };
    let file = info
        .file
        .file_name()
        .map(|name| name.to_string_lossy().into_owned())
        .unwrap_or_default();
    Completion::new(ItemKind::Macro, tag)
        .snippet(snippet)
        .note(file)
        .detail(super::docs::signature(info))
        .rank(1)
        .about(Topic::Macro {
            name: info.name.clone(),
        })
}

/// Whether a call has to give a parameter.
pub(super) fn is_required(param: &MacroParam) -> bool {
    param.default.is_none() && !param.forward
}

/// The element that a call gives for a block parameter.
fn block(name: &str, places: &mut PlaceholderCounter) -> String {
    let bare = name.trim_start_matches('*');
    if name.starts_with("**") {
        return format!("<{bare}>{}</{bare}>", places.next(""));
    }
    let pose = [
        "origin",
        "pose",
        "at",
        "xyz",
        "tf",
        "transform",
        "offset",
        "mount",
    ];
    let is_pose = bare.split('_').any(|word| pose.contains(&word));
    match only(bare).or_else(|| {
        elements()
            .find(|spec| spec.name == "origin")
            .filter(|_| is_pose)
    }) {
        Some(spec) => format!("<{}", whole(spec, "\t", places)),
        None => format!("<{}/>", places.next("origin")),
    }
}

/// Whether a name is one of xacro's own tags.
pub(super) fn is_directive(name: &str) -> bool {
    directive(name).is_some()
}
