//! Materials of the robot and of visuals.
use super::super::geometry::{FileTarget, resolve_file};
use super::facts::{Facts, Found, link_owner};
use base::FastMap;
use model::{Material, Text};

/// Red, green, blue and opacity.
type Color = [f64; 4];

pub(super) fn find(facts: &Facts<'_, '_>, out: &mut Found) {
    let mut colors: FastMap<&str, Option<Color>> = FastMap::default();
    for material in &facts.robot.materials {
        let owner = owner(material);
        let mut add = |row: &str| out.add(row, facts.at(material.element), owner.as_str());
        match material.name.as_ref().map(|name| name.value.as_str()) {
            None => add("material-of-robot-without-name"),
            Some(name) => {
                if colors.insert(name, color(material)).is_some() {
                    add("material-of-robot-defined-twice");
                }
                if material.color.is_none() && material.texture.is_none() {
                    add("material-of-robot-without-color");
                }
            }
        }
        look(facts, material, &owner, out);
    }
    let defined = |material: &&Material| material.color.is_some() || material.texture.is_some();
    let bodies = || {
        facts
            .robot
            .links
            .iter()
            .flat_map(|link| link.visuals.iter().map(move |body| (link, body)))
    };
    for (link, body) in bodies() {
        let Some(material) = body.material.as_deref() else {
            continue;
        };
        let owner = link_owner(link);
        let mut add = |row: &str| out.add(row, facts.at(material.element), owner.as_str());
        let Some(name) = &material.name else {
            add("material-without-name");
            continue;
        };
        let rgba = color(material);
        if name.value.is_empty() {
            look(facts, material, &owner, out);
            continue;
        }
        match (colors.get(name.value.as_str()), defined(&material)) {
            (None, false) if name.is_known() => {
                let elsewhere = bodies()
                    .filter_map(|(_, body)| body.material.as_deref())
                    .filter(defined);
                if !elsewhere.into_iter().any(|other| {
                    other
                        .name
                        .as_ref()
                        .is_some_and(|own| own.value == name.value)
                }) {
                    add("material-undefined");
                }
            }
            (Some(known), true) if rgba.is_some() && known.is_some() && rgba != *known => {
                add("material-redefined")
            }
            (None, true) => {
                colors.insert(name.value.as_str(), rgba);
            }
            _ => {}
        }
        look(facts, material, &owner, out);
    }
}

/// The color of a material, when it is four numbers.
fn color(material: &Material) -> Option<Color> {
    material.rgba.as_ref()?.numbers()
}

fn owner(material: &Material) -> String {
    material.name.as_ref().map_or_else(
        || "a material".to_owned(),
        |name| format!("material `{}`", name.value),
    )
}

/// What a material says of its color and texture.
fn look(facts: &Facts<'_, '_>, material: &Material, owner: &str, out: &mut Found) {
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

fn is_missing(target: &FileTarget, file: &Text) -> bool {
    match target {
        FileTarget::Missing(..) | FileTarget::NoFile(_) | FileTarget::OtherCase(_) => true,
        FileTarget::Unknown => file.is_known() && file.value.starts_with("package://"),
        FileTarget::Malformed | FileTarget::File(_) => false,
    }
}
