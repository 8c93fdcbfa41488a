//! Meshes that came, went or changed without a word of the client: no record tells of them.
use std::path::PathBuf;

use super::host::AnalysisHost;

impl AnalysisHost {
    /// Look whether the meshes that descriptions named so far are as they were.
    pub(super) fn notice_meshes(&mut self) {
        let vfs = self.session().vfs.clone();
        let changed = self
            .named
            .iter()
            .filter(|(path, state)| vfs.state_on_disk(path) != **state);
        let changed: Vec<PathBuf> = changed.map(|(path, _)| path.clone()).collect();
        if !changed.is_empty() {
            self.changed_on_disk(&changed);
        }
    }

    /// Keep in mind how the meshes are that were looked for.
    pub(super) fn keep_meshes(&mut self) {
        let files = self.session().mesh_files();
        for path in files
            .into_iter()
            .filter(|path| !self.named.contains_key(path))
            .collect::<Vec<_>>()
        {
            let state = self.session().vfs.state_on_disk(&path);
            self.named.insert(path, state);
        }
    }
}
