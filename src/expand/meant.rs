//! What was meant by a text that says something else: the slips that many make have a name, and a text to type.
use super::Problem;
use expr::is_identifier;
use facts::XACRO_TAGS;
use packages::{misspelled, nearest};

/// What a text was meant to be.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct MeantText {
    /// What to know about it.
    help: String,
    /// The text to type in its place, where that is sure.
    text: Option<String>,
}

impl MeantText {
    pub fn new(help: impl Into<String>) -> Self {
        Self {
            help: help.into(),
            text: None,
        }
    }

    pub fn with(mut self, text: impl Into<String>) -> Self {
        self.text = Some(text.into());
        self
    }

    /// A problem with what was meant.
    pub fn said_of(self, problem: Problem) -> Problem {
        let problem = problem.help(self.help);
        match self.text {
            Some(text) => problem.replace_with(text),
            None => problem,
        }
    }
}

/// Words that begin `$(...)`.
const COMMANDS: [&str; 6] = ["find", "arg", "env", "optenv", "dirname", "eval"];

/// Of a `${code}` that does not parse.
pub(super) fn by_expression(code: &str) -> Option<MeantText> {
    let command = code.split_whitespace().next().unwrap_or_default();
    if COMMANDS.contains(&command) && (code != command || command == "dirname") {
        let what = match command {
            "arg" => "to read an argument",
            "find" => "to find a package",
            _ => "for this command",
        };
        let text = format!(
            "$({})",
            code.split_whitespace().collect::<Vec<_>>().join(" ")
        );
        return Some(MeantText::new(format!("write `{text}` {what}")).with(text));
    }
    SLIPS.iter().find_map(|(help, repair)| {
        let text =
            repair(code).filter(|text| text != code && expr::parse(text).errors.is_empty())?;
        let text = format!("${{{text}}}");
        let meant = MeantText::new(format!("{help}: `{text}`"));
        // other signs would have to be written as references
        Some(if text.contains(['<', '&', '"', '\'']) {
            meant
        } else {
            meant.with(text)
        })
    })
}

/// What to know, and the expression without the slip, if it has it.
type Slip = (&'static str, fn(&str) -> Option<String>);

const SLIPS: [Slip; 5] = [
    ("use ASCII operators and quotes", |code| {
        Some(plain_signs(code))
    }),
    ("use `*` to multiply", |code| {
        Some(code.replace(" x ", " * ").replace(['×', '·'], "*"))
    }),
    ("use `*` to multiply", multiplied),
    ("use `and`, `or` and `not`", |code| {
        Some(
            code.replace("&&", " and ")
                .replace("||", " or ")
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" "),
        )
    }),
    ("use `==` to compare", |code| {
        code.split_once('=')
            .map(|(left, right)| format!("{left}=={right}"))
    }),
];

/// `2width` as `2*width`.
fn multiplied(code: &str) -> Option<String> {
    let mut text = String::new();
    let mut in_word = false;
    let mut last = ' ';
    for c in code.chars() {
        let begins_name = c.is_alphabetic() || c == '_';
        if begins_name && last.is_ascii_digit() && !in_word {
            text.push('*');
        }
        in_word = begins_name || in_word && (c.is_alphanumeric() || c == '_');
        text.push(c);
        last = c;
    }
    Some(text)
}

/// A text with the signs of a keyboard where a word processor put its own.
pub(super) fn plain_signs(text: &str) -> String {
    let plain = |c: char| match c {
        '\u{2212}' | '\u{2013}' | '\u{2014}' => '-',
        '“' | '”' | '„' | '‘' | '’' | '‚' | '′' | '″' => '\'',
        '\u{a0}' => ' ',
        c => c,
    };
    text.chars().map(plain).collect()
}

/// Of an expression that Python cannot evaluate, with its words.
pub(super) fn by_failure(code: &str, message: &str) -> Option<MeantText> {
    if message.contains("for ^:") {
        let text = format!("${{{}}}", code.replace('^', "**"));
        let meant = MeantText::new(format!(
            "write `{text}`; the power operator of Python is `**`"
        ));
        return Some(if code.contains(['<', '&', '"', '\'']) {
            meant
        } else {
            meant.with(text)
        });
    }
    None
}

/// Names that expressions know without a definition, and that are written otherwise elsewhere.
const KNOWN: [&str; 12] = [
    "pi", "radians", "degrees", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt",
    "True",
];

/// Of a name that nothing defines: the one that expressions know.
pub(super) fn by_name(name: &str) -> Option<MeantText> {
    let bare = name.strip_prefix("M_").unwrap_or(name).to_lowercase();
    let is_meant = |known: &&&str| {
        known.to_lowercase() == bare
            || known.len() > 4 && known.strip_suffix('s') == Some(bare.as_str())
    };
    let known = *KNOWN.iter().find(is_meant)?;
    Some(MeantText::new(format!("did you mean `{known}`?")).with(known))
}

/// Of a name that nothing defines in `side == right`: the comparison with a string.
pub(super) fn by_comparison(name: &str, code: &str) -> Option<String> {
    let (left, right) = code.split_once("==").or_else(|| code.split_once("!="))?;
    let is_other_name = is_identifier(left.trim()) && left.trim() != name;
    let before = code.trim().strip_suffix(name)?;
    (is_other_name && right.trim() == name).then(|| format!("{before}'{name}'"))
}

/// Xacro's own tag that a misspelled one was meant to be.
pub(super) fn by_tag(name: &str) -> Option<&'static str> {
    // `call` is too near to names of macros
    let tags = || {
        let names = XACRO_TAGS.iter().map(|tag| tag.name);
        names.filter(|name| *name != "call")
    };
    tags()
        .find(|tag| tag.eq_ignore_ascii_case(name))
        .or_else(|| misspelled(name, tags()))
}

/// What to write for a tag of another language.
pub(super) fn by_foreign_tag(name: &str) -> Option<&'static str> {
    Some(match name {
        "else" | "elif" | "elseif" => {
            "close `xacro:if` and write <xacro:unless value=\"...\"> with the same condition; xacro has no `else`"
        }
        "for" | "foreach" | "while" | "loop" => {
            "write a macro that calls itself inside <xacro:if>; xacro has no loops"
        }
        _ => return None,
    })
}

/// Of the name of an included file that is not there.
pub(super) fn by_include(name: &str) -> Option<MeantText> {
    let rest = ["package://", "$find ", "$find(", "(find ", "{find "]
        .iter()
        .find_map(|open| name.strip_prefix(open))?;
    let end = rest.find(['/', ')', '}'])?;
    let (package, file) = rest.split_at(end);
    let file = file.trim_start_matches([')', '}']);
    let is_name = !package.is_empty()
        && package
            .chars()
            .all(|c| c.is_alphanumeric() || "_-.".contains(c));
    let text = format!("$(find {package}){file}");
    (is_name && file.starts_with('/')).then(|| MeantText::new(format!("write `{text}`")).with(text))
}

/// Of a `${` that is closed with `)`, or a `$(` that is closed with `}`; `rest` is the text from there on.
pub(super) fn by_other_bracket(rest: &str, open: &str) -> Option<MeantText> {
    let (other, close) = if open == "${" { (')', '}') } else { ('}', ')') };
    let inner = rest.strip_prefix(open)?;
    let end = inner.find(other)?;
    let (code, behind) = inner.split_at(end);
    let is_plain = !code.is_empty()
        && code
            .chars()
            .all(|c| c.is_alphanumeric() || " _.".contains(c));
    let text = format!("{open}{code}{close}");
    let whole = format!("{text}{}", behind.get(1..)?);
    is_plain.then(|| MeantText::new(format!("write `{text}`")).with(whole))
}

/// Of a `$(inner)` that is no substitution: a property or an argument, as far as there are such.
pub(super) fn by_round_brackets(
    inner: &str,
    is_property: bool,
    is_argument: bool,
) -> Option<MeantText> {
    if !is_identifier(inner) {
        return None;
    }
    let (property, argument) = (format!("${{{inner}}}"), format!("$(arg {inner})"));
    Some(match (is_property, is_argument) {
        (true, _) => MeantText::new(format!(
            "write `{property}` to read a property or parameter"
        ))
        .with(property),
        (false, true) => {
            MeantText::new(format!("write `{argument}` to read an argument")).with(argument)
        }
        _ => MeantText::new(format!(
            "write `{property}` to read a property, or `{argument}` to read an argument"
        )),
    })
}

/// Of a parameter name that no call can give: the names in it. None when the name is good.
pub(super) fn by_parameter(name: &str) -> Option<Vec<&str>> {
    let (stars, bare) = name.split_at(name.len() - name.trim_start_matches('*').len());
    if is_identifier(bare) || stars.len() > 2 {
        return None;
    }
    let bare = match stars {
        "" => bare
            .strip_prefix("${")
            .and_then(|rest| rest.strip_suffix('}'))
            .unwrap_or(bare),
        _ => bare,
    };
    let whole = if stars.is_empty() { bare } else { name };
    let names: Vec<&str> = whole
        .split([',', ';'])
        .filter(|part| !part.is_empty())
        .collect();
    names
        .iter()
        .all(|part| is_identifier(part.trim_start_matches('*')))
        .then_some(names)
}

/// The attribute of a tag of xacro that is meant by an unknown one: a near name, or one that is cut short (`val`).
pub(super) fn by_attribute<'a>(name: &str, allowed: &[&'a str]) -> Option<&'a str> {
    const SHORTEST: usize = 3;
    let is_cut = |whole: &&&str| {
        name.len() >= SHORTEST && whole.starts_with(name) && whole.len() > name.len()
    };
    let whole = allowed.iter().find(is_cut).copied();
    whole.or_else(|| nearest(name, allowed.iter().copied()))
}

#[cfg(test)]
mod tests {
    use super::{by_expression, by_name, by_parameter};

    fn text(code: &str) -> String {
        by_expression(code).map_or_else(String::new, |meant| meant.text.unwrap_or(meant.help))
    }

    #[test]
    fn expressions() {
        assert_eq!(text("find arm"), "$(find arm)");
        assert_eq!(text("arg  x"), "$(arg x)");
        assert_eq!(text("a - b x 2"), "${a - b * 2}");
        assert_eq!(text("a - 2b"), "${a - 2*b}");
        assert_eq!(text("a2b c"), "");
        assert_eq!(text("\u{2212}a"), "${-a}");
        assert_eq!(text("a || b"), "${a or b}");
        assert_eq!(text("a = b"), "${a == b}");
        assert_eq!(text("find"), "");
    }

    #[test]
    fn names() {
        let known = |name| {
            by_name(name)
                .and_then(|meant| meant.text)
                .unwrap_or_default()
        };
        assert_eq!(
            ["PI", "M_PI", "radian", "Sqrt", "width"].map(known),
            ["pi", "pi", "radians", "sqrt", ""]
        );
    }

    #[test]
    fn parameters() {
        let cases: [(&str, Option<&[&str]>); 7] = [
            ("a", None),
            ("*a", None),
            ("a,", Some(&["a"])),
            ("a,b", Some(&["a", "b"])),
            (",", Some(&[])),
            ("${a}", Some(&["a"])),
            ("a-b", None),
        ];
        for (name, expected) in cases {
            assert_eq!(by_parameter(name).as_deref(), expected, "{name}");
        }
    }
}
