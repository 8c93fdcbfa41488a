//! glTF 2.0, as JSON with buffers beside it and as one binary file.

use std::cell::Cell;

use nalgebra::{Matrix4, Quaternion, Translation3, UnitQuaternion, Vector3};

use super::defect::Defect;
use super::draft::{Dependency, MeshBuilder, UpAxis};
use super::gltf_json::{Gltf, GltfBuffer, GltfNode};
use super::gltf_mesh::{Data, triangles};
use super::node_transform::NodeTransform;
use base::FastSet;
use base::limits::{MESH_ELEMENTS, MESH_VISITS};

/// Reads a file beside the mesh; none when it is not there.
pub(super) type FileLoader<'a> = &'a dyn Fn(&str) -> Option<Vec<u8>>;

/// Read a glTF file.
pub(super) fn read(
    bytes: &[u8],
    beside: FileLoader<'_>,
    draft: &mut MeshBuilder,
) -> Result<(), Defect> {
    let (json, binary) = if bytes.starts_with(b"glTF") {
        chunks(bytes)?
    } else {
        (bytes, None)
    };
    let gltf: Gltf = serde_json::from_slice(json).map_err(|error| not_gltf(&error))?;
    draft.up_axis = Some(UpAxis::Y);
    draft.unit = Some(1.0);
    for uri in gltf
        .images
        .iter()
        .chain(&gltf.buffers)
        .filter_map(|part| part.uri.as_deref())
    {
        if !uri.starts_with("data:") {
            draft.needs(Dependency::file(uri));
        }
    }
    if let Some(extension) = gltf
        .extensions_required
        .iter()
        .find_map(|name| changes_geometry(name))
    {
        return Err(Defect::unread(format!(
            "it requires the extension `{extension}`"
        )));
    }
    let mut buffers = Vec::new();
    for (index, buffer) in gltf.buffers.iter().enumerate() {
        buffers.push(buffer_bytes(buffer, binary.filter(|_| index == 0), beside)?);
    }
    scene(
        &gltf,
        &Data {
            gltf: &gltf,
            buffers: &buffers,
            budget: Cell::new(MESH_ELEMENTS),
        },
        draft,
    )
}

/// What is wrong with the JSON, without its text: the file may be a link to one that is nobody else's business.
fn not_gltf(error: &serde_json::Error) -> Defect {
    let what = if error.is_data() {
        "its JSON is not glTF"
    } else {
        "it is not valid JSON"
    };
    Defect::corrupt(format!(
        "{what} (line {}, column {})",
        error.line(),
        error.column()
    ))
}

/// The feature of an extension with which what is read here would not be the geometry.
fn changes_geometry(extension: &str) -> Option<&'static str> {
    ["draco", "meshopt", "quantization", "gpu_instancing"]
        .into_iter()
        .find(|word| extension.contains(word))
}

/// The number in the four bytes from `at` on.
fn number(bytes: &[u8], at: usize) -> Option<usize> {
    let bytes = bytes.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?) as usize)
}

/// JSON and binary part of a GLB file.
fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Defect> {
    let cut = || Defect::corrupt("it is truncated: a chunk is longer than the file");
    let length = number(bytes, 8).ok_or_else(cut)?;
    if length > bytes.len() {
        let size = bytes.len();
        return Err(Defect::corrupt(format!(
            "it should have {length} bytes but has {size}"
        )));
    }
    let (mut json, mut binary, mut at) = (None, None, 12);
    while at < length {
        let size = number(bytes, at).ok_or_else(cut)?;
        let kind = bytes.get(at + 4..at + 8).ok_or_else(cut)?;
        let content = bytes
            .get(at + 8..)
            .and_then(|rest| rest.get(..size))
            .ok_or_else(cut)?;
        match kind {
            b"JSON" if json.is_none() => json = Some(content),
            b"BIN\0" if binary.is_none() => binary = Some(content),
            _ => {}
        }
        at += 8 + size;
    }
    Ok((
        json.ok_or_else(|| Defect::corrupt("it has no JSON"))?,
        binary,
    ))
}

/// The bytes of a buffer; none when its file is missing, which is a dependency of its own.
fn buffer_bytes(
    buffer: &GltfBuffer,
    binary: Option<&[u8]>,
    beside: FileLoader<'_>,
) -> Result<Option<Vec<u8>>, Defect> {
    let Some(uri) = buffer.uri.as_deref() else {
        let bytes = binary
            .ok_or_else(|| Defect::corrupt("a buffer has neither a file nor a binary chunk"))?;
        return Ok(Some(bytes.to_vec()));
    };
    match uri.strip_prefix("data:") {
        None => Ok(beside(uri)),
        Some(data) => {
            let encoded = data
                .split_once("base64,")
                .map(|(_, encoded)| encoded)
                .unwrap_or_default();
            let bytes = base64(encoded)
                .ok_or_else(|| Defect::corrupt("the data of a buffer is not base64"))?;
            Ok(Some(bytes))
        }
    }
}

/// Take the triangles of the scene that is shown.
fn scene(gltf: &Gltf, data: &Data<'_>, draft: &mut MeshBuilder) -> Result<(), Defect> {
    let scene = gltf.scenes.get(gltf.scene.unwrap_or(0));
    // without a scene, there is what is in the nodes that no node holds
    let tops = match scene {
        Some(scene) => scene.nodes.clone(),
        None => {
            let held: FastSet<usize> = gltf
                .nodes
                .iter()
                .flat_map(|node| node.children.iter().copied())
                .collect();
            (0..gltf.nodes.len())
                .filter(|node| !held.contains(node))
                .collect()
        }
    };
    let mut open: Vec<(usize, Matrix4<f64>)> = tops
        .into_iter()
        .map(|top| (top, Matrix4::identity()))
        .collect();
    let mut visits = 0;
    while let Some((index, around)) = open.pop() {
        let missing = || Defect::corrupt(format!("it refers to missing node {index}"));
        let node = gltf.nodes.get(index).ok_or_else(missing)?;
        visits += 1 + node.children.len();
        if visits > MESH_VISITS {
            return Err(Defect::too_large(format!(
                "its nodes contain each other, or there are more than {MESH_VISITS}"
            )));
        }
        let here = around * transform(node);
        open.extend(node.children.iter().map(|&child| (child, here)));
        if let Some(mesh) = node.mesh {
            let placed = NodeTransform::new(here);
            let found = triangles(data, mesh)?;
            let mut materials = found.materials.into_iter().peekable();
            for (number, corners) in found.triangles.into_iter().enumerate() {
                if draft.tinted
                    && let Some((_, material)) = materials.next_if(|(start, _)| *start == number)
                {
                    draft
                        .soup
                        .tint(material.and_then(|material| color(gltf, material)));
                }
                draft.soup.push(placed.triangle(corners))?;
            }
        }
    }
    Ok(())
}

/// The color of a material; glTF says how much light there is, URDF what a screen is told.
fn color(gltf: &Gltf, material: usize) -> Option<[f64; 4]> {
    let material = gltf.materials.get(material)?;
    let [r, g, b, a] = material
        .pbr_metallic_roughness
        .base_color_factor
        .unwrap_or([1.0; 4]);
    let [r, g, b] = [r, g, b].map(|light| {
        let light = light.clamp(0.0, 1.0);
        if light <= 0.003_130_8 {
            light * 12.92
        } else {
            1.055 * libm::pow(light, 1.0 / 2.4) - 0.055
        }
    });
    Some([r, g, b, a])
}

fn transform(node: &GltfNode) -> Matrix4<f64> {
    if let Some(matrix) = &node.matrix {
        return Matrix4::from_column_slice(matrix);
    }
    let [x, y, z] = node.translation.unwrap_or_default();
    let [i, j, k, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let rotation = UnitQuaternion::try_new(Quaternion::new(w, i, j, k), 1e-12).unwrap_or_default();
    let scale = Vector3::from(node.scale.unwrap_or([1.0; 3]));
    Translation3::new(x, y, z).to_homogeneous()
        * rotation.to_homogeneous()
        * Matrix4::new_nonuniform_scaling(&scale)
}

/// The bytes that base64 stands for.
fn base64(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut held, mut bits) = (0u32, 0);
    for letter in text.trim_end_matches('=').bytes() {
        let value = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return None,
        };
        held = held << 6 | u32::from(value);
        bits += 6;
        if bits >= 8 {
            bits -= 8;
            bytes.push((held >> bits) as u8);
            held &= (1 << bits) - 1;
        }
    }
    Some(bytes)
}
