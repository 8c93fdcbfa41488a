//! White space inside of start tags.

use super::FormatWriter;
use super::indent::width;
use super::pieces::FormatPiece;
use base::TextRange;
use workspace::config::AttributeLayout;
use xml::{Attr, Node};

/// How the attributes of a tag stand below each other.
struct TagLayout {
    /// The column of attributes that begin a line.
    column: usize,
    /// The column of a `>` that begins a line.
    end: usize,
}

impl FormatWriter<'_> {
    /// A start tag: attributes with one blank between them, or below each other.
    pub(super) fn start_tag(&mut self, element: Node<'_>, piece: &FormatPiece<'_>) {
        let layout = self.layout(element, piece);
        self.keep(element.name_range().shift(piece.base).end);
        let count = element.attrs().len();
        for (number, attr) in element.attrs().enumerate() {
            let name = attr.name_range().shift(piece.base);
            let gap = TextRange::new(self.at, name.start).slice(self.text);
            let closer = if number + 1 < count {
                0
            } else {
                closer(element, piece, self.text).trim().len()
            };
            let breaks = match self.options.attributes {
                AttributeLayout::Keep => gap.contains(['\n', '\r']),
                AttributeLayout::Auto => number > 0 && self.is_full(attr, closer),
            };
            self.gap(name.start, breaks.then_some(layout.column));
            self.keep(name.end);
            self.attribute(attr, piece);
        }
        self.close(element, piece, &layout);
        self.has_tag = true;
    }

    fn attribute(&mut self, attr: Attr<'_>, piece: &FormatPiece<'_>) {
        let value = attr.value_range().shift(piece.base);
        if attr.is_quoted() {
            let quote = TextRange::new(value.start - 1, value.start).slice(self.text);
            self.put(value.start, &format!("={quote}"));
        }
        self.keep(attr.range().shift(piece.base).end);
    }

    /// The end of a tag.
    fn close(&mut self, element: Node<'_>, piece: &FormatPiece<'_>, layout: &TagLayout) {
        let closer = closer(element, piece, self.text);
        let start = piece.range.end - closer.trim_start().len() as u32;
        let blanks = TextRange::new(self.at, start).slice(self.text);
        if blanks.contains(['\n', '\r']) && self.options.attributes == AttributeLayout::Keep {
            self.gap(start, Some(layout.end));
        } else {
            // `<a b="c" />` is as common as `<a b="c"/>`
            let blank = if blanks.is_empty() { "" } else { " " };
            self.put(start, blank);
        }
        self.close_empty(element, piece);
    }

    /// `<a></a>` becomes `<a/>` where that is wished.
    fn close_empty(&mut self, element: Node<'_>, piece: &FormatPiece<'_>) {
        let end = element
            .end_tag()
            .filter(|end| end.start == element.start_tag_range().end);
        match end {
            Some(end) if self.options.self_close => self.put(end.end + piece.base, "/>"),
            _ => self.keep(piece.range.end),
        }
    }

    /// One blank, or a line end and white space up to a column.
    fn gap(&mut self, end: u32, column: Option<usize>) {
        let new = match column {
            None => " ".to_owned(),
            Some(column) => {
                let gap = TextRange::new(self.at, end).slice(self.text);
                let line_break = self.line_break(gap, 0);
                let line_end = if line_break.starts_with('\r') {
                    "\r\n"
                } else {
                    "\n"
                };
                line_end.to_owned() + &self.indent.blank(column)
            }
        };
        self.put(end, &new);
    }

    /// Whether an attribute does not fit into the line.
    fn is_full(&self, attr: Attr<'_>, closer: usize) -> bool {
        let first = attr.raw().split(['\n', '\r']).next().unwrap_or("");
        let text = format!("{}=\"{first}\"", attr.name());
        let own = width(&text, self.column + 1, self.indent.tab);
        let closer = if first.len() == attr.raw().len() {
            closer
        } else {
            0
        };
        self.column + 1 + own + closer > self.options.line_width as usize
    }

    /// Attributes that stood in one column stay there, seen from the tag; others go below the first one.
    fn layout(&self, element: Node<'_>, piece: &FormatPiece<'_>) -> TagLayout {
        let new = self.column;
        let below_first = new + width(element.name(), 0, self.indent.tab) + 2;
        let tag_text = piece.range.slice(self.text);
        if self.options.attributes == AttributeLayout::Auto || !tag_text.contains(['\n', '\r']) {
            // columns in the old text are not looked for: its lines may be long
            return TagLayout {
                column: below_first,
                end: new,
            };
        }
        let old = |offset: u32| column_of(self.text, offset, self.indent.tab);
        let tag = old(piece.range.start);
        let beginning = self.beginning_lines(element, piece);
        let first = element
            .attrs()
            .next()
            .map(|attr| attr.name_range().start + piece.base);
        let first_is_broken = first.is_some_and(|at| beginning.first() == Some(&at));
        let common = beginning.first().map(|at| old(*at));
        let common = common.filter(|first| beginning.iter().all(|at| old(*at) == *first));
        let column = match common {
            Some(column) if !first_is_broken && first.map(old) == Some(column) => below_first,
            Some(column) if column > tag => new + (column - tag),
            _ if first_is_broken => new + width(&self.indent.unit, new, self.indent.tab),
            _ => below_first,
        };
        let closer = closer(element, piece, self.text);
        let closer_at = piece.range.end - closer.trim_start().len() as u32;
        let end = if beginning.is_empty() || old(closer_at) == tag {
            new
        } else {
            column
        };
        TagLayout { column, end }
    }

    /// Where attributes begin that have a line end in front of them.
    fn beginning_lines(&self, element: Node<'_>, piece: &FormatPiece<'_>) -> Vec<u32> {
        let mut before = element.name_range().end;
        let mut found = Vec::new();
        for attr in element.attrs() {
            let gap = TextRange::new(before, attr.name_range().start).shift(piece.base);
            if gap.slice(self.text).contains(['\n', '\r']) {
                found.push(gap.end);
            }
            before = attr.range().end;
        }
        found
    }
}

/// The end of a start tag with the white space in front of it.
fn closer<'t>(element: Node<'_>, piece: &FormatPiece<'_>, text: &'t str) -> &'t str {
    let behind = element
        .attrs()
        .last()
        .map_or(element.name_range().end, |attr| attr.range().end);
    TextRange::new(behind + piece.base, piece.range.end).slice(text)
}

fn column_of(text: &str, offset: u32, tab: usize) -> usize {
    let before = text.get(..offset as usize).unwrap_or("");
    let line = before.rfind(['\n', '\r']).map_or(0, |at| at + 1);
    width(before.get(line..).unwrap_or(""), 0, tab)
}
