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
mod mend;
mod mend_xacro;
mod mesh_inertia;
mod place;
mod prefix;
mod split;
mod suppress;
mod vector;
mod wrap;

pub use create::{MacroFile, include_macro};
pub use extract_macro::{NewFile, move_to_file};
pub use inline::inlinable;
pub use inline_macro::inline_macro;
pub use mend_xacro::{before_use, missing_parameters, other_name, suggested};
pub use mesh_inertia::{Refused, of_mesh};
pub use suppress::ignored_in_config;

use super::context::Cx;
use base::{Span, TextRange};
use rules::{Edit, Surroundings};
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
    /// Mends a finding.
    Fix,
    /// Gives a value a name.
    Extract,
    /// Puts a value in the place of its name.
    Inline,
    /// Writes it in another way.
    Rewrite,
}

/// Quick fixes of a finding of `rule` at `range` that its rule does not offer by itself.
pub fn quick_fixes(source: &SourceFile, rule: &str, range: TextRange) -> Vec<Action> {
    let mut found = match rule {
        "xml-syntax-error" => mend::mend_syntax(source, range),
        "unknown-macro-param" | "unknown-xacro-attribute" | "unknown-attribute" => {
            mend_xacro::without_attribute(source, range).into_iter().collect()
        }
        "wrong-vector-length" => vector::length(source, range).into_iter().collect(),
        "zero-axis" => vector::axis(source, range),
        "duplicate-joint-name" => vector::other_joint_name(source, range).into_iter().collect(),
        _ => create::missing(source, rule, range),
    };
    if rule != "xml-syntax-error" {
        found.extend(suppress::suppress(source, rule, range));
    }
    found
}

/// Changes offered for a selection, or for the place of the cursor when it is empty.
pub fn refactorings(cx: &Cx<'_>, world: Surroundings<'_>, selection: TextRange) -> Vec<Action> {
    if !cx.source.document.errors().is_empty() {
        return Vec::new();
    }
    let mut found: Vec<Action> = inertia::from_geometry(cx, selection.start).into_iter().collect();
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
    Edit { span: Span { file: source.id, range }, content: content.into() }
}

fn fix(title: String, edits: Vec<Edit>) -> Action {
    Action { title, kind: ActionKind::Fix, edits }
}
