//! A Gazebo plugin without its library.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugins::plugins;
use expand::XId;
use model::tag_start;

pub(super) static RULE: Rule = Rule {
    code: "CTL016",
    name: "gazebo-plugin-missing-filename",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("gazebo-plugin-missing-filename"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for plugin in plugins(cx) {
        if tree.attr(plugin, "filename").is_none() {
            let name = tree
                .attr(plugin, "name")
                .map_or("", |name| name.value.as_str());
            let severity = if is_in_link(cx, plugin) {
                Severity::Info
            } else {
                RULE.severity
            };
            out.report(
                tag_start(cx.expansion, plugin),
                format!("plugin `{name}` has no `filename`"),
            )
            .severity(severity)
            .help("add filename=\"...\" with the plugin library")
            .done();
        }
    }
}

/// Whether a plugin is copied into a link or joint, from where Gazebo loads none, with a library or without.
fn is_in_link(cx: &DocumentCx<'_>, plugin: XId) -> bool {
    let parent = cx.expansion.tree.parent(plugin);
    let mut blocks = cx.robot.into_iter().flat_map(|robot| &robot.gazebo);
    blocks.any(|block| parent == Some(block.element) && block.reference.is_some())
}
