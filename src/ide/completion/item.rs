//! What completion offers.

use std::cmp::Reverse;

use serde::{Deserialize, Serialize};

use base::TextRange;
use base::limits::COMPLETIONS;

/// What an item stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum ItemKind {
    Element,
    Directive,
    Macro,
    Attribute,
    Choice,
    Link,
    Joint,
    Group,
    Controller,
    Color,
    Property,
    Parameter,
    Argument,
    Block,
    Function,
    Constant,
    Module,
    Key,
    File,
    Folder,
    Package,
    Snippet,
}

/// What there is more to say about, when an item is looked at.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "about", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Topic {
    /// An element of URDF.
    Element {
        /// What its children call it.
        key: String,
    },
    /// An attribute of an element of URDF.
    Attribute {
        /// The element's key.
        element: String,
        /// The attribute.
        name: String,
    },
    /// A tag of xacro.
    Directive {
        /// Its name with its prefix.
        name: String,
    },
    /// A macro.
    Macro {
        /// Its name.
        name: String,
    },
    /// A property.
    Property {
        /// Its name.
        name: String,
    },
    /// A global symbol.
    Symbol {
        /// Its module; empty for bare names.
        module: String,
        /// Its name.
        name: String,
    },
    /// A rule of the linter.
    Rule {
        /// Its name.
        name: String,
    },
}

/// Something to be inserted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// What is shown, and compared with what was typed.
    pub label: String,
    /// What it stands for.
    pub kind: ItemKind,
    /// The text to insert.
    pub text: String,
    /// The text to insert with places to fill in, for editors that know these.
    pub snippet: Option<String>,
    /// Its value, type or file; may be empty.
    pub note: String,
    /// One line about it; may be empty.
    pub detail: String,
    /// Lower ranks come first.
    pub rank: u8,
    /// More about it.
    pub topic: Option<Topic>,
}

impl Completion {
    /// Something whose label is its text.
    pub(super) fn new(kind: ItemKind, label: impl Into<String>) -> Self {
        let label = label.into();
        Self {
            text: label.clone(),
            label,
            kind,
            snippet: None,
            note: String::new(),
            detail: String::new(),
            rank: 5,
            topic: None,
        }
    }

    pub(super) fn text(mut self, text: impl Into<String>) -> Self {
        self.text = text.into();
        self
    }

    pub(super) fn snippet(mut self, snippet: impl Into<String>) -> Self {
        self.snippet = Some(snippet.into());
        self
    }

    pub(super) fn note(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    pub(super) fn detail(mut self, detail: impl Into<String>) -> Self {
        self.detail = detail.into();
        self
    }

    pub(super) fn rank(mut self, rank: u8) -> Self {
        self.rank = rank;
        self
    }

    pub(super) fn about(mut self, topic: Topic) -> Self {
        self.topic = Some(topic);
        self
    }
}

/// The answer: items that all replace the same text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completions {
    /// What can be inserted, the best first.
    pub items: Vec<Completion>,
    /// The text that an insertion replaces; ends at the cursor.
    pub insert: TextRange,
    /// The same with the rest of the word behind the cursor.
    pub replace: TextRange,
    /// Whether there were more items.
    pub more: bool,
}

impl Completions {
    /// Items that replace what was typed since `start`, and `rest` bytes behind the cursor.
    pub(super) fn new(start: u32, offset: u32, rest: u32, items: Vec<Completion>) -> Self {
        let insert = TextRange::new(start.min(offset), offset);
        let replace = TextRange::new(insert.start, offset + rest);
        Self {
            items,
            insert,
            replace,
            more: false,
        }
    }

    /// Each label once, the best first, of one rank the nearest, and not too many: only what fits to `typed` counts then.
    pub(super) fn bounded(mut self, typed: &str, nearness: impl Fn(&Completion) -> i32) -> Self {
        // the first of a label is the nearest
        let mut seen = base::FastSet::default();
        // what begins with the letters that were typed is meant more often than what holds them
        let typed_lower = typed.to_lowercase();
        self.items.sort_by_cached_key(|item| {
            let begins = item.label.to_lowercase().starts_with(&typed_lower);
            // of the others, of which there may be thousands, the rank is enough
            (
                !begins,
                item.rank,
                Reverse(if begins { nearness(item) } else { 0 }),
            )
        });
        self.items.retain(|item| seen.insert(item.label.clone()));
        if self.more || self.items.len() > COMPLETIONS {
            self.more = true;
            self.items.retain(|item| fits(typed, &item.label));
            self.items.truncate(COMPLETIONS);
        }
        self
    }
}

/// Whether the letters of `typed` stand in `label` in that order, whatever their case.
pub(super) fn fits(typed: &str, label: &str) -> bool {
    let mut letters = label.chars().flat_map(char::to_lowercase);
    typed
        .chars()
        .flat_map(char::to_lowercase)
        .all(|wanted| letters.any(|letter| letter == wanted))
}

/// Literal text inside of a snippet.
pub(super) fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\")
        .replace('$', "\\$")
        .replace('}', "\\}")
}

/// A text of at most so many characters.
pub(super) fn shortened(text: &str, most: usize) -> String {
    let text = text.replace(['\n', '\r', '\t'], " ");
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or("")),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::{Completion, Completions, ItemKind, escaped, fits, shortened};

    #[test]
    fn texts() {
        assert!(fits("ptb", "pan_tilt_Body") && !fits("bt", "t_b"));
        assert_eq!(escaped("${a}\\"), "\\${a\\}\\\\");
        assert_eq!(shortened("äöü\nx", 3), "äöü…");
    }

    #[test]
    fn a_label_stands_once_and_lists_are_bounded() {
        let item = |n: usize| Completion::new(ItemKind::Link, format!("link_{n}"));
        let many: Vec<_> = (0..500).chain(0..500).map(item).collect();
        let all = Completions::new(0, 0, 0, many.clone()).bounded("", |_| 0);
        assert!(all.more && all.items.len() == 200);
        let some = Completions::new(0, 0, 0, many).bounded("49", |_| 0);
        assert!(some.more && some.items.len() == 23, "{}", some.items.len());
    }
}
