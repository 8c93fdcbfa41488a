//! Which of several names is meant more likely: the one whose words stand around the cursor.
//!
//! Robots name things after each other: the joint `wrist_2` has the limit `wrist_2_upper` and the mesh `wrist_2.stl`.

use std::path::Path;

use super::item::{Completion, ItemKind};
use crate::typed::{Typed, Typing, attr_text};
use base::FastMap;

/// How much of the text in front of the cursor is read, in bytes.
const NEAR: usize = 600;
/// What a word of the own tag, of an element near by and of the name of the file counts.
const OWN_TAG: i32 = 4;
const CLOSE: i32 = 3;
const AROUND: i32 = 2;
const OF_FILE: i32 = 1;

/// The words around the cursor, and what each counts.
pub(super) struct NearbyWords {
    words: FastMap<String, i32>,
}

impl NearbyWords {
    /// Of what is typed in a file. `word` is what was typed of the name itself.
    pub fn of(typed: &Typed<'_>, file: &Path, word: &str) -> Self {
        let mut found = Self {
            words: FastMap::default(),
        };
        let stem = file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned())
            .unwrap_or_default();
        found.read(&stem, OF_FILE);
        let text = typed
            .text_before
            .strip_suffix(word)
            .unwrap_or(typed.text_before);
        // only words are taken from this text, wherever they stand: its tags need not be understood
        let tag = text.rfind('<').unwrap_or(0);
        let near = text.len().saturating_sub(NEAR);
        let start = (near..=tag.max(near))
            .find(|at| text.is_char_boundary(*at))
            .unwrap_or(tag);
        let (before, own) = (
            text.get(start..tag).unwrap_or(""),
            text.get(tag..).unwrap_or(""),
        );
        // names of elements say nothing: they are everywhere
        for tag in before.split('<') {
            found.read(behind_name(tag), CLOSE);
        }
        for open in typed.open.iter().filter(|open| open.name() != "robot") {
            found.read(&attr_text(*open, "name").unwrap_or_default(), AROUND);
        }
        match typed.what {
            Typing::Content => {
                found.read(own.split_once('>').map_or("", |(_, text)| text), OWN_TAG)
            }
            _ => found.read(behind_name(own.trim_start_matches('<')), OWN_TAG),
        }
        let rest = typed.after.split('>').next().unwrap_or("");
        found.read(
            rest.split_once(char::is_whitespace)
                .map_or("", |(_, rest)| rest),
            OWN_TAG,
        );
        found
    }

    fn read(&mut self, text: &str, weight: i32) {
        each_word(text, &mut |word| {
            let known = self.words.entry(word.to_owned()).or_default();
            *known = (*known).max(weight);
        });
    }

    /// How near a candidate is: more is nearer.
    pub fn nearness(&self, item: &Completion) -> i32 {
        let counts = matches!(
            item.kind,
            ItemKind::Link
                | ItemKind::Joint
                | ItemKind::Color
                | ItemKind::Property
                | ItemKind::Argument
                | ItemKind::Macro
                | ItemKind::File
                | ItemKind::Package
        );
        if !counts {
            return 0;
        }
        let mut found = 0;
        each_word(item.label.trim_start_matches("xacro:"), &mut |word| {
            found += self.words.get(word).copied().unwrap_or(-1);
        });
        found
    }
}

/// A tag without its name.
fn behind_name(tag: &str) -> &str {
    tag.split_once(char::is_whitespace)
        .map_or("", |(_, rest)| rest)
}

/// The words of a text in small letters: `leftWrist_2` has `left`, `wrist` and `2`. Numbers that stand alone are none.
fn each_word(text: &str, use_it: &mut dyn FnMut(&str)) {
    let mut word = String::new();
    for name in text.split(|c: char| !c.is_alphanumeric() && c != '_') {
        if name.starts_with(|c: char| c.is_ascii_digit()) && !name.contains(char::is_alphabetic) {
            continue;
        }
        let mut last = ' ';
        for letter in name.chars() {
            let begins = letter.is_ascii_digit() != last.is_ascii_digit()
                || letter.is_uppercase() && last.is_lowercase();
            if (begins || letter == '_') && !word.is_empty() {
                use_it(&word);
                word.clear();
            }
            if letter != '_' {
                word.extend(letter.to_lowercase());
            }
            last = letter;
        }
        if !word.is_empty() {
            use_it(&word);
            word.clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::each_word;

    #[test]
    fn words_of_names() {
        let mut found = Vec::new();
        each_word("${prefix}leftWrist_2.stl 0.5 l4s", &mut |word| {
            found.push(word.to_owned())
        });
        assert_eq!(
            found,
            ["prefix", "left", "wrist", "2", "stl", "l", "4", "s"]
        );
    }
}
