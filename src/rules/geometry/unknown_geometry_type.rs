//! A shape that URDF does not know.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::shapes::bodies;
use model::{ShapeKind, Version, tag_start};

pub(super) const RULE: Rule = Rule {
    code: "GEO016",
    name: "unknown-geometry-type",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unknown-geometry-type"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, body, _) in bodies(cx) {
        let shapes = body.geometry.iter().flat_map(|geometry| &geometry.shapes);
        let mut is_first = true;
        for shape in shapes {
            // urdfdom takes the first element, whatever follows
            let is_passed_over = !std::mem::replace(&mut is_first, false);
            let name = cx.expansion.tree.get(shape.element).text.as_str();
            let extension =
                name.contains(':') || cx.world.config.allow_elements.iter().any(|known| known == name);
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
                    "urdfdom reads capsules from 5.1 on, when the robot says version=\"1.1\"; Drake, MuJoCo and Bullet take them"
                }
                "ellipsoid" => "urdfdom refuses it; Drake, MuJoCo and Gazebo's SDF take ellipsoids",
                "plane" => "urdfdom refuses it; MuJoCo, Bullet and Gazebo's SDF take planes",
                "material" | "origin" => "move it out of `geometry`",
                _ => "URDF has box, cylinder, sphere and mesh; capsule from version 1.1 on",
            };
            let version = if name == "capsule" { " 1.0" } else { "" };
            let message = format!("link `{}`: `{name}` is no shape of URDF{version}", link.shown());
            // outside of a package, it is for the programs that take the shape
            let root = cx.expansion.files.first().map(|file| &*file.source.path);
            let in_package = root.is_some_and(|root| cx.world.packages.containing(root).is_some());
            let is_meant = is_of_simulators && !in_package;
            out.report(tag_start(cx.expansion, shape.element), message)
                .severity(if is_meant || is_passed_over { Severity::Warning } else { RULE.severity })
                .help(help)
                .done();
        }
    }
}
