//! YAML, meshes and configuration files.

use std::path::{Path, PathBuf};

use xacro_lsp::model::Mesh;
use xacro_lsp::vfs::Vfs;
use xacro_lsp::workspace::config::Config;
use xacro_lsp::yaml::{self, YamlKind, YamlNode};

use super::launch_requests::config_places;

/// A value with places in the text, or one error.
pub fn yaml(data: &[u8]) {
    let text = xacro_lsp::vfs::text_of(data.to_vec());
    match yaml::load(&text, "f.yaml") {
        Ok(node) => places(&node, &text),
        Err(error) => {
            assert!(
                error.range.end as usize <= text.len(),
                "{error:?} of {text:?}"
            );
            assert!(
                !error.short.is_empty() && !error.message.is_empty(),
                "{error:?} of {text:?}"
            );
        }
    }
}

fn places(root: &YamlNode, text: &str) {
    let mut open = vec![root];
    while let Some(node) = open.pop() {
        assert!(
            node.range.end as usize <= text.len(),
            "{:?} of {text:?}",
            node.range
        );
        assert!(
            text.is_char_boundary(node.range.start as usize),
            "{:?} of {text:?}",
            node.range
        );
        match &node.kind {
            YamlKind::Map(items) | YamlKind::Pairs(items) => {
                open.extend(items.iter().flat_map(|(key, value)| [key, value]));
            }
            YamlKind::List(items) | YamlKind::Set(items) => open.extend(items),
            _ => {}
        }
    }
}

/// A mesh has a surface, or something is wrong with it; numbers of a surface are sound.
///
/// The first byte names the format.
pub fn mesh(data: &[u8]) {
    const ENDINGS: [&str; 5] = ["stl", "obj", "dae", "gltf", "glb"];
    let (&first, bytes) = data.split_first().unwrap_or((&0, &[]));
    let ending = ENDINGS[usize::from(first) % ENDINGS.len()];
    let mesh = Mesh::read(ending, bytes, &|_| {
        Some(vec![0, 0, 128, 63, 0, 0, 0, 64, 1, 0, 2, 0, 3, 0])
    });
    assert!(mesh.surface.is_some() || mesh.defect.is_some());
    if let Some(surface) = mesh.surface {
        assert!(surface.triangles > 0);
        let [min, max] = [surface.bounds.min, surface.bounds.max];
        assert!((0..3).all(|axis| min[axis] <= max[axis]), "{surface:?}");
    }
    if let Some(defect) = &mesh.defect {
        assert!(
            !defect.message.contains('\n') && defect.message.len() < 2000,
            "{defect:?}"
        );
    }
}

/// A configuration always loads, and says what in it has no effect, with places in its text.
pub fn configuration(data: &[u8]) {
    let text = xacro_lsp::vfs::text_of(data.to_vec());
    let vfs = Vfs::with_cwd(1 << 20, PathBuf::from("/none"));
    let path = Path::new("/none/xacro-lint.toml");
    vfs.set_buffer(path, Some(text.clone()));
    let loaded = Config::load(&vfs, path).expect("the buffer is there");
    for warning in &loaded.warnings {
        assert!(
            warning.place.range.end as usize <= text.len(),
            "{warning:?} of {text:?}"
        );
        assert!(
            warning.place.line >= 1 && warning.place.column >= 1,
            "{warning:?} of {text:?}"
        );
        assert!(!warning.message.contains('\n'), "{warning:?} of {text:?}");
    }
    loaded.config.settings();
    config_places(&text);
    for root in &loaded.config.roots {
        assert!(root.variants(&Vec::new()).len() <= xacro_lsp::base::limits::MATRIX_RUNS);
    }
    if let Ok(settings) = serde_json::from_str(&text) {
        Config::default().apply_settings(&settings, Path::new("/none"));
    }
}
