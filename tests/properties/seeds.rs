//! Inputs to begin with, from the examples and fixtures of this repository.

use std::fs;
use std::path::{Path, PathBuf};

use crate::harness::Target;

/// Larger files are cut: every part of a language stands in small ones too.
const LONGEST: usize = 6000;

/// The seeds of a target.
pub fn of(target: &Target) -> Vec<Vec<u8>> {
    let mut found = Vec::new();
    for kind in target.seeds {
        match *kind {
            "expressions" => found.extend(expressions()),
            "messages" => found.extend(MESSAGES.iter().map(|text| framed(text))),
            "meshes" => found.extend(
                MESHES
                    .iter()
                    .map(|(choice, text)| with_choice(*choice, text.as_bytes())),
            ),
            "yaml" => found.extend(
                files("yaml")
                    .into_iter()
                    .chain(YAML.iter().map(|text| text.as_bytes().to_vec())),
            ),
            "launch" => found.extend(
                LAUNCH
                    .iter()
                    .map(|(choice, text)| with_choice(*choice, text.as_bytes())),
            ),
            "launch-of-a-package" => found.extend(
                LAUNCH_OF_ARM
                    .iter()
                    .map(|(choice, text)| with_choice(*choice, text.as_bytes())),
            ),
            "stl" => found.extend(
                files("stl")
                    .iter()
                    .take(4)
                    .map(|bytes| with_choice(0, bytes)),
            ),
            "toml" => found.extend(
                files("toml")
                    .into_iter()
                    .chain(TOML.iter().map(|text| text.as_bytes().to_vec())),
            ),
            ending if target.has_choice => {
                let numbered = files(ending).into_iter().enumerate();
                found.extend(numbered.map(|(number, bytes)| with_choice(number as u8, &bytes)));
            }
            ending => found.extend(files(ending)),
        }
    }
    found
}

fn with_choice(choice: u8, bytes: &[u8]) -> Vec<u8> {
    [&[choice], bytes].concat()
}

fn framed(body: &str) -> Vec<u8> {
    format!("Content-Length: {}\r\n\r\n{body}", body.len()).into_bytes()
}

/// The files of the examples and fixtures with this ending, the short ones whole.
fn files(ending: &str) -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    for folder in ["docs/examples", "tests/cli", "tests/conformance"] {
        collect(&root.join(folder), ending, &mut paths);
    }
    paths.sort();
    let mut found: Vec<Vec<u8>> = paths.iter().map(|path| fs::read(path).unwrap()).collect();
    for bytes in &mut found {
        bytes.truncate(LONGEST);
    }
    found
}

fn collect(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, ending, found);
        } else if path.extension().is_some_and(|own| own == ending) {
            found.push(path);
        }
    }
}

/// The expressions of the tables that Python made.
fn expressions() -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/expr/testdata");
    let mut found = Vec::new();
    for (table, every) in [
        ("eval.txt", 1),
        ("operators.txt", 20),
        ("format.txt", 20),
        ("valid.txt", 1),
    ] {
        let text = fs::read_to_string(folder.join(table)).unwrap();
        let first = text
            .lines()
            .step_by(every)
            .filter_map(|line| line.split('\t').next());
        found.extend(first.map(|expression| expression.trim_matches('"').as_bytes().to_vec()));
    }
    found.push(b"a ${x*2} b $(find pkg)/$(arg n) $${c} ${'$(arg s)'} ${[i for i in l]}".to_vec());
    found
}

/// Words of all the languages.
pub fn words() -> Vec<&'static str> {
    WORDS
        .split(' ')
        .chain([
            "\n", "\r\n", " ", "\t", "\u{feff}", "\u{0}", "\u{2028}", "😀",
        ])
        .collect()
}

const WORDS: &str = "< > / \" ' = & ; --> <!-- <![CDATA[ ]]> </ /> <? ?> <!DOCTYPE <!ENTITY &amp; &#x41; &#0; &e; ${ } $( ) \
    $${ <link <joint <robot </robot> <xacro:macro <xacro:property <xacro:if <xacro:unless <xacro:include \
    <xacro:insert_block <xacro:element <xacro:attribute <xacro:arg <xacro:call xmlns:xacro= name= value= params= \
    filename=\"part.xacro\" default= scope=\"parent\" lazy_eval= type=\"revolute\" xyz=\"0 0 1\" lambda for in if else \
    not and or is None True len( range( python.eval( math.sqrt( load_yaml( xacro. 1e308 -1 0x7fffffffffffffff ** // \
    [ ] { : , . 99999999999999999999 nan inf &a *a << !!int !degrees | > - ? %YAML --- ... \
    [limits] [[roots]] severity. select extend macro-depth Content-Length: jsonrpc method id params solid facet vertex \
    COLLADA geometry instance_node node accessors bufferViews meshes primitives v f mtllib";

const MESSAGES: &[&str] = &[
    r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{"workspace":{"diagnostics":{}}}}}"#,
    r#"{"jsonrpc":"2.0","method":"exit"}"#,
    r#"{"jsonrpc":"2.0","id":"a","method":"shutdown","params":null}"#,
    r#"{"jsonrpc":"2.0","id":7,"result":null}"#,
    r#"{"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":1}}"#,
    r#"{"jsonrpc":"2.0","id":3,"method":"$/x","params":["\ud800 \ude00"]}"#,
];

const YAML: &[&str] = &[
    "joint_limits:\n  pan:\n    max: !degrees 90\n    min: -1.5\n  tilt: {max: 1, min: [1, 2]}\n",
    "base: &b {x: 1}\nall:\n  <<: *b\n  y: |\n    text\n  z: >-\n    more\n",
    "? [a, b]\n: !!set {c, d}\n",
    "--- \"a\\u00e9\" # c\n...\n",
    "a: 1:30\nb: 2001-12-14t21:59:43.10-05:00\nc: 0o7\nd: .inf\n",
];

const TOML: &[&str] = &[
    "target = 'ros1'\nselect = ['XML']\nseverity.unused-property = 'off'\n[limits]\nfile-mb = 7\n[format]\nline-width = 80\n",
    "[[roots]]\nfile = 'urdf/*.xacro'\nargs = { a = '1' }\npresets.b = { c = 2 }\n[per-file-ignores]\n'a/**' = ['NAM']\n",
    "{\"limits\": {\"fileMb\": 3}, \"severity\": {\"undefined-link\": \"off\"}}",
];

const MESHES: &[(u8, &str)] = &[
    (
        0,
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
    ),
    (
        1,
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1/1/1 2//2 -1\nf 1 2 3 4\n",
    ),
    (
        2,
        "<COLLADA><asset><unit meter='0.001'/><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id='g'><mesh>\
         <source id='s'><float_array id='f' count='9'>0 0 0 1 0 0 0 1 0</float_array><technique_common>\
         <accessor source='#f' count='3' stride='3'/></technique_common></source><vertices id='v'>\
         <input semantic='POSITION' source='#s'/></vertices><triangles count='1'><input semantic='VERTEX' source='#v' \
         offset='0'/><p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>\
         <visual_scene id='w'><node><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url='#g'/></node>\
         </visual_scene></library_visual_scenes><scene><instance_visual_scene url='#w'/></scene></COLLADA>",
    ),
    (
        3,
        r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[1,2,3]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":12},{"buffer":0,"byteOffset":8,"byteLength":6}],"buffers":[{"uri":"a.bin","byteLength":14}]}"#,
    ),
    (
        4,
        "glTF\u{2}\u{0}\u{0}\u{0}\u{1c}\u{0}\u{0}\u{0}\u{8}\u{0}\u{0}\u{0}JSON{}      ",
    ),
];

/// Launch files of the package `arm`, by the number of their kind.
const LAUNCH_OF_ARM: [(u8, &str); 6] = [
    (
        0,
        "side = LaunchConfiguration('side')\nc = [DeclareLaunchArgument('side', default_value='left', choices=['left', 'rigt'])]\n\
         path = [FindPackageShare('arm'), '/arm.urdf.xacro']\nr = Command(['xacro ', *path, ' side:=', side, ' n:=2 sim:=', s])\n\
         IncludeLaunchDescription('b.launch.py', launch_arguments={'side': 'right'}.items())\n",
    ),
    (
        5,
        "p = get_package_share_directory('arm') + '/arm.urdf.xacro'\nxacro.process_file(p, mappings={'side': 'right', 'nn': '3'})\n\
         for s in ['a', 'b']:\n    Command(f'xacro {p} side:={s} n:=é')\n",
    ),
    (
        1,
        "<launch><arg name=\"side\" default=\"left\"/><param name=\"d\" command=\"$(find xacro)/xacro $(find arm)/arm.urdf.xacro \
         side:=$(arg side) sim:=1\"/><include file=\"$(find arm)/launch/a.launch\"><arg name=\"side\" value=\"b\"/></include></launch>",
    ),
    (
        2,
        "<launch><let name=\"s\" value=\"right\"/><node><param name=\"d\" value=\"$(command 'xacro $(find-pkg-share arm)/arm.urdf.xacro \
         side:=$(var s)')\"/></node></launch>",
    ),
    (
        3,
        "cd $(rospack find arm)\nxacro arm.urdf.xacro side:=left 'n:=1' sim:=\"$1\" > a.urdf # side:=\n",
    ),
    (
        4,
        "launch:\n- arg: {name: side, default: left}\n- node:\n    param:\n    - name: robot_description\n      value: \
         \"$(command 'xacro $(find-pkg-share arm)/arm.urdf.xacro side:=$(var side)')\"\n",
    ),
];

/// Launch files, by the number of their kind.
const LAUNCH: [(u8, &str); 5] = [
    (
        0,
        "from launch import *\nimport xacro as x\n\ndef robot(side, n='1', *args, **more):\n    if side == 'left':\n        \
         path = f'/r/{side}.xacro'\n    else:\n        path = '/r/' + side\n    return Command(['xacro ', path, ' n:=', n])\n\n\
         def generate_launch_description():\n    c = [DeclareLaunchArgument('side', default_value='left', choices=['left'])]\n    \
         for i in range(3):\n        c.append(Node(condition=IfCondition(LaunchConfiguration('side'))))\n    try:\n        \
         a, b = robot('left'), robot(LaunchConfiguration('side').perform(context))\n    except Exception as e:\n        raise\n    \
         m = {'a': '1', **more}\n    m['b'] = lambda x: x\n    x.process_file('/r/a.xacro', mappings=m)\n    \
         return LaunchDescription(c)\n",
    ),
    (
        0,
        "with open('/r/a.xacro') as f: doc = xacro.parse(f)\nxacro.process_doc(doc, mappings=dict(a='1'))\n\
         OpaqueFunction(function=setup, args=['{} %s'.format(1) % 2])\nMoveItConfigsBuilder('a').robot_description(mappings={})\n\
         p = Path(__file__).parent.parents[2] / 'a'\nos.system(\"xacro $(find a)/b; c\")\n",
    ),
    (
        1,
        "<launch><arg name=\"a\" default=\"$(find p)/x\"/><group if=\"$(arg a)\"><include file=\"$(dirname)/b.launch\"><arg name=\"c\" \
         value=\"$(eval 1 + (2))\"/></include><param name=\"d\" command=\"xacro '$(arg a)' b:=$(arg a)\"/></group></launch>",
    ),
    (
        2,
        "<launch><let name=\"d\" value=\"$(command 'xacro $(find-pkg-share p)/a.xacro b:=$(var c)' 'warn')\"/></launch>",
    ),
    (
        3,
        "xacro \"$A/b.xacro\" c:=${D:-$(e f)} 'g:=h i' \\\n  j:=1 | k > l # m\nD=$(rosrun xacro xacro a.xacro)\n",
    ),
];
