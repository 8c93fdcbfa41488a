//! How large visuals and collisions are, in the frame of their link.
use super::super::context::{DocumentCx, RootKind, RuleEnv};
use super::resources::factors;
use expand::Expansion;
use model::{AttrValue, Body, Bounds, Link, Mesh, Robot, Shape, ShapeKind, UpAxis, transform};

/// What is known about the space that bodies take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// There are no bodies.
    Nothing,
    /// One of them is not known.
    Unknown,
    /// The box around all of them, meters.
    Known(Bounds),
}

impl Extent {
    /// The box, when it is known.
    pub fn bounds(self) -> Option<Bounds> {
        match self {
            Extent::Known(bounds) => Some(bounds),
            Extent::Nothing | Extent::Unknown => None,
        }
    }
}

/// The box around what a link looks like, in its frame; around its collisions when it looks like nothing. None when
/// a part of it is not known.
pub fn link_bounds(
    expansion: &Expansion,
    robot: &Robot,
    world: RuleEnv<'_>,
    link: &Link,
) -> Option<Bounds> {
    let bodies = if link.visuals.is_empty() {
        &link.collisions
    } else {
        &link.visuals
    };
    extent_of(&shapes_of(expansion, robot, world), bodies).bounds()
}

/// A robot, to ask for boxes of its bodies.
pub(in super::super) fn shapes_of<'a>(
    expansion: &'a Expansion,
    robot: &'a Robot,
    world: RuleEnv<'a>,
) -> DocumentCx<'a> {
    DocumentCx::new(
        expansion,
        robot.element,
        (RootKind::Robot, false),
        Some(robot),
        world,
        false,
    )
}

/// The box of the collisions of a link, or of its visuals when it has no collision.
pub fn extent(cx: &DocumentCx<'_>, link: &Link) -> Extent {
    if link.collisions.is_empty() {
        extent_of(cx, &link.visuals)
    } else {
        extent_of(cx, &link.collisions)
    }
}

/// The box around bodies.
pub fn extent_of(cx: &DocumentCx<'_>, bodies: &[Body]) -> Extent {
    let mut extent = Extent::Nothing;
    for body in bodies {
        let Some(bounds) = bounds(cx, body) else {
            return Extent::Unknown;
        };
        extent = Extent::Known(extent.bounds().map_or(bounds, |others| others.with(bounds)));
    }
    extent
}

/// The box of a body in the frame of its link.
pub(super) fn bounds(cx: &DocumentCx<'_>, body: &Body) -> Option<Bounds> {
    let place = transform(body.origin.as_ref())?;
    Some(shape_bounds(cx, body.shape()?)?.moved(&place))
}

/// The box of a shape in its own frame.
pub(super) fn shape_bounds(cx: &DocumentCx<'_>, shape: &Shape) -> Option<Bounds> {
    Some(match &shape.kind {
        ShapeKind::Box { size } => Bounds::centered(size.as_ref()?.numbers()?),
        ShapeKind::Cylinder { radius, length } => {
            let width = number(radius)? * 2.0;
            Bounds::centered([width, width, number(length)?])
        }
        ShapeKind::Capsule { radius, length } => {
            let width = number(radius)? * 2.0;
            Bounds::centered([width, width, number(length)? + width])
        }
        ShapeKind::Sphere { radius } => Bounds::centered([number(radius)? * 2.0; 3]),
        ShapeKind::Mesh { scale, .. } => {
            mesh_bounds(cx.mesh(shape)?)?.scaled(factors(scale.as_ref())?)
        }
        ShapeKind::Other => return None,
    })
}

fn number(text: &Option<AttrValue>) -> Option<f64> {
    text.as_ref()?.number()
}

/// The box of a mesh before scaling. Some programs turn a mesh whose up axis is not z, others do not: then the
/// box holds both.
fn mesh_bounds(mesh: &Mesh) -> Option<Bounds> {
    let bounds = mesh.surface?.bounds;
    let corners = [bounds.min, bounds.max];
    let turned = match mesh.up_axis {
        Some(UpAxis::Y) => corners.map(|[x, y, z]| [x, -z, y]),
        Some(UpAxis::X) => corners.map(|[x, y, z]| [-y, x, z]),
        Some(UpAxis::Z) | None => return Some(bounds),
    };
    Some(Bounds::around(turned).map_or(bounds, |turned| bounds.with(turned)))
}

/// The volume of the collisions of a link, or of its visuals when it has no collision, in cubic meters; none
/// when one of them is not known or encloses none.
pub fn volume(cx: &DocumentCx<'_>, link: &Link) -> Option<f64> {
    let bodies = if link.collisions.is_empty() {
        &link.visuals
    } else {
        &link.collisions
    };
    let volumes = bodies.iter().map(|body| shape_volume(cx, body.shape()?));
    volumes
        .sum::<Option<f64>>()
        .filter(|volume| volume.is_finite())
}

fn shape_volume(cx: &DocumentCx<'_>, shape: &Shape) -> Option<f64> {
    use std::f64::consts::PI;
    Some(match &shape.kind {
        ShapeKind::Box { size } => size.as_ref()?.numbers::<3>()?.into_iter().product(),
        ShapeKind::Cylinder { radius, length } => PI * number(radius)?.powi(2) * number(length)?,
        ShapeKind::Capsule { radius, length } => {
            let radius = number(radius)?;
            PI * radius.powi(2) * (number(length)? + 4.0 / 3.0 * radius)
        }
        ShapeKind::Sphere { radius } => 4.0 / 3.0 * PI * number(radius)?.powi(3),
        ShapeKind::Mesh { scale, .. } => {
            let surface = cx
                .mesh(shape)?
                .surface
                .filter(|surface| surface.edges.closed)?;
            let factors = factors(scale.as_ref())?;
            (surface.volume * factors.into_iter().product::<f64>()).abs()
        }
        ShapeKind::Other => return None,
    })
}
