//! What stands between `$(` and `)`.

use ecow::EcoString;

use base::TextRange;

/// A substitution; ranges are offsets in the text between the parentheses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subst {
    /// `$(arg name)`
    Arg(SubstArg),
    /// `$(find package)`
    Find(SubstArg),
    /// `$(env NAME)`
    Env(SubstArg),
    /// `$(optenv NAME words)`
    OptEnv {
        /// The variable.
        name: SubstArg,
        /// The words behind it, joined by single blanks.
        default: EcoString,
    },
    /// `$(cwd)`
    Cwd,
    /// `$(eval code)`
    Eval {
        /// The Python expression, unstripped.
        code: TextRange,
    },
    /// `$()` and the like: no substitution, the text stays as it is.
    Verbatim,
    /// `$(dirname)`: known to the reference, but always fails there.
    Dirname(SubstError),
    /// Any other command, `anon` among them.
    Unknown {
        /// The command.
        command: SubstArg,
        /// What the reference says.
        error: SubstError,
    },
    /// A known command with wrong arguments, or characters that cannot stand here.
    Bad(SubstError),
}

/// A word and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SubstArg {
    /// The word.
    pub text: EcoString,
    /// Where it stands.
    pub range: TextRange,
}

/// Why a substitution cannot be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SubstError {
    /// Name of the exception's class, with its module.
    pub class: &'static str,
    /// Text of the exception.
    pub message: String,
}

impl SubstError {
    /// An error of the reference's own class.
    pub fn new(message: impl Into<String>) -> Self {
        Self {
            class: "xacro.substitution_args.SubstitutionException",
            message: message.into(),
        }
    }
}

/// The commands the reference knows besides `cwd` and `eval`.
const COMMANDS: &str = "['find', 'env', 'optenv', 'dirname', 'arg']";

/// Understand the text between `$(` and `)`.
pub fn parse_substitution(inner: &str) -> Subst {
    if inner == "cwd" {
        return Subst::Cwd;
    }
    if let Some(code) = inner.strip_prefix("eval ") {
        if code.contains("__") {
            return Subst::Bad(SubstError::new(
                "$(eval ...) may not contain double underscore expressions",
            ));
        }
        return Subst::Eval {
            code: TextRange::new(5, inner.len() as u32),
        };
    }
    let whole = format!("$({inner})");
    match collect(&whole) {
        Err(error) => Subst::Bad(error),
        Ok(found) => match found.first() {
            // Offsets in `inner` are two less than in `whole`.
            Some(range) => command(range.slice(&whole), range.start.saturating_sub(2)),
            None => Subst::Verbatim,
        },
    }
}

/// Replace the substitution `$(inner)` as the reference does: all commands first, then a second pass over the
/// result, in which only `find` is carried out but every command must be known.
///
/// `value` gives the text for an `Arg`, `Find`, `Env`, `OptEnv`, `Cwd` or `Eval`; the code of an
/// `Eval` is a range of `inner`.
///
/// # Errors
/// What `value` fails with, or what is wrong with the text.
pub fn resolve_substitution<E: From<SubstError>>(
    inner: &str,
    mut value: impl FnMut(&Subst) -> Result<EcoString, E>,
) -> Result<EcoString, E> {
    let first = parse_substitution(inner);
    if matches!(first, Subst::Cwd | Subst::Eval { .. }) {
        return value(&first);
    }
    if let Subst::Bad(error) = first {
        return Err(error.into());
    }
    let mut text = format!("$({inner})");
    for pass in [Pass::All, Pass::Find] {
        let mut result = text.clone();
        for range in collect(&text)? {
            let content = range.slice(&text);
            let found = command(content, 0);
            if let Subst::Unknown { error, .. } = found {
                return Err(error.into());
            }
            if pass == Pass::Find && !matches!(first_word(content), Some("find")) {
                // The reference looks no further than at the command's name here.
                if first_word(content).is_none() {
                    return Err(no_command().into());
                }
                continue;
            }
            match &found {
                Subst::Bad(error) | Subst::Dirname(error) => return Err(error.clone().into()),
                Subst::Verbatim => {}
                known => {
                    let new = value(known)?;
                    result = result.replace(&format!("$({content})"), &new);
                }
            }
        }
        text = result;
    }
    Ok(text.into())
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    All,
    Find,
}

fn first_word(content: &str) -> Option<&str> {
    content.split(' ').find(|word| !word.is_empty())
}

fn no_command() -> SubstError {
    SubstError {
        class: "IndexError",
        message: "list index out of range".into(),
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum ScanState {
    Out,
    Dollar,
    Open,
    In(usize),
}

/// The contents of all `$(…)` in a text.
fn collect(text: &str) -> Result<Vec<TextRange>, SubstError> {
    let mut found = Vec::new();
    let mut state = ScanState::Out;
    for (i, c) in text.char_indices() {
        state = match (c, state) {
            ('$', ScanState::Out | ScanState::Dollar) => ScanState::Dollar,
            ('$', _) => {
                let message =
                    format!("Dollar signs \"$\" cannot be inside of substitution args [{text}]");
                return Err(SubstError::new(message));
            }
            ('(', ScanState::Dollar) => ScanState::Open,
            ('(', ScanState::Out) => ScanState::Out,
            ('(', _) => {
                let message =
                    format!("Invalid left parenthesis \"(\" in substitution args [{text}]");
                return Err(SubstError::new(message));
            }
            (')', ScanState::In(start)) => {
                found.push(TextRange::new(start as u32, i as u32));
                ScanState::Out
            }
            (')', _) | (_, ScanState::Dollar) => ScanState::Out,
            (_, ScanState::Open) => ScanState::In(i),
            (_, state) => state,
        };
    }
    Ok(found)
}

/// Understand the content of one substitution, which starts at `base`.
fn command(content: &str, base: u32) -> Subst {
    let mut words = words(content, base);
    let Some(command) = words.next() else {
        return Subst::Bad(no_command());
    };
    let mut args: Vec<SubstArg> = words.collect();
    match command.text.as_str() {
        "arg" => match args.len() {
            0 => Subst::Bad(SubstError::new(format!(
                "$(arg var) must specify a variable name [{content}]"
            ))),
            1 => Subst::Arg(args.remove(0)),
            _ => Subst::Bad(SubstError::new(format!(
                "$(arg var) may only specify one arg [{content}]"
            ))),
        },
        "find" if args.len() == 1 => Subst::Find(args.remove(0)),
        "find" => Subst::Bad(SubstError::new(format!(
            "$(find pkg) accepts exactly one argument [{content}]"
        ))),
        "env" if args.len() == 1 => Subst::Env(args.remove(0)),
        "env" => Subst::Bad(SubstError::new(format!(
            "$(env var) command only accepts one argument [{content}]"
        ))),
        "optenv" if args.is_empty() => {
            let message = format!("$(optenv var) must specify an environment variable [{content}]");
            Subst::Bad(SubstError::new(message))
        }
        "optenv" => {
            let name = args.remove(0);
            let words: Vec<&str> = args.iter().map(|arg| arg.text.as_str()).collect();
            Subst::OptEnv {
                name,
                default: words.join(" ").into(),
            }
        }
        "dirname" => Subst::Dirname(SubstError::new(
            "Cannot substitute $(dirname),no file/directory information available.",
        )),
        _ => {
            let message =
                format!("Unknown substitution command [{content}]. Valid commands are {COMMANDS}");
            Subst::Unknown {
                command,
                error: SubstError::new(message),
            }
        }
    }
}

/// Words separated by blanks; no other white space counts.
fn words(content: &str, base: u32) -> impl Iterator<Item = SubstArg> + '_ {
    let mut at = 0;
    content.split(' ').filter_map(move |word| {
        let start = at;
        at += word.len() as u32 + 1;
        let range = TextRange::new(start, start + word.len() as u32).shift(base);
        (!word.is_empty()).then(|| SubstArg {
            text: word.into(),
            range,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The world of `tests/oracle/text_tables.py`.
    fn value(subst: &Subst) -> Result<EcoString, SubstError> {
        let undefined = |name: &str| SubstError {
            class: "undefined",
            message: name.into(),
        };
        let env = |name: &str| (name == "A").then_some("env-a");
        match subst {
            Subst::Arg(arg) => Ok(match arg.text.as_str() {
                "a" => "1".into(),
                "b" => "$(arg a)".into(),
                "c" => "$(find p)/x".into(),
                "d" => "x(y)".into(),
                "e" => "$(nope)".into(),
                "f" => "$( )".into(),
                "g" => "$".into(),
                "h" => "$(env)".into(),
                "i" => "$(find p q)".into(),
                "j" => "$(arg missing) $(find z)".into(),
                other => return Err(undefined(other)),
            }),
            Subst::Find(package) => Ok(format!("<find {}>", package.text).into()),
            Subst::Env(name) => env(&name.text).map(EcoString::from).ok_or_else(|| {
                SubstError::new(format!("environment variable '{}' is not set", name.text))
            }),
            Subst::OptEnv { name, default } => {
                Ok(env(&name.text).map_or(default.clone(), EcoString::from))
            }
            Subst::Cwd => Ok("<cwd>".into()),
            other => panic!("{other:?} has no value"),
        }
    }

    #[test]
    fn results_are_those_of_the_reference() {
        for line in include_str!("testdata/substitutions.txt").lines() {
            let (inner, want): (String, Vec<String>) = serde_json::from_str(line).unwrap();
            let got = match resolve_substitution(&inner, value) {
                Ok(text) => vec!["value".to_owned(), text.into()],
                Err(error) => vec!["error".to_owned(), error.class.to_owned(), error.message],
            };
            assert_eq!(got, want, "{inner:?}");
        }
    }

    #[test]
    fn arguments_have_places() {
        for (inner, want) in [
            ("arg  a", "a"),
            ("find my_pkg", "my_pkg"),
            ("env  A ", "A"),
            ("é x", "é"),
        ] {
            let arg = match parse_substitution(inner) {
                Subst::Arg(arg) | Subst::Find(arg) | Subst::Env(arg) => arg,
                Subst::Unknown { command, .. } => command,
                other => panic!("{other:?}"),
            };
            assert_eq!(
                (arg.text.as_str(), arg.range.slice(inner)),
                (want, want),
                "{inner}"
            );
        }
    }

    #[test]
    fn eval_is_taken_as_it_stands() {
        let inner = "eval 1 + x";
        let Subst::Eval { code } = parse_substitution(inner) else {
            panic!()
        };
        assert_eq!(code.slice(inner), "1 + x");
        let bad = SubstError::new("$(eval ...) may not contain double underscore expressions");
        assert_eq!(parse_substitution("eval a.__b"), Subst::Bad(bad));
    }
}
