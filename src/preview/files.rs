//! The files that a viewer may ask for, by ids that mean nothing to anybody else.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::Serialize;

use base::{FastMap, FastSet};

/// A file of a mesh, or one that a mesh needs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshFile {
    /// Its name without folders.
    pub name: String,
    /// Its ending in small letters.
    pub format: String,
    /// Its length.
    pub bytes: u64,
    /// Corners of the box around it, in its own units; where it is known.
    #[serde(rename = "box", skip_serializing_if = "Option::is_none")]
    pub bounds: Option<[[f64; 3]; 2]>,
    /// The files it names, as it names them, by their ids.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub files: BTreeMap<String, String>,
}

/// The files that models name, by id. Shared with the server that hands them out.
#[derive(Debug, Default)]
pub struct ModelFiles(Mutex<FileTable>);

#[derive(Debug, Default)]
struct FileTable {
    /// How many ids were given.
    count: u64,
    /// Ids by path and state of the file.
    ids: FastMap<(PathBuf, u64), String>,
    /// Paths of the ids that models name now.
    paths: FastMap<String, PathBuf>,
}

impl ModelFiles {
    /// The id of a file in a state: the same file in another state has another id.
    pub fn id(&self, path: &Path, state: u64) -> String {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (path.to_path_buf(), state);
        let id = match known.ids.get(&key) {
            Some(id) => id.clone(),
            None => {
                known.count += 1;
                let id = format!("f{}", known.count);
                known.ids.insert(key, id.clone());
                id
            }
        };
        known.paths.insert(id.clone(), path.to_path_buf());
        id
    }

    /// The path behind an id that a model names now.
    pub fn path(&self, id: &str) -> Option<PathBuf> {
        self.0
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .paths
            .get(id)
            .cloned()
    }

    /// All files that models name now.
    pub fn paths(&self) -> Vec<PathBuf> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut paths: Vec<PathBuf> = known.paths.values().cloned().collect();
        paths.sort();
        paths
    }

    /// Forget all ids but these.
    pub fn keep(&self, ids: &FastSet<&str>) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.paths.retain(|id, _| ids.contains(id.as_str()));
        let FileTable {
            ids: named, paths, ..
        } = &mut *known;
        named.retain(|_, id| paths.contains_key(id));
    }
}
