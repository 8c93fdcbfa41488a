//! A material with two colors.
use ecow::EcoString;

use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::{color, is_defined, visual_materials};
use base::FastMap;
use model::Material;

pub(super) static RULE: Rule = Rule {
    code: "GEO028",
    name: "material-redefinition",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("material-redefinition"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot else { return };
    let mut first: FastMap<&str, &Material> = FastMap::default();
    for material in robot
        .materials
        .iter()
        .filter(|material| is_defined(material))
    {
        if let Some(name) = material.name.as_ref().and_then(|name| name.name()) {
            first.entry(name).or_insert(material);
        }
    }
    for (link, material) in visual_materials(robot).filter(|(_, material)| is_defined(material)) {
        let Some(text) = &material.name else { continue };
        let Some(name) = text.name() else { continue };
        let earlier = *first.entry(name).or_insert(material);
        let Some(earlier_name) = earlier.name.as_ref().filter(|_| differ(earlier, material)) else {
            continue;
        };
        let message = format!(
            "link `{}` redefines material `{name}` with another color",
            link.shown()
        );
        out.report(text.origin, message)
            .also(earlier_name.origin, "this color is used everywhere")
            .help("use another material name for the other color")
            .done();
    }
}

/// Whether two materials are known to look different.
fn differ(a: &Material, b: &Material) -> bool {
    color(a).zip(color(b)).is_some_and(|(a, b)| a != b)
        || texture(a).zip(texture(b)).is_some_and(|(a, b)| a != b)
}

/// The name of the texture of a material, when it is known.
fn texture(material: &Material) -> Option<&EcoString> {
    material.texture_file.as_ref()?.name()
}
