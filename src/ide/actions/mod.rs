//! What an editor offers to do at a place: quick fixes of findings, and changes that keep the meaning.
//!
//! Every action is a list of edits; nothing is offered that was not worked out.

mod convert;
mod create;
mod expand;
mod extract;
mod extract_macro;
mod inertia;
mod inline;
mod inline_macro;
mod joint;
mod mesh_inertia;
mod place;
mod prefix;
mod split;
mod suppress;
mod syntax;
mod vector;
mod wrap;
mod xacro;

pub use create::{MacroFile, include_macro};
pub use extract_macro::{NewFile, move_to_file};
pub use inline::inlinable;
pub use inline_macro::inline_macro;
pub use mesh_inertia::{Refused, of_mesh};
pub use suppress::{ignored_in_config, severity_in_config};
pub use xacro::{before_use, other_name, suggested};

use super::context::Cx;
use base::{Span, TextRange};
use rules::{Edit, Rule, RuleEnv, named};
use vfs::SourceFile;

/// Something that can be done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Action {
    /// What it does, for people.
    pub title: String,
    /// Which kind of change it is.
    pub kind: ActionKind,
    /// The changes; they do not overlap.
    pub edits: Vec<Edit>,
}

/// Kinds of changes, as editors sort them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActionKind {
    /// Fixes a finding.
    Fix,
    /// Gives a value a name.
    Extract,
    /// Puts a value in the place of its name.
    Inline,
    /// Writes it in another way.
    Rewrite,
}

/// What makes the quick fixes of a finding at a range.
type QuickFix = fn(&SourceFile, TextRange) -> Vec<Action>;

/// Rules with quick fixes that only an editor can offer: a person chooses one of them, or completes it.
const QUICK_FIXES: [(&Rule, QuickFix); 15] = [
    (named::XML_SYNTAX_ERROR, syntax::fixes),
    (named::UNKNOWN_MACRO_PARAM, xacro::without_attribute),
    (named::UNKNOWN_XACRO_ATTRIBUTE, xacro::without_attribute),
    (named::UNKNOWN_ATTRIBUTE, xacro::without_attribute),
    (named::WRONG_VECTOR_LENGTH, |source, range| {
        Vec::from_iter(vector::length(source, range))
    }),
    (named::ZERO_AXIS, vector::axis),
    (named::DUPLICATE_JOINT_NAME, |source, range| {
        Vec::from_iter(vector::other_joint_name(source, range))
    }),
    (named::UNDEFINED_PROPERTY, create::undefined_property),
    (named::UNDEFINED_ARG, create::undefined_arg),
    (named::UNDEFINED_MACRO, create::undefined_macro),
    (named::UNDEFINED_LINK, create::undefined_link),
    (named::UNDEFINED_MATERIAL, create::undefined_material),
    (named::MISSING_JOINT_LIMIT, create::missing_joint_limit),
    (named::MISSING_ATTRIBUTE, create::missing_attributes),
    (named::MISSING_LIMIT_ATTRIBUTE, create::missing_attributes),
];

/// Quick fixes of a finding of `rule` at `range` that its rule does not offer by itself.
pub fn quick_fixes(source: &SourceFile, rule: &Rule, range: TextRange) -> Vec<Action> {
    let own = QUICK_FIXES.iter().find(|(known, _)| *known == rule);
    let mut found = own.map_or_else(Vec::new, |(_, make)| make(source, range));
    if rule != named::XML_SYNTAX_ERROR {
        found.extend(suppress::suppress(source, rule.name, range));
    }
    found
}

/// Changes offered for a selection, or for the place of the cursor when it is empty.
pub fn refactorings(cx: &Cx<'_>, world: RuleEnv<'_>, selection: TextRange) -> Vec<Action> {
    if !cx.source.document.errors().is_empty() {
        return Vec::new();
    }
    let mut found: Vec<Action> = inertia::from_geometry(cx, selection.start)
        .into_iter()
        .collect();
    found.extend(extract::property(cx, selection));
    found.extend(inline::property(cx, world, selection.start));
    found.extend(expand::call(cx, selection.start));
    found.extend(wrap::in_condition(cx.source, selection));
    found.extend(joint::additions(cx.source, selection.start));
    found.extend(joint::collision(cx.source, selection.start));
    found.extend(of_mesh(cx, world, selection.start).unwrap_or_default());
    found.extend(split::collision(cx, selection.start));
    found.extend(joint::inertial(cx.source, selection.start));
    found.extend(extract_macro::extract_macro(cx, selection));
    found.extend(prefix::names(cx.source, selection));
    found.extend(convert::angle(cx.source, selection.start));
    found.extend(convert::degrees_note(cx.source, selection.start));
    found.extend(convert::package_path(cx, world, selection.start));
    found.extend(convert::sort_attributes(cx.source, selection.start));
    found.extend(convert::to_xacro(cx.source, selection.start));
    found
}

/// An edit of a file.
fn edit(source: &SourceFile, range: TextRange, content: impl Into<String>) -> Edit {
    Edit {
        span: Span {
            file: source.id,
            range,
        },
        content: content.into(),
    }
}

fn fix(title: String, edits: Vec<Edit>) -> Action {
    Action {
        title,
        kind: ActionKind::Fix,
        edits,
    }
}
