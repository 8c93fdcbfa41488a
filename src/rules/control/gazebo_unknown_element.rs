//! An element for Gazebo that Gazebo does not know at its place.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::xml::tag_names;
use super::sdf::{COPIED, SETTINGS, children_of, element_of, has, may_hold, near};
use expand::{XId, XTree};
use model::{Gazebo, tag_start};
use packages::nearest;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL042",
    name: "gazebo-unknown-element",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("gazebo-unknown-element"),
    check: Check::Document(check),
};

/// How many elements of a sensor or a block are read.
const MOST: usize = 1_000;

/// What changes nothing that a robot measures: simulators run a sensor that somebody listens to.
const IDLE: [&str; 2] = ["always_on", "visualize"];

/// The frame of the data, which sensors of SDF 1.12 have.
const FRAME: &str = "frame_id";

/// What is meant by an element that is not known.
enum Meant {
    /// Another name.
    Name(&'static str),
    /// The same one in these elements.
    Place(Vec<String>),
    Unknown,
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for block in cx.robot.into_iter().flat_map(|robot| &robot.gazebo) {
        check_settings(cx, block, out);
        for sensor in sensors(&cx.expansion.tree, block) {
            check_sensor(cx, sensor, out);
        }
    }
}

/// The settings of a link or a joint.
fn check_settings(cx: &DocumentCx<'_>, block: &Gazebo, out: &mut Sink<'_>) {
    if block.reference.is_none() {
        return;
    }
    let tree = &cx.expansion.tree;
    for id in tree.elements(block.element).take(MOST) {
        let name = tree.get(id).text.as_str();
        if name.contains(':') || has(SETTINGS, name) || has(COPIED, name) {
            continue;
        }
        let meant = near(name, SETTINGS).map_or(Meant::Unknown, Meant::Name);
        report(cx, id, block.element, &meant, out);
    }
}

/// The sensors of a block, wherever they are in it.
fn sensors(tree: &XTree, block: &Gazebo) -> Vec<XId> {
    let mut open = vec![block.element];
    let mut found = Vec::new();
    while let Some(element) = open.pop() {
        for id in tree.elements(element).take(MOST) {
            match tree.get(id).text.as_str() {
                "sensor" => found.push(id),
                "plugin" => {}
                _ => open.push(id),
            }
        }
    }
    found
}

fn check_sensor(cx: &DocumentCx<'_>, sensor: XId, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let mut open = vec![sensor];
    let mut left = MOST;
    while let Some(parent) = open.pop() {
        let around = tree.get(parent).text.as_str();
        for id in tree.elements(parent) {
            let name = tree.get(id).text.as_str();
            left = left.saturating_sub(1);
            if left == 0 {
                return;
            }
            if may_hold(around, name) {
                open.extend(children_of(name).map(|_| id));
            } else if !name.contains(':') {
                let meant = meant(tree, sensor, parent, name);
                report(cx, id, parent, &meant, out);
            }
        }
    }
}

/// What is meant by an element of a sensor that may not stand in `parent`.
fn meant(tree: &XTree, sensor: XId, parent: XId, name: &str) -> Meant {
    let around = tree.get(parent).text.as_str();
    let Some(children) = children_of(around) else {
        return Meant::Unknown;
    };
    let mut above =
        std::iter::successors(Some(parent), |&id| tree.parent(id).filter(|_| id != sensor));
    if let Some(right) = above.find(|&id| may_hold(&tree.get(id).text, name)) {
        return Meant::Place(vec![tree.get(right).text.to_string()]);
    }
    let kind = tree.attr(sensor, "type").map_or("", |kind| &kind.value);
    let is_own = |child: &&str| around != "sensor" || element_of(kind) == Some(*child);
    let below = children.clone().filter(|child| may_hold(child, name));
    let below: Vec<String> = below.filter(is_own).map(str::to_owned).collect();
    if !below.is_empty() {
        return Meant::Place(below);
    }
    // `distortion_k1` is not `distortion`
    let children = children.filter(|child| !name.starts_with(child));
    nearest(name, children).map_or(Meant::Unknown, Meant::Name)
}

fn report(cx: &DocumentCx<'_>, id: XId, parent: XId, meant: &Meant, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    let name = tree.get(id).text.as_str();
    let around = tree.get(parent).text.as_str();
    let (severity, help) = advice(tree, name, parent, meant);
    let report = out
        .report(
            tag_start(cx.expansion, id),
            format!("unknown element `{name}` in `{around}`"),
        )
        .severity(severity)
        .group(Group::Name(format!("{around} {name}").into()))
        .help(help);
    let Meant::Name(meant) = *meant else {
        return report.done();
    };
    match tag_names(cx.expansion, id).filter(|_| severity != Severity::Hint) {
        Some((file, names)) => {
            let edits = names.into_iter().map(|range| (range, meant.to_owned()));
            let what = format!("rename to `{meant}`");
            report.fix(Safety::Unsafe, what, file, edits).done();
        }
        None => report.done(),
    }
}

/// How much it matters that an element is ignored, and what to do.
fn advice(tree: &XTree, name: &str, parent: XId, meant: &Meant) -> (Severity, Help) {
    let weight = |name: &str| match IDLE.contains(&name) {
        true => Severity::Info,
        false => RULE.severity,
    };
    match meant {
        Meant::Name(meant) => {
            let mut given = tree.elements(parent).take(MOST);
            let severity = match given.any(|id| tree.get(id).text == *meant) {
                true => Severity::Hint,
                false => weight(meant),
            };
            let ignored = format!("Gazebo ignores `{name}`");
            (severity, Help::did_you_mean(*meant).and(&ignored))
        }
        Meant::Place(_) if name == FRAME => {
            let help = "write `gz_frame_id` in `sensor`; Gazebo ignores it here";
            (RULE.severity, Help::from(help))
        }
        Meant::Place(places) => {
            let places = places.join("` or `");
            let help = format!("move it into `{places}`; Gazebo ignores it here");
            (weight(name), Help::from(help))
        }
        Meant::Unknown => {
            let help = "remove it; Gazebo ignores it, and SDF does not have it here";
            (Severity::Hint, Help::from(help))
        }
    }
}
