//! Settings of a link for Gazebo that name no link.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::tag_start;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL020",
    name: "gazebo-missing-reference",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("gazebo-missing-reference"),
    check: Check::Document(check),
};

/// What belongs to one link.
pub(super) const OF_LINKS: [&str; 12] = [
    "mu1",
    "mu2",
    "kp",
    "kd",
    "material",
    "maxVel",
    "minDepth",
    "maxContacts",
    "fdir1",
    "laserRetro",
    "turnGravityOff",
    "dampingFactor",
];

/// What SDF has in links and in joints, but not in models.
const COPIED: [&str; 2] = ["gravity", "sensor"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for block in cx.robot.into_iter().flat_map(|robot| &robot.gazebo) {
        if block.reference.is_some() {
            continue;
        }
        let mut names = tree
            .elements(block.element)
            .map(|id| tree.get(id).text.as_str());
        let is_lost = |name: &&str| OF_LINKS.contains(name) || COPIED.contains(name);
        let Some(name) = names.find(is_lost) else {
            continue;
        };
        let message = format!("`{name}` belongs to a link, but this `gazebo` has no `reference`");
        out.report(tag_start(cx.expansion, block.element), message)
            .help("write <gazebo reference=\"...\"> with the name of the link")
            .done();
    }
}
