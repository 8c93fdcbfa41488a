//! The geometries of Collada.

use std::rc::Rc;
use std::str::FromStr;

use roxmltree::{Node, NodeId};

use super::dae::{child, children, fragment};
use super::defect::Defect;
use super::soup::MeshPoint;
use base::FastMap;

/// Corners of triangles in the frame of a geometry.
pub(super) type TriangleList = Vec<[MeshPoint; 3]>;

/// Triangles, and from which one on there is which material.
#[derive(Debug)]
pub(super) struct Surfaced<M> {
    pub(super) triangles: TriangleList,
    pub(super) materials: Vec<(usize, M)>,
}

impl<M> Surfaced<M> {
    pub(super) fn new() -> Self {
        Self {
            triangles: Vec::new(),
            materials: Vec::new(),
        }
    }

    /// What came since there were `start` triangles has this material.
    pub(super) fn since(&mut self, start: usize, material: M) {
        if self.triangles.len() > start {
            self.materials.push((start, material));
        }
    }
}

/// Arrays that were read, with their stride: a file may name the same large one again and again.
pub(super) type Arrays = FastMap<(NodeId, usize), Rc<[MeshPoint]>>;

/// The triangles of a `geometry`.
pub(super) fn triangles<'a, 'input>(
    geometry: Node<'a, 'input>,
    ids: &FastMap<&'a str, Node<'a, 'input>>,
    arrays: &mut Arrays,
) -> Result<Surfaced<Option<&'a str>>, Defect> {
    let mut found = Surfaced::new();
    let Some(mesh) = child(geometry, "mesh") else {
        return Ok(found);
    };
    for part in mesh.children().filter(Node::is_element) {
        let name = part.tag_name().name();
        if !matches!(
            name,
            "triangles" | "polylist" | "polygons" | "trifans" | "tristrips"
        ) {
            continue;
        }
        let Some((vertices, layout)) = layout(part) else {
            continue;
        };
        let vertices = named(mesh, ids, vertices);
        let vertices = vertices
            .ok_or_else(|| Defect::corrupt(format!("`{name}` refers to missing vertices")))?;
        let points = points(mesh, vertices, ids, arrays)?;
        let start = found.triangles.len();
        primitive(part, &layout, &points, &mut found.triangles)?;
        found.since(start, part.attribute("material"));
    }
    Ok(found)
}

/// How the indices of a primitive are laid out.
struct IndexLayout {
    /// Indices for each corner.
    stride: usize,
    /// Which of them is the vertex.
    offset: usize,
}

/// The id of the vertices and the layout of a primitive.
fn layout<'a>(part: Node<'a, '_>) -> Option<(&'a str, IndexLayout)> {
    let offset = |input: Node<'_, '_>| -> usize {
        input
            .attribute("offset")
            .and_then(|text| text.trim().parse().ok())
            .unwrap_or(0)
    };
    let vertex =
        children(part, "input").find(|input| input.attribute("semantic") == Some("VERTEX"))?;
    let stride = children(part, "input").map(offset).max()?.checked_add(1)?;
    Some((
        fragment(vertex.attribute("source")?)?,
        IndexLayout {
            stride,
            offset: offset(vertex),
        },
    ))
}

/// What an id means in a mesh: its own part of that name, else that of the file. Some programs write the same ids into
/// each mesh.
fn named<'a, 'input>(
    mesh: Node<'a, 'input>,
    ids: &FastMap<&'a str, Node<'a, 'input>>,
    id: &str,
) -> Option<Node<'a, 'input>> {
    let own = mesh
        .children()
        .find(|part| part.attribute("id") == Some(id));
    own.or_else(|| ids.get(id).copied())
}

/// The positions of `vertices`.
fn points<'a, 'input>(
    mesh: Node<'a, 'input>,
    vertices: Node<'a, 'input>,
    ids: &FastMap<&'a str, Node<'a, 'input>>,
    arrays: &mut Arrays,
) -> Result<Rc<[MeshPoint]>, Defect> {
    let missing = || Defect::corrupt("its vertices have no positions");
    let position =
        children(vertices, "input").find(|input| input.attribute("semantic") == Some("POSITION"));
    let source = position.and_then(|input| named(mesh, ids, fragment(input.attribute("source")?)?));
    let source = source.ok_or_else(missing)?;
    let array = child(source, "float_array").ok_or_else(missing)?;
    let accessor = child(source, "technique_common").and_then(|common| child(common, "accessor"));
    let stride = accessor.and_then(|accessor| accessor.attribute("stride")?.trim().parse().ok());
    let stride = stride.filter(|&stride: &usize| stride >= 3).unwrap_or(3);
    if let Some(known) = arrays.get(&(array.id(), stride)) {
        return Ok(known.clone());
    }
    let values: Vec<f64> = numbers(array)?;
    let points: Rc<[MeshPoint]> = values
        .chunks(stride)
        .filter_map(|chunk| chunk.first_chunk::<3>().copied())
        .collect();
    arrays.insert((array.id(), stride), points.clone());
    Ok(points)
}

/// The numbers in the text of an element.
pub(super) fn numbers<T: FromStr>(element: Node<'_, '_>) -> Result<Vec<T>, Defect> {
    let text = element.text().unwrap_or_default();
    let parsed = text
        .split_ascii_whitespace()
        .zip(1_usize..)
        .map(|(word, number)| {
            let name = element.tag_name().name();
            word.parse()
                .map_err(|_| Defect::corrupt(format!("value {number} of `{name}` is not a number")))
        });
    parsed.collect()
}

fn primitive(
    part: Node<'_, '_>,
    layout: &IndexLayout,
    points: &[MeshPoint],
    found: &mut TriangleList,
) -> Result<(), Defect> {
    let lists =
        children(part, "p").chain(children(part, "ph").filter_map(|holes| child(holes, "p")));
    match part.tag_name().name() {
        "triangles" => {
            for list in lists {
                found.extend_from_slice(corners(list, layout, points)?.as_chunks::<3>().0);
            }
        }
        "polylist" => {
            let counts: Vec<usize> = child(part, "vcount")
                .map(numbers)
                .transpose()?
                .unwrap_or_default();
            let mut lists = lists.map(|list| corners(list, layout, points));
            let all = lists.next().transpose()?.unwrap_or_default();
            let mut rest = all.as_slice();
            for count in counts {
                let Some((polygon, behind)) = rest.split_at_checked(count) else {
                    return Err(Defect::corrupt(
                        "its `vcount` needs more indices than there are",
                    ));
                };
                fan(polygon, found);
                rest = behind;
            }
        }
        "tristrips" => {
            for list in lists {
                strip(&corners(list, layout, points)?, found);
            }
        }
        _ => {
            for list in lists {
                fan(&corners(list, layout, points)?, found);
            }
        }
    }
    Ok(())
}

/// The corners that a list of indices names.
fn corners(
    list: Node<'_, '_>,
    layout: &IndexLayout,
    points: &[MeshPoint],
) -> Result<Vec<MeshPoint>, Defect> {
    let indices: Vec<i64> = numbers(list)?;
    let vertices = indices
        .chunks_exact(layout.stride)
        .filter_map(|chunk| chunk.get(layout.offset));
    vertices
        .map(|&index| {
            let place = usize::try_from(index).ok();
            let found = place.and_then(|place| points.get(place)).copied();
            found.ok_or_else(|| Defect::no_vertex(index, points.len()))
        })
        .collect()
}

/// A polygon, or a fan, as triangles around its first corner.
pub(super) fn fan(corners: &[MeshPoint], found: &mut TriangleList) {
    if let Some((first, rest)) = corners.split_first() {
        found.extend(
            rest.iter()
                .zip(rest.iter().skip(1))
                .map(|(b, c)| [*first, *b, *c]),
        );
    }
}

/// A strip as triangles: every second one is turned.
pub(super) fn strip(corners: &[MeshPoint], found: &mut TriangleList) {
    for (window, turned) in corners.windows(3).zip([false, true].into_iter().cycle()) {
        if let &[a, b, c] = window {
            found.push(if turned { [b, a, c] } else { [a, b, c] });
        }
    }
}
