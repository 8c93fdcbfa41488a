//! A gazebo element about nothing.
use std::cell::LazyCell;

use super::super::context::RobotCx;
use super::super::edits::rename;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use base::FastSet;
use expand::{SymbolKind, XId};
use facts::{Fact, FactKind, facts};
use memchr::memmem::Finder;
use model::{AttrValue, Gazebo};
use packages::nearest;
use xml::{Node, NodeKind};

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
        let near = nearest(name, names);
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
                let is_left_over =
                    changes_nothing(cx, block) && has_own(cx, near) || is_commented_out(cx, name);
                let severity = if is_left_over { Severity::Info } else { RULE.severity };
                let report =
                    report.severity(severity).help(Help::did_you_mean(near).and("SDFormat ignores an element with an unknown reference"));
                rename(report, cx.expansion, text, near).done();
            }
            None => report
                .severity(severity(cx, block, name))
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
fn severity(cx: &RobotCx<'_>, block: &Gazebo, name: &str) -> Severity {
    if is_joined(cx, name) {
        return Severity::Warning;
    }
    let is_meant = holds_device(cx, block) || shares_word(cx, name);
    if is_meant
        && !changes_nothing(cx, block)
        && !sets_only_self_collision(cx, block)
        && !is_written(cx, name)
        && !is_commented_out(cx, name)
    {
        Severity::Warning
    } else {
        Severity::Info
    }
}

/// Whether a joint of the robot has a parent or child of that name: the link was taken away.
fn is_joined(cx: &RobotCx<'_>, name: &str) -> bool {
    let joints = cx.robot.joints.iter();
    let mut ends = joints
        .flat_map(|joint| [&joint.parent, &joint.child])
        .flatten();
    ends.any(|end| end.value == name)
}

/// Whether an element holds a sensor or a plugin.
fn holds_device(cx: &RobotCx<'_>, block: &Gazebo) -> bool {
    let tree = &cx.expansion.tree;
    tree.elements(block.element)
        .any(|child| ["sensor", "plugin"].contains(&tree.get(child).text.as_str()))
}

/// Whether a link or joint shares a word with a name, one that says which part is meant.
fn shares_word(cx: &RobotCx<'_>, name: &str) -> bool {
    let own = words(name);
    let links = cx.robot.links.iter().map(|link| link.shown());
    let mut names = links.chain(cx.robot.joints.iter().map(|joint| joint.shown()));
    names.any(|other| words(other).iter().any(|word| own.contains(word)))
}

/// The words of a name that say which part is meant.
fn words(name: &str) -> Vec<String> {
    const OF_ALL: [&str; 4] = ["link", "joint", "frame", "base"];
    const LEAST_LETTERS: usize = 3;
    let words = name
        .split(|c: char| !c.is_alphabetic())
        .map(str::to_lowercase);
    words
        .filter(|word| word.len() >= LEAST_LETTERS && !OF_ALL.contains(&word.as_str()))
        .collect()
}

/// Whether a text that the robot is made of names a link or joint so, in a branch that is not taken this time.
fn is_written(cx: &RobotCx<'_>, name: &str) -> bool {
    let is_it =
        |fact: &Fact| matches!(fact.kind, FactKind::Link | FactKind::Joint) && fact.name == name;
    let mut files = cx.expansion.files.iter();
    files.any(|file| facts(&file.source.document).any(|(_, facts)| facts.named.iter().any(is_it)))
}

/// Whether a comment in these texts holds a link or joint of that name: it was taken out on purpose, and what is left over
/// does nothing.
fn is_commented_out(cx: &RobotCx<'_>, name: &str) -> bool {
    let quoted = |quote: char| format!("{quote}{name}{quote}");
    let tags = ["<link name=", "<joint name="].into_iter();
    let tags = tags.flat_map(|tag| ['"', '\''].map(|quote| format!("{tag}{}", quoted(quote))));
    let tags: Vec<Finder<'_>> = tags.map(|tag| Finder::new(&tag).into_owned()).collect();
    let holds = |text: &str| tags.iter().any(|tag| tag.find(text.as_bytes()).is_some());
    let is_comment = |node: &Node<'_>| node.kind() == NodeKind::Comment;
    let mut items = cx
        .expansion
        .files
        .iter()
        .flat_map(|file| file.source.document.parts());
    items.any(|(_, item)| {
        let mut comments = item.all_nodes().filter(is_comment);
        holds(item.text()) && comments.any(|comment| holds(comment.raw()))
    })
}

/// Whether there is an element about a link or joint of that name.
fn has_own(cx: &RobotCx<'_>, name: &str) -> bool {
    let mut named = cx
        .robot
        .gazebo
        .iter()
        .filter_map(|block| block.reference.as_ref());
    named.any(|text| text.value == name)
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
    let keeps_gravity = |child: XId, name: &str| {
        let usual = match name {
            "gravity" => ["true", "1"],
            "turnGravityOff" => ["false", "0"],
            _ => return false,
        };
        AttrValue::content(tree, child).is_some_and(|text| usual.contains(&text.value.trim()))
    };
    tree.elements(block.element).all(|child| {
        let name = tree.get(child).text.as_str();
        IDLE.contains(&name) || keeps_gravity(child, name)
    })
}
