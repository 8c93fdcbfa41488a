//! Problems as people read them on a terminal: the rustc layout, through annotate-snippets.

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

use base::limits::DRAWN_LINE;
use base::{Encoding, TextRange};
use vfs::SourceFile;
pub use vfs::shown_path;

/// A file as it is shown: its text, and its path relative to where the user is.
pub struct ShownFile<'a> {
    /// The file.
    pub source: &'a SourceFile,
    /// Its path for people.
    pub path: String,
}

/// A place with words.
pub struct AnnotatedRange<'a> {
    /// The file.
    pub file: &'a ShownFile<'a>,
    /// Absolute byte range.
    pub range: TextRange,
    /// What to say there.
    pub label: String,
}

/// Everything to be said about one problem.
pub struct ProblemReport<'a> {
    /// Error, warning or info.
    pub level: Level<'static>,
    /// Shown in brackets behind the level.
    pub id: Option<String>,
    /// A page about it, which terminals link to.
    pub url: Option<String>,
    /// The headline.
    pub title: String,
    /// The wrong text.
    pub primary: AnnotatedRange<'a>,
    /// The way that led there, innermost first.
    pub trace: Vec<AnnotatedRange<'a>>,
    /// Further places of the same defect.
    pub places: Vec<AnnotatedRange<'a>>,
    /// What to do.
    pub help: Option<String>,
}

/// Steps of a trace that are drawn.
const MOST_STEPS: usize = 8;
/// Further places that are drawn.
const MOST_PLACES: usize = 3;

/// Draw a report.
pub fn render(report: &ProblemReport<'_>, color: bool) -> String {
    let title = visible(&report.title);
    let primary = RenderedLines::cut(&report.primary);
    let trace: Vec<RenderedLines> = report
        .trace
        .iter()
        .take(MOST_STEPS)
        .map(RenderedLines::cut)
        .collect();
    let places: Vec<RenderedLines> = report
        .places
        .iter()
        .take(MOST_PLACES)
        .map(RenderedLines::cut)
        .collect();
    let mut head = report.level.clone().primary_title(title.as_str());
    if let Some(id) = &report.id {
        head = head.id(id.as_str());
        if let Some(url) = &report.url {
            head = head.id_url(url.as_str());
        }
    }
    let mut group = primary.draw(Group::with_title(head), AnnotationKind::Primary);
    for piece in &trace {
        group = piece.draw(group, AnnotationKind::Context);
    }
    let left = report.trace.len().saturating_sub(MOST_STEPS);
    let more = format!("{left} more calls not shown");
    if left > 0 {
        group = group.element(Level::NOTE.message(more.as_str()));
    }
    for piece in &places {
        group = piece.draw(group, AnnotationKind::Context);
    }
    let left = report.places.len().saturating_sub(MOST_PLACES);
    let more_places = format!(
        "{} not shown (`--no-group` reports each)",
        base::counted(left, "more location")
    );
    if left > 0 {
        group = group.element(Level::NOTE.message(more_places.as_str()));
    }
    let help = report.help.as_deref().map(visible);
    if let Some(help) = &help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    let renderer = if color {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let groups: [Group<'_>; 1] = [group];
    renderer.decor_style(DecorStyle::Ascii).render(&groups)
}

/// The lines of a mark, ready to be drawn.
struct RenderedLines {
    path: String,
    line: usize,
    /// The line; none when it is too long to be drawn.
    text: Option<String>,
    span: std::ops::Range<usize>,
    label: String,
}

/// A source line without the control characters that the drawing passes on; it stays as long as it is.
fn harmless(line: &str) -> String {
    // as many bytes as what they stand for
    line.replace(|c| ('\u{80}'..='\u{9f}').contains(&c), "·")
        .replace(['\u{2028}', '\u{2029}'], "\u{240a}")
}

impl RenderedLines {
    fn cut(mark: &AnnotatedRange<'_>) -> Self {
        let document = &mark.file.source.document;
        let start = document.line_col(mark.range.start, Encoding::Utf8);
        let end = document.line_col(mark.range.end, Encoding::Utf8);
        let line = document
            .line_around(mark.range.start, DRAWN_LINE as u32)
            .map(|(line, _)| line);
        let length = line.as_ref().map_or(0, String::len);
        let col = start.col as usize;
        // of a range over several lines, the first says enough
        let to = if end.line == start.line {
            end.col as usize
        } else {
            length
        };
        Self {
            path: visible(&mark.file.path),
            line: start.line as usize + 1,
            span: col..to.clamp(col, length.max(col)),
            text: line.map(|line| harmless(&line)),
            label: visible(&mark.label),
        }
    }

    fn draw<'g>(&'g self, group: Group<'g>, kind: AnnotationKind) -> Group<'g> {
        let label = (!self.label.is_empty()).then_some(self.label.as_str());
        let Some(text) = &self.text else {
            let origin = Origin::path(self.path.as_str())
                .line(self.line)
                .char_column(self.span.start + 1);
            let group = group.element(origin);
            return group.elements(label.map(|label| Level::NOTE.message(label)));
        };
        let snippet = Snippet::source(text.as_str())
            .line_start(self.line)
            .path(self.path.as_str());
        group.element(snippet.annotation(kind.span(self.span.clone()).label(label)))
    }
}

/// The same for a name, which stays in its line.
pub fn visible_name(name: &str) -> String {
    visible(name)
        .replace('\n', "\u{240a}")
        .replace('\t', "\u{2409}")
}

/// Whether a character steers a terminal, or makes text read other than it is: control characters, marks of the
/// direction of writing, and line ends that are no line feeds.
fn is_steering(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
        || c.is_control() && c != '\n' && c != '\t'
}

/// Steering characters made visible.
pub fn visible(text: &str) -> String {
    let hidden = is_steering;
    if !text.contains(hidden) {
        return text.to_owned();
    }
    text.chars()
        .map(|c| match c {
            c if !hidden(c) => c,
            c if (c as u32) < 0x20 => char::from_u32(0x2400 + c as u32).unwrap_or('\u{fffd}'),
            _ => '\u{fffd}',
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use annotate_snippets::Level;

    use super::{AnnotatedRange, ProblemReport, ShownFile, render};
    use base::TextRange;
    use vfs::testing::Tree;

    #[test]
    fn names_of_rules_link_to_their_pages() {
        let tree = Tree::new();
        tree.write("a.urdf", "<robot/>\n");
        let source = tree.vfs().document(&tree.path("a.urdf")).unwrap();
        let file = ShownFile {
            source: &source,
            path: "a.urdf".to_owned(),
        };
        let report = ProblemReport {
            level: Level::ERROR,
            id: Some("no-links".to_owned()),
            url: Some("https://example.org/no-links".to_owned()),
            title: "robot has no links".to_owned(),
            primary: AnnotatedRange {
                file: &file,
                range: TextRange::new(0, 6),
                label: String::new(),
            },
            trace: Vec::new(),
            places: Vec::new(),
            help: None,
        };
        assert!(render(&report, true).contains("\u{1b}]8;;https://example.org/no-links\u{1b}\\"));
    }
}
