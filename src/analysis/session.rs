//! Files, packages, environment and configuration that checks and commands share.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

use super::beside::Pairing;
use super::configs::{Configs, Overrides, Settings};
use super::includes::Included;
use super::lock::locked;
use super::run_cache::Runs;
use base::{FastMap, FastSet};
use model::Meshes;
use packages::{PackageOptions, Packages};
use rules::{Manifests, Rule, RuleEnv};
use vfs::{Environment, LoadError, Vfs};
use workspace::config::{self, Axes, Config, ConfigWarning};
use workspace::{Caller, Callers, Era, Excluded, GivenArg, Purpose, RobotCall, is_ignored_by_git};

/// Files, packages, environment and configuration.
pub struct Session {
    /// Files.
    pub vfs: Arc<Vfs>,
    /// `$(find)` and `package://`.
    pub packages: Packages,
    /// Variables and working directory.
    pub env: Environment,
    meshes: Meshes,
    manifests: Manifests,
    configs: Configs,
    callers: Callers,
    /// Expansions that generated files were compared with.
    pub(super) drift_runs: Runs,
    /// What the descriptions below a folder include.
    included: Mutex<FastMap<PathBuf, Arc<Included>>>,
    /// The robots that files beside them are for.
    pairings: Mutex<FastMap<PathBuf, Arc<Pairing>>>,
    /// By the folder of sources: the files there that say something about robots.
    beside: Mutex<FastMap<PathBuf, Arc<Vec<PathBuf>>>>,
}

/// How a session is set up.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    /// What the session is about: the configuration nearest to it says where packages are.
    pub about: PathBuf,
    /// Folders whose packages are known wherever the asking file lies.
    pub folders: Vec<PathBuf>,
    /// Folders searched for packages before those of the configuration.
    pub package_path: Vec<PathBuf>,
    /// Settings over those of the configuration.
    pub overrides: Overrides,
}

impl Session {
    /// A session that sees the world from `env`.
    ///
    /// # Errors
    /// When the configuration file that `setup` names cannot be read.
    pub fn new(env: &Environment, setup: Setup) -> Result<Self, LoadError> {
        let vfs = Arc::new(Vfs::of(env, config::Limits::default().file_bytes()));
        let configs = Configs::new(&vfs, setup.overrides.clone())?;
        Ok(Self::with(vfs, env, setup, configs))
    }

    /// A session over files that others use too. A configuration file that `setup` names and that cannot be read
    /// counts as empty.
    pub fn over(vfs: Arc<Vfs>, env: &Environment, setup: Setup) -> Self {
        let overrides = Overrides {
            config: None,
            ..setup.overrides.clone()
        };
        let configs = Configs::new(&vfs, setup.overrides.clone());
        let configs = configs.unwrap_or_else(|_| Configs::without_file(overrides));
        Self::with(vfs, env, setup, configs)
    }

    /// A session of an editor that shows folders, with the settings it has for them.
    pub(super) fn of_editor(
        vfs: &Arc<Vfs>,
        env: &Environment,
        folders: &[PathBuf],
        editor: Vec<(serde_json::Value, PathBuf)>,
    ) -> Self {
        let setup = Setup {
            about: folders.first().cloned().unwrap_or_else(|| env.cwd.clone()),
            folders: folders.to_vec(),
            overrides: Overrides {
                editor,
                ..Overrides::default()
            },
            ..Setup::default()
        };
        Self::over(vfs.clone(), env, setup)
    }

    fn with(vfs: Arc<Vfs>, env: &Environment, setup: Setup, configs: Configs) -> Self {
        let about = vfs.absolute(&setup.about);
        let folder = if vfs.is_dir(&about) {
            Some(about.as_path())
        } else {
            about.parent()
        };
        let settings = configs.of_folder(&vfs, folder.unwrap_or(&about));
        let config = &settings.config;
        vfs.set_max_file_bytes(config.limits.file_bytes());
        let explicit = setup.package_path.iter().map(|path| env.cwd.join(path));
        let folders: Vec<PathBuf> = setup
            .folders
            .into_iter()
            .filter(|folder| vfs.is_dir(folder))
            .collect();
        // each folder may name places of its own
        let others = folders.iter().map(|folder| configs.of_folder(&vfs, folder));
        let of_folders: Vec<PathBuf> = others
            .flat_map(|settings| settings.config.package_path.clone())
            .filter(|path| !config.package_path.contains(path))
            .collect();
        let options = PackageOptions {
            workspace_folders: folders,
            explicit: explicit
                .chain(config.package_path.iter().cloned())
                .chain(of_folders)
                .collect(),
            use_environment: config.use_environment,
            target: config.target,
            ignored_by_git: is_ignored_by_git,
            ..PackageOptions::default()
        };
        let packages = Packages::new(vfs.clone(), env, options);
        Self {
            vfs,
            packages,
            env: env.clone(),
            meshes: Meshes::default(),
            manifests: Manifests::default(),
            configs,
            callers: Callers::default(),
            drift_runs: Runs::default(),
            included: Mutex::default(),
            pairings: Mutex::default(),
            beside: Mutex::default(),
        }
    }

    /// The files of the workspace that call a description, with the arguments they give.
    pub(super) fn callers(&self, file: &Path) -> Vec<Caller> {
        self.callers.of(file, &self.packages)
    }

    /// The arguments that the workspace gives to a description, call by call: first as the files that name it write them.
    pub(super) fn given_args(&self, file: &Path) -> impl Iterator<Item = Vec<GivenArg>> {
        let written = self.callers(file).into_iter().map(|caller| caller.args);
        // launch files are read when somebody asks for more
        let (callers, packages, file) = (&self.callers, &self.packages, file.to_owned());
        written.chain(std::iter::once_with(move || callers.given(&file, packages)).flatten())
    }

    /// The calls of robots below a folder, or those that a file makes or that call it, by the paths of the files that call.
    pub fn robot_calls(&self, path: &Path) -> Vec<RobotCall> {
        let path = self.vfs.absolute(path);
        if self.vfs.is_dir(&path) {
            return self.callers.calls_below(&path, &self.packages).to_vec();
        }
        let all = self.callers.calls(&path, &self.packages);
        let concerns =
            |call: &&RobotCall| call.call.caller == path || call.target.as_ref() == Some(&path);
        all.iter().filter(concerns).cloned().collect()
    }

    /// The values below a folder that launch files give and that choices rule out.
    pub(super) fn excluded_values(&self, folder: &Path) -> Arc<Vec<Excluded>> {
        self.callers.excluded_values(folder, &self.packages)
    }

    /// The arguments of a description for which launch files declare the values to choose from.
    pub(super) fn launch_choices(&self, file: &Path) -> Axes {
        self.callers.choices(file, &self.packages)
    }

    /// All calls of robots around a file.
    pub(super) fn calls_around(&self, file: &Path) -> Arc<Vec<RobotCall>> {
        self.callers.calls(file, &self.packages)
    }

    /// The files around a path that may say something about robots.
    pub(super) fn beside_around(&self, path: &Path) -> Arc<Vec<PathBuf>> {
        let Some(top) = self.packages.sources_around(path) else {
            return Arc::default();
        };
        if let Some(found) = locked(&self.beside).get(&top) {
            return found.clone();
        }
        let mut found = self.callers.beside(path, &self.packages);
        found.retain(|file| self.is_about_robots(file) && !self.settings(file).excludes(file));
        locked(&self.beside)
            .entry(top)
            .or_insert(Arc::new(found))
            .clone()
    }

    /// Forget which robots the files beside them are for.
    pub(super) fn forget_pairings(&self) {
        self.pairings().clear();
        locked(&self.beside).clear();
    }

    /// The descriptions around a file.
    pub(super) fn descriptions_around(&self, file: &Path) -> Arc<Vec<PathBuf>> {
        self.callers.descriptions(file, &self.packages)
    }

    /// Whether a launch file, script or page names a description.
    pub(super) fn is_named(&self, file: &Path) -> bool {
        self.callers.name(file, &self.packages)
    }

    /// Whether a file that counts names a description.
    pub(super) fn is_named_where(&self, file: &Path, counts: impl Fn(&Path) -> bool) -> bool {
        self.callers.name_where(file, &self.packages, counts)
    }

    /// Whether something that runs, not a page, loads a description.
    pub(super) fn is_loaded(&self, file: &Path) -> bool {
        self.callers.load(file, &self.packages)
    }

    /// Whether a description is there for the tests of its package and nothing else.
    pub(super) fn is_for_tests(&self, file: &Path) -> bool {
        let includers = |file: &Path| self.includers(file);
        self.callers.is_for_tests(file, &self.packages, includers)
    }

    /// The xacro that the launch files of a description are for.
    pub(super) fn era(&self, file: &Path) -> Era {
        self.callers.era(file, &self.packages)
    }

    /// Whether programs load a description into Bullet, and no launch file does.
    pub(super) fn is_for_bullet(&self, file: &Path) -> bool {
        self.callers.load_in_bullet(file, &self.packages)
    }

    /// Whether programs load a description into RaiSim, and nothing else loads it.
    pub(super) fn is_for_raisim(&self, file: &Path) -> bool {
        self.callers.load_in_raisim(file, &self.packages)
    }

    /// Whether launch files only show a description, and simulate another one.
    pub(super) fn is_only_shown(&self, file: &Path) -> bool {
        self.callers.only_show(file, &self.packages)
    }

    /// Whether a launch file loads a description.
    pub(super) fn is_launched(&self, file: &Path) -> bool {
        self.callers.launch(file, &self.packages)
    }

    /// Whether a launch file of the workspace around a file loads a description.
    pub(super) fn is_beside_launched(&self, file: &Path) -> bool {
        self.callers.launch_any(file, &self.packages)
    }

    /// Whether a launch file or program of the workspace around a file loads a description.
    pub(super) fn is_beside_loaded(&self, file: &Path) -> bool {
        self.callers.load_any(file, &self.packages)
    }

    /// Whether a launch file or program of the workspace around a file does more with a description than to show it.
    pub(super) fn is_beside_moved(&self, file: &Path) -> bool {
        self.callers.move_any(file, &self.packages)
    }

    /// The names of the descriptions that launch files load instead of this one.
    pub(super) fn launched_instead(&self, file: &Path, may_be_given: bool) -> FastSet<String> {
        self.callers
            .launched_instead(file, &self.packages, may_be_given)
    }

    /// Whether a launch file or program of the package of a file loads a description that is there, other than this one.
    pub(super) fn are_others_launched(&self, file: &Path) -> bool {
        self.callers.load_another(file, &self.packages)
    }

    /// Whether launch files load other descriptions, and nothing can mean this one, which lies in no package.
    pub(super) fn is_passed_over(&self, file: &Path) -> bool {
        self.callers.pass_over(file, &self.packages)
    }

    /// Whether launch files spawn models of SDF, and nothing loads a description.
    pub(super) fn is_beside_spawned_models(&self, file: &Path) -> bool {
        self.callers.spawn_models_instead(file, &self.packages)
    }

    /// Whether a file that names a description also says `word`.
    pub(super) fn is_named_with(&self, file: &Path, word: &str) -> bool {
        self.callers.mention(file, word, &self.packages)
    }

    /// Whether a file that names a description also holds a text, letter for letter.
    pub(super) fn is_quoted(&self, file: &Path, text: &str) -> bool {
        self.callers.quote(file, text, &self.packages)
    }

    /// Whether a page names a description to be used, not only in a table of files.
    pub(super) fn is_in_a_page(&self, file: &Path) -> bool {
        self.callers.tell_to_use(file, &self.packages)
    }

    /// Whether a program that names a description puts something else for a text.
    pub(super) fn is_rewritten(&self, file: &Path, text: &str) -> bool {
        self.callers.rewrite(file, text, &self.packages)
    }

    /// Whether a program around a file builds the configuration of MoveIt.
    pub(super) fn has_moveit_builder(&self, file: &Path) -> bool {
        self.callers.build_for_moveit(file, &self.packages)
    }

    /// Whether all that names a description are programs that write it.
    pub(super) fn is_only_written(&self, file: &Path) -> bool {
        self.callers.only_write(file, &self.packages)
    }

    /// Whether nothing but programs for kinematics loads a description.
    pub(super) fn is_for_kinematics(&self, file: &Path) -> bool {
        self.callers.load_for_kinematics(file, &self.packages)
    }

    /// Whether all launch files and programs around an SRDF leave it alone.
    pub(super) fn is_srdf_unread(&self, file: &Path) -> bool {
        self.callers.leave_srdf_alone(file, &self.packages)
    }

    /// Whether launch files and programs use what lies around a file, and none of them simulates anything.
    pub(super) fn is_never_simulated(&self, file: &Path) -> bool {
        self.callers.never_simulate(file, &self.packages)
    }

    /// Whether a description has something that only Gazebo runs.
    pub(super) fn is_for_gazebo(&self, file: &Path) -> bool {
        self.callers.is_for_gazebo(file, &self.packages)
    }

    /// What is done with a description, as far as texts name it.
    pub(super) fn purpose_in_texts(&self, file: &Path) -> Option<Purpose> {
        self.callers.purpose(file, &self.packages)
    }

    /// Whether launch files and programs simulate what lies around a file, and no simulator refuses a tensor that no body has.
    pub(super) fn is_never_refused(&self, file: &Path) -> bool {
        self.callers.never_refuse(file, &self.packages)
    }

    /// Whether launch files start the controllers of another description, and none names this one.
    pub(super) fn is_another_controlled(&self, file: &Path) -> bool {
        self.callers.control_another(file, &self.packages)
    }

    /// Whether a description is only spawned in Gazebo, under a name of its own.
    pub(super) fn is_only_spawned(&self, file: &Path) -> bool {
        self.callers.only_spawn(file, &self.packages)
    }

    /// Whether a file lies in a package that was put aside for another one.
    pub(super) fn is_put_aside(&self, file: &Path) -> bool {
        self.callers.is_put_aside(file, &self.packages)
    }

    /// Whether there are launch files or programs around a file.
    pub(super) fn has_programs(&self, file: &Path) -> bool {
        self.callers.run_something(file, &self.packages)
    }

    /// Whether the pages around a file name only old distributions.
    pub(super) fn is_for_old_ros(&self, file: &Path) -> bool {
        self.callers.is_for_old_ros(file, &self.packages)
    }

    /// The texts around a file that start controllers.
    pub(super) fn starters(&self, file: &Path) -> Vec<PathBuf> {
        self.callers.starters(file, &self.packages)
    }

    /// Whether a text of the workspace holds the name of a file.
    pub(super) fn is_mentioned(&self, file: &Path) -> bool {
        self.callers.mention_file(file, &self.packages)
    }

    /// Whether a repository of others was copied into the sources around a file.
    pub(super) fn has_copies(&self, file: &Path) -> bool {
        self.callers.has_copies(file, &self.packages)
    }

    /// The folder of the repository of others that a file was copied with into this workspace.
    pub(super) fn copied_with(&self, file: &Path) -> Option<PathBuf> {
        self.callers.copied_with(file, &self.packages)
    }

    /// Whether a file was copied with a repository of others, and nothing else in the workspace leads to it.
    pub(super) fn is_unused_copy(&self, file: &Path) -> bool {
        self.callers
            .is_unused_copy(file, &self.packages, |file| self.includers(file))
    }

    /// Whether a file belongs to a package that was copied with a repository of others, and nothing else in the workspace leads there.
    pub(super) fn is_in_unused_package(&self, file: &Path) -> bool {
        self.callers.is_in_unused_package(file, &self.packages)
    }

    /// Whether launch files and programs load a description, and all of them give it an argument.
    pub(super) fn is_always_given(&self, file: &Path, name: &str) -> bool {
        self.callers.always_give(file, name, &self.packages)
    }

    /// What the descriptions below a folder include, as `make` finds it the first time.
    pub(super) fn included_below(
        &self,
        folder: &Path,
        make: impl FnOnce() -> Arc<Included>,
    ) -> Arc<Included> {
        if let Some(included) = locked(&self.included).get(folder) {
            return included.clone();
        }
        let made = make();
        locked(&self.included)
            .entry(folder.to_owned())
            .or_insert(made)
            .clone()
    }

    /// The robots that files beside them are for, as far as somebody has asked.
    pub(super) fn pairings(&self) -> MutexGuard<'_, FastMap<PathBuf, Arc<Pairing>>> {
        locked(&self.pairings)
    }

    /// Forget which files include and call others: some have come, gone or changed.
    pub(super) fn forget_uses(&self) {
        self.callers.forget();
        locked(&self.included).clear();
        self.forget_pairings();
    }

    /// The settings for a file.
    pub fn settings(&self, file: &Path) -> Arc<Settings> {
        self.configs
            .of_folder(&self.vfs, file.parent().unwrap_or(file))
    }

    /// The settings for what lies directly in a folder.
    pub(super) fn folder_settings(&self, folder: &Path) -> Arc<Settings> {
        self.configs.of_folder(&self.vfs, folder)
    }

    /// What in the configurations read so far has no effect.
    pub fn config_warnings(&self) -> Vec<ConfigWarning> {
        self.configs.warnings()
    }

    /// Whether the editor gives this very rule a severity for a file, whatever its configuration says.
    pub fn editor_sets_severity(&self, file: &Path, rule: &Rule) -> bool {
        let folder = file.parent().unwrap_or(file);
        self.configs.editor_sets_severity(folder, rule)
    }

    /// The configurations that could not be read so far: nothing of them holds.
    pub fn unreadable_configs(&self) -> Vec<LoadError> {
        self.configs.unreadable()
    }

    /// The meshes.
    pub fn meshes(&self) -> &Meshes {
        &self.meshes
    }

    /// The meshes that were read or looked for so far.
    pub(super) fn mesh_files(&self) -> BTreeSet<PathBuf> {
        self.meshes.looked_for()
    }

    /// The configuration files read so far.
    pub(super) fn config_files(&self) -> Vec<PathBuf> {
        self.configs.files()
    }

    /// What rules see around a file with these settings.
    pub fn rule_env<'a>(&'a self, config: &'a Config) -> RuleEnv<'a> {
        let variables = [
            "AMENT_PREFIX_PATH",
            "COLCON_PREFIX_PATH",
            "ROS_PACKAGE_PATH",
        ];
        let sourced = variables
            .iter()
            .any(|name| self.env.var(name).is_some_and(|value| !value.is_empty()));
        let has_ros = sourced || self.vfs.is_dir(Path::new("/opt/ros"));
        let (vfs, meshes, manifests) = (&self.vfs, &self.meshes, &self.manifests);
        RuleEnv {
            packages: &self.packages,
            has_ros,
            vfs,
            meshes,
            manifests,
            config,
        }
    }
}
