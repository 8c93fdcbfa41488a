//! Formatting: white space between tags and between attributes is set again, everything else stays byte by byte.
//!
//! Every change is a replacement of one range of white space, so that the changes of a range are those of the
//! whole document that lie in it. Text is never touched: an element with text in it is left alone as a whole.
//! Between a comment and the tag behind it, one line end stays one and more stay more: xacro drops the comments
//! that stand directly above its own tags.

mod indent;
mod pieces;
mod tag;

use base::TextRange;
use indent::width;
pub use indent::{Indent, indentation, own_indentation};
use pieces::{FormatPiece, PieceKind, pieces};
use workspace::config;
use xml::Document;

/// Most steps of indentation; deeper elements stand below each other.
const MOST_STEPS: usize = 200;

/// The replacements that format a document, in order; none when its syntax is broken.
pub fn format(
    document: &Document,
    indent: &Indent,
    options: &config::Format,
) -> Vec<(TextRange, String)> {
    if !document.errors().is_empty() || document.root().is_none() {
        return Vec::new();
    }
    let text = document.text();
    let mut writer = FormatWriter::new(&text, indent, options);
    for piece in pieces(document) {
        writer.piece(&piece);
    }
    writer.end();
    writer.edits
}

/// The replacements that format a range of a document: its lines, as they are when all is formatted.
pub fn format_range(
    document: &Document,
    range: TextRange,
    indent: &Indent,
    options: &config::Format,
) -> Vec<(TextRange, String)> {
    let mut edits = format(document, indent, options);
    // the line end in front of a line belongs to it
    edits.retain(|(place, _)| {
        place.start < range.end.max(range.start + 1) && range.start <= place.end
    });
    edits
}

/// The text as it is formatted, with the replacements that lead there.
struct FormatWriter<'a> {
    text: &'a str,
    indent: &'a Indent,
    options: &'a config::Format,
    /// The line end of most lines.
    line_end: &'static str,
    /// Where the text that is not written yet begins.
    at: u32,
    /// The column in the new text.
    column: usize,
    /// Whether a tag stands in the current line.
    has_tag: bool,
    edits: Vec<(TextRange, String)>,
}

impl<'a> FormatWriter<'a> {
    fn new(text: &'a str, indent: &'a Indent, options: &'a config::Format) -> Self {
        let all = text.matches('\n').count();
        let line_end = if text.matches("\r\n").count() * 2 > all {
            "\r\n"
        } else {
            "\n"
        };
        Self {
            text,
            indent,
            options,
            line_end,
            at: 0,
            column: 0,
            has_tag: false,
            edits: Vec::new(),
        }
    }

    /// The text up to `end` becomes `new`.
    fn put(&mut self, end: u32, new: &str) {
        let range = TextRange::new(self.at, end);
        if range.slice(self.text) != new {
            self.edits.push((range, new.to_owned()));
        }
        self.advance(new);
        self.at = end;
    }

    /// The text up to `end` stays.
    fn keep(&mut self, end: u32) {
        let same = TextRange::new(self.at, end).slice(self.text);
        self.advance(same);
        self.at = end;
    }

    fn advance(&mut self, text: &str) {
        let mut bytes = text.bytes();
        self.column = match bytes.rposition(|byte| matches!(byte, b'\n' | b'\r')) {
            Some(at) => width(text.get(at + 1..).unwrap_or(""), 0, self.indent.tab),
            None => self.column + width(text, self.column, self.indent.tab),
        };
    }

    /// White space up to `start`, then the piece.
    fn piece(&mut self, piece: &FormatPiece<'_>) {
        if piece.range.end <= self.at {
            // the end tag of an element that was closed at once
            return;
        }
        let gap = TextRange::new(self.at, piece.range.start).slice(self.text);
        let breaks = match piece.kind {
            PieceKind::Start(_) => self.has_tag,
            PieceKind::End { closes_elements } => closes_elements,
            PieceKind::Other | PieceKind::Content => false,
        };
        if !is_blank(gap) || matches!(piece.kind, PieceKind::Content) {
            self.keep(piece.range.start);
        } else if self.at == 0 {
            self.put(piece.range.start, "");
        } else if breaks || gap.contains(['\n', '\r']) {
            let line_break = self.line_break(gap, piece.depth);
            self.put(piece.range.start, &line_break);
            self.has_tag = false;
        } else {
            self.keep(piece.range.start);
        }
        match piece.kind {
            PieceKind::Start(element) => self.start_tag(element, piece),
            PieceKind::End { .. } => self.end_tag(piece.range),
            PieceKind::Other | PieceKind::Content => {
                let before = self.at;
                self.keep(piece.range.end);
                let own = TextRange::new(before, self.at).slice(self.text);
                self.has_tag = self.has_tag && !own.contains('\n');
            }
        }
    }

    /// At most one blank line, then the indentation.
    fn line_break(&self, gap: &str, depth: usize) -> String {
        let line_end = match gap.find('\n') {
            Some(at) if gap.get(..at).is_some_and(|before| before.ends_with('\r')) => "\r\n",
            Some(_) => "\n",
            None => self.line_end,
        };
        let lines = gap.matches('\n').count().clamp(1, 2);
        line_end.repeat(lines) + &self.indent.unit.repeat(depth.min(MOST_STEPS))
    }

    fn end_tag(&mut self, range: TextRange) {
        let tag = range.slice(self.text);
        let name = tag.trim_end_matches('>').trim_end();
        self.keep(range.start + name.len() as u32);
        self.put(range.end, ">");
        self.has_tag = true;
    }

    /// At most one line end behind everything.
    fn end(&mut self) {
        let gap = TextRange::new(self.at, self.text.len() as u32).slice(self.text);
        if is_blank(gap) && self.at > 0 && gap.contains('\n') {
            let line_break = self.line_break(gap, 0);
            let one = if line_break.starts_with('\r') {
                "\r\n"
            } else {
                "\n"
            };
            self.put(self.text.len() as u32, one);
        }
    }
}

/// Whether there is nothing but what XML calls white space.
fn is_blank(text: &str) -> bool {
    text.bytes()
        .all(|byte| matches!(byte, b' ' | b'\t' | b'\n' | b'\r'))
}
