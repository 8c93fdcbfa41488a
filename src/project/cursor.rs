//! What a word that is typed into a YAML file beside a robot is to name. Half-typed YAML seldom parses, so this is told from
//! the lines in front of it.

use super::controllers::{joint_keys, may_hold_joints};
use super::steps::{PathStep, YamlContext, around};
use base::TextRange;

/// What a word is to name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExpectedName {
    /// A joint that something drives.
    Joint,
    /// An interface that controllers write.
    CommandInterface,
    /// An interface that controllers read.
    StateInterface,
    /// A joint with one of its interfaces, `joint_1/position`.
    JointInterface,
    /// A planning group.
    Group,
    /// A configuration of a planner.
    Planner,
    /// A controller that a controller manager lists.
    Controller,
    /// A limit of the joint whose name is around.
    Limit,
}

/// A word that is typed, or may be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TypedWord {
    /// What it is to name.
    pub wanted: ExpectedName,
    /// Whether it is the key of a mapping.
    pub is_key: bool,
    /// What was typed of it.
    pub range: TextRange,
    /// How many bytes behind the cursor belong to it.
    pub rest: u32,
    /// Whether a colon follows.
    pub has_colon: bool,
    /// Its siblings: other names of the same list or mapping.
    pub taken: Vec<String>,
    /// The key around it.
    pub around: String,
}

/// The parameters that name a planning group.
/// Source: parameters of MoveIt Servo.
pub(super) const GROUP_KEYS: [&str; 2] = ["move_group_name", "active_subgroup"];

/// The word at an offset of a file with this name; none where no name of a robot is wanted.
pub fn word_at(name: &str, text: &str, offset: u32) -> Option<TypedWord> {
    let found = around(text, offset as usize)?;
    let keys: Vec<&str> = found.steps.iter().filter_map(PathStep::key).collect();
    let wanted = if found.is_key {
        of_key(&keys, name, text)?
    } else {
        of_value(&keys)?
    };
    let (rest, has_colon) = behind(text.get(offset as usize..)?);
    let YamlContext {
        start,
        taken,
        is_key,
        ..
    } = found;
    let around = keys.last().copied().unwrap_or_default().to_owned();
    Some(TypedWord {
        wanted,
        is_key,
        range: TextRange::new(start as u32, offset),
        rest,
        has_colon,
        taken,
        around,
    })
}

/// How much of the text behind the cursor belongs to the word, and whether a colon follows it.
fn behind(text: &str) -> (u32, bool) {
    let ends = |c: char| c.is_whitespace() || matches!(c, ',' | ']' | '}' | '"' | '\'' | ':' | '#');
    let rest = text.find(ends).unwrap_or(text.len());
    let after = text
        .get(rest..)
        .unwrap_or("")
        .trim_start_matches(['"', '\'', ' ']);
    (rest as u32, after.starts_with(':'))
}

/// What the value of a key names.
fn of_value(keys: &[&str]) -> Option<ExpectedName> {
    let &last = keys.last()?;
    match last {
        "controller_names" => Some(ExpectedName::Controller),
        "planner_configs" | "default_planner_config" => Some(ExpectedName::Planner),
        "command_interfaces" | "interface_name" => Some(ExpectedName::CommandInterface),
        "state_interfaces" => Some(ExpectedName::StateInterface),
        "interface_names" => Some(ExpectedName::JointInterface),
        key if GROUP_KEYS.contains(&key) => Some(ExpectedName::Group),
        key if joint_keys().contains(&key) => Some(ExpectedName::Joint),
        key if may_hold_joints(key) && keys.contains(&"ros__parameters") => {
            Some(ExpectedName::Joint)
        }
        _ => None,
    }
}

/// What the keys in a mapping name.
fn of_key(keys: &[&str], name: &str, text: &str) -> Option<ExpectedName> {
    let inside: Vec<&str> = keys
        .iter()
        .copied()
        .filter(|key| !["/**", "ros__parameters"].contains(key))
        .collect();
    match inside.as_slice() {
        [.., "joint_limits" | "gains" | "pid_gains" | "constraints"] => Some(ExpectedName::Joint),
        [.., "joint_limits", _] => Some(ExpectedName::Limit),
        [] | ["robot_description_kinematics"]
            if text.contains("kinematics_solver") || name.starts_with("kinematics") =>
        {
            Some(ExpectedName::Group)
        }
        [] | ["ompl"] if text.contains("planner_configs") || name.starts_with("ompl") => {
            Some(ExpectedName::Group)
        }
        ["moveit_simple_controller_manager"] => Some(ExpectedName::Controller),
        [] if text.contains("controller_names:") || text.contains("controller_manager:") => {
            Some(ExpectedName::Controller)
        }
        _ => None,
    }
}
