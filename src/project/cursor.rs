//! What a word that is typed into a YAML file beside a robot is to name. Half-typed YAML seldom parses, so this is told from
//! the lines in front of it.

use super::controllers::{joint_keys, may_hold_joints};
use super::steps::{Around, Step, around};
use base::TextRange;

/// What a word is to name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
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
pub struct Word {
    /// What it is to name.
    pub wanted: Wanted,
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
pub fn word_at(name: &str, text: &str, offset: u32) -> Option<Word> {
    let found = around(text, offset as usize)?;
    let keys: Vec<&str> = found.steps.iter().filter_map(Step::key).collect();
    let wanted = if found.is_key {
        of_key(&keys, name, text)?
    } else {
        of_value(&keys)?
    };
    let (rest, has_colon) = behind(text.get(offset as usize..)?);
    let Around {
        start,
        taken,
        is_key,
        ..
    } = found;
    let around = keys.last().copied().unwrap_or_default().to_owned();
    Some(Word {
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
fn of_value(keys: &[&str]) -> Option<Wanted> {
    let &last = keys.last()?;
    match last {
        "controller_names" => Some(Wanted::Controller),
        "planner_configs" | "default_planner_config" => Some(Wanted::Planner),
        "command_interfaces" | "interface_name" => Some(Wanted::CommandInterface),
        "state_interfaces" => Some(Wanted::StateInterface),
        "interface_names" => Some(Wanted::JointInterface),
        key if GROUP_KEYS.contains(&key) => Some(Wanted::Group),
        key if joint_keys().contains(&key) => Some(Wanted::Joint),
        key if may_hold_joints(key) && keys.contains(&"ros__parameters") => Some(Wanted::Joint),
        _ => None,
    }
}

/// What the keys in a mapping name.
fn of_key(keys: &[&str], name: &str, text: &str) -> Option<Wanted> {
    let inside: Vec<&str> = keys
        .iter()
        .copied()
        .filter(|key| !["/**", "ros__parameters"].contains(key))
        .collect();
    match inside.as_slice() {
        [.., "joint_limits" | "gains" | "pid_gains" | "constraints"] => Some(Wanted::Joint),
        [.., "joint_limits", _] => Some(Wanted::Limit),
        [] | ["robot_description_kinematics"]
            if text.contains("kinematics_solver") || name.starts_with("kinematics") =>
        {
            Some(Wanted::Group)
        }
        [] | ["ompl"] if text.contains("planner_configs") || name.starts_with("ompl") => {
            Some(Wanted::Group)
        }
        ["moveit_simple_controller_manager"] => Some(Wanted::Controller),
        [] if text.contains("controller_names:") || text.contains("controller_manager:") => {
            Some(Wanted::Controller)
        }
        _ => None,
    }
}
