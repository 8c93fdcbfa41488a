//! A material that nobody can see.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::shapes::{color, holds_colors, is_replaceable, materials, mesh_file};
use model::{Body, Material, Robot};

pub(super) static RULE: Rule = Rule {
    code: "GEO039",
    name: "invisible-material",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("invisible-material"),
    check: Check::Document(check),
};

/// Words in the names of materials that are meant to be invisible.
const MEANT: [&str; 9] = [
    "clear", "dummy", "empty", "glass", "hidden", "invis", "none", "trans", "vis",
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot else { return };
    for material in materials(cx) {
        let Some([red, green, blue, 0.0]) = color(material) else {
            continue;
        };
        let (Some(text), Some(name)) = (&material.rgba, &material.name) else {
            continue;
        };
        let small = name.value.to_lowercase();
        let is_meant = small.trim().is_empty() || MEANT.iter().any(|word| small.contains(word));
        if is_meant || material.texture.is_some() || !is_drawn(robot, material, &name.value) {
            continue;
        }
        let message = format!("material `{}` is invisible: its alpha is 0", name.value);
        let report = out
            .report(text.origin, message)
            .help("write an alpha of 1 for an opaque color");
        let content = format!("{red} {green} {blue} 1");
        if is_replaceable(text, &content) {
            let title = "make the color opaque";
            report.replace_with(Safety::Unsafe, title, &content).done();
        } else {
            report.done();
        }
    }
}

/// Whether a part is drawn in a material: its shape has no colors of its own.
fn is_drawn(robot: &Robot, material: &Material, name: &str) -> bool {
    let has_it = |body: &&Body| {
        let own = body.material.as_deref();
        own.is_some_and(|own| {
            std::ptr::eq(own, material)
                || own.color.is_none() && own.name.as_ref().is_some_and(|own| own.value == name)
        })
    };
    let bodies = robot.links.iter().flat_map(|link| &link.visuals);
    let mut shapes = bodies.filter(has_it).filter_map(|body| body.shape());
    shapes.any(|shape| mesh_file(shape).is_none_or(|file| !holds_colors(&file.value)))
}
