//! A shape that URDF does not know.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::{bodies, holds_colors, mesh_file};
use expand::XId;
use model::{AttrValue, Body, Link, ShapeKind, Version, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO016",
    name: "unknown-geometry-type",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unknown-geometry-type"),
    check: Check::Link(check),
};

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    for (body, is_collision) in bodies(link) {
        let shapes = body.geometry.iter().flat_map(|geometry| &geometry.shapes);
        let mut is_first = true;
        for shape in shapes {
            // urdfdom takes the first element, whatever follows
            let is_passed_over = !std::mem::replace(&mut is_first, false);
            let name = cx.expansion.tree.get(shape.element).text.as_str();
            let extension = name.contains(':')
                || cx
                    .world
                    .config
                    .allow_elements
                    .iter()
                    .any(|known| known == name);
            let is_unknown = match shape.kind {
                ShapeKind::Other => true,
                ShapeKind::Capsule { .. } => cx.is_older_than(Version::V1_1),
                _ => false,
            };
            if !is_unknown || extension {
                continue;
            }
            let is_of_simulators = matches!(name, "capsule" | "ellipsoid" | "plane");
            let help = match name {
                "capsule" => {
                    "write version=\"1.1\" in <robot>, which needs urdfdom 5.1, or use a cylinder and two spheres"
                }
                "ellipsoid" => {
                    "use a sphere or a mesh; only Drake, MuJoCo and SDF support ellipsoids"
                }
                "plane" => "use a flat box; only MuJoCo, Bullet and SDF support planes",
                "material" | "origin" => "move it out of <geometry>",
                _ => "use <box>, <cylinder>, <sphere> or <mesh> (or <capsule> since URDF 1.1)",
            };
            let version = if name == "capsule" { " 1.0" } else { "" };
            let message = format!(
                "`{name}` in link `{}` is not a shape of URDF{version}",
                link.shown()
            );
            // outside of a package, it is for the programs that take the shape
            let root = cx.expansion.files.first().map(|file| &*file.source.path);
            let in_package = root.is_some_and(|root| cx.world.packages.containing(root).is_some());
            let is_meant = is_of_simulators && !in_package;
            let is_idle = is_meant
                || is_passed_over && is_idle(cx, shape.element, is_collision || is_colored(body));
            let severity = match (is_idle, is_passed_over) {
                (true, _) => Severity::Info,
                (false, true) => Severity::Warning,
                (false, false) => RULE.severity,
            };
            out.report(tag_start(cx.expansion, shape.element), message)
                .severity(severity)
                .help(help)
                .done();
        }
    }
}

/// Whether the first shape of a body is a mesh in a format that holds colors of its own.
fn is_colored(body: &Body) -> bool {
    body.shape()
        .and_then(mesh_file)
        .is_some_and(|file| holds_colors(&file.value))
}

/// Whether an element beside the shape would do nothing in its right place either: a pose that moves nothing, or the color of a
/// body that nothing shows, or that has its own.
fn is_idle(cx: &DocumentCx<'_>, element: XId, needs_no_color: bool) -> bool {
    let tree = &cx.expansion.tree;
    let mut vectors = ["xyz", "rpy"]
        .into_iter()
        .filter_map(|name| AttrValue::attr(tree, element, name));
    match tree.get(element).text.as_str() {
        "material" => needs_no_color,
        "origin" => vectors.all(|text| text.numbers() == Some([0.0; 3])),
        _ => false,
    }
}
