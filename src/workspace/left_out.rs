//! Files that a checkout lacks on purpose: what `.gitignore` leaves out, and what Git LFS keeps elsewhere.

use std::path::Path;

use ignore::gitignore::{Gitignore, GitignoreBuilder};

use packages::Packages;
use vfs::Vfs;

/// What Git says about the files below a folder, in files that lie in it.
#[derive(Default)]
struct GitRules {
    ignored: Option<Gitignore>,
    in_lfs: Option<Gitignore>,
}

/// Whether a `.gitignore` between a file and the top of its sources leaves the file out of the repository.
pub fn is_ignored_by_git(packages: &Packages, file: &Path) -> bool {
    is_matched(packages, file, |rules| rules.ignored.as_ref())
}

/// Whether a `.gitattributes` between a file and the top of its sources gives the file to Git LFS.
pub fn is_in_git_lfs(packages: &Packages, file: &Path) -> bool {
    is_matched(packages, file, |rules| rules.in_lfs.as_ref())
}

/// Whether the rules of the nearest folder that has one about a file match it.
fn is_matched(
    packages: &Packages,
    file: &Path,
    kind: impl Fn(&GitRules) -> Option<&Gitignore>,
) -> bool {
    let Some(top) = packages.sources_around(file) else {
        return false;
    };
    let folders = file
        .ancestors()
        .skip(1)
        .take_while(|folder| folder.starts_with(&top));
    let matched = folders.map(|folder| {
        let rules = packages.of_folder(folder, || GitRules::of(packages.vfs(), folder));
        let found = kind(&rules).map(|rules| rules.matched_path_or_any_parents(file, false));
        found
            .filter(|found| !found.is_none())
            .map(|found| found.is_ignore())
    });
    matched.flatten().next().unwrap_or(false)
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
    use super::{is_ignored_by_git, is_in_git_lfs};
    use packages::{PackageOptions, Packages};
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
                is_ignored_by_git(&packages, &file),
                is_in_git_lfs(&packages, &file),
            );
            assert_eq!(found, (is_ignored, is_in_lfs), "{file:?}");
        }
    }
}
