//! What stands behind the dot of something whose value is not known, as a parameter: what stands there elsewhere.

use super::item::{Completion, ItemKind};
use super::names::file_name;
use super::scope::CompletionScope;
use crate::typed::Typed;
use base::FastSet;

/// Different names that are taken over.
const MOST: usize = 60;

/// The names that other texts have behind the same word and a dot: of `link.origin`, those behind `origin.`.
pub(super) fn seen(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    object: &str,
) -> Vec<Completion> {
    let word = object.rsplit(|c: char| !is_word(c)).next().unwrap_or("");
    let mut found = Vec::new();
    if word.is_empty() {
        return found;
    }
    let start = format!("{word}.");
    let edited = &scope.sources.source.document;
    let place = edited.item_at(typed.offset.saturating_sub(1));
    let own = (typed.offset - typed.before.len() as u32).saturating_sub(place.start) as usize;
    let end = own + typed.before.len();
    let mut names: FastSet<&str> = FastSet::default();
    for (_, file, item) in scope.items() {
        let text = item.text();
        let here = std::sync::Arc::ptr_eq(item, place.item);
        for (at, _) in text.match_indices(&start) {
            let behind = at + start.len();
            if text
                .get(..at)
                .is_some_and(|before| before.ends_with(is_word))
                || here && behind == end
            {
                continue;
            }
            let rest = text.get(behind..).unwrap_or("");
            let name = rest
                .get(..rest.find(|c: char| !is_word(c)).unwrap_or(rest.len()))
                .unwrap_or("");
            let is_call = rest
                .get(name.len()..)
                .is_some_and(|rest| rest.starts_with('('));
            let is_typed = here && (behind..=behind + name.len()).contains(&end);
            if expr::is_identifier(name)
                && !is_call
                && !is_typed
                && found.len() < MOST
                && names.insert(name)
            {
                let note = file_name(&file.source.path);
                found.push(Completion::new(ItemKind::Key, name).note(note).rank(4));
            }
        }
    }
    found
}

/// Whether a name in an expression can have the letter.
pub(super) fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}
