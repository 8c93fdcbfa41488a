//! What is said of a mesh file once, however often it is used.
use super::super::context::DocumentCx;
use super::resources::MeshUse;
use base::FastMap;
use model::Mesh;

/// Further places listed with a finding.
const MOST_PLACES: usize = 10;

/// Each file that `wanted` picks, with the first place that names it and some of the others.
pub(super) fn each_file<'a>(
    cx: &'a DocumentCx<'_>,
    wanted: impl Fn(&Mesh) -> bool,
) -> Vec<(MeshUse<'a>, Vec<MeshUse<'a>>)> {
    let mut files: Vec<(MeshUse<'a>, Vec<MeshUse<'a>>)> = Vec::new();
    let mut places: FastMap<std::path::PathBuf, usize> = FastMap::default();
    for mesh in cx.meshes().filter(|mesh| mesh.mesh.is_some_and(&wanted)) {
        let Some(path) = mesh.target.file() else {
            continue;
        };
        match places.get(path).and_then(|&place| files.get_mut(place)) {
            Some((_, others)) if others.len() < MOST_PLACES => others.push(mesh),
            Some(_) => {}
            None => {
                places.insert(path.to_owned(), files.len());
                files.push((mesh, Vec::new()));
            }
        }
    }
    files
}
