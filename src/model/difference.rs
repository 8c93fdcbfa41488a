//! Where two descriptions of a robot first differ.

use std::ops::Range;

use super::attr_value::decimal;
use super::canonical::{Element, canonical};

/// What a comparison gave.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// Both describe the same robot.
    Same,
    /// They differ.
    Different(Difference),
    /// One of them is not well-formed, or has a document type.
    Unknown,
}

/// The first difference, in the order of the elements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Its place in the first text, bytes.
    pub one: Range<usize>,
    /// Its place in the second text.
    pub other: Range<usize>,
    /// What differs.
    pub what: DifferenceKind,
}

/// What differs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DifferenceKind {
    /// The text of an attribute or element; none where it is missing.
    Value {
        /// The attribute or element: `value` of `mass`.
        of: String,
        /// Its text in the first one.
        one: Option<String>,
        /// Its text in the second one.
        other: Option<String>,
    },
    /// An element that only the first one has.
    OnlyOne(String),
    /// An element that only the second one has.
    OnlyOther(String),
}

/// Compare two descriptions as readers of URDF do. White space, comments, the order of attributes, defaults that are
/// written out, digits beyond the precision of old versions of xacro, and the folders of absolute paths do not count.
pub fn compare(one: &str, other: &str) -> Comparison {
    if one == other || below_head(one).is_some_and(|body| below_head(other) == Some(body)) {
        return Comparison::Same;
    }
    let (Some(a), Some(b)) = (canonical(one), canonical(other)) else {
        return Comparison::Unknown;
    };
    let comparer = Comparer { one, other };
    match comparer.elements(&a, &b) {
        None => Comparison::Same,
        Some(difference) => Comparison::Different(difference),
    }
}

/// A document from its root element on; what stands above is comments, unless it declares entities.
fn below_head(text: &str) -> Option<&str> {
    let (head, body) = text.split_at_checked(text.find("<robot")?)?;
    (!head.contains("<!DOCTYPE")).then_some(body)
}

struct Comparer<'t> {
    one: &'t str,
    other: &'t str,
}

impl Comparer<'_> {
    fn elements(&self, a: &Element, b: &Element) -> Option<Difference> {
        if !is_counterpart(a, b) {
            return Some(self.difference(a, b, None, DifferenceKind::OnlyOne(shown(a))));
        }
        self.attributes(a, b).or_else(|| self.children(a, b))
    }

    fn attributes(&self, a: &Element, b: &Element) -> Option<Difference> {
        let mut names: Vec<&str> = a
            .attrs
            .iter()
            .chain(&b.attrs)
            .map(|(name, _)| name.as_str())
            .collect();
        names.sort_unstable();
        names.dedup();
        let differs = |name: &&str| match (a.attr(name), b.attr(name)) {
            (Some(one), Some(other)) => !is_same_value(one, other),
            _ => true,
        };
        let name = names.iter().copied().find(differs)?;
        let of = match name {
            "" => "text".to_owned(),
            _ => format!("`{name}` of {}", shown(a)),
        };
        let what = DifferenceKind::Value {
            of,
            one: a.attr(name).map(str::to_owned),
            other: b.attr(name).map(str::to_owned),
        };
        Some(self.difference(a, b, Some(name), what))
    }

    fn children(&self, a: &Element, b: &Element) -> Option<Difference> {
        let mut others = b.children.iter().peekable();
        for (number, child) in a.children.iter().enumerate() {
            let Some(other) = others.next() else {
                return Some(self.difference(
                    child,
                    b,
                    None,
                    DifferenceKind::OnlyOne(shown(child)),
                ));
            };
            if is_counterpart(child, other) {
                if let Some(difference) = self.elements(child, other) {
                    return Some(difference);
                }
                continue;
            }
            // one that comes later in the first text is there, and this one is in addition
            let rest = a.children.get(number + 1..).unwrap_or_default();
            let what = if rest.iter().any(|later| is_counterpart(later, other)) {
                DifferenceKind::OnlyOne(shown(child))
            } else {
                DifferenceKind::OnlyOther(shown(other))
            };
            return Some(self.difference(child, other, None, what));
        }
        let other = others.next()?;
        Some(self.difference(a, other, None, DifferenceKind::OnlyOther(shown(other))))
    }

    fn difference(
        &self,
        a: &Element,
        b: &Element,
        attr: Option<&str>,
        what: DifferenceKind,
    ) -> Difference {
        let (one, other) = (place(self.one, a, attr), place(self.other, b, attr));
        let is_value = matches!(
            &what,
            DifferenceKind::Value {
                one: Some(_),
                other: Some(_),
                ..
            }
        );
        match self.word(&one, &other).filter(|_| is_value) {
            Some((one, other)) => Difference { one, other, what },
            None => Difference { one, other, what },
        }
    }

    /// The first words of two values that differ.
    fn word(
        &self,
        one: &Range<usize>,
        other: &Range<usize>,
    ) -> Option<(Range<usize>, Range<usize>)> {
        let (a, b) = (words(self.one, one), words(self.other, other));
        let differs = |(a, b): &(Range<usize>, Range<usize>)| {
            let pair = self.one.get(a.clone()).zip(self.other.get(b.clone()));
            pair.is_some_and(|(a, b)| !is_same_word(a, b))
        };
        a.zip(b).find(differs)
    }
}

/// Whether two elements are the same thing, whatever is in them.
fn is_counterpart(a: &Element, b: &Element) -> bool {
    let is_same_name = a.attr("name") == b.attr("name");
    a.name == b.name && (is_same_name || a.name == "robot")
}

/// An element for people: link `tool0`.
fn shown(element: &Element) -> String {
    match (element.name.as_str(), element.attr("name")) {
        ("", _) => "the text".to_owned(),
        (tag, Some(name)) => format!("{tag} `{name}`"),
        (tag, None) => format!("`{tag}`"),
    }
}

/// Where an element begins, or one of its attributes.
fn place(text: &str, element: &Element, attr: Option<&str>) -> Range<usize> {
    let start = element.start;
    let rest = text.get(start..).unwrap_or_default();
    if element.name.is_empty() {
        let lead = rest.len() - rest.trim_start().len();
        let end = rest.find('<').unwrap_or(rest.len());
        let length = rest.get(..end).map_or(0, |text| text.trim_end().len());
        return start + lead.min(length)..start + length;
    }
    let tag = rest
        .find('>')
        .and_then(|end| rest.get(..end))
        .unwrap_or(rest);
    let whole = start..start + 1 + element.name.len();
    attr.and_then(|name| value_in(tag, name))
        .map_or(whole, |value| start + value.start..start + value.end)
}

/// The value of an attribute in a start tag, without its quotes.
fn value_in(tag: &str, name: &str) -> Option<Range<usize>> {
    let named = tag.match_indices(name).find_map(|(at, _)| {
        let is_whole = tag.get(..at)?.ends_with(char::is_whitespace);
        let rest = tag
            .get(at + name.len()..)?
            .trim_start()
            .strip_prefix('=')?
            .trim_start();
        let quote = rest
            .chars()
            .next()
            .filter(|c| is_whole && matches!(c, '"' | '\''))?;
        let start = tag.len() - rest.len() + 1;
        Some((start, tag.get(start..)?.find(quote)?))
    });
    named.map(|(start, length)| start..start + length)
}

/// The places of the words in a part of a text.
fn words<'t>(text: &'t str, part: &Range<usize>) -> impl Iterator<Item = Range<usize>> + use<'t> {
    let start = text.as_ptr() as usize;
    let words = text
        .get(part.clone())
        .unwrap_or_default()
        .split_ascii_whitespace();
    words.map(move |word| {
        let at = word.as_ptr() as usize - start;
        at..at + word.len()
    })
}

fn is_same_word(one: &str, other: &str) -> bool {
    one == other || is_same_number(one, other) || is_same_file(one, other)
}

/// Whether two values mean the same, word by word.
fn is_same_value(one: &str, other: &str) -> bool {
    let (mut a, mut b) = (one.split_ascii_whitespace(), other.split_ascii_whitespace());
    loop {
        match (a.next(), b.next()) {
            (None, None) => return true,
            (Some(a), Some(b)) if is_same_word(a, b) => {}
            _ => return false,
        }
    }
}

/// Python 2 printed numbers with twelve digits.
fn is_same_number(one: &str, other: &str) -> bool {
    const RELATIVE: f64 = 1e-9;
    const ABSOLUTE: f64 = 1e-12;
    match (decimal(one), decimal(other)) {
        (Some(a), Some(b)) => (a - b).abs() <= ABSOLUTE + RELATIVE * a.abs().max(b.abs()),
        _ => false,
    }
}

/// Whether two words are paths to files of one name. Folders of packages differ from machine to machine.
fn is_same_file(one: &str, other: &str) -> bool {
    is_path(one)
        && is_path(other)
        && last_name(one).contains('.')
        && last_name(one) == last_name(other)
}

fn is_path(text: &str) -> bool {
    text.starts_with('/') || text.contains(":/")
}

/// What follows the last slash.
fn last_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::{Comparison, DifferenceKind, compare};

    fn robot(content: &str) -> String {
        format!("<robot name='r'>{content}</robot>")
    }

    #[test]
    fn descriptions_of_the_same_robot() {
        for (one, other) in [
            ("<a x='1'/>", "<!-- generated -->\n  <a x=\"1.0\"></a>"),
            (
                "<origin rpy='0 0 1.5707963267948966'/>",
                "<origin rpy='0  0 1.57079632679'/>",
            ),
            ("<p>1.5707963267948966</p>", "<p> 1.57079632679 </p>"),
            (
                "<mesh filename='file:///ws/src/arm/a.stl'/>",
                "<mesh filename='file:///home/me/arm/a.stl'/>",
            ),
            (
                "<mesh filename='package://arm/a.stl'/>",
                "<mesh filename='file:///opt/share/arm/a.stl'/>",
            ),
            (
                "<parameters>/ws/src/arm/c.yaml</parameters>",
                "<parameters>/home/me/c.yaml</parameters>",
            ),
            (
                "<joint type='fixed'/>",
                "<joint type='fixed'><axis xyz='0 0 1'/></joint>",
            ),
        ] {
            assert_eq!(
                compare(&robot(one), &robot(other)),
                Comparison::Same,
                "{one}\n{other}"
            );
        }
    }

    /// The place of the first difference in both, and what it is.
    fn check_difference(one: &str, other: &str, expected: (&str, &str, &str)) {
        let (one, other) = (robot(one), robot(other));
        let Comparison::Different(found) = compare(&one, &other) else {
            panic!("{one}\n{other}")
        };
        let what = match found.what {
            DifferenceKind::Value { of, one, other } => format!("{of}: {one:?} {other:?}"),
            DifferenceKind::OnlyOne(what) => format!("+{what}"),
            DifferenceKind::OnlyOther(what) => format!("-{what}"),
        };
        assert_eq!(
            (&one[found.one], &other[found.other], what.as_str()),
            expected
        );
    }

    #[test]
    fn differences() {
        check_difference(
            "<link name='a'><mass value='2'/></link>",
            "<link name='a'> <mass  value = \"3\"/></link>",
            ("2", "3", "`value` of `mass`: Some(\"2.0\") Some(\"3.0\")"),
        );
        check_difference(
            "<a xyz='0 0.2 0'/>",
            "<a xyz='0.0  0.25 0'/>",
            (
                "0.2",
                "0.25",
                "`xyz` of `a`: Some(\"0.0 0.2 0.0\") Some(\"0.0 0.25 0.0\")",
            ),
        );
        check_difference("<a/><b/>", "<a/>", ("<b", "<robot", "+`b`"));
        check_difference(
            "<a/>",
            "<a/><link name='c'/>",
            ("<robot", "<link", "-link `c`"),
        );
        check_difference(
            "<link name='a'/><link name='b'/>",
            "<link name='b'/>",
            ("<link", "<link", "+link `a`"),
        );
        check_difference(
            "<link name='b'/>",
            "<link name='a'/><link name='b'/>",
            ("<link", "<link", "-link `a`"),
        );
        check_difference(
            "<a>one</a>",
            "<a>\n two </a>",
            ("one", "two", "text: Some(\"one\") Some(\"two\")"),
        );
        check_difference(
            "<a x='1'/>",
            "<a/>",
            ("1", "<a", "`x` of `a`: Some(\"1\") None"),
        );
        // a topic is not a path of a machine
        check_difference(
            "<a t='/left/cmd'/>",
            "<a t='/right/cmd'/>",
            (
                "/left/cmd",
                "/right/cmd",
                "`t` of `a`: Some(\"/left/cmd\") Some(\"/right/cmd\")",
            ),
        );
    }

    #[test]
    fn texts_that_cannot_be_compared() {
        for other in ["", "garbage", "<robot", "<!DOCTYPE a><robot/>"] {
            assert_eq!(compare("<robot/>", other), Comparison::Unknown, "{other}");
        }
    }
}
