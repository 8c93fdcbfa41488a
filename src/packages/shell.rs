//! What a shell has in its environment once ROS was sourced.

use std::path::Path;

use super::manifest::MANIFEST;
use super::{Packages, RosVersion};

/// A variable that every shell of ROS has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RosVariable {
    /// Its value.
    Value(&'static str),
    /// It has one of several values: outside of a package, nothing says which.
    Unknown,
}

impl Packages {
    /// What `$(env name)` is in every shell of ROS, for the robot of a root file. None for variables that such a shell
    /// need not have.
    pub fn ros_variable(&self, name: &str, root: &Path) -> Option<RosVariable> {
        let (ros1, ros2) = match name {
            "ROS_VERSION" => ("1", "2"),
            "ROS_DISTRO" => ("noetic", "jazzy"),
            "ROS_PYTHON_VERSION" => return Some(RosVariable::Value("3")),
            _ => return None,
        };
        Some(match self.generation(root) {
            Some(RosVersion::Ros1) => RosVariable::Value(ros1),
            Some(RosVersion::Ros2) => RosVariable::Value(ros2),
            None => RosVariable::Unknown,
        })
    }

    /// The generation of ROS that the package around a file is built for: ROS 1 when only catkin builds it.
    pub fn generation(&self, file: &Path) -> Option<RosVersion> {
        let package = self.containing(file)?;
        let manifest = self.vfs.text(&package.folder.join(MANIFEST)).ok()?;
        let tools = manifest.text.split("<buildtool_depend").skip(1);
        let mut tools = tools.filter_map(|tool| tool.split_once('>')?.1.split('<').next());
        let is_ros1 =
            tools.any(|tool| tool.trim() == "catkin") && !manifest.text.contains("ament_");
        Some(if is_ros1 {
            RosVersion::Ros1
        } else {
            RosVersion::Ros2
        })
    }

    /// The same; for a file of no package, that of the packages around it, if they agree.
    pub fn generation_around(&self, file: &Path) -> Option<RosVersion> {
        if self.containing(file).is_some() {
            return self.generation(file);
        }
        let packages = self.below(&self.sources_around(file)?);
        let mut all = packages
            .into_iter()
            .map(|(_, folder)| self.generation(&folder.join(MANIFEST)));
        let first = all.next()??;
        all.all(|other| other == Some(first)).then_some(first)
    }

    /// Whether the manifest of the package around a file says that it is built for ROS 2.
    pub fn is_for_ament(&self, file: &Path) -> bool {
        let says = |folder: &Path| {
            self.is_text(&folder.join(MANIFEST), |manifest| {
                manifest.contains("ament_")
            })
        };
        self.generation(file) == Some(RosVersion::Ros2)
            && self
                .containing(file)
                .is_some_and(|package| says(&package.folder))
    }
}

#[cfg(test)]
mod tests {
    use crate::{PackageOptions, Packages, RosVariable};
    use vfs::testing::Tree;

    #[test]
    fn the_generation_follows_the_build_type() {
        let tree = Tree::new();
        let manifest = |name: &str, tool: &str| {
            format!(
                "<package><name>{name}</name><buildtool_depend>{tool}</buildtool_depend></package>"
            )
        };
        tree.write("old/package.xml", &manifest("old", "catkin"));
        tree.write("new/package.xml", &manifest("new", "ament_cmake"));
        let packages = Packages::new(
            tree.vfs().clone(),
            &tree.environment(&[]),
            PackageOptions::default(),
        );
        let variable = |name: &str, file: &str| packages.ros_variable(name, &tree.path(file));
        assert_eq!(
            variable("ROS_VERSION", "old/urdf/r.xacro"),
            Some(RosVariable::Value("1"))
        );
        assert_eq!(
            variable("ROS_VERSION", "new/urdf/r.xacro"),
            Some(RosVariable::Value("2"))
        );
        assert_eq!(
            variable("ROS_VERSION", "r.xacro"),
            Some(RosVariable::Unknown)
        );
        assert_eq!(variable("ROBOT", "old/urdf/r.xacro"), None);
    }
}
