//! Nodes that load the hardware of robots, compared with the robots that they are started with.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::called_robots::CalledRobots;
use super::includers::is_for_tests;
use super::kept::is_launch_left_over;
use super::session::Session;
use base::{CancelFlag, Span, TextRange};
use expand::Expansion;
use model::{AttrValue, Robot};
use rules::{Finding, Severity, span_of, unloadable_hardware};
use workspace::{ControlNode, RobotCall};

/// What the names of hardware begin with that only a plugin of Gazebo loads.
///
/// Source: the plugin descriptions of gazebo_ros2_control, gz_ros2_control and ign_ros2_control, whose base classes are their own.
const OF_GAZEBO: [&str; 3] = [
    "gazebo_ros2_control/",
    "gz_ros2_control/",
    "ign_ros2_control/",
];
/// The program that loads hardware.
const PROGRAM: &str = "ros2_control_node";

/// What the launch files below a folder that are asked for have nodes load in vain.
pub(super) fn findings_of_hardware(
    session: &Session,
    cancel: &CancelFlag,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    is_asked: impl Fn(&PathBuf) -> bool,
) -> Vec<Finding> {
    let nodes = session.callers.control_nodes_below(top);
    let mut named: BTreeMap<Option<PathBuf>, bool> = BTreeMap::new();
    let asked = nodes.iter().filter(|one| {
        is_asked(&one.file)
            && !session.settings(&one.file).excludes(&one.file)
            && !is_launch_left_over(session, &one.file)
    });
    let mut found = Vec::new();
    for node in asked {
        if cancel.is_cancelled() {
            break;
        }
        let around = session.packages.sources_around(&node.file);
        let is_named = named.entry(around);
        if *is_named.or_insert_with(|| is_named_around(session, &node.file)) {
            found.extend(unloadable(session, robots, top, node));
        }
    }
    found
}

/// Whether any description around a launch file has such hardware: no robot need be expanded otherwise.
fn is_named_around(session: &Session, launch: &Path) -> bool {
    let descriptions = session.callers.descriptions(launch);
    let names = |text: &str| OF_GAZEBO.iter().any(|start| text.contains(start));
    let mut all = descriptions.iter();
    all.any(|file| session.packages.is_text(file, names))
}

fn unloadable(
    session: &Session,
    robots: &mut CalledRobots<'_>,
    top: &Path,
    node: &ControlNode,
) -> Option<Finding> {
    let (calls, loads) = (
        session.callers.calls_below(top),
        session.callers.loads_below(top),
    );
    // of several robots, or of several ways to call one, any may be for the node
    let is_of = |call: &&RobotCall| node.started.contains(&call.call.caller);
    let all = calls.iter().chain(loads.iter()).filter(is_of);
    let is_known = |call: &RobotCall| {
        let mut args = call.call.args.iter();
        args.all(|one| one.given(&session.packages, &call.call.caller).is_some())
    };
    let found: Option<Vec<(String, Span)>> = all
        .map(|call| {
            if !is_known(call) {
                return None;
            }
            let (expansion, robot) = robots.of(call)?;
            hardware_of_gazebo(expansion, robot)
        })
        .collect();
    let (name, place) = found?.into_iter().next()?;
    let span = Span {
        file: session.vfs.file_id(&node.file),
        range: program(session, node),
    };
    let mut finding = unloadable_hardware(span, &name, place);
    if is_for_tests(session, &node.file) {
        finding.severity = Severity::Info;
    }
    Some(finding)
}

/// The hardware of a robot and where it is named, where Gazebo runs all of it.
fn hardware_of_gazebo(expansion: &Expansion, robot: &Robot) -> Option<(String, Span)> {
    let tree = &expansion.tree;
    let hardware = robot.controls.iter().flat_map(|one| &one.hardware);
    let plugins = hardware.flat_map(|&hardware| {
        let plugins = tree.elements(hardware);
        plugins.filter(|&plugin| tree.get(plugin).text == "plugin")
    });
    let names: Vec<AttrValue> = plugins
        .filter_map(|plugin| AttrValue::content(tree, plugin))
        .collect();
    let is_of_gazebo = |name: &AttrValue| {
        let name = name.value.trim();
        OF_GAZEBO.iter().any(|start| name.starts_with(start))
    };
    let first = names.first().filter(|_| names.iter().all(is_of_gazebo))?;
    let place = span_of(expansion, first.origin)?;
    Some((first.value.trim().to_owned(), place))
}

/// Where a node names its program.
fn program(session: &Session, node: &ControlNode) -> TextRange {
    let text = session.vfs.text(&node.file).ok();
    let within = text.as_ref().and_then(|text| {
        let (start, end) = (node.range.start as usize, node.range.end as usize);
        text.text.get(start..end)
    });
    let at = within.and_then(|within| within.find(PROGRAM));
    at.map_or(node.range, |at| {
        let start = node.range.start + at as u32;
        TextRange::new(start, start + PROGRAM.len() as u32)
    })
}

#[cfg(test)]
mod tests {
    use super::super::set_aside_tests::found;
    use super::PROGRAM;

    const PACKAGE: &str = "<package><name>cart</name></package>";

    /// Check whether a launch file that calls the robot so starts a node that cannot load its hardware.
    fn check(launch: &str, is_found: bool) {
        let robot = "<robot name='cart' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='sim' default='true'/>\
                     <link name='base'/><ros2_control name='drive' type='system'><hardware>\
                     <xacro:if value='$(arg sim)'><plugin>gz_ros2_control/GazeboSimSystem</plugin></xacro:if>\
                     <xacro:unless value='$(arg sim)'><plugin>mock_components/GenericSystem</plugin></xacro:unless>\
                     </hardware></ros2_control></robot>";
        let inner = "path = get_package_share_directory('cart') + '/cart.xacro'\nDeclareLaunchArgument('sim', default_value='true')\n\
                     Node(parameters=[{'robot_description': Command(['xacro ', path, ' sim:=', LaunchConfiguration('sim')])}])\n";
        let files = [
            ("package.xml", PACKAGE),
            ("cart.xacro", robot),
            ("launch/robot.launch.py", inner),
            ("launch/cart.launch.py", launch),
        ];
        let count = found(&files, "unloadable-hardware").len();
        assert_eq!(count, usize::from(is_found), "{launch}");
    }

    #[test]
    fn hardware_that_a_node_cannot_load() {
        let node = format!("Node(package='controller_manager', executable='{PROGRAM}')\n");
        let call = |args: &str| {
            format!(
                "path = get_package_share_directory('cart') + '/cart.xacro'\nCommand(['xacro ', path{args}])\n"
            )
        };
        check(&format!("{}{node}", call("")), true);
        check(&call(""), false);
        check(&format!("{}{node}", call(", ' sim:=false'")), false);
        let unknown = call(", ' sim:=', LaunchConfiguration('sim')");
        check(&format!("{unknown}{node}"), false);
        let conditional = node.replace(")\n", ", condition=IfCondition(real))\n");
        check(&format!("{}{conditional}", call("")), false);
        let unstarted = format!("{}node = {node}LaunchDescription([])\n", call(""));
        check(&unstarted, false);
    }

    #[test]
    fn the_robot_of_a_launch_file_that_is_included() {
        let node = format!("Node(package='controller_manager', executable='{PROGRAM}')\n");
        let include = |args: &str| {
            format!(
                "inner = os.path.join(os.path.dirname(__file__), 'robot.launch.py')\nIncludeLaunchDescription(inner{args})\n{node}"
            )
        };
        check(&include(""), true);
        let real = ", launch_arguments={'sim': 'false'}.items()";
        check(&include(real), false);
    }

    #[test]
    fn xml() {
        let launch = |node: &str| {
            format!(
                "<launch><let name='d' value=\"$(command 'xacro $(find-pkg-share cart)/cart.xacro')\"/>{node}</launch>"
            )
        };
        let check_xml = |node: &str, is_found: bool| {
            let robot = "<robot name='cart'><link name='base'/><ros2_control name='d' type='system'><hardware>\
                         <plugin>ign_ros2_control/IgnitionSystem</plugin></hardware></ros2_control></robot>";
            let launch = launch(node);
            let files = [
                ("package.xml", PACKAGE),
                ("cart.xacro", robot),
                ("launch/cart.launch.xml", launch.as_str()),
            ];
            let count = found(&files, "unloadable-hardware").len();
            assert_eq!(count, usize::from(is_found), "{launch}");
        };
        check_xml(
            "<node pkg='controller_manager' exec='ros2_control_node'/>",
            true,
        );
        check_xml(
            "<node pkg='controller_manager' exec='ros2_control_node' if='$(var real)'/>",
            false,
        );
    }
}
