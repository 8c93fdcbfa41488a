//! A joint that mimics another one, and takes commands.
use super::super::context::DocumentCx;
use super::super::edits::delete_element;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::{controlled, is_before_jazzy};
use model::tag_start;

pub(super) static RULE: Rule = Rule {
    code: "CTL008",
    name: "ros2-control-mimic-command",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("ros2-control-mimic-command"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut is_old = None;
    for (control, joint) in controlled(cx) {
        let released = control
            .mimic
            .as_ref()
            .is_some_and(|text| !text.is_known() || text.value.eq_ignore_ascii_case("false"));
        if joint.mimic.is_none() || released {
            continue;
        }
        let is_old = *is_old.get_or_insert_with(|| is_before_jazzy(cx));
        for command in &control.commands {
            let message = format!(
                "mimic joint `{}` cannot have a command interface",
                joint.shown()
            );
            let report = out
                .report(tag_start(cx.expansion, command.element), message)
                .severity(if is_old { Severity::Info } else { RULE.severity })
                .help("remove the command interface, or add mimic=\"false\" to the joint in ros2_control");
            let fix = (Safety::Unsafe, "remove the command interface");
            delete_element(report, cx.expansion, command.element, fix).done();
        }
    }
}
