//! Two links of one name.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::repeated_calls::{HELP, RepeatedCalls, differ_when_given};
use base::FastMap;
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR001",
    name: "duplicate-link-name",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("duplicate-link-name"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    if !cx.robot.naming().has_repeated_link {
        return;
    }
    let names = cx.robot.links.iter().filter_map(|link| link.name.as_ref());
    let mut calls = RepeatedCalls::default();
    let mut first: FastMap<&str, &AttrValue> = FastMap::default();
    for name in names {
        let Some(text) = name.name() else { continue };
        let Some(earlier) = first.get(text.as_str()) else {
            first.insert(text, name);
            continue;
        };
        let call = calls.between(cx.expansion, earlier.origin, name.origin);
        if call.as_ref().is_some_and(|call| !call.is_first) {
            continue;
        }
        let severity = if differ_when_given(cx.expansion, earlier, name) {
            Severity::Info
        } else {
            RULE.severity
        };
        out.report(name.origin, format!("duplicate link name `{text}`"))
            .severity(severity)
            .also(earlier.origin, format!("first link named `{text}`"))
            .help(call.map_or_else(|| HELP.to_owned(), |call| call.help()))
            .done();
    }
}
