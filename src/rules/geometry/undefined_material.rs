//! A material that is defined nowhere.
use std::cell::OnceCell;
use std::path::Path;

use ecow::EcoString;

use super::super::context::RobotCx;
use super::super::finding::Help;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::shapes::{holds_colors, is_defined, is_replaceable, mesh_file, visual_materials};
use base::FastSet;
use model::{Body, Link, Material};
use packages::Suggestions;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO026",
    name: "undefined-material",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("undefined-material"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let inline = visual_materials(cx.robot)
        .map(|(_, material)| material)
        .filter(|material| is_defined(material));
    let names = cx
        .robot
        .materials
        .iter()
        .chain(inline)
        .filter_map(|material| material.name.as_ref());
    let defined: Vec<&str> = names.map(|name| name.value.as_str()).collect();
    let known: FastSet<&str> = defined.iter().copied().collect();
    let mut suggestions = Suggestions::default();
    let definitions = OnceCell::new();
    for (link, material) in visual_materials(cx.robot).filter(|(_, material)| !is_defined(material))
    {
        let Some(text) = &material.name else { continue };
        let Some(name) = text.name().filter(|name| !known.contains(name.as_str())) else {
            continue;
        };
        if name.starts_with("Gazebo/") {
            continue;
        }
        let near = suggestions
            .nearest(name, defined.iter().copied())
            .filter(|near| is_replaceable(text, near));
        // one name is misspelled; several that are like no other are defined in a file that is not included
        let group = match near {
            Some(_) => Group::Name(name.clone()),
            None => Group::Thing(definitions.get_or_init(|| place_of_definitions(cx)).clone()),
        };
        let report = out
            .report(
                text.origin,
                format!("undefined material `{name}` in link `{}`", link.shown()),
            )
            .group(group);
        match near {
            Some(near) => {
                let report = report.help(Help::did_you_mean(near));
                report.replace_with(Safety::Unsafe, format!("rename to `{near}`"), near).done();
            }
            None => report.severity(if is_on_colored_mesh(link, material) || is_default(name) || is_on_nothing(link, material) { Severity::Info } else { RULE.severity }).help(format!("add <material name=\"{name}\"><color rgba=\"...\"/></material> to <robot>, or a <color> here: the part is shown in black")).done(),
        }
    }
}

/// Whether a name means the color that a part of an undefined material gets.
///
/// Source: `parseMaterial` and `assignMaterial` of urdfdom keep the material of the visual, whose color is `0 0 0 1` unless it is read.
fn is_default(name: &str) -> bool {
    let mut words = name.split(|c: char| !c.is_alphabetic());
    words.any(|word| word.eq_ignore_ascii_case("black"))
}

/// Whether a material is that of a visual without any shape.
fn is_on_nothing(link: &Link, material: &Material) -> bool {
    let is_its = |body: &&Body| {
        let own = body.material.as_ref();
        own.is_some_and(|own| own.element == material.element)
    };
    let body = link.visuals.iter().find(is_its);
    body.is_some_and(|body| body.shape().is_none())
}

/// Where the materials of a robot would be defined, for all of its package.
fn place_of_definitions(cx: &RobotCx<'_>) -> EcoString {
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    let package = root.and_then(|root| cx.world.packages.containing(root));
    let folder = package
        .as_ref()
        .map(|package| &*package.folder)
        .or_else(|| root?.parent());
    let folder = folder.map(Path::to_string_lossy).unwrap_or_default();
    format!("materials of {folder}").into()
}

/// Whether a material is that of a mesh in a format that holds colors of its own: these are shown without it.
fn is_on_colored_mesh(link: &Link, material: &Material) -> bool {
    let is_its = |body: &&Body| {
        body.material
            .as_ref()
            .is_some_and(|own| own.element == material.element)
    };
    let shapes = link
        .visuals
        .iter()
        .find(is_its)
        .and_then(|body| body.geometry.as_ref());
    let mut files = shapes
        .into_iter()
        .flat_map(|shapes| &shapes.shapes)
        .filter_map(mesh_file);
    files.next().is_some_and(|file| holds_colors(&file.value))
}
