//! A robot as solids in the world.

use std::sync::Arc;

use nalgebra::Isometry3;

use super::MOST_TRIANGLES;
use super::color::{self, AXES, LINK_LINE_COLOR, MISSING, PLAIN, Rgba};
use super::joints::{LinkTransform, Positions, place, transform};
use super::solids::Solid;
use base::FastMap;
use model::Meshes;
use preview::{BodyModel, Model, ModelFiles, ShapeModel};
use vfs::Vfs;

/// What of a robot is drawn.
#[derive(Clone, Debug, Default)]
pub struct SceneOptions {
    /// Collisions instead of visuals.
    pub collisions: bool,
    /// Frames too, seen through the shapes.
    pub frames: bool,
    /// Positions of joints.
    pub positions: Positions,
}

/// A solid with its color.
#[derive(Clone, Debug)]
pub(super) struct ColoredSolid {
    pub solid: Solid,
    pub color: Rgba,
    /// Whether the colors of its file count.
    pub own: bool,
}

impl ColoredSolid {
    fn new(solid: Solid, color: Rgba) -> Self {
        Self {
            solid,
            color,
            own: false,
        }
    }

    /// Its color where its file gives this one.
    pub fn tinted(&self, tint: Option<Rgba>) -> Rgba {
        let [.., opacity] = self.color;
        match tint.filter(|_| self.own) {
            Some([r, g, b, a]) => [r, g, b, a.min(opacity)],
            None => self.color,
        }
    }

    /// The color that most of it has.
    pub fn main_color(&self) -> Rgba {
        let ends = self.solid.tints.iter().skip(1).map(|(start, _)| *start);
        let runs = self
            .solid
            .tints
            .iter()
            .zip(ends.chain([self.solid.triangles.len()]));
        let longest = runs.max_by_key(|((start, _), end)| end - start);
        longest.map_or(self.color, |((_, tint), _)| self.tinted(*tint))
    }
}

/// The frame of a link.
#[derive(Clone, Debug)]
pub(super) struct LinkFrame {
    pub name: String,
    pub at: Isometry3<f64>,
    /// The link it hangs on, by number, with the name and the type of the joint between.
    pub by: Option<(usize, String, String)>,
}

/// A robot as solids in the world.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Shapes.
    pub(super) parts: Vec<ColoredSolid>,
    /// Axes of frames and lines between them, where they are drawn too.
    pub(super) skeleton: Vec<ColoredSolid>,
    /// All links.
    pub(super) frames: Vec<LinkFrame>,
    /// What could not be drawn, and why.
    pub problems: Vec<String>,
}

/// Opacity of shapes that frames are seen through.
const GLASS: f64 = 0.35;

impl Scene {
    /// Put a robot together.
    ///
    /// # Errors
    /// When it has more triangles than are drawn.
    pub fn of(
        model: &Model,
        files: &ModelFiles,
        vfs: &Vfs,
        content: &SceneOptions,
    ) -> Result<Self, String> {
        let placed = place(model, &content.positions);
        let mut scene = Self::default();
        let mut shapes = Solids {
            files,
            vfs,
            meshes: FastMap::default(),
        };
        let mut triangles = 0;
        for (number, (link, placed)) in model.links.iter().zip(&placed).enumerate() {
            let bodies = if content.collisions {
                &link.collisions
            } else {
                &link.visuals
            };
            for body in bodies {
                let part = scene.part(&link.name, number, body, &mut shapes, placed, content);
                triangles += part.solid.triangles.len();
                if triangles > MOST_TRIANGLES {
                    return Err(format!("robot has more than {MOST_TRIANGLES} triangles"));
                }
                scene.parts.push(part);
            }
            let by = placed.by.and_then(|(parent, joint)| {
                let joint = model.joints.get(joint)?;
                Some((parent, joint.name.clone(), joint.kind.clone()))
            });
            scene.frames.push(LinkFrame {
                name: link.name.clone(),
                at: placed.at,
                by,
            });
        }
        if content.frames || scene.parts.is_empty() {
            scene.skeleton = skeleton(&scene);
        }
        Ok(scene)
    }

    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    fn part(
        &mut self,
        link: &str,
        number: usize,
        body: &BodyModel,
        shapes: &mut Solids<'_>,
        placed: &LinkTransform,
        content: &SceneOptions,
    ) -> ColoredSolid {
        let own = if content.collisions {
            color::collision(number)
        } else {
            body.color.unwrap_or(PLAIN)
        };
        let at = placed.at * transform(&body.pose);
        let (solid, [r, g, b, a]) = match shapes.solid(&body.shape) {
            Ok((solid, scale)) => {
                let mut solid = (*solid).clone();
                solid.place(scale, &at);
                (solid, own)
            }
            Err(problem) => {
                self.problems.push(format!("link `{link}`: {problem}"));
                let mut stand_in = Solid::cuboid([0.1; 3]);
                stand_in.place([1.0; 3], &at);
                (stand_in, MISSING)
            }
        };
        let opacity = if content.frames { a.min(GLASS) } else { a };
        ColoredSolid {
            own: !content.collisions,
            ..ColoredSolid::new(solid, [r, g, b, opacity])
        }
    }

    /// Where everything is that is drawn.
    pub(super) fn points(&self) -> impl Iterator<Item = &[f64; 3]> + Clone {
        self.parts
            .iter()
            .chain(&self.skeleton)
            .flat_map(|part| &part.solid.points)
    }

    /// A length that is easy to see beside the robot, meters.
    pub(super) fn unit(&self) -> f64 {
        let frames = self
            .frames
            .iter()
            .map(|frame| frame.at.translation.vector.into());
        let points = self
            .parts
            .iter()
            .flat_map(|part| part.solid.points.iter().copied());
        let bounds = model::Bounds::around(frames.chain(points));
        let size = bounds.map_or(0.0, model::Bounds::diagonal);
        if size > 1e-6 { size * 0.06 } else { 0.1 }
    }
}

/// Axes of all frames, and lines from each to the one it hangs on.
fn skeleton(scene: &Scene) -> Vec<ColoredSolid> {
    let unit = scene.unit();
    let mut parts = Vec::new();
    for frame in &scene.frames {
        let axes = [[unit, 0.0, 0.0], [0.0, unit, 0.0], [0.0, 0.0, unit]];
        for (axis, color) in axes.into_iter().zip(AXES) {
            let mut solid = Solid::beam(axis, unit * 0.08);
            solid.place([1.0; 3], &frame.at);
            parts.push(ColoredSolid::new(solid, color));
        }
        let parent = frame
            .by
            .as_ref()
            .and_then(|(parent, ..)| scene.frames.get(*parent));
        let Some(parent) = parent else { continue };
        let to = frame
            .at
            .inverse_transform_point(&parent.at.translation.vector.into());
        if to.coords.norm() > unit * 1e-3 {
            let mut solid = Solid::beam(to.coords.into(), unit * 0.05);
            solid.place([1.0; 3], &frame.at);
            parts.push(ColoredSolid::new(solid, LINK_LINE_COLOR));
        }
    }
    parts
}

/// Shapes as solids; each mesh is read once.
struct Solids<'a> {
    files: &'a ModelFiles,
    vfs: &'a Vfs,
    meshes: FastMap<String, Result<Arc<Solid>, String>>,
}

impl Solids<'_> {
    /// A shape and the factors along its axes.
    fn solid(&mut self, shape: &ShapeModel) -> Result<(Arc<Solid>, [f64; 3]), String> {
        let solid = match shape {
            ShapeModel::Box { size } => Solid::cuboid(*size),
            ShapeModel::Cylinder { radius, length } => Solid::cylinder(*radius, *length),
            ShapeModel::Capsule { radius, length } => Solid::capsule(*radius, *length),
            ShapeModel::Sphere { radius } => Solid::sphere(*radius),
            ShapeModel::Unknown { problem } => return Err(problem.clone()),
            ShapeModel::Mesh {
                uri,
                scale,
                mesh,
                problem,
            } => {
                let Some(id) = mesh else {
                    let why = problem.as_deref().unwrap_or("not found");
                    return Err(format!("mesh `{uri}`: {why}"));
                };
                let read = || match self
                    .files
                    .path(id)
                    .map(|path| Meshes::triangles(self.vfs, &path))
                {
                    Some(Ok(triangles)) => Ok(Arc::new(Solid::from(triangles))),
                    Some(Err(defect)) => Err(format!("mesh `{uri}`: {}", defect.message)),
                    None => Err(format!("mesh `{uri}`: not found")),
                };
                let solid = self.meshes.entry(id.clone()).or_insert_with(read).clone()?;
                return Ok((solid, *scale));
            }
        };
        Ok((Arc::new(solid), [1.0; 3]))
    }
}
