//! Lines and columns of a whole text at once: for those who ask for many.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, OnceLock};

use super::document::Document;
use base::{Encoding, LineCol};

/// What a question costs besides the bytes that are looked at for it, as bytes.
const QUESTION: u32 = 256;
/// Bytes between two entries.
const STEP: usize = 64;

/// The table of a document, made when answers without it have cost as much as it costs. An edited document begins
/// again.
#[derive(Default)]
pub(super) struct LineTable {
    /// Bytes that were looked at.
    spent: AtomicU32,
    table: OnceLock<Arc<EntryTable>>,
}

impl Clone for LineTable {
    fn clone(&self) -> Self {
        let table = self
            .table
            .get()
            .cloned()
            .map_or_else(OnceLock::new, OnceLock::from);
        Self {
            spent: AtomicU32::new(self.spent.load(Ordering::Relaxed)),
            table,
        }
    }
}

impl LineTable {
    /// The table, when it is worth it.
    pub fn get(&self, document: &Document) -> Option<&EntryTable> {
        if let Some(table) = self.table.get() {
            return Some(table);
        }
        if self.spent.load(Ordering::Relaxed) <= document.len() {
            return None;
        }
        Some(
            self.table
                .get_or_init(|| Arc::new(EntryTable::of(document))),
        )
    }

    /// A question was answered without the table.
    pub fn spend(&self, bytes: u32) {
        // documents are much shorter than what would not fit
        self.spent.fetch_add(bytes + QUESTION, Ordering::Relaxed);
    }
}

/// A place in the text, at the start of a character.
#[derive(Clone, Copy, Default)]
struct LineEntry {
    offset: u32,
    line: u32,
    /// Where the line begins.
    start: u32,
    utf16: u32,
    utf32: u32,
}

/// Entries all along a text.
pub(super) struct EntryTable {
    entries: Vec<LineEntry>,
}

impl EntryTable {
    fn of(document: &Document) -> Self {
        let mut entries = vec![LineEntry::default()];
        let mut now = LineEntry::default();
        let mut next = STEP;
        let mut crlf = false;
        let mut chars = document.chars_from(0).peekable();
        while let Some(c) = chars.next() {
            let at = now.offset as usize;
            // between CR and LF, the line that ends is seen from its CR only
            if at >= next && !crlf {
                entries.push(now);
                next = at + STEP;
            }
            let end = now.offset + c.len_utf8() as u32;
            crlf = c == '\r' && chars.peek().is_some_and(|&c| c == '\n');
            now.offset = end;
            if (c == '\n' || c == '\r') && !crlf {
                now = LineEntry {
                    offset: end,
                    line: now.line + 1,
                    start: end,
                    utf16: 0,
                    utf32: 0,
                };
            } else {
                now.utf16 += c.len_utf16() as u32;
                now.utf32 += 1;
            }
        }
        Self { entries }
    }

    /// Line and column of an offset inside of the text.
    pub fn line_col(&self, document: &Document, offset: u32, encoding: Encoding) -> LineCol {
        let index = self
            .entries
            .partition_point(|entry| entry.offset <= offset)
            .saturating_sub(1);
        let mut now = self.entries.get(index).copied().unwrap_or_default();
        let mut chars = document.chars_from(now.offset).peekable();
        while let Some(c) = chars.next() {
            let end = now.offset + c.len_utf8() as u32;
            let crlf = c == '\r' && chars.peek() == Some(&'\n');
            // between CR and LF: still the line that ends here
            if end > offset || crlf && end == offset {
                break;
            }
            now.offset = end;
            if (c == '\n' || c == '\r') && !crlf {
                now = LineEntry {
                    offset: end,
                    line: now.line + 1,
                    start: end,
                    utf16: 0,
                    utf32: 0,
                };
            } else {
                now.utf16 += c.len_utf16() as u32;
                now.utf32 += 1;
            }
        }
        let col = match encoding {
            Encoding::Utf8 => now.offset - now.start,
            Encoding::Utf16 => now.utf16,
            Encoding::Utf32 => now.utf32,
        };
        LineCol {
            line: now.line,
            col,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::Document;
    use base::Encoding;

    #[test]
    fn the_table_says_what_is_said_without_it() {
        let line = "<link name=\"ä🤖\"/>\r\n\n<!-- \r x -->".repeat(40);
        let text = format!("<robot>{line}</robot>\n");
        for encoding in [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32] {
            let asked = Document::parse(&text);
            for offset in 0..=text.len() as u32 + 2 {
                let fresh = Document::parse(&text);
                assert_eq!(
                    asked.line_col(offset, encoding),
                    fresh.line_col(offset, encoding),
                    "{offset}"
                );
            }
        }
    }
}
