//! Files, packages, environment and configuration that checks and commands share.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

use super::beside::Pairing;
use super::configs::{Configs, Overrides, Settings};
use super::includes::{Included, IncludedCache};
use super::lock::locked;
use super::run_cache::Runs;
use base::FastMap;
use model::Meshes;
use packages::{PackageOptions, Packages};
use rules::{Manifests, Rule, RuleEnv};
use vfs::{Environment, LoadError, Vfs};
use workspace::config::{self, Config, ConfigWarning};
use workspace::{Callers, GivenArg, RobotCall, is_ignored_by_git};

/// Files, packages, environment and configuration.
pub struct Session {
    /// Files.
    pub vfs: Arc<Vfs>,
    /// `$(find)` and `package://`.
    pub packages: Arc<Packages>,
    /// Variables and working directory.
    pub env: Environment,
    meshes: Meshes,
    manifests: Manifests,
    configs: Configs,
    /// Who uses which description.
    pub(super) callers: Callers,
    /// Expansions that generated files were compared with.
    pub(super) drift_runs: Runs,
    /// What the descriptions below a folder include.
    included: Mutex<IncludedCache>,
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
        let packages = Arc::new(Packages::new(vfs.clone(), env, options));
        Self {
            vfs,
            callers: Callers::new(packages.clone()),
            packages,
            env: env.clone(),
            meshes: Meshes::default(),
            manifests: Manifests::default(),
            configs,
            drift_runs: Runs::default(),
            included: Mutex::default(),
            pairings: Mutex::default(),
            beside: Mutex::default(),
        }
    }

    /// The arguments that the workspace gives to a description, call by call: first as the files that name it write them.
    pub(super) fn given_args(&self, file: &Path) -> impl Iterator<Item = Vec<GivenArg>> {
        let written = self.callers.of(file).into_iter().map(|caller| caller.args);
        // launch files are read when somebody asks for more
        let (callers, file) = (&self.callers, file.to_owned());
        written.chain(std::iter::once_with(move || callers.given(&file)).flatten())
    }

    /// The calls of robots below a folder, or those that a file makes or that call it, by the paths of the files that call.
    pub fn robot_calls(&self, path: &Path) -> Vec<RobotCall> {
        let path = self.vfs.absolute(path);
        if self.vfs.is_dir(&path) {
            return self.callers.calls_below(&path).to_vec();
        }
        let all = self.callers.calls(&path);
        let concerns =
            |call: &&RobotCall| call.call.caller == path || call.target.as_ref() == Some(&path);
        all.iter().filter(concerns).cloned().collect()
    }

    /// Forget which robots the files beside them are for.
    pub(super) fn forget_pairings(&self) {
        self.pairings().clear();
        self.known_beside().clear();
    }

    /// What the descriptions below a folder include, as `make` finds it the first time.
    pub(super) fn included_below(
        &self,
        folder: &Path,
        make: impl FnOnce() -> Arc<Included>,
    ) -> Arc<Included> {
        let known = locked(&self.included).get(folder, &self.vfs, &self.packages);
        known.unwrap_or_else(|| {
            let made = make();
            locked(&self.included).keep(folder, made)
        })
    }

    /// A description was edited: it may include and define something else.
    pub(super) fn edit_description(&self, path: &Path) {
        locked(&self.included).edit(path);
        self.callers.edit_description(path);
    }

    /// The robots that files beside them are for, as far as somebody has asked.
    pub(super) fn pairings(&self) -> MutexGuard<'_, FastMap<PathBuf, Arc<Pairing>>> {
        locked(&self.pairings)
    }

    /// The files around sources that may say something about robots, as far as somebody has asked.
    pub(super) fn known_beside(&self) -> MutexGuard<'_, FastMap<PathBuf, Arc<Vec<PathBuf>>>> {
        locked(&self.beside)
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
