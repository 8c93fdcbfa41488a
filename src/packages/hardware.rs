//! What hardware of the workspace does by itself, whatever the description says: read off its sources in C++.

use std::path::Path;
use std::sync::Arc;

use super::Packages;
use super::root::is_built;
use base::FastSet;
use base::limits::{CALLER_BYTES, CALLER_DEPTH, CALLER_FILES, CALLER_FOLDERS};
use vfs::Vfs;

/// The functions by which a plugin exports interfaces.
const EXPORTS: [&str; 2] = ["::export_state_interfaces(", "::export_command_interfaces("];
/// By what hardware of ROS 1 registers joints under names of its own.
const REGISTERS: &str = "JointStateHandle";
/// What a plugin reads when it exports what the description lists.
const LISTED: [&str; 2] = [".state_interfaces", ".command_interfaces"];

/// What the sources below a folder say about hardware.
#[derive(Default)]
pub(super) struct HardwareSources {
    /// The classes that export interfaces of their own.
    exporting: FastSet<String>,
    /// Whether one of them registers joints, as hardware of ROS 1 does.
    registers: bool,
}

impl Packages {
    /// Whether the sources around `from` have a hardware plugin of that name (`package/Class`, `package::Class`) that exports
    /// interfaces without reading which ones the description lists.
    pub fn exports_interfaces(&self, plugin: &str, from: &Path) -> bool {
        let class = plugin.rsplit(['/', ':']).next().unwrap_or(plugin);
        self.hardware_around(from)
            .is_some_and(|hardware| hardware.exporting.contains(class))
    }

    /// Whether the sources around `from` have hardware of ROS 1 that registers joints: under names that it computes, as
    /// far as anybody knows.
    pub fn registers_joints(&self, from: &Path) -> bool {
        self.hardware_around(from)
            .is_some_and(|hardware| hardware.registers)
    }

    fn hardware_around(&self, from: &Path) -> Option<Arc<HardwareSources>> {
        let top = self.sources_around(from)?;
        Some(
            self.hardware
                .get(top.clone(), || Arc::new(search(&self.vfs, &top))),
        )
    }
}

fn search(vfs: &Vfs, top: &Path) -> HardwareSources {
    let mut seen: FastSet<u128> = FastSet::default();
    let mut open = vec![(top.to_owned(), 0)];
    let (mut files, mut found) = (0, HardwareSources::default());
    while let Some((folder, depth)) = open.pop() {
        let is_new = vfs
            .identity(&folder)
            .is_some_and(|identity| seen.insert(identity));
        if !is_new || seen.len() > CALLER_FOLDERS {
            continue;
        }
        for entry in vfs.list_dir(&folder).iter() {
            let path = folder.join(&entry.name);
            if entry.is_dir {
                let passed_over = entry.name.starts_with('.') || is_built(&entry.name);
                if !passed_over && depth < CALLER_DEPTH {
                    open.push((path, depth + 1));
                }
            } else if files < CALLER_FILES && is_source(&entry.name) {
                files += 1;
                let is_small = vfs.size(&path).is_some_and(|size| size <= CALLER_BYTES);
                let text = is_small.then(|| vfs.text(&path).ok()).flatten();
                if let Some(file) = text {
                    found.exporting.extend(exporting(&file.text));
                    found.registers |= file.text.contains(REGISTERS);
                }
            }
        }
    }
    found
}

fn is_source(name: &str) -> bool {
    [".cpp", ".cc", ".cxx", ".h", ".hpp"]
        .iter()
        .any(|ending| name.ends_with(ending))
}

/// The classes that a source file defines the exports of.
fn exporting(text: &str) -> Vec<String> {
    if LISTED.iter().any(|list| text.contains(list)) {
        return Vec::new();
    }
    let ends = EXPORTS
        .iter()
        .flat_map(|function| text.match_indices(function));
    let class = |(at, _): (usize, &str)| {
        let before = text.get(..at).unwrap_or("");
        before
            .rsplit(|c: char| !(c.is_alphanumeric() || c == '_'))
            .next()
            .map(str::to_owned)
    };
    ends.filter_map(class).collect()
}

#[cfg(test)]
mod tests {
    use crate::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn plugins_that_export_by_themselves() {
        let tree = Tree::new();
        tree.write("arm/package.xml", "<package><name>arm</name></package>");
        let export = "std::vector<StateInterface> arm::Arm::export_state_interfaces() {}";
        tree.write("arm/src/arm.cpp", export);
        let listed = export
            .replace("Arm::", "Listed::")
            .replace("{}", "{ joint.state_interfaces; }");
        tree.write("arm/src/listed.cpp", &listed);
        let packages = Packages::new(
            tree.vfs().clone(),
            &tree.environment(&[]),
            PackageOptions::default(),
        );
        let exports =
            |plugin: &str| packages.exports_interfaces(plugin, &tree.path("arm/urdf/arm.urdf"));
        let found = [
            "arm/Arm",
            "arm::Arm",
            "arm/Listed",
            "mock_components/GenericSystem",
        ]
        .map(exports);
        assert_eq!(found, [true, true, false, false]);
    }
}
