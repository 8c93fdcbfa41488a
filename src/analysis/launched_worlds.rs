//! Worlds of Gazebo that launch files name, compared with the sensors of the robots that are started in them.
use std::path::{Path, PathBuf};

use super::called_robots::CalledRobots;
use super::kept::is_launch_left_over;
use super::session::Session;
use base::{CancelFlag, FastSet, Span};
use expand::{Expansion, XId};
use model::{Robot, tag_start};
use rules::{Finding, Severity, missing_sensors_system, span_of};
use workspace::RobotCall;

/// The kinds of sensors that the system of sensors runs.
///
/// Source: `Sensors.cc` of gz-sim.
const RENDERED: [&str; 8] = [
    "boundingbox_camera",
    "camera",
    "depth_camera",
    "gpu_lidar",
    "rgbd_camera",
    "segmentation_camera",
    "thermal_camera",
    "wide_angle_camera",
];
/// A part of the names of that system, in Gazebo and Ignition.
const SYSTEM: &str = "sensors";
/// What the names of systems begin with.
const SYSTEMS: [&str; 4] = [
    "gz-sim",
    "libgz-sim",
    "ignition-gazebo",
    "libignition-gazebo",
];

/// What the worlds lack that launch files below a folder name which are asked for.
pub(super) fn findings_of_worlds(
    session: &Session,
    cancel: &CancelFlag,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    is_asked: impl Fn(&PathBuf) -> bool,
) -> Vec<Finding> {
    let opened = session.callers.opened_below(top);
    let asked = opened.iter().filter(|one| {
        let caller = &one.call.caller;
        is_asked(caller) && !session.settings(caller).excludes(caller)
    });
    let mut seen: FastSet<&Path> = FastSet::default();
    let mut found = Vec::new();
    for one in asked {
        let Some(world) = one.target.as_deref().filter(|file| is_world(file)) else {
            continue;
        };
        if cancel.is_cancelled() {
            break;
        }
        if session.packages.is_text(world, runs_no_sensors) && seen.insert(world) {
            found.extend(without_sensors(session, robots, top, one));
        }
    }
    found
}

fn is_world(file: &Path) -> bool {
    let ending = file.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| ["sdf", "world"].contains(&ending))
}

/// Whether a text is a world that names its systems, and that of sensors is not one of them.
fn runs_no_sensors(text: &str) -> bool {
    text.contains("<world")
        && SYSTEMS.iter().any(|start| text.contains(start))
        && !text.contains(SYSTEM)
}

fn without_sensors(
    session: &Session,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    named: &RobotCall,
) -> Option<Finding> {
    let caller = &named.call.caller;
    let package = |file: &Path| {
        session
            .packages
            .containing(file)
            .map(|package| package.folder)
    };
    let own = package(caller)?;
    let (calls, loads) = (
        session.callers.calls_below(top),
        session.callers.loads_below(top),
    );
    let is_beside = |call: &&RobotCall| package(&call.call.caller).as_ref() == Some(&own);
    let mut first = None;
    for call in calls.iter().chain(loads.iter()).filter(is_beside) {
        // a robot may bring the system along, and so may one that cannot be expanded
        let (expansion, robot) = robots.of(call)?;
        if brings_system(expansion, robot) {
            return None;
        }
        first = first.or_else(|| rendered_sensor(expansion, robot));
    }
    let (name, place) = first?;
    let span = Span {
        file: session.vfs.file_id(caller),
        range: named.call.file.written().unwrap_or(named.call.range),
    };
    let world = named.target.as_ref()?.file_name()?.to_string_lossy();
    let mut finding = missing_sensors_system(span, &world, (&name, place));
    if is_launch_left_over(session, caller) || session.callers.is_of_tests(caller) {
        finding.severity = Severity::Info;
    }
    Some(finding)
}

fn elements<'e>(
    expansion: &'e Expansion,
    robot: &'e Robot,
    name: &'e str,
) -> impl Iterator<Item = XId> + 'e {
    let tree = &expansion.tree;
    let blocks = robot.gazebo.iter();
    let inside = blocks.flat_map(|block| tree.below(block.element));
    inside.filter(move |&id| tree.get(id).text == name)
}

fn brings_system(expansion: &Expansion, robot: &Robot) -> bool {
    elements(expansion, robot, "plugin").any(|plugin| {
        let file = expansion.tree.attr(plugin, "filename");
        file.is_none_or(|file| file.value.contains(SYSTEM))
    })
}

/// The first sensor of a robot that needs the system, and no plugin of Gazebo Classic: its name or kind, and its place.
fn rendered_sensor(expansion: &Expansion, robot: &Robot) -> Option<(String, Span)> {
    let tree = &expansion.tree;
    let mut sensors = elements(expansion, robot, "sensor");
    let sensor = sensors.find(|&sensor| {
        let kind = tree.attr(sensor, "type");
        let has_plugin = tree
            .elements(sensor)
            .any(|id| tree.get(id).text == "plugin");
        kind.is_some_and(|kind| RENDERED.contains(&kind.value.as_str())) && !has_plugin
    })?;
    let named = ["name", "type"]
        .iter()
        .find_map(|name| tree.attr(sensor, name));
    let place = span_of(expansion, tag_start(expansion, sensor))?;
    Some((named?.value.to_string(), place))
}

#[cfg(test)]
mod tests {
    use super::super::set_aside_tests::found;

    const PHYSICS: &str = "<plugin filename='gz-sim-physics-system' name='p'/>";
    const SENSORS: &str = "<plugin filename='gz-sim-sensors-system' name='s'/>";
    const CAMERA: &str = "<sensor name='front' type='camera'/>";

    /// Check whether a robot with this in its `gazebo` element has sensors in vain in a world with these plugins.
    fn check(gazebo: &str, plugins: &str, is_found: bool) {
        let robot =
            format!("<robot name='cart'><link name='base'/><gazebo>{gazebo}</gazebo></robot>");
        let world = format!("<sdf><world name='hall'>{plugins}</world></sdf>");
        let launch = "here = get_package_share_directory('cart')\nCommand(['xacro ', here + '/cart.xacro'])\n\
                      IncludeLaunchDescription(gz, launch_arguments={'gz_args': ['-r ', here, '/hall.sdf']}.items())\n";
        let files = [
            ("package.xml", "<package><name>cart</name></package>"),
            ("cart.xacro", robot.as_str()),
            ("hall.sdf", world.as_str()),
            ("launch/cart.launch.py", launch),
        ];
        let count = found(&files, "missing-sensors-system").len();
        assert_eq!(count, usize::from(is_found), "{robot}\n{world}");
    }

    #[test]
    fn worlds_that_run_no_sensors() {
        check(CAMERA, PHYSICS, true);
        check(CAMERA, &format!("{PHYSICS}{SENSORS}"), false);
        // what a world without plugins gets is not known
        check(CAMERA, "", false);
        check(&format!("{CAMERA}{SENSORS}"), PHYSICS, false);
        // an IMU needs another system, and a plugin of Gazebo Classic brings its own
        check("<sensor name='imu' type='imu'/>", PHYSICS, false);
        let classic = "<sensor name='front' type='camera'><plugin filename='libgazebo_ros_camera.so'/></sensor>";
        check(classic, PHYSICS, false);
    }
}
