//! An element that ros2_control does not know.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use expand::XId;
use model::tag_start;
use packages::nearest;

pub(super) static RULE: Rule = Rule {
    code: "CTL019",
    name: "ros2-control-unknown-tag",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-unknown-tag"),
    check: Check::Document(check),
};

/// The elements that ros2_control reads; `properties` only in its later versions.
const KNOWN: [&str; 6] = [
    "hardware",
    "joint",
    "sensor",
    "gpio",
    "transmission",
    "properties",
];

/// What may be in them: the name of the element, and those of its children.
const INSIDE: [(&str, &[&str]); 4] = [
    ("hardware", &["plugin", "param", "group", "properties"]),
    ("joint", &["command_interface", "state_interface", "param"]),
    ("sensor", &["state_interface", "param"]),
    ("gpio", &["command_interface", "state_interface", "param"]),
];

/// Whether an element in a joint is meant for another one, or one of xacro that stayed.
pub(super) fn is_misread_in_joint(tag: &str) -> bool {
    let inside = INSIDE.iter().find(|(outer, _)| *outer == "joint");
    let known = inside.map_or(&[][..], |(_, known)| known);
    tag.contains(':') || !known.contains(&tag) && nearest(tag, known.iter().copied()).is_some()
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for control in cx.robot.into_iter().flat_map(|robot| &robot.controls) {
        for id in tree.elements(control.element) {
            let name = tree.get(id).text.as_str();
            // tags of xacro that stayed have their own finding
            if !KNOWN.contains(&name) && !name.contains(':') {
                out.report(
                    tag_start(cx.expansion, id),
                    format!("unknown element `{name}` in ros2_control"),
                )
                .help(outer_help(name))
                .done();
            } else if let Some((_, known)) = INSIDE.iter().find(|(outer, _)| *outer == name) {
                tree.elements(id)
                    .for_each(|inner| check_inner(cx, (name, known), inner, out));
            }
        }
    }
}

/// What to do with an unknown element: the name that is meant, or the element that it belongs in.
fn outer_help(name: &str) -> Help {
    match (nearest(name, KNOWN), name) {
        (Some(near), _) => Help::did_you_mean(near),
        (None, "plugin" | "param") => format!("put <{name}> in <hardware>").into(),
        (None, "command_interface" | "state_interface") => {
            format!("put <{name}> in <joint name=\"...\">, <sensor> or <gpio>").into()
        }
        (None, _) => "use <hardware>, <joint>, <sensor>, <gpio> or <transmission>".into(),
    }
}

/// An element inside, which is misspelled; ros2_control passes over what it does not know.
fn check_inner(cx: &DocumentCx<'_>, (outer, known): (&str, &[&str]), id: XId, out: &mut Sink<'_>) {
    let name = cx.expansion.tree.get(id).text.as_str();
    let Some(near) = nearest(name, known.iter().copied()).filter(|near| *near != name) else {
        return;
    };
    out.report(
        tag_start(cx.expansion, id),
        format!("unknown element `{name}` in `{outer}` of ros2_control"),
    )
    .help(Help::did_you_mean(near))
    .done();
}
