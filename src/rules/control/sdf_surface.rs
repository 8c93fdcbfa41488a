//! Friction and contact of a collision as SDF writes them, which URDF does not know.
use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::SDF_SURFACE;
use expand::{XId, XKind, XTree};
use model::{AttrValue, Body, JointType, Link, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL035",
    name: "sdf-surface",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("sdf-surface"),
    check: Check::Link(check),
};

/// A surface has some twenty elements in SDF.
const MOST_ELEMENTS: usize = 100;

/// What a surface has in a simulator of which nothing is said: 1 and 0 are friction and slip, the others are of contacts.
///
/// Source: the specification of SDFormat 1.11, `surface`.
const DEFAULTS: &[(&str, f64)] = &[
    ("mu", 1.0),
    ("mu1", 1.0),
    ("mu2", 1.0),
    ("friction", 1.0),
    ("friction2", 1.0),
    ("rolling_friction", 1.0),
    ("coefficient", 1.0),
    ("kd", 1.0),
    ("kp", 1e12),
    ("soft_erp", 0.2),
    ("max_vel", 0.01),
    ("threshold", 100_000.0),
];

/// What `<gazebo>` calls it that a surface calls otherwise.
const OF_GAZEBO: &[(&str, &str)] = &[
    ("mu", "mu1"),
    ("mu1", "mu1"),
    ("mu2", "mu2"),
    ("kp", "kp"),
    ("kd", "kd"),
    ("fdir1", "fdir1"),
    ("max_vel", "maxVel"),
    ("min_depth", "minDepth"),
];

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for body in &link.collisions {
        let surfaces = tree.elements(body.element).take(MOST_ELEMENTS);
        let Some(surface) = surfaces
            .into_iter()
            .find(|&child| tree.get(child).text == SDF_SURFACE)
        else {
            continue;
        };
        let settings = settings(tree, surface);
        let severity = if settings.is_empty() || has_own(cx, link) {
            Severity::Hint
        } else if slides(&settings) && !turns(cx, link) {
            RULE.severity
        } else {
            Severity::Info
        };
        let message = format!(
            "`surface` in the collision of link `{}` has no effect",
            link.shown()
        );
        out.report(tag_start(cx.expansion, surface), message)
            .severity(severity)
            // one element for Gazebo sets it for all bodies of a link
            .group(if is_repeated(link, tree) {
                Group::Thing(format!("surface of {}", link.shown()).into())
            } else {
                Group::File
            })
            .help(help(link, &settings))
            .done();
    }
}

/// Whether several collisions of a link have a surface.
fn is_repeated(link: &Link, tree: &XTree) -> bool {
    let has_surface = |body: &&Body| {
        let mut inside = tree.elements(body.element).take(MOST_ELEMENTS);
        inside.any(|child| tree.get(child).text == SDF_SURFACE)
    };
    link.collisions.iter().filter(has_surface).nth(1).is_some()
}

/// Whether a surface has less friction than others. Of two bodies that touch each other, Gazebo takes the smaller friction, so more
/// of it needs to be said of both.
fn slides(settings: &[(&str, String)]) -> bool {
    let is_less = |text: &str| text.trim().parse::<f64>().is_ok_and(|number| number < 1.0);
    let mut all = settings.iter();
    all.any(|(name, text)| ["mu", "mu1", "mu2"].contains(name) && is_less(text))
}

/// Whether a joint turns a link without end: a wheel that slides is hardly meant.
fn turns(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let joint = cx.joint_above(link.shown());
    joint.is_some_and(|joint| joint.is(&[JointType::Continuous]))
}

/// The names and texts of a surface that are not what a simulator takes anyway.
fn settings(tree: &XTree, surface: XId) -> Vec<(&str, String)> {
    let below = tree.below(surface).take(MOST_ELEMENTS);
    let mut found = Vec::new();
    for element in below.filter(|&id| tree.get(id).kind == XKind::Element) {
        let node = tree.get(element);
        let text =
            AttrValue::content(tree, element).filter(|_| tree.elements(element).next().is_none());
        let attrs = node
            .attrs
            .iter()
            .map(|attr| (&*attr.name, attr.value.to_string()));
        let own = text.map(|text| (node.text.as_str(), text.value.to_string()));
        found.extend(
            own.into_iter()
                .chain(attrs)
                .filter(|(name, text)| !is_default(name, text)),
        );
    }
    found
}

fn is_default(name: &str, text: &str) -> bool {
    let defaults = DEFAULTS.iter().find(|(known, _)| *known == name);
    let number = |text: &str| text.trim().parse::<f64>().ok();
    match defaults {
        Some((_, value)) => number(text) == Some(*value),
        None => {
            matches!(text.trim(), "false" | "world")
                || text
                    .split_whitespace()
                    .all(|word| number(word) == Some(0.0))
        }
    }
}

/// Whether the link has friction or contacts of its own where simulators read them.
fn has_own(cx: &DocumentCx<'_>, link: &Link) -> bool {
    cx.look_beyond();
    let tree = &cx.expansion.tree;
    let blocks = cx.robot.into_iter().flat_map(|robot| &robot.gazebo);
    let mut own = blocks.filter(|block| {
        let name = block.reference.as_ref().map(|text| text.value.as_str());
        name == Some(link.shown())
    });
    own.any(|block| {
        let mut settings = tree
            .elements(block.element)
            .map(|id| tree.get(id).text.as_str());
        settings.any(|name| OF_GAZEBO.iter().any(|(_, own)| *own == name) || name == "collision")
    })
}

/// Where to write what the surface says.
fn help(link: &Link, settings: &[(&str, String)]) -> String {
    let known = |name: &str| {
        let names = OF_GAZEBO.iter().find(|(surface, _)| *surface == name);
        names.map(|(_, gazebo)| *gazebo)
    };
    let elements = settings.iter().filter_map(|(name, text)| {
        known(name).map(|own| format!("<{own}>{}</{own}>", text.trim()))
    });
    let elements: String = elements.collect();
    if elements.is_empty() {
        return "remove it; URDF parsers silently ignore `surface`, which is SDF".to_owned();
    }
    format!(
        "write <gazebo reference=\"{}\">{elements}</gazebo>; URDF parsers silently ignore `surface`, which is SDF",
        link.shown()
    )
}
