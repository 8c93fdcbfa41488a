//! A sensor or plugin on a link that becomes part of its parent.
use std::cell::LazyCell;

use super::super::context::RobotCx;
use super::super::edits::{indent, is_called, source_text};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::{Reported, Sink};
use base::{FastSet, TextRange};
use expand::{XId, XTree};
use model::{AttrValue, Gazebo, Joint, JointType, element_range};

pub(super) static RULE: Rule = Rule {
    code: "CTL015",
    name: "gazebo-lumped-reference",
    category: Category::Control,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("gazebo-lumped-reference"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    // there may be as many of these elements as links
    let kept = LazyCell::new(|| Kept::of(cx));
    for block in cx
        .robot
        .gazebo
        .iter()
        .filter(|block| has_content(tree, block.element))
    {
        let Some((text, name)) = block
            .reference
            .as_ref()
            .and_then(|text| Some((text, text.name()?)))
        else {
            continue;
        };
        let up = cx
            .kinematics
            .link(name)
            .and_then(|link| cx.kinematics.parent_joints(link).first().copied());
        let Some(joint) = up.and_then(|joint| cx.robot.joints.get(joint)) else {
            continue;
        };
        let held = joint.ends().is_some_and(|(parent, _)| parent != "world");
        if !held || !joint.is(&[JointType::Fixed]) || kept.has(joint) {
            continue;
        }
        let message = format!(
            "link `{name}` is merged into its parent because joint `{}` is fixed",
            joint.shown()
        );
        let report = out
            .report(text.origin, message)
            .help("add <preserveFixedJoint>true</preserveFixedJoint>, or refer to the parent link");
        keeping(report, cx, block, joint).done();
    }
}

/// Whether a block says more than a few parameters of contact.
fn has_content(tree: &XTree, block: XId) -> bool {
    tree.elements(block)
        .any(|id| ["sensor", "plugin", "visual"].contains(&tree.get(id).text.as_str()))
}

/// The joints that `gazebo` elements keep from being reduced.
#[derive(Default)]
struct Kept<'a> {
    /// Whether an element without a reference keeps all of them.
    all: bool,
    names: FastSet<&'a str>,
}

impl<'a> Kept<'a> {
    fn of(cx: &RobotCx<'a>) -> Self {
        let tree = &cx.expansion.tree;
        let keeps = |id: XId| {
            let name = tree.get(id).text.as_str();
            ["preserveFixedJoint", "disableFixedJointLumping"].contains(&name)
                && AttrValue::content(tree, id)
                    .is_some_and(|text| text.value == "true" || text.value == "1")
        };
        let mut kept = Self::default();
        let blocks = cx.robot.gazebo.iter();
        for block in blocks.filter(|block| tree.elements(block.element).any(keeps)) {
            match &block.reference {
                Some(text) => {
                    kept.names.insert(&text.value);
                }
                None => kept.all = true,
            }
        }
        kept
    }

    fn has(&self, joint: &Joint) -> bool {
        self.all || self.names.contains(joint.shown())
    }
}

/// With the fix to keep the joint.
fn keeping<'s, 'a>(
    report: Reported<'s, 'a>,
    cx: &RobotCx<'_>,
    block: &Gazebo,
    joint: &Joint,
) -> Reported<'s, 'a> {
    let at = element_range(cx.expansion, block.element);
    if is_called(cx.expansion, at) {
        return report;
    }
    let Some((file, range, _)) = source_text(cx.expansion, at) else {
        return report;
    };
    let line = indent(cx.expansion, file, range);
    let name = joint.shown();
    let new = format!(
        "{line}<gazebo reference=\"{name}\">{line}  <preserveFixedJoint>true</preserveFixedJoint>{line}</gazebo>"
    );
    report.fix(
        Safety::Unsafe,
        format!("add `preserveFixedJoint` for joint `{name}`"),
        file,
        [(TextRange::empty(range.end), new)],
    )
}
