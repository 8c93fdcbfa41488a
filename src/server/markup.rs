//! Texts for people, in the form that the client shows.
use lsp_types::{Documentation, InlayHintTooltip, MarkupContent, MarkupKind};

/// The form of a text that one kind of answer takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum MarkupFormat {
    /// Markdown.
    Markdown,
    /// Plain text: all that a client takes which does not say more.
    #[default]
    Plain,
}

impl MarkupFormat {
    /// What a client prefers of the formats that it lists.
    pub fn of(listed: Option<&Vec<MarkupKind>>) -> Self {
        match listed.and_then(|listed| listed.first()) {
            Some(MarkupKind::Markdown) => Self::Markdown,
            _ => Self::Plain,
        }
    }

    /// A text of Markdown as the contents of a hover.
    pub fn contents(self, markdown: String) -> MarkupContent {
        match self {
            Self::Markdown => MarkupContent {
                kind: MarkupKind::Markdown,
                value: markdown,
            },
            Self::Plain => MarkupContent {
                kind: MarkupKind::PlainText,
                value: plain(&markdown),
            },
        }
    }

    /// The same as documentation of an item or a signature.
    pub fn documentation(self, markdown: String) -> Documentation {
        match self {
            Self::Markdown => Documentation::MarkupContent(self.contents(markdown)),
            Self::Plain => Documentation::String(plain(&markdown)),
        }
    }

    /// The same beside a hint.
    pub fn tooltip(self, markdown: String) -> InlayHintTooltip {
        match self {
            Self::Markdown => InlayHintTooltip::MarkupContent(self.contents(markdown)),
            Self::Plain => InlayHintTooltip::String(plain(&markdown)),
        }
    }
}

/// The words of a text, without the marks of the Markdown that we write.
fn plain(markdown: &str) -> String {
    let mut out = String::with_capacity(markdown.len());
    let mut fenced = false;
    for line in markdown.lines() {
        let fence = line
            .strip_prefix("```")
            .is_some_and(|info| !info.contains('`'));
        if fence {
            fenced = !fenced;
            continue;
        }
        if fenced {
            out.push_str(line);
        } else {
            inline(line, &mut out);
        }
        out.push('\n');
    }
    out.trim().to_owned()
}

/// The words of a line.
fn inline(line: &str, out: &mut String) {
    let mut rest = line;
    while let Some(first) = rest.chars().next() {
        let behind = match first {
            '\\' => escaped(rest, out),
            '`' => code(rest, out),
            '*' => rest.strip_prefix("**"),
            '!' => rest
                .strip_prefix('!')
                .and_then(link)
                .map(|(_, _, behind)| behind.trim_start()),
            '[' => link(rest).map(|(text, target, behind)| {
                inline(text, out);
                out.push_str(&format!(" ({target})"));
                behind
            }),
            _ => None,
        };
        rest = behind.unwrap_or_else(|| {
            out.push(first);
            rest.split_at(first.len_utf8()).1
        });
    }
}

/// A character that would be a mark; what stands behind it.
fn escaped<'a>(text: &'a str, out: &mut String) -> Option<&'a str> {
    let behind = text.strip_prefix('\\')?;
    let c = behind.chars().next().filter(char::is_ascii_punctuation)?;
    out.push(c);
    behind.strip_prefix(c)
}

/// A span of code between runs of as many backticks; what stands behind it.
fn code<'a>(text: &'a str, out: &mut String) -> Option<&'a str> {
    let inside = text.trim_start_matches('`');
    let fence = text.strip_suffix(inside)?;
    let mut from = 0;
    loop {
        let start = from + inside.get(from..)?.find('`')?;
        let run = inside
            .get(start..)?
            .chars()
            .take_while(|c| *c == '`')
            .count();
        if run == fence.len() {
            let content = inside.get(..start)?;
            let padded = content
                .strip_prefix(' ')
                .and_then(|content| content.strip_suffix(' '));
            out.push_str(
                padded
                    .filter(|content| !content.trim().is_empty())
                    .unwrap_or(content),
            );
            return inside.get(start + run..);
        }
        from = start + run;
    }
}

/// The text and the target of a link, and what stands behind it.
fn link(text: &str) -> Option<(&str, &str, &str)> {
    let (label, rest) = text.strip_prefix('[')?.split_once("](")?;
    let (target, behind) = rest.split_once(')')?;
    (!label.contains(['[', ']'])).then_some((label, target, behind))
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn marks_are_taken_away_and_words_stay() {
        for (markdown, expected) in [
            ("**property** `a` = `1`", "property a = 1"),
            ("a \\*b\\* \\<c\\> \\\\", "a *b* <c> \\"),
            ("`` a`b `` and ` `", "a`b and  "),
            ("**`<link>`** – a *body*", "<link> – a *body*"),
            ("![colour](data:image/svg+xml,x) `#ff0000`", "#ff0000"),
            (
                "[documentation](http://wiki.ros.org/xacro)",
                "documentation (http://wiki.ros.org/xacro)",
            ),
            (
                "```python\nsin(x)  # **no** `mark`\n```\n\nSine",
                "sin(x)  # **no** `mark`\n\nSine",
            ),
            ("a ` b [c] !d 🤖", "a ` b [c] !d 🤖"),
        ] {
            assert_eq!(plain(markdown), expected.trim(), "{markdown}");
        }
    }
}
