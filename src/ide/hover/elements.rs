//! Elements and attributes of URDF, tags of xacro.

use super::super::context::Cx;
use super::super::expressions::ExprText;
use super::super::locate::{LocatedNode, NodePart};
use super::super::schema;
use super::super::values::{distinct, instances};
use super::page::{Page, code};
use base::TextRange;
use expr::{TemplateToken, Value, literal};
use rules::is_semantic_file;
use rules::schema::{AttributeKind, AttributeSpec, ElementSpec, robot, semantic_robot};
use xml::{Attr, Node};

/// What the specification is called.
const SPECIFICATION: &str = "https://wiki.ros.org/urdf/XML";
const SEMANTIC: &str = "https://wiki.ros.org/srdf";
const XACRO: &str = "https://wiki.ros.org/xacro";

/// More about some elements: parent, name, words.
const NOTES: &[(&str, &str, &str)] = &[
    (
        "joint",
        "axis",
        "a unit vector in the joint frame, `1 0 0` by default; ignored for fixed and floating joints",
    ),
    (
        "joint",
        "origin",
        "from the frame of the parent link to the frame of the joint; identity by default",
    ),
    (
        "inertial",
        "origin",
        "from the frame of the link to the frame of the inertia; identity by default",
    ),
    (
        "visual",
        "origin",
        "from the frame of the link to that of the geometry; identity by default",
    ),
    (
        "inertial",
        "inertia",
        "about the center of mass, in the axes of the inertial frame",
    ),
    ("geometry", "box", "centered at the origin"),
    ("geometry", "cylinder", "centered at the origin, along z"),
    (
        "geometry",
        "capsule",
        "centered at the origin, along z; `length` is the length of the cylinder between the half spheres",
    ),
    (
        "joint",
        "limit",
        "required for revolute and prismatic joints",
    ),
];

/// The element or attribute at a place.
pub(super) fn about(cx: &Cx<'_>, at: &LocatedNode<'_>) -> Option<(TextRange, Page)> {
    let node = at.node?;
    match at.part {
        NodePart::StartName => Some((at.shift(node.name_range()), element(cx, at, node)?)),
        NodePart::EndName => Some((at.shift(node.end_name_range()?), element(cx, at, node)?)),
        NodePart::AttrName(attr) => Some((at.shift(attr.name_range()), attribute(cx, node, attr)?)),
        NodePart::AttrValue(attr) => {
            Some((at.shift(attr.value_range()), attribute(cx, node, attr)?))
        }
        _ => None,
    }
}

fn element(cx: &Cx<'_>, at: &LocatedNode<'_>, node: Node<'_>) -> Option<Page> {
    if let Some(tag) = node.name().strip_prefix("xacro:") {
        return xacro_tag(cx, at, node, tag);
    }
    let specs = schema::element_below(root(cx), node);
    let first = *specs.first()?;
    let mut page = Page::titled(format!(
        "**{}** – {}",
        code(&format!("<{}>", first.name)),
        first.docs
    ));
    for spec in specs.iter().skip(1) {
        page.add(format!("in {}: {}", parents(spec), spec.docs));
    }
    let note = NOTES
        .iter()
        .find(|(parent, name, _)| *name == first.name && first.parents.contains(parent));
    page.add(
        note.map(|(_, _, words)| (*words).to_owned())
            .unwrap_or_default(),
    );
    if !first.parents.is_empty() {
        page.add(format!("allowed in {}", parents(first)));
    }
    page.list(
        first
            .attributes
            .iter()
            .map(|attribute| format!("{} – {}", code(attribute.name), facts(attribute))),
    );
    if !first.required.is_empty() {
        let names: Vec<String> = first
            .required
            .iter()
            .map(|name| code(&format!("<{name}>")))
            .collect();
        page.add(format!("must contain {}", names.join(" and ")));
    }
    let page_of = if first.key.starts_with("srdf") {
        SEMANTIC.to_owned()
    } else {
        link(first)
    };
    page.add(format!("[specification]({page_of})"));
    Some(page)
}

fn parents(spec: &ElementSpec) -> String {
    let names: Vec<String> = spec
        .parents
        .iter()
        .map(|parent| {
            code(&format!(
                "<{}>",
                parent.rsplit('/').next().unwrap_or(parent)
            ))
        })
        .collect();
    names.join(", ")
}

fn link(spec: &ElementSpec) -> String {
    const PAGES: &[&str] = &["robot", "link", "joint", "transmission", "gazebo", "sensor"];
    let page = |name: &str| PAGES.iter().find(|page| **page == name).copied();
    let in_link = ["inertial", "visual", "collision", "geometry"];
    let parent = spec.parents.first().map(|parent| {
        if in_link.contains(parent) {
            "link"
        } else {
            parent
        }
    });
    let page = page(spec.name).or_else(|| parent.and_then(page));
    page.map_or_else(
        || SPECIFICATION.to_owned(),
        |page| format!("{SPECIFICATION}/{page}"),
    )
}

/// The root element of the kind of file.
fn root(cx: &Cx<'_>) -> &'static ElementSpec {
    if is_semantic_file(&cx.source.path, &cx.source.document) {
        semantic_robot()
    } else {
        robot()
    }
}

fn attribute(cx: &Cx<'_>, node: Node<'_>, attr: Attr<'_>) -> Option<Page> {
    let specs = schema::element_below(root(cx), node);
    let spec = specs
        .into_iter()
        .find_map(|spec| spec.attribute(attr.name()))?;
    let mut page = Page::titled(format!("**{}** – {}", code(spec.name), spec.docs));
    page.add(facts(spec));
    if spec.name == "rpy" {
        page.add("roll, pitch and yaw about the fixed axes x, y and z, in this order");
    }
    Some(page)
}

/// Type, unit, default, whether it is required.
fn facts(spec: &AttributeSpec) -> String {
    let kind = match spec.kind {
        AttributeKind::Name => "a name".to_owned(),
        AttributeKind::Link => "the name of a link".to_owned(),
        AttributeKind::Joint => "the name of a joint".to_owned(),
        AttributeKind::LinkOrJoint => "the name of a link or a joint".to_owned(),
        AttributeKind::Group => "the name of a planning group".to_owned(),
        AttributeKind::Number => "a number".to_owned(),
        AttributeKind::Vector(count) => format!("{count} numbers"),
        AttributeKind::Choice(words) => words
            .iter()
            .map(|word| code(word))
            .collect::<Vec<_>>()
            .join(", "),
        AttributeKind::Uri => "a path or URI".to_owned(),
        AttributeKind::Text => "text".to_owned(),
    };
    let unit = spec
        .unit
        .map(|unit| format!(" in {unit}"))
        .unwrap_or_default();
    let default = spec
        .default
        .map(|default| format!(", default {}", code(default)))
        .unwrap_or_default();
    let required = if spec.required { ", required" } else { "" };
    format!("{kind}{unit}{default}{required}")
}

fn xacro_tag(cx: &Cx<'_>, at: &LocatedNode<'_>, node: Node<'_>, tag: &str) -> Option<Page> {
    let docs = facts::xacro_tag(tag)?.docs;
    let mut page = Page::titled(format!(
        "**{}** – {docs}",
        code(&format!("<{}>", node.name()))
    ));
    if matches!(tag, "if" | "unless") {
        page.add(condition_line(cx, at, node).unwrap_or_default());
    }
    page.add(format!("[documentation]({XACRO})"));
    Some(page)
}

fn condition_line(cx: &Cx<'_>, at: &LocatedNode<'_>, node: Node<'_>) -> Option<String> {
    let truths = condition(cx, at.base, node)?;
    let wanted = node.name() == "xacro:if";
    match truths.as_slice() {
        [] => None,
        [Some(truth)] if *truth == wanted => Some(format!("now {truth}: the content is included")),
        [Some(truth)] => Some(format!("now {truth}: the content is excluded")),
        [None] => Some("now `?`: the condition is unknown".to_owned()),
        _ => Some("true in some calls, false in others".to_owned()),
    }
}

/// The different truths of a condition over all ways that lead there; none for one that is not known.
pub(in super::super) fn condition(
    cx: &Cx<'_>,
    base: u32,
    node: Node<'_>,
) -> Option<Vec<Option<bool>>> {
    let text = ExprText::of_attr(&cx.source.document, base, node.attr("value")?);
    if text.template.is_verbatim() {
        return Some(vec![literal::boolean(&Value::Str(
            text.text.as_ref().into(),
        ))]);
    }
    let [token @ (TemplateToken::Expr { .. } | TemplateToken::Subst { .. })] =
        text.template.tokens.as_slice()
    else {
        return None;
    };
    if cx.expansion.index.evaluations.is_full() {
        return None;
    }
    let values = instances(cx, text.range(token.range()));
    let values = distinct(values.iter().map(|instance| &instance.value)).into_iter();
    let mut truths: Vec<Option<bool>> = values.map(literal::boolean).collect();
    truths.sort_unstable();
    truths.dedup();
    Some(truths)
}
