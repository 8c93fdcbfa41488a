//! Controllers that launch files start for robots in Gazebo, compared with what those robots have to run them.
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::called_robots::CalledRobots;
use super::kept::is_launch_left_over;
use super::session::Session;
use base::{CancelFlag, Span};
use expand::{Expansion, XId};
use model::{AttrValue, Robot};
use rules::{Finding, Lacking, Severity, missing_controller_manager};
use workspace::{RobotCall, SpawnedControllers};

/// What the names of the plugins of Gazebo hold that run a controller manager.
const PLUGIN: &str = "ros2_control";
/// Texts that start a controller manager themselves, or another simulator that has one.
const OTHERS: [&str; 5] = [
    "ros2_control_node",
    "webots",
    "mujoco",
    "isaac",
    "controller_manager_node",
];
/// What the names of plugins begin with that come with Gazebo and its bridges to ROS: of others, what they run is not known.
const KNOWN: [&str; 5] = [
    "gz-sim",
    "ignition-gazebo",
    "libgazebo_ros_",
    "libgz-sim",
    "libignition-gazebo",
];
/// Packages that start Gazebo.
const GAZEBO: [&str; 4] = [
    "ros_gz_sim",
    "ros_ign_gazebo",
    "gazebo_ros",
    "ros_gz_bringup",
];

/// What the launch files below a folder that are asked for have no controller manager for.
pub(super) fn findings_of_managers(
    session: &Session,
    cancel: &CancelFlag,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    is_asked: impl Fn(&PathBuf) -> bool,
) -> Vec<Finding> {
    let spawned = session.callers.spawned_below(top);
    let asked = spawned.iter().filter(|one| {
        is_asked(&one.file)
            && !session.settings(&one.file).excludes(&one.file)
            && !is_launch_left_over(session, &one.file)
    });
    let mut found = Vec::new();
    for one in asked {
        if cancel.is_cancelled() {
            break;
        }
        found.extend(unmanaged(session, robots, top, one));
    }
    found
}

fn unmanaged(
    session: &Session,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    spawned: &SpawnedControllers,
) -> Option<Finding> {
    let reached = spawned.reached.as_ref()?;
    let names = |words: &[&str]| {
        let mut files = reached.iter();
        files.any(|file| {
            session
                .packages
                .is_text(file, |text| words.iter().any(|word| text.contains(word)))
        })
    };
    // an SDF may be spawned in place of the robot that is shown
    let spawns_sdf = names(&["-file"]) && names(&[".sdf"]);
    if names(&OTHERS) || !names(&GAZEBO) || spawns_sdf || is_in_world(session, top, reached) {
        return None;
    }
    let controller = spawned.controllers.first()?;
    let calls = calls_of(session, top, spawned)?;
    let lacking: Option<Vec<Lacking>> = calls
        .iter()
        .map(|call| {
            let mut args = call.call.args.iter();
            let is_known =
                args.all(|one| one.given(&session.packages, &call.call.caller).is_some());
            let (expansion, robot) = robots.of(call).filter(|_| is_known)?;
            lacking(expansion, robot)
        })
        .collect();
    let lacking = lacking?.first().copied()?;
    let call = calls.first()?;
    let at = |file: &Path, range| Span {
        file: session.vfs.file_id(file),
        range,
    };
    let robot = call.target.as_ref()?.file_name()?.to_string_lossy();
    let place = call.call.file.place().unwrap_or(call.call.range);
    let mut finding = missing_controller_manager(
        at(&spawned.file, controller.range),
        &controller.name,
        lacking,
        (at(&call.call.caller, place), &robot),
    );
    if session.callers.is_of_tests(&spawned.file) {
        finding.severity = Severity::Info;
    }
    Some(finding)
}

/// Whether a world that launch files name has a plugin of ros2_control.
fn is_in_world(session: &Session, top: &Path, launch_files: &[PathBuf]) -> bool {
    let opened = session.callers.opened_below(top);
    let mut named = opened
        .iter()
        .filter(|one| launch_files.contains(&one.call.caller))
        .filter_map(|one| one.target.as_ref());
    named.any(|file| session.packages.is_text(file, |text| text.contains(PLUGIN)) && is_world(file))
}

fn is_world(file: &Path) -> bool {
    let ending = file.extension().and_then(OsStr::to_str);
    ending.is_some_and(|ending| ["sdf", "world"].contains(&ending))
}

/// The robots that a launch file starts, as it starts them: of those that it includes, with the arguments that it gives. None where a
/// program of its own may expand one.
fn calls_of(session: &Session, top: &Path, spawned: &SpawnedControllers) -> Option<Vec<RobotCall>> {
    let (calls, loads) = (
        session.callers.calls_below(top),
        session.callers.loads_below(top),
    );
    let is_of = |call: &&RobotCall| spawned.started.contains(&call.call.caller);
    let is_for_xacro = |load: &RobotCall| {
        let name = load.target.as_deref().and_then(Path::file_name);
        name.is_some_and(|name| name.to_string_lossy().contains("xacro"))
    };
    if loads.iter().filter(is_of).any(is_for_xacro) {
        return None;
    }
    let all: Vec<&RobotCall> = calls.iter().chain(loads.iter()).filter(is_of).collect();
    let is_through = |call: &RobotCall| call.call.through.first() == Some(&spawned.file);
    let is_by_itself = |call: &RobotCall| call.call.caller == spawned.file;
    let mut found = Vec::new();
    for call in &all {
        let caller = &call.call.caller;
        let mut same = all.iter().filter(|other| other.call.caller == *caller);
        let counts = if is_by_itself(call) {
            call.call.through.is_empty()
        } else {
            is_through(call) || !same.any(|other| is_through(other))
        };
        if counts {
            found.push((*call).clone());
        }
    }
    Some(found)
}

/// What a robot lacks; none of one that has a controller manager, or may have one.
fn lacking(expansion: &Expansion, robot: &Robot) -> Option<Lacking> {
    let tree = &expansion.tree;
    let blocks = robot.gazebo.iter();
    let inside = blocks.flat_map(|block| tree.below(block.element));
    let is_plugin = |id: &XId| tree.get(*id).text == "plugin";
    let plugins = inside.filter(is_plugin);
    let files: Option<Vec<AttrValue>> = plugins
        .map(|id| AttrValue::attr(tree, id, "filename"))
        .collect();
    let files = files?;
    let is_of_control = |file: &AttrValue| file.value.contains(PLUGIN);
    let is_known = |file: &AttrValue| {
        let name = file.value.as_str();
        file.is_known()
            && (is_of_control(file) || KNOWN.iter().any(|start| name.starts_with(start)))
    };
    if !files.iter().all(is_known) {
        None
    } else if !files.iter().any(is_of_control) {
        Some(Lacking::Plugin)
    } else {
        robot.controls.is_empty().then_some(Lacking::Control)
    }
}

#[cfg(test)]
mod tests {
    use super::super::set_aside_tests::found;

    const SPAWNER: &str =
        "Node(package='controller_manager', executable='spawner', arguments=['drive'])\n";
    const GAZEBO: &str = "Node(package='ros_gz_sim', executable='create')\n";
    const PLUGIN: &str =
        "<gazebo><plugin filename='libgz_ros2_control-system.so' name='p'/></gazebo>";
    const CONTROL: &str = "<ros2_control name='c' type='system'/>";

    /// Check whether controllers are started in vain for a robot that is called so.
    fn check(robot: &str, launch: &str, is_found: bool) {
        let robot = format!(
            "<robot name='cart' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='sim' default='true'/>\
             <link name='base'/>{robot}</robot>"
        );
        let inner = "DeclareLaunchArgument('sim', default_value='true')\npath = get_package_share_directory('cart') + '/cart.xacro'\n\
                     Command(['xacro ', path, ' sim:=', LaunchConfiguration('sim')])\n";
        let files = [
            ("package.xml", "<package><name>cart</name></package>"),
            ("cart.xacro", robot.as_str()),
            ("launch/robot.launch.py", inner),
            ("launch/cart.launch.py", launch),
            (
                "worlds/with.sdf",
                "<sdf><plugin filename='libgz_ros2_control-system.so'/></sdf>",
            ),
        ];
        let count = found(&files, "missing-controller-manager").len();
        assert_eq!(count, usize::from(is_found), "{robot}\n{launch}");
    }

    fn include(args: &str) -> String {
        format!(
            "inner = os.path.join(os.path.dirname(__file__), 'robot.launch.py')\nIncludeLaunchDescription(inner{args})\n{GAZEBO}{SPAWNER}"
        )
    }

    #[test]
    fn robots_that_have_no_controller_manager() {
        check("", &include(""), true);
        check(PLUGIN, &include(""), true);
        check(CONTROL, &include(""), true);
        check(&format!("{PLUGIN}{CONTROL}"), &include(""), false);
        // what is not of Gazebo may run one
        let own = "<gazebo><plugin filename='libown.so' name='o'/></gazebo>";
        check(own, &include(""), false);
    }

    #[test]
    fn arguments_decide() {
        let robot = format!("<xacro:if value='$(arg sim)'>{PLUGIN}{CONTROL}</xacro:if>");
        check(&robot, &include(""), false);
        let real = ", launch_arguments={'sim': 'false'}.items()";
        check(&robot, &include(real), true);
        let unknown = ", launch_arguments={'sim': mode}.items()";
        check(&robot, &include(unknown), false);
    }

    #[test]
    fn launch_files_that_may_start_one() {
        let plain = include("");
        check("", &plain.replace(GAZEBO, ""), false);
        check("", &plain.replace(SPAWNER, ""), false);
        let node = "Node(package='controller_manager', executable='ros2_control_node', condition=IfCondition(real))\n";
        check("", &format!("{plain}{node}"), false);
        let other = "IncludeLaunchDescription(get_package_share_directory('driver') + '/launch/driver.launch.py')\n";
        check("", &format!("{plain}{other}"), false);
        let known = other.replace("'driver'", "'ros_gz_sim'");
        check("", &format!("{plain}{known}"), true);
        let sdf = "Node(package='ros_gz_sim', executable='create', arguments=['-file', folder + '/cart.sdf'])\n";
        check("", &format!("{plain}{sdf}"), false);
        let world = "Node(package='a', executable='b', arguments=[get_package_share_directory('cart') + '/worlds/with.sdf'])\n";
        check("", &format!("{plain}{world}"), false);
    }
}
