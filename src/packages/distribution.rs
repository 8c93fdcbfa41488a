//! Which distributions of ROS 2 the authors of a package name.

use std::path::{Path, PathBuf};

use super::Packages;
use super::manifest::MANIFEST;
use base::limits::CALLER_BYTES;

/// Distributions that have ros2_control, the oldest first. Without Iron, whose name is a word of workshops.
const DISTRIBUTIONS: [&str; 7] = [
    "foxy", "galactic", "humble", "jazzy", "kilted", "lyrical", "rolling",
];
/// What the name of a file begins with that describes a container.
const CONTAINER: &str = "Dockerfile";
/// What the name of a folder holds that describes one.
const CONTAINER_FOLDER: &str = "docker";
/// The folder of a repository in which tests are described.
const WORKFLOWS: &str = ".github/workflows";

impl Packages {
    /// Whether a file is for distributions of ROS 2 before Jazzy only: the environment says so, or else the manifest, pages, scripts and
    /// workflows of the package around it, or those of the repository.
    pub fn is_before_jazzy(&self, file: &Path) -> bool {
        self.is_before("jazzy", file)
    }

    /// The same for Humble.
    pub fn is_before_humble(&self, file: &Path) -> bool {
        self.is_before("humble", file)
    }

    /// Whether the package around a file is for Jazzy or a later distribution, too.
    pub fn is_since_jazzy(&self, file: &Path) -> bool {
        self.distribution_of(file) >= place("jazzy")
    }

    fn is_before(&self, distribution: &str, file: &Path) -> bool {
        let newest = self.distribution_of(file);
        newest.is_some() && newest < place(distribution)
    }

    /// The place of the newest distribution that a package is for; none when nothing says one.
    fn distribution_of(&self, file: &Path) -> Option<usize> {
        if let Some(own) = self.env.var("ROS_DISTRO").filter(|name| !name.is_empty()) {
            return place(own);
        }
        let package = self.containing(file);
        // what it is run in says more than pages, which also tell of plans
        let is_container = |path: &PathBuf| name_of(path).starts_with(CONTAINER);
        let all = |_: &PathBuf| true;
        let of_package = || self.newest_named(&package.as_ref()?.folder, all);
        let top = self.sources_around(file);
        let in_container = || self.newest_named(top.as_ref()?, is_container);
        let of_repository = || self.newest_named(top.as_ref()?, all);
        in_container().or_else(of_package).or_else(of_repository)
    }

    /// The newest distribution that the pages below a folder that count name, by its place; none when they name no distribution.
    fn newest_named(&self, top: &Path, counts: impl Fn(&PathBuf) -> bool) -> Option<usize> {
        let is_for_containers = |name: &str| name.to_ascii_lowercase().contains(CONTAINER_FOLDER);
        let entries = self.vfs.list_dir(top);
        let containers = entries
            .iter()
            .filter(|entry| entry.is_dir && is_for_containers(&entry.name))
            .map(|entry| top.join(&entry.name));
        let folders = [top.to_owned(), top.join(WORKFLOWS)].into_iter();
        let pages = folders
            .chain(containers)
            .flat_map(|folder| self.pages_in(&folder));
        let named = pages.filter(counts).filter_map(|path| {
            let file = self.vfs.text(&path).ok()?;
            let words = file.text.split(|c: char| !c.is_ascii_alphanumeric());
            let place = |word: &str| {
                let mut all = DISTRIBUTIONS.iter();
                all.position(|name| word.eq_ignore_ascii_case(name))
            };
            words.filter_map(place).max()
        });
        named.max()
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

fn place(distribution: &str) -> Option<usize> {
    DISTRIBUTIONS.iter().position(|one| *one == distribution)
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
    fn containers_in_a_folder_of_their_own() {
        let tree = Tree::new();
        tree.write("ws/arm/package.xml", "<package><name>arm</name></package>");
        tree.write("ws/.git/HEAD", "");
        tree.write("ws/README.md", "Planned: Humble.");
        tree.write("ws/docker_arm/Dockerfile", "FROM osrf/ros:foxy-desktop");
        let packages = Packages::new(
            tree.vfs().clone(),
            &tree.environment(&[]),
            PackageOptions::default(),
        );
        for file in ["ws/arm/urdf/arm.xacro", "ws/loose/arm.xacro"] {
            let file = tree.path(file);
            assert!(packages.is_before_humble(&file) && packages.is_before_jazzy(&file));
        }
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
