//! A pure frame with geometry or inertia.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::prefix_of;
use model::{Link, Robot, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "FRM008",
    name: "frame-has-geometry",
    category: Category::Frames,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("frame-has-geometry"),
    check: Check::Document(check),
};

/// Links of an arm that show what is its prefix.
const COMPANY: [&str; 8] = [
    "base_link",
    "base",
    "link_0",
    "link0",
    "link_1",
    "link1",
    "tool0",
    "flange",
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot else { return };
    let tree = &cx.expansion.tree;
    for link in cx.links().iter().filter(|link| is_frame(robot, link)) {
        let is_body =
            |&id: &_| ["visual", "collision", "inertial"].contains(&tree.get(id).text.as_str());
        let Some(first) = tree.elements(link.element).find(is_body) else {
            continue;
        };
        let (name, body) = (link.shown(), &tree.get(first).text);
        out.report(
            tag_start(cx.expansion, first),
            format!("link `{name}` is a frame but has a `{body}`"),
        )
        .help(format!(
            "move it to a separate link and attach `{name}` to that link with a fixed joint"
        ))
        .done();
    }
}

/// Whether a link is one of the frames of an arm that have no body.
fn is_frame(robot: &Robot, link: &Link) -> bool {
    let Some(name) = link.name.as_ref().and_then(|name| name.name()) else {
        return false;
    };
    let prefix = ["flange", "tool0"]
        .iter()
        .find_map(|frame| prefix_of(name, frame));
    prefix.is_some_and(|prefix| {
        prefix.is_empty()
            || COMPANY
                .iter()
                .map(|other| format!("{prefix}{other}"))
                .any(|other| other != *name && robot.link(&other).is_some())
    })
}
