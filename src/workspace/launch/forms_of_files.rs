//! The forms in which launch files name files other than descriptions.

use std::path::Path;

use super::{LaunchContext, opened_in, read};

/// Check which files a launch file names.
fn check_files(name: &str, forms: &[(&str, &str, &[&str])]) {
    for (form, text, expected) in forms {
        let comment = if name.ends_with(".py") {
            "# makes a LaunchDescription\n"
        } else {
            ""
        };
        let file = read(Path::new(name), &format!("{comment}{text}"));
        let opened = file.map(|file| opened_in(&file, &LaunchContext::default()));
        let found: Vec<String> = opened
            .iter()
            .flatten()
            .map(|one| one.file.shown())
            .collect();
        assert_eq!(found, *expected, "{form}\n{text}");
    }
}

#[test]
fn xml() {
    let forms = [
        (
            "parameters",
            "<rosparam command='load' file='$(find r)/a.yaml'/>",
            vec!["$(find r)/a.yaml"],
        ),
        (
            "parameters that are written",
            "<rosparam command='dump' file='$(find r)/a.yaml'/>",
            vec![],
        ),
        (
            "parameters of a node",
            "<node><param from='$(find-pkg-share r)/a.yaml'/></node>",
            vec!["$(find r)/a.yaml"],
        ),
        (
            "another launch file, and what it is given",
            "<include file='$(find r)/a.launch'><arg name='world' value='$(find r)/a.world'/></include>",
            vec!["$(find r)/a.world", "$(find r)/a.launch"],
        ),
        (
            "settings of RViz by a default",
            "<arg name='d' default='$(find r)/a.rviz'/><node type='rviz' args='-d $(arg d) -f map'/>",
            vec!["$(find r)/a.rviz"],
        ),
        (
            "a value of another parameter, a default that nothing reads",
            "<arg name='d' default='$(find r)/a.rviz'/><param name='a' value='$(find r)/a.yaml'/>",
            vec![],
        ),
    ];
    for (form, inner, expected) in &forms {
        let launch = format!("<launch>{inner}</launch>");
        check_files("/ws/launch/a.launch", &[(form, &launch, expected)]);
    }
}

#[test]
fn python() {
    check_files(
        "/ws/launch/a.launch.py",
        &[
            (
                "parameters and settings of RViz",
                "p = get_package_share_directory('r')\nNode(parameters=[p + '/a.yaml', {'b': 1}], arguments=['-d', p + '/a.rviz'])",
                &["$(find r)/a.yaml", "$(find r)/a.rviz"],
            ),
            (
                "another launch file, and what it is given",
                "p = get_package_share_directory('r')\nIncludeLaunchDescription(p + '/a.launch.py', launch_arguments={'world': p + '/a.sdf', 'x': '1'}.items())",
                &["$(find r)/a.sdf", "$(find r)/a.launch.py"],
            ),
            (
                "a line of words",
                "p = get_package_share_directory('r')\nIncludeLaunchDescription('/g/gz_sim.launch.py', launch_arguments={'gz_args': ['-r -v 4 ', p, '/a.sdf']}.items())",
                &["$(find r)/a.sdf", "/g/gz_sim.launch.py"],
            ),
            (
                "a path that is joined",
                "p = get_package_share_directory('r')\nNode(parameters=[os.path.join(p, 'config', 'a.yaml')])",
                &["$(find r)/config/a.yaml"],
            ),
            (
                "a node that nothing starts",
                "node = Node(parameters=['/r/a.yaml'])\n",
                &[],
            ),
            (
                "a text that is not passed on",
                "p = '/r/a.yaml'\nprint(p)",
                &[],
            ),
        ],
    );
}
