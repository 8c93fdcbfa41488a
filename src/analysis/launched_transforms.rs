//! Transforms that launch files publish beside robots that have them already.
use std::path::{Path, PathBuf};

use super::called_robots::CalledRobots;
use super::kept::is_launch_left_over;
use super::session::Session;
use base::{CancelFlag, Span};
use expand::Expansion;
use model::{Joint, JointType, Robot};
use rules::{Finding, looping_transform, repeated_transform, span_of};
use workspace::launch::StaticTransform;
use workspace::{PublishedTransform, RobotCall};

/// The program that publishes the transforms of a robot.
const PUBLISHER: &str = "robot_state_publisher";
/// What gives the frames of a robot other names than its links have.
const RENAMES: [&str; 2] = ["tf_prefix", "frame_prefix"];
/// Lengths and angles that differ by less are the same, in meters and radians.
const TOLERANCE: f64 = 1e-3;

/// What is published twice by the launch files below a folder that are asked for.
pub(super) fn findings_of_transforms(
    session: &Session,
    cancel: &CancelFlag,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    is_asked: impl Fn(&PathBuf) -> bool,
) -> Vec<Finding> {
    let transforms = session.callers.transforms_below(top);
    let asked = transforms.iter().filter(|PublishedTransform { file, .. }| {
        is_asked(file)
            && !session.settings(file).excludes(file)
            && !is_launch_left_over(session, file)
    });
    let mut found = Vec::new();
    for published in asked {
        if cancel.is_cancelled() {
            break;
        }
        found.extend(conflict(session, robots, top, published));
    }
    found
}

/// What is wrong with a transform for one of the robots that its launch file starts.
fn conflict(
    session: &Session,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    published: &PublishedTransform,
) -> Option<Finding> {
    let callers = &session.callers;
    let (calls, loads) = (callers.calls_below(top), callers.loads_below(top));
    let span = Span {
        file: session.vfs.file_id(&published.file),
        range: published.transform.range,
    };
    let started = |call: &&RobotCall| published.started.contains(&call.call.caller);
    let mut all = calls.iter().chain(loads.iter()).filter(started);
    let is_still = callers.leave_joints_alone(&published.file);
    all.find_map(|call| {
        if !has_its_frames(session, &published.file, call) {
            return None;
        }
        let (expansion, robot) = robots.of(call)?;
        let is_sent = |joint: &Joint| !is_still || joint.is(&[JointType::Fixed]);
        compare(expansion, robot, span, (&published.transform, &is_sent))
    })
}

/// Whether the links of the robot of a call are the frames that are published.
fn has_its_frames(session: &Session, path: &Path, call: &RobotCall) -> bool {
    let says = |file: &Path, word: &str| session.packages.is_text(file, |text| text.contains(word));
    let caller = &call.call.caller;
    let is_renamed = |file: &Path| RENAMES.iter().any(|word| says(file, word));
    says(caller, PUBLISHER) && !is_renamed(caller) && !is_renamed(path)
}

/// What is wrong with a transform for a robot: a joint whose transform is sent places the frame as well, or the frame is above.
fn compare(
    expansion: &Expansion,
    robot: &Robot,
    span: Span,
    (transform, is_sent): (&StaticTransform, &dyn Fn(&Joint) -> bool),
) -> Option<Finding> {
    let StaticTransform { parent, child, .. } = transform;
    let kinematics = robot.kinematics();
    let place = |joint: &Joint| {
        let text = joint.child.as_ref()?;
        span_of(expansion, text.origin)
    };
    if let Some(joint) = joint_above(robot, child).filter(|joint| is_sent(joint)) {
        let is_same = is_same(joint, transform);
        return Some(repeated_transform(
            span,
            child,
            (joint.shown(), place(joint)?),
            is_same,
        ));
    }
    let mut above = kinematics.ancestor_joints(kinematics.link(parent)?);
    let joint = above.find_map(|joint| {
        let joint = robot.joints.get(joint)?;
        let (start, _) = joint.ends()?;
        (start == child).then_some(joint)
    })?;
    Some(looping_transform(
        span,
        child,
        parent,
        (joint.shown(), place(joint)?),
    ))
}

/// The joint that places a link, if robot_state_publisher publishes it.
fn joint_above<'r>(robot: &'r Robot, link: &str) -> Option<&'r Joint> {
    let places = |joint: &&Joint| joint.ends().is_some_and(|(_, child)| child == link);
    let joint = robot.joints.iter().find(places)?;
    (!joint.is(&[JointType::Floating])).then_some(joint)
}

/// Whether a joint that does not move says the same as a transform.
fn is_same(joint: &Joint, transform: &StaticTransform) -> bool {
    let near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < TOLERANCE);
    let origin = joint.origin.as_ref();
    let translation = origin.map_or(Some([0.0; 3]), |origin| origin.translation());
    let angles = origin.map_or(Some([0.0; 3]), |origin| origin.angles());
    joint.is(&[JointType::Fixed])
        && joint
            .ends()
            .is_some_and(|(parent, _)| *parent == transform.parent)
        && translation.is_some_and(|own| near(own, transform.translation))
        && transform.angles.zip(angles).is_none_or(|(a, b)| near(a, b))
}

#[cfg(test)]
mod tests {
    use super::super::set_aside_tests::found;
    use rules::Severity;

    const ROBOT: &str = "<robot name='cart'><link name='base'/><link name='laser'/><joint name='j' type='fixed'>\
                         <parent link='base'/><child link='laser'/><origin xyz='0 0 0.2' rpy='0 0 1'/></joint></robot>";

    /// Check what is said of a publisher with these words, in a launch file that goes on like this.
    fn check(words: &str, rest: &str, expected: Option<Severity>) {
        check_robot(ROBOT, words, rest, expected);
    }

    /// The same for another robot.
    fn check_robot(description: &str, words: &str, rest: &str, expected: Option<Severity>) {
        let publisher = |words: &str| {
            format!("<node pkg='tf2_ros' type='static_transform_publisher' args='{words}'/>")
        };
        let load = "<param name='robot_description' textfile='$(find cart)/cart.urdf'/>";
        let launch = format!("<launch>{}{rest}</launch>", publisher(words));
        let robot = format!("<launch>{load}<node pkg='robot_state_publisher'/></launch>");
        let files = [
            ("package.xml", "<package><name>cart</name></package>"),
            ("cart.urdf", description),
            ("a.launch", launch.as_str()),
            ("robot.launch", robot.as_str()),
        ];
        let severity = found(&files, "duplicate-transform")
            .first()
            .map(|one| one.1);
        assert_eq!(severity, expected, "{launch}");
    }

    #[test]
    fn frames_that_are_placed_twice() {
        let includes = "<include file='$(find cart)/robot.launch'/>";
        let other = "0 0 0.3 1 0 0 base laser";
        check(other, includes, Some(Severity::Warning));
        check("0 0 0.2 1 0 0 base laser", includes, Some(Severity::Info));
        check(
            "0 0 0.2 1 0 0 cart laser",
            includes,
            Some(Severity::Warning),
        );
        check(
            "0 0 0.2 1 0 0 laser base",
            includes,
            Some(Severity::Warning),
        );
        check("0 0 0.2 1 0 0 map base", includes, None);
        // another launch file starts the robot, and who starts both is not known
        check(other, "", None);
        let renamed = format!("<param name='tf_prefix' value='a'/>{includes}");
        check(other, &renamed, None);
        // nobody publishes the joints
        check(other, "<param textfile='$(find cart)/cart.urdf'/>", None);
    }

    #[test]
    fn joints_that_move_are_published_where_something_says_how_they_stand() {
        let robot = ROBOT.replace("fixed", "continuous");
        let includes = "<include file='$(find cart)/robot.launch'/>";
        let states = format!("{includes}<node pkg='joint_state_publisher'/>");
        let other = "0 0 0.3 1 0 0 base laser";
        check_robot(&robot, other, &states, Some(Severity::Warning));
        check_robot(&robot, other, includes, None);
    }
}
