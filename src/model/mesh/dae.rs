//! Collada.

use nalgebra::{Matrix4, Rotation3, Translation3, Unit, Vector3};
use roxmltree::{Document, Node, ParsingOptions};

use super::dae_geometry::{Arrays, Surfaced, numbers, triangles};
use super::defect::{Defect, DefectKind};
use super::draft::{Dependency, MeshBuilder, UpAxis};
use super::node_transform::NodeTransform;
use base::FastMap;
use base::limits::{MESH_NODES, MESH_VISITS};

/// Materials of an instance that are looked at.
const MOST_BOUND: usize = 256;

/// Read a Collada file. Some exporters write `<` into attributes, and most readers do not mind.
pub(super) fn read(text: &str, draft: &mut MeshBuilder) -> Result<(), Defect> {
    match parse(text) {
        Ok(document) => document_of(&document, draft),
        Err(defect) if defect.kind == DefectKind::Corrupt => {
            let escaped = with_escaped_attributes(text);
            let Ok(document) = parse(&escaped) else {
                return Err(defect);
            };
            draft.defect = Some(Defect::unescaped(defect.message));
            document_of(&document, draft)
        }
        Err(defect) => Err(defect),
    }
}

fn parse(text: &str) -> Result<Document<'_>, Defect> {
    let options = ParsingOptions {
        nodes_limit: MESH_NODES,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| match error {
        roxmltree::Error::DtdDetected => Defect::unread("it has a DOCTYPE"),
        roxmltree::Error::NodesLimitReached => {
            Defect::too_large(format!("it has more than {MESH_NODES} nodes"))
        }
        error => {
            // names and characters of the file are quoted: it may be a link to one that is nobody else's business
            let said = Some(error.to_string()).filter(|said| !said.contains('\''));
            let said = said.unwrap_or_else(|| format!("unexpected text at {}", error.pos()));
            Defect::corrupt(format!("it is not well-formed XML: {said}"))
        }
    })
}

/// The text with every `<` inside the quotes of a tag escaped.
fn with_escaped_attributes(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len() + 64);
    let (mut in_tag, mut quote) = (false, None);
    for c in text.chars() {
        match c {
            '<' if quote.is_some() => {
                escaped.push_str("&lt;");
                continue;
            }
            '<' => in_tag = true,
            '>' if quote.is_none() => in_tag = false,
            '"' | '\'' if quote == Some(c) => quote = None,
            '"' | '\'' if in_tag && quote.is_none() => quote = Some(c),
            _ => {}
        }
        escaped.push(c);
    }
    escaped
}

fn document_of(document: &Document<'_>, draft: &mut MeshBuilder) -> Result<(), Defect> {
    let root = document.root_element();
    if root.tag_name().name() != "COLLADA" {
        return Err(Defect::corrupt("its root element is not `COLLADA`"));
    }
    header(root, draft);
    let mut scene = ColladaScene {
        ids: FastMap::default(),
        by_kind: FastMap::default(),
        made: FastMap::default(),
        arrays: Arrays::default(),
        draft,
    };
    for node in root.descendants() {
        if let Some(id) = node.attribute("id") {
            // exporters give a material the id of a geometry: what instances lead to is known by its kind
            scene.ids.entry(id).or_insert(node);
            scene
                .by_kind
                .entry((node.tag_name().name(), id))
                .or_insert(node);
        }
    }
    scene.read(root)
}

/// Unit, up axis and textures.
fn header(root: Node<'_, '_>, draft: &mut MeshBuilder) {
    if let Some(asset) = child(root, "asset") {
        let unit = child(asset, "unit").and_then(|unit| unit.attribute("meter"));
        draft.unit = unit
            .and_then(|text| text.trim().parse().ok())
            .filter(|&unit| unit > 0.0 && f64::is_finite(unit));
        draft.up_axis = match child(asset, "up_axis")
            .and_then(|axis| axis.text())
            .map(str::trim)
        {
            Some("X_UP") => Some(UpAxis::X),
            Some("Y_UP") => Some(UpAxis::Y),
            Some("Z_UP") => Some(UpAxis::Z),
            _ => None,
        };
    }
    let images = children(root, "library_images").flat_map(|library| children(library, "image"));
    for source in images.filter_map(|image| child(image, "init_from")) {
        // version 1.5 has one more element inside
        let name = child(source, "ref")
            .unwrap_or(source)
            .text()
            .unwrap_or_default()
            .trim();
        if !name.starts_with("data:") {
            draft.needs(Dependency::file(name));
        }
    }
}

/// A file on its way to triangles.
struct ColladaScene<'a, 'input, 'd> {
    ids: FastMap<&'a str, Node<'a, 'input>>,
    /// The same by the kind of element.
    by_kind: FastMap<(&'a str, &'a str), Node<'a, 'input>>,
    made: FastMap<&'a str, Surfaced<Option<&'a str>>>,
    arrays: Arrays,
    draft: &'d mut MeshBuilder,
}

impl<'a, 'input> ColladaScene<'a, 'input, '_> {
    fn read(&mut self, root: Node<'a, 'input>) -> Result<(), Defect> {
        let unit = self.draft.unit.unwrap_or(1.0);
        let start = Matrix4::new_scaling(unit);
        let instance = child(root, "scene").and_then(|scene| child(scene, "instance_visual_scene"));
        let Some(scene) = instance.and_then(|instance| self.target(instance)) else {
            // without a scene, there is what is in the library
            let geometries = children(root, "library_geometries")
                .flat_map(|library| children(library, "geometry"));
            return geometries
                .into_iter()
                .try_for_each(|geometry| self.place(geometry, &start, None));
        };
        let mut open = vec![(scene, start)];
        let mut visits = 0;
        while let Some((node, around)) = open.pop() {
            visits += 1 + node.children().count();
            if visits > MESH_VISITS {
                return Err(Defect::too_large(format!(
                    "its nodes contain each other, or there are more than {MESH_VISITS}"
                )));
            }
            let here = around * transform(node)?;
            for part in node.children().filter(Node::is_element) {
                match part.tag_name().name() {
                    "node" => open.push((part, here)),
                    "instance_node" => open.extend(self.target(part).map(|node| (node, here))),
                    "instance_geometry" => {
                        self.target(part)
                            .into_iter()
                            .try_for_each(|geometry| self.place(geometry, &here, Some(part)))?;
                    }
                    "instance_controller" => {
                        let skin = self
                            .target(part)
                            .and_then(|controller| child(controller, "skin"));
                        let geometry = skin
                            .and_then(|skin| self.ids.get(fragment(skin.attribute("source")?)?));
                        let mut geometry = geometry.copied().into_iter();
                        geometry
                            .try_for_each(|geometry| self.place(geometry, &here, Some(part)))?;
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    /// What the `url` of an instance means; none when it is in another file.
    fn target(&self, instance: Node<'a, 'input>) -> Option<Node<'a, 'input>> {
        let id = fragment(instance.attribute("url")?)?;
        let kind = instance
            .tag_name()
            .name()
            .strip_prefix("instance_")
            .unwrap_or_default();
        self.by_kind
            .get(&(kind, id))
            .or_else(|| self.ids.get(id))
            .copied()
    }

    /// Take the triangles of a geometry, placed by an instance that says which materials it has.
    fn place(
        &mut self,
        geometry: Node<'a, 'input>,
        at: &Matrix4<f64>,
        instance: Option<Node<'a, 'input>>,
    ) -> Result<(), Defect> {
        let id = geometry.attribute("id").unwrap_or_default();
        if !self.made.contains_key(id) || id.is_empty() {
            self.made
                .insert(id, triangles(geometry, &self.ids, &mut self.arrays)?);
        }
        let placed = NodeTransform::new(*at);
        let Some(Surfaced {
            triangles,
            materials,
        }) = self.made.get(id)
        else {
            return Ok(());
        };
        let mut materials = materials.iter().peekable();
        for (number, corners) in triangles.iter().enumerate() {
            if self.draft.tinted
                && let Some((_, symbol)) = materials.next_if(|(start, _)| *start == number)
            {
                self.draft
                    .soup
                    .tint(symbol.and_then(|symbol| color(symbol, instance, &self.ids)));
            }
            self.draft.soup.push(placed.triangle(*corners))?;
        }
        Ok(())
    }
}

/// The diffuse color of a material, which an instance may name otherwise than the geometry.
fn color<'a, 'input>(
    symbol: &'a str,
    instance: Option<Node<'a, 'input>>,
    ids: &FastMap<&'a str, Node<'a, 'input>>,
) -> Option<[f64; 4]> {
    let common =
        instance.and_then(|instance| child(child(instance, "bind_material")?, "technique_common"));
    let bound = common.and_then(|common| {
        let mut bound = children(common, "instance_material").take(MOST_BOUND);
        let bound = bound.find(|bound| bound.attribute("symbol") == Some(symbol))?;
        fragment(bound.attribute("target")?)
    });
    let material = *ids.get(bound.unwrap_or(symbol))?;
    let effect = *ids.get(fragment(
        child(material, "instance_effect")?.attribute("url")?,
    )?)?;
    let technique = child(child(effect, "profile_COMMON")?, "technique")?;
    let shader = ["phong", "lambert", "blinn"]
        .iter()
        .find_map(|name| child(technique, name))?;
    let color: Vec<f64> = numbers(child(child(shader, "diffuse")?, "color")?).ok()?;
    let [r, g, b, ..] = *color.as_slice() else {
        return None;
    };
    Some([r, g, b, 1.0])
}

/// The transform of a node: its elements one after the other.
fn transform(node: Node<'_, '_>) -> Result<Matrix4<f64>, Defect> {
    let mut all = Matrix4::identity();
    for part in node.children().filter(Node::is_element) {
        let name = part.tag_name().name();
        if !matches!(name, "matrix" | "translate" | "rotate" | "scale") {
            continue;
        }
        let values: Vec<f64> = numbers(part)?;
        all *= match (name, values.as_slice()) {
            ("matrix", values) if values.len() == 16 => Matrix4::from_row_slice(values),
            ("translate", &[x, y, z]) => Translation3::new(x, y, z).to_homogeneous(),
            ("scale", &[x, y, z]) => Matrix4::new_nonuniform_scaling(&Vector3::new(x, y, z)),
            ("rotate", &[x, y, z, degrees]) => match Unit::try_new(Vector3::new(x, y, z), 1e-12) {
                Some(axis) => {
                    Rotation3::from_axis_angle(&axis, degrees.to_radians()).to_homogeneous()
                }
                None => Matrix4::identity(),
            },
            (_, values) => {
                return Err(Defect::corrupt(format!(
                    "`{name}` with {} numbers",
                    values.len()
                )));
            }
        };
    }
    Ok(all)
}

/// The id in a reference to the same file.
pub(super) fn fragment(url: &str) -> Option<&str> {
    url.strip_prefix('#')
}

/// The first child element of a name, in whatever namespace.
pub(super) fn child<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Option<Node<'a, 'input>> {
    node.children()
        .find(|child| child.is_element() && child.tag_name().name() == name)
}

/// The child elements of a name.
pub(super) fn children<'a, 'input>(
    node: Node<'a, 'input>,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'input>> + use<'a, 'input> {
    node.children()
        .filter(move |child| child.is_element() && child.tag_name().name() == name)
}
