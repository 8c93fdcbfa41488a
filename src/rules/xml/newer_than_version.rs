//! An attribute of a newer URDF than the robot is written in.
use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::seen::CheckedElement;
use super::walk;
use model::{AttrValue, Version};

pub(super) static RULE: Rule = Rule {
    code: "XML018",
    name: "newer-than-version",
    category: Category::Xml,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("newer-than-version"),
    check: Check::Element(check),
};

fn check(
    cx: &DocumentCx<'_>,
    &CheckedElement { id, known, .. }: &CheckedElement,
    out: &mut Sink<'_>,
) {
    let tree = &cx.expansion.tree;
    let Some(spec) = known else {
        return;
    };
    let newer = spec
        .attributes
        .iter()
        .filter(|attribute| attribute.since > Version::V1_0);
    let newer = newer.filter(|attribute| {
        tree.attr(id, attribute.name).is_some() && cx.is_older_than(attribute.since)
    });
    for attribute in newer {
        let Some(text) = AttrValue::attr(tree, id, attribute.name) else {
            continue;
        };
        let Some(own) = Version::of(tree) else {
            continue;
        };
        let (name, since) = (attribute.name, attribute.since);
        // a rotation that is lost changes the robot; limits of acceleration are for those who know them
        let is_rotation = name == "quat_xyzw";
        let severity = if is_rotation {
            Severity::Warning
        } else {
            Severity::Info
        };
        let instead = if is_rotation {
            ", or write the rotation as rpy"
        } else {
            ""
        };
        let message = format!(
            "`{name}` of {} requires URDF {since}, but the robot is URDF {own}, so parsers ignore it",
            walk::described(cx, id)
        );
        out.report(text.origin, message)
            .severity(severity)
            .group(Group::Name(format!("{name} of {}", spec.name).into()))
            .help(format!("write version=\"{since}\" in <robot>{instead}"))
            .done();
    }
}
