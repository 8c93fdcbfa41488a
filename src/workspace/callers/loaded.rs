//! Which texts name a description or load it, and what else these say.

use std::path::Path;

use super::Callers;
use super::caller::Caller;
use super::era::Era;
use super::file_names::{self, name_of};
use super::read;

impl Callers {
    /// Whether a file names the description `file`.
    pub fn name(&self, file: &Path) -> bool {
        self.name_where(file, |_| true)
    }

    /// Whether a file that counts names the description `file`.
    pub fn name_where(&self, file: &Path, counts: impl Fn(&Path) -> bool) -> bool {
        self.of(file)
            .iter()
            .any(|caller| caller.descriptions.contains_key(name_of(file)) && counts(&caller.path))
    }

    /// Whether something that runs names the description `file`, in part at least; a page does not run.
    pub fn load(&self, file: &Path) -> bool {
        self.load_where(file, |_| true)
    }

    /// Whether something that runs and that counts names the description `file`, in part at least.
    pub fn load_where(&self, file: &Path, counts: impl Fn(&Path) -> bool) -> bool {
        self.of(file)
            .iter()
            .any(|caller| !caller.is_page() && caller.says(file) && counts(&caller.path))
    }

    /// Whether a launch file may mean the description `file`.
    pub fn launch(&self, file: &Path) -> bool {
        self.of(file).iter().any(Caller::is_launch)
    }

    /// The xacro that the launch files are for that load the description `file`: the latest of them.
    pub fn era(&self, file: &Path) -> Era {
        let all = self.of(file);
        let era = |caller: &Caller| if caller.is_launch() { caller.era } else { None };
        let own = all
            .iter()
            .filter(|caller| caller.says(file))
            .filter_map(era)
            .max();
        // a file that no launch file names is for the xacro that those around it run, in its package before others
        let package = self.packages.containing(file).map(|package| package.folder);
        let around = || {
            let all = self.around(file)?;
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

    /// Whether programs load the description `file` into Bullet, and no launch file does.
    pub fn load_in_bullet(&self, file: &Path) -> bool {
        self.load_in(file, |caller| caller.is_bullet)
    }

    /// Whether a program loads the description `file` into Isaac Gym, or may do so with one in no package, and no launch file does.
    pub fn load_in_isaac(&self, file: &Path) -> bool {
        let all = self.of(file);
        let mut loaders = all.iter().filter(|caller| caller.says(file));
        !loaders.clone().any(Caller::is_launch)
            && (loaders.any(|caller| caller.is_isaac)
                || self.packages.containing(file).is_none() && self.run_isaac(file))
    }

    /// Whether a program around a file runs Isaac Gym.
    fn run_isaac(&self, file: &Path) -> bool {
        self.around(file)
            .is_some_and(|uses| uses.callers.iter().any(|caller| caller.is_isaac))
    }

    /// Whether programs around a file run Isaac Gym, and nothing there runs Gazebo.
    pub fn run_isaac_alone(&self, file: &Path) -> bool {
        let without_gazebo = || {
            self.mentions(file)
                .is_some_and(|all| all.is_whole && !all.runs_gazebo)
        };
        self.run_isaac(file) && without_gazebo()
    }

    /// Whether programs load the description `file` into RaiSim, and no launch file does.
    pub fn load_in_raisim(&self, file: &Path) -> bool {
        self.load_in(file, |caller| caller.is_raisim && !caller.is_bullet)
    }

    /// Whether programs for MATLAB load the description `file`, which looks for meshes where the call says, and nothing else does.
    pub fn load_in_matlab(&self, file: &Path) -> bool {
        let all = self.of(file);
        let is_matlab =
            |caller: &&Caller| caller.path.extension().is_some_and(|ending| ending == "m");
        let mut loaders = all
            .iter()
            .filter(|caller| caller.says(file) && !caller.is_page())
            .peekable();
        loaders.peek().is_some() && loaders.all(|caller| is_matlab(&caller))
    }

    /// Whether programs around an SRDF read such files by a library that takes only the pairs of links or the states of them, and no text
    /// is about MoveIt.
    pub fn read_srdf_without_moveit(&self, file: &Path) -> bool {
        const READERS: [&str; 3] = ["pinocchio", "mplib", "sapien"];
        const MOVEIT: [&str; 3] = ["moveit", "MoveIt", "move_group"];
        let has = |caller: &Caller, words: &[&str]| {
            self.packages
                .is_text(&caller.path, |text| read::has_any(text, words))
        };
        self.around(file).is_some_and(|uses| {
            let mut all = uses.callers.iter();
            let mut programs = all.clone().filter(|caller| caller.is_program());
            programs.any(|program| has(program, &["srdf"]) && has(program, &READERS))
                && !all.any(|caller| has(caller, &MOVEIT))
        })
    }

    /// Whether all programs that load a description are of a kind, and no launch file does. Where no program names a description
    /// that belongs to no package, those around it count that load others.
    fn load_in(&self, file: &Path, is_of_kind: impl Fn(&Caller) -> bool) -> bool {
        let all = self.of(file);
        let is_free =
            |caller: &Caller| !caller.says(file) || !caller.is_launch() && !caller.is_program();
        if all.iter().all(is_free) && self.packages.containing(file).is_none() {
            return self
                .around(file)
                .is_some_and(|uses| uses.callers.iter().any(&is_of_kind));
        }
        // tests say as well what it is for
        let runs = |caller: &Caller| {
            caller.is_launch() || caller.is_program() || file_names::is_test(&caller.path)
        };
        let mut loaders = all
            .iter()
            .filter(|caller| caller.says(file) && runs(caller))
            .peekable();
        loaders.peek().is_some() && loaders.all(|caller| is_of_kind(caller) && !caller.is_launch())
    }

    /// Whether launch files load the description `file`, and all of them give it the argument `name`; programs where no launch file
    /// does. What runs xacro by a function of its own has the name as a key.
    pub fn always_give(&self, file: &Path, name: &str) -> bool {
        let keys = [format!("'{name}':"), format!("\"{name}\":")];
        let gives = |caller: &&Caller| {
            caller.args.iter().any(|argument| argument.name == name)
                || self.packages.is_text(&caller.path, |text| {
                    keys.iter().any(|key| text.contains(key.as_str()))
                })
        };
        let all = self.of(file);
        let loaders = || all.iter().filter(|caller| caller.says(file));
        let launches: Vec<&Caller> = loaders().filter(|caller| caller.is_launch()).collect();
        let programs = loaders().filter(|caller| caller.is_program());
        let loaders = if launches.is_empty() {
            programs.collect()
        } else {
            launches
        };
        !loaders.is_empty() && loaders.iter().all(gives)
    }

    /// Whether a file that names the description `file` also says `word`.
    pub fn mention(&self, file: &Path, word: &str) -> bool {
        self.of(file).iter().any(|caller| {
            self.packages
                .is_text(&caller.path, |said| read::has_name(said, word))
        })
    }

    /// Whether a file that names the description `file` also holds `text`, letter for letter, outside of comments.
    pub fn quote(&self, file: &Path, text: &str) -> bool {
        self.of(file).iter().any(|caller| {
            let name = name_of(&caller.path);
            self.packages.is_text(&caller.path, |said| {
                read::without_comments(name, said).contains(text)
            })
        })
    }
}
