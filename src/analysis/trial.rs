//! Trying an edit out: what a robot would be with it.

use std::path::Path;

use super::analyzed::Analyzed;
use super::check::CheckOptions;
use super::job;
use super::world::World;
use crate::base::{CancelFlag, TextRange};
use crate::expand::{Expansion, write_mapped};

impl World {
    /// Whether a robot stays what it is, comments and blanks aside, when texts of a file are replaced; they are in
    /// order and do not overlap. None when cancelled.
    pub fn stays_the_same(
        &self,
        known: &Analyzed,
        path: &Path,
        edits: &[(TextRange, String)],
        cancel: &CancelFlag,
    ) -> Option<bool> {
        let changed = self.tried(known, path, edits, cancel)?;
        let sound = changed.complete && !changed.has_errors() && !known.expansion.has_errors();
        let text = write_mapped(&changed.tree, "").text;
        Some(sound && words(&text).eq(words(&known.written().text)))
    }

    /// A robot with other texts in a file. The file is as it was afterwards.
    fn tried(
        &self,
        known: &Analyzed,
        path: &Path,
        edits: &[(TextRange, String)],
        cancel: &CancelFlag,
    ) -> Option<Expansion> {
        let vfs = &self.session().vfs;
        let before = self.document(path)?;
        let is_open = self.open_files().any(|open| open == path);
        if !is_open {
            vfs.set_buffer(path, Some(before.document.text()));
        }
        let mut back = Vec::new();
        let mut shift: i64 = 0;
        for (range, new) in edits {
            let start = (i64::from(range.start) + shift) as u32;
            back.push((TextRange::new(start, start + new.len() as u32), before.document.slice(*range)));
            shift += new.len() as i64 - i64::from(range.len());
        }
        for (range, new) in edits.iter().rev() {
            vfs.edit_buffer(path, *range, new);
        }
        let options = CheckOptions { cancel: cancel.clone(), ..CheckOptions::default() };
        let expansion = job::expansion(self.session(), &options, &super::analyzed::job_of(&known.root));
        for (range, old) in back.iter().rev() {
            vfs.edit_buffer(path, *range, old);
        }
        if !is_open {
            vfs.set_buffer(path, None);
        }
        (!cancel.is_cancelled()).then_some(expansion)
    }
}

/// The words of a document, comments left out; numbers as their values.
fn words(text: &str) -> impl Iterator<Item = Word<'_>> {
    let mut rest = text;
    let content = std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let (part, behind) = rest.split_once("<!--").unwrap_or((rest, ""));
        rest = behind.split_once("-->").map_or("", |(_, behind)| behind);
        Some(part)
    });
    let ends = |c: char| c.is_whitespace() || matches!(c, '"' | '<' | '>' | '=' | '/');
    let words = content.flat_map(move |part| part.split(ends)).filter(|word| !word.is_empty());
    words.map(|word| match word.parse::<f64>() {
        Ok(number) => Word::Number(number.to_bits()),
        Err(_) => Word::Text(word),
    })
}

/// A word of a document.
#[derive(PartialEq)]
enum Word<'a> {
    Number(u64),
    Text(&'a str),
}
