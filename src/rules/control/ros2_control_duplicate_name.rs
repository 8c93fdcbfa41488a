//! Two ros2_control blocks of one name.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL006",
    name: "ros2-control-duplicate-name",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-duplicate-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut first: FastMap<&str, &AttrValue> = FastMap::default();
    let controls = cx.robot.into_iter().flat_map(|robot| &robot.controls);
    for text in controls.filter_map(|control| control.name.as_ref()) {
        let Some(name) = text.name() else { continue };
        match first.get(name.as_str()) {
            Some(earlier) => out
                .report(text.origin, format!("duplicate ros2_control name `{name}`"))
                .also(earlier.origin, format!("first ros2_control named `{name}`"))
                .help(
                    "rename one of them; in a macro, start the name with a parameter: name=\"${prefix}...\"",
                )
                .done(),
            None => {
                first.insert(name, text);
            }
        }
    }
}
