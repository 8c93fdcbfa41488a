//! What the texts of a workspace say: the names of its files and packages, what is started, and for which ROS it is.

use std::hash::BuildHasher;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Callers;
use super::file_names::{self, name_of};
use super::read::{self, has_any};
use super::text_words::TextWords;
use super::walk::walk;
use base::{FastMap, FastSet};
use packages::Packages;

/// Distributions whose xacro takes tags without their prefix, by the first part of their name.
const OLD: [&str; 8] = [
    "fuerte", "groovy", "hydro", "indigo", "jade", "kinetic", "lunar", "melodic",
];

/// The others.
const NEW: [&str; 13] = [
    "noetic", "ardent", "bouncy", "crystal", "dashing", "eloquent", "foxy", "galactic", "humble",
    "iron", "jazzy", "kilted", "ros2",
];

/// What the texts below a folder say, comments left out.
#[derive(Default)]
pub(super) struct TextMentions {
    /// The texts that hold the name of a file, each with the package that is written in front of it.
    files: FastMap<String, Vec<(PathBuf, Option<String>)>>,
    /// The texts that hold the name of a package, but for descriptions and what is built.
    packages: FastMap<String, Vec<PathBuf>>,
    /// The packages that descriptions name.
    read: FastSet<String>,
    /// The texts that start controllers.
    starters: Vec<PathBuf>,
    /// Whether a program builds the configuration of MoveIt from the names of packages.
    builds_moveit: bool,
    /// Whether a text that runs may find an SRDF whose name it does not spell out.
    takes_srdf: bool,
    /// Whether a text that runs may find a YAML file whose name it does not spell out.
    takes_yaml: bool,
    /// Whether a launch file or program plans or controls something, or simulates it.
    pub moves: bool,
    /// Whether a launch file navigates, or reads the sensors of a real robot.
    pub navigates: bool,
    /// Whether a launch file, a program or what configures them may publish the states of joints.
    publishes_states: bool,
    /// What texts that run something, and descriptions, say of programs, where they say something.
    says: FastMap<PathBuf, TextWords>,
    /// Whether there is a model for MuJoCo or Isaac, which they read instead of a description.
    pub has_own_model: bool,
    /// Whether a text is for a simulator that refuses a tensor that no body has.
    pub refuses: bool,
    /// Whether there is a launch file or a program.
    pub runs: bool,
    /// Whether one of them runs Gazebo.
    pub runs_gazebo: bool,
    /// Whether there is a launch file that no exporter of CAD programs wrote.
    launches_more: bool,
    /// Whether a launch file or program starts Gazebo Classic.
    pub runs_classic: bool,
    /// Whether a launch file spawns a model of SDF.
    pub spawns_models: bool,
    /// What each description says, by a number.
    described: FastMap<PathBuf, u64>,
    /// Whether a page names an old distribution, and whether one names a newer one.
    distributions: (bool, bool),
    /// Whether all texts were read.
    pub is_whole: bool,
}

impl Callers {
    /// Whether a text in the sources around a file holds its name; also where not all texts are known.
    pub fn mention_file(&self, file: &Path) -> bool {
        self.mention_file_in(file, |_| true)
    }

    /// Whether one of these texts does.
    fn mention_file_in(&self, file: &Path, is_one: impl Fn(&Path) -> bool) -> bool {
        let own = self.packages.containing(file);
        let is_its = |(path, package): (&Path, Option<&str>)| {
            let own = own.as_ref().map(|package| package.name.as_str());
            (package.is_none() || own.is_none() || package == own) && is_one(path)
        };
        let is_it = |mentions: Arc<TextMentions>| {
            !mentions.is_whole || mentions.with_packages(file).any(is_its)
        };
        self.mentions(file).is_none_or(is_it)
    }

    /// Whether nothing around a launch file publishes the states of joints: robot_state_publisher publishes those alone that do not
    /// move.
    pub fn leave_joints_alone(&self, launch: &Path) -> bool {
        self.mentions(launch).is_some_and(|mentions| {
            // what simulates or controls publishes them where a description or program says so
            let mut all = mentions.says.values();
            mentions.is_whole
                && !mentions.publishes_states
                && !(mentions.moves && all.any(|words| words.may_move_joints()))
        })
    }

    /// Whether there are launch files or programs around a YAML file, and none of them can load it: the name is in no text but in
    /// launch files for ROS 1 in packages for ROS 2, and no text puts such a name together.
    pub fn leave_yaml_alone(&self, file: &Path) -> bool {
        let may_run = |path: &Path| {
            let is_of_ros1 = path.extension().is_some_and(|ending| ending == "launch");
            !(is_of_ros1 && self.packages.is_for_ament(path))
        };
        let none_finds_it = |mentions: Arc<TextMentions>| mentions.runs && !mentions.takes_yaml;
        !self.mention_file_in(file, may_run) && self.mentions(file).is_some_and(none_finds_it)
    }

    /// Whether a program around a file builds the configuration of MoveIt, which finds descriptions by itself.
    pub fn build_for_moveit(&self, file: &Path) -> bool {
        self.mentions(file)
            .is_none_or(|mentions| mentions.builds_moveit)
    }

    /// Whether a program builds the configuration of MoveIt of the package around a file: one in the package, or that names it.
    pub fn build_package_for_moveit(&self, file: &Path) -> bool {
        let package = self.packages.containing(file);
        let (Some(mentions), Some(package)) = (self.mentions(file), package) else {
            return true;
        };
        let names_it = |path: &Path| mentions.uses(&package.name).any(|by| by == path);
        let mut builders = mentions
            .says
            .iter()
            .filter(|(_, words)| words.builds_moveit());
        builders.any(|(path, _)| path.starts_with(&package.folder) || names_it(path))
    }

    /// Whether no text around an SRDF holds its name, and none that runs puts the name of one together.
    pub fn leave_srdf_alone(&self, file: &Path) -> bool {
        self.mentions(file).is_some_and(|mentions| {
            mentions.is_whole
                && !mentions.takes_srdf
                && !mentions.builds_moveit
                && mentions.of(file).next().is_none()
        })
    }

    /// Whether the pages around a file name only distributions whose xacro takes tags without their prefix, or it belongs to a
    /// container or an installation with one of these.
    pub fn is_for_old_ros(&self, file: &Path) -> bool {
        self.mentions(file).is_some_and(|mentions| {
            is_run_in_old(file, &self.packages)
                || is_installed_for_old(file, &self.packages)
                || mentions.distributions == (true, false)
                || !mentions.distributions.1 && is_edited_for_old(file, &self.packages)
        })
    }

    /// The texts around a file that start controllers.
    pub fn starters(&self, file: &Path) -> Vec<PathBuf> {
        self.mentions(file)
            .map_or_else(Vec::new, |mentions| mentions.starters.clone())
    }

    /// What the texts in the sources around a file say.
    pub(super) fn mentions(&self, file: &Path) -> Option<Arc<TextMentions>> {
        // whoever asks at the same time waits, and does not get what was said before the edit
        let mut edited = self.edited();
        let paths = std::mem::take(&mut *edited);
        paths.iter().for_each(|path| self.mention_again(path));
        drop(edited);
        let top = self.packages.sources_around(file)?;
        Some(self.mentions.get(top.clone(), || {
            Arc::new(TextMentions::below(&top, &self.packages))
        }))
    }
}

impl Callers {
    /// Forget what the texts around a description say where it says something else than before.
    fn mention_again(&self, path: &Path) {
        let Some(top) = self.packages.sources_around(path) else {
            return;
        };
        let Some(known) = self.mentions.known(&top) else {
            return;
        };
        let text = self.packages.vfs().text(path);
        let names = names_below(&top, &self.packages);
        let now = text.map(|file| TextMentions::of_description(path, &file.text, &names).mark());
        if now.ok().as_ref() != known.described.get(path) {
            self.mentions.remove(&top);
        }
    }
}

/// The names of the packages below a folder.
fn names_below(top: &Path, packages: &Packages) -> FastSet<String> {
    let all = packages.below(top).into_iter();
    all.map(|(name, _)| name).collect()
}

impl TextMentions {
    fn below(top: &Path, packages: &Packages) -> Self {
        let mut found = Self::default();
        let names = names_below(top, packages);
        found.is_whole = walk(packages.vfs(), top, &mut |path, name, is_small| {
            let is_read =
                (file_names::is_description(name) || file_names::may_call(name)) && is_small();
            if let Some(text) = is_read.then(|| packages.vfs().text(path).ok()).flatten() {
                if file_names::is_description(name) {
                    let own = Self::of_description(path, &text.text, &names);
                    found.described.insert(path.to_owned(), own.mark());
                    found.merge(own);
                } else {
                    found.add_generation(path, &text.text);
                    let runs_classic = found.runs_classic;
                    found.add(path, &read::without_comments(name, &text.text), &names);
                    // ROS 2 cannot run a launch file of ROS 1
                    let is_of_ros1 = path.extension().is_some_and(|ending| ending == "launch");
                    if is_of_ros1 && packages.is_for_ament(path) {
                        found.runs_classic = runs_classic;
                    }
                }
            }
        });
        found.starters.sort();
        found
    }

    /// What one description says.
    fn of_description(path: &Path, text: &str, names: &FastSet<String>) -> Self {
        let mut own = Self::default();
        own.add_generation(path, text);
        own.add(path, &read::without_comments(name_of(path), text), names);
        own
    }

    /// What a description says, by a number.
    fn mark(&self) -> u64 {
        let mut files: Vec<_> = self.files.iter().collect();
        files.sort_unstable();
        let mut read: Vec<_> = self.read.iter().collect();
        read.sort_unstable();
        let mut words: Vec<_> = self.says.iter().collect();
        words.sort_unstable_by_key(|(path, _)| *path);
        let flags = (self.has_own_model, self.refuses, self.distributions);
        self.says.hasher().hash_one((files, read, words, flags))
    }

    /// Add what another description says.
    #[allow(clippy::iter_over_hash_type)] // lists of one name get one path at a time
    fn merge(&mut self, own: Self) {
        for (name, paths) in own.files {
            self.files.entry(name).or_default().extend(paths);
        }
        self.read.extend(own.read);
        self.says.extend(own.says);
        self.has_own_model |= own.has_own_model;
        self.refuses |= own.refuses;
        self.distributions.0 |= own.distributions.0;
        self.distributions.1 |= own.distributions.1;
    }

    /// Add what one text says.
    fn add(&mut self, path: &Path, text: &str, names: &FastSet<String>) {
        let is_description = file_names::is_description(name_of(path));
        let is_page = file_names::is_page(path);
        let words = TextWords::of(text);
        let is_run = !is_description && !is_page;
        self.moves |= is_run && words.simulates();
        self.publishes_states |= is_run && words.publishes_states();
        self.has_own_model |= words.is_own_model();
        self.refuses |= !is_page && words.refuses();
        let may_start =
            !is_description && (name_of(path).contains("launch") || file_names::is_program(path));
        self.runs |= may_start;
        self.navigates |= may_start && words.navigates();
        self.runs_gazebo |= may_start && words.runs_gazebo();
        // the exporter writes it beside the other one
        let is_exported = words.is_exported() || name_of(path) == "display.launch";
        self.launches_more |= name_of(path).contains("launch") && !is_exported;
        self.runs_classic |= may_start && words.runs_classic();
        self.spawns_models |= name_of(path).contains("launch") && words.spawns_model();
        self.builds_moveit |= is_run && words.builds_moveit();
        if is_run && words.starts_controllers() {
            self.starters.push(path.to_owned());
        }
        if !is_page && words != TextWords::default() {
            self.says.insert(path.to_owned(), words);
        }
        let is_use = !is_description && !path.ends_with("CMakeLists.txt");
        let mut seen: FastSet<(&str, Option<String>)> = FastSet::default();
        let mut end = 0;
        for part in text.split_inclusive(|c| !read::is_name(c)) {
            let start = end;
            end += part.len();
            let word = without_ends(part);
            if word.is_empty() {
                continue;
            }
            self.takes_srdf |= is_use && !is_page && word == "srdf";
            self.takes_yaml |= is_use && !is_page && is_end_of_yaml(part);
            let is_package = is_use && names.contains(word);
            // in `package://name/` and `$(find name)`
            if is_description && names.contains(word) && part.ends_with(['/', ')']) {
                self.read.insert(word.to_owned());
            }
            let is_file = word.contains('.') && word.contains(char::is_alphabetic);
            if is_page {
                self.add_distribution(word);
            }
            if !(is_package || is_file) {
                continue;
            }
            let lead = text.get(..start).filter(|_| is_file);
            let package = lead.and_then(read::package_of);
            if !seen.insert((word, package.clone())) {
                continue;
            }
            if is_package {
                self.packages
                    .entry(word.to_owned())
                    .or_default()
                    .push(path.to_owned());
            }
            if is_file {
                self.files
                    .entry(word.to_owned())
                    .or_default()
                    .push((path.to_owned(), package));
            }
        }
    }

    /// Add what a program says by the Python that it is for, and a description by the elements that Gazebo read before 2012.
    fn add_generation(&mut self, path: &Path, text: &str) {
        const PYTHON_2: [&str; 4] = ["python2", "from Tkinter ", "import Tkinter", "raw_input("];
        const OLD_GAZEBO: [&str; 2] = ["<sensor:", "<controller:"];
        // programs that ROS Noetic has no more
        const OLD_PROGRAMS: [&str; 2] = ["/xacro.py", "type=\"state_publisher\""];
        let is_launch = path.extension().is_some_and(|ending| ending == "launch");
        let is_python = path.extension().is_some_and(|ending| ending == "py");
        self.distributions.0 |=
            is_launch && has_any(text, &OLD_PROGRAMS) || names_install(text, &OLD);
        self.distributions.1 |= names_install(text, &NEW);
        self.distributions.0 |= is_python && (has_any(text, &PYTHON_2) || text.lines().any(prints))
            || file_names::is_description(name_of(path)) && has_any(text, &OLD_GAZEBO);
        self.distributions.1 |= is_python && has_any(text, &["python3", "rclpy", "ament_"]);
    }

    fn add_distribution(&mut self, word: &str) {
        // no distribution has a shorter or longer name
        let parts = word
            .split(['-', '_', '.'])
            .filter(|part| (4..=9).contains(&part.len()));
        for part in parts {
            self.distributions.0 |= is_one_of(part, &OLD);
            self.distributions.1 |= is_one_of(part, &NEW);
        }
    }

    /// Whether a text needs the masses and inertia of descriptions, or is a description for Gazebo. MuJoCo and Isaac need them where
    /// they have no model of their own.
    pub fn weighs(&self, path: &Path) -> bool {
        let words = self.words(path);
        if file_names::is_description(name_of(path)) {
            words.is_for_gazebo()
        } else {
            words.weighs() || words.weighs_unless_own() && !self.has_own_model
        }
    }

    /// Whether a text is a launch file for Gazebo that an exporter of CAD programs wrote.
    pub fn is_exported(&self, path: &Path) -> bool {
        self.words(path).is_exported()
    }

    /// Whether a text computes with the triangles of collision meshes.
    pub fn meets(&self, path: &Path) -> bool {
        !file_names::is_description(name_of(path)) && self.words(path).meets()
    }

    /// Whether a text starts Gazebo Classic.
    pub fn starts_classic(&self, path: &Path) -> bool {
        !file_names::is_description(name_of(path)) && self.words(path).runs_classic()
    }

    /// Whether a text runs controllers.
    pub fn controls(&self, path: &Path) -> bool {
        !file_names::is_description(name_of(path)) && self.words(path).controls()
    }

    /// What a text says of programs that take descriptions, unless it is one that an exporter wrote.
    fn words(&self, path: &Path) -> TextWords {
        let words = self.says.get(path).copied().unwrap_or_default();
        if words.spawns_only_models() || self.is_export(path) {
            TextWords::default()
        } else {
            words
        }
    }

    /// The texts that need the masses and inertia of descriptions.
    pub fn simulators(&self) -> impl Iterator<Item = &Path> {
        let paths = self.says.keys().map(PathBuf::as_path);
        paths.filter(|path| self.weighs(path))
    }

    /// Whether a launch file is one that an exporter of CAD programs writes beside each description, and nothing starts it: the robot
    /// has a model for another simulator, or people wrote launch files of their own.
    fn is_export(&self, path: &Path) -> bool {
        let is_exported = || {
            let is_marked = self.says.get(path).is_some_and(|words| words.is_exported());
            is_marked && self.names_own_package(path)
        };
        let is_passed_over = self.has_own_model || self.launches_more && is_exported();
        let is_of_its_package = |package: &str| path.iter().any(|folder| folder == package);
        let mut named = self.with_packages(path);
        is_passed_over
            && name_of(path) == "gazebo.launch"
            && !named.any(|(_, package)| package.is_none_or(is_of_its_package))
    }

    /// Whether a text holds the name of a package that is also that of a folder around it.
    fn names_own_package(&self, path: &Path) -> bool {
        let mut folders = path.iter().filter_map(|folder| folder.to_str());
        folders.any(|folder| {
            let named_by = self.packages.get(folder);
            named_by.is_some_and(|texts| texts.iter().any(|text| text == path))
        })
    }

    /// The texts other than a file itself that hold its name.
    pub fn of(&self, file: &Path) -> impl Iterator<Item = &Path> {
        self.with_packages(file).map(|(path, _)| path)
    }

    /// The texts other than a file itself that hold its name, each with the package that it writes in front of it.
    fn with_packages(&self, file: &Path) -> impl Iterator<Item = (&Path, Option<&str>)> {
        let all = self.files.get(name_of(file)).into_iter().flatten();
        let own = file.to_owned();
        all.filter(move |(path, _)| *path != own)
            .map(|(path, package)| (path.as_path(), package.as_deref()))
    }

    /// Whether a description names a package.
    pub fn is_read(&self, package: &str) -> bool {
        self.read.contains(package)
    }

    /// Whether any text names a package.
    pub fn is_named(&self, package: &str) -> bool {
        self.uses(package).next().is_some() || self.is_read(package)
    }

    /// The texts that hold the name of a package, but for descriptions and what is built.
    pub fn uses(&self, package: &str) -> impl Iterator<Item = &Path> {
        self.packages
            .get(package)
            .into_iter()
            .flatten()
            .map(PathBuf::as_path)
    }
}

/// A part of a text without the character behind the word, and without dots and dashes around that. Most words have none.
fn without_ends(part: &str) -> &str {
    let is_edge = |byte: Option<&u8>| matches!(byte, Some(b'.' | b'-'));
    let word = match part.as_bytes() {
        [.., last] if last.is_ascii() && !read::is_name(char::from(*last)) => {
            part.get(..part.len() - 1).unwrap_or_default()
        }
        [.., last] if last.is_ascii() => part,
        _ => part.trim_end_matches(|c| !read::is_name(c)),
    };
    let bytes = word.as_bytes();
    if is_edge(bytes.first()) || is_edge(bytes.last()) {
        word.trim_matches(['.', '-'])
    } else {
        word
    }
}

/// Whether a part of a text is the end of the name of a YAML file: `.yaml` or `_controllers.yaml`.
fn is_end_of_yaml(part: &str) -> bool {
    let word = part.trim_end_matches(|c| !read::is_name(c));
    word.starts_with(['.', '_']) && (word.ends_with(".yaml") || word.ends_with(".yml"))
}

/// Whether a word is one of these names, in letters of either case.
fn is_one_of(word: &str, names: &[&str]) -> bool {
    names.iter().any(|name| word.eq_ignore_ascii_case(name))
}

/// Whether the nearest `Dockerfile` in a folder above a file installs an old distribution, and no newer one.
fn is_run_in_old(file: &Path, packages: &Packages) -> bool {
    let Some(top) = packages.sources_around(file) else {
        return false;
    };
    let mut paths = file
        .ancestors()
        .skip(1)
        .take_while(|folder| folder.starts_with(&top))
        .map(|folder| folder.join("Dockerfile"));
    let nearest = paths.find(|path| packages.vfs().is_file(path));
    nearest.is_some_and(|path| packages.is_text(&path, installs_old))
}

/// Whether the page or a script at the top of the sources around a file installs or sets up an old distribution, and none there a
/// newer one: these say more than the pages of packages that were copied.
fn is_installed_for_old(file: &Path, packages: &Packages) -> bool {
    let Some(top) = packages.sources_around(file) else {
        return false;
    };
    let names = packages.vfs().list_dir(&top);
    let mut texts = names
        .iter()
        .filter(|entry| entry.name.starts_with("README") || entry.name.ends_with(".sh"))
        .filter_map(|entry| packages.vfs().text(&top.join(&entry.name)).ok())
        .filter(|file| installs(&file.text, &OLD) || installs(&file.text, &NEW))
        .peekable();
    texts.peek().is_some() && texts.all(|file| installs_old(&file.text))
}

/// Whether a line of Python prints by a statement, which is a function in Python 3.
fn prints(line: &str) -> bool {
    let printed = line.trim_start().strip_prefix("print ");
    printed
        .is_some_and(|what| what.starts_with(|c: char| c.is_alphanumeric() || "\"'_".contains(c)))
}

/// Whether a text has a path into the installation of one of these distributions.
fn names_install(text: &str, names: &[&str]) -> bool {
    let mut installs = text.split("/opt/ros/").skip(1);
    installs.any(|rest| names.iter().any(|name| rest.starts_with(name)))
}

/// Whether a text installs or sets up an old distribution, and no newer one.
fn installs_old(text: &str) -> bool {
    installs(text, &OLD) && !installs(text, &NEW)
}

/// Whether a text installs or sets up one of these distributions.
fn installs(text: &str, names: &[&str]) -> bool {
    const BEFORE: [&str; 3] = ["ros-", "ros:", "/opt/ros/"];
    BEFORE.iter().any(|before| {
        names
            .iter()
            .any(|name| text.contains(&format!("{before}{name}")))
    })
}

/// Whether an editor was set up for an old distribution, in the folder of sources around a file.
fn is_edited_for_old(file: &Path, packages: &Packages) -> bool {
    let Some(folder) = packages.sources_around(file).map(|top| top.join(".vscode")) else {
        return false;
    };
    packages.vfs().list_dir(&folder).iter().any(|entry| {
        entry.name.ends_with(".json")
            && packages.is_text(&folder.join(&entry.name), |text| {
                OLD.iter()
                    .any(|name| text.contains(&format!("/opt/ros/{name}")))
            })
    })
}
