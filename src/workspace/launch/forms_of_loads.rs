//! The forms in which launch files load descriptions as they are, without xacro.

use std::path::Path;

use super::{LaunchContext, loads_in, read};

/// Check which descriptions a file loads as they are.
fn check_loads(name: &str, forms: &[(&str, &str, &[&str])]) {
    for (form, text, expected) in forms {
        let file = read(Path::new(name), text);
        let loads = file.map(|file| loads_in(&file, &LaunchContext::default()));
        let found: Vec<String> = loads
            .iter()
            .flatten()
            .map(|load| load.file.shown())
            .collect();
        assert_eq!(found, *expected, "{form}\n{text}");
    }
}

#[test]
fn xml() {
    let launch =
        |inner: &str| format!("<launch><arg name='m' default='$(find r)/a.urdf'/>{inner}</launch>");
    let forms = [
        (
            "the text of a file",
            launch("<param name='robot_description' textfile='$(find r)/a.urdf'/>"),
            vec!["$(find r)/a.urdf"],
        ),
        (
            "what cat prints",
            launch("<param name='robot_description' command='cat $(arg m)'/>"),
            vec!["$(find r)/a.urdf"],
        ),
        (
            "a spawner",
            launch(
                "<node pkg='gazebo_ros' type='spawn_model' args='-urdf -file $(arg m) -model r -z 0.1'/>",
            ),
            vec!["$(find r)/a.urdf"],
        ),
        (
            "what a program writes",
            launch("<node type='convert' args='-file $(find r)/in.urdf -o $(find r)/out.urdf'/>"),
            vec!["$(find r)/in.urdf"],
        ),
        (
            "what a shell writes",
            launch("<param name='d' command='cat $(arg m) > /tmp/out.urdf'/>"),
            vec!["$(find r)/a.urdf"],
        ),
        (
            "xacro reads it",
            launch(
                "<param name='d' command='$(find xacro)/xacro $(arg m)'/><rosparam textfile='a.urdf'/>",
            ),
            vec![],
        ),
        (
            "a node that runs xacro",
            launch("<node pkg='xacro' type='xacro' args='$(find r)/a.urdf.xacro -o a.urdf'/>"),
            vec![],
        ),
        (
            "other files",
            launch(
                "<param name='d' textfile='$(find r)/a.txt'/><node args='-d $(find r)/a.rviz -file'/>",
            ),
            vec![],
        ),
    ];
    for (form, text, expected) in &forms {
        check_loads("/ws/launch/a.launch", &[(form, text, expected)]);
    }
}

#[test]
fn python() {
    check_loads(
        "/ws/launch/a.launch.py",
        &[
            (
                "a file that is opened",
                "p = os.path.join(get_package_share_directory('r'), 'a.urdf')\nwith open(p, 'r') as f:\n    text = f.read()",
                &["$(find r)/a.urdf"],
            ),
            (
                "without a mode",
                "text = open('/r/a.urdf').read()",
                &["/r/a.urdf"],
            ),
            (
                "a file that is written",
                "open('/r/a.urdf', 'w').write(text)",
                &[],
            ),
            ("a mode that is computed", "open('/r/a.urdf', mode)", &[]),
            ("another file", "open('/r/a.yaml')  # not a.urdf", &[]),
            (
                "a path",
                "p = Path('/r') / 'a.urdf'\np.read_text()\np.open()\np.open('w')",
                &["/r/a.urdf", "/r/a.urdf"],
            ),
            (
                "a spawner",
                "Node(executable='create', arguments=['-name', 'r', '-file', '/r/a.urdf', '-z', '0.1'])",
                &["/r/a.urdf"],
            ),
            (
                "a process",
                "xacro = 0\nExecuteProcess(cmd=['spawn', '-file', '/r/a.urdf'])",
                &["/r/a.urdf"],
            ),
            (
                "xacro reads it",
                "ExecuteProcess(cmd=['xacro', '/r/a.xacro', '-file'])",
                &[],
            ),
        ],
    );
}
