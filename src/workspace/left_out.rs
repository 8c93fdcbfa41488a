//! Files that a checkout lacks on purpose: what `.gitignore` leaves out, and what Git LFS keeps elsewhere.

use std::path::Path;
use std::sync::Arc;

use ignore::gitignore::{Gitignore, GitignoreBuilder};

use super::{Packages, is_built};
use vfs::Vfs;

/// Files that have tools look for no packages in a folder.
const IGNORE_MARKS: [&str; 3] = ["AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE"];

/// What Git says about the files below a folder, in files that lie in it.
#[derive(Default)]
pub(super) struct GitRules {
    ignored: Option<Gitignore>,
    in_lfs: Option<Gitignore>,
}

impl Packages {
    /// Whether a `.gitignore` between a file and the top of its sources leaves the file out of the repository.
    pub fn is_ignored_by_git(&self, file: &Path) -> bool {
        self.is_matched(file, |rules| rules.ignored.as_ref())
    }

    /// Whether a file lies in what a build installed, and the build tool says so: what is missing there was not installed yet.
    pub fn is_in_a_build(&self, file: &Path) -> bool {
        let is_one = |folder: &Path| {
            folder.file_name().is_some_and(is_built)
                && IGNORE_MARKS
                    .iter()
                    .any(|mark| self.vfs.is_file(&folder.join(mark)))
        };
        file.ancestors().skip(1).any(is_one)
    }

    /// Whether a `.gitattributes` between a file and the top of its sources gives the file to Git LFS.
    pub fn is_in_git_lfs(&self, file: &Path) -> bool {
        self.is_matched(file, |rules| rules.in_lfs.as_ref())
    }

    /// Whether the rules of the nearest folder that has one about a file match it.
    fn is_matched(&self, file: &Path, kind: impl Fn(&GitRules) -> Option<&Gitignore>) -> bool {
        let Some(top) = self.sources_around(file) else {
            return false;
        };
        let folders = file
            .ancestors()
            .skip(1)
            .take_while(|folder| folder.starts_with(&top));
        let matched = folders.map(|folder| {
            let rules = self.git_rules.get(folder.to_owned(), || {
                Arc::new(GitRules::of(&self.vfs, folder))
            });
            let found = kind(&rules).map(|rules| rules.matched_path_or_any_parents(file, false));
            found
                .filter(|found| !found.is_none())
                .map(|found| found.is_ignore())
        });
        matched.flatten().next().unwrap_or(false)
    }
}

impl GitRules {
    fn of(vfs: &Vfs, folder: &Path) -> Self {
        let ignored = text_in(vfs, folder, ".gitignore");
        let attributes = text_in(vfs, folder, ".gitattributes");
        let in_lfs = attributes
            .lines()
            .filter(|line| line.contains("filter=lfs"));
        let in_lfs = in_lfs.filter_map(|line| line.split_whitespace().next());
        Self {
            ignored: patterns(folder, ignored.lines()),
            in_lfs: patterns(folder, in_lfs),
        }
    }
}

/// The text of a file of a folder; empty where there is none.
fn text_in(vfs: &Vfs, folder: &Path, name: &str) -> String {
    let path = folder.join(name);
    let text = vfs.is_file(&path).then(|| vfs.text(&path).ok()).flatten();
    text.map(|file| file.text.to_string()).unwrap_or_default()
}

/// Patterns of Git below a folder; none when there are none. A line that is not one is passed over, as by Git.
fn patterns<'l>(folder: &Path, lines: impl Iterator<Item = &'l str>) -> Option<Gitignore> {
    let mut builder = GitignoreBuilder::new(folder);
    for line in lines {
        let _ = builder.add_line(None, line);
    }
    builder.build().ok().filter(|rules| !rules.is_empty())
}

#[cfg(test)]
mod tests {
    use crate::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn files_that_git_leaves_out() {
        let tree = Tree::new();
        tree.write("arm/package.xml", "<package><name>arm</name></package>");
        tree.write("arm/.gitignore", "# exports\n/meshes/\n*.obj\n");
        tree.write("arm/parts/.gitignore", "!*.obj\n");
        tree.write(
            "arm/.gitattributes",
            "*.STL filter=lfs diff=lfs merge=lfs -text\n*.sh text eol=lf\n",
        );
        let packages = Packages::new(
            tree.vfs().clone(),
            &tree.environment(&[]),
            PackageOptions::default(),
        );
        for (file, is_ignored, is_in_lfs) in [
            ("arm/meshes/base.stl", true, false),
            ("arm/urdf/meshes/base.stl", false, false),
            ("arm/urdf/base.obj", true, false),
            // the nearest folder decides
            ("arm/parts/base.obj", false, false),
            ("arm/urdf/base.STL", false, true),
            ("arm/run.sh", false, false),
            ("other/base.obj", false, false),
        ] {
            let file = tree.path(file);
            let found = (
                packages.is_ignored_by_git(&file),
                packages.is_in_git_lfs(&file),
            );
            assert_eq!(found, (is_ignored, is_in_lfs), "{file:?}");
        }
    }
}
