//! Numbered tool frames.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::Link;

pub(super) static RULE: Rule = Rule {
    code: "FRM009",
    name: "tool-frame-name",
    category: Category::Frames,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("tool-frame-name"),
    check: Check::Link(check),
};

fn check(_: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some((text, name)) = link
        .name
        .as_ref()
        .and_then(|text| Some((text, text.name()?)))
    else {
        return;
    };
    let last = name.rsplit(['_', '/']).next().unwrap_or_default();
    let number = last
        .strip_prefix("tool")
        .filter(|digits| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()));
    if number.is_some_and(|number| !number.trim_start_matches('0').is_empty()) {
        out.report(
            text.origin,
            format!("tool frame `{name}` has a number instead of a name"),
        )
        .help("name the frame after the tool; only `tool0` has a fixed meaning")
        .done();
    }
}
