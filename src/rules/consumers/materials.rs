//! Materials of the robot and of visuals.
use super::super::geometry::{FileTarget, color, is_defined, resolve_file, visual_materials};
use super::facts::{ConstructCollector, ConstructOwner, RobotFacts, link_owner};
use base::FastMap;
use model::{AttrValue, Material};

/// Red, green, blue and opacity.
type ColorChannels = [f64; 4];

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let mut colors: FastMap<&str, Option<ColorChannels>> = FastMap::default();
    for material in &facts.robot.materials {
        let owner = owner(material);
        let at = facts.at(material.element);
        match material.name.as_ref().map(|name| name.value.as_str()) {
            None => out.add("material-of-robot-without-name", at, owner),
            Some(name) => {
                if colors.insert(name, color(material)).is_some() {
                    out.add("material-of-robot-defined-twice", at, owner);
                }
                if !is_defined(material) {
                    out.add("material-of-robot-without-color", at, owner);
                }
            }
        }
        look(facts, material, owner, out);
    }
    for (link, material) in visual_materials(facts.robot) {
        let (at, owner) = (facts.at(material.element), link_owner(link));
        let Some(name) = &material.name else {
            out.add("material-without-name", at, owner);
            continue;
        };
        let rgba = color(material);
        if name.value.is_empty() {
            look(facts, material, owner, out);
            continue;
        }
        match (colors.get(name.value.as_str()), is_defined(material)) {
            (None, false) if name.is_known() && !is_defined_elsewhere(facts, name) => {
                out.add("material-undefined", at, owner);
            }
            (Some(known), true) if rgba.is_some() && known.is_some() && rgba != *known => {
                out.add("material-redefined", at, owner);
            }
            (None, true) => {
                colors.insert(name.value.as_str(), rgba);
            }
            _ => {}
        }
        look(facts, material, owner, out);
    }
}

/// Whether a visual defines a material.
fn is_defined_elsewhere(facts: &RobotFacts<'_, '_>, name: &AttrValue) -> bool {
    let mut materials = visual_materials(facts.robot)
        .map(|(_, material)| material)
        .filter(|material| is_defined(material));
    materials.any(|material| {
        material
            .name
            .as_ref()
            .is_some_and(|own| own.value == name.value)
    })
}

fn owner(material: &Material) -> ConstructOwner<'_> {
    ConstructOwner {
        kind: "material",
        name: material.name.as_ref().map(|name| name.value.as_str()),
    }
}

/// What a material says of its color and texture.
fn look(
    facts: &RobotFacts<'_, '_>,
    material: &Material,
    owner: ConstructOwner<'_>,
    out: &mut ConstructCollector,
) {
    let tree = &facts.cx.expansion.tree;
    if let Some(color) = material
        .color
        .filter(|&color| tree.attr(color, "rgba").is_none())
    {
        let row = if tree.attr(color, "rgb").is_some() {
            "color-with-rgb"
        } else {
            "color-without-rgba"
        };
        out.add(row, facts.at(color), owner);
    }
    let Some(texture) = material.texture else {
        return;
    };
    match &material.texture_file {
        None => out.add("texture-without-filename", facts.at(texture), owner),
        Some(file) => {
            let target = resolve_file(facts.cx.expansion, facts.cx.world, file);
            if is_missing(&target, file) {
                out.add("texture-missing", file.origin, owner);
            }
        }
    }
}

fn is_missing(target: &FileTarget, file: &AttrValue) -> bool {
    match target {
        FileTarget::Missing(..) | FileTarget::NoFile(_) | FileTarget::OtherCase(_) => true,
        FileTarget::Unknown => file.is_known() && file.value.starts_with("package://"),
        FileTarget::Malformed | FileTarget::File(_) => false,
    }
}
