//! How the arguments of a call fit a built-in function, and what Python says when they do not.

use super::builtins::Function;
use super::stop::{Eval, Stop};
use super::value::{Str, Value};

/// The arguments of a call.
#[derive(Debug, Default)]
pub(crate) struct Args {
    /// Positional ones; after [`bind`] also named ones at their place, with [`Value::Unknown`] for one not given.
    pub(crate) pos: Vec<Value>,
    pub(crate) named: Vec<(Str, Value)>,
}

impl Args {
    pub(crate) fn len(&self) -> usize {
        self.pos.len()
    }

    pub(crate) fn has_unknown(&self) -> bool {
        self.pos.iter().any(Value::is_unknown)
            || self.named.iter().any(|(_, value)| value.is_unknown())
    }

    /// The argument at `place`, if it was given.
    pub(crate) fn get(&self, place: usize) -> Option<&Value> {
        self.pos.get(place).filter(|value| !value.is_unknown())
    }

    /// The argument at `place`, which the arity guarantees; `None` stands for one left out.
    pub(crate) fn at(&self, place: usize) -> &Value {
        static NONE: Value = Value::None;
        self.get(place).unwrap_or(&NONE)
    }

    /// A named argument that [`Arity::Any`] left in place.
    pub(crate) fn named(&self, name: &str) -> Option<&Value> {
        self.named
            .iter()
            .find(|(given, _)| given == name)
            .map(|(_, value)| value)
    }
}

/// Which arguments a function takes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Arity {
    /// None at all.
    Zero,
    /// Exactly one, by position.
    One,
    /// So many, by position.
    Range(usize, usize),
    /// By position or name; the first `required` must be given, the first `positional` may be given by position.
    Named {
        names: &'static [&'static str],
        required: usize,
        positional: usize,
    },
    /// The function sees for itself.
    Any,
    /// Any number by position, none by name.
    Positional,
}

/// The arguments in the order of the parameters.
pub(crate) fn bind(function: &Function, receiver: &Value, args: Args) -> Eval<Args> {
    let given = args.len();
    match function.arity {
        Arity::Any => return Ok(args),
        Arity::Named {
            names,
            required,
            positional,
        } => {
            return bind_named(function.name, names, required, positional, args);
        }
        _ if !args.named.is_empty() => {
            let name = function.qualified_name(receiver);
            return Err(Stop::typ(format!("{name} takes no keyword arguments")));
        }
        Arity::Zero if given != 0 => {
            let name = function.qualified_name(receiver);
            Err(Stop::typ(format!(
                "{name} takes no arguments ({given} given)"
            )))
        }
        Arity::One if given != 1 => {
            let name = function.qualified_name(receiver);
            Err(Stop::typ(format!(
                "{name} takes exactly one argument ({given} given)"
            )))
        }
        Arity::Range(min, max) => check_count(function.name, given, min, max),
        Arity::Zero | Arity::One | Arity::Positional => Ok(()),
    }?;
    Ok(args)
}

/// What follows a noun after a number.
pub(crate) fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// `pow expected 2 arguments, got 1`
pub(crate) fn check_count(name: &str, given: usize, min: usize, max: usize) -> Eval<()> {
    if (min..=max).contains(&given) {
        return Ok(());
    }
    let (bound, how) = match () {
        () if min == max => (min, ""),
        () if given < min => (min, "at least "),
        () => (max, "at most "),
    };
    let plural = plural(bound);
    Err(Stop::typ(format!(
        "{name} expected {how}{bound} argument{plural}, got {given}"
    )))
}

/// Arguments by position or name; a parameter without a name is taken by position only.
///
/// Errors are `round() takes at most 2 arguments (3 given)` and its relatives.
pub(crate) fn bind_named(
    function: &str,
    names: &[&str],
    required: usize,
    positional: usize,
    args: Args,
) -> Eval<Args> {
    // The usual call: nothing to rearrange.
    if args.named.is_empty() && (required..=positional).contains(&args.len()) {
        return Ok(args);
    }
    check_counts(function, names, required, positional, &args)?;
    let given = args.len();
    let Args { mut pos, named } = args;
    pos.resize(names.len(), Value::Unknown);
    let mut wrong = None;
    for (name, value) in named {
        match names.iter().position(|known| *known == name) {
            None => wrong = wrong.or(Some(name)),
            Some(place) if place < given => {
                return Err(Stop::typ(format!(
                    "argument for {function}() given by name ('{name}') and position ({})",
                    place + 1
                )));
            }
            Some(place) => {
                if let Some(slot) = pos.get_mut(place) {
                    *slot = value;
                }
            }
        }
    }
    let missing = pos.iter().take(required).position(Value::is_unknown);
    if let Some((place, name)) = missing.and_then(|place| Some((place + 1, names.get(place)?))) {
        return Err(Stop::typ(format!(
            "{function}() missing required argument '{name}' (pos {place})"
        )));
    }
    match wrong {
        Some(name) => Err(Stop::typ(format!(
            "'{name}' is an invalid keyword argument for {function}()"
        ))),
        None => Ok(Args {
            pos,
            named: Vec::new(),
        }),
    }
}

/// Whether the numbers of arguments fit, in total and by position.
fn check_counts(
    function: &str,
    names: &[&str],
    required: usize,
    positional: usize,
    args: &Args,
) -> Eval<()> {
    let (by_position, given) = (args.len(), args.len() + args.named.len());
    if given > names.len() {
        let how = if required == names.len() {
            "exactly"
        } else {
            "at most"
        };
        let keyword = if by_position == 0 { "keyword " } else { "" };
        let (most, s) = (names.len(), plural(names.len()));
        return Err(Stop::typ(format!(
            "{function}() takes {how} {most} {keyword}argument{s} ({given} given)"
        )));
    }
    if by_position > positional {
        if positional == 0 {
            return Err(Stop::typ(format!(
                "{function}() takes no positional arguments"
            )));
        }
        let how = if required >= positional {
            "exactly"
        } else {
            "at most"
        };
        let s = plural(positional);
        return Err(Stop::typ(format!(
            "{function}() takes {how} {positional} positional argument{s} ({by_position} given)"
        )));
    }
    let unnamed = names
        .iter()
        .take(required)
        .take_while(|name| name.is_empty())
        .count();
    if by_position < unnamed {
        let how = if unnamed < positional {
            "at least"
        } else {
            "exactly"
        };
        let s = plural(unnamed);
        return Err(Stop::typ(format!(
            "{function}() takes {how} {unnamed} positional argument{s} ({by_position} given)"
        )));
    }
    Ok(())
}
