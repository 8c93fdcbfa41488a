//! The names of links, joints and interfaces that texts spell out, whatever an expansion makes of them.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::super::includes::reach;
use super::super::root_analysis::RootAnalysis;
use super::super::session::Session;
use super::files::Beside;
use super::robots::is_robot;
use base::FastSet;
use project::{ProjectNameKind, Srdf};
use rules::{JointConnection, OfferedInterface, RobotNames, is_semantic_name};
use xml::Node;

/// Descriptions that a robot may include.
const MOST_FILES: usize = 200;

/// Robots that are asked whether they have all names of an SRDF.
const MOST_ROBOTS: usize = 20;

/// What the prefix of a name stands for: `${prefix}joint7`.
#[derive(Clone, Copy)]
pub(super) enum Prefixes<'a> {
    /// Nobody knows.
    Kept,
    /// Nothing, in files that a robot does not read: these may be those of another one.
    Of(&'a RootAnalysis),
    /// Nothing.
    Empty,
}

impl Prefixes<'_> {
    /// Whether names in a file count without their prefix.
    fn are_others(self, file: &Path) -> bool {
        match self {
            Self::Kept => false,
            Self::Of(robot) => !robot.includes(file),
            Self::Empty => true,
        }
    }
}

/// Add the names of the robots that launch files or programs load and that have all names of an SRDF: it may be for these,
/// whatever its name says.
pub(super) fn add_robots_with(
    session: &Session,
    srdf: &Srdf,
    own: &Beside,
    paired: &[Arc<RootAnalysis>],
    names: &mut RobotNames,
) {
    let all = session.callers.descriptions(&own.path);
    let is_other = |file: &&PathBuf| {
        !paired.iter().any(|known| known.root.file == **file)
            && is_robot(session, file)
            && session.callers.load(file)
    };
    let mentioned: FastSet<(ProjectNameKind, &str)> = srdf
        .names()
        .into_iter()
        .filter(|(_, kind, is_given)| *kind != ProjectNameKind::Group && !is_given)
        .filter_map(|(name, kind, _)| Some((kind, name.name()?.as_str())))
        .collect();
    for file in all.iter().filter(is_other).take(MOST_ROBOTS) {
        let mut spelled = RobotNames::default();
        add_spelled(session, file, Prefixes::Empty, &mut spelled);
        let has = |&(kind, name): &(ProjectNameKind, &str)| match kind {
            ProjectNameKind::Link => spelled.links.contains(name),
            _ => spelled.joints.contains(name),
        };
        if mentioned.iter().all(has) {
            names.extend(&spelled);
        }
    }
}

/// Whether a tag includes a file of a package that is absent.
fn is_absent(session: &Session, include: Node<'_>, from: &Path) -> bool {
    let name = include.attr("filename").map(|name| name.raw().to_owned());
    let package = name.as_ref().and_then(|name| {
        let (_, after) = name.split_once("$(find ")?;
        Some(after.split_once(')')?.0.trim())
    });
    package.is_some_and(|package| {
        !package.contains('$') && session.packages.find(package, from).is_err()
    })
}

/// Add the names that the texts of a file and of those that it may include spell out, in branches and macros that take
/// no part too.
pub(super) fn add_spelled(
    session: &Session,
    root: &Path,
    prefixes: Prefixes<'_>,
    names: &mut RobotNames,
) {
    let mut files = vec![root.to_owned()];
    let mut next = 0;
    while let Some(source) = files.get(next).map(|file| session.vfs.document(file)) {
        next += 1;
        let Ok(source) = source else { continue };
        let has_others = prefixes.are_others(&source.path);
        let nodes = source
            .document
            .parts()
            .flat_map(|(_, item)| item.all_nodes());
        for node in nodes {
            if ["xacro:if", "xacro:unless"].contains(&node.name()) {
                add_interfaces(node, names);
            }
            // what a robot that is whole includes is there: this is for other arguments
            if node.name() == "xacro:include" {
                names.is_open |= is_absent(session, node, &source.path);
            }
            let list = match node.name() {
                "link" if !is_semantic_name(root) => &mut names.links,
                // not those of ros2_control or a transmission
                "joint" if node.child_elements().any(|inner| inner.name() == "child") => {
                    &mut names.joints
                }
                "group" if node.child_elements().next().is_some() => &mut names.groups,
                _ => continue,
            };
            let unprefixed = || without_prefix(node, "name").filter(|_| has_others);
            let Some(name) = spelled(node, "name").or_else(unprefixed) else {
                continue;
            };
            list.insert(name);
            if let Some(place) = place_of(node).filter(|_| node.name() == "joint") {
                names.places.insert(place);
            }
        }
        for file in reach(&source, &session.packages).reached(&session.vfs) {
            if files.len() < MOST_FILES && !files.contains(&file) {
                files.push(file);
            }
        }
    }
}

/// The value of an attribute that the text spells out.
fn spelled(node: Node<'_>, attribute: &str) -> Option<EcoString> {
    let value = node.attr(attribute)?.raw();
    (!value.contains('$')).then(|| value.into())
}

/// The value of an attribute behind a single property at its start: `joint7` of `${prefix}joint7`.
fn without_prefix(node: Node<'_>, attribute: &str) -> Option<EcoString> {
    let value = node.attr(attribute)?.raw();
    let (property, rest) = value.strip_prefix("${")?.split_once('}')?;
    let is_name = property.chars().all(|c| c.is_alphanumeric() || c == '_');
    (is_name && !rest.is_empty() && !rest.contains('$')).then(|| rest.into())
}

/// The place of a joint, as far as the text spells it out.
fn place_of(joint: Node<'_>) -> Option<JointConnection> {
    let child = joint
        .child_elements()
        .find(|inner| inner.name() == "child")?;
    Some(JointConnection {
        joint: spelled(joint, "name")?,
        child: spelled(child, "link")?,
        kind: spelled(joint, "type")?,
    })
}

/// Add the interfaces of hardware that a condition decides on.
fn add_interfaces(condition: Node<'_>, names: &mut RobotNames) {
    for inner in condition.child_elements() {
        match inner.name() {
            tag @ ("command_interface" | "state_interface") => {
                let offered = inner.attr("name").map(|name| OfferedInterface {
                    is_command: tag == "command_interface",
                    joint: joint_around(inner),
                    name: name.raw().into(),
                });
                names.interfaces.extend(offered);
            }
            // those are visited by themselves
            "xacro:if" | "xacro:unless" => {}
            _ => add_interfaces(inner, names),
        }
    }
}

/// The name of the joint that an interface is in, as the text spells it.
fn joint_around(interface: Node<'_>) -> Option<EcoString> {
    let outer = std::iter::successors(interface.parent(), |node| node.parent());
    let joint = outer.into_iter().find(|node| node.name() == "joint")?;
    Some(joint.attr("name")?.raw().into())
}
