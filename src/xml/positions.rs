//! Offsets to lines and columns and back, without a copy of the text or a table of lines.

use super::document::{Document, DocumentPart};
use super::item::Item;
use base::{Encoding, LineCol, TextRange, last_line_start, line_end, nth_line_start};
use std::sync::Arc;

impl Document {
    /// The number of lines: one more than there are line ends.
    pub fn line_count(&self) -> u32 {
        self.header.lines + self.items.lines() + self.footer.item.lines + 1
    }

    /// The line and column of a byte offset; an offset inside a character counts as its start, one behind
    /// the end as the end.
    pub fn line_col(&self, offset: u32, encoding: Encoding) -> LineCol {
        match self.lines.get(self) {
            Some(table) => table.line_col(self, offset.min(self.len()), encoding),
            None => self.counted(offset, encoding),
        }
    }

    /// The same, counted from the start of the line.
    fn counted(&self, offset: u32, encoding: Encoding) -> LineCol {
        let (index, start, lines, item) = self.part_at(offset.min(self.len()));
        let mut inside = (offset.min(self.len()) - start) as usize;
        while !item.text().is_char_boundary(inside) {
            inside -= 1;
        }
        let before = item.text().get(..inside).unwrap_or("");
        self.lines.spend(before.len() as u32);
        let line = lines + base::count_line_ends(before);
        let col = match last_line_start(before) {
            // Between CR and LF: still the line that ends here.
            Some(at)
                if before.ends_with('\r')
                    && item
                        .text()
                        .get(inside..)
                        .is_some_and(|t| t.starts_with('\n')) =>
            {
                let line_text = before.get(..at - 1).unwrap_or("");
                return self.counted(start + line_text.len() as u32, encoding);
            }
            Some(at) => encoding.width(before.get(at..).unwrap_or("")),
            None => encoding.width(before) + self.width_before(index, encoding),
        };
        LineCol { line, col }
    }

    /// The columns of the line before the part with this number, as far as it began in earlier parts.
    fn width_before(&self, index: usize, encoding: Encoding) -> u32 {
        let mut width = 0;
        let items = self.items.iter_before(index.saturating_sub(1));
        let header = (index > 0).then_some(&self.header);
        for item in items.chain(header) {
            self.lines.spend(item.len());
            match last_line_start(item.text()) {
                Some(at) => return width + encoding.width(item.text().get(at..).unwrap_or("")),
                None => width += encoding.width(item.text()),
            }
        }
        width
    }

    /// The part an offset lies in: its number (header 0, items from 1, footer last), its offset, the line
    /// ends before it.
    fn part_at(&self, offset: u32) -> (usize, u32, u32, &Arc<Item>) {
        let head = self.header.len();
        if offset < head {
            return (0, 0, 0, &self.header);
        }
        let mark = self.items.at_offset(offset - head);
        let item = self.items.get(mark.index).unwrap_or(&self.footer.item);
        (
            mark.index + 1,
            head + mark.bytes,
            self.header.lines + mark.lines,
            item,
        )
    }

    /// The byte offset of a position. Behind the end of a line: the end of the line; behind the last line:
    /// the end of the text; inside a character: its start.
    pub fn offset(&self, position: LineCol, encoding: Encoding) -> u32 {
        let Some((part, start, inside)) = self.line_start(position.line) else {
            return self.len();
        };
        let mut at = start + inside as u32;
        let mut skip = inside;
        let mut col = position.col;
        for item in self.parts_from(part) {
            let text = item.text().get(skip..).unwrap_or("");
            skip = 0;
            let end = line_end(text);
            let line = text.get(..end).unwrap_or("");
            match encoding.locate(line, col) {
                Ok(found) => return at + found as u32,
                Err(left) => col = left,
            }
            at += end as u32;
            if end < text.len() {
                break;
            }
        }
        at
    }

    /// Where a line begins: the part, its offset, the offset in it.
    fn line_start(&self, line: u32) -> Option<(DocumentPart, u32, usize)> {
        if line <= self.header.lines {
            let inside = if line == 0 {
                0
            } else {
                nth_line_start(self.header.text(), line)?
            };
            return Some((DocumentPart::Header, 0, inside));
        }
        let line = line - self.header.lines;
        let mark = self.items.at_line(line);
        let start = self.header.len() + mark.bytes;
        let (part, item) = match self.items.get(mark.index) {
            Some(item) => (DocumentPart::Item(mark.index), item),
            None => (DocumentPart::Footer, &self.footer.item),
        };
        Some((part, start, nth_line_start(item.text(), line - mark.lines)?))
    }

    /// The text of a line without its end; empty for lines that do not exist.
    pub fn line_text(&self, line: u32) -> String {
        if line >= self.line_count() {
            return String::new();
        }
        let start = self.offset(LineCol { line, col: 0 }, Encoding::Utf8);
        let end = self.offset(
            LineCol {
                line,
                col: u32::MAX,
            },
            Encoding::Utf8,
        );
        self.slice(TextRange::new(start, end))
    }
}
