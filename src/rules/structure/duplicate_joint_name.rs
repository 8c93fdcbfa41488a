//! Two joints of one name.

use super::super::context::RobotCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::Text;

pub(super) const RULE: Rule = Rule {
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
    let mut first: FastMap<&str, &Text> = FastMap::default();
    for name in cx.robot.joints.iter().filter_map(|joint| joint.name.as_ref()) {
        let Some(text) = name.name() else { continue };
        match first.get(text.as_str()) {
            Some(earlier) => out
                .report(name.origin, format!("a second joint is named `{text}`"))
                .also(earlier.origin, format!("the first joint named `{text}`"))
                .help("names of joints are unique; in a macro, begin them with a parameter: name=\"${prefix}...\"")
                .done(),
            None => {
                first.insert(text, name);
            }
        }
    }
}
