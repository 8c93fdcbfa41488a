//! What the launch files and programs of a workspace use a description for.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Callers;
use super::caller::Caller;
use super::file_names::{self, name_of};
use super::meant::may_mean;
use super::mentions::TextMentions;
use super::read::{has_any, has_name};
use super::uses::Uses;
use crate::include_pattern::admitted_files;
use base::FastSet;
use packages::Packages;
use vfs::Vfs;

/// Whether a text runs something: no page, no list of what is installed, no launch file of ROS 1 in a package for ROS 2.
fn is_run(path: &Path, packages: &Packages) -> bool {
    let is_no_call = file_names::is_page(path) || path.ends_with("CMakeLists.txt");
    !(is_no_call || is_of_ros1(path, packages))
}

/// Whether a launch file is for ROS 1 in a package for ROS 2.
fn is_of_ros1(path: &Path, packages: &Packages) -> bool {
    // what roslaunch alone understands
    const OWN: [&str; 3] = ["<rosparam", "$(find ", " textfile=\""];
    let name = name_of(path);
    let says = || packages.is_text(path, |text| has_any(text, &OWN));
    (name.ends_with(".launch") || name.ends_with(".launch.xml") && says())
        && packages.is_for_ament(path)
}

/// What is done with a description by the texts that load it and those that start them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Purpose {
    /// Whether a launch file, a program or what configures them loads it.
    pub is_loaded: bool,
    /// Whether one of these texts needs masses and inertia.
    pub is_weighed: bool,
    /// Whether one of these texts computes with the triangles of its collision meshes.
    pub is_met: bool,
    /// Whether one of these texts runs controllers.
    pub is_controlled: bool,
    /// Whether nobody else is expected to use it: a program loads it, or launch files and programs around it plan, control or
    /// simulate. What is only shown may be simulated by others.
    pub is_applied: bool,
}

/// Whether a text names another description in the package of a file.
fn is_another_named(all: &Uses, file: &Path, packages: &Packages) -> bool {
    let Some(package) = packages.containing(file) else {
        return false;
    };
    all.callers.iter().any(|caller| {
        let names = caller.descriptions.keys();
        let mut files = names.filter_map(|name| all.files.get(name)).flatten();
        files.any(|other| {
            other != file
                && other.starts_with(&package.folder)
                && all.names(caller, other, packages, true)
        })
    })
}

/// Whether at least half of the lines of a text are in another one.
fn is_copy(vfs: &Vfs, file: &Path, other: &Path) -> bool {
    let (Ok(own), Ok(other)) = (vfs.text(file), vfs.text(other)) else {
        return false;
    };
    let known: FastSet<&str> = other.text.lines().map(str::trim).collect();
    let lines = || {
        own.text
            .lines()
            .map(str::trim)
            .filter(|line| !line.is_empty())
    };
    lines().filter(|line| known.contains(line)).count() * 2 >= lines().count()
}

impl Purpose {
    /// Add what a text does with a description that it loads, or starts what loads it.
    fn add(&mut self, path: &Path, mentions: &TextMentions) {
        self.is_weighed |= mentions.weighs(path);
        self.is_met |= mentions.meets(path);
        self.is_controlled |= mentions.controls(path);
        if !file_names::is_description(name_of(path)) {
            self.is_loaded = true;
            self.is_applied |= file_names::is_program(path) && !file_names::is_launch(path);
        }
    }

    /// What is done with one of two descriptions.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self {
            is_loaded: self.is_loaded || other.is_loaded,
            is_weighed: self.is_weighed || other.is_weighed,
            is_met: self.is_met || other.is_met,
            is_controlled: self.is_controlled || other.is_controlled,
            is_applied: self.is_applied || other.is_applied,
        }
    }
}

impl Callers {
    /// What is done with the description `file`, alone or as a part of others, by texts that are not left over; none where not all
    /// texts around it are known.
    pub fn purpose(&self, file: &Path, is_left_over: impl Fn(&Path) -> bool) -> Option<Purpose> {
        let mentions = self.mentions(file).filter(|mentions| mentions.is_whole)?;
        let mut purpose = Purpose {
            is_applied: mentions.moves || mentions.navigates,
            ..Purpose::default()
        };
        let mut open = self.loaders(file, &mentions);
        // an exporter writes launch files beside each robot: where a program loads it, it is for that
        let is_program =
            |path: &PathBuf| file_names::is_program(path) && !file_names::is_launch(path);
        let has_program = open.iter().any(is_program);
        open.retain(|path| !(has_program && mentions.is_exported(path)));
        let mut seen: FastSet<PathBuf> = FastSet::default();
        while let Some(path) = open.pop() {
            let is_passed_over = !is_run(&path, &self.packages) || is_left_over(&path);
            if is_passed_over || !seen.insert(path.clone()) {
                continue;
            }
            purpose.add(&path, &mentions);
            open.extend(self.loaders(&path, &mentions));
        }
        if purpose.is_loaded && !purpose.is_weighed {
            for path in self.simulators_beside(file, &seen, &mentions) {
                purpose.add(path, &mentions);
            }
        }
        Some(purpose)
    }

    /// Whether a launch file is for ROS 1 in a package for ROS 2: nobody can run it.
    pub fn is_launch_of_ros1(&self, path: &Path) -> bool {
        is_of_ros1(path, &self.packages)
    }

    /// Whether a launch file or program around a description needs masses and inertia of one.
    pub fn simulate_any(&self, file: &Path) -> bool {
        self.mentions(file).is_some_and(|mentions| {
            let mut simulators = mentions.simulators();
            simulators.any(|path| {
                is_run(path, &self.packages) && !file_names::is_description(name_of(path))
            })
        })
    }

    /// Whether a description has something that only Gazebo runs.
    pub fn is_for_gazebo(&self, file: &Path) -> bool {
        self.mentions(file)
            .is_some_and(|mentions| mentions.weighs(file))
    }

    /// The texts that name a file, compute a part of its name, or take any: the last where no text names another description of its
    /// package.
    fn loaders(&self, file: &Path, mentions: &TextMentions) -> Vec<PathBuf> {
        let named = mentions
            .of(file)
            .filter(|by| may_mean(by, file, &self.packages));
        let mut found: Vec<PathBuf> = named.map(Path::to_owned).collect();
        if let Some(all) = self
            .around(file)
            .filter(|_| file_names::is_description(name_of(file)))
        {
            let is_another_named = is_another_named(&all, file, &self.packages);
            let loads = |caller: &&Caller| {
                caller.ends_in_word(file)
                    || caller.ends_for_one(file, &all, &self.packages)
                    || !is_another_named
                        && (caller.ends(file) || caller.is_open && caller.is_launch())
            };
            let callers = all.callers.iter().filter(loads).map(|caller| &caller.path);
            let may_mean = |by: &&PathBuf| may_mean(by, file, &self.packages);
            found.extend(callers.filter(may_mean).cloned());
        }
        found
    }

    /// Launch files and programs that need masses of a robot without naming one, in the &self.packages of a description and of the launch
    /// files that load it: they take what a topic or parameter holds.
    fn simulators_beside<'m>(
        &self,
        file: &Path,
        loaders: &FastSet<PathBuf>,
        mentions: &'m TextMentions,
    ) -> Vec<&'m Path> {
        let folders: FastSet<PathBuf> = loaders
            .iter()
            .filter(|path| file_names::is_launch(path))
            .map(PathBuf::as_path)
            .chain([file])
            .filter_map(|path| Some(self.packages.containing(path)?.folder))
            .collect();
        let Some(uses) = self.around(file) else {
            return Vec::new();
        };
        let names_one = |path: &Path| {
            uses.callers
                .iter()
                .any(|caller| caller.path == path && !caller.descriptions.is_empty())
        };
        let simulators = mentions
            .simulators()
            .filter(|path| file_names::is_launch(path) || file_names::is_program(path));
        simulators
            .filter(|path| {
                self.packages
                    .containing(path)
                    .is_some_and(|package| folders.contains(&package.folder))
                    && !names_one(path)
                    && !self.is_started_with_another(path, file, (&uses, mentions))
            })
            .collect()
    }

    /// Whether the launch files that start another one load descriptions beside it, and `file` is none of them.
    fn is_started_with_another(
        &self,
        launch: &Path,
        file: &Path,
        (uses, mentions): (&Uses, &TextMentions),
    ) -> bool {
        let starters = self.starters_of(launch, mentions);
        let starts_with = |caller: &Caller| {
            let own = self.starters_of(&caller.path, mentions);
            own.iter().any(|path| starters.contains(path))
        };
        let is_beside = |caller: &&Caller| caller.is_launch() && starts_with(caller);
        let mut beside = uses.callers.iter().filter(is_beside).peekable();
        let mut is_another = false;
        beside.all(|caller| {
            is_another |= uses.has_another(caller, file, &self.packages);
            let computes = caller.is_open || caller.ends_in_word(file) || caller.ends(file);
            !(computes || uses.names(caller, file, &self.packages, false))
        }) && is_another
            && !self.is_selected(file, uses)
    }

    /// Whether an include with a computed name may bring a file into a description that something loads: what is done with that one is
    /// done with the file.
    fn is_selected(&self, file: &Path, uses: &Uses) -> bool {
        let loaders = uses.callers.iter().filter(|caller| !caller.is_page());
        let mut loaded = loaders.flat_map(|caller| uses.others(caller, file, &self.packages));
        loaded.any(|description| self.selects(description, file))
    }

    /// Whether an include with a computed name in a description may bring in a file.
    fn selects(&self, description: &Path, file: &Path) -> bool {
        let vfs = self.packages.vfs();
        let Ok(source) = vfs.document(description) else {
            return false;
        };
        let items = source.document.parts();
        let includes = items
            .flat_map(|(_, item)| item.all_nodes())
            .filter(|node| node.name() == "xacro:include");
        let mut names = includes.filter_map(|node| Some(node.attr("filename")?.raw()));
        names.any(|name| {
            let files = admitted_files(name, description, &self.packages, vfs);
            files.iter().any(|admitted| admitted == file)
        })
    }

    /// A launch file with those that include it, and those that include these.
    fn starters_of(&self, launch: &Path, mentions: &TextMentions) -> FastSet<PathBuf> {
        let mut open = vec![launch.to_owned()];
        let mut seen: FastSet<PathBuf> = FastSet::default();
        while let Some(path) = open.pop() {
            if !seen.insert(path.clone()) {
                continue;
            }
            let by = mentions
                .of(&path)
                .filter(|by| file_names::is_launch(by) && may_mean(by, &path, &self.packages));
            open.extend(by.map(Path::to_owned));
        }
        seen
    }

    /// Whether launch files and programs run what lies around a file, none of them with a simulator that refuses a tensor that no body
    /// has.
    pub fn never_refuse(&self, file: &Path) -> bool {
        self.mentions(file)
            .is_some_and(|all| all.is_whole && all.runs && !all.refuses)
    }

    /// Whether a launch file starts the controllers or simulation of another description that is there, and none names this one.
    pub fn control_another(&self, file: &Path) -> bool {
        const STARTS: [&str; 4] = ["controller_manager", "ros2_control_node", "gazebo", "gz_"];
        let is_it = |all: Arc<Uses>| {
            let mut launches = all.callers.iter().filter(|caller| caller.is_launch());
            launches.any(|caller| {
                all.has_another(caller, file, &self.packages)
                    && self
                        .packages
                        .is_text(&caller.path, |text| has_any(text, &STARTS))
            })
        };
        let mut named = self.of(file).into_iter().filter(Caller::is_launch);
        !named.any(|caller| caller.says(file)) && self.around(file).is_some_and(is_it)
    }

    /// Whether nothing but launch files that spawn models of Gazebo under a name of their own load a description.
    pub fn only_spawn(&self, file: &Path) -> bool {
        const NAMES: [&str; 2] = ["-model ", "-entity"];
        const READS: [&str; 4] = [
            "robot_state_publisher",
            "move_group",
            "MoveIt",
            "controller_manager",
        ];
        let spawns = |caller: &Caller| {
            self.packages.is_text(&caller.path, |text| {
                text.contains("spawn_") && has_any(text, &NAMES) && !has_any(text, &READS)
            })
        };
        let all = self.of(file);
        let mut loaders = all
            .iter()
            .filter(|caller| caller.says(file) && !caller.is_page())
            .peekable();
        loaders.peek().is_some() && loaders.all(spawns)
    }

    /// Whether launch files around a file spawn models of SDF, and no launch file or program there loads a description.
    pub fn spawn_models_instead(&self, file: &Path) -> bool {
        let loads = |caller: &Caller| caller.is_launch() || caller.is_program();
        // to read all texts takes longer than to ask those that name descriptions
        self.around(file)
            .is_some_and(|uses| !uses.callers.iter().any(loads))
            && self
                .mentions(file)
                .is_some_and(|all| all.is_whole && all.spawns_models)
    }

    /// Whether a file lies in a package that was put aside: no text names it, and another package, which texts do name, has a
    /// file at the same place that says much the same.
    pub fn is_put_aside(&self, file: &Path) -> bool {
        let Some(own) = self.packages.containing(file) else {
            return false;
        };
        let Some(top) = self.packages.sources_around(file) else {
            return false;
        };
        let inside = file.strip_prefix(&own.folder).unwrap_or(file);
        let is_twin = |(name, folder): &(String, PathBuf)| {
            let twin = folder.join(inside);
            let vfs = self.packages.vfs();
            *name != own.name && vfs.is_file(&twin) && is_copy(vfs, file, &twin)
        };
        let mut twins = self.packages.below(&top);
        twins.retain(is_twin);
        if twins.is_empty() {
            return false;
        }
        let Some(mentions) = self.mentions(file).filter(|all| all.is_whole) else {
            return false;
        };
        !mentions.is_named(&own.name) && twins.iter().any(|(name, _)| mentions.is_named(name))
    }

    /// Whether something that loads the description `file` starts Gazebo Classic, or may do so: where nothing loads anything,
    /// others may.
    pub fn run_gazebo_classic(&self, file: &Path) -> bool {
        let Some(mentions) = self.mentions(file).filter(|all| all.is_whole) else {
            return true;
        };
        if !mentions.runs_classic {
            return false;
        }
        let mut open = self.loaders(file, &mentions);
        let mut seen: FastSet<PathBuf> = FastSet::default();
        while let Some(path) = open.pop() {
            if is_run(&path, &self.packages) && seen.insert(path.clone()) {
                open.extend(self.loaders(&path, &mentions));
            }
        }
        let mut beside = self.simulators_beside(file, &seen, &mentions).into_iter();
        // an argument may be the name without its ending
        let stem = name_of(file).split('.').next().unwrap_or_default();
        let selects = |path: &Path| self.packages.is_text(path, |text| has_name(text, stem));
        seen.iter().any(|path| mentions.starts_classic(path))
            || beside.any(|path| mentions.starts_classic(path))
            || (mentions.simulators()).any(|path| mentions.starts_classic(path) && selects(path))
    }

    /// Whether there are launch files or programs around a file.
    pub fn run_something(&self, file: &Path) -> bool {
        self.mentions(file).is_some_and(|all| all.runs)
    }
}
