//! A ros2_control of an unknown type.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::tag_start;
use workspace::nearest;

pub(super) const RULE: Rule = Rule {
    code: "CTL005",
    name: "ros2-control-invalid-type",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-invalid-type"),
    check: Check::Document(check),
};

/// The types that ros2_control knows.
const KNOWN: [&str; 3] = ["system", "actuator", "sensor"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for control in cx.robot.into_iter().flat_map(|robot| &robot.controls) {
        let name = control.name.as_ref().map_or("", |name| name.value.as_str());
        let Some(kind) = &control.kind else {
            out.report(
                tag_start(cx.expansion, control.element),
                format!("ros2_control `{name}` has no `type`"),
            )
            .help("write type=\"system\", type=\"actuator\" or type=\"sensor\"")
            .done();
            continue;
        };
        if kind.is_known() && !KNOWN.contains(&kind.value.as_str()) {
            let near = nearest(&kind.value, KNOWN).map(|near| format!("did you mean `{near}`?"));
            out.report(kind.origin, format!("ros2_control `{name}` has unknown type `{}`", kind.value))
                .help(near.unwrap_or_else(|| {
                    "write type=\"system\", type=\"actuator\" or type=\"sensor\"".to_owned()
                }))
                .done();
        }
    }
}
