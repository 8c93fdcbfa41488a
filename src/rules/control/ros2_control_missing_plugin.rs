//! Hardware of ros2_control without a plugin.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{AttrValue, Ros2Control, source_mentions, tag_start};
use packages::nearest;

pub(super) static RULE: Rule = Rule {
    code: "CTL002",
    name: "ros2-control-missing-plugin",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-missing-plugin"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| cx.whole()) else {
        return;
    };
    let tree = &cx.expansion.tree;
    for control in &robot.controls {
        let name = control.name.as_ref().map_or("", |name| name.value.as_str());
        if control.hardware.is_empty()
            && !source_mentions(cx.expansion, control.element, "hardware")
        {
            no_hardware(cx, control, name, out);
        }
        for &hardware in &control.hardware {
            let mut plugins = tree
                .elements(hardware)
                .filter(|&id| tree.get(id).text == "plugin");
            if !plugins.any(|plugin| AttrValue::content(tree, plugin).is_some()) {
                // other arguments choose one: the parameters of a hardware whose plugin is missing would be here
                let has_branch = source_mentions(cx.expansion, hardware, "plugin")
                    && tree.elements(hardware).next().is_none();
                let message = if has_branch {
                    format!("hardware of ros2_control `{name}` has no plugin with these arguments")
                } else {
                    format!("hardware of ros2_control `{name}` has no plugin")
                };
                out.report(tag_start(cx.expansion, hardware), message)
                    .severity(if has_branch { Severity::Info } else { RULE.severity })
                    .help(
                        "add <plugin>package/Class</plugin>; for testing, use mock_components/GenericSystem",
                    )
                    .done();
            }
        }
    }
}

/// A block that names no hardware at all. Where a macro or a block may bring it, nothing is said.
fn no_hardware(cx: &DocumentCx<'_>, control: &Ros2Control, name: &str, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let mut children = tree
        .elements(control.element)
        .map(|id| tree.get(id).text.as_str())
        .peekable();
    let is_empty = children.peek().is_none();
    // a plugin outside of hardware and misspelled names have their own findings
    if is_empty || children.any(|child| child == "plugin" || nearest(child, ["hardware"]).is_some())
    {
        return;
    }
    out.report(tag_start(cx.expansion, control.element), format!("ros2_control `{name}` has no hardware"))
        .help("add <hardware><plugin>package/Class</plugin></hardware>; for testing, use mock_components/GenericSystem")
        .done();
}
