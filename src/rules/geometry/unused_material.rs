//! A material that nothing uses.
use std::cell::LazyCell;

use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::shapes::visual_materials;
use base::FastSet;
use expand::FileIdx;
use model::element_range;
use xml::Node;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO029",
    name: "unused-material",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("unused-material"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let used: FastSet<&str> = visual_materials(cx.robot)
        .filter_map(|(_, material)| Some(material.name.as_ref()?.value.as_str()))
        .collect();
    let mentioned = LazyCell::new(|| mentioned(cx));
    for material in &cx.robot.materials {
        let Some(text) = &material.name else { continue };
        let Some(name) = text.name().filter(|name| !used.contains(name.as_str())) else {
            continue;
        };
        // files of materials are shared; what a condition left out may need the material
        let place = cx.expansion.place(text.origin);
        if place.is_none_or(|place| place.file != FileIdx(0)) || mentioned.contains(name.as_str()) {
            continue;
        }
        let whole = element_range(cx.expansion, material.element);
        let report = out
            .report(text.origin, format!("unused material `{name}`"))
            .help("remove the material");
        match cx.expansion.place(whole) {
            Some(place) => {
                report
                    .fix(
                        Safety::Unsafe,
                        format!("remove material `{name}`"),
                        place.file,
                        [(place.range, String::new())],
                    )
                    .done();
            }
            None => report.done(),
        }
    }
}

/// The values of attributes in the sources, but for those of the definitions of materials themselves.
fn mentioned<'a>(cx: &RobotCx<'a>) -> FastSet<&'a str> {
    let items = cx
        .expansion
        .files
        .iter()
        .flat_map(|file| file.source.document.parts());
    let nodes = items.flat_map(|(_, item)| item.all_nodes());
    let others = nodes.filter(|&node| !is_definition(node));
    others
        .flat_map(|node| node.attrs())
        .map(|attr| attr.raw())
        .collect()
}

fn is_definition(node: Node<'_>) -> bool {
    node.name() == "material" && node.child_elements().next().is_some()
}
