//! A gazebo element about nothing.
use std::cell::LazyCell;

use super::super::context::RobotCx;
use super::super::edits::rename;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::FastSet;
use ecow::EcoString;
use expand::{SymbolKind, XId};
use facts::{Fact, FactKind, facts};
use model::{AttrValue, Gazebo};
use packages::Suggestions;
use xml::{Document, NodeKind};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL014",
    name: "gazebo-unknown-reference",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("gazebo-unknown-reference"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let joints = || cx.robot.joints.iter().map(|joint| joint.shown());
    let joints: LazyCell<FastSet<&str>, _> = LazyCell::new(|| joints().collect());
    let around = LazyCell::new(|| Around::of(cx));
    let mut suggestions = Suggestions::default();
    for block in &cx.robot.gazebo {
        let Some(text) = &block.reference else {
            continue;
        };
        let Some(name) = text.name() else { continue };
        let is_known = cx.kinematics.link(name).is_some() || joints.contains(name.as_str());
        // where the `$` is missing, that is said
        if is_known || lacks_dollar(cx, name) {
            continue;
        }
        let links = cx.robot.links.iter().map(|link| link.shown());
        let names = links.chain(cx.robot.joints.iter().map(|joint| joint.shown()));
        let near = suggestions.nearest(name, names);
        // what resembles no name is left over from one robot: one finding for a file
        let group = if near.is_some() {
            Group::Name(name.clone())
        } else {
            Group::File
        };
        let report = out
            .report(text.origin, format!("unknown link or joint `{name}`"))
            .group(group);
        match near {
            Some(near) => {
                // the part that the name resembles has its color
                let is_left_over = changes_nothing(cx, block)
                    && (around.referred_to.contains(near) || !has_color(cx, block))
                        || around.commented_out.contains(name.as_str());
                let severity = if is_left_over { Severity::Info } else { RULE.severity };
                let report =
                    report.severity(severity).help(Help::did_you_mean(near).and("SDFormat ignores an element with an unknown reference"));
                rename(report, cx.expansion, text, near).done();
            }
            None => report
                .severity(severity(cx, block, name, &around))
                .help("use the name of a link or joint of this robot; SDFormat ignores an element with an unknown reference")
                .done(),
        }
    }
}

/// Whether a name holds the one of a property or parameter in braces without `$`.
fn lacks_dollar(cx: &RobotCx<'_>, name: &str) -> bool {
    let inside = name
        .split_once('{')
        .and_then(|(_, rest)| rest.split_once('}'));
    let mut definitions = cx.expansion.index.symbols.definitions.iter();
    inside.is_some_and(|(inside, _)| {
        definitions.any(|one| {
            matches!(one.kind, SymbolKind::Property | SymbolKind::Parameter) && one.name == inside
        })
    })
}

/// Without a similar name, what is said of a link that the robot does not have is mostly left over from another robot, and
/// nothing is lost. Not so sensors and plugins, names that share a word with those of the robot, and links between joints.
fn severity(cx: &RobotCx<'_>, block: &Gazebo, name: &str, around: &Around<'_>) -> Severity {
    if around.joined.contains(name) {
        return Severity::Warning;
    }
    let is_meant = holds_device(cx, block) || words(name).any(|word| around.words.contains(&word));
    if is_meant
        && !changes_nothing(cx, block)
        && !sets_only_self_collision(cx, block)
        && !around.written.contains(name)
        && !around.commented_out.contains(name)
    {
        Severity::Warning
    } else {
        Severity::Info
    }
}

/// Whether an element holds a sensor or a plugin.
fn holds_device(cx: &RobotCx<'_>, block: &Gazebo) -> bool {
    let tree = &cx.expansion.tree;
    tree.elements(block.element)
        .any(|child| ["sensor", "plugin"].contains(&tree.get(child).text.as_str()))
}

/// The words of a name that say which part is meant.
fn words(name: &str) -> impl Iterator<Item = String> + '_ {
    const OF_ALL: [&str; 4] = ["link", "joint", "frame", "base"];
    const LEAST_LETTERS: usize = 3;
    let words = name
        .split(|c: char| !c.is_alphabetic())
        .map(str::to_lowercase);
    words.filter(|word| word.len() >= LEAST_LETTERS && !OF_ALL.contains(&word.as_str()))
}

/// What the robot and its texts say of names, looked for once: as many may be unknown as there are links.
struct Around<'a> {
    /// Parents and children of joints: where there is no such link, it was taken away.
    joined: FastSet<&'a str>,
    /// Words of the names of links and joints that say which part is meant.
    words: FastSet<String>,
    /// What `gazebo` elements are about.
    referred_to: FastSet<&'a str>,
    /// Links and joints that the texts define, in a branch that is not taken this time.
    written: FastSet<EcoString>,
    /// Links and joints in comments: they were taken out on purpose, and what is left over does nothing.
    commented_out: FastSet<&'a str>,
}

impl<'a> Around<'a> {
    fn of(cx: &RobotCx<'a>) -> Self {
        let (links, joints) = (&cx.robot.links, &cx.robot.joints);
        let ends = joints
            .iter()
            .flat_map(|joint| [&joint.parent, &joint.child]);
        let names = links.iter().map(|link| link.shown());
        let names = names.chain(joints.iter().map(|joint| joint.shown()));
        let references = cx
            .robot
            .gazebo
            .iter()
            .filter_map(|block| block.reference.as_ref());
        let documents = || cx.expansion.files.iter().map(|file| &file.source.document);
        let is_part = |fact: &&Fact| matches!(fact.kind, FactKind::Link | FactKind::Joint);
        let mut written = FastSet::default();
        for (_, facts) in documents().flat_map(facts) {
            let parts = facts.named.iter().filter(is_part);
            written.extend(parts.map(|fact| fact.name.clone()));
        }
        Self {
            joined: ends.flatten().map(|end| end.value.as_str()).collect(),
            words: names.flat_map(words).collect(),
            referred_to: references.map(|text| text.value.as_str()).collect(),
            written,
            commented_out: documents().flat_map(commented_out).collect(),
        }
    }
}

/// The names of links and joints in comments.
fn commented_out(document: &Document) -> impl Iterator<Item = &str> {
    let nodes = document.parts().flat_map(|(_, item)| item.all_nodes());
    let comments = nodes.filter(|node| node.kind() == NodeKind::Comment);
    comments.flat_map(|comment| {
        ["<link name=", "<joint name="]
            .into_iter()
            .flat_map(move |tag| {
                let behind = comment.raw().split(tag).skip(1);
                behind.filter_map(|rest| {
                    let quote = rest.chars().next().filter(|c| ['"', '\''].contains(c))?;
                    rest.get(1..)?.split_once(quote).map(|(name, _)| name)
                })
            })
    })
}

/// Whether an element sets whether a link collides with its own robot, and nothing else: which link that is says the name alone.
fn sets_only_self_collision(cx: &RobotCx<'_>, block: &Gazebo) -> bool {
    let tree = &cx.expansion.tree;
    let mut children = tree.elements(block.element);
    children.all(|child| ["selfCollide", "self_collide"].contains(&tree.get(child).text.as_str()))
}

/// Whether an element gives a color or keeps a fixed joint or the gravity, and nothing else: without it, nothing behaves
/// differently.
fn changes_nothing(cx: &RobotCx<'_>, block: &Gazebo) -> bool {
    const IDLE: [&str; 3] = ["disableFixedJointLumping", "material", "preserveFixedJoint"];
    let tree = &cx.expansion.tree;
    let is_usual = |child: XId, name: &str| {
        let usual = match name {
            "gravity" => ["true", "1"],
            "turnGravityOff" | "selfCollide" | "self_collide" => ["false", "0"],
            _ => return false,
        };
        AttrValue::content(tree, child).is_some_and(|text| usual.contains(&text.value.trim()))
    };
    tree.elements(block.element).all(|child| {
        let name = tree.get(child).text.as_str();
        IDLE.contains(&name) || is_usual(child, name)
    })
}

/// Whether an element gives its part a color.
fn has_color(cx: &RobotCx<'_>, block: &Gazebo) -> bool {
    let tree = &cx.expansion.tree;
    let mut children = tree.elements(block.element);
    children.any(|child| {
        tree.get(child).text == "material"
            && AttrValue::content(tree, child).is_some_and(|text| !text.value.trim().is_empty())
    })
}
