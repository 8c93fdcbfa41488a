//! The inertia of a solid body of even density in the shape of a closed mesh.

use std::path::Path;

use ecow::EcoString;
use nalgebra::{Matrix3, Point3, Vector3};

use super::inertia::{body, child, is_at, is_origin_written, place_of_links, shown};
use super::place::{enclosing, indented, last_child, line_end};
use super::{Action, ActionKind, edit};
use crate::Cx;
use base::TextRange;
use model::{Inertial, Link, Mesh, Meshes, Pose, ShapeKind, Surface, Triangles, UpAxis, transform};
use rules::{Edit, FileTarget, RuleEnv, factors, resolve_file};
use xml::Node;

/// Substances offered where no mass is given, and what they weigh, kg/m³.
const SUBSTANCES: [(&str, f64); 3] = [
    ("plastic", 1000.0),
    ("aluminium", 2700.0),
    ("steel", 7850.0),
];

/// Why there is no inertia of the mesh of a link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// What would have been offered.
    pub title: String,
    /// What is in the way.
    pub reason: String,
}

/// A body filled with one kilogram for each cubic meter.
struct SolidProperties {
    /// Cubic meters.
    volume: f64,
    /// Center of mass in the frame of the mesh, meters.
    center: Vector3<f64>,
    /// About the center, in the axes of the mesh, for a density of one.
    inertia: Matrix3<f64>,
}

/// What the inertia of a link with a mesh follows from.
#[derive(PartialEq)]
struct InertiaInput {
    file: EcoString,
    scale: [f64; 3],
    /// Position and angles, where an origin is given.
    pose: Option<[Option<[f64; 3]>; 2]>,
    mass: Option<f64>,
}

impl InertiaInput {
    fn of(link: &Link) -> Option<Self> {
        let body = body(link)?;
        let ShapeKind::Mesh { filename, scale } = &body.shape()?.kind else {
            return None;
        };
        let origin = body.origin.as_ref();
        Some(Self {
            file: filename.as_ref()?.value.clone(),
            scale: factors(scale.as_ref())?,
            pose: origin.map(|origin| [origin.translation(), origin.angles()]),
            mass: link.inertial.as_ref().and_then(Inertial::mass),
        })
    }
}

/// What is asked for: a link with a mesh.
struct InertiaRequest<'a> {
    base: u32,
    node: Node<'a>,
    link: &'a Link,
    origin: Option<&'a Pose>,
    name: String,
    solid: SolidProperties,
}

/// Write the inertia that follows from the mesh of the link at an offset: for the mass that is given, or else for some
/// substances, with the mass.
///
/// # Errors
/// Why there is none, when the link has a mesh.
pub fn of_mesh(cx: &Cx<'_>, world: RuleEnv<'_>, offset: u32) -> Result<Vec<Action>, Refused> {
    let Some(asked) = asked(cx, world, offset)? else {
        return Ok(Vec::new());
    };
    let source = child(asked.node, "inertial");
    let mass = asked
        .link
        .inertial
        .as_ref()
        .and_then(Inertial::mass)
        .filter(|mass| *mass > 0.0);
    let name = &asked.name;
    let Some(source) = source else {
        let brings_one = |node: Node<'_>| node.name().starts_with("xacro:");
        if asked.link.inertial.is_some() || asked.node.child_elements().any(brings_one) {
            return Ok(Vec::new());
        }
        let offered = SUBSTANCES.iter().filter_map(|(substance, density)| {
            let title = format!(
                "compute mass and inertia from mesh `{name}` for {substance} ({density} kg/m³)"
            );
            Some(Action {
                title,
                kind: ActionKind::Rewrite,
                edits: vec![asked.inertial(cx, *density)?],
            })
        });
        return Ok(offered.collect());
    };
    let Some(mass) = mass else {
        return Ok(Vec::new());
    };
    let density = mass / asked.solid.volume;
    let title = format!(
        "compute inertia from mesh `{name}` ({} m³, {} kg/m³)",
        shown(asked.solid.volume),
        density.round()
    );
    let edits = asked.entries(cx, source, density);
    Ok(edits
        .map(|edits| Action {
            title,
            kind: ActionKind::Rewrite,
            edits,
        })
        .into_iter()
        .collect())
}

/// The link at an offset, when its shape is a mesh; the numbers are to be the same from call to call.
fn asked<'a>(
    cx: &Cx<'a>,
    world: RuleEnv<'_>,
    offset: u32,
) -> Result<Option<InertiaRequest<'a>>, Refused> {
    let Some((base, node)) = enclosing(&cx.source.document, offset, "link") else {
        return Ok(None);
    };
    let mut links = place_of_links(cx, node.range().shift(base));
    let Some(link) = links.next() else {
        return Ok(None);
    };
    let Some(first) = InertiaInput::of(link) else {
        return Ok(None);
    };
    if !links.all(|other| InertiaInput::of(other).as_ref() == Some(&first)) {
        return Ok(None);
    }
    let Some(body) = body(link) else {
        return Ok(None);
    };
    let Some(ShapeKind::Mesh {
        filename: Some(file),
        ..
    }) = body.shape().map(|shape| &shape.kind)
    else {
        return Ok(None);
    };
    let name = file
        .value
        .rsplit(['/', '\\'])
        .next()
        .unwrap_or_default()
        .to_owned();
    let FileTarget::File(path) = resolve_file(cx.expansion, world, file) else {
        return Ok(None);
    };
    let solid = solid(world, &path, first.scale).map_err(|reason| Refused {
        title: format!("compute inertia from mesh `{name}`"),
        reason: format!("mesh `{name}` {reason}"),
    })?;
    let body_node = node
        .child_elements()
        .find(|child| is_at(cx, body.element, child.range().shift(base)));
    let written = body_node.is_some_and(|node| is_origin_written(node, body.origin.as_ref()));
    let origin = body.origin.as_ref();
    Ok(written.then_some(InertiaRequest {
        base,
        node,
        link,
        origin,
        name,
        solid,
    }))
}

/// The mesh as a solid body.
fn solid(world: RuleEnv<'_>, path: &Path, scale: [f64; 3]) -> Result<SolidProperties, String> {
    let mesh: &Mesh = &world.meshes.get(world.vfs, path);
    let unread = || {
        let defect = mesh
            .defect
            .as_ref()
            .map_or("", |defect| defect.message.as_str());
        format!("cannot be read: {defect}")
    };
    let surface: &Surface = mesh.surface.as_ref().ok_or_else(unread)?;
    if !surface.edges.closed {
        let open = surface.edges.boundary;
        return Err(match open {
            0 => "is not closed: its normals are inconsistent".to_owned(),
            _ => format!("is not closed: it has {open} open edges"),
        });
    }
    if matches!(mesh.up_axis, Some(UpAxis::X | UpAxis::Y)) {
        return Err("has an up axis other than z, which not all programs apply".to_owned());
    }
    let triangles = Meshes::triangles(world.vfs, path)
        .map_err(|defect| format!("cannot be read: {}", defect.message))?;
    integrate(&triangles, scale).ok_or_else(|| "encloses no volume".to_owned())
}

/// Sum over the pyramids that the triangles make with one corner of the mesh.
fn integrate(mesh: &Triangles, scale: [f64; 3]) -> Option<SolidProperties> {
    // numbers stay small around a point of the mesh
    let near = scaled(mesh, 0, scale);
    let (mut volume, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
    for corners in &mesh.corners {
        let [a, b, c] = corners.map(|index| scaled(mesh, index, scale) - near);
        let (six, sum) = (a.dot(&b.cross(&c)), a + b + c);
        volume += six / 6.0;
        first += sum * (six / 24.0);
        let squares =
            a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose();
        second += squares * (six / 120.0);
    }
    let center = first / volume;
    let second = (second - center * center.transpose() * volume) * volume.signum();
    let inertia = Matrix3::identity() * second.trace() - second;
    let sound = volume.abs() > 1e-15 && inertia.iter().all(|entry| entry.is_finite());
    (sound && inertia.diagonal().min() > 0.0).then(|| SolidProperties {
        volume: volume.abs(),
        center: center + near,
        inertia,
    })
}

/// A point of the mesh in the size that it has in the robot.
fn scaled(mesh: &Triangles, index: u32, scale: [f64; 3]) -> Vector3<f64> {
    let point = mesh.points.get(index as usize).copied().unwrap_or_default();
    Vector3::from(point).component_mul(&Vector3::from(scale))
}

impl InertiaRequest<'_> {
    /// The element `origin`: the center of mass, in the axes of the mesh.
    fn origin(&self) -> Option<String> {
        let at = transform(self.origin)? * Point3::from(self.solid.center);
        let angles = self.origin.map_or(Some([0.0; 3]), Pose::angles)?;
        let [x, y, z] = [at.x, at.y, at.z].map(small);
        let [roll, pitch, yaw] = angles.map(|angle| format!("{angle}"));
        Some(format!(
            "<origin xyz=\"{x} {y} {z}\" rpy=\"{roll} {pitch} {yaw}\"/>"
        ))
    }

    /// The element `inertia` for a density, kg/m³.
    fn inertia(&self, density: f64) -> String {
        let it = self.solid.inertia * density;
        let largest = it.m11.max(it.m22).max(it.m33);
        // what is left of sums that cancel out is nothing
        let [ixy, ixz, iyz] = [it.m12, it.m13, it.m23].map(|entry| {
            if entry.abs() < largest * 1e-9 {
                "0".to_owned()
            } else {
                shown(entry)
            }
        });
        let (ixx, iyy, izz) = (shown(it.m11), shown(it.m22), shown(it.m33));
        format!(
            "<inertia ixx=\"{ixx}\" ixy=\"{ixy}\" ixz=\"{ixz}\" iyy=\"{iyy}\" iyz=\"{iyz}\" izz=\"{izz}\"/>"
        )
    }

    /// A whole `inertial` as the last child of the link.
    fn inertial(&self, cx: &Cx<'_>, density: f64) -> Option<Edit> {
        let end = line_end(&cx.source.document);
        let mass = shown(self.solid.volume * density);
        let text = format!(
            "<inertial>{end}{}{end}<mass value=\"{mass}\"/>{end}{}{end}</inertial>",
            self.origin()?,
            self.inertia(density)
        );
        let (range, text) = last_child(cx.source, self.base, self.node, &text);
        let text = indented(&cx.source.document, range, &text)?;
        Some(edit(cx.source, range, text))
    }

    /// The entries of the `inertial` that is there.
    fn entries(&self, cx: &Cx<'_>, inertial: Node<'_>, density: f64) -> Option<Vec<Edit>> {
        Some(vec![
            self.entry(cx, inertial, "origin", self.origin()?),
            self.entry(cx, inertial, "inertia", self.inertia(density)),
        ])
    }

    /// An element of the `inertial` that is there, in the place of the one with its name; the origin stands first.
    fn entry(&self, cx: &Cx<'_>, inertial: Node<'_>, name: &str, text: String) -> Edit {
        let (range, text) = match child(inertial, name) {
            Some(old) => (old.range().shift(self.base), text),
            None if name == "origin" => {
                let first = inertial
                    .child_elements()
                    .next()
                    .map_or(0, |first| first.range().start)
                    + self.base;
                let margin = super::place::margin(&cx.source.document, first);
                (
                    TextRange::empty(first),
                    format!("{text}{}{margin}", line_end(&cx.source.document)),
                )
            }
            None => last_child(cx.source, self.base, inertial, &text),
        };
        edit(cx.source, range, text)
    }
}

/// A length, meters; less than a nanometer is nothing.
fn small(length: f64) -> String {
    if length.abs() < 1e-9 {
        "0".to_owned()
    } else {
        shown(length)
    }
}

#[cfg(test)]
mod tests {
    use super::integrate;
    use model::Triangles;

    /// A box of 1, 2 and 3 m whose corner is the origin.
    fn cuboid() -> Triangles {
        let points = (0..8).map(|i| {
            [
                f64::from(i & 1),
                f64::from(i >> 1 & 1) * 2.0,
                f64::from(i >> 2) * 3.0,
            ]
        });
        let sides = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let corners = sides
            .into_iter()
            .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
        Triangles {
            points: points.collect(),
            corners: corners.collect(),
            tints: Vec::new(),
        }
    }

    #[test]
    fn a_mesh_of_a_box_weighs_as_the_box() {
        for (scale, turned) in [
            ([1.0, 1.0, 1.0], false),
            ([1.0, 1.0, -1.0], false),
            ([1.0, 1.0, 1.0], true),
        ] {
            let mut mesh = cuboid();
            if turned {
                mesh.corners
                    .iter_mut()
                    .for_each(|triangle| triangle.reverse());
            }
            let solid = integrate(&mesh, scale).unwrap();
            let density = 12.0 / solid.volume;
            let it = solid.inertia * density;
            for (got, expected) in [
                (solid.volume, 6.0),
                (solid.center.z, 1.5 * scale[2]),
                (it.m11, 13.0),
                (it.m22, 10.0),
                (it.m33, 5.0),
                (it.m12, 0.0),
            ] {
                assert!((got - expected).abs() < 1e-9, "{got} for {expected}");
            }
        }
    }
}
