//! The forms of Python programs that call robots: what branches, loops and functions leave known.

use super::forms::check_python;

#[test]
fn python_programs() {
    check_python(&[
        (
            "in generate_launch_description",
            "def generate_launch_description():\n    side = LaunchConfiguration('side')\n    return LaunchDescription([\n        \
             DeclareLaunchArgument('side', default_value='left'),\n        Node(package='p', parameters=[{'robot_description': \
             ParameterValue(Command(['xacro /r/a.xacro side:=', side]), value_type=str)}])])\n",
            &["/r/a.xacro side=left"],
        ),
        (
            "OpaqueFunction with perform",
            "def setup(context, *args, **kwargs):\n    side = LaunchConfiguration('side').perform(context)\n    \
             x = xacro.process_file('/r/a.xacro', mappings={'side': side})\n    return []\n\
             def generate_launch_description():\n    return LaunchDescription([\n        \
             DeclareLaunchArgument('side', default_value='left'), OpaqueFunction(function=setup)])\n",
            &["/r/a.xacro side=left"],
        ),
        (
            "OpaqueFunction with perform_substitution",
            "DeclareLaunchArgument('side', default_value='left')\nDeclareLaunchArgument('n', default_value='2')\n\
             def robot(context, side):\n    side = context.perform_substitution(side)\n    \
             n = perform_substitutions(context, normalize_to_list_of_substitutions(['n', LaunchConfiguration('n')]))\n    \
             return xacro.process_file('/r/a.xacro', mappings={'side': side, 'n': n})\n\
             def setup(context, side):\n    return [robot(context, side)]\n\
             OpaqueFunction(function=setup, args=[LaunchConfiguration('side')])\n",
            &["/r/a.xacro side=left n=n2"],
        ),
        (
            "OpaqueFunction with arguments",
            "def setup(context, path):\n    return xacro.process_file(path)\n\
             OpaqueFunction(function=setup, args=['/r/a.xacro'])\n",
            &["/r/a.xacro"],
        ),
        (
            "values of the context",
            "DeclareLaunchArgument('side', default_value='left')\ndef setup(context):\n    \
             s = context.launch_configurations['side']\n    xacro.process_file('/r/a.xacro', mappings={'side': s})\n",
            &["/r/a.xacro side=left"],
        ),
        (
            "helper function, called twice",
            "def robot(side, n='1'):\n    return Command(['xacro /r/a.xacro side:=', side, ' n:=' + n])\n\
             a = robot('left')\nb = robot('right', n='2')\n",
            &["/r/a.xacro side=left n=1", "/r/a.xacro side=right n=2"],
        ),
        (
            "helper function that is never called",
            "def robot(side, n='1'):\n    return Command(['xacro /r/a.xacro side:=', side, ' n:=', n])\n",
            &["/r/a.xacro side=? n=?"],
        ),
        (
            "function that gives a path",
            "def where(name: str) -> str:\n    return '/r/' + name\nCommand(['xacro ', where('a.xacro')])",
            &["/r/a.xacro"],
        ),
        (
            "variable set in two branches",
            "if x:\n    a = '1'\nelse:\n    a = '2'\nb = '3'\nCommand(['xacro /r/a.xacro a:=', a, ' b:=', b])",
            &["/r/a.xacro a=? b=3"],
        ),
        (
            "choice",
            "a = 'l' if x else 'r'\nCommand(['xacro /r/a.xacro a:=', a])",
            &["/r/a.xacro a=?"],
        ),
        (
            "branch that a condition decides",
            "DeclareLaunchArgument('sim', default_value='false')\nsim = LaunchConfiguration('sim').perform(context)\n\
             if sim == 'true':\n    Command(['xacro /r/a.xacro sim:=', sim])\n",
            &["/r/a.xacro sim=?if sim"],
        ),
        (
            "condition of a node",
            "DeclareLaunchArgument('sim', default_value='false')\nsim = LaunchConfiguration('sim')\n\
             Node(condition=IfCondition(sim), parameters=[{'d': Command(['xacro /r/a.xacro sim:=', sim])}])\n",
            &["/r/a.xacro sim=?if sim"],
        ),
        (
            "loop",
            "for side in ['left', 'right']:\n    path = '/r/' + side\n    Command(['xacro /r/a.xacro n:=1 side:=', side])\n",
            &["/r/a.xacro n=1 side=?"],
        ),
        (
            "error that is caught in a loop",
            "for n in ['1', '2']:\n    try:\n        xacro.process_file('/r/a.xacro', mappings={'n': '1'})\n    \
             except xacro.XacroException as error:\n        print(error)\n",
            &["/r/a.xacro n=1"],
        ),
        (
            "folder that is opened in a loop",
            "for n in ['1', '2']:\n    with os.scandir('/r') as found:\n        pass\n    \
             xacro.process_file(os.path.join('/r', 'a.xacro'))\n",
            &["/r/a.xacro"],
        ),
        (
            "list that grows in a branch",
            "c = ['xacro /r/a.xacro']\nif x:\n    c += [' a:=1']\nCommand(c)\n",
            &[],
        ),
        (
            "list under two names",
            "c = ['xacro /r/a.xacro']\nd = c\nd.append(' a:=1')\nCommand(c)\n",
            &[],
        ),
        (
            "global that a function sets",
            "side = 'left'\ndef f():\n    global side\n    side = 'right'\nf()\nCommand(['xacro /r/a.xacro side:=', side])\n",
            &["/r/a.xacro side=?"],
        ),
        (
            "unpacked names",
            "a, b = '1', '2'\nCommand(['xacro /r/a.xacro a:=', a, ' b:=', b])",
            &["/r/a.xacro a=1 b=2"],
        ),
        (
            "sum of numbers",
            "n = 1 + 2\nCommand(['xacro /r/a.xacro n:=', str(n)])",
            &["/r/a.xacro n=?"],
        ),
        (
            "attribute of an object",
            "self.a = '1'\nCommand(['xacro /r/a.xacro a:=', self.a])",
            &["/r/a.xacro a=?"],
        ),
        ("comment", "# Command(['xacro /r/a.xacro'])\n", &[]),
        (
            "text that is not a program",
            "Command(['xacro /r/a.xacro' 'b':])\n",
            &[],
        ),
    ]);
}
