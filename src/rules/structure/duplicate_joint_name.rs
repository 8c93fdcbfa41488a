//! Two joints of one name.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::repeated_calls::{HELP, RepeatedCalls, differ_when_given};
use base::FastMap;
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR002",
    name: "duplicate-joint-name",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("duplicate-joint-name"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    if !cx.robot.naming().has_repeated_joint {
        return;
    }
    let names = cx
        .robot
        .joints
        .iter()
        .filter_map(|joint| joint.name.as_ref());
    // what links show of two calls is not said again of joints
    let mut calls = RepeatedCalls::of_links(cx);
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
        out.report(name.origin, format!("duplicate joint name `{text}`"))
            .severity(severity)
            .also(earlier.origin, format!("first joint named `{text}`"))
            .help(call.map_or_else(|| HELP.to_owned(), |call| call.help()))
            .done();
    }
}
