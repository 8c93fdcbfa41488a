//! Reading tags in text that may end anywhere.

use super::typed::is_name_char;
use xml::Node;

/// An element whose start tag was read, as far as it was.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Open {
    /// Where its start tag begins, from the start of the text that was read.
    pub start: usize,
    /// Its name.
    pub name: String,
    /// Its attributes with their values as written.
    pub attrs: Vec<(String, String)>,
    /// The names of the elements in it so far.
    pub children: Vec<String>,
}

impl Open {
    /// An element of a tree.
    pub fn of(node: Node<'_>) -> Self {
        let attrs = node
            .attrs()
            .map(|attr| (attr.name().to_owned(), attr.raw().to_owned()));
        Self {
            start: node.range().start as usize,
            name: node.name().to_owned(),
            attrs: attrs.collect(),
            children: Vec::new(),
        }
    }

    /// The value of an attribute, line ends and tabs as the blanks that XML takes them for.
    pub fn attr(&self, name: &str) -> Option<String> {
        let (_, value) = self.attrs.iter().find(|(given, _)| given == name)?;
        Some(value.replace(['\n', '\r', '\t'], " "))
    }
}

/// Where a text ends; offsets are those of the thing that is not finished.
pub(super) enum State {
    Nothing,
    Comment(usize),
    Content(usize),
    Tag(usize),
    EndTag(usize),
    Attribute(Open, usize),
    Value(Open, String, usize),
}

/// How a start tag ended.
enum Ending {
    /// `>`
    Open,
    /// `/>`, or given up.
    Closed,
    /// The text ended first.
    Cut(State),
}

/// Reads a text once.
pub(super) struct Reader<'t> {
    text: &'t str,
    pos: usize,
    /// The elements that are open.
    pub open: Vec<Open>,
    /// The end of the last start tag that opened an element.
    pub opened_at: Option<usize>,
    /// Names of end tags that closed nothing.
    pub unmatched: Vec<String>,
    most_unmatched: usize,
}

impl<'t> Reader<'t> {
    pub fn new(text: &'t str) -> Self {
        Self {
            text,
            pos: 0,
            open: Vec::new(),
            opened_at: None,
            unmatched: Vec::new(),
            most_unmatched: usize::MAX,
        }
    }

    /// Stop after so many end tags that close nothing.
    pub fn until_unmatched(mut self, most: usize) -> Self {
        self.most_unmatched = most;
        self
    }

    fn rest(&self) -> &'t str {
        self.text.get(self.pos..).unwrap_or("")
    }

    /// Read to the end.
    pub fn run(&mut self) -> State {
        loop {
            let content = self.pos;
            let Some(at) = memchr::memchr(b'<', self.rest().as_bytes()) else {
                return State::Content(content);
            };
            self.pos += at;
            if let Some(state) = self.markup() {
                return state;
            }
            if self.unmatched.len() >= self.most_unmatched {
                return State::Nothing;
            }
        }
    }

    /// Read what a `<` begins; the state when the text ends in it.
    fn markup(&mut self) -> Option<State> {
        let rest = self.rest();
        if rest.starts_with("<!--") {
            let start = self.pos + "<!--".len();
            return (!self.skip_past("-->", "<!--".len())).then_some(State::Comment(start));
        }
        for (begin, end) in [("<![CDATA[", "]]>"), ("<?", "?>"), ("<!", ">")] {
            if rest.starts_with(begin) {
                let subset = begin == "<!"
                    && rest
                        .split('>')
                        .next()
                        .is_some_and(|head| head.contains('['));
                let end = if subset { "]>" } else { end };
                return (!self.skip_past(end, begin.len())).then_some(State::Nothing);
            }
        }
        if rest.starts_with("</") {
            self.end_tag()
        } else {
            self.start_tag()
        }
    }

    /// Go behind the next `end`; false when there is none.
    fn skip_past(&mut self, end: &str, from: usize) -> bool {
        let found = self.rest().get(from..).and_then(|rest| rest.find(end));
        if let Some(at) = found {
            self.pos += from + at + end.len();
        }
        found.is_some()
    }

    /// Read a name; it may be empty.
    fn name(&mut self) -> &'t str {
        let rest = self.rest();
        let end = rest.find(|c: char| !is_name_char(c)).unwrap_or(rest.len());
        self.pos += end;
        rest.get(..end).unwrap_or("")
    }

    fn is_at_end(&self) -> bool {
        self.pos >= self.text.len()
    }

    fn end_tag(&mut self) -> Option<State> {
        self.pos += "</".len();
        let start = self.pos;
        let name = self.name();
        if self.is_at_end() {
            return Some(State::EndTag(start));
        }
        match self.open.iter().rposition(|open| open.name == name) {
            Some(at) => self.open.truncate(at),
            None => self.unmatched.push(name.to_owned()),
        }
        let end = self.rest().find(['<', '>']);
        let Some(end) = end else {
            return Some(State::Nothing);
        };
        self.pos += end + usize::from(self.rest().as_bytes().get(end) == Some(&b'>'));
        None
    }

    fn start_tag(&mut self) -> Option<State> {
        let begin = self.pos;
        self.pos += "<".len();
        let start = self.pos;
        let name = self.name();
        if self.is_at_end() {
            return Some(State::Tag(start));
        }
        if name.is_empty() {
            return None;
        }
        let mut tag = Open {
            start: begin,
            name: name.to_owned(),
            ..Open::default()
        };
        let ending = self.attributes(&mut tag);
        if let Ending::Cut(state) = ending {
            return Some(state);
        }
        if let Some(parent) = self.open.last_mut() {
            parent.children.push(tag.name.clone());
        }
        if matches!(ending, Ending::Open) {
            self.open.push(tag);
            self.opened_at = Some(self.pos);
        }
        None
    }

    /// Read the attributes and the end of a start tag.
    fn attributes(&mut self, tag: &mut Open) -> Ending {
        loop {
            let blank = self.blanks();
            let Some(next) = self.rest().chars().next() else {
                let state = if blank {
                    State::Attribute(tag.clone(), self.pos)
                } else {
                    State::Nothing
                };
                return Ending::Cut(state);
            };
            match next {
                '>' => {
                    self.pos += 1;
                    return Ending::Open;
                }
                '/' if self.rest().starts_with("/>") => {
                    self.pos += 2;
                    return Ending::Closed;
                }
                '<' => return Ending::Open,
                c if is_name_char(c) => {
                    if let Some(ending) = self.attribute(tag) {
                        return ending;
                    }
                }
                c => self.pos += c.len_utf8(),
            }
        }
    }

    /// Read an attribute; the end of the tag when it ends with it.
    fn attribute(&mut self, tag: &mut Open) -> Option<Ending> {
        let start = self.pos;
        let name = self.name();
        if self.is_at_end() {
            return Some(Ending::Cut(State::Attribute(tag.clone(), start)));
        }
        self.blanks();
        if !self.rest().starts_with('=') {
            tag.attrs.push((name.to_owned(), String::new()));
            return None;
        }
        self.pos += 1;
        self.blanks();
        let quote = self
            .rest()
            .chars()
            .next()
            .filter(|c| matches!(c, '"' | '\''));
        let Some(quote) = quote else {
            if self.is_at_end() {
                return Some(Ending::Cut(State::Nothing));
            }
            let rest = self.rest();
            let end = rest.find(|c: char| c.is_whitespace() || matches!(c, '<' | '>' | '/'));
            let end = end.unwrap_or(rest.len());
            tag.attrs
                .push((name.to_owned(), rest.get(..end).unwrap_or("").to_owned()));
            self.pos += end;
            return None;
        };
        self.pos += 1;
        let (start, rest) = (self.pos, self.rest());
        let Some(end) = rest.find([quote, '<']) else {
            return Some(Ending::Cut(State::Value(
                tag.clone(),
                name.to_owned(),
                start,
            )));
        };
        tag.attrs
            .push((name.to_owned(), rest.get(..end).unwrap_or("").to_owned()));
        self.pos += end;
        if rest.get(end..).is_some_and(|rest| rest.starts_with('<')) {
            // no value holds a `<`: the tag was left half-typed
            return Some(Ending::Closed);
        }
        self.pos += 1;
        None
    }

    /// Skip blanks; whether there were any.
    fn blanks(&mut self) -> bool {
        let rest = self.rest();
        let end = rest
            .find(|c: char| !c.is_whitespace())
            .unwrap_or(rest.len());
        self.pos += end;
        end > 0
    }

    /// In the middle of a start tag: the attributes that follow, and whether the tag ends.
    pub fn rest_of_tag(&mut self) -> (Vec<String>, bool) {
        // what directly follows may be the value of the attribute that is typed
        let mut tag = Open::default();
        if self.rest().trim_start().starts_with('=') {
            self.pos += self.rest().find('=').map_or(0, |at| at + 1);
            let _ = self.skip_value();
        }
        let ending = self.attributes(&mut tag);
        let ends = match ending {
            Ending::Open => self
                .text
                .get(..self.pos)
                .is_some_and(|read| read.ends_with('>')),
            Ending::Closed => self
                .text
                .get(..self.pos)
                .is_some_and(|read| read.ends_with("/>")),
            Ending::Cut(_) => false,
        };
        (tag.attrs.into_iter().map(|(name, _)| name).collect(), ends)
    }

    fn skip_value(&mut self) -> Option<()> {
        self.blanks();
        let quote = self
            .rest()
            .chars()
            .next()
            .filter(|c| matches!(c, '"' | '\''))?;
        let end = self.rest().get(1..)?.find([quote, '<'])?;
        self.pos += 1 + end + usize::from(self.rest().as_bytes().get(1 + end) != Some(&b'<'));
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Reader, State};

    fn state(text: &str) -> String {
        let mut reader = Reader::new(text);
        let state = reader.run();
        let open: Vec<&str> = reader.open.iter().map(|open| open.name.as_str()).collect();
        let what = match state {
            State::Nothing => "nothing".to_owned(),
            State::Comment(at) => format!("comment {}", &text[at..]),
            State::Content(at) => format!("content {}", &text[at..]),
            State::Tag(at) => format!("tag {}", &text[at..]),
            State::EndTag(at) => format!("end {}", &text[at..]),
            State::Attribute(tag, at) => format!("attribute of {} {}", tag.name, &text[at..]),
            State::Value(tag, name, at) => format!("{}.{name} {}", tag.name, &text[at..]),
        };
        format!("{} | {what}", open.join(" "))
    }

    #[test]
    fn texts_may_end_anywhere() {
        for (text, expected) in [
            ("<a><b x=\"1\"/> te", "a | content  te"),
            ("<a><b x=\"1\"></b><c", "a | tag c"),
            ("<a></", "a | end "),
            ("<a><b x='1' ", "a | attribute of b "),
            ("<a><b x='1'", "a | nothing"),
            ("<a><b x='1' y=\"2 ${", "a | b.y 2 ${"),
            ("<a><b x=\"half\n<c y=\"", "a | c.y "),
            ("<a><!-- <b ", "a | comment  <b "),
            ("<a><![CDATA[ <b ", "a | nothing"),
            (
                "<?xml version='1.0'?><!DOCTYPE a [<!ENTITY x 'y'>]><a ",
                " | attribute of a ",
            ),
            ("<a><b><c></b>", "a | content "),
            ("a < b <c", " | tag c"),
        ] {
            assert_eq!(state(text), expected, "{text}");
        }
    }

    #[test]
    fn the_rest_of_a_tag() {
        for (text, names, ends) in [
            (" upper=\"1\"/>", vec!["upper"], true),
            ("=\"1\" upper=\"1\">", vec!["upper"], true),
            ("\n  <b x=\"1\"/>", vec![], false),
            ("", vec![], false),
        ] {
            assert_eq!(
                Reader::new(text).rest_of_tag(),
                (names.into_iter().map(String::from).collect(), ends)
            );
        }
    }
}
