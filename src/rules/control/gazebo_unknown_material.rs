//! A material that Gazebo does not have.
use super::super::context::DocumentCx;
use super::super::edits::rename;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::sdf::{MATERIALS, has, near};
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL043",
    name: "gazebo-unknown-material",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("gazebo-unknown-material"),
    check: Check::Document(check),
};

/// What the names of materials of Gazebo begin with.
const START: &str = "Gazebo/";

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for block in cx.robot.into_iter().flat_map(|robot| &robot.gazebo) {
        for id in tree.elements(block.element) {
            if tree.get(id).text != "material" || tree.elements(id).next().is_some() {
                continue;
            }
            let text = AttrValue::content(tree, id).filter(AttrValue::is_known);
            if let Some(text) = text {
                check_name(cx, &text, out);
            }
        }
    }
}

fn check_name(cx: &DocumentCx<'_>, text: &AttrValue, out: &mut Sink<'_>) {
    let name = text.value.trim();
    // without it, the name may be one of a file of the robot's own
    let own = name.strip_prefix(START);
    let color = own.unwrap_or(name);
    let is_known = |color: &str| has(MATERIALS, color);
    if color.is_empty() || own.is_some_and(is_known) {
        return;
    }
    let meant = match own {
        Some(_) => near(color, MATERIALS),
        None => MATERIALS
            .split_whitespace()
            .find(|known| known.eq_ignore_ascii_case(color)),
    };
    let severity = match (meant, own) {
        // as which Gazebo shows what it does not know
        (Some("White"), _) => Severity::Info,
        (Some(_), _) => RULE.severity,
        (None, Some(_)) => Severity::Info,
        (None, None) => return,
    };
    let report = out
        .report(text.origin, format!("Gazebo has no material `{name}`"))
        .severity(severity)
        .group(Group::Name(name.into()));
    let Some(meant) = meant.map(|meant| format!("{START}{meant}")) else {
        let help = "choose one of `gazebo.material`, or remove it: newer versions of Gazebo take the color of the `visual`";
        return report.help(help).done();
    };
    let report = report.help(Help::did_you_mean(&meant).and("Gazebo shows the link in white"));
    rename(report, cx.expansion, text, &meant).done();
}
