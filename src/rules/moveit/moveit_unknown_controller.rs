//! A controller of MoveIt that no controller manager of the robot lists.
use super::super::beside::BesideCx;
use super::super::finding::Help;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::namespace::last;
use base::FastSet;
use packages::nearest;

pub(in super::super) static RULE: Rule = Rule::beside(
    "MOV007",
    "moveit-unknown-controller",
    Category::Moveit,
    Severity::Warning,
    page("moveit-unknown-controller"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let listed: FastSet<&str> = cx
        .all_settings()
        .flat_map(|settings| &settings.listed)
        .map(|listed| listed.name.name.as_str())
        .collect();
    // controllers of other programs, such as drivers, are listed nowhere
    let controllers = cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.moveit);
    let is_any_listed = controllers
        .clone()
        .any(|one| listed.contains(last(&one.name.name)));
    for controller in controllers.filter(|_| is_any_listed) {
        let name = last(&controller.name.name);
        if listed.contains(name) || project::is_computed(name) {
            continue;
        }
        let message = format!("controller `{name}` is not in any controller manager of the robot");
        let near = nearest(name, listed.iter().copied());
        // the driver of a gripper may offer the action itself
        let is_of_driver = controller.is_gripper() && near.is_none();
        let severity = if is_of_driver {
            Severity::Info
        } else {
            RULE.severity
        };
        let help = match near {
            Some(near) => Help::did_you_mean(near),
            None => {
                format!("add `{name}` with its `type` to the parameters of the controller manager")
                    .into()
            }
        };
        cx.report(out, &controller.name, message)
            .severity(severity)
            .help(help)
            .done();
    }
}
