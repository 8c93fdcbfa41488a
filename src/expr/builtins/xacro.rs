//! The functions of the `xacro` namespace.

use std::str::Chars;

use super::Function;
use crate::args::{Args, Arity, bind_named};
use crate::display;
use crate::host::HostFn;
use crate::interp::Interp;
use crate::numeric::{decimal_digit, is_space};
use crate::stop::{Eval, Stop};
use crate::value::Value;

macro_rules! hosted {
    ($name:literal, $params:literal, $which:ident, $doc:literal) => {
        Function {
            name: $name,
            // a Python function, as all that is no built-in one
            owner: "xacro",
            params: $params,
            doc: $doc,
            arity: Arity::Any,
            run: |interp, _, args| call_host(interp, HostFn::$which, args),
        }
    };
}

/// All names in the order in which the reference lists them.
pub(super) static NAMES: &[&str] = &[
    "load_yaml",
    "abs_filename",
    "dotify",
    "arg",
    "message",
    "warning",
    "error",
    "print_location",
    "fatal",
    "tokenize",
];

/// Sorted by name. `dotify` is a type.
pub(super) static FUNCTIONS: &[Function] = &[
    hosted!(
        "abs_filename",
        "filename",
        AbsFilename,
        "The file name relative to the file being processed."
    ),
    hosted!("arg", "name", Arg, "The text of a substitution argument."),
    hosted!(
        "error",
        "*values",
        Error,
        "Print the values as an error and go on."
    ),
    hosted!(
        "fatal",
        "*values",
        Fatal,
        "Stop the processing with an error."
    ),
    hosted!(
        "load_yaml",
        "filename",
        LoadYaml,
        "The contents of a YAML file."
    ),
    hosted!("message", "*values", Message, "Print the values."),
    hosted!(
        "print_location",
        "",
        PrintLocation,
        "Print where the processing is."
    ),
    Function {
        name: "tokenize",
        owner: "xacro",
        params: "s, sep=',; ', skip_empty=True",
        doc: "Split a string at any of the separators.",
        arity: Arity::Any,
        run: tokenize,
    },
    hosted!(
        "warning",
        "*values",
        Warning,
        "Print the values as a warning and go on."
    ),
];

/// The functions that only `$(eval)` has, sorted by name.
pub(super) static OF_EVAL: &[Function] = &[
    hosted!("arg", "name", Arg, "The value of a substitution argument."),
    hosted!(
        "dirname",
        "",
        Dirname,
        "The folder of the file; fails in xacro."
    ),
    hosted!("env", "name", Env, "The value of an environment variable."),
    hosted!("find", "package", Find, "The share folder of a package."),
    hosted!(
        "optenv",
        "name, default=''",
        OptEnv,
        "The value of an environment variable, or the default."
    ),
];

fn call_host(interp: &mut Interp, function: HostFn, args: &Args) -> Eval {
    let at = interp.at;
    interp
        .host
        .call(function, &args.pos, &args.named, at)
        .map_err(Stop::from)
}

fn tokenize(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let given = Args {
        pos: args.pos.clone(),
        named: args.named.clone(),
    };
    let args = bind_named("tokenize", &["s", "sep", "skip_empty"], 1, 3, given)?;
    let Value::Str(text) = args.at(0) else {
        let kind = args.at(0).type_name();
        return Err(Stop::typ(format!(
            "expected string or bytes-like object, got '{kind}'"
        )));
    };
    let separators = match args.get(1) {
        None => ",; ".into(),
        Some(separators) => display::to_str(separators).ok_or(Stop::Unknown)?,
    };
    let skip_empty = args.get(2).map_or(Ok(true), |value| interp.truth(value))?;
    interp.budget.items(text.len() as u128)?;
    let class = CharClass::parse(&separators)?;
    let pieces = class
        .split(text)
        .into_iter()
        .filter(|piece| !skip_empty || !piece.is_empty());
    Ok(Value::list(pieces.map(Value::from)))
}

/// The separators, which the reference puts between the brackets of a regular expression.
struct CharClass {
    negated: bool,
    members: Vec<ClassMember>,
    /// What follows the set when a bracket among the separators closes it.
    tail: String,
}

enum ClassMember {
    Range(char, char),
    /// `\d`, `\w`, `\s`; in upper case everything else.
    Class(char),
}

impl ClassMember {
    fn has(&self, c: char) -> bool {
        match *self {
            Self::Range(first, last) => (first..=last).contains(&c),
            Self::Class('d') => decimal_digit(c).is_some(),
            Self::Class('s') => is_space(c),
            Self::Class('w') => c.is_alphanumeric() || c == '_',
            Self::Class(other) => !Self::Class(other.to_ascii_lowercase()).has(c),
        }
    }

    /// The member that begins with `c`.
    fn read(c: char, rest: &mut Chars<'_>) -> Eval<Self> {
        if c != '\\' {
            return Ok(Self::Range(c, c));
        }
        let c = rest.next().ok_or_else(unterminated)?;
        let character = match c {
            'd' | 'D' | 's' | 'S' | 'w' | 'W' => return Ok(Self::Class(c)),
            'a' => '\x07',
            'b' => '\x08',
            't' => '\t',
            'n' => '\n',
            'v' => '\x0b',
            'f' => '\x0c',
            'r' => '\r',
            'x' => by_code(c, 16, 2, 2, rest)?,
            'u' => by_code(c, 16, 4, 4, rest)?,
            'U' => by_code(c, 16, 8, 8, rest)?,
            '0'..='7' => {
                let digits = format!("{c}{}", rest.as_str());
                let mut all = digits.chars();
                let found = by_code(c, 8, 1, 3, &mut all)?;
                let used = digits.len() - all.as_str().len() - 1;
                *rest = rest.as_str().get(used..).unwrap_or("").chars();
                found
            }
            _ if c.is_ascii_alphanumeric() => {
                return Err(Stop::value(format!("bad escape \\{c}")));
            }
            _ => c,
        };
        Ok(Self::Range(character, character))
    }

    /// `self-last`
    fn up_to(&self, last: &Self) -> Eval<Self> {
        match (self, last) {
            (&Self::Range(first, _), &Self::Range(last, _)) if first <= last => {
                Ok(Self::Range(first, last))
            }
            _ => Err(Stop::value("bad character range")),
        }
    }
}

fn unterminated() -> Stop {
    Stop::value("unterminated character set at position 0")
}

/// The character whose code follows, in digits of `radix`: at least `least` and at most `most` of them.
fn by_code(
    escape: char,
    radix: u32,
    least: usize,
    most: usize,
    rest: &mut Chars<'_>,
) -> Eval<char> {
    let text = rest.as_str();
    let len = text
        .chars()
        .take(most)
        .take_while(|c| c.is_digit(radix))
        .count();
    let (digits, behind) = text.split_at(len);
    *rest = behind.chars();
    let code = u32::from_str_radix(digits, radix)
        .ok()
        .filter(|_| len >= least);
    let code = code
        .filter(|&code| radix != 8 || code <= 0o377)
        .and_then(char::from_u32);
    code.ok_or_else(|| Stop::value(format!("incomplete escape \\{escape}{digits}")))
}

impl CharClass {
    /// Read the separators as Python reads `[separators]`, which must end with its last bracket.
    fn parse(separators: &str) -> Eval<Self> {
        let pattern = format!("{separators}]");
        let (negated, set) = pattern
            .strip_prefix('^')
            .map_or((false, &*pattern), |rest| (true, rest));
        let mut rest = set.chars();
        let mut members = Vec::new();
        loop {
            let first = match rest.next().ok_or_else(unterminated)? {
                ']' if !members.is_empty() => break,
                c => ClassMember::read(c, &mut rest)?,
            };
            let mut ahead = rest.clone();
            if ahead.next() != Some('-') {
                members.push(first);
                continue;
            }
            match ahead.next().ok_or_else(unterminated)? {
                // a dash in front of the bracket is one of the characters, and the dash is read next
                ']' => members.push(first),
                c => {
                    let last = ClassMember::read(c, &mut ahead)?;
                    members.push(first.up_to(&last)?);
                    rest = ahead;
                }
            }
        }
        match rest.as_str() {
            tail if !tail.contains(|c| ".^$*+?{}[\\|()".contains(c)) => Ok(Self {
                negated,
                members,
                tail: tail.to_owned(),
            }),
            _ => Err(Stop::value(format!(
                "unsupported separators `{separators}`: only a set of characters is supported, with `]` first"
            ))),
        }
    }

    /// The pieces between the separators.
    fn split<'t>(&self, text: &'t str) -> Vec<&'t str> {
        let (mut pieces, mut start, mut at) = (Vec::new(), 0, 0);
        while let Some(c) = text.get(at..).and_then(|rest| rest.chars().next()) {
            let behind = at + c.len_utf8();
            at = behind;
            if self.matches(c)
                && text
                    .get(behind..)
                    .is_some_and(|rest| rest.starts_with(&self.tail))
            {
                pieces.extend(text.get(start..behind - c.len_utf8()));
                at = behind + self.tail.len();
                start = at;
            }
        }
        pieces.extend(text.get(start..));
        pieces
    }

    fn matches(&self, c: char) -> bool {
        self.members.iter().any(|member| member.has(c)) != self.negated
    }
}
