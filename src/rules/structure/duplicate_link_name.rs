//! Two links of one name.

use super::super::context::RobotCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::Text;

pub(super) const RULE: Rule = Rule {
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
    let mut first: FastMap<&str, &Text> = FastMap::default();
    for name in cx.robot.links.iter().filter_map(|link| link.name.as_ref()) {
        let Some(text) = name.name() else { continue };
        match first.get(text.as_str()) {
            Some(earlier) => out
                .report(name.origin, format!("a second link is named `{text}`"))
                .also(earlier.origin, format!("the first link named `{text}`"))
                .help("names of links are unique; in a macro, begin them with a parameter: name=\"${prefix}...\"")
                .done(),
            None => {
                first.insert(text, name);
            }
        }
    }
}
