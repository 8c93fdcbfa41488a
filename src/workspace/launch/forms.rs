//! The forms in which robots are called, each with what is known of it.
//!
//! Of a value that is not known, `?` says that the file computes it, `?name` that whoever starts the file gives it as the
//! argument `name`, `?if name` that a condition on that argument stands around the call; `...` says that there may be
//! further arguments.

use std::path::Path;

use super::{CommandWord, LaunchCall, Why, calls, read};

fn word(word: &CommandWord) -> String {
    match word.why() {
        None => word.shown(),
        Some(Why::Computed) => word.shown(),
        Some(Why::Required(name)) => word.shown().replacen('?', &format!("?{name}"), 1),
        Some(Why::Decided(name)) => word.shown().replacen('?', &format!("?if {name}"), 1),
    }
}

fn shown(call: &LaunchCall) -> String {
    let mut text = word(&call.file);
    for arg in &call.args {
        text.push_str(&format!(" {}={}", arg.name, word(&arg.value)));
    }
    if call.open {
        text.push_str(" ...");
    }
    text
}

/// Check what is known of the calls in a file.
fn check(form: &str, name: &str, text: &str, expected: &[&str]) {
    let file = read(Path::new(name), text);
    let found: Vec<String> = file
        .iter()
        .flat_map(calls)
        .map(|call| shown(&call))
        .collect();
    assert_eq!(found, expected, "{form}\n{text}");
}

pub(super) fn check_python(forms: &[(&str, &str, &[&str])]) {
    for (form, text, expected) in forms {
        check(form, "/ws/arm_bringup/launch/arm.launch.py", text, expected);
    }
}

/// A description in a package, as Python joins it.
const ARM: &str = "$(find arm)/urdf/arm.urdf.xacro";

#[test]
fn python_commands() {
    check_python(&[
        (
            "list, with the words of the command in pieces",
            "Command(['xacro ', '/r/arm.urdf.xacro', ' side:=', 'left', ' n:=2'])",
            &["/r/arm.urdf.xacro side=left n=2"],
        ),
        (
            "one text",
            "Command('xacro /r/arm.urdf.xacro side:=left')",
            &["/r/arm.urdf.xacro side=left"],
        ),
        (
            "keyword",
            "Command(command=['xacro ', '/r/a.xacro'])",
            &["/r/a.xacro"],
        ),
        (
            "list with a constant variable",
            "path = '/r/a.xacro'\nx = Command(['xacro ', path])",
            &["/r/a.xacro"],
        ),
        (
            "program found by the launch system",
            "Command([PathJoinSubstitution([FindExecutable(name='xacro')]), ' ', \
             PathJoinSubstitution([FindPackageShare('arm'), 'urdf', 'arm.urdf.xacro']), ' ', 'side:=', 'left', ' '])",
            &["$(find arm)/urdf/arm.urdf.xacro side=left"],
        ),
        (
            "argument of the launch file with a default",
            "DeclareLaunchArgument('side', default_value='left')\n\
             Command(['xacro /r/a.xacro side:=', LaunchConfiguration('side')])",
            &["/r/a.xacro side=left"],
        ),
        (
            "argument declared by keyword, after its use",
            "c = Command(['xacro /r/a.xacro side:=', LaunchConfiguration(variable_name='side')])\n\
             d = DeclareLaunchArgument(name='side', description='x', default_value=TextSubstitution(text='left'))",
            &["/r/a.xacro side=left"],
        ),
        (
            "argument without a default",
            "DeclareLaunchArgument('side')\nCommand(['xacro /r/a.xacro side:=', LaunchConfiguration('side')])",
            &["/r/a.xacro side=?side"],
        ),
        (
            "argument that another file declares",
            "Command(['xacro /r/a.xacro side:=', LaunchConfiguration('side')])",
            &["/r/a.xacro side=?"],
        ),
        (
            "default where the value is read",
            "Command(['xacro /r/a.xacro side:=', LaunchConfiguration('side', default='left')])",
            &["/r/a.xacro side=left"],
        ),
        (
            "declared without the default that is written where it is read",
            "DeclareLaunchArgument('side')\nCommand(['xacro /r/a.xacro side:=', LaunchConfiguration('side', default='left')])",
            &["/r/a.xacro side=?side"],
        ),
        (
            "two declarations that differ",
            "DeclareLaunchArgument('side', default_value='left')\nDeclareLaunchArgument('side', default_value='right')\n\
             Command(['xacro /r/a.xacro side:=', LaunchConfiguration('side')])",
            &["/r/a.xacro side=?"],
        ),
        (
            "argument that is set later",
            "DeclareLaunchArgument('side', default_value='left')\nSetLaunchConfiguration('side', 'right')\n\
             Command(['xacro /r/a.xacro side:=', LaunchConfiguration('side')])",
            &["/r/a.xacro side=?"],
        ),
        (
            "default that is quoted for a shell",
            "DeclareLaunchArgument('tf', default_value='\"\"')\n\
             Command(['xacro /r/a.xacro tf:=', LaunchConfiguration('tf'), ' b:=\"x y\"'])",
            &["/r/a.xacro tf= b=x y"],
        ),
        (
            "default made of other arguments and packages",
            "DeclareLaunchArgument('pkg', default_value='arm')\n\
             DeclareLaunchArgument('file', default_value=[FindPackageShare(LaunchConfiguration('pkg')), '/c.yaml'])\n\
             Command(['xacro /r/a.xacro file:=', LaunchConfiguration('file')])",
            &["/r/a.xacro file=$(find arm)/c.yaml"],
        ),
        (
            "argument whose default is itself",
            "DeclareLaunchArgument('a', default_value=LaunchConfiguration('a'))\n\
             Command(['xacro /r/a.xacro a:=', LaunchConfiguration('a')])",
            &["/r/a.xacro a=?"],
        ),
        (
            "expression of the launch system",
            "Command(['xacro /r/a.xacro a:=', PythonExpression(['1 + ', '1'])])",
            &["/r/a.xacro a=?"],
        ),
        (
            "variable of the environment",
            "Command(['xacro /r/a.xacro a:=', EnvironmentVariable('A')])",
            &["/r/a.xacro a=?"],
        ),
        (
            "name of the description given from outside",
            "DeclareLaunchArgument('model')\nCommand(['xacro ', LaunchConfiguration('model'), ' a:=1'])",
            &["?model a=1"],
        ),
        (
            "further arguments given from outside",
            "Command(['xacro /r/a.xacro a:=1 ', LaunchConfiguration('more')])",
            &["/r/a.xacro a=1 ..."],
        ),
        (
            "options of xacro",
            "Command('xacro --inorder -o /tmp/x /r/a.xacro a:=1 __name:=b')",
            &["/r/a.xacro a=1"],
        ),
        ("another program", "Command(['cat ', '/r/a.xacro'])", &[]),
        ("text that is open", "Command('xacro \"/r/a.xacro')", &[]),
    ]);
}

#[test]
fn python_paths() {
    let command = |path: &str| format!("c = Command(['xacro ', {path}])");
    for (form, before, path, expected) in [
        (
            "os.path.join",
            "import os",
            "os.path.join(get_package_share_directory('arm'), 'urdf', 'arm.urdf.xacro')",
            ARM,
        ),
        (
            "join by name",
            "from os.path import join",
            "join(FindPackageShare(package='arm').find('arm'), 'urdf', 'arm.urdf.xacro')",
            ARM,
        ),
        (
            "step of a path",
            "from pathlib import Path",
            "str(Path(get_package_share_directory('arm')) / 'urdf/arm.urdf.xacro')",
            ARM,
        ),
        (
            "path of a package",
            "",
            "get_package_share_path('arm') / 'urdf' / 'arm.urdf.xacro'",
            ARM,
        ),
        (
            "path substitution",
            "",
            "PathSubstitution(FindPackageShare('arm')) / 'urdf' / 'arm.urdf.xacro'",
            ARM,
        ),
        (
            "joined texts",
            "p = get_package_share_directory('arm')",
            "p + '/urdf/arm.urdf.xacro'",
            ARM,
        ),
        (
            "f-string",
            "p = get_package_share_directory('arm')",
            "f'{p}/urdf/arm.urdf.xacro'",
            ARM,
        ),
        (
            "format",
            "p = get_package_share_directory('arm')",
            "'{}/urdf/{}'.format(p, 'arm.urdf.xacro')",
            ARM,
        ),
        (
            "percent",
            "p = get_package_share_directory('arm')",
            "'%s/urdf/%s' % (p, 'arm.urdf.xacro')",
            ARM,
        ),
        (
            "beside the launch file",
            "import os",
            "os.path.join(os.path.dirname(__file__), '..', 'urdf', 'a.xacro')",
            "/ws/arm_bringup/launch/../urdf/a.xacro",
        ),
        (
            "parents of the launch file",
            "from pathlib import Path",
            "Path(__file__).resolve().parent.parent / 'urdf' / 'a.xacro'",
            "/ws/arm_bringup/urdf/a.xacro",
        ),
        (
            "list in a path",
            "",
            "PathJoinSubstitution([FindPackageShare('arm'), ['urdf/', 'arm'], 'a.xacro'])",
            "$(find arm)/urdf/arm/a.xacro",
        ),
        (
            "name with an argument",
            "DeclareLaunchArgument('kind', default_value='big')",
            "[FindPackageShare('arm'), '/urdf/', LaunchConfiguration('kind'), '.xacro']",
            "$(find arm)/urdf/big.xacro",
        ),
        (
            "function that is not known",
            "from helpers import where",
            "where('arm.urdf.xacro')",
            "?",
        ),
        (
            "format that changes the value",
            "n = 1.5",
            "f'/r/{n:.3f}.xacro'",
            "/r/?.xacro",
        ),
    ] {
        let text = format!("{before}\n{}", command(path));
        check(
            form,
            "/ws/arm_bringup/launch/arm.launch.py",
            &text,
            &[expected],
        );
    }
}

#[test]
fn python_calls_of_xacro() {
    check_python(&[
        (
            "process_file with mappings",
            "import xacro\ndoc = xacro.process_file('/r/a.xacro', mappings={'side': 'left', 'n': 2, 'sim': True}).toxml()",
            &["/r/a.xacro side=left n=2 sim=True"],
        ),
        (
            "imported function",
            "from xacro import process_file\nprocess_file('/r/a.xacro')",
            &["/r/a.xacro"],
        ),
        (
            "module under another name",
            "import xacro as x\nx.process_file('/r/a.xacro', mappings={'a': b})",
            &["/r/a.xacro a=?"],
        ),
        (
            "parse and process_doc",
            "doc = xacro.parse(open('/r/a.xacro'))\nxacro.process_doc(doc, mappings={'a': '1'})",
            &["/r/a.xacro a=1"],
        ),
        (
            "parse in a with block",
            "with open('/r/a.xacro') as f:\n    doc = xacro.parse(f)\nxacro.process_doc(doc)",
            &["/r/a.xacro"],
        ),
        (
            "description from somewhere",
            "xacro.process_doc(doc, mappings={'a': '1'})",
            &["? a=1"],
        ),
        (
            "mappings in a variable that grows",
            "m = {'a': '1'}\nm['b'] = '2'\nm.update({'c': '3'})\nxacro.process_file('/r/a.xacro', mappings=m)",
            &["/r/a.xacro a=1 b=2 c=3"],
        ),
        (
            "mappings from somewhere",
            "xacro.process_file('/r/a.xacro', mappings=get())",
            &["/r/a.xacro ..."],
        ),
        (
            "mappings over others",
            "xacro.process_file('/r/a.xacro', mappings={'a': '1', **more, 'b': '2'})",
            &["/r/a.xacro a=? b=2 ..."],
        ),
        (
            "mappings by keywords",
            "xacro.process_file('/r/a.xacro', mappings=dict(a='1'))",
            &["/r/a.xacro a=1"],
        ),
        (
            "a helper that runs xacro",
            "from launch_utils import to_urdf\nto_urdf('/r/a.xacro', {'side': 'left'})",
            &["/r/a.xacro side=left"],
        ),
        (
            "another process_file",
            "other.process_file('/r/a.xacro')",
            &[],
        ),
        (
            "MoveItConfigsBuilder",
            "MoveItConfigsBuilder('arm', package_name='arm_moveit').robot_description(\
             file_path='config/arm.urdf.xacro', mappings={'side': LaunchConfiguration('side')}).to_moveit_configs()",
            &["$(find arm_moveit)/config/arm.urdf.xacro side=?"],
        ),
        (
            "MoveItConfigsBuilder after other steps, package by its rule",
            "MoveItConfigsBuilder('arm').trajectory_execution(file_path='x').robot_description(mappings={'a': '1'})",
            &["? a=1"],
        ),
        (
            "MoveItConfigsBuilder with an SRDF",
            "MoveItConfigsBuilder('arm', package_name='arm_moveit').robot_description_semantic(\
             Path('srdf') / 'arm.srdf.xacro', {'name': 'left'})",
            &["$(find arm_moveit)/srdf/arm.srdf.xacro name=left"],
        ),
        (
            "subprocess with words",
            "subprocess.run(['xacro', '/r/a.xacro', 'a:=x y'])",
            &["/r/a.xacro a=x y"],
        ),
        (
            "process of the launch system",
            "ExecuteProcess(cmd=['xacro', '/r/a.xacro', ['a:=', 'b']])",
            &["/r/a.xacro a=b"],
        ),
        (
            "command of a shell",
            "os.system('rosrun xacro xacro /r/a.xacro a:=1 > /tmp/a.urdf')",
            &["/r/a.xacro a=1"],
        ),
    ]);
}

#[test]
fn launch_files_in_xml() {
    for (form, text, expected) in [
        (
            "ROS 1, parameter",
            r#"<launch><arg name="side" default="left"/><arg name="n"/><param name="d"
            command="$(find xacro)/xacro --inorder '$(find arm)/urdf/arm.urdf.xacro' side:=$(arg side) n:=$(arg n) m:=2"/></launch>"#,
            "$(find arm)/urdf/arm.urdf.xacro side=left n=?n m=2",
        ),
        (
            "old name",
            r#"<launch><param name="d" command="$(find xacro)/xacro.py /r/a.xacro"/></launch>"#,
            "/r/a.xacro",
        ),
        (
            "without a slash",
            r#"<launch><param name="d" command="$(find xacro)xacro.py /r/a.xacro"/></launch>"#,
            "/r/a.xacro",
        ),
        (
            "fixed value",
            r#"<launch><arg name="m" value="$(find arm)/a.xacro"/><param name="d" command="xacro $(arg m)"/></launch>"#,
            "$(find arm)/a.xacro",
        ),
        (
            "expression",
            r#"<launch><param name="d" command="xacro /r/a.xacro a:=$(eval 1 + (2)) b:=$(env X) c:=$(optenv Y z)"/></launch>"#,
            "/r/a.xacro a=? b=? c=?",
        ),
        (
            "argument with a condition",
            r#"<launch><arg name="a" default="1" if="$(arg x)"/><arg name="a" default="2" unless="$(arg x)"/>
            <param name="d" command="xacro /r/a.xacro a:=$(arg a)"/></launch>"#,
            "/r/a.xacro a=?",
        ),
        (
            "group with a condition",
            r#"<launch><arg name="sim" default="false"/><group if="$(arg sim)"><param name="d" command="xacro /r/a.xacro sim:=$(arg sim)"/></group></launch>"#,
            "/r/a.xacro sim=?if sim",
        ),
        (
            "ROS 2, parameter",
            r#"<launch><arg name="side" default="left"/><node pkg="p" exec="e"><param name="d"
            value="$(command 'xacro $(find-pkg-share arm)/urdf/arm.urdf.xacro side:=$(var side)')"/></node></launch>"#,
            "$(find arm)/urdf/arm.urdf.xacro side=left",
        ),
        (
            "ROS 2, what a command prints",
            r#"<launch><let name="d" value="$(command '$(find-exec xacro) /r/a.xacro a:=1' 'warn')"/></launch>"#,
            "/r/a.xacro a=1",
        ),
        (
            "ROS 2, folder of the file",
            r#"<launch><let name="d" value="$(command &quot;xacro $(dirname)/../a.xacro&quot;)"/></launch>"#,
            "/ws/launch/../a.xacro",
        ),
    ] {
        check(form, "/ws/launch/a.launch.xml", text, &[expected]);
    }
    check(
        "no launch file",
        "/ws/a.xml",
        r#"<root><param name="d" command="xacro a.xacro"/></root>"#,
        &[],
    );
    check(
        "broken",
        "/ws/a.launch",
        r#"<launch><param name="d" command="xacro a.xacro"/>"#,
        &[],
    );
}

#[test]
fn scripts_and_jobs() {
    for (form, name, text, expected) in [
        (
            "script",
            "a.sh",
            "#!/bin/sh\nxacro urdf/a.xacro side:=left n:='1 2' > /tmp/a.urdf\n",
            "urdf/a.xacro side=left n=1 2",
        ),
        (
            "variables",
            "a.sh",
            "xacro \"$DIR/a.xacro\" side:=$1 n:=${N:-2} m:=3",
            "?/a.xacro side=? n=? m=3",
        ),
        (
            "package of ROS 1",
            "a.bash",
            "rosrun xacro xacro --inorder a.xacro a:=1 -o a.urdf",
            "a.xacro a=1",
        ),
        (
            "package of ROS 2",
            "a.bash",
            "ros2 run xacro xacro a.xacro a:=1 && echo done:=1",
            "a.xacro a=1",
        ),
        (
            "inside of another command",
            "a.sh",
            "check_urdf <(xacro a.xacro a:=1) b:=2",
            "",
        ),
        (
            "value of a variable",
            "a.sh",
            "D=$(xacro a.xacro a:=1) b:=2",
            "a.xacro a=1",
        ),
        (
            "two lines",
            "a.sh",
            "xacro a.xacro \\\n  a:=1 \\\n  b:=2\n",
            "a.xacro a=1 b=2",
        ),
        (
            "job",
            ".gitlab-ci.yml",
            "job:\n  script:\n    - xacro a.xacro a:=1\n",
            "a.xacro a=1",
        ),
        (
            "step",
            "ci.yaml",
            "steps:\n  - run: xacro a.xacro a:=1\n",
            "a.xacro a=1",
        ),
        ("comment", "a.sh", "# xacro a.xacro a:=1\n", ""),
        (
            "package that is installed",
            "a.sh",
            "apt install xacro a.xacro",
            "",
        ),
    ] {
        let expected: Vec<&str> = Some(expected)
            .filter(|text| !text.is_empty())
            .into_iter()
            .collect();
        check(form, &format!("/ws/{name}"), text, &expected);
    }
}
