//! Who calls a description: the launch files, scripts, tests and pages of the workspace that name it, and the
//! arguments that they give.
//!
//! Read as text, never executed: which values a launch file computes is not known then, only that it gives them.

mod called;
mod choices;
mod config;
mod copied;
mod mentions;
mod programs;
mod purpose;
mod read;

pub use called::RobotCall;
pub use choices::Excluded;
pub use read::{has_name, without_comments};

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Packages;
use super::cache::Cache;
use super::launch;
use super::root::{is_built, is_cache};
use base::limits::{CALLER_BYTES, CALLER_DEPTH, CALLER_FILES, CALLER_FOLDERS};
use base::{FastMap, FastSet};
use vfs::Vfs;
use vfs::without_parents;

/// A file that names descriptions.
#[derive(Clone, Debug)]
pub struct Caller {
    path: PathBuf,
    /// The names of the description files, each with the folders that are written in front of it.
    descriptions: FastMap<String, Vec<Written>>,
    /// What further names end with, whose beginnings are computed.
    endings: Vec<String>,
    /// Whether whoever calls it names the description.
    is_open: bool,
    /// The xacro that it runs.
    era: Option<Era>,
    /// Whether it starts a simulator, a planner or controllers.
    simulates: bool,
    /// Whether it loads files into Bullet.
    is_bullet: bool,
    /// Whether it starts RViz.
    shows: bool,
    /// The arguments it gives, in order.
    pub args: Vec<GivenArg>,
    /// The package whose configuration it completes.
    based_on: Option<String>,
}

/// The xacro that a launch file is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Era {
    /// It runs `xacro.py` without `--inorder`: macros and properties were read before what uses them.
    Unordered,
    /// It runs `xacro.py`, which there is no more since ROS Noetic: tags without their prefix were taken.
    Old,
    /// It says `--inorder`, as nobody has to since ROS Melodic, where xacro took such tags and warned of them.
    Melodic,
    /// Nothing says that it is old.
    Any,
}

/// What is written in front of the name of a description.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Written {
    /// The package, where the text says it.
    package: Option<String>,
    folders: PathBuf,
}

impl Written {
    /// How well a file fits: its package first, then its folders, and then whether these are all that it has in its package.
    fn fit(&self, file: &Path, packages: &Packages) -> (bool, usize, bool) {
        let folder = file.parent().unwrap_or(file);
        let pairs = folder.iter().rev().zip(self.folders.iter().rev());
        let count = pairs.take_while(|(a, b)| a == b).count();
        let own = (self.package.is_some() || count > 0)
            .then(|| packages.containing(file))
            .flatten();
        let is_in_package =
            self.package.is_some() && own.as_ref().map(|own| &own.name) == self.package.as_ref();
        let is_all = count > 0 && own.is_some_and(|own| folder == own.folder.join(&self.folders));
        (is_in_package, count, is_all)
    }
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
    below: Cache<PathBuf, Arc<Uses>>,
    called: Cache<PathBuf, Arc<called::Called>>,
    copies: Cache<PathBuf, Arc<copied::Copies>>,
    mentions: Cache<PathBuf, Arc<mentions::Mentions>>,
}

/// Who calls descriptions below a folder, and the descriptions there, by name.
#[derive(Default)]
struct Uses {
    callers: Vec<Caller>,
    /// The files that may hold calls of xacro: read as such when somebody asks for all calls.
    scripts: Vec<PathBuf>,
    files: FastMap<String, Vec<PathBuf>>,
    /// The same files in the order of their paths.
    sorted: Arc<Vec<PathBuf>>,
    /// The files that may belong to robots by their names: SRDF, YAML, what MoveIt's setup assistant wrote down.
    beside: Vec<PathBuf>,
}

impl Uses {
    /// Whether a caller names `file`. Of several files of that name (`is_near`: that it may mean), it means those that lie
    /// in the package and folders that it writes.
    fn names(&self, caller: &Caller, file: &Path, packages: &Packages, is_near: bool) -> bool {
        let name = name_of(file);
        let Some(written) = caller.descriptions.get(name) else {
            return false;
        };
        let own = || packages.containing(file).map(|package| package.name);
        // a text that says another package means no file of this one
        let may_be = |written: &&Written| {
            let said = written.package.as_ref();
            said.is_none_or(|said| own().is_none_or(|own| own == *said))
        };
        let namesakes = self.files.get(name).into_iter().flatten();
        let may_mean = |other: &&PathBuf| !is_near || packages.may_mean(&caller.path, other);
        let others: Vec<&PathBuf> = namesakes
            .filter(|other| *other != file)
            .filter(may_mean)
            .collect();
        written.iter().filter(may_be).any(|written| {
            let fit = written.fit(file, packages);
            others
                .iter()
                .all(|other| written.fit(other, packages) <= fit)
        })
    }

    /// Whether a caller names a description that is there, other than `file`.
    fn has_another(&self, caller: &Caller, file: &Path, packages: &Packages) -> bool {
        let mut others = caller
            .descriptions
            .keys()
            .filter_map(|name| self.files.get(name))
            .flatten();
        others.any(|other| other != file && self.names(caller, other, packages, false))
    }
}

impl Callers {
    /// The files that call the description `file`: first those that name it, then those that may, since they compute the
    /// name; each in the order of their paths.
    pub fn of(&self, file: &Path, packages: &Packages) -> Vec<Caller> {
        let name = name_of(file);
        let Some(all) = self.around(file, packages).filter(|_| !name.is_empty()) else {
            return Vec::new();
        };
        let is_named = |caller: &&Caller| all.names(caller, file, packages, true);
        let named = all.callers.iter().filter(is_named);
        let may_name = |caller: &&Caller| {
            !caller.descriptions.contains_key(name)
                && caller
                    .endings
                    .iter()
                    .any(|ending| name.ends_with(ending.as_str()))
        };
        let computed = all.callers.iter().filter(may_name);
        let may_mean =
            |caller: &&Caller| caller.computes_the_file() || packages.may_mean(&caller.path, file);
        named.chain(computed).filter(may_mean).cloned().collect()
    }

    /// What is known of the sources around a file.
    fn around(&self, file: &Path, packages: &Packages) -> Option<Arc<Uses>> {
        let top = packages.sources_around(file)?;
        Some(
            self.below
                .get(top.clone(), || Arc::new(search(&packages.vfs, &top))),
        )
    }

    /// The files around `file` that may belong to robots, by their names: SRDF, YAML, what MoveIt's setup assistant wrote.
    pub fn beside(&self, file: &Path, packages: &Packages) -> Vec<PathBuf> {
        self.around(file, packages)
            .map_or_else(Vec::new, |all| all.beside.clone())
    }

    /// The descriptions around `file`, in the order of their paths.
    pub fn descriptions(&self, file: &Path, packages: &Packages) -> Arc<Vec<PathBuf>> {
        let all = self.around(file, packages);
        all.map(|all| all.sorted.clone()).unwrap_or_default()
    }

    /// Whether a file that names the description `file` also says `word`.
    pub fn mention(&self, file: &Path, word: &str, packages: &Packages) -> bool {
        let says = |caller: &Caller| {
            packages
                .vfs
                .text(&caller.path)
                .is_ok_and(|text| read::has_name(&text.text, word))
        };
        self.of(file, packages).iter().any(says)
    }

    /// Whether a file that names the description `file` also holds `text`, letter for letter.
    pub fn quote(&self, file: &Path, text: &str, packages: &Packages) -> bool {
        let holds = |caller: &Caller| {
            packages
                .vfs
                .text(&caller.path)
                .is_ok_and(|file| file.text.contains(text))
        };
        self.of(file, packages).iter().any(holds)
    }

    /// Whether a file names the description `file`.
    pub fn name(&self, file: &Path, packages: &Packages) -> bool {
        self.of(file, packages)
            .iter()
            .any(|caller| caller.descriptions.contains_key(name_of(file)))
    }

    /// Whether something that runs names the description `file`, in part at least; a page does not run.
    pub fn load(&self, file: &Path, packages: &Packages) -> bool {
        self.of(file, packages)
            .iter()
            .any(|caller| !caller.is_page() && caller.says(file))
    }

    /// Whether launch files load the description `file` to show it in RViz and for nothing else, while others simulate or plan
    /// with another description that is there.
    pub fn only_show(&self, file: &Path, packages: &Packages) -> bool {
        let launches: Vec<Caller> = self
            .of(file, packages)
            .into_iter()
            .filter(|caller| caller.is_launch() && caller.says(file))
            .collect();
        let simulates_another = |all: Arc<Uses>| {
            let mut others = all
                .callers
                .iter()
                .filter(|caller| caller.is_launch() && caller.simulates);
            others.any(|caller| all.has_another(caller, file, packages))
        };
        !launches.is_empty()
            && launches
                .iter()
                .all(|caller| caller.shows && !caller.simulates)
            && self.around(file, packages).is_some_and(simulates_another)
    }

    /// The xacro that the launch files are for that load the description `file`: the latest of them.
    pub fn era(&self, file: &Path, packages: &Packages) -> Era {
        let all = self.of(file, packages);
        let era = |caller: &Caller| if caller.is_launch() { caller.era } else { None };
        let own = all
            .iter()
            .filter(|caller| caller.says(file))
            .filter_map(era)
            .max();
        // a file that no launch file names is for the xacro that those around it run, in its package before others
        let package = packages.containing(file).map(|package| package.folder);
        let around = || {
            let all = self.around(file, packages)?;
            let is_near = |caller: &&Caller| {
                package
                    .as_ref()
                    .is_some_and(|folder| caller.path.starts_with(folder))
            };
            let near = all.callers.iter().filter(is_near).filter_map(era).max();
            near.or_else(|| all.callers.iter().filter_map(era).max())
        };
        own.or_else(around).unwrap_or(Era::Any)
    }

    /// Whether programs load the description `file` into Bullet, and no launch file does. Where no program names a description
    /// that belongs to no package, those around it count that load others.
    pub fn load_in_bullet(&self, file: &Path, packages: &Packages) -> bool {
        let all = self.of(file, packages);
        let is_free =
            |caller: &Caller| !caller.says(file) || !caller.is_launch() && !caller.is_program();
        if all.iter().all(is_free) && packages.containing(file).is_none() {
            return self
                .around(file, packages)
                .is_some_and(|uses| uses.callers.iter().any(|one| one.is_bullet));
        }
        let mut loaders = all
            .iter()
            .filter(|caller| caller.says(file) && (caller.is_launch() || caller.is_program()))
            .peekable();
        loaders.peek().is_some() && loaders.all(|caller| caller.is_bullet && !caller.is_launch())
    }

    /// Whether a launch file may mean the description `file`.
    pub fn launch(&self, file: &Path, packages: &Packages) -> bool {
        self.of(file, packages).iter().any(Caller::is_launch)
    }

    /// Whether a launch file around `file` loads a description that is there.
    pub fn launch_any(&self, file: &Path, packages: &Packages) -> bool {
        self.around(file, packages).is_some_and(|all| {
            let launches = all.callers.iter().filter(|caller| caller.is_launch());
            launches
                .flat_map(|caller| caller.descriptions.keys())
                .any(|name| all.files.contains_key(name))
        })
    }

    /// The names of the descriptions in the package of `file` that launch files, programs and build files load instead: none where the file itself
    /// is named somewhere, or the launch files take the name of any and it `may_be_given`.
    pub fn launched_instead(
        &self,
        file: &Path,
        packages: &Packages,
        may_be_given: bool,
    ) -> FastSet<String> {
        let takes = |caller: &Caller| may_be_given && caller.is_open && caller.is_launch();
        let may_mean = |caller: &Caller| caller.says(file) || takes(caller);
        let is_free = || !self.of(file, packages).iter().any(may_mean);
        let all = packages
            .containing(file)
            .and_then(|_| self.around(file, packages));
        let Some(all) = all.filter(|_| is_free()) else {
            return FastSet::default();
        };
        let is_loader = |caller: &&Caller| caller.may_load(file, packages);
        let launches = all.callers.iter().filter(is_loader);
        launches
            .flat_map(|caller| caller.descriptions.keys().cloned())
            .collect()
    }

    /// Whether `file` lies in no package and no text of the workspace may mean it, while launch files load other
    /// descriptions that are there: a copy of something, or what another program has left.
    pub fn pass_over(&self, file: &Path, packages: &Packages) -> bool {
        let all = self
            .around(file, packages)
            .filter(|_| packages.containing(file).is_none());
        let Some(all) = all else { return false };
        let may_mean = |caller: &Caller| {
            all.names(caller, file, packages, false) && !caller.is_trial()
                || caller.ends(file)
                || caller.is_open && packages.may_mean(&caller.path, file)
        };
        let loads_another = |caller: &&Caller| all.has_another(caller, file, packages);
        let has = |is_loader: fn(&Caller) -> bool| {
            all.callers
                .iter()
                .filter(|caller| is_loader(caller))
                .any(|caller| loads_another(&caller))
        };
        // without launch files, programs load robots
        !all.callers.iter().any(may_mean)
            && (has(Caller::is_launch)
                || !all.callers.iter().any(Caller::is_launch) && has(Caller::is_program))
    }

    /// Forget what was found: files have come, gone or changed.
    pub fn forget(&self) {
        self.below.clear();
        self.called.clear();
        self.copies.clear();
        self.mentions.clear();
    }
}

impl Caller {
    /// Whether the text runs xacro, as far as it says.
    pub fn runs_xacro(&self) -> bool {
        self.era.is_some()
    }

    /// Whether the text names a description, or the end of its name.
    fn says(&self, file: &Path) -> bool {
        self.descriptions.contains_key(name_of(file)) || self.ends(file)
    }

    /// Whether the text names the end of the name of a description.
    fn ends(&self, file: &Path) -> bool {
        let is_end =
            |ending: &String| !ending.is_empty() && name_of(file).ends_with(ending.as_str());
        self.endings.iter().any(is_end)
    }

    /// Whether this is a file to be read, not run.
    fn is_page(&self) -> bool {
        read::is_page(&self.path)
    }

    /// Whether this is a program, and no test of one.
    fn is_program(&self) -> bool {
        read::is_program(&self.path)
    }

    /// Whether this is a launch file, by its name or folder.
    fn is_launch(&self) -> bool {
        let name = self
            .path
            .file_name()
            .and_then(|name| name.to_str())
            .unwrap_or("");
        let folder = self.path.parent().and_then(Path::file_name);
        name.contains("launch")
            || folder.is_some_and(|folder| folder == "launch") && !self.is_page()
    }

    /// Whether this is a launch file to try something out, by its name.
    fn is_trial(&self) -> bool {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        self.is_launch() && name.to_lowercase().starts_with("test")
    }

    /// Whether it loads robots and may mean `file`: a launch file, or a program or build file of the same package, since programs
    /// elsewhere pick one of many.
    fn may_load(&self, file: &Path, packages: &Packages) -> bool {
        let is_own = || {
            packages
                .containing(file)
                .is_some_and(|package| self.path.starts_with(package.folder))
        };
        let is_build_file = || self.path.ends_with("CMakeLists.txt");
        self.is_launch() && packages.may_mean(&self.path, file)
            || (self.is_program() || is_build_file()) && is_own()
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
            let near = file
                .parent()
                .map(|folder| folder.parent().unwrap_or(folder));
            return near.is_some_and(|near| caller.starts_with(near));
        };
        let names_it = || {
            self.vfs
                .text(caller)
                .is_ok_and(|text| read::has_name(&text.text, &package.name))
        };
        caller.starts_with(&package.folder) || names_it()
    }

    /// The widest folder of sources around a file: the folder that is checked, or the workspace above, else the package,
    /// else the folder of the file.
    pub fn sources_around(&self, file: &Path) -> Option<PathBuf> {
        let file = without_parents(&self.vfs.absolute(file));
        let mut sources = self.source_folders(&file);
        sources.retain(|folder| file.starts_with(folder) && self.vfs.is_dir(folder));
        let widest = sources
            .into_iter()
            .min_by_key(|folder| folder.components().count());
        let package = || self.containing(&file).map(|package| package.folder);
        widest
            .or_else(package)
            .or_else(|| file.parent().map(Path::to_owned))
    }
}

fn name_of(file: &Path) -> &str {
    file.file_name()
        .and_then(|name| name.to_str())
        .unwrap_or_default()
}

/// All callers and descriptions below a folder.
fn search(vfs: &Vfs, top: &Path) -> Uses {
    let (mut files, mut uses) = (0, Uses::default());
    walk(vfs, top, &mut |path, name, is_small| {
        let fits = || name.contains(".srdf") || is_small();
        if read::is_beside(name) && uses.beside.len() < CALLER_FILES && fits() {
            uses.beside.push(path.to_owned());
        }
        if files < CALLER_FILES && read::may_call(name) {
            files += 1;
            let text = is_small().then(|| vfs.text(path).ok()).flatten();
            if let Some(file) = text {
                uses.callers.extend(read::caller(path, &file.text));
                if launch::may_call(&file.text) {
                    uses.scripts.push(path.to_owned());
                }
            }
        } else if read::is_description(name) {
            uses.files
                .entry(name.to_owned())
                .or_default()
                .push(path.to_owned());
        }
    });
    uses.callers.sort_by(|a: &Caller, b| a.path.cmp(&b.path));
    uses.scripts.sort();
    uses.beside.sort();
    let mut sorted: Vec<PathBuf> = uses.files.values().flatten().cloned().collect();
    sorted.sort();
    uses.sorted = Arc::new(sorted);
    config::inherit(&mut uses.callers);
    uses
}

/// Takes the path of a file, its name, and whether it is small enough to be read.
type Visit<'v> = dyn FnMut(&Path, &str, &dyn Fn() -> bool) + 'v;

/// Visit the files below a folder, each with its name and whether it is small enough to be read; whether that were all.
fn walk(vfs: &Vfs, top: &Path, visit: &mut Visit<'_>) -> bool {
    // a link that leads up does not make what lies beside the folder a part of it
    let mut seen: FastSet<u128> = top
        .ancestors()
        .skip(1)
        .filter_map(|folder| vfs.identity(folder))
        .collect();
    let above = seen.len();
    let mut open = vec![(top.to_owned(), 0)];
    let mut is_whole = true;
    while let Some((folder, depth)) = open.pop() {
        is_whole &= seen.len() - above <= CALLER_FOLDERS;
        if !is_whole
            || !vfs
                .identity(&folder)
                .is_some_and(|identity| seen.insert(identity))
        {
            continue;
        }
        let entries = vfs.list_dir(&folder);
        if is_cache(&entries) {
            continue;
        }
        for entry in entries.iter() {
            let path = folder.join(&entry.name);
            let passed_over = entry.name.starts_with('.')
                || is_built(&entry.name)
                || entry.name == "node_modules";
            match entry.is_dir {
                true if passed_over || depth >= CALLER_DEPTH => {}
                true => open.push((path, depth + 1)),
                false => {
                    let is_small = || vfs.size(&path).is_some_and(|size| size <= CALLER_BYTES);
                    visit(&path, &entry.name, &is_small);
                }
            }
        }
    }
    is_whole
}

#[cfg(test)]
mod read_tests;
#[cfg(test)]
mod tests;
