//! A name with characters that other tools do not take.
use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::xml::with_dollars;
use super::names::{self, NamedElement};
use base::FastMap;
use model::{AttrValue, JointType};

pub(in super::super) static RULE: Rule = Rule {
    code: "CNV001",
    name: "invalid-name",
    category: Category::Conventions,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("invalid-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !has_unusual(cx) {
        return check_robot(cx, out);
    }
    check_ends(cx, out);
    check_robot(cx, out);
    let signs = signs(cx);
    for (named, name) in cx.robot.into_iter().flat_map(names::names) {
        let Some(bad) = name.value.chars().find(|&c| !is_admitted(c)) else {
            continue;
        };
        let what = named.word();
        let shown = if bad.is_whitespace() {
            "whitespace".to_owned()
        } else {
            format!("`{bad}`")
        };
        if let Some(new) = with_dollars(cx, &name.value).filter(|_| name.is_literal()) {
            out.report(
                name.origin,
                format!("name of {what} {}contains {shown}", quoted(name)),
            )
            .help(format!("write `{new}`: an expression starts with `$`"))
            .replace_with(Safety::Unsafe, format!("replace with `{new}`"), new)
            .done();
            continue;
        }
        let report = out
            .report(
                name.origin,
                format!("name of {what} {}contains {shown}", quoted(name)),
            )
            // no controller ever names a joint that is fixed; names may have the letters of any language, and frames any sign
            .severity(
                if is_fixed_joint(cx, named, &name.value)
                    || signs.get(&bad).is_some_and(|&count| count >= SCHEME)
                    || name.value.chars().all(is_letter)
                    || named == NamedElement::Link && !name.value.chars().any(is_kept_apart)
                {
                    Severity::Info
                } else {
                    RULE.severity
                },
            )
            // a tool that writes such names writes all of them so
            .group(Group::Name(format!("{shown} in names").into()))
            .help("use only letters, digits, `_`, `-`, `.` and `/`");
        let new: String = name
            .value
            .trim()
            .chars()
            .map(|c| if is_admitted(c) { c } else { '_' })
            .collect();
        match names::rename(cx, named, &name.value, &new).filter(|_| !new.is_empty()) {
            Some(edits) => {
                report
                    .edits(
                        Safety::Unsafe,
                        format!("rename to `{new}` everywhere"),
                        edits,
                    )
                    .done();
            }
            None => report.done(),
        }
    }
}

/// Whether a name of a link or joint, or an end of a joint, has a character that others than these have.
fn has_unusual(cx: &DocumentCx<'_>) -> bool {
    cx.robot.is_some_and(|robot| robot.naming().marks.unusual)
}

/// The name of the robot, which becomes that of a model or a namespace in some programs.
fn check_robot(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let name = cx
        .robot
        .and_then(|robot| robot.name.as_ref())
        .filter(|name| name.is_known());
    let Some(name) = name.filter(|name| name.value.trim().contains(char::is_whitespace)) else {
        return;
    };
    out.report(
        name.origin,
        format!("name of robot {}contains whitespace", quoted(name)),
    )
    .severity(Severity::Info)
    .help("write `_` instead of spaces")
    .done();
}

/// The links that a joint names without the `$` of an expression.
fn check_ends(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for joint in cx.joints() {
        for (end, text) in [("parent", &joint.parent), ("child", &joint.child)] {
            let Some(text) = text.as_ref().filter(|text| text.is_literal()) else {
                continue;
            };
            let Some(new) = with_dollars(cx, &text.value) else {
                continue;
            };
            let message = format!(
                "{end} link `{}` of joint `{}` contains `{{`",
                text.value,
                joint.shown()
            );
            out.report(text.origin, message)
                .help(format!("write `{new}`: an expression starts with `$`"))
                .replace_with(Safety::Unsafe, format!("replace with `{new}`"), new)
                .done();
        }
    }
}

/// Names with the same sign that make a scheme, such as `finger[0]`: some program reads these.
const SCHEME: usize = 4;

/// How many names have each of the signs that stand for parts of something.
fn signs(cx: &DocumentCx<'_>) -> FastMap<char, usize> {
    let mut count = FastMap::default();
    for (_, name) in cx.robot.into_iter().flat_map(names::names) {
        for sign in ['[', ':', '#', '@'] {
            if name.value.contains(sign) {
                *count.entry(sign).or_default() += 1;
            }
        }
    }
    count
}

/// Whether the name is that of fixed joints.
fn is_fixed_joint(cx: &DocumentCx<'_>, named: NamedElement, name: &str) -> bool {
    let mut own = cx
        .joints()
        .iter()
        .filter(|joint| joint.shown() == name)
        .peekable();
    named == NamedElement::Joint
        && own.peek().is_some()
        && own.all(|joint| joint.is(&[JointType::Fixed]))
}

/// The name, unless it is so long that it cannot be meant as one: then it may be the text of some file.
fn quoted(name: &AttrValue) -> String {
    const MOST: usize = 100;
    if name.value.len() > MOST {
        String::new()
    } else {
        format!("`{}` ", name.value)
    }
}

/// Whether a letter is admitted, or one of another language than English.
fn is_letter(c: char) -> bool {
    is_admitted(c) || c.is_alphanumeric()
}

/// Whether a letter ends a name in some program, or was meant as a part of an expression.
fn is_kept_apart(c: char) -> bool {
    c.is_whitespace() || matches!(c, '{' | '}' | '$')
}

fn is_admitted(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '/' | '-')
}
