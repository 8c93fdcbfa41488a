//! The bodies and materials of a robot.
use super::super::context::DocumentCx;
use expand::{XId, XKind, XTree};
use model::{AttrValue, Body, Link, Material, Robot, Shape, ShapeKind};

/// The visuals and collisions of a link, and whether it is a collision.
pub(super) fn bodies(link: &Link) -> impl Iterator<Item = (&Body, bool)> {
    let visuals = link.visuals.iter().map(|body| (body, false));
    visuals.chain(link.collisions.iter().map(|body| (body, true)))
}

/// Whether what should be in an element `inside` a visual or collision is in a comment there: somebody took it out, and nothing is
/// lost with it. urdfdom keeps the link without this body and all that it would have read after it: further visuals, and
/// then collisions.
pub(in super::super) fn is_taken_out(tree: &XTree, body: XId, inside: XId) -> bool {
    let is_meant = |child: XId| {
        tree.get(child).kind == XKind::Comment && is_about_geometry(&tree.get(child).text)
    };
    tree.children(inside).any(is_meant) && is_read_last(tree, body)
}

/// Whether a comment holds an element, or says something of the geometry, in most languages by this word.
fn is_about_geometry(comment: &str) -> bool {
    comment.contains('<') || comment.to_lowercase().contains("geom")
}

/// Whether urdfdom reads a visual or collision of its link last, so that nothing else is lost with it.
pub(in super::super) fn is_read_last(tree: &XTree, body: XId) -> bool {
    let Some(link) = tree.parent(body) else {
        return false;
    };
    last_child(tree, link, "collision").or_else(|| last_child(tree, link, "visual")) == Some(body)
}

/// The last child element of a name.
fn last_child(tree: &XTree, element: XId, name: &str) -> Option<XId> {
    tree.elements(element)
        .filter(|&child| tree.get(child).text == name)
        .last()
}

/// The materials inside visuals, with their link.
pub(in super::super) fn visual_materials(
    robot: &Robot,
) -> impl Iterator<Item = (&Link, &Material)> {
    let visuals = robot
        .links
        .iter()
        .flat_map(|link| link.visuals.iter().map(move |body| (link, body)));
    visuals.filter_map(|(link, body)| Some((link, body.material.as_deref()?)))
}

/// The materials of the robot and of its visuals.
pub(super) fn materials<'a>(cx: &'a DocumentCx<'_>) -> impl Iterator<Item = &'a Material> {
    cx.robot.into_iter().flat_map(|robot| {
        robot
            .materials
            .iter()
            .chain(visual_materials(robot).map(|(_, material)| material))
    })
}

/// Whether a material says how it looks.
pub(in super::super) fn is_defined(material: &Material) -> bool {
    material.color.is_some() || material.texture.is_some()
}

/// Red, green, blue and opacity of a material, when they are four numbers.
pub(in super::super) fn color(material: &Material) -> Option<[f64; 4]> {
    material.rgba.as_ref()?.numbers()
}

/// The file of a mesh.
pub(super) fn mesh_file(shape: &Shape) -> Option<&AttrValue> {
    match &shape.kind {
        ShapeKind::Mesh { filename, .. } => filename.as_ref(),
        _ => None,
    }
}

/// The names of all meshes and textures.
pub(super) fn resource_names<'a>(cx: &'a DocumentCx<'_>) -> Vec<&'a AttrValue> {
    let links = cx.robot.into_iter().flat_map(|robot| &robot.links);
    let geometries = links.flat_map(bodies).flat_map(|(body, _)| &body.geometry);
    let shapes = geometries.flat_map(|geometry| &geometry.shapes);
    shapes
        .filter_map(mesh_file)
        .chain(materials(cx).filter_map(|material| material.texture_file.as_ref()))
        .collect()
}

/// Whether a value may be replaced by `content`: the source spells it, and neither needs entities.
pub(in super::super) fn is_replaceable(text: &AttrValue, content: &str) -> bool {
    text.is_literal() && is_plain(&text.value) && is_plain(content)
}

fn is_plain(text: &str) -> bool {
    !text.contains(['&', '<', '"', '\'', '$'])
}

/// Whether a mesh file has a format that holds colors.
pub(super) fn holds_colors(file: &str) -> bool {
    const FORMATS: [&str; 4] = [".dae", ".glb", ".gltf", ".obj"];
    let name = file.trim().to_lowercase();
    FORMATS.iter().any(|ending| name.ends_with(ending))
}
