//! What can be typed in YAML beside a robot: joints, interfaces, groups, controllers and limits.

use super::super::hover::limits;
use super::item::{Completion, Completions, ItemKind, escaped};
use base::FastMap;
use expand::Expansion;
use model::{Interface, Joint, JointType, Robot};
use project::{ExpectedName, Srdf, TypedWord, YamlSettings, planner_names, word_at};

/// What names in YAML are taken from.
#[derive(Default)]
pub struct BesideSources<'a> {
    /// The robots that the file is for, or may be for.
    pub robots: Vec<(&'a Expansion, &'a Robot)>,
    /// The SRDFs beside them.
    pub srdfs: Vec<&'a Srdf>,
    /// Other YAML beside them.
    pub settings: Vec<&'a YamlSettings>,
}

/// Interfaces that are offered where no hardware says which there are.
const INTERFACES: [&str; 4] = ["position", "velocity", "effort", "acceleration"];

/// What can be typed at an offset of a YAML file with this name; none where no name of a robot belongs.
pub fn completions_in_settings(
    (name, text): (&str, &str),
    offset: u32,
    sources: &BesideSources<'_>,
) -> Option<Completions> {
    let word = word_at(name, text, offset)?;
    let own = FileSettings::of(text, offset);
    let mut items = match word.wanted {
        ExpectedName::Joint => joints(sources, &word),
        ExpectedName::CommandInterface => interfaces(sources, true),
        ExpectedName::StateInterface => interfaces(sources, false),
        ExpectedName::JointInterface => joint_interfaces(sources),
        ExpectedName::Group => groups(sources),
        ExpectedName::Planner => own
            .planners
            .iter()
            .map(|name| Completion::new(ItemKind::Choice, name))
            .collect(),
        ExpectedName::Controller => controllers(sources, &own, word.is_key),
        ExpectedName::Limit => limit_keys(sources, &word.around),
    };
    let typed = word.range.slice(text);
    items.retain(|item| {
        // of the names of this file, what is typed is none
        let is_typed = item.kind == ItemKind::Controller && item.label == typed;
        !is_typed && !word.taken.contains(&item.label)
    });
    if word.is_key && !word.has_colon {
        items
            .iter_mut()
            .filter(|item| item.text == item.label)
            .for_each(as_key);
    }
    if word.has_colon {
        for item in &mut items {
            (item.snippet, item.text) = (None, item.label.clone());
        }
    }
    Some(Completions::new(word.range.start, offset, word.rest, items).bounded(typed, |_| 0))
}

fn as_key(item: &mut Completion) {
    item.text = format!("{}:", item.label);
}

/// What the rest of the file says: the line that is typed seldom parses.
struct FileSettings {
    settings: Option<YamlSettings>,
    planners: Vec<String>,
}

impl FileSettings {
    fn of(text: &str, offset: u32) -> Self {
        let (before, after) = text.split_at_checked(offset as usize).unwrap_or((text, ""));
        let before = before
            .rfind('\n')
            .map_or("", |end| before.get(..=end).unwrap_or(""));
        let after = after
            .find('\n')
            .map_or("", |start| after.get(start + 1..).unwrap_or(""));
        let root = yaml::load(text, "").or_else(|_| yaml::load(&format!("{before}{after}"), ""));
        let planners = root
            .iter()
            .flat_map(planner_names)
            .map(|name| name.name.to_string())
            .collect();
        Self {
            settings: root.ok().as_ref().and_then(YamlSettings::of),
            planners,
        }
    }
}

/// The joints of the robots: those of the hardware first, then others that are driven, last what cannot be commanded.
fn joints(sources: &BesideSources<'_>, word: &TypedWord) -> Vec<Completion> {
    let mut found = Vec::new();
    for (_, robot) in &sources.robots {
        let controlled: Vec<&str> = robot
            .controls
            .iter()
            .flat_map(|control| &control.joints)
            .filter_map(|joint| Some(joint.name.as_ref()?.name()?.as_str()))
            .collect();
        for joint in robot
            .joints
            .iter()
            .filter(|joint| joint.name.as_ref().is_some_and(|name| name.is_known()))
        {
            let has_hardware = controlled.contains(&joint.shown());
            let rank = match (joint.is_driven(), has_hardware) {
                (true, true) => 0,
                (true, false) => 1,
                (false, true) => 2,
                _ if joint.is(&[JointType::Fixed]) => 4,
                _ => 3,
            };
            // the limits of a joint that does not move mean nothing
            if !(word.is_key && rank == 4) {
                found.push(joint_item(joint, rank));
            }
        }
    }
    found
}

/// A joint, with its type and limits.
pub(super) fn joint_item(joint: &Joint, rank: u8) -> Completion {
    let kind = joint.kind.as_ref().map_or("", |kind| kind.value.as_str());
    let detail = limits(joint, joint.joint_type()).unwrap_or_default();
    Completion::new(ItemKind::Joint, joint.shown())
        .note(kind)
        .detail(detail)
        .rank(rank)
}

/// Whether two texts are the same.
pub(super) fn same_text(one: &str, other: &str) -> bool {
    one.trim() == other.trim()
}

/// The interfaces of the hardware with the number of joints that offer each; the usual ones where there is none.
fn interfaces(sources: &BesideSources<'_>, is_command: bool) -> Vec<Completion> {
    let mut counts: FastMap<&str, usize> = FastMap::default();
    let joints = sources
        .robots
        .iter()
        .flat_map(|(_, robot)| &robot.controls)
        .flat_map(|control| &control.joints);
    for interface in joints.flat_map(|joint| {
        if is_command {
            &joint.commands
        } else {
            &joint.states
        }
    }) {
        if let Some(name) = name_of(interface) {
            *counts.entry(name).or_default() += 1;
        }
    }
    if counts.is_empty() {
        return INTERFACES
            .iter()
            .map(|name| Completion::new(ItemKind::Choice, *name))
            .collect();
    }
    let mut counts: Vec<(&str, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(name, count)| (std::cmp::Reverse(*count), *name));
    let item = |(rank, (name, count)): (usize, (&str, usize))| {
        Completion::new(ItemKind::Choice, name)
            .note(base::counted(count, "joint"))
            .rank(rank.min(9) as u8)
    };
    counts.into_iter().enumerate().map(item).collect()
}

fn name_of(interface: &Interface) -> Option<&str> {
    Some(interface.name.as_ref()?.name()?.as_str())
}

/// `joint_1/position`
fn joint_interfaces(sources: &BesideSources<'_>) -> Vec<Completion> {
    let joints = sources
        .robots
        .iter()
        .flat_map(|(_, robot)| &robot.controls)
        .flat_map(|control| &control.joints);
    let named = joints.filter_map(|joint| Some((joint.name.as_ref()?.name()?, joint)));
    let all = named.flat_map(|(name, joint)| {
        joint
            .interfaces()
            .filter_map(name_of)
            .map(move |interface| format!("{name}/{interface}"))
    });
    all.map(|name| Completion::new(ItemKind::Choice, name))
        .collect()
}

fn groups(sources: &BesideSources<'_>) -> Vec<Completion> {
    let groups = sources.srdfs.iter().flat_map(|srdf| &srdf.groups);
    let item = |group: &project::PlanningGroup| {
        let name = group.name.as_ref()?.name()?;
        Some(
            Completion::new(ItemKind::Group, name.as_str())
                .note(group.in_short())
                .rank(0),
        )
    };
    groups.filter_map(item).collect()
}

/// The controllers that controller managers list, and those that the file names. MoveIt sends nothing to broadcasters.
fn controllers(
    sources: &BesideSources<'_>,
    own: &FileSettings,
    with_broadcasters: bool,
) -> Vec<Completion> {
    let all = sources.settings.iter().copied().chain(&own.settings);
    let mut found = Vec::new();
    for settings in all {
        let listed = settings
            .listed
            .iter()
            .map(|listed| (&listed.name.name, listed.class.name.as_str()));
        let named = settings
            .moveit
            .iter()
            .map(|controller| (&controller.name.name, ""));
        let all = listed
            .chain(named)
            .filter(|(_, class)| with_broadcasters || !class.contains("Broadcaster"));
        found.extend(all.map(|(name, class)| {
            let rank = if class.contains("Broadcaster") { 3 } else { 0 };
            let class = class.rsplit('/').next().unwrap_or(class);
            Completion::new(ItemKind::Controller, name.as_str())
                .note(class)
                .rank(rank)
        }));
    }
    found
}

/// The limits of a joint that MoveIt reads, with the values of the URDF.
fn limit_keys(sources: &BesideSources<'_>, joint: &str) -> Vec<Completion> {
    let joint = sources
        .robots
        .iter()
        .find_map(|(_, robot)| robot.joint(joint));
    let limit = joint.and_then(|joint| joint.limit.as_ref());
    let velocity = limit.and_then(|limit| limit.velocity.as_ref()?.number());
    let range = limit.and_then(|limit| limit.range());
    let values = [
        ("max_velocity", velocity),
        ("max_acceleration", None),
        ("min_position", range.map(|range| range.0)),
        ("max_position", range.map(|range| range.1)),
        ("max_jerk", None),
    ];
    let switches = [
        "has_velocity_limits",
        "has_acceleration_limits",
        "has_position_limits",
        "has_jerk_limits",
    ];
    let switch = |(rank, name): (usize, &&str)| {
        Completion::new(ItemKind::Key, *name)
            .text(format!("{name}: true"))
            .rank(rank as u8)
    };
    let value = |(rank, (name, value)): (usize, &(&str, Option<f64>))| {
        let item = Completion::new(ItemKind::Key, *name).rank(4 + rank as u8);
        match value {
            // MoveIt 2 wants doubles
            Some(value) => {
                let text = format!("{name}: {value:?}");
                let snippet = format!("{}$0", escaped(&text));
                item.text(text)
                    .snippet(snippet)
                    .note(format!("{value:?} in the URDF"))
            }
            None => item.text(format!("{name}: ")),
        }
    };
    let switches: Vec<Completion> = switches.iter().enumerate().map(switch).collect();
    switches
        .into_iter()
        .chain(values.iter().enumerate().map(value))
        .collect()
}
