//! xacro tags in a file that calls itself plain URDF.
use super::super::context::FileCx;
use super::super::package::reads_as_it_stands;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::schema;
use super::super::sink::Sink;
use base::TextRange;

pub(in super::super) static RULE: Rule = Rule {
    code: "XML017",
    name: "xacro-tags-in-urdf",
    category: Category::Xml,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("xacro-tags-in-urdf"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    if !cx.is_plain_urdf() {
        return;
    }
    let Some((base, node)) = cx
        .elements()
        .find(|(_, node)| node.name().starts_with("xacro:"))
    else {
        return expressions(cx, out);
    };
    let name = node.name_range().shift(base);
    out.report_in(
        cx.file,
        TextRange::new(name.start - 1, name.end),
        format!("xacro element `{}` in a `.urdf` file", node.name()),
    )
    .severity(if reads_as_it_stands(cx) && has_effect(cx) { Severity::Warning } else { Severity::Info })
    .help(
        "rename the file to `.urdf.xacro` and expand it with xacro; URDF parsers silently ignore the element",
    )
    .done();
}

/// The first attribute of URDF's own elements with an expression in a file without tags of xacro.
fn expressions(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    if !cx
        .source
        .document
        .parts()
        .any(|(_, item)| item.text().contains("${"))
    {
        return;
    }
    let written = cx.elements().find_map(|(base, node)| {
        let attributes = schema::urdf_element(node.name())?.attributes.iter();
        let numbers = attributes.filter(|attribute| attribute.numbers().is_some());
        let mut attrs = numbers.filter_map(|attribute| node.attr(attribute.name));
        let attr = attrs.find(|attr| attr.raw().contains("${"))?;
        Some((base, attr))
    });
    let Some((base, attr)) = written.filter(|_| is_robot(cx)) else {
        return;
    };
    let is_for_xacro = cx.root_attrs().any(|attr| attr.name() == "xmlns:xacro");
    let severity = if !is_for_xacro {
        Severity::Error
    } else if reads_as_it_stands(cx) {
        Severity::Warning
    } else {
        Severity::Info
    };
    out.report_in(
        cx.file,
        attr.value_range().shift(base),
        format!(
            "expression `{}` in a `.urdf` file, which URDF parsers cannot read",
            attr.raw()
        ),
    )
    .severity(severity)
    .help("write the number, or rename the file to `.urdf.xacro` and expand it with xacro")
    .done();
}

/// Whether a file stands on its own: others are for files that include them.
fn is_robot(cx: &FileCx<'_>) -> bool {
    cx.root_attrs().any(|attr| attr.name() == "name")
        && cx.elements().any(|(_, node)| node.name() == "link")
}

/// Whether something is lost when the tags are skipped: properties that no expression reads give nothing.
fn has_effect(cx: &FileCx<'_>) -> bool {
    cx.elements().any(|(_, node)| {
        let is_other = node.name().starts_with("xacro:") && node.name() != "xacro:property";
        is_other || node.attrs().any(|attr| attr.raw().contains("${"))
    })
}
