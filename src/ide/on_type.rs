//! What an editor adds while somebody types: end tags and indentation.

use super::tag_reader::Reader;
use super::typed::{Typed, Typing, is_name_char, typed};
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
pub fn on_type(document: &Document, offset: u32, character: char, unit: &str) -> Option<Insertion> {
    let typed = typed(document, offset);
    match character {
        '>' => end_tag(&typed),
        '/' => name_of_end_tag(&typed),
        '\n' => indentation(document, &typed, unit),
        _ => None,
    }
}

/// Behind `>`: the end tag of the element, when it has none.
fn end_tag(typed: &Typed) -> Option<Insertion> {
    let is_here = typed.just_opened.is_some_and(|(_, end)| end == typed.offset);
    let name = &typed.open.last().filter(|_| is_here)?.name;
    // elements of the same name around it may own the end tags that follow
    let same = typed.open.iter().filter(|open| open.name == *name).count();
    let mut reader = Reader::new(&typed.after).until_unmatched(same);
    reader.run();
    let ends = reader.unmatched.iter().take_while(|end| *end == name).count();
    (ends < same).then(|| Insertion { range: TextRange::empty(typed.offset), text: format!("</{name}>") })
}

/// Behind `</`: the name of the open element, and the `>`.
fn name_of_end_tag(typed: &Typed) -> Option<Insertion> {
    let is_here = typed.what == Typing::EndTag && typed.before.is_empty();
    let open = typed.open.last().filter(|_| is_here && !typed.after.starts_with(is_name_char))?;
    let end = if typed.after.starts_with('>') { "" } else { ">" };
    Some(Insertion { range: TextRange::empty(typed.offset), text: format!("{}{end}", open.name) })
}

/// Behind a line end between tags: the indentation of the new line.
fn indentation(document: &Document, typed: &Typed, unit: &str) -> Option<Insertion> {
    if typed.what != Typing::Content || !typed.before.trim().is_empty() {
        return None;
    }
    let line = document.line_col(typed.offset, Encoding::Utf8).line;
    let start = document.offset(LineCol { line, col: 0 }, Encoding::Utf8);
    let closes = typed.after.trim_start_matches([' ', '\t']).starts_with("</");
    let blanks = typed.rest_of_word(|c| matches!(c, ' ' | '\t'));
    let wanted = match typed.just_opened {
        Some((tag, _)) => {
            let base = indent(&document.line_text(document.line_col(tag, Encoding::Utf8).line));
            match closes {
                true => format!("{base}{unit}{}{base}", line_end(document, start)),
                false => format!("{base}{unit}"),
            }
        }
        None => {
            let before = (0..line).rev().take(100).map(|line| document.line_text(line));
            let before = before.into_iter().find(|text| !text.trim().is_empty())?;
            let base = indent(&before);
            match closes && !before.trim_start().starts_with("</") {
                true => base.strip_suffix(unit).unwrap_or(&base).to_owned(),
                false => base,
            }
        }
    };
    let range = TextRange::new(start, typed.offset + blanks);
    (document.slice(range) != wanted).then_some(Insertion { range, text: wanted })
}

fn indent(line: &str) -> String {
    line.chars().take_while(|c| matches!(c, ' ' | '\t')).collect()
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
        match on_type(&document, offset as u32, character, "  ") {
            None => text,
            Some(edit) => {
                let mut text = text;
                text.replace_range(edit.range.start as usize..edit.range.end as usize, &edit.text);
                text
            }
        }
    }

    #[test]
    fn elements_are_closed_once() {
        for (text, expected) in [
            ("<robot><link name=\"x\">|", "<robot><link name=\"x\"></link>"),
            ("<robot><link name=\"x\">|</robot>", "<robot><link name=\"x\"></link></robot>"),
            ("<robot><link>|</link></robot>", "<robot><link></link></robot>"),
            ("<a><b>|</b></a>", "<a><b></b></a>"),
            ("<a><a>|</a>", "<a><a></a></a>"),
            ("<a><b/>|</a>", "<a><b/></a>"),
            ("<a></b>|</a>", "<a></b></a>"),
            ("<a><!-- <b>|", "<a><!-- <b>"),
            ("<a><!-- b -->|", "<a><!-- b -->"),
            ("<a x=\"1 >|\"", "<a x=\"1 >\""),
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
        ] {
            assert_eq!(edited(text, '/'), expected);
        }
    }

    #[test]
    fn new_lines_are_indented() {
        for (text, expected) in [
            ("<a>\n|", "<a>\n  "),
            ("<a>\n  <b\n    x=\"1\">\n|", "<a>\n  <b\n    x=\"1\">\n    "),
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
