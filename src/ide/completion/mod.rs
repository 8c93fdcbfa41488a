//! What can be typed at a place.
//!
//! Works on text that is broken or cut off: what stands around the cursor is asked of the tree and of the lexer
//! (`ide::typed`), names come from the texts of the files that belong together (`scope`), names of links and joints
//! also from earlier expansions. Nothing is expanded here.

mod attributes;
mod choices;
mod comments;
mod directives;
mod docs;
mod elements;
mod evaluate;
mod expressions;
mod inherited;
mod item;
mod learned;
mod made;
mod members;
mod mentioned;
mod names;
mod nearness;
mod paths;
mod scope;
mod semantic;
mod settings;
mod signature;
mod substitutions;
mod tags;

pub use docs::documentation;
pub use item::{Completion, Completions, ItemKind, Topic};
pub(super) use scope::comment_above;
pub use scope::{CompletionScope, CompletionSources};
pub use settings::{BesideSources, completions_in_settings};
pub use signature::{Signature, signature_help};

use super::typed::{Typed, Typing, is_name_char, typed};
use names::WantedName;
use nearness::NearbyWords;

/// What can be typed at `offset` of the edited file. `trigger` is the character that made the editor ask; none when
/// the user did.
pub fn completions(scope: &CompletionScope<'_>, offset: u32, trigger: Option<char>) -> Completions {
    let typed = typed(&scope.sources.source.document, offset);
    let found = match &typed.what {
        Typing::Nothing => Completions::default(),
        Typing::Comment => comments::comment(scope, &typed),
        Typing::Tag => tags::tags(scope, &typed, ""),
        Typing::EndTag => tags::end_tag(&typed),
        Typing::Attribute(tag) => attributes::attributes(scope, &typed, *tag),
        Typing::Value(tag, name) => match trigger {
            // a blank inside of a value is no reason to ask, but it is inside of `$(arg `
            Some(' ') => expressions::expression(scope, &typed).unwrap_or_default(),
            _ => choices::values(scope, &typed, *tag, name),
        },
        Typing::Content => content(scope, &typed, trigger),
    };
    let length = found.insert.len() as usize;
    let word = typed
        .before
        .get(typed.before.len().saturating_sub(length)..)
        .unwrap_or("")
        .to_owned();
    let around = NearbyWords::of(&typed, &scope.sources.source.path, &word);
    let mut found = found.bounded(&word, |item| around.nearness(item));
    expressions::show_values(scope, offset, &mut found.items);
    found
}

/// Between tags: expressions; names in elements that hold one; elements when the user asks.
fn content(scope: &CompletionScope<'_>, typed: &Typed<'_>, trigger: Option<char>) -> Completions {
    if let Some(found) = expressions::expression(scope, typed) {
        return found;
    }
    let has_root = scope.sources.source.document.root().is_some();
    if trigger.is_some() || has_root && typed.open.is_empty() && !typed.before.trim().is_empty() {
        return Completions::default();
    }
    let parent = typed.open.last().map_or("", |open| open.name());
    if matches!(
        parent,
        "frame_id" | "frameName" | "frame_name" | "bodyName" | "baseLink" | "robotBaseFrame"
    ) {
        let text = typed.before.trim_start();
        let rest = typed.rest_of_word(is_name_char);
        let items = names::names(scope, typed, WantedName::Link, false);
        return Completions::new(typed.offset - text.len() as u32, typed.offset, rest, items);
    }
    let is_word = typed.before.trim_start().chars().all(is_name_char);
    if is_word {
        tags::tags(scope, typed, "<")
    } else {
        Completions::default()
    }
}
