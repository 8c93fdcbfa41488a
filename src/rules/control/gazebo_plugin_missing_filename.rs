//! A Gazebo plugin without its library.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugins::plugins;
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
    for plugin in plugins(cx) {
        if cx.expansion.tree.attr(plugin, "filename").is_none() {
            let name = cx
                .expansion
                .tree
                .attr(plugin, "name")
                .map_or("", |name| name.value.as_str());
            out.report(
                tag_start(cx.expansion, plugin),
                format!("plugin `{name}` has no `filename`"),
            )
            .help("add filename=\"...\" with the plugin library")
            .done();
        }
    }
}
