//! A controller of a drive that is told other wheels than the robot has.
use super::super::beside::BesideCx;
use super::super::geometry::link_bounds;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::controller_unknown_interface::class_of;
use super::wheel_sizes::{WheelPair, length};
use base::Span;
use model::Link;
use project::Controller;

pub(in super::super) static RULE: Rule = Rule::beside(
    "CTL033",
    "controller-wheel-mismatch",
    Category::Control,
    Severity::Warning,
    page("controller-wheel-mismatch"),
    check,
);

const CLASS: &str = "diff_drive_controller/DiffDriveController";
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
fn wheels<'a>(cx: &BesideCx<'a>, controller: &Controller) -> Vec<WheelPair<'a>> {
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
        .filter_map(|paired| {
            let bounds = |link: &Link| link_bounds(paired.expansion, paired.robot, cx.world, link);
            WheelPair::of(paired.robot, paired.kinematics, joints, &bounds)
        })
        .collect()
}
