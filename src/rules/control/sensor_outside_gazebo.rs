//! A sensor that no simulator sees, because it stands in its link and not in an element for Gazebo.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::xml::CheckedElement;
use model::{AttrValue, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL041",
    name: "sensor-outside-gazebo",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("sensor-outside-gazebo"),
    check: Check::Element(check),
};

/// What a sensor of URDF holds, which is a draft that nobody reads: one with more is meant for a simulator.
const OF_DRAFT: [&str; 2] = ["origin", "parent"];

fn check(cx: &DocumentCx<'_>, element: &CheckedElement, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let id = element.id;
    let in_link = element.parent.is_some_and(|parent| parent.name == "link");
    if !in_link || tree.get(id).text != "sensor" {
        return;
    }
    let says_more = |child| !OF_DRAFT.contains(&tree.get(child).text.as_str());
    let is_meant = tree.attr(id, "type").is_some() && tree.elements(id).any(says_more);
    let link = tree.parent(id).filter(|_| is_meant);
    let Some(link) = link.and_then(|link| AttrValue::attr(tree, link, "name")) else {
        return;
    };
    let name = AttrValue::attr(tree, id, "name");
    let named = name.map_or("a sensor".to_owned(), |name| {
        format!("sensor `{}`", name.value)
    });
    let link = &link.value;
    out.report(
        tag_start(cx.expansion, id),
        format!("{named} of link `{link}` is not simulated: it is outside of `<gazebo>`"),
    )
    .help(format!(
        "move it into <gazebo reference=\"{link}\">; simulators read no sensors elsewhere in a URDF"
    ))
    .done();
}
