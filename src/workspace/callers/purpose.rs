//! What the launch files and programs of a workspace use a description for.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Callers;
use super::caller::Caller;
use super::read::has_any;
use super::uses::Uses;
use packages::Packages;

/// Words in launch files and programs that run something that needs masses: simulators, and libraries for dynamics.
const WEIGHS: [&str; 21] = [
    "gazebo",
    "ros_gz",
    "ros_ign",
    "gz_sim",
    "mujoco",
    "bullet",
    "isaac",
    "webots",
    "coppelia",
    "vrep",
    "drake",
    "pinocchio",
    "raisim",
    "genesis",
    "sapien",
    "dartsim",
    "RigidBody",
    "rbdl",
    "RBDL",
    "dynamics",
    "Dynamics",
];

/// Whether a text runs something that needs masses and inertia.
pub(super) fn weighs(text: &str) -> bool {
    has_any(text, &WEIGHS)
}

/// Words of simulators that refuse a robot with a tensor that no body has: Gazebo Sim, MuJoCo, Drake. Gazebo Classic takes it.
const REFUSES: [&str; 9] = [
    "ros_gz",
    "ros_ign",
    "gz_sim",
    "gz-sim",
    "gz_ros2_control",
    "ign_ros2_control",
    "ignition",
    "mujoco",
    "drake",
];

/// Whether a text runs a simulator that refuses a tensor that no body has, or is for one.
pub(super) fn refuses(text: &str) -> bool {
    has_any(text, &REFUSES)
}

/// Whether a launch file spawns a model of SDF in Gazebo.
pub(super) fn spawns_model(text: &str) -> bool {
    const SPAWNERS: [&str; 3] = ["spawn_model", "spawn_entity", "ros_gz_sim"];
    const MODELS: [&str; 2] = ["-sdf", ".sdf"];
    has_any(text, &SPAWNERS) && has_any(text, &MODELS)
}

/// Words in texts that run something that computes with every triangle of a collision mesh. Bullet, MuJoCo and Isaac take the
/// convex hull of it.
const TRIANGLES: [&str; 10] = [
    "gazebo", "ros_gz", "ros_ign", "gz_sim", "webots", "coppelia", "vrep", "moveit", "fcl", "hpp",
];

/// Whether a text runs something that computes with the triangles of collision meshes.
pub(super) fn meets(text: &str) -> bool {
    has_any(text, &TRIANGLES)
}

/// Whether a description has something that only Gazebo runs.
pub(super) fn is_for_gazebo(text: &str) -> bool {
    text.contains("<gazebo") && (text.contains("<plugin") || text.contains("<sensor"))
}

impl Callers {
    /// Whether launch files and programs plan with what lies around a file or control it, and nothing there needs masses and inertia:
    /// none of them simulates anything or computes dynamics, and no description has a plugin or sensor for Gazebo. What is only shown
    /// there may be simulated by others.
    pub fn never_weigh(&self, file: &Path, packages: &Packages) -> bool {
        self.mentions(file, packages)
            .is_some_and(|all| all.is_whole && all.moves && !all.weighs)
    }

    /// Whether launch files and programs simulate what lies around a file, none of them with a simulator that refuses a tensor that no
    /// body has.
    pub fn never_refuse(&self, file: &Path, packages: &Packages) -> bool {
        self.mentions(file, packages)
            .is_some_and(|all| all.is_whole && all.weighs && all.runs && !all.refuses)
    }

    /// Whether launch files and programs use what lies around a file, and no text there simulates or plans with the triangles of
    /// its collision meshes.
    pub fn never_meet(&self, file: &Path, packages: &Packages) -> bool {
        self.mentions(file, packages)
            .is_some_and(|all| all.is_whole && all.runs && !all.meets)
    }

    /// Whether nothing but programs loads the description `file`, and none of them needs masses and inertia.
    pub fn load_without_masses(&self, file: &Path, packages: &Packages) -> bool {
        self.load_in_programs_without(weighs, file, packages)
    }

    /// Whether nothing but programs loads the description `file`, and none of them computes with triangles of collision meshes.
    pub fn load_without_triangles(&self, file: &Path, packages: &Packages) -> bool {
        self.load_in_programs_without(meets, file, packages)
    }

    /// Whether nothing but programs loads a description, and none of them says that it does something with it.
    fn load_in_programs_without(
        &self,
        does: impl Fn(&str) -> bool,
        file: &Path,
        packages: &Packages,
    ) -> bool {
        let all = self.of(file, packages);
        let mut loaders = all
            .iter()
            .filter(|caller| caller.says(file) && !caller.is_page())
            .peekable();
        loaders.peek().is_some()
            && loaders.all(|caller| {
                caller.is_program()
                    && !caller.is_launch()
                    && packages.is_text(&caller.path, |text| !does(text))
            })
    }

    /// Whether launch files load the description `file` and neither they nor the texts that name them need masses, while others
    /// simulate another one that is there.
    pub fn handle_only(&self, file: &Path, packages: &Packages) -> bool {
        let Some(mentions) = self.mentions(file, packages).filter(|all| all.is_whole) else {
            return false;
        };
        let needs_masses = |path: &Path| packages.is_text(path, weighs);
        let all = self.of(file, packages);
        let mut loaders = all
            .iter()
            .filter(|caller| caller.says(file) && !caller.is_page())
            .peekable();
        let simulates_another = |all: Arc<Uses>| {
            let mut others = all.callers.iter().filter(|caller| caller.is_launch());
            others
                .any(|caller| all.has_another(caller, file, packages) && needs_masses(&caller.path))
        };
        loaders.peek().is_some()
            && loaders.all(|caller| {
                caller.is_launch()
                    && !needs_masses(&caller.path)
                    && !mentions.of(&caller.path).any(needs_masses)
            })
            && self.around(file, packages).is_some_and(simulates_another)
    }

    /// Whether a launch file starts the controllers or simulation of another description that is there, and none names this one.
    pub fn control_another(&self, file: &Path, packages: &Packages) -> bool {
        const STARTS: [&str; 4] = ["controller_manager", "ros2_control_node", "gazebo", "gz_"];
        let is_it = |all: Arc<Uses>| {
            let mut launches = all.callers.iter().filter(|caller| caller.is_launch());
            launches.any(|caller| {
                all.has_another(caller, file, packages)
                    && packages.is_text(&caller.path, |text| has_any(text, &STARTS))
            })
        };
        let mut named = self
            .of(file, packages)
            .into_iter()
            .filter(Caller::is_launch);
        !named.any(|caller| caller.says(file)) && self.around(file, packages).is_some_and(is_it)
    }

    /// Whether nothing but launch files that spawn models of Gazebo under a name of their own load a description.
    pub fn only_spawn(&self, file: &Path, packages: &Packages) -> bool {
        const NAMES: [&str; 2] = ["-model ", "-entity"];
        const READS: [&str; 4] = [
            "robot_state_publisher",
            "move_group",
            "MoveIt",
            "controller_manager",
        ];
        let spawns = |caller: &Caller| {
            packages.is_text(&caller.path, |text| {
                text.contains("spawn_") && has_any(text, &NAMES) && !has_any(text, &READS)
            })
        };
        let all = self.of(file, packages);
        let mut loaders = all
            .iter()
            .filter(|caller| caller.says(file) && !caller.is_page())
            .peekable();
        loaders.peek().is_some() && loaders.all(spawns)
    }

    /// Whether launch files around a file spawn models of SDF, and no launch file or program there loads a description.
    pub fn spawn_models_instead(&self, file: &Path, packages: &Packages) -> bool {
        let loads = |caller: &Caller| caller.is_launch() || caller.is_program();
        // to read all texts takes longer than to ask those that name descriptions
        self.around(file, packages)
            .is_some_and(|uses| !uses.callers.iter().any(loads))
            && self
                .mentions(file, packages)
                .is_some_and(|all| all.is_whole && all.spawns_models)
    }

    /// Whether a file lies in a package that was put aside: no text names it, and another package, which texts do name, has a
    /// file at the same place.
    pub fn is_put_aside(&self, file: &Path, packages: &Packages) -> bool {
        let Some(own) = packages.containing(file) else {
            return false;
        };
        let Some(top) = packages.sources_around(file) else {
            return false;
        };
        let inside = file.strip_prefix(&own.folder).unwrap_or(file);
        let is_twin = |(name, folder): &(String, PathBuf)| {
            *name != own.name && packages.vfs().is_file(&folder.join(inside))
        };
        let mut twins = packages.below(&top);
        twins.retain(is_twin);
        if twins.is_empty() {
            return false;
        }
        let Some(mentions) = self.mentions(file, packages).filter(|all| all.is_whole) else {
            return false;
        };
        !mentions.is_named(&own.name) && twins.iter().any(|(name, _)| mentions.is_named(name))
    }

    /// Whether there are launch files or programs around a file.
    pub fn run_something(&self, file: &Path, packages: &Packages) -> bool {
        self.mentions(file, packages).is_some_and(|all| all.runs)
    }
}
