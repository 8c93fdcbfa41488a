//! The functions of the `xacro` namespace.

use super::Function;
use crate::expr::args::{Args, Arity, bind_named};
use crate::expr::host::HostFn;
use crate::expr::interp::Interp;
use crate::expr::numeric::{decimal_digit, is_space};
use crate::expr::stop::{Eval, Stop};
use crate::expr::value::Value;

macro_rules! hosted {
    ($name:literal, $params:literal, $which:ident, $doc:literal) => {
        Function {
            name: $name,
            owner: "xacro",
            params: $params,
            doc: $doc,
            arity: Arity::Any,
            run: |interp, _, args| call_host(interp, HostFn::$which, args),
        }
    };
}

/// Sorted by name. `dotify` is a type.
pub(super) static FUNCTIONS: &[Function] = &[
    hosted!("abs_filename", "filename", AbsFilename, "The file name relative to the file being processed."),
    hosted!("arg", "name", Arg, "The text of a substitution argument."),
    hosted!("error", "*values", Error, "Print the values as an error and go on."),
    hosted!("fatal", "*values", Fatal, "Stop the processing with an error."),
    hosted!("load_yaml", "filename", LoadYaml, "The contents of a YAML file."),
    hosted!("message", "*values", Message, "Print the values."),
    hosted!("print_location", "", PrintLocation, "Print where the processing is."),
    Function {
        name: "tokenize",
        owner: "xacro",
        params: "s, sep=',; ', skip_empty=True",
        doc: "Split a string at any of the separators.",
        arity: Arity::Any,
        run: tokenize,
    },
    hosted!("warning", "*values", Warning, "Print the values as a warning and go on."),
];

fn call_host(interp: &mut Interp, function: HostFn, args: &Args) -> Eval {
    let at = interp.at;
    interp.host.call(function, &args.pos, &args.named, at).map_err(Stop::from)
}

fn tokenize(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let given = Args { pos: args.pos.clone(), named: args.named.clone() };
    let args = bind_named("tokenize", &["s", "sep", "skip_empty"], 1, 3, given)?;
    let Value::Str(text) = args.at(0) else {
        let kind = args.at(0).type_name();
        return Err(Stop::typ(format!("expected string or bytes-like object, got '{kind}'")));
    };
    let separators = match args.get(1) {
        None => ",; ",
        Some(Value::Str(separators)) => separators,
        Some(_) => return Err(Stop::typ("separators must be a string")),
    };
    let skip_empty = args.get(2).map_or(Ok(true), |value| interp.truth(value))?;
    interp.budget.items(text.len() as u128)?;
    let class = CharClass::parse(separators);
    let pieces = text.split(|c| class.matches(c)).filter(|piece| !skip_empty || !piece.is_empty());
    Ok(Value::list(pieces.map(Value::from)))
}

/// The separators, which the reference puts between the brackets of a regular expression.
struct CharClass {
    negated: bool,
    members: Vec<Member>,
}

enum Member {
    Range(char, char),
    /// `\d`, `\w`, `\s`; in upper case everything else.
    Class(char),
}

impl Member {
    fn has(&self, c: char) -> bool {
        match *self {
            Self::Range(first, last) => (first..=last).contains(&c),
            Self::Class('d') => decimal_digit(c).is_some(),
            Self::Class('s') => is_space(c),
            Self::Class('w') => c.is_alphanumeric() || c == '_',
            Self::Class(other) => !Self::Class(other.to_ascii_lowercase()).has(c),
        }
    }
}

impl CharClass {
    fn parse(text: &str) -> Self {
        let (negated, text) = text.strip_prefix('^').map_or((false, text), |rest| (true, rest));
        let mut members = Vec::new();
        let mut chars = text.chars().peekable();
        while let Some(c) = chars.next() {
            let first = match (c, chars.peek()) {
                ('\\', Some(&class @ ('d' | 'D' | 's' | 'S' | 'w' | 'W'))) => {
                    chars.next();
                    members.push(Member::Class(class));
                    continue;
                }
                ('\\', Some(_)) => escaped(chars.next().unwrap_or(c)),
                _ => c,
            };
            let mut ahead = chars.clone();
            match (ahead.next(), ahead.next()) {
                (Some('-'), Some(last)) => {
                    chars.nth(1);
                    members.push(Member::Range(first, last));
                }
                _ => members.push(Member::Range(first, first)),
            }
        }
        Self { negated, members }
    }

    fn matches(&self, c: char) -> bool {
        self.members.iter().any(|member| member.has(c)) != self.negated
    }
}

fn escaped(c: char) -> char {
    match c {
        't' => '\t',
        'n' => '\n',
        'r' => '\r',
        other => other,
    }
}
