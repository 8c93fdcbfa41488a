//! A link and a joint of one name.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use base::FastMap;
use model::AttrValue;

pub(super) static RULE: Rule = Rule {
    code: "STR011",
    name: "link-joint-same-name",
    category: Category::Structure,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("link-joint-same-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if cx.robot.is_none_or(|robot| !robot.naming().has_shared_name) {
        return;
    }
    let links = cx.links().iter().filter_map(|link| link.name.as_ref());
    let links: FastMap<&str, &AttrValue> = links
        .filter_map(|text| Some((text.name()?.as_str(), text)))
        .collect();
    for text in cx.joints().iter().filter_map(|joint| joint.name.as_ref()) {
        let Some(name) = text.name() else { continue };
        if let Some(link) = links.get(name.as_str()) {
            out.report(
                text.origin,
                format!("joint `{name}` has the same name as a link"),
            )
            .also(link.origin, format!("link `{name}`"))
            .help(format!(
                "rename the joint, for example to `{name}_joint`; SDF requires different names"
            ))
            .done();
        }
    }
}
