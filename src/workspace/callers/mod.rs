//! Who calls a description: the launch files, scripts, tests and pages of the workspace that name it, and the
//! arguments that they give.
//!
//! Read as text, never executed: which values a launch file computes is not known then, only that it gives them.

mod config;
mod read;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::memo::Memo;
use super::root::is_built;
use super::{Packages, packages::without_parents};
use base::FastSet;
use base::limits::{CALLER_BYTES, CALLER_DEPTH, CALLER_FILES, CALLER_FOLDERS};
use vfs::Vfs;

/// A file that names descriptions.
#[derive(Clone, Debug)]
pub struct Caller {
    path: PathBuf,
    /// The names of the description files, without folders.
    descriptions: FastSet<String>,
    /// What further names end with, whose beginnings are computed.
    endings: Vec<String>,
    /// Whether whoever calls it names the description.
    is_open: bool,
    /// The arguments it gives, in order.
    pub args: Vec<GivenArg>,
    /// The package whose configuration it completes.
    based_on: Option<String>,
}

/// An argument that a caller gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GivenArg {
    /// Its name.
    pub name: String,
    /// Its value, where the text says it.
    pub value: Option<String>,
}

/// The callers below some folders, found when somebody asks for them.
#[derive(Default)]
pub struct Callers {
    below: Memo<PathBuf, Arc<Vec<Caller>>>,
}

impl Callers {
    /// The files that call the description `file`: first those that name it, then those that may, since they compute the
    /// name; each in the order of their paths.
    pub fn of(&self, file: &Path, packages: &Packages) -> Vec<Caller> {
        let Some(name) = file.file_name().and_then(|name| name.to_str()) else { return Vec::new() };
        let Some(top) = packages.sources_around(file) else { return Vec::new() };
        let all = self.below.get(top.clone(), || Arc::new(search(&packages.vfs, &top)));
        let named = all.iter().filter(|caller| caller.descriptions.contains(name));
        let may_name = |caller: &&Caller| {
            !caller.descriptions.contains(name)
                && caller.endings.iter().any(|ending| name.ends_with(ending.as_str()))
        };
        let computed = all.iter().filter(may_name);
        let may_mean = |caller: &&Caller| caller.computes_the_file() || packages.may_mean(&caller.path, file);
        named.chain(computed).filter(may_mean).cloned().collect()
    }

    /// Whether a file that names the description `file` also says `word`.
    pub fn mention(&self, file: &Path, word: &str, packages: &Packages) -> bool {
        let says = |caller: &Caller| {
            packages.vfs.text(&caller.path).is_ok_and(|text| read::has_name(&text.text, word))
        };
        self.of(file, packages).iter().any(says)
    }

    /// Whether a file names the description `file`.
    pub fn name(&self, file: &Path, packages: &Packages) -> bool {
        let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        self.of(file, packages).iter().any(|caller| caller.descriptions.contains(name))
    }

    /// Whether something that runs names the description `file`, in part at least; a page does not run.
    pub fn load(&self, file: &Path, packages: &Packages) -> bool {
        self.of(file, packages).iter().any(|caller| !caller.is_page() && caller.says(file))
    }

    /// Whether a launch file may mean the description `file`.
    pub fn launch(&self, file: &Path, packages: &Packages) -> bool {
        self.of(file, packages).iter().any(Caller::is_launch)
    }

    /// The names of the descriptions in the package of `file` that launch files load instead: none where the file itself
    /// is named somewhere, or the launch files take the name of any.
    pub fn launched_instead(&self, file: &Path, packages: &Packages) -> FastSet<String> {
        let top = packages.containing(file).and_then(|_| packages.sources_around(file));
        let may_mean = |caller: &Caller| caller.says(file) || caller.is_open && caller.is_launch();
        let is_free = || !self.of(file, packages).iter().any(may_mean);
        let Some(top) = top.filter(|_| is_free()) else { return FastSet::default() };
        let all = self.below.get(top.clone(), || Arc::new(search(&packages.vfs, &top)));
        let launches =
            all.iter().filter(|caller| caller.is_launch() && packages.may_mean(&caller.path, file));
        launches.flat_map(|caller| caller.descriptions.iter().cloned()).collect()
    }

    /// Forget what was found: files have come, gone or changed.
    pub fn forget(&self) {
        self.below.clear();
    }
}

impl Caller {
    /// Whether the text names a description, or the end of its name.
    fn says(&self, file: &Path) -> bool {
        let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let is_end = |ending: &String| !ending.is_empty() && name.ends_with(ending.as_str());
        self.descriptions.contains(name) || self.endings.iter().any(is_end)
    }

    /// Whether this is a file to be read, not run.
    fn is_page(&self) -> bool {
        let ending = self.path.extension().and_then(|ending| ending.to_str()).unwrap_or("");
        ["md", "rst", "txt", "ipynb"].contains(&ending) && !self.path.ends_with("CMakeLists.txt")
    }

    /// Whether this is a launch file, by its name or folder.
    fn is_launch(&self) -> bool {
        let name = self.path.file_name().and_then(|name| name.to_str()).unwrap_or("");
        let folder = self.path.parent().and_then(Path::file_name);
        name.contains("launch") || folder.is_some_and(|folder| folder == "launch") && !self.is_page()
    }

    /// Whether the text says nothing of the file, so that its package may be computed as well.
    fn computes_the_file(&self) -> bool {
        self.descriptions.is_empty() && self.endings.iter().any(String::is_empty)
    }
}

impl Packages {
    /// Whether a text that names a description by its file name may mean `file`, not one of the same name elsewhere: it
    /// is in the same package or names it; without a package, it is in the folder above or below that.
    fn may_mean(&self, caller: &Path, file: &Path) -> bool {
        let Some(package) = self.containing(file) else {
            let near = file.parent().map(|folder| folder.parent().unwrap_or(folder));
            return near.is_some_and(|near| caller.starts_with(near));
        };
        let names_it = || self.vfs.text(caller).is_ok_and(|text| read::has_name(&text.text, &package.name));
        caller.starts_with(&package.folder) || names_it()
    }

    /// The widest folder of sources around a file: the folder that is checked, or the workspace above, else the package,
    /// else the folder of the file.
    pub fn sources_around(&self, file: &Path) -> Option<PathBuf> {
        let file = without_parents(&self.vfs.absolute(file));
        let mut sources = self.source_folders(&file);
        sources.retain(|folder| file.starts_with(folder) && self.vfs.is_dir(folder));
        let widest = sources.into_iter().min_by_key(|folder| folder.components().count());
        let package = || self.containing(&file).map(|package| package.folder);
        widest.or_else(package).or_else(|| file.parent().map(Path::to_owned))
    }
}

/// All callers below a folder.
fn search(vfs: &Vfs, top: &Path) -> Vec<Caller> {
    let mut seen: FastSet<u128> = FastSet::default();
    let mut open = vec![(top.to_owned(), 0)];
    let (mut files, mut found) = (0, Vec::new());
    while let Some((folder, depth)) = open.pop() {
        if seen.len() > CALLER_FOLDERS || !vfs.identity(&folder).is_some_and(|identity| seen.insert(identity))
        {
            continue;
        }
        let entries = vfs.list_dir(&folder);
        // what a tool made and can make again says so
        if entries.iter().any(|entry| entry.name == "CACHEDIR.TAG") {
            continue;
        }
        for entry in entries.iter() {
            let path = folder.join(&entry.name);
            let passed_over =
                entry.name.starts_with('.') || is_built(&entry.name) || entry.name == "node_modules";
            match entry.is_dir {
                true if passed_over || depth >= CALLER_DEPTH => {}
                true => open.push((path, depth + 1)),
                false if files < CALLER_FILES && read::may_call(&entry.name) => {
                    files += 1;
                    let is_small = vfs.size(&path).is_some_and(|size| size <= CALLER_BYTES);
                    let text = is_small.then(|| vfs.text(&path).ok()).flatten();
                    found.extend(text.and_then(|file| read::caller(&path, &file.text)));
                }
                false => {}
            }
        }
    }
    found.sort_by(|a: &Caller, b| a.path.cmp(&b.path));
    config::inherit(&mut found);
    found
}

#[cfg(test)]
mod tests {
    use super::Callers;
    use crate::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn launch_files_of_other_packages_count() {
        let tree = Tree::new();
        tree.write("ws/src/arm/package.xml", "<package><name>arm</name></package>");
        tree.write("ws/src/arm/urdf/arm.urdf.xacro", "<robot/>");
        tree.write(
            "ws/src/bringup/launch/arm.launch.py",
            "Command(['xacro ', share('arm') / 'arm.urdf.xacro', ' side:=', 'left'])",
        );
        tree.write("ws/src/leg/launch/leg.launch.py", "find('leg'), 'arm.urdf.xacro leg:=1'");
        tree.write("ws/src/leg/package.xml", "<package><name>leg</name></package>");
        tree.write("ws/build/arm.launch.py", "'arm.urdf.xacro built:=1'");
        tree.write("ws/src/arm/CHANGELOG.rst", "arm.urdf.xacro log:=1");
        let packages = Packages::new(tree.vfs().clone(), &tree.environment(&[]), PackageOptions::default());
        let callers = Callers::default();
        let found = callers.of(&tree.path("ws/src/arm/urdf/arm.urdf.xacro"), &packages);
        let args: Vec<_> = found.iter().flat_map(|caller| &caller.args).collect();
        assert_eq!(args.len(), 1);
        assert_eq!((args[0].name.as_str(), args[0].value.as_deref()), ("side", Some("left")));
        assert!(callers.of(&tree.path("ws/src/arm/urdf/hand.urdf.xacro"), &packages).is_empty());
    }

    #[test]
    fn configurations_give_arguments_and_pass_them_on() {
        let tree = Tree::new();
        for package in ["arm_base", "arm_site", "other"] {
            tree.write(
                &format!("ws/src/{package}/package.xml"),
                &format!("<package><name>{package}</name></package>"),
            );
        }
        tree.write("ws/src/arm_base/urdf/arm.xacro", "<robot/>");
        tree.write(
            "ws/src/arm_base/config/config.yaml",
            "urdf:\n  path: urdf/arm.xacro\nurdf_params:\n  - side: left\n",
        );
        tree.write(
            "ws/src/arm_site/config/config.yaml",
            "based_on_package: \"arm_base\"\nurdf_params:\n  - mode: fast\n",
        );
        tree.write("ws/src/other/config/config.yaml", "urdf_params:\n  - leg: 1\n");
        let packages = Packages::new(tree.vfs().clone(), &tree.environment(&[]), PackageOptions::default());
        let found = Callers::default().of(&tree.path("ws/src/arm_base/urdf/arm.xacro"), &packages);
        let given =
            found.iter().map(|caller| caller.args.iter().map(|arg| arg.name.as_str()).collect::<Vec<_>>());
        assert_eq!(given.collect::<Vec<_>>(), [vec!["side"], vec!["mode", "side"]]);
    }
}
