//! A vector of too few or too many numbers.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::invalid_number::bad_words;
use super::seen::Numeric;
use super::walk;

pub(in super::super) static RULE: Rule = Rule {
    code: "XML011",
    name: "wrong-vector-length",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("wrong-vector-length"),
    check: Check::Number(check),
};

fn check(cx: &DocumentCx<'_>, number: &Numeric, out: &mut Sink<'_>) {
    let &Numeric {
        id,
        name,
        count,
        ref text,
    } = number;
    if count == 1 {
        return;
    }
    let found = text.words().count();
    // what is no number is reported as such: it may well be two of them
    if found == count || !bad_words(text, count).is_empty() {
        return;
    }
    let plural = if found == 1 { "number" } else { "numbers" };
    let message = format!(
        "`{name}` of {} has {found} {plural} instead of {count}",
        walk::described(cx, id)
    );
    let help = match example(name) {
        Some(example) => {
            format!("write {count} numbers separated by spaces: {name}=\"{example}\"")
        }
        None => format!("write {count} numbers separated by spaces"),
    };
    out.report(text.origin, message).help(help).done();
}

/// What the numbers of an attribute stand for.
fn example(name: &str) -> Option<&'static str> {
    Some(match name {
        "xyz" | "size" | "scale" => "X Y Z",
        "rpy" => "ROLL PITCH YAW",
        "rgba" => "RED GREEN BLUE ALPHA",
        _ => return None,
    })
}
