//! A link with the name of a frame that localisation publishes.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::prefix_of;
use model::{Joint, JointType, Link};

pub(in super::super) static RULE: Rule = Rule {
    code: "FRM005",
    name: "reserved-frame-name",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("reserved-frame-name"),
    check: Check::Link(check),
};

/// The frames of REP-105 that no robot has among its links.
const RESERVED: [&str; 3] = ["map", "odom", "earth"];

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some((text, name)) = link
        .name
        .as_ref()
        .and_then(|text| Some((text, text.name()?)))
    else {
        return;
    };
    let found = |word: &&'static str| Some((*word, prefix_of(name, word)?));
    if let Some((word, prefix)) = RESERVED.iter().find_map(found) {
        out.report(
            text.origin,
            format!("link `{name}` has the name of a frame that localization publishes"),
        )
        .severity(if is_set_free(cx, name) || !is_of_robot(cx, prefix) {
            Severity::Info
        } else {
            RULE.severity
        })
        .help(format!(
            "remove or rename the link (`world` is allowed); `{word}` is not part of the robot"
        ))
        .done();
    }
}

/// Whether a prefix is one of the robot: its base has it, too.
fn is_of_robot(cx: &DocumentCx<'_>, prefix: &str) -> bool {
    const BASES: [&str; 2] = ["base_link", "base_footprint"];
    let is_there = |base: &&str| cx.links_named(&format!("{prefix}{base}")).next().is_some();
    prefix.is_empty() || BASES.iter().any(is_there)
}

/// Whether only joints that move hang on a link, and none fixes it: robot_state_publisher publishes none of them by itself, and a base
/// that moves is meant.
fn is_set_free(cx: &DocumentCx<'_>, link: &str) -> bool {
    let moves = |joint: &Joint| joint.kind.is_some() && !joint.is(&[JointType::Fixed]);
    let mut below = cx.joints_below(link).peekable();
    below.peek().is_some() && below.all(moves) && cx.joints_above(link).all(moves)
}
