//! An element without an attribute that parsers insist on.
use super::super::context::DocumentCx;
use super::super::edits::source_text;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::schema::ElementSpec;
use super::super::sink::Sink;
use super::seen::CheckedElement;
use super::{meant, walk};
use expand::{XId, XTree};
use model::{AttrValue, element_range, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "XML008",
    name: "missing-attribute",
    category: Category::Xml,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("missing-attribute"),
    check: Check::Element(check),
};

fn check(
    cx: &DocumentCx<'_>,
    &CheckedElement { id, known, .. }: &CheckedElement,
    out: &mut Sink<'_>,
) {
    if id == cx.element {
        check_controls(cx, out);
    }
    // the name of the robot has a rule of its own
    let Some(spec) = known.filter(|spec| spec.name != "robot") else {
        return;
    };
    let missing = missing(cx, id, spec);
    if missing.is_empty() || walk::may_get_more(cx, id) {
        return;
    }
    let plural = if missing.len() == 1 {
        "attribute"
    } else {
        "attributes"
    };
    let message = format!(
        "missing {plural} `{1}` in {0}",
        walk::described(cx, id),
        missing.join("`, `")
    );
    if let (["value"], Some(text)) = (missing.as_slice(), number_inside(cx, id)) {
        report_inside(cx, id, (spec.name, "value", message), &text, out);
        return;
    }
    let add: Vec<String> = missing
        .iter()
        .map(|name| format!("{name}=\"...\""))
        .collect();
    let severity = if is_second_material(cx, id, spec) {
        Severity::Info
    } else {
        RULE.severity
    };
    out.report(tag_start(cx.expansion, id), message)
        .severity(severity)
        .help(format!("add {}", add.join(" ")))
        .done();
}

/// What ros2_control stops at: joints, sensors, groups of inputs and outputs, and interfaces without a name.
fn check_controls(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    const PARTS: [&str; 3] = ["joint", "sensor", "gpio"];
    const INTERFACES: [&str; 2] = ["command_interface", "state_interface"];
    let tree = &cx.expansion.tree;
    for control in cx.robot.into_iter().flat_map(|robot| &robot.controls) {
        if control.name.is_none() {
            let message = "missing attribute `name` in `ros2_control`".to_owned();
            let help = "add name=\"...\"; ros2_control rejects the robot without it";
            out.report(tag_start(cx.expansion, control.element), message)
                .help(help)
                .done();
        }
        for part in tree.elements(control.element) {
            let inner = tree
                .elements(part)
                .filter(|&id| is_nameless(tree, id, &INTERFACES));
            for id in inner.chain(Some(part).filter(|&part| is_nameless(tree, part, &PARTS))) {
                let message = format!("missing attribute `name` in {}", walk::described(cx, id));
                let kind = tree.get(id).text.as_str();
                let is_word = |text: &AttrValue| {
                    tree.elements(id).next().is_none() && !text.value.trim().contains(' ')
                };
                match AttrValue::content(tree, id).filter(is_word) {
                    Some(text) => report_inside(cx, id, (kind, "name", message), &text, out),
                    None => out
                        .report(tag_start(cx.expansion, id), message)
                        .help("add name=\"...\"; ros2_control rejects the robot without it")
                        .done(),
                }
            }
        }
    }
}

/// Whether an element of one of these kinds has no name.
fn is_nameless(tree: &XTree, id: XId, kinds: &[&str]) -> bool {
    kinds.contains(&tree.get(id).text.as_str()) && tree.attr(id, "name").is_none()
}

/// The required attributes that are absent and not misspelled either.
fn missing(cx: &DocumentCx<'_>, id: XId, spec: &ElementSpec) -> Vec<&'static str> {
    let tree = &cx.expansion.tree;
    if spec
        .attributes
        .iter()
        .all(|attribute| !attribute.required || tree.attr(id, attribute.name).is_some())
    {
        return Vec::new();
    }
    let absent = walk::absent(cx, id, spec);
    let misspelled = meant::attributes(cx, id, spec);
    absent
        .into_iter()
        .filter(|name| spec.requires(name) && !misspelled.contains(name))
        .collect()
}

/// Whether an element is an empty `material` behind another one, which parsers do not look at.
fn is_second_material(cx: &DocumentCx<'_>, id: XId, spec: &ElementSpec) -> bool {
    let tree = &cx.expansion.tree;
    if spec.name != "material"
        || !tree.get(id).attrs.is_empty()
        || tree.elements(id).next().is_some()
    {
        return false;
    }
    let around = tree.parent(id);
    around.is_some_and(|around| {
        let mut materials = tree
            .elements(around)
            .filter(|&child| tree.get(child).text == "material");
        tree.get(around).text == "visual" && materials.next() != Some(id)
    })
}

/// The text of an element that holds nothing but a number.
fn number_inside(cx: &DocumentCx<'_>, id: XId) -> Option<AttrValue> {
    let is_alone = cx.expansion.tree.elements(id).next().is_none();
    AttrValue::content(&cx.expansion.tree, id).filter(|text| is_alone && text.number().is_some())
}

/// The value stands between the tags.
fn report_inside(
    cx: &DocumentCx<'_>,
    id: XId,
    (name, attribute, message): (&str, &str, String),
    text: &AttrValue,
    out: &mut Sink<'_>,
) {
    let content =
        source_text(cx.expansion, text.origin).map_or_else(String::new, |(_, _, source)| source);
    let element = format!("<{name} {attribute}=\"{}\"/>", content.trim());
    let report = out
        .report(tag_start(cx.expansion, id), message)
        .help(format!("write {element}"));
    let is_plain = cx.expansion.tree.get(id).attrs.is_empty() && !content.contains(['"', '<']);
    match source_text(cx.expansion, element_range(cx.expansion, id)).filter(|_| is_plain) {
        Some((file, range, _)) => {
            report
                .fix(
                    Safety::Unsafe,
                    format!("replace with `{element}`"),
                    file,
                    [(range, element)],
                )
                .done();
        }
        None => report.done(),
    }
}
