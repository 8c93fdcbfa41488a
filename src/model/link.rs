//! What a link is made of: inertia, visuals and collisions, geometry, materials.

use std::any::Any;
use std::sync::{Arc, OnceLock};

use super::attr_value::AttrValue;
use super::pose::Pose;
use super::source::first_children;
use base::Cache;
use expand::{XId, XTree};

/// A `link` of the robot.
#[derive(Clone, Debug)]
pub struct Link {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// Its first `inertial`.
    pub inertial: Option<Inertial>,
    /// Its `visual`s in document order.
    pub visuals: Vec<Body>,
    /// Its `collision`s in document order.
    pub collisions: Vec<Body>,
}

/// An `inertial`: mass in kg, inertia about the center of mass in kg m^2.
#[derive(Clone, Debug)]
pub struct Inertial {
    /// Its element.
    pub element: XId,
    /// The frame of the inertia; its translation is the center of mass.
    pub origin: Option<Pose>,
    /// The element `mass`.
    pub mass_element: Option<XId>,
    /// The `value` of `mass`, kg.
    pub mass: Option<AttrValue>,
    /// The element `inertia`.
    pub inertia_element: Option<XId>,
    /// `ixx ixy ixz iyy iyz izz`, kg m^2.
    pub inertia: [Option<AttrValue>; 6],
    /// Its numbers: many rules ask for them.
    entries: OnceLock<Option<[f64; 6]>>,
    cache: Cache,
}

impl Inertial {
    /// The names of the entries of [`Inertial::inertia`].
    pub const ENTRIES: [&'static str; 6] = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];

    fn of(tree: &XTree, element: XId) -> Self {
        let [origin, mass_element, inertia_element] =
            first_children(tree, element, ["origin", "mass", "inertia"]);
        Self {
            element,
            origin: origin.map(|origin| Pose::of(tree, origin)),
            mass_element,
            mass: mass_element.and_then(|mass| AttrValue::attr(tree, mass, "value")),
            inertia_element,
            inertia: Self::ENTRIES.map(|name| AttrValue::attr(tree, inertia_element?, name)),
            entries: OnceLock::new(),
            cache: Cache::default(),
        }
    }

    /// What somebody reads off it, made on first use; an inertial that an edit does not reach keeps it. One type is kept.
    pub fn cached<T: Any + Send + Sync>(&self, make: impl FnOnce(&Self) -> Arc<T>) -> Arc<T> {
        self.cache.get_or_make(|| make(self))
    }

    /// The mass in kg, when it is known.
    pub fn mass(&self) -> Option<f64> {
        self.mass.as_ref()?.number()
    }

    /// `ixx ixy ixz iyy iyz izz` in kg m^2, when all are known.
    pub fn entries(&self) -> Option<[f64; 6]> {
        *self.entries.get_or_init(|| {
            let mut numbers = [0.0; 6];
            for (slot, text) in numbers.iter_mut().zip(&self.inertia) {
                *slot = text.as_ref()?.number()?;
            }
            Some(numbers)
        })
    }
}

/// A `visual` or a `collision`.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// Where its geometry stands in the link.
    pub origin: Option<Pose>,
    /// Its first `geometry`.
    pub geometry: Option<Geometry>,
    /// Its first `material`. Boxed: most have none.
    pub material: Option<Box<Material>>,
}

impl Body {
    fn of(tree: &XTree, element: XId) -> Self {
        let [origin, geometry, material] =
            first_children(tree, element, ["origin", "geometry", "material"]);
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            origin: origin.map(|origin| Pose::of(tree, origin)),
            geometry: geometry.map(|geometry| Geometry::of(tree, geometry)),
            material: material.map(|material| Box::new(Material::of(tree, material))),
        }
    }

    /// The shape that parsers take: the first one.
    pub fn shape(&self) -> Option<&Shape> {
        self.geometry.as_ref()?.shapes.first()
    }
}

/// A `geometry`.
#[derive(Clone, Debug)]
pub struct Geometry {
    /// Its element.
    pub element: XId,
    /// Its child elements in order; parsers take the first one.
    pub shapes: Vec<Shape>,
}

impl Geometry {
    fn of(tree: &XTree, element: XId) -> Self {
        Self {
            element,
            shapes: tree
                .elements(element)
                .map(|shape| Shape::of(tree, shape))
                .collect(),
        }
    }
}

/// A child of `geometry`.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Its element; the tag name is the element's text.
    pub element: XId,
    /// What it is.
    pub kind: ShapeKind,
}

/// The kinds of shapes; lengths in meters.
#[derive(Clone, Debug)]
pub enum ShapeKind {
    /// `box`: full lengths along x, y, z, centered.
    Box {
        /// Three lengths.
        size: Option<AttrValue>,
    },
    /// `cylinder` along z, centered.
    Cylinder {
        /// Radius.
        radius: Option<AttrValue>,
        /// Length.
        length: Option<AttrValue>,
    },
    /// `capsule` along z, centered: a cylinder with half spheres at its ends.
    Capsule {
        /// Radius.
        radius: Option<AttrValue>,
        /// Length of the cylinder.
        length: Option<AttrValue>,
    },
    /// `sphere`, centered.
    Sphere {
        /// Radius.
        radius: Option<AttrValue>,
    },
    /// `mesh`
    Mesh {
        /// The URI or path of the file.
        filename: Option<AttrValue>,
        /// Three factors, 1 when absent.
        scale: Option<AttrValue>,
    },
    /// An element that urdfdom does not know.
    Other,
}

impl Shape {
    fn of(tree: &XTree, element: XId) -> Self {
        let kind = match tree.get(element).text.as_str() {
            "box" => ShapeKind::Box {
                size: AttrValue::attr(tree, element, "size"),
            },
            "cylinder" => ShapeKind::Cylinder {
                radius: AttrValue::attr(tree, element, "radius"),
                length: AttrValue::attr(tree, element, "length"),
            },
            "capsule" => ShapeKind::Capsule {
                radius: AttrValue::attr(tree, element, "radius"),
                length: AttrValue::attr(tree, element, "length"),
            },
            "sphere" => ShapeKind::Sphere {
                radius: AttrValue::attr(tree, element, "radius"),
            },
            "mesh" => ShapeKind::Mesh {
                filename: AttrValue::attr(tree, element, "filename"),
                scale: AttrValue::attr(tree, element, "scale"),
            },
            _ => ShapeKind::Other,
        };
        Self { element, kind }
    }
}

/// A `material`, of the robot or inside a `visual`.
#[derive(Clone, Debug)]
pub struct Material {
    /// Its element.
    pub element: XId,
    /// Its `name`.
    pub name: Option<AttrValue>,
    /// The first `color` element.
    pub color: Option<XId>,
    /// The `rgba` of its `color`, each 0 to 1.
    pub rgba: Option<AttrValue>,
    /// The first `texture` element.
    pub texture: Option<XId>,
    /// The `filename` of its `texture`.
    pub texture_file: Option<AttrValue>,
}

impl Material {
    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        let [color, texture] = first_children(tree, element, ["color", "texture"]);
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            color,
            rgba: color.and_then(|color| AttrValue::attr(tree, color, "rgba")),
            texture,
            texture_file: texture.and_then(|texture| AttrValue::attr(tree, texture, "filename")),
        }
    }
}

impl Link {
    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        let (mut inertial, mut visuals, mut collisions) = (None, Vec::new(), Vec::new());
        for child in tree.elements(element) {
            match tree.get(child).text.as_str() {
                "inertial" => {
                    inertial.get_or_insert_with(|| Inertial::of(tree, child));
                }
                "visual" => visuals.push(Body::of(tree, child)),
                "collision" => collisions.push(Body::of(tree, child)),
                _ => {}
            }
        }
        Self {
            element,
            name: AttrValue::attr(tree, element, "name"),
            inertial,
            visuals,
            collisions,
        }
    }

    /// Its name for messages.
    pub fn shown(&self) -> &str {
        self.name.as_ref().map_or("", |name| name.value.as_str())
    }

    /// Whether it has a visual or a collision.
    pub fn has_geometry(&self) -> bool {
        !self.visuals.is_empty() || !self.collisions.is_empty()
    }
}
