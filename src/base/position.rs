//! Lines and columns: counting them in a text, in the units the three encodings use.

/// A position as editors count: both from 0; the unit of `col` is that of an [`Encoding`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct LineCol {
    /// Line, from 0. Lines end at LF, CRLF or a lone CR.
    pub line: u32,
    /// Column, from 0.
    pub col: u32,
}

/// The unit columns are counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Bytes of UTF-8.
    Utf8,
    /// Units of UTF-16: what LSP clients count unless something else was agreed.
    Utf16,
    /// Characters (code points): what expat and compilers count.
    Utf32,
}

impl Encoding {
    /// The width of `text` in this unit.
    pub fn width(self, text: &str) -> u32 {
        let width = match self {
            Encoding::Utf8 => text.len(),
            // Every character has one lead byte; those beyond U+FFFF, with a lead from 0xF0, need two units.
            Encoding::Utf16 => text
                .bytes()
                .map(|b| usize::from(b & 0xC0 != 0x80) + usize::from(b >= 0xF0))
                .sum(),
            Encoding::Utf32 => text.bytes().filter(|b| b & 0xC0 != 0x80).count(),
        };
        u32::try_from(width).unwrap_or(u32::MAX)
    }

    /// The byte offset of the character that holds column `col` of `text`: the start of the character when
    /// the column lies inside it. `Err` with the columns left over when `text` is too short.
    pub fn locate(self, text: &str, col: u32) -> Result<usize, u32> {
        let mut left = col;
        for (at, c) in text.char_indices() {
            let width = match self {
                Encoding::Utf8 => c.len_utf8(),
                Encoding::Utf16 => c.len_utf16(),
                Encoding::Utf32 => 1,
            } as u32;
            if left < width {
                return Ok(at);
            }
            left -= width;
        }
        Err(left)
    }
}

/// The number of line ends in `text`: LF, CRLF (one), lone CR.
pub fn count_line_ends(text: &str) -> u32 {
    let bytes = text.as_bytes();
    let feeds = memchr::memchr_iter(b'\n', bytes).count();
    let lone = memchr::memchr_iter(b'\r', bytes)
        .filter(|&at| bytes.get(at + 1) != Some(&b'\n'))
        .count();
    u32::try_from(feeds + lone).unwrap_or(u32::MAX)
}

/// The offset behind the last line end of `text`; `None` when it has none.
pub fn last_line_start(text: &str) -> Option<usize> {
    memchr::memrchr2(b'\n', b'\r', text.as_bytes()).map(|at| at + 1)
}

/// The offset behind the `n`th line end of `text` (`n` from 1).
pub fn nth_line_start(text: &str, n: u32) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut ends = memchr::memchr2_iter(b'\n', b'\r', bytes)
        .filter(|&at| bytes.get(at) == Some(&b'\n') || bytes.get(at + 1) != Some(&b'\n'));
    ends.nth(n.checked_sub(1)? as usize).map(|at| at + 1)
}

/// The offset of the first line end of `text`: the length of the text when it has none.
pub fn line_end(text: &str) -> usize {
    memchr::memchr2(b'\n', b'\r', text.as_bytes()).unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_differ_by_encoding() {
        let text = "aé中😀";
        assert_eq!(Encoding::Utf8.width(text), 10);
        assert_eq!(Encoding::Utf16.width(text), 5);
        assert_eq!(Encoding::Utf32.width(text), 4);
    }

    #[test]
    fn locate_rounds_down_inside_a_character() {
        let text = "😀b";
        assert_eq!(Encoding::Utf16.locate(text, 1), Ok(0));
        assert_eq!(Encoding::Utf16.locate(text, 2), Ok(4));
        assert_eq!(Encoding::Utf8.locate(text, 3), Ok(0));
        assert_eq!(Encoding::Utf16.locate(text, 5), Err(2));
    }

    #[test]
    fn all_three_line_ends_count_once() {
        let text = "a\r\nb\rc\nd\r";
        assert_eq!(count_line_ends(text), 4);
        assert_eq!(nth_line_start(text, 1), Some(3));
        assert_eq!(nth_line_start(text, 2), Some(5));
        assert_eq!(nth_line_start(text, 4), Some(9));
        assert_eq!(nth_line_start(text, 5), None);
        assert_eq!(last_line_start(text), Some(9));
        assert_eq!(line_end("ab\r\n"), 2);
    }
}
