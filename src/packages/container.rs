//! Where a workspace lies in the container that its authors run it in.

use std::path::Path;

use super::Packages;

/// The folders of a workspace, behind its own path.
const INSIDE: [&str; 4] = ["/src/", "/install/", "/devel/", "/build/"];
/// Folders in which containers are described.
const FOLDERS: [&str; 4] = ["", "docker", ".docker", ".devcontainer"];

impl Packages {
    /// Whether an absolute path leads into the workspace of a container that a file beside the sources around `file` describes.
    /// A page counts unless it is about somebody's home.
    pub fn is_in_container(&self, file: &Path, path: &str) -> bool {
        let Some(workspace) = workspace_of(path) else {
            return false;
        };
        let Some(top) = self.sources_around(file) else {
            return false;
        };
        let is_home = ["/home/", "/Users/"]
            .iter()
            .any(|start| workspace.starts_with(start));
        let has_it = |path: &Path| self.is_text(path, |text| has_path(text, workspace));
        FOLDERS.iter().map(|folder| top.join(folder)).any(|folder| {
            let entries = self.vfs().list_dir(&folder);
            let mut files = entries.iter().filter(|entry| !entry.is_dir);
            files.any(|entry| {
                let is_page = entry.name.ends_with(".md") && !is_home;
                (is_page || describes_container(&entry.name)) && has_it(&folder.join(&entry.name))
            })
        })
    }
}

/// The path of the workspace that a path leads into.
pub fn workspace_of(path: &str) -> Option<&str> {
    let path = path.strip_prefix("file://").unwrap_or(path);
    let ends = INSIDE.iter().filter_map(|folder| path.find(folder)).min();
    path.get(..ends?).filter(|workspace| workspace.len() > 1)
}

/// Whether a file of that name describes a container.
fn describes_container(name: &str) -> bool {
    name.starts_with("Dockerfile")
        || name.ends_with("Dockerfile")
        || name == "devcontainer.json"
        || name.contains("compose") && (name.ends_with(".yml") || name.ends_with(".yaml"))
}

/// Whether a text has a path that does not go on with a letter.
fn has_path(text: &str, path: &str) -> bool {
    let goes_on = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    text.match_indices(path).any(|(at, _)| {
        let rest = text.get(at + path.len()..).unwrap_or("");
        !rest.starts_with(goes_on)
    })
}

#[cfg(test)]
mod tests {
    use crate::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn paths_of_containers() {
        let is_it = |name: &str, text: &str, path: &str| {
            let tree = Tree::new();
            tree.write("ws/arm/package.xml", "<package><name>arm</name></package>");
            tree.write("ws/.git/HEAD", "");
            tree.write(name, text);
            let packages = Packages::new(
                tree.vfs().clone(),
                &tree.environment(&[]),
                PackageOptions::default(),
            );
            packages.is_in_container(&tree.path("ws/arm/urdf/arm.xacro"), path)
        };
        let mesh = "file:///opt/ws/install/share/arm/a.stl";
        assert!(is_it("ws/Dockerfile", "ARG WS=/opt/ws\n", mesh));
        assert!(is_it("ws/README.md", "You are in `/opt/ws` now.", mesh));
        assert!(!is_it("ws/Dockerfile", "WORKDIR /opt/ws_old", mesh));
        assert!(!is_it("ws/setup.sh", "cd /opt/ws", mesh));
        let home = "/home/me/ws/src/arm/a.yaml";
        assert!(!is_it("ws/README.md", "cd /home/me/ws", home));
        assert!(is_it(
            "ws/.devcontainer/devcontainer.json",
            "{\"workspaceFolder\": \"/home/me/ws\"}",
            home
        ));
        assert!(!is_it("ws/Dockerfile", "WORKDIR /", "/src/a.stl"));
    }
}
