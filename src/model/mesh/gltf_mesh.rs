//! The triangles of a mesh of glTF.

use std::cell::Cell;

use super::dae_geometry::{Surfaced, fan, strip};
use super::defect::Defect;
use super::gltf_json::{Accessor, Gltf, Primitive};
use super::soup::MeshPoint;
use base::limits::MESH_ELEMENTS;

const BYTE: u32 = 5121;
const SHORT: u32 = 5123;
const INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// The JSON with the bytes it speaks about; those of a missing file are none.
pub(super) struct Data<'a> {
    pub(super) gltf: &'a Gltf,
    pub(super) buffers: &'a [Option<Vec<u8>>],
    /// Elements of accessors that may still be read.
    pub(super) budget: Cell<usize>,
}

/// The triangles of a mesh in its own frame.
pub(super) fn triangles(data: &Data<'_>, mesh: usize) -> Result<Surfaced<Option<usize>>, Defect> {
    let missing = || Defect::corrupt(format!("it refers to missing mesh {mesh}"));
    let mesh = data.gltf.meshes.get(mesh).ok_or_else(missing)?;
    let mut found = Surfaced::new();
    for primitive in &mesh.primitives {
        let corners = corners(data, primitive)?;
        let start = found.triangles.len();
        match primitive.mode.unwrap_or(4) {
            4 => found
                .triangles
                .extend_from_slice(corners.as_chunks::<3>().0),
            5 => strip(&corners, &mut found.triangles),
            6 => fan(&corners, &mut found.triangles),
            _ => {}
        }
        found.since(start, primitive.material);
    }
    Ok(found)
}

/// The corners of a primitive in the order of its indices.
fn corners(data: &Data<'_>, primitive: &Primitive) -> Result<Vec<MeshPoint>, Defect> {
    let Some(position) = primitive.attributes.position else {
        return Ok(Vec::new());
    };
    let accessor = accessor(data, position)?;
    if (accessor.component_type, accessor.kind.as_str()) != (FLOAT, "VEC3") {
        return Err(Defect::unread(
            "its positions are not stored as three floats",
        ));
    }
    let points: Vec<MeshPoint> = elements(data, accessor, 12)?.map(point).collect();
    let Some(indices) = primitive.indices else {
        return Ok(points);
    };
    let accessor = self::accessor(data, indices)?;
    let size = match accessor.component_type {
        BYTE => 1,
        SHORT => 2,
        INT => 4,
        kind => return Err(Defect::corrupt(format!("its indices have the type {kind}"))),
    };
    let indices = elements(data, accessor, size)?.map(|bytes| {
        bytes
            .iter()
            .rev()
            .fold(0usize, |number, &byte| number << 8 | usize::from(byte))
    });
    indices
        .map(|index| {
            let found = points.get(index).copied();
            found.ok_or_else(|| Defect::no_vertex(index, points.len()))
        })
        .collect()
}

fn point(bytes: &[u8]) -> MeshPoint {
    let mut numbers = bytes
        .as_chunks::<4>()
        .0
        .iter()
        .map(|bytes| f64::from(f32::from_le_bytes(*bytes)));
    std::array::from_fn(|_| numbers.next().unwrap_or(f64::NAN))
}

fn accessor<'a>(data: &Data<'a>, index: usize) -> Result<&'a Accessor, Defect> {
    let missing = || Defect::corrupt(format!("it refers to missing accessor {index}"));
    data.gltf.accessors.get(index).ok_or_else(missing)
}

/// The bytes of each element of an accessor, of `size` bytes each.
fn elements<'a>(
    data: &Data<'a>,
    accessor: &Accessor,
    size: usize,
) -> Result<impl Iterator<Item = &'a [u8]>, Defect> {
    let view = accessor
        .buffer_view
        .ok_or_else(|| Defect::unread("it stores positions as differences"))?;
    let missing = || Defect::corrupt("it refers to a missing part of a buffer");
    let view = data.gltf.buffer_views.get(view).ok_or_else(missing)?;
    let buffer = data.buffers.get(view.buffer).ok_or_else(missing)?;
    let buffer = buffer
        .as_deref()
        .ok_or_else(|| Defect::unread("the file of its buffer is missing"))?;
    let part = buffer
        .get(view.byte_offset..)
        .and_then(|rest| rest.get(..view.byte_length))
        .ok_or_else(missing)?;
    let part = part.get(accessor.byte_offset..).ok_or_else(missing)?;
    let stride = view
        .byte_stride
        .filter(|&stride| stride >= size)
        .unwrap_or(size);
    // of the last element, what follows it up to the stride may be missing
    let fitting = if part.len() < size {
        0
    } else {
        (part.len() - size) / stride + 1
    };
    if accessor.count > fitting {
        let count = accessor.count;
        return Err(Defect::corrupt(format!(
            "it has {count} elements where only {fitting} fit"
        )));
    }
    let left = data.budget.get().checked_sub(accessor.count);
    data.budget.set(left.ok_or_else(|| {
        Defect::too_large(format!("it reads more than {MESH_ELEMENTS} elements"))
    })?);
    Ok(part
        .chunks(stride)
        .take(accessor.count)
        .filter_map(move |chunk| chunk.get(..size)))
}
