//! How large meshes and the files beside them may be.

use xacro_lsp::base::limits::*;
use xacro_lsp::model::{Mesh, Meshes};
use xacro_lsp::vfs::Vfs;

use super::{folder, sparse, write};

fn vfs() -> Vfs {
    Vfs::with_cwd(1 << 20, folder())
}

#[test]
fn mesh_bytes() {
    let folder = folder();
    sparse(&folder, "a.stl", "", MESH_BYTES + 1);
    let mesh = Meshes::default().get(&vfs(), &folder.join("a.stl"));
    assert_eq!(
        mesh.defect.as_ref().unwrap().message,
        "it has more than 100 megabytes"
    );
}

#[test]
fn material_bytes() {
    let folder = folder();
    write(
        &folder,
        "a.obj",
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    let missing = |size| {
        sparse(&folder, "a.mtl", "newmtl m\nmap_Kd gone.png\n", size);
        let (meshes, vfs, path) = (Meshes::default(), vfs(), folder.join("a.obj"));
        let mesh = meshes.get(&vfs, &path);
        meshes.missing(&vfs, &path, &mesh, &|_| true).len()
    };
    assert_eq!((missing(25), missing(MATERIAL_BYTES + 1)), (1, 0));
}

fn mesh_defect(ending: &str, bytes: &[u8]) -> String {
    Mesh::read(ending, bytes, &|_| None)
        .defect
        .map(|defect| defect.message)
        .unwrap_or_default()
}

#[test]
fn mesh_triangles() {
    let text = format!(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n{}",
        "f 1 2 3\n".repeat(MESH_TRIANGLES + 1)
    );
    assert_eq!(
        mesh_defect("obj", text.as_bytes()),
        "line 2500004: it has more than 2500000 triangles"
    );
}

#[test]
fn mesh_nodes() {
    let text = format!("<COLLADA>{}</COLLADA>", "<a/>".repeat(MESH_NODES as usize));
    assert_eq!(
        mesh_defect("dae", text.as_bytes()),
        "it has more than 4000000 nodes"
    );
}

#[test]
fn mesh_files() {
    let libraries: String = (0..MESH_FILES + 500)
        .map(|n| format!("mtllib {n}.mtl\n"))
        .collect();
    let text = format!("{libraries}v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(
        Mesh::read("obj", text.as_bytes(), &|_| None)
            .dependencies
            .len(),
        MESH_FILES
    );
}
