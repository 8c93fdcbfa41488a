//! Comments that hide findings: `<!-- xacro-lint: disable-next-line RULE, RULE: reason -->`.
use super::super::linter::directive::{Directive, Selector, Suppression};
use super::super::rule::Rule;
use super::reach::SuppressionIndex;
use base::{Encoding, TextRange};
use facts::may_hold;
use packages::nearest;
use xml::{Document, Node, NodeKind};

/// The words that may follow.
const WORDS: [&str; 4] = ["disable-next-line", "disable", "enable", "disable-file"];

/// Lines at the top of a file that `disable-file` may stand in.
const HEAD_LINES: u32 = 10;

/// A comment for the linter that cannot be understood.
#[derive(Clone, Debug)]
pub struct Malformed {
    /// The comment, absolute.
    pub comment: TextRange,
    /// What is wrong with it.
    pub message: String,
    /// What to write instead.
    pub help: String,
}

/// The comments for the linter in one file, in order.
#[derive(Clone, Debug, Default)]
pub struct Suppressions {
    /// Those that say something.
    pub list: Vec<Suppression>,
    /// Those that do not.
    pub malformed: Vec<Malformed>,
    reach: SuppressionIndex,
}

impl Suppressions {
    /// How comments for the linter begin.
    pub const MARK: &str = "xacro-lint:";

    /// Read the comments of a document.
    pub fn of(document: &Document) -> Self {
        let mut found = Self::default();
        if !may_hold(document, |marks| marks.lint) {
            return found;
        }
        let end = document.len();
        // numbers of the suppressions that wait for the next element
        let mut waiting: Vec<usize> = Vec::new();
        for (base, item) in document.parts() {
            for node in item.all_nodes() {
                match node.kind() {
                    NodeKind::Element => {
                        let scope = own_text(node).shift(base);
                        for at in waiting.drain(..) {
                            if let Some(suppression) = found.list.get_mut(at) {
                                suppression.scope = scope;
                            }
                        }
                    }
                    NodeKind::Comment => {
                        if let Some(parsed) = parse(node, base) {
                            found.add(parsed, document, end);
                            let last = found.list.last().map(|last| (last.directive, last.comment));
                            if last == Some((Directive::DisableNextLine, node.range().shift(base)))
                            {
                                waiting.push(found.list.len() - 1);
                            }
                        }
                    }
                    _ => {}
                }
            }
        }
        found.reach = SuppressionIndex::of(&found.list);
        found
    }

    fn add(&mut self, parsed: Result<Suppression, Malformed>, document: &Document, end: u32) {
        let mut suppression = match parsed {
            Ok(suppression) => suppression,
            Err(malformed) => return self.malformed.push(malformed),
        };
        let comment = suppression.comment;
        suppression.scope = match suppression.directive {
            Directive::DisableNextLine => TextRange::empty(comment.end),
            Directive::Disable | Directive::Enable => TextRange::new(comment.end, end),
            Directive::DisableFile => TextRange::new(0, end),
        };
        if suppression.directive == Directive::DisableFile
            && document.line_col(comment.start, Encoding::Utf8).line >= HEAD_LINES
        {
            return self.malformed.push(Malformed {
                comment,
                message: format!(
                    "`disable-file` has no effect after the first {HEAD_LINES} lines of a file"
                ),
                help: "move the comment to the top of the file, or write `disable`".to_owned(),
            });
        }
        self.list.push(suppression);
    }

    /// The number of the suppression that hides a finding of `rule` at `offset`, the nearest one first.
    pub fn hiding(&self, rule: &Rule, offset: u32) -> Option<usize> {
        self.reach.hiding(rule, offset)
    }

    /// Whether an `enable` at `offset` ends what a `disable` before it began.
    pub fn ended_by(&self, selector: &Selector, offset: u32) -> bool {
        self.reach
            .begins(&selector.text)
            .is_some_and(|begin| begin <= offset)
    }
}

/// The start tag; of an element that holds nothing but text, all of it.
fn own_text(element: Node<'_>) -> TextRange {
    let mut children = element.children().peekable();
    let tag = element.start_tag_range();
    if children.peek().is_none() || children.any(|child| child.kind() != NodeKind::Text) {
        return tag;
    }
    TextRange::new(tag.start, element.range().end)
}

/// Read a comment; none when it is not for the linter.
fn parse(comment: Node<'_>, base: u32) -> Option<Result<Suppression, Malformed>> {
    let text = comment.raw().trim_start();
    let range = comment.range().shift(base);
    let Some(rest) = text.strip_prefix(Suppressions::MARK) else {
        return misspelled(text).map(|(message, help)| {
            Err(Malformed {
                comment: range,
                message,
                help,
            })
        });
    };
    let start = base + comment.raw_range().end - rest.len() as u32;
    Some(
        read(rest, start, range).map_err(|(message, help)| Malformed {
            comment: range,
            message,
            help,
        }),
    )
}

/// What is wrong with a comment that begins nearly as those for the linter do, and goes on as they do.
fn misspelled(text: &str) -> Option<(String, String)> {
    let (name, _) = Suppressions::MARK.split_at(Suppressions::MARK.len() - 1);
    let (own, rest) = text.split_at_checked(name.len())?;
    let rest = rest.trim_start();
    let said = rest.strip_prefix(':').unwrap_or(rest);
    let word = said.split_whitespace().next()?;
    let is_word = WORDS.iter().any(|known| known.eq_ignore_ascii_case(word));
    if !own.eq_ignore_ascii_case(name) || !is_word {
        return None;
    }
    let begins = &text[..text.len() - said.len()];
    let message = format!(
        "suppression comment starts with `{1}` instead of `{0}`",
        Suppressions::MARK,
        begins.trim_end()
    );
    Some((
        message,
        format!("write <!-- {} {} -->", Suppressions::MARK, said.trim()),
    ))
}

/// Read what follows the mark; `start` is where it stands.
fn read(text: &str, start: u32, comment: TextRange) -> Result<Suppression, (String, String)> {
    const FORM: &str = "write <!-- xacro-lint: disable-next-line RULE: reason -->";
    // the reason begins behind the first colon
    let said = text.split(':').next().unwrap_or("");
    let word = said.split_whitespace().next().unwrap_or("");
    let directive = match word {
        "disable-next-line" => Directive::DisableNextLine,
        "disable" => Directive::Disable,
        "enable" => Directive::Enable,
        "disable-file" => Directive::DisableFile,
        "" => {
            return Err((
                "suppression comment has no directive".to_owned(),
                FORM.to_owned(),
            ));
        }
        _ => {
            let help = match nearest(word, WORDS) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("use one of `{}`", WORDS.join("`, `")),
            };
            return Err((
                format!("unknown directive `{word}` in a suppression comment"),
                help,
            ));
        }
    };
    let mut rules = Vec::new();
    let mut at = said.find(word).unwrap_or(0) + word.len();
    for part in said.get(at..).unwrap_or("").split(',') {
        let name = part.trim();
        let offset = start + (at + part.len() - part.trim_start().len()) as u32;
        if name.is_empty() {
            let message = format!("`{word}` has no rule");
            return Err((message, FORM.replace("disable-next-line", word)));
        }
        if name.contains(char::is_whitespace) {
            let help = "separate rules with commas, and start the reason with a colon".to_owned();
            return Err((
                format!(
                    "unknown rule `{}`",
                    name.split_whitespace().collect::<Vec<_>>().join(" ")
                ),
                help,
            ));
        }
        rules.push(Selector {
            text: name.to_owned(),
            range: TextRange::new(offset, offset + name.len() as u32),
        });
        at += part.len() + 1;
    }
    Ok(Suppression {
        directive,
        comment,
        rules,
        scope: TextRange::default(),
    })
}

#[cfg(test)]
mod tests {
    use super::super::super::registry::by_code;
    use super::Suppressions;
    use xml::Document;

    /// Whether a finding at the first `here` of a text is hidden from a rule.
    fn hides(text: &str, code: &str) -> bool {
        let found = Suppressions::of(&Document::parse(text));
        assert!(found.malformed.is_empty(), "{:?}", found.malformed);
        found
            .hiding(by_code(code).unwrap(), text.find("here").unwrap() as u32)
            .is_some()
    }

    #[test]
    fn where_they_hold() {
        let next = "<!-- xacro-lint: disable-next-line STR008: known -->";
        for (text, expected) in [
            (format!("<robot>{next}<link\n name='here'/></robot>"), true),
            (format!("<robot>{next}<link/><link name='here'/></robot>"), false),
            (format!("<robot>{next}<link><visual name='here'/></link></robot>"), false),
            (format!("<robot>{next}<param>here</param></robot>"), true),
            (format!("<robot><link>{next}</link><link name='here'/></robot>"), true),
            (format!("{next}<robot name='here'/>"), true),
            (format!("<robot>{next}{next}<link name='here'/></robot>"), true),
            (format!("<robot>{next}<link/>{next}<link/><link name='here'/></robot>"), false),
            ("<robot><!-- xacro-lint: disable STR --><a/><a>here</a></robot>".to_owned(), true),
            ("<robot><!-- xacro-lint: disable ALL --><!-- xacro-lint: enable STR --><a>here</a><!-- xacro-lint: disable STR0 --></robot>".to_owned(), false),
            ("<robot><!-- xacro-lint: disable ALL --><!-- xacro-lint: enable STR --><!-- xacro-lint: disable orphan-link --><a>here</a></robot>".to_owned(), true),
            ("<robot><a>here</a><!-- xacro-lint: disable STR --></robot>".to_owned(), false),
            (
                "<robot><!--xacro-lint: disable STR--><!-- xacro-lint: enable STR008 --><a>here</a></robot>"
                    .to_owned(),
                false,
            ),
            (
                "<robot><!--xacro-lint: disable STR--><!-- xacro-lint: enable STR007 --><a>here</a></robot>"
                    .to_owned(),
                true,
            ),
            ("<robot><a>here</a><!-- xacro-lint:disable-file\n no-links ,\n orphan-link : a: b --></robot>".to_owned(), true),
        ] {
            assert_eq!(hides(&text, "STR008"), expected, "{text}");
        }
    }

    #[test]
    fn what_an_enable_ends() {
        let ended = |begin: &str, end: &str| {
            let text = format!(
                "<robot><!-- xacro-lint: {begin} --><a/><!-- xacro-lint: enable {end} --></robot>"
            );
            let found = Suppressions::of(&Document::parse(&text));
            let last = found.list.last().unwrap();
            found.ended_by(&last.rules[0], last.comment.start)
        };
        for (begin, end, expected) in [
            ("disable STR008", "STR008", true),
            ("disable STR008", "STR007", false),
            ("disable STR008", "STR", true),
            ("disable STR", "STR008", true),
            ("disable no-links", "ALL", true),
            ("disable ALL", "no-links", true),
            ("disable nothing-known", "nothing-known", true),
            ("disable nothing-known", "ALL", false),
            ("disable-next-line STR008", "STR008", false),
        ] {
            assert_eq!(ended(begin, end), expected, "{begin}, {end}");
        }
    }

    #[test]
    fn many_comments_take_no_longer_than_they_are() {
        let one = |n: usize| {
            format!(
                "<!-- xacro-lint: disable x{n} --><!-- xacro-lint: enable ALL -->{}<a/>\n",
                "<!-- xacro-lint: disable-next-line STR008 -->"
            )
        };
        let text = format!(
            "<robot>{}</robot>",
            (0..20_000).map(one).collect::<String>()
        );
        let found = Suppressions::of(&Document::parse(&text));
        let rule = by_code("STR008").unwrap();
        let hidden = text
            .match_indices("<a/>")
            .filter(|(at, _)| found.hiding(rule, *at as u32).is_some());
        assert_eq!(hidden.count(), 20_000);
        let ends = found
            .list
            .iter()
            .filter(|one| found.ended_by(&one.rules[0], one.comment.start));
        assert_eq!(ends.count(), 0);
    }

    #[test]
    fn what_cannot_be_understood() {
        for (comment, expected) in [
            ("xacro-lint:", "suppression comment has no directive"),
            (
                "xacro-lint: disabel STR008",
                "unknown directive `disabel` in a suppression comment",
            ),
            ("xacro-lint: disable", "`disable` has no rule"),
            ("xacro-lint: disable: all of it", "`disable` has no rule"),
            ("xacro-lint: disable STR008, : why", "`disable` has no rule"),
            (
                "xacro-lint: disable STR008 STR007",
                "unknown rule `STR008 STR007`",
            ),
            (
                "Xacro-Lint: disable STR008",
                "suppression comment starts with `Xacro-Lint:` instead of `xacro-lint:`",
            ),
            (
                "xacro-lint disable STR008",
                "suppression comment starts with `xacro-lint` instead of `xacro-lint:`",
            ),
            (
                "XACRO-LINT : Disable x",
                "suppression comment starts with `XACRO-LINT :` instead of `xacro-lint:`",
            ),
        ] {
            let found = Suppressions::of(&Document::parse(&format!(
                "<robot><!-- {comment} --></robot>"
            )));
            let messages: Vec<&str> = found.malformed.iter().map(|m| m.message.as_str()).collect();
            assert_eq!(
                (messages, found.list.len()),
                (vec![expected], 0),
                "{comment}"
            );
        }
        let late = format!(
            "<robot>{}<!-- xacro-lint: disable-file STR008 --></robot>",
            "\n".repeat(10)
        );
        assert_eq!(Suppressions::of(&Document::parse(&late)).malformed.len(), 1);
        let other = Suppressions::of(&Document::parse(
            "<robot><!-- see xacro-lint: disable x --></robot>",
        ));
        assert!(other.malformed.is_empty() && other.list.is_empty());
        let prose = Suppressions::of(&Document::parse(
            "<robot><!-- xacro-lint finds this --></robot>",
        ));
        assert!(prose.malformed.is_empty() && prose.list.is_empty());
    }
}
