//! Parameters of nodes that hold a robot: launch reads them as YAML unless their type is given.

use std::path::Path;

use super::{calls, read};

/// Check whether launch reads the one robot that a file calls as YAML.
fn check_read_as_yaml(form: &str, name: &str, text: &str, expected: bool) {
    let file = read(Path::new(name), text);
    let all = file.iter().flat_map(calls);
    let found: Vec<bool> = all.map(|call| call.is_read_as_yaml).collect();
    assert_eq!(found, [expected], "{form}\n{text}");
}

#[test]
fn parameters_in_python() {
    let command = "Command(['xacro ', '/r/a.xacro'])";
    let forms = [
        (
            "inline",
            "Node(parameters=[{'robot_description': COMMAND}])",
            true,
        ),
        (
            "in a variable",
            "robot = COMMAND\nNode(parameters=[{'robot_description': robot}])",
            true,
        ),
        (
            "with others in a variable",
            "both = {'robot_description': COMMAND, 'use_sim_time': True}\nNode(package='p', parameters=[both, 'a.yaml'])",
            true,
        ),
        (
            "of a function",
            "def robot():\n    return {'robot_description': COMMAND}\nNode(parameters=[robot()])",
            true,
        ),
        (
            "with a type",
            "Node(parameters=[{'robot_description': ParameterValue(COMMAND, value_type=str)}])",
            false,
        ),
        (
            "in a variable with a type",
            "robot = ParameterValue(COMMAND, value_type=str)\nNode(parameters=[{'robot_description': robot}])",
            false,
        ),
        (
            "for another launch file",
            "Include(launch_arguments={'robot': COMMAND}.items())",
            false,
        ),
        ("for nobody", "robot = COMMAND", false),
    ];
    for (form, text, expected) in forms {
        let text = text.replace("COMMAND", command);
        check_read_as_yaml(form, "/ws/launch/a.launch.py", &text, expected);
    }
}

#[test]
fn parameters_in_xml() {
    let launch = |rest: &str| {
        format!(
            "<launch><node><param name='robot_description' value=\"$(command 'xacro /r/a.xacro')\"{rest}/></node></launch>"
        )
    };
    let old = "<launch><param name='robot_description' command='xacro /r/a.xacro'/></launch>";
    let forms = [
        ("without a type", launch(""), true),
        ("with a type", launch(" type='str'"), false),
        ("ROS 1 takes the text as it is", old.to_owned(), false),
    ];
    for (form, text, expected) in forms {
        check_read_as_yaml(form, "/ws/launch/a.launch.xml", &text, expected);
    }
}
