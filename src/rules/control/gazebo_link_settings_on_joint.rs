//! Settings of a link for Gazebo under the name of a joint.
use std::cell::LazyCell;

use super::super::context::RobotCx;
use super::super::edits::rename;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::gazebo_missing_reference::OF_LINKS;
use base::{FastMap, FastSet};
use expand::XTree;
use model::{Gazebo, Joint};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL034",
    name: "gazebo-link-settings-on-joint",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("gazebo-link-settings-on-joint"),
    check: Check::Robot(check),
};

/// What only changes how a link looks.
const COLOR: &str = "material";

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let joints: LazyCell<FastMap<&str, &Joint>, _> = LazyCell::new(|| {
        let joints = cx.robot.joints.iter();
        joints.map(|joint| (joint.shown(), joint)).collect()
    });
    let by_name = LazyCell::new(|| settings_by_name(cx));
    for block in &cx.robot.gazebo {
        let Some((text, name)) = block
            .reference
            .as_ref()
            .and_then(|text| Some((text, text.name()?)))
        else {
            continue;
        };
        if cx.kinematics.link(name).is_some() {
            continue;
        }
        let mut settings = settings(tree, block);
        let is_all = tree.elements(block.element).count() == settings.len();
        settings.dedup();
        let joint = joints.get(name.as_str()).filter(|_| !settings.is_empty());
        let Some((_, child)) = joint.and_then(|joint| joint.ends()) else {
            continue;
        };
        let is_color = settings.iter().all(|setting| *setting == COLOR);
        let own = by_name.get(child.as_str());
        let has_own = own.is_some_and(|own| settings.iter().any(|setting| own.contains(setting)));
        let severity = if is_color || has_own {
            Severity::Info
        } else {
            RULE.severity
        };
        let message = format!("{} for links, but `{name}` is a joint", are(&settings));
        let report = out
            .report(text.origin, message)
            .severity(severity)
            .group(Group::File)
            .help(format!(
                "write reference=\"{child}\"; Gazebo ignores them at a joint"
            ));
        // settings of the joint have to stay where they are
        if is_all {
            rename(report, cx.expansion, text, child).done();
        } else {
            report.done();
        }
    }
}

/// What a sentence about settings begins with: the first of them, and how many more there are.
fn are(settings: &[&str]) -> String {
    const SHOWN: usize = 3;
    let shown: Vec<&str> = settings.iter().take(SHOWN).copied().collect();
    let shown = shown.join("`, `");
    match settings.len() {
        1 => format!("`{shown}` is"),
        count if count <= SHOWN => format!("`{shown}` are"),
        count => format!("`{shown}` and {} more are", count - SHOWN),
    }
}

/// The settings of links in a block, in document order.
fn settings<'t>(tree: &'t XTree, block: &Gazebo) -> Vec<&'t str> {
    let names = tree
        .elements(block.element)
        .map(|child| tree.get(child).text.as_str());
    names.filter(|name| OF_LINKS.contains(name)).collect()
}

/// The settings of links in all blocks, by the name that they refer to.
fn settings_by_name<'t>(cx: &RobotCx<'t>) -> FastMap<&'t str, FastSet<&'t str>> {
    let mut found: FastMap<&str, FastSet<&str>> = FastMap::default();
    for block in &cx.robot.gazebo {
        if let Some(text) = &block.reference {
            let own = found.entry(text.value.as_str()).or_default();
            own.extend(settings(&cx.expansion.tree, block));
        }
    }
    found
}
