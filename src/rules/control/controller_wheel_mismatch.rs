//! A controller of a drive that is told other wheels than the robot has.
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::super::beside::{BesideCx, PairedRobot};
use super::super::geometry::link_bounds;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::controller_unknown_interface::class_of;
use super::wheel_sizes::{WheelPair, length};
use base::Span;
use model::{AttrValue, Link};
use project::{Controller, SpannedName};

pub(in super::super) static RULE: Rule = Rule::beside(
    "CTL033",
    "controller-wheel-mismatch",
    Category::Control,
    Severity::Warning,
    page("controller-wheel-mismatch"),
    check,
);

pub(super) const CLASS: &str = "diff_drive_controller/DiffDriveController";
/// The keys of the joints that it turns, left and right: those of ROS 2, and of ROS 1.
const JOINTS: [[&str; 2]; 2] = [
    ["left_wheel_names", "right_wheel_names"],
    ["left_wheel", "right_wheel"],
];

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    for controller in cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.controllers)
        .filter(|controller| class_of(cx, controller) == Some(CLASS) && !is_tuned(controller))
    {
        let pairs = wheels(cx, controller);
        for (key, said, range) in &controller.numbers {
            // where the file is for several robots, one of them may fit
            let found: Option<Vec<_>> =
                pairs.iter().map(|pair| pair.mismatch(key, *said)).collect();
            let Some((message, real)) = found.and_then(|found| found.into_iter().next()) else {
                continue;
            };
            let span = Span {
                file: cx.file,
                range: *range,
            };
            out.report_span(span, message)
                .help(format!("write {}, or correct the wheels", length(real)))
                .done();
        }
    }
}

/// Whether a factor that was measured corrects the lengths.
fn is_tuned(controller: &Controller) -> bool {
    let mut numbers = controller.numbers.iter();
    #[allow(clippy::float_cmp)]
    numbers.any(|(key, value, _)| key.ends_with("_multiplier") && *value != 1.0)
}

/// The first wheels of a controller on each side, in each robot that has them.
pub(super) fn wheels<'a>(cx: &BesideCx<'a>, controller: &Controller) -> Vec<WheelPair<'a>> {
    let named = |key: &str| {
        let mut all = controller.joints.iter().filter(|(own, _)| own == key);
        let (_, first) = all.next()?;
        Some(first.name.as_str())
    };
    let joints = JOINTS
        .iter()
        .find_map(|[left, right]| Some([named(left)?, named(right)?]));
    let Some(joints) = joints else {
        return Vec::new();
    };
    let robots = cx.robots.iter();
    robots
        .filter(|paired| !names_variant(cx, paired))
        .filter_map(|paired| {
            let bounds = |link: &Link| link_bounds(paired.expansion, paired.robot, cx.world, link);
            WheelPair::of(paired.robot, paired.kinematics, joints, &bounds)
        })
        .collect()
}

/// The first wheel on the left.
pub(super) fn first_joint(controller: &Controller) -> Option<&SpannedName> {
    let mut all = controller.joints.iter();
    let is_left = |key: &str| JOINTS.iter().any(|[left, _]| *left == key);
    all.find_map(|(key, name)| is_left(key).then_some(name))
}

/// Whether a robot names another variant of the file for its controllers: one of the same name in a folder beside it, or one in its
/// folder of which a part of the name is another one. Which variant it names is decided by what decides on its wheels.
fn names_variant(cx: &BesideCx<'_>, paired: &PairedRobot<'_>) -> bool {
    let tree = &paired.expansion.tree;
    let own = cx.world.vfs.path(cx.file);
    let blocks = paired.robot.gazebo.iter();
    let parameters = blocks
        .flat_map(|block| tree.below(block.element))
        .filter(|&id| tree.get(id).text == "parameters")
        .filter_map(|id| AttrValue::content(tree, id))
        .map(|text| PathBuf::from(text.value.trim()));
    let arguments = paired.expansion.arguments.iter();
    let given = arguments.map(|(_, value)| PathBuf::from(value.as_str()));
    let named: Vec<PathBuf> = parameters.chain(given).collect();
    let is_own = |path: &PathBuf| names(path) == names(&own);
    !named.iter().any(is_own) && named.iter().any(|path| are_variants(path, &own))
}

/// The names of a file and of the two folders around it, from inside to outside. A build may put them elsewhere.
fn names(path: &Path) -> [&OsStr; 3] {
    let mut names = path.iter().rev();
    std::array::from_fn(|_| names.next().unwrap_or_default())
}

/// Whether two paths are those of variants of a file.
fn are_variants(one: &Path, other: &Path) -> bool {
    let ([name, folder, outer], [other_name, other_folder, other_outer]) =
        (names(one), names(other));
    if name == other_name {
        return folder != other_folder && outer == other_outer;
    }
    let first = |name: &OsStr| {
        let name = name.to_string_lossy();
        let end = name.find(['.', '_', '-'])?;
        name.get(..=end).map(str::to_owned)
    };
    folder == other_folder
        && one.extension() == other.extension()
        && first(name).is_some_and(|part| Some(part) == first(other_name))
}
