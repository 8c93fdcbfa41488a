//! What was meant by a text that says something else: the slips that many make have a name, and a text to type.

use super::Problem;
use expr::is_identifier;
use workspace::misspelled;

/// What a text was meant to be.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Meant {
    /// What to know about it.
    help: String,
    /// The text to type in its place, where that is sure.
    text: Option<String>,
}

impl Meant {
    fn new(help: impl Into<String>) -> Self {
        Self { help: help.into(), text: None }
    }

    fn with(mut self, text: impl Into<String>) -> Self {
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
pub(super) fn by_expression(code: &str) -> Option<Meant> {
    let command = code.split_whitespace().next().unwrap_or_default();
    if COMMANDS.contains(&command) && (code != command || command == "dirname") {
        let what = match command {
            "arg" => "an argument is read",
            "find" => "a package is found",
            _ => "this is written",
        };
        let text = format!("$({})", code.split_whitespace().collect::<Vec<_>>().join(" "));
        return Some(Meant::new(format!("{what} with round brackets: `{text}`")).with(text));
    }
    SLIPS.iter().find_map(|(help, mend)| {
        let text = mend(code).filter(|text| text != code && expr::parse(text).errors.is_empty())?;
        let text = format!("${{{text}}}");
        let meant = Meant::new(format!("{help}: `{text}`"));
        // other signs would have to be written as references
        Some(if text.contains(['<', '&', '"', '\'']) { meant } else { meant.with(text) })
    })
}

/// What to know, and the expression without the slip, if it has it.
type Slip = (&'static str, fn(&str) -> Option<String>);

const SLIPS: [Slip; 5] = [
    ("only plain signs and quotes mean something in expressions", |code| Some(plain_signs(code))),
    ("to multiply, write `*`", |code| Some(code.replace(" x ", " * ").replace(['×', '·'], "*"))),
    ("to multiply, write `*`", multiplied),
    ("write `and`, `or` and `not` in expressions", |code| {
        Some(
            code.replace("&&", " and ")
                .replace("||", " or ")
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" "),
        )
    }),
    ("to compare, write `==`", |code| code.split_once('=').map(|(left, right)| format!("{left}=={right}"))),
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
pub(super) fn by_failure(code: &str, message: &str) -> Option<Meant> {
    if message.contains("for ^:") {
        let text = format!("${{{}}}", code.replace('^', "**"));
        let meant = Meant::new(format!("`^` is no power in Python: write `{text}`"));
        return Some(if code.contains(['<', '&', '"', '\'']) { meant } else { meant.with(text) });
    }
    None
}

/// Names that expressions know without a definition, and that are written otherwise elsewhere.
const KNOWN: [&str; 12] =
    ["pi", "radians", "degrees", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "True"];

/// Of a name that nothing defines: the one that expressions know.
pub(super) fn by_name(name: &str) -> Option<Meant> {
    let bare = name.strip_prefix("M_").unwrap_or(name).to_lowercase();
    let is_meant = |known: &&&str| {
        known.to_lowercase() == bare || known.len() > 4 && known.strip_suffix('s') == Some(bare.as_str())
    };
    let known = *KNOWN.iter().find(is_meant)?;
    Some(Meant::new(format!("expressions know it as `{known}`")).with(known))
}

/// Xacro's own tag that a misspelled one was meant to be.
pub(super) fn by_tag(name: &str) -> Option<&'static str> {
    const TAGS: [&str; 9] =
        ["include", "property", "macro", "arg", "if", "unless", "insert_block", "element", "attribute"];
    let is_same = |tag: &&&str| tag.eq_ignore_ascii_case(name);
    TAGS.iter().find(is_same).copied().or_else(|| misspelled(name, TAGS))
}

/// What to write for a tag of another language.
pub(super) fn by_foreign_tag(name: &str) -> Option<&'static str> {
    Some(match name {
        "else" | "elif" | "elseif" => {
            "xacro has no `else`: close the `xacro:if` and write <xacro:unless value=\"...\"> with the same condition"
        }
        "for" | "foreach" | "while" | "loop" => {
            "xacro has no loops: write a macro that calls itself below a condition"
        }
        _ => return None,
    })
}

/// Of the name of an included file that is not there.
pub(super) fn by_include(name: &str) -> Option<Meant> {
    let rest = ["package://", "$find ", "$find(", "(find ", "{find "]
        .iter()
        .find_map(|open| name.strip_prefix(open))?;
    let end = rest.find(['/', ')', '}'])?;
    let (package, file) = rest.split_at(end);
    let file = file.trim_start_matches([')', '}']);
    let is_name = !package.is_empty() && package.chars().all(|c| c.is_alphanumeric() || "_-.".contains(c));
    let text = format!("$(find {package}){file}");
    (is_name && file.starts_with('/')).then(|| {
        Meant::new(format!("an include finds a package with `$(find ...)`: write `{text}`")).with(text)
    })
}

/// Of a `$(inner)` that is no substitution: a property or an argument, as far as there are such.
pub(super) fn by_round_brackets(inner: &str, is_property: bool, is_argument: bool) -> Option<Meant> {
    if !is_identifier(inner) {
        return None;
    }
    let (property, argument) = (format!("${{{inner}}}"), format!("$(arg {inner})"));
    Some(match (is_property, is_argument) {
        (true, _) => {
            Meant::new(format!("properties and parameters are read with `{property}`")).with(property)
        }
        (false, true) => Meant::new(format!("an argument is read with `{argument}`")).with(argument),
        _ => Meant::new(format!("a property is read with `{property}`, an argument with `{argument}`")),
    })
}

/// Of a parameter name that no call can give: the names in it. None when the name is good.
pub(super) fn by_parameter(name: &str) -> Option<Vec<&str>> {
    let (stars, bare) = name.split_at(name.len() - name.trim_start_matches('*').len());
    if is_identifier(bare) || stars.len() > 2 {
        return None;
    }
    let bare = match stars {
        "" => bare.strip_prefix("${").and_then(|rest| rest.strip_suffix('}')).unwrap_or(bare),
        _ => bare,
    };
    let whole = if stars.is_empty() { bare } else { name };
    let names: Vec<&str> = whole.split([',', ';']).filter(|part| !part.is_empty()).collect();
    names.iter().all(|part| is_identifier(part.trim_start_matches('*'))).then_some(names)
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
        let known = |name| by_name(name).and_then(|meant| meant.text).unwrap_or_default();
        assert_eq!(["PI", "M_PI", "radian", "Sqrt", "width"].map(known), ["pi", "pi", "radians", "sqrt", ""]);
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
