//! What detectors look at, and where they put what they find.
use super::super::consumers::met::Met;
use super::super::context::{DocumentCx, is_plain_urdf};
use super::super::edits::source_text;
use super::bodies::{RigidBody, bodies};
use super::table::construct;
use expand::{Origin, XId};
use model::{AttrValue, Joint, Kinematics, Link, Robot, Version, tag_start};

/// A robot, as detectors see it.
pub(super) struct RobotFacts<'a, 'e> {
    pub(super) cx: &'a DocumentCx<'e>,
    pub(super) robot: &'a Robot,
    pub(super) kinematics: &'a Kinematics,
    pub(super) bodies: Vec<RigidBody>,
    /// Whether consumers read the file itself, and not what xacro makes of it.
    pub(super) is_plain: bool,
    /// The version of URDF; none when it cannot be told.
    pub(super) version: Option<Version>,
}

/// Collects what is found.
#[derive(Default)]
pub(super) struct ConstructCollector {
    pub(super) met: Vec<Met>,
}

/// The thing that has a construct: "joint `elbow`", or "a joint" when it has no name.
#[derive(Clone, Copy)]
pub(super) struct ConstructOwner<'a> {
    pub(super) kind: &'static str,
    pub(super) name: Option<&'a str>,
}

impl ConstructCollector {
    /// The construct `name` is at `origin`.
    pub(super) fn add(&mut self, name: &str, origin: Origin, owner: impl Into<String>) {
        let construct = construct(name);
        debug_assert!(construct.is_some(), "no row {name}");
        self.met.extend(construct.map(|construct| Met {
            construct,
            origin,
            owner: owner.into(),
        }));
    }
}

impl<'a, 'e> RobotFacts<'a, 'e> {
    pub(super) fn of(cx: &'a DocumentCx<'e>, robot: &'a Robot) -> Self {
        let version = Version::of(&cx.expansion.tree);
        let file = cx.expansion.files.first();
        let is_plain = cx.expansion.files.len() == 1
            && file.is_some_and(|file| {
                let root = file.source.document.root();
                is_plain_urdf(&file.source.path)
                    && root.is_some_and(|root| root.attr("xmlns:xacro").is_none())
            });
        let kinematics = robot.kinematics();
        Self {
            cx,
            robot,
            bodies: bodies(robot, kinematics),
            kinematics,
            is_plain,
            version,
        }
    }

    /// The text of a value as consumers see it.
    pub(super) fn seen(&self, text: &AttrValue) -> String {
        // blanks may have been tabs, and what is computed was written otherwise
        if !self.is_plain || text.is_literal() && !text.value.contains([' ', '&', '<', '"']) {
            return text.value.to_string();
        }
        let source = source_text(self.cx.expansion, text.origin);
        // what has references is long to read, and seldom
        let source = source
            .map(|(_, _, source)| source)
            .filter(|source| !source.contains('&'));
        source.unwrap_or_else(|| text.value.to_string())
    }

    /// The start of an element.
    pub(super) fn at(&self, element: XId) -> Origin {
        tag_start(self.cx.expansion, element)
    }

    /// Where a thing is named, or where it begins.
    pub(super) fn at_name(&self, name: Option<&AttrValue>, element: XId) -> Origin {
        name.filter(|name| !name.value.is_empty())
            .map_or_else(|| self.at(element), |name| name.origin)
    }

    /// Whether an element has a child element of a name.
    pub(super) fn has_child(&self, element: XId, name: &'static str) -> bool {
        self.children(element, name).next().is_some()
    }

    /// The child elements of a name.
    pub(super) fn children(
        &self,
        element: XId,
        name: &'static str,
    ) -> impl Iterator<Item = XId> + '_ {
        let tree = &self.cx.expansion.tree;
        tree.elements(element)
            .filter(move |&id| tree.get(id).text == name)
    }
}

impl From<ConstructOwner<'_>> for String {
    fn from(ConstructOwner { kind, name }: ConstructOwner<'_>) -> Self {
        name.map_or_else(|| format!("a {kind}"), |name| format!("{kind} `{name}`"))
    }
}

/// "link `arm`"
pub(super) fn link_owner(link: &Link) -> ConstructOwner<'_> {
    ConstructOwner {
        kind: "link",
        name: Some(link.shown()).filter(|name| !name.is_empty()),
    }
}

/// "joint `elbow`"
pub(super) fn joint_owner(joint: &Joint) -> ConstructOwner<'_> {
    ConstructOwner {
        kind: "joint",
        name: Some(joint.shown()).filter(|name| !name.is_empty()),
    }
}
