//! What an editor adds while somebody types: end tags and indentation.

use super::typed::{Typed, Typing, ended_at, has_end_tag, is_name_char, is_surplus, typed};
use base::{Encoding, LineCol, TextRange};
use xml::Document;

/// A text to put in the place of a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Insertion {
    /// What is replaced.
    pub range: TextRange,
    /// The new text.
    pub text: String,
}

/// What to add behind the character that was just typed in front of `offset`. `unit` is one step of indentation.
/// No edit reaches over the offset, so that editors keep the cursor where it is.
pub fn on_type(document: &Document, offset: u32, character: char, unit: &str) -> Vec<Insertion> {
    let typed = typed(document, offset);
    match character {
        '>' => end_tag(document, &typed)
            .or_else(|| without_added(document, &typed))
            .into_iter()
            .collect(),
        '/' => name_of_end_tag(document, &typed).into_iter().collect(),
        '\n' => indentation(document, &typed, unit).unwrap_or_default(),
        _ => Vec::new(),
    }
}

/// Behind `>`: the end tag of the element, when it has none.
fn end_tag(document: &Document, typed: &Typed<'_>) -> Option<Insertion> {
    let is_here = typed
        .just_opened
        .is_some_and(|(_, end)| end == typed.offset);
    let name = typed.open.last().filter(|_| is_here)?.name();
    // an end tag that the tree gives to this element may be that of one around it
    (!all_ended(document, typed, name)).then(|| Insertion {
        range: TextRange::empty(typed.offset),
        text: format!("</{name}>"),
    })
}

/// Whether the elements of a name around have end tags.
fn all_ended(document: &Document, typed: &Typed<'_>, name: &str) -> bool {
    let mut same = typed.open.iter().filter(|open| open.name() == name);
    same.all(|open| has_end_tag(document, *open))
}

/// Behind the `>` of an end tag: where the end tag that was added follows, it gives way. Whoever types fast is done with the
/// name before the answer to `</` comes, which is of no use then.
fn without_added(document: &Document, typed: &Typed<'_>) -> Option<Insertion> {
    let name = ended_at(document, typed.offset)?.name();
    let (start, end) = end_tag_behind(typed, name)?;
    is_surplus(document, start, name).then(|| removed(typed, end))
}

/// Behind `</`: the name of the open element, and the `>`. Where its end tag follows already, somebody types by habit
/// what was added: that end tag gives way to the one that is typed.
fn name_of_end_tag(document: &Document, typed: &Typed<'_>) -> Option<Insertion> {
    let is_here = typed.what == Typing::EndTag && typed.before.is_empty();
    let name = typed
        .open
        .last()
        .filter(|_| is_here && !typed.after.starts_with(is_name_char))?
        .name();
    if let Some((_, end)) = end_tag_behind(typed, name)
        && all_ended(document, typed, name)
    {
        return Some(removed(typed, end));
    }
    let end = if typed.after.starts_with('>') {
        ""
    } else {
        ">"
    };
    Some(Insertion {
        range: TextRange::empty(typed.offset),
        text: format!("{name}{end}"),
    })
}

/// Where the end tag of this name stands that follows, when nothing but blanks is in front of it.
fn end_tag_behind(typed: &Typed<'_>, name: &str) -> Option<(u32, u32)> {
    let rest = typed.after.trim_start();
    rest.strip_prefix("</")?
        .strip_prefix(name)
        .filter(|rest| rest.starts_with('>'))?;
    let start = typed.offset + (typed.after.len() - rest.len()) as u32;
    Some((start, start + ("</>".len() + name.len()) as u32))
}

/// What follows, up to an offset, is taken away.
fn removed(typed: &Typed<'_>, end: u32) -> Insertion {
    Insertion {
        range: TextRange::new(typed.offset, end),
        text: String::new(),
    }
}

/// Behind a line end between tags: the indentation of the new line, and an end tag in a line of its own.
fn indentation(document: &Document, typed: &Typed<'_>, unit: &str) -> Option<Vec<Insertion>> {
    if typed.what != Typing::Content || !typed.before.trim().is_empty() {
        return None;
    }
    let line = document.line_col(typed.offset, Encoding::Utf8).line;
    let start = document.offset(LineCol { line, col: 0 }, Encoding::Utf8);
    let closes = typed
        .after
        .trim_start_matches([' ', '\t'])
        .starts_with("</");
    let blanks = typed.rest_of_word(|c| matches!(c, ' ' | '\t'));
    let behind = TextRange::new(typed.offset, typed.offset + blanks);
    let (wanted, rest) = match typed.just_opened {
        Some((tag, _)) => {
            let base = indent(&document.line_text(document.line_col(tag, Encoding::Utf8).line));
            let own_line = closes.then(|| {
                // with the `<`: an editor moves the cursor behind what is inserted at it
                let range = TextRange::new(behind.start, behind.end + 1);
                Insertion {
                    range,
                    text: format!("{}{base}<", line_end(document, start)),
                }
            });
            (format!("{base}{unit}"), own_line)
        }
        None => {
            let before = (0..line)
                .rev()
                .take(100)
                .map(|line| document.line_text(line));
            let before = before.into_iter().find(|text| !text.trim().is_empty())?;
            let base = indent(&before);
            let wanted = if closes && !before.trim_start().starts_with("</") {
                base.strip_suffix(unit).unwrap_or(&base).to_owned()
            } else {
                base
            };
            (
                wanted,
                (!behind.is_empty()).then_some(Insertion {
                    range: behind,
                    text: String::new(),
                }),
            )
        }
    };
    let range = TextRange::new(start, typed.offset);
    let there = document.slice(range);
    let own = match wanted.strip_suffix(&*there) {
        Some("") => None,
        // at the start of the line, so that the cursor moves along
        Some(more) => Some(Insertion {
            range: TextRange::empty(start),
            text: more.to_owned(),
        }),
        None => Some(Insertion {
            range,
            text: wanted,
        }),
    };
    Some(own.into_iter().chain(rest).collect())
}

fn indent(line: &str) -> String {
    line.chars()
        .take_while(|c| matches!(c, ' ' | '\t'))
        .collect()
}

/// The line end in front of a line.
fn line_end(document: &Document, start: u32) -> &'static str {
    let before = document.slice(TextRange::new(start.saturating_sub(2), start));
    if before == "\r\n" { "\r\n" } else { "\n" }
}

#[cfg(test)]
mod tests {
    use super::on_type;
    use xml::Document;

    /// The text after the edit; `|` is where the character was typed.
    fn edited(text: &str, character: char) -> String {
        let offset = text.find('|').unwrap();
        let text = text.replacen('|', "", 1);
        let document = Document::parse(&text);
        let mut text = text;
        for edit in on_type(&document, offset as u32, character, "  ")
            .iter()
            .rev()
        {
            text.replace_range(
                edit.range.start as usize..edit.range.end as usize,
                &edit.text,
            );
        }
        text
    }

    #[test]
    fn elements_are_closed_once() {
        for (text, expected) in [
            (
                "<robot><link name=\"x\">|",
                "<robot><link name=\"x\"></link>",
            ),
            (
                "<robot><link name=\"x\">|</robot>",
                "<robot><link name=\"x\"></link></robot>",
            ),
            (
                "<robot><link>|</link></robot>",
                "<robot><link></link></robot>",
            ),
            ("<a><b>|</b></a>", "<a><b></b></a>"),
            ("<a><a>|</a>", "<a><a></a></a>"),
            ("<a><b/>|</a>", "<a><b/></a>"),
            ("<a></b>|</a>", "<a></b></a>"),
            ("<a><!-- <b>|", "<a><!-- <b>"),
            ("<a><!-- b -->|", "<a><!-- b -->"),
            ("<a x=\"1 >|\"", "<a x=\"1 >\""),
            // an end tag typed by habit and fast: the one that was added goes
            ("<a><b></b>|</b></a>", "<a><b></b></a>"),
            (
                "<a>\n  <b>\n    </b>|\n  </b>\n</a>",
                "<a>\n  <b>\n    </b>\n</a>",
            ),
            ("<b><b></b>|</b>", "<b><b></b></b>"),
            ("<b><b></b>|</b></b>", "<b><b></b></b>"),
            ("<a><b></b>|</a>", "<a><b></b></a>"),
            ("<a></b>|</b></a>", "<a></b></b></a>"),
        ] {
            assert_eq!(edited(text, '>'), expected);
        }
    }

    #[test]
    fn a_slash_closes_what_is_open() {
        for (text, expected) in [
            ("<a><b></|</a>", "<a><b></b></a>"),
            ("<a><b></|>", "<a><b></b>"),
            ("<a><b></|b>", "<a><b></b>"),
            ("<a><b x=\"/|\"", "<a><b x=\"/\""),
            // typed by habit: the end tag that was added goes
            ("<a><b></|</b></a>", "<a><b></</a>"),
            (
                "<a>\n  <b>\n    <c/>\n  </|\n  </b>\n</a>",
                "<a>\n  <b>\n    <c/>\n  </\n</a>",
            ),
            ("<b><b></|</b>", "<b><b></b></b>"),
        ] {
            assert_eq!(edited(text, '/'), expected);
        }
    }

    #[test]
    fn new_lines_are_indented() {
        for (text, expected) in [
            ("<a>\n|", "<a>\n  "),
            (
                "<a>\n  <b\n    x=\"1\">\n|",
                "<a>\n  <b\n    x=\"1\">\n    ",
            ),
            ("<a>\n  <b>\n|</b>", "<a>\n  <b>\n    \n  </b>"),
            ("<a>\r\n|</a>", "<a>\r\n  \r\n</a>"),
            ("<a>\n\t<b/>\n|\n</a>", "<a>\n\t<b/>\n\t\n</a>"),
            ("<a>\n  <b/>\n|</a>", "<a>\n  <b/>\n</a>"),
            ("<a x=\"1\"\n|", "<a x=\"1\"\n"),
            ("<a><!--\n|", "<a><!--\n"),
        ] {
            assert_eq!(edited(text, '\n'), expected);
        }
    }
}
