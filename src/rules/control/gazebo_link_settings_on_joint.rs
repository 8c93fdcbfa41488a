//! Settings of a link for Gazebo under the name of a joint.
use super::super::context::RobotCx;
use super::super::edits::rename;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::gazebo_missing_reference::OF_LINKS;
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
    for block in &cx.robot.gazebo {
        let Some((text, name)) = block
            .reference
            .as_ref()
            .and_then(|text| Some((text, text.name()?)))
        else {
            continue;
        };
        let mut settings = settings(tree, block);
        settings.dedup();
        let is_joint = |joint: &&Joint| joint.shown() == name.as_str();
        let joint = cx.robot.joints.iter().find(is_joint);
        let (Some(joint), None) = (joint, cx.kinematics.link(name)) else {
            continue;
        };
        let Some((_, child)) = joint.ends().filter(|_| !settings.is_empty()) else {
            continue;
        };
        let is_color = settings.iter().all(|setting| *setting == COLOR);
        let severity = if is_color || has_own(cx, child, &settings) {
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
        if tree.elements(block.element).count() == settings.len() {
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

/// Whether a block about a link has one of these settings, too.
fn has_own(cx: &RobotCx<'_>, link: &str, names: &[&str]) -> bool {
    let tree = &cx.expansion.tree;
    let of_link = |block: &&Gazebo| {
        block
            .reference
            .as_ref()
            .is_some_and(|text| text.value == link)
    };
    let blocks = cx.robot.gazebo.iter().filter(of_link);
    blocks
        .flat_map(|block| settings(tree, block))
        .any(|own| names.contains(&own))
}
