//! What to do about a problem for which the place that found it has no better advice.
use super::kind::ProblemKind;
use super::problem::Problem;
use expr::{ErrorKind, EvalError};

/// What to do about errors whose messages have some words; the first row that fits counts.
const ADVICE: [(&[&str], &str); 16] = [
    (
        &["YAML tag", "constructor for the tag"],
        "use a tag that xacro supports, such as `!degrees`, or remove it",
    ),
    (
        &["division by zero", "modulo"],
        "check the divisor; it is 0",
    ),
    (
        &["is a single string and outside"],
        "move the file into the package, or write a mapping or a list",
    ),
    (
        &["so its text is not shown"],
        "move the file into the package to see the error",
    ),
    (
        &["has no key", "unknown key"],
        "use a key that exists in the mapping",
    ),
    (
        &["index out of range"],
        "use an index from 0 to the number of items minus 1",
    ),
    (
        &[
            "could not convert string to float",
            "invalid literal for int()",
        ],
        "use a value that is a number",
    ),
    (
        &["is not set"],
        "set the environment variable, or write $(optenv NAME DEFAULT)",
    ),
    (
        &["math domain error", "math range error"],
        "check the arguments of the function; the result is not a real number",
    ),
    (
        &["has no attribute"],
        "check the spelling; the value has no such attribute or key",
    ),
    (
        &["No such file or directory", "Is a directory"],
        "correct the path, or add the file",
    ),
    (
        &["substitution args", "$("],
        "use $(find PACKAGE), $(arg NAME), $(env NAME), $(optenv NAME DEFAULT) or $(eval EXPRESSION)",
    ),
    (
        &["argument"],
        "check the number and the types of the arguments of the function",
    ),
    (
        &["must be str", "only concatenate"],
        "convert the number to a string with `str(...)`",
    ),
    (&["the limit"], "simplify the expression"),
    (
        &["xacro:element", "xacro:attribute"],
        "write an expression whose value is a name",
    ),
];

/// Python's words for a failed evaluation, where they say enough; what they leave out is added.
pub(super) fn headline(error: &EvalError) -> String {
    let message = error.message.as_str();
    match error.kind {
        ErrorKind::Key if !message.contains("()") => format!("unknown key {message}"),
        ErrorKind::YamlKey => message.replacen("The ", "the ", 1),
        ErrorKind::Io => message
            .split_once("] ")
            .map_or(message, |(_, rest)| rest)
            .to_owned(),
        _ => translated(message).unwrap_or_else(|| message.to_owned()),
    }
}

/// What Python says of types, in other words.
fn translated(message: &str) -> Option<String> {
    if let Some((operator, left, right)) = operands(message) {
        let (left, right) = (named(left), named(right));
        let both = match left.strip_prefix("a ").filter(|_| left == right) {
            Some(kind) => format!("two {kind}s"),
            None => format!("{left} and {right}"),
        };
        return Some(format!("`{operator}` cannot be applied to {both}"));
    }
    if let Some(rest) = message.strip_prefix("can only concatenate str (not \"") {
        let kind = rest.split('"').next()?;
        return Some(format!(
            "`+` cannot be applied to a string and {}",
            named(kind)
        ));
    }
    if let Some(tag) = message.strip_prefix("could not determine a constructor for the tag ") {
        return Some(format!("unknown YAML tag {tag}"));
    }
    let text = message.strip_prefix("could not convert string to float: ")?;
    Some(format!("{text} is not a number"))
}

/// The operator and the types of "unsupported operand type(s) for /: 'str' and 'float'".
fn operands(message: &str) -> Option<(&str, &str, &str)> {
    let (_, rest) = message.split_once("unsupported operand type(s) for ")?;
    let (operator, kinds) = rest.split_once(": ")?;
    let (left, right) = kinds.split_once(" and ")?;
    let right = right.split_whitespace().next()?;
    Some((operator, left.trim_matches('\''), right.trim_matches('\'')))
}

/// A type of Python for people.
fn named(kind: &str) -> String {
    match kind {
        "str" => "a string".to_owned(),
        "int" | "float" => "a number".to_owned(),
        "bool" => "a boolean".to_owned(),
        "list" | "tuple" => "a list".to_owned(),
        "dict" => "a mapping".to_owned(),
        "NoneType" => "nothing".to_owned(),
        kind => format!("`{kind}`"),
    }
}

/// The advice, in the imperative.
pub(super) fn of(problem: &Problem) -> String {
    let advice = match problem.kind {
        ProblemKind::UnknownMacroParam => "remove it, or add it to `params` of the macro",
        ProblemKind::MacroBlockMismatch => {
            "remove the extra element from the call, or add a block parameter `*name` to the macro"
        }
        ProblemKind::IncludeCycle => {
            "remove one of the includes, or put it in <xacro:if value=\"...\">"
        }
        ProblemKind::ShadowedBuiltin => {
            "rename the property; expressions can no longer use the built-in symbol"
        }
        ProblemKind::InvalidPropertyName => {
            "use letters, digits and `_`; do not start with a digit or use a Python keyword"
        }
        ProblemKind::InvalidExpression => {
            "write a Python expression such as `${2 * pi}`; quote strings as in `${'left' + side}`"
        }
        ProblemKind::ExpressionError => return of_failure(problem),
        ProblemKind::UnclosedExpression if problem.message.contains("${") => "add `}`",
        ProblemKind::UnclosedExpression => "add `)`",
        ProblemKind::MacroNameWithPrefix => {
            "write `xacro:` before the name in calls only, not in the definition"
        }
        ProblemKind::UnknownXacroAttribute => "remove the attribute",
        ProblemKind::MissingXacroAttribute if problem.message.starts_with("missing") => {
            "add the attribute with a value"
        }
        ProblemKind::MissingXacroAttribute => "remove the attribute",
        ProblemKind::IncludeChildrenIgnored => {
            "remove the child elements, or move them out of the include"
        }
        ProblemKind::InfiniteMacroRecursion => "simplify the robot description; the limit is fixed",
        ProblemKind::GlobIncludeNoMatch => "correct the pattern, or remove the include",
        ProblemKind::ConflictingPropertyAttributes => "keep only one of the attributes",
        ProblemKind::DefaultWithScope => "remove `scope`, or use `value` instead of `default`",
        ProblemKind::InvalidMacroName => "use another name",
        ProblemKind::InconsistentNamespaceRedefinition => {
            "use the same URI in both places, or another prefix"
        }
        ProblemKind::XmlSyntaxError => {
            "write the text itself instead of the entity, and remove the DOCTYPE"
        }
        _ => return of_evaluation(&problem.message),
    };
    advice.to_owned()
}

/// The advice, and Python's own words where the headline translates them.
fn of_failure(problem: &Problem) -> String {
    let words = problem
        .reference
        .split(" \nwhen evaluating")
        .next()
        .unwrap_or_default()
        .trim();
    match translated(words) {
        Some(_) if !words.contains('\n') => format!("{}; Python: {words}", of_evaluation(words)),
        _ => of_evaluation(&problem.message),
    }
}

/// Python's words, translated for those who do not know Python.
fn of_evaluation(message: &str) -> String {
    if let Some(advice) = of_operands(message) {
        return advice;
    }
    let advice = ADVICE
        .iter()
        .find(|(words, _)| words.iter().any(|part| message.contains(part)));
    advice
        .map_or(
            "check the types of the values in the expression; xacro evaluates it as Python",
            |(_, advice)| advice,
        )
        .to_owned()
}

/// "unsupported operand type(s) for /: 'str' and 'float'": which side is no number.
fn of_operands(message: &str) -> Option<String> {
    let (operator, left, right) = operands(message)?;
    let side = match (left == "str", right == "str") {
        (true, true) => "both values are strings",
        (true, false) => "the value on the left is a string",
        (false, true) => "the value on the right is a string",
        _ => return Some(format!("use numbers with `{operator}`")),
    };
    Some(format!(
        "convert the string with `float(...)`; `{operator}` needs numbers, but {side}"
    ))
}
