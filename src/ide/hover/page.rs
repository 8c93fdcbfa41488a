//! Putting a short page of Markdown together.

/// Most lines of a page.
const MOST_LINES: usize = 25;

/// Paragraphs of Markdown.
#[derive(Debug, Default)]
pub(super) struct Page {
    paragraphs: Vec<String>,
}

impl Page {
    pub fn titled(title: impl Into<String>) -> Self {
        Self {
            paragraphs: vec![title.into()],
        }
    }

    /// Add a paragraph, unless it is empty.
    pub fn add(&mut self, paragraph: impl Into<String>) {
        let paragraph = paragraph.into();
        if !paragraph.is_empty() {
            self.paragraphs.push(paragraph);
        }
    }

    /// Add the items of a list.
    pub fn list(&mut self, items: impl IntoIterator<Item = String>) {
        let items: Vec<String> = items.into_iter().map(|item| format!("- {item}")).collect();
        self.add(items.join("\n"));
    }

    /// Everything in at most so many lines.
    pub fn finish(self) -> String {
        let text = self.paragraphs.join("\n\n");
        if text.lines().count() <= MOST_LINES {
            return text;
        }
        let kept: Vec<&str> = text.lines().take(MOST_LINES - 1).collect();
        format!("{}\n…", kept.join("\n"))
    }
}

/// A text of the file as code, whatever it holds.
pub(super) fn code(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    let pad = if text.starts_with('`') || text.ends_with('`') || text.is_empty() {
        " "
    } else {
        ""
    };
    format!("{fence}{pad}{text}{pad}{fence}")
}

/// A text of the file as plain words of Markdown.
pub(super) fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(
            c,
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '|' | '!' | '&'
        ) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
