//! Which distributions of ROS 2 the authors of a package name.

use std::path::{Path, PathBuf};

use super::Packages;
use super::manifest::MANIFEST;
use base::limits::CALLER_BYTES;

/// Distributions before Jazzy that have ros2_control.
/// Without Iron, whose name is a word of workshops.
const BEFORE_JAZZY: [&str; 3] = ["foxy", "galactic", "humble"];
const SINCE_JAZZY: [&str; 4] = ["jazzy", "kilted", "lyrical", "rolling"];
/// What the name of a file begins with that describes a container.
const CONTAINER: &str = "Dockerfile";
/// Folders of a repository in which builds and tests are described.
const FOLDERS: [&str; 4] = ["", "docker", ".docker", ".github/workflows"];

impl Packages {
    /// Whether the package around a file is for distributions of ROS 2 before Jazzy only: the environment says so, or else
    /// its manifest, pages, scripts and workflows, or those of the repository.
    pub fn is_before_jazzy(&self, file: &Path) -> bool {
        if let Some(distribution) = self.env.var("ROS_DISTRO").filter(|name| !name.is_empty()) {
            return BEFORE_JAZZY.contains(&distribution);
        }
        let Some(package) = self.containing(file) else {
            return false;
        };
        // what it is run in says more than pages, which also tell of plans
        let is_container = |path: &PathBuf| name_of(path).starts_with(CONTAINER);
        let all = |_: &PathBuf| true;
        let of_package = || self.names_distributions(&package.folder, all);
        let top = self.sources_around(file);
        let in_container = || self.names_distributions(top.as_ref()?, is_container);
        let of_repository = || self.names_distributions(top.as_ref()?, all);
        in_container()
            .or_else(of_package)
            .or_else(of_repository)
            .is_some_and(|is_new| !is_new)
    }

    /// Whether the pages below a folder that count name a distribution since Jazzy; none when they name no distribution.
    fn names_distributions(&self, top: &Path, counts: impl Fn(&PathBuf) -> bool) -> Option<bool> {
        let (mut is_old, mut is_new) = (false, false);
        let pages = FOLDERS
            .iter()
            .flat_map(|folder| self.pages_in(&top.join(folder)));
        for path in pages.filter(counts) {
            let Ok(file) = self.vfs.text(&path) else {
                continue;
            };
            for word in file.text.split(|c: char| !c.is_ascii_alphanumeric()) {
                is_old |= BEFORE_JAZZY
                    .iter()
                    .any(|name| word.eq_ignore_ascii_case(name));
                is_new |= SINCE_JAZZY
                    .iter()
                    .any(|name| word.eq_ignore_ascii_case(name));
            }
        }
        (is_old || is_new).then_some(is_new)
    }

    /// The files of a folder that say what a package is built and tested with.
    fn pages_in(&self, folder: &Path) -> Vec<PathBuf> {
        let entries = self.vfs.list_dir(folder);
        let files = entries
            .iter()
            .filter(|entry| !entry.is_dir && tells_how_built(&entry.name));
        let paths = files.map(|entry| folder.join(&entry.name));
        paths
            .filter(|path| self.vfs.size(path).is_some_and(|size| size <= CALLER_BYTES))
            .collect()
    }
}

fn name_of(path: &Path) -> &str {
    let name = path.file_name().and_then(|name| name.to_str());
    name.unwrap_or_default()
}

/// Whether a file of that name may say what a package is built and tested with.
fn tells_how_built(name: &str) -> bool {
    const ENDINGS: [&str; 7] = ["md", "rst", "txt", "sh", "yml", "yaml", "repos"];
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    name == MANIFEST || name.starts_with(CONTAINER) || ENDINGS.contains(&ending)
}

#[cfg(test)]
mod tests {
    use crate::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn distributions_that_are_named() {
        let is_old = |name: &str, text: &str, vars: &[(&str, &str)]| {
            let tree = Tree::new();
            tree.write("ws/arm/package.xml", "<package><name>arm</name></package>");
            tree.write("ws/.git/HEAD", "");
            tree.write(name, text);
            let packages = Packages::new(
                tree.vfs().clone(),
                &tree.environment(vars),
                PackageOptions::default(),
            );
            packages.is_before_jazzy(&tree.path("ws/arm/urdf/arm.xacro"))
        };
        assert!(is_old("ws/arm/README.md", "Install ros-humble-xacro.", &[]));
        assert!(is_old(
            "ws/.github/workflows/ci.yml",
            "distribution: [Foxy, Humble]",
            &[]
        ));
        assert!(!is_old(
            "ws/arm/README.md",
            "Tested on Humble and Jazzy.",
            &[]
        ));
        assert!(!is_old("ws/arm/README.md", "A humbler arm.", &[]));
        assert!(!is_old(
            "ws/arm/README.md",
            "For Humble.",
            &[("ROS_DISTRO", "jazzy")]
        ));
        assert!(is_old("ws/arm/README.md", "", &[("ROS_DISTRO", "humble")]));
    }

    #[test]
    fn a_container_says_more_than_plans() {
        let is_old = |container: &str| {
            let tree = Tree::new();
            tree.write("ws/arm/package.xml", "<package><name>arm</name></package>");
            tree.write("ws/.git/HEAD", "");
            tree.write("ws/README.md", "For Humble. Planned: Jazzy.");
            tree.write("ws/Dockerfile", container);
            let packages = Packages::new(
                tree.vfs().clone(),
                &tree.environment(&[]),
                PackageOptions::default(),
            );
            packages.is_before_jazzy(&tree.path("ws/arm/urdf/arm.xacro"))
        };
        assert!(is_old("FROM ros:humble"));
        assert!(!is_old("FROM ros:jazzy"));
        assert!(!is_old("FROM ubuntu"));
    }
}
