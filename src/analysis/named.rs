//! Meshes that came, went or changed without a word of the client: no record tells of them.
use std::path::PathBuf;

use super::host::AnalysisHost;

/// Look whether the meshes that descriptions named so far are as they were.
pub(super) fn notice_meshes(host: &mut AnalysisHost) {
    let vfs = host.session().vfs.clone();
    let changed = host
        .named
        .iter()
        .filter(|(path, state)| vfs.state_on_disk(path) != **state);
    let changed: Vec<PathBuf> = changed.map(|(path, _)| path.clone()).collect();
    if !changed.is_empty() {
        host.changed_on_disk(&changed);
    }
}

/// Keep in mind how the meshes are that were looked for.
pub(super) fn keep_meshes(host: &mut AnalysisHost) {
    let files = host.session().mesh_files();
    for path in files
        .into_iter()
        .filter(|path| !host.named.contains_key(path))
        .collect::<Vec<_>>()
    {
        let state = host.session().vfs.state_on_disk(&path);
        host.named.insert(path, state);
    }
}
