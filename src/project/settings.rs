//! What a YAML file says about a robot.

use super::controllers::{self, Controller, Listed};
use super::moveit::{self, Assistant, JointLimit, MoveitController};
use super::value::SpannedName;
use super::{ProjectNameKind, is_computed};
use yaml::YamlNode;

/// What a YAML file says about links, joints and groups of a robot; everything in the order of the text.
#[derive(Clone, Debug, Default)]
pub struct YamlSettings {
    /// What the controller managers may load.
    pub listed: Vec<Listed>,
    /// Parameters of controllers.
    pub controllers: Vec<Controller>,
    /// The controllers that MoveIt sends trajectories to.
    pub moveit: Vec<MoveitController>,
    /// Limits of joints.
    pub limits: Vec<JointLimit>,
    /// The groups with a solver for inverse kinematics.
    pub kinematics: Vec<SpannedName>,
    /// The groups with planners.
    pub planners: Vec<SpannedName>,
    /// The groups that parameters of MoveIt Servo name.
    pub servo: Vec<SpannedName>,
    /// What MoveIt's setup assistant wrote down.
    pub assistant: Option<Assistant>,
}

/// Whether a text may hold settings of a robot: most YAML files do not.
pub fn may_be_settings(text: &str) -> bool {
    const WORDS: [&str; 8] = [
        "controller",
        "joint_limits",
        "kinematics_solver",
        "planner_configs",
        "move_group_name",
        "moveit_setup_assistant_config",
        "joints:",
        "joint:",
    ];
    WORDS.iter().any(|word| text.contains(word))
}

/// Whether a text has a key twice at its left edge, as in two blocks of `/**:`.
fn has_repeated(text: &str) -> bool {
    let mut keys: Vec<&str> = Vec::new();
    let is_key =
        |line: &&str| line.starts_with(|first: char| !first.is_whitespace() && first != '#');
    for line in text.lines().filter(is_key) {
        let Some((key, _)) = line.split_once(':') else {
            continue;
        };
        if keys.contains(&key) {
            return true;
        }
        keys.push(key);
    }
    false
}

impl YamlSettings {
    /// The settings in a text, with its value. The parameters in several blocks of one name are those of all blocks.
    pub fn read(text: &str, root: &YamlNode) -> Option<Self> {
        if has_repeated(text) {
            Self::of(&yaml::load_repeated(text, "").ok()?)
        } else {
            Self::of(root)
        }
    }

    /// The settings in a YAML document; none when it says nothing about a robot.
    pub fn of(root: &YamlNode) -> Option<Self> {
        let mut settings = Self {
            moveit: moveit::controllers(root),
            limits: moveit::limits(root),
            kinematics: moveit::kinematics(root),
            planners: moveit::planners(root),
            servo: moveit::servo(root),
            assistant: Assistant::of(root),
            ..Self::default()
        };
        controllers::read(root, &mut settings.listed, &mut settings.controllers);
        for controller in &mut settings.controllers {
            if !settings
                .listed
                .iter()
                .any(|listed| listed.name.name == controller.name.name)
            {
                controller.keep_known_parameters();
            }
        }
        let is_of_robot = |controller: &Controller| !controller.joints.is_empty();
        if settings.listed.is_empty() && !settings.controllers.iter().any(is_of_robot) {
            settings.controllers.clear();
        }
        let is_empty = settings.listed.is_empty()
            && settings.controllers.is_empty()
            && settings.moveit.is_empty()
            && settings.limits.is_empty()
            && settings.kinematics.is_empty()
            && settings.planners.is_empty()
            && settings.servo.is_empty()
            && settings.assistant.is_none();
        (!is_empty).then_some(settings)
    }

    /// Every name of a joint or group that is written out.
    pub fn names(&self) -> Vec<(&SpannedName, ProjectNameKind)> {
        let mut found: Vec<(&SpannedName, ProjectNameKind)> = Vec::new();
        let joints = self
            .controllers
            .iter()
            .flat_map(|one| one.joints.iter().map(|(_, joint)| joint));
        let joints = joints.chain(self.moveit.iter().flat_map(|one| &one.joints));
        let joints = joints.chain(self.limits.iter().map(|limit| &limit.joint));
        found.extend(joints.map(|joint| (joint, ProjectNameKind::Joint)));
        let groups = self
            .kinematics
            .iter()
            .chain(&self.planners)
            .chain(&self.servo);
        found.extend(groups.map(|group| (group, ProjectNameKind::Group)));
        found.retain(|(name, _)| !is_computed(&name.name));
        found
    }
}
