//! F4: hover.

use super::client::{Client, Options};
use super::workspace::{self, ROBOT, UNIT};

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

/// The text shown at a place, and the text it is about.
#[track_caller]
fn hover(client: &mut Client, file: &str, at: &str) -> (String, String) {
    let found = client.request("textDocument/hover", client.at(file, at));
    assert!(!found.is_null(), "nothing at {at}");
    let text = found["contents"]["value"].as_str().unwrap().to_owned();
    assert!(text.lines().count() <= 25, "{text}");
    (text, client.slice(file, &found["range"]))
}

#[track_caller]
fn check(client: &mut Client, file: &str, at: &str, about: &str, expected: &[&str]) {
    let (text, range) = hover(client, file, at);
    assert_eq!(range, about, "{text}");
    for part in expected {
        assert!(text.contains(part), "`{part}` at {at} in:\n{text}");
    }
}

#[test]
fn expressions_and_their_parts_have_values() {
    let mut client = both();
    check(
        &mut client,
        ROBOT,
        "${m0 |/ 3}",
        "${m0 / 3}",
        &["= `0.05`", "0.049999999999999996"],
    );
    check(
        &mut client,
        UNIT,
        "${m0 |* 2}",
        "${m0 * 2}",
        &["= `0.3`", "all 2 calls"],
    );
    client.edit(ROBOT, "${m0 / 3}", "${1 + (m0 * 2) - pi}");
    check(
        &mut client,
        ROBOT,
        "(m0 |* 2)",
        "m0 * 2",
        &["`m0 * 2` = `0.3`"],
    );
    check(&mut client, ROBOT, "p|i}", "pi", &["3.14159265"]);
}

#[test]
fn a_value_that_differs_by_call_is_a_list() {
    let mut client = both();
    check(
        &mut client,
        UNIT,
        "${na|me}_body",
        "name",
        &["- `pan` – `unit` at pan_tilt.urdf.xacro:7", "- `tilt`"],
    );
    client.edit(
        ROBOT,
        "</robot>",
        "<xacro:unit name=\"a\" parent=\"pan_body\"><origin/></xacro:unit>\
        <xacro:unit name=\"b\" parent=\"pan_body\"><origin/></xacro:unit></robot>",
    );
    check(
        &mut client,
        UNIT,
        "${na|me}_body",
        "name",
        &["- `a` –", "- … (4 calls)"],
    );
}

#[test]
fn names_of_xacro_say_what_they_are() {
    let mut client = both();
    client.edit(
        ROBOT,
        "  <xacro:property name=\"m0\"",
        "  <!-- Mass of a *bracket*, kg. -->\n  <xacro:property name=\"m0\"",
    );
    let expected = [
        "**property** `m0` = `0.15`",
        "pan_tilt.urdf.xacro:4",
        "used 2 times",
        "Mass of a \\*bracket\\*",
    ];
    check(&mut client, ROBOT, "name=\"m|0\"", "m0", &expected);
    let expected = [
        "A motor with its bracket.",
        "unit(name, parent, axis:='0 0 1', *at)",
        "1 link, 1 joint",
        "unit.xacro:3",
    ];
    check(
        &mut client,
        ROBOT,
        "<xacro:un|it name=\"pan\"",
        "unit",
        &expected,
    );
    check(
        &mut client,
        UNIT,
        "xyz=\"${ax|is}\"",
        "axis",
        &["parameter", "default `'0 0 1'`", "- `0 0 1`", "- `0 1 0`"],
    );
    check(
        &mut client,
        ROBOT,
        "name=\"$(arg mo|unt)\"",
        "mount",
        &["**argument** `mount` = `desk`", "default `desk`"],
    );
}

#[test]
fn a_property_that_nothing_reads_has_a_value() {
    let mut client = both();
    check(&mut client, ROBOT, "name=\"c|am\"", "cam", &["'fov': 1.2"]);
    check(
        &mut client,
        ROBOT,
        "config/cam|.yaml",
        "$(find pan_tilt)/config/cam.yaml",
        &["/config/cam.yaml"],
    );
    check(
        &mut client,
        ROBOT,
        "$(find pan_|tilt)",
        "pan_tilt",
        &["**package** `pan_tilt`", "/src/pan_tilt"],
    );
}

#[test]
fn elements_and_attributes_are_explained() {
    let mut client = both();
    check(&mut client, UNIT, "velo|city=", "velocity", &["rad/s"]);
    check(
        &mut client,
        UNIT,
        "<ax|is",
        "axis",
        &[
            "unit vector in the joint frame",
            "`1 0 0`",
            "`<joint>`",
            "wiki.ros.org",
        ],
    );
    check(
        &mut client,
        UNIT,
        "<iner|tia ",
        "inertia",
        &["about the center of mass", "kg m²"],
    );
    check(
        &mut client,
        UNIT,
        "upper=\"1.|57\"",
        "1.57",
        &["`1.57 rad (89.95°)`"],
    );
    check(&mut client, UNIT, "velocity=\"|2\"", "2", &["114.59°/s"]);
    check(
        &mut client,
        UNIT,
        "<xacro:ma|cro",
        "xacro:macro",
        &["Defines"],
    );
}

#[test]
fn links_and_joints_show_where_they_hang() {
    let mut client = both();
    let expected = [
        "`desk → pan → pan_body`",
        "mass 0.3 kg",
        "`tilt_body` by `tilt`",
        "from `unit` at pan_tilt.urdf.xacro:7",
    ];
    check(
        &mut client,
        ROBOT,
        "parent=\"pan|_body\"",
        "pan_body",
        &expected,
    );
    check(
        &mut client,
        UNIT,
        "<link name=\"${name}_bo|dy\"",
        "${name}_body",
        &["**link** `pan_body`", "**link** `tilt_body`"],
    );
    let expected = [
        "**joint** `tilt` (revolute)",
        "`pan_body → tilt_body`",
        "axis `+Y` of `pan_body`",
        "-89.95° … 89.95°",
    ];
    check(&mut client, ROBOT, "name=\"ti|lt\"", "tilt", &expected);
}

#[test]
fn includes_and_meshes_lead_to_files() {
    let mut client = both();
    check(
        &mut client,
        ROBOT,
        "filename=\"uni|t.xacro\"",
        "unit.xacro",
        &["/urdf/unit.xacro`", "bytes"],
    );
    client.edit(ROBOT, "unit.xacro", "gone.xacro");
    check(
        &mut client,
        ROBOT,
        "filename=\"go|ne.xacro\"",
        "gone.xacro",
        &["not found", "/urdf/gone.xacro`"],
    );
    let mut mesh = vec![0; 80];
    mesh.extend(1u32.to_le_bytes());
    for number in [
        0.0f32, 0.0, 1.0, 0.0, 0.0, 0.0, 200.0, 0.0, 0.0, 0.0, 300.0, 0.0,
    ] {
        mesh.extend(number.to_le_bytes());
    }
    mesh.extend([0, 0]);
    workspace::write(&client.folder, "src/pan_tilt/meshes/head.stl", mesh);
    let visual = "<link name=\"$(arg mount)\"><visual><geometry>\
        <mesh filename=\"package://pan_tilt/meshes/head.stl\"/></geometry></visual></link>";
    client.edit(ROBOT, "<link name=\"$(arg mount)\"/>", visual);
    let expected = [
        "/meshes/head.stl",
        "1 triangle",
        "200 × 300 × 0 m",
        "millimeters",
    ];
    check(
        &mut client,
        ROBOT,
        "meshes/he|ad.stl",
        "package://pan_tilt/meshes/head.stl",
        &expected,
    );
}

#[test]
fn conditions_and_colors_show_what_they_are_now() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<xacro:if value=\"${m0 > 1}\"><link name=\"x\"/></xacro:if>\
        <material name=\"red\"><color rgba=\"1 0 0 1\"/></material></robot>",
    );
    check(
        &mut client,
        ROBOT,
        "<xacro:i|f",
        "xacro:if",
        &["now false", "excluded"],
    );
    check(
        &mut client,
        ROBOT,
        "rgba=\"1 |0 0 1\"",
        "1 0 0 1",
        &["#ff0000", "data:image/svg+xml"],
    );
}

#[test]
fn broken_files_unsaved_includes_and_wide_characters_change_nothing() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<link name=\"");
    check(&mut client, ROBOT, "${m0 |/ 3}", "${m0 / 3}", &["`0.05`"]);
    client.edit(
        ROBOT,
        "<xacro:unit name=\"tilt\"",
        "<!-- 🤖🤖 --><xacro:unit name=\"tilt\"",
    );
    check(&mut client, ROBOT, "${m0 |/ 3}", "${m0 / 3}", &["`0.05`"]);
    client.edit(UNIT, "${m0 * 2}", "${m0 * 4}");
    check(&mut client, UNIT, "${m0 |* 4}", "${m0 * 4}", &["`0.6`"]);
    client.edit(ROBOT, "${m0 / 3}", "${m0 / nothing}");
    check(
        &mut client,
        ROBOT,
        "${m0 |/ nothing}",
        "${m0 / nothing}",
        &["is unknown"],
    );
}

#[test]
fn comments_say_nothing() {
    let mut client = both();
    assert!(
        client
            .request("textDocument/hover", client.at(UNIT, "A mo|tor"))
            .is_null()
    );
}

#[test]
fn a_macro_that_nothing_calls_has_no_values() {
    let mut client = both();
    let idle = "<xacro:macro name=\"idle\" params=\"size:=2\"><link name=\"${size * 2}\"/></xacro:macro></robot>";
    client.edit(ROBOT, "</robot>", idle);
    let expected = [
        "**parameter** `size` = ?",
        "the macro is never called",
        "default `2`",
    ];
    check(&mut client, ROBOT, "params=\"si|ze", "size", &expected);
    check(
        &mut client,
        ROBOT,
        "${size |* 2}",
        "${size * 2}",
        &["= ?", "`size` has no known value"],
    );
}

#[test]
fn yaml_that_changes_on_the_disk_gives_new_values() {
    let mut client = both();
    check(&mut client, ROBOT, "name=\"c|am\"", "cam", &["'fov': 1.2"]);
    let yaml = "src/pan_tilt/config/cam.yaml";
    workspace::write(&client.folder, yaml, "fov: 1.75\n");
    let changes = serde_json::json!([{ "uri": client.uri(yaml), "type": 2 }]);
    client.notify(
        "workspace/didChangeWatchedFiles",
        serde_json::json!({ "changes": changes }),
    );
    check(&mut client, ROBOT, "name=\"c|am\"", "cam", &["'fov': 1.75"]);
}

/// A robot that takes a while to expand.
fn large() -> String {
    let mut text = String::from(
        "<robot name=\"large\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">
  <xacro:property name=\"half\" value=\"${base_mass / 2}\"/>
  <!-- of a segment, kg -->
  <xacro:property name=\"base_mass\" value=\"2.5\"/>
  <xacro:property name=\"twice\" value=\"1\"/>
  <xacro:property name=\"twice\" value=\"2\"/>
  <xacro:macro name=\"seg\" params=\"name parent radius:=0.1\">
    <link name=\"${name}\">
      <inertial>
        <mass value=\"${base_mass * radius}\"/>
        <inertia ixx=\"${half}\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/>
      </inertial>
    </link>
    <joint name=\"${name}_joint\" type=\"fixed\"><parent link=\"${parent}\"/><child link=\"${name}\"/></joint>
  </xacro:macro>
  <link name=\"s0\"/>\n",
    );
    for n in 1..=300 {
        text.push_str(&format!(
            "  <xacro:seg name=\"s{n}\" parent=\"s{}\" radius=\"${{base_mass / {n}}}\"/>\n",
            n - 1
        ));
    }
    text + "</robot>\n"
}

#[test]
fn names_read_the_same_while_a_large_robot_is_edited() {
    const FILE: &str = "src/pan_tilt/urdf/large.urdf.xacro";
    let edits = [
        // in an expression of a macro
        (
            "${base_mass * radius}",
            "${2 * base_mass * radius}",
            "base_|mass * radius",
        ),
        (
            "${base_mass * radius}",
            "${base_mass + base_mass}",
            "ixx=\"${ha|lf",
        ),
        ("${base_mass * radius}", "${base_massx}", "${base_|massx"),
        ("${base_mass * radius}", "${twice}", "${twi|ce"),
        // in a call
        ("${base_mass / 7}", "${base_mass / 8 - half}", "8 - ha|lf"),
        ("${base_mass / 7}", "${radius}", "radius=\"${rad|ius"),
        // lines above the definition, and the definition itself
        (
            "  <xacro:property name=\"half\"",
            "\n\n  <xacro:property name=\"half\"",
            "${base_|mass * radius",
        ),
        ("value=\"2.5\"", "value=\"3.5\"", "ixx=\"${ha|lf"),
        ("value=\"${base_mass / 2}\"", "value=\"7\"", "ixx=\"${ha|lf"),
        (
            "<link name=\"s0\"/>",
            "<link name=\"s0\"/><xacro:property name=\"half\" value=\"9\"/>",
            "ixx=\"${ha|lf",
        ),
    ];
    let mut client = Client::start();
    client.open_with(FILE, &large());
    for (old, new, at) in edits {
        client.findings(FILE);
        client.edit(FILE, old, new);
        let text = client.text(FILE).to_owned();
        let while_typing = hover(&mut client, FILE, at);
        let mut fresh = Client::start();
        fresh.open_with(FILE, &text);
        assert_eq!(while_typing, hover(&mut fresh, FILE, at), "{new}");
        client.edit(FILE, new, old);
    }
}

#[test]
fn an_argument_lists_the_values_of_launch_files() {
    let mut client = Client::start();
    const FILE: &str = "src/pan_tilt/urdf/launched.urdf.xacro";
    let robot = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:arg name=\"side\" default=\"left\"/>\
                 <link name=\"$(arg side)_base\"/></robot>\n";
    let call = |side: &str| {
        format!(
            "Command(['xacro ', FindPackageShare('pan_tilt'), '/urdf/launched.urdf.xacro side:={side}'])\n"
        )
    };
    workspace::write(
        &client.folder,
        "src/pan_tilt/launch/one.launch.py",
        call("right"),
    );
    workspace::write(
        &client.folder,
        "src/pan_tilt/launch/two.launch.py",
        call("left"),
    );
    client.open_with(FILE, robot);
    let expected = [
        "in launch files:",
        "* `right`: one.launch.py",
        "* `left`: two.launch.py",
    ];
    check(&mut client, FILE, "$(arg si|de)", "side", &expected);
}

#[test]
fn a_table_says_what_programs_make_of_an_element() {
    let arm = "<robot name=\"arm\"><link name=\"base_link\"/><link name=\"link_1\"><inertial><mass value=\"1\"/>\
               <inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/></inertial></link>\
               <joint name=\"joint_1\" type=\"revolute\"><parent link=\"base_link\"/><child link=\"link_1\"/>\
               <axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" velocity=\"1\"/></joint></robot>";
    for (config, is_named) in [
        ("consumers = [\"pinocchio\", \"gazebo\"]\n", true),
        ("", false),
    ] {
        let folder = workspace::fresh_folder();
        workspace::write(&folder, "xacro-lint.toml", config);
        workspace::write(&folder, "arm.urdf", arm);
        let mut client = Client::with(folder, Options::default());
        client.open("arm.urdf");
        let (limit, range) = hover(&mut client, "arm.urdf", "<li|mit");
        assert_eq!(range, "limit");
        let table = "| `<limit>` without `effort` | by |\n|---|---|\n| rejected | urdfdom, urdfdom 3, KDL, MoveIt, Gazebo, ";
        assert_eq!(limit.contains(table), is_named, "{limit}");
        assert_eq!(
            limit.contains("| accepted | MuJoCo, Drake, PyBullet, "),
            is_named,
            "{limit}"
        );
        let (name, range) = hover(&mut client, "arm.urdf", "\"base_|link\"/><link");
        assert_eq!(range, "base_link");
        let row = "| no `<inertial>` on the root link | by |\n|---|---|\n| rejected | Gazebo |\n| changed or ignored | PyBullet, urchin |";
        assert!(
            name.contains("**link**") && name.contains(row) == is_named,
            "{name}"
        );
        // the named programs accept the axis
        let (axis, _) = hover(&mut client, "arm.urdf", "<a|xis");
        assert!(!axis.contains("rejected"), "{axis}");
    }
}

#[test]
fn all_of_a_tag_in_front_of_its_name_is_about_the_name() {
    let mut client = both();
    let (text, range) = hover(&mut client, ROBOT, "<xacro:un|it name=\"pan\"");
    assert_eq!(range, "unit");
    for at in [
        "|<xacro:unit name=\"pan\"",
        "<|xacro:unit name=\"pan\"",
        "<xac|ro:unit name=\"pan\"",
        "<xacro|:unit name=\"pan\"",
    ] {
        let found = hover(&mut client, ROBOT, at);
        assert_eq!(found, (text.clone(), range.clone()), "{at}");
    }
    let on_name = hover(&mut client, ROBOT, "<li|nk name");
    assert_eq!(hover(&mut client, ROBOT, "|<link name"), on_name);
}

#[test]
fn what_one_call_of_a_macro_makes() {
    let mut client = both();
    let of_macro = |client: &mut Client| hover(client, UNIT, "<xacro:macro name=\"un|it").0;
    let text = of_macro(&mut client);
    assert!(
        text.contains("creates 1 link, 1 joint in each of 2 calls"),
        "{text}"
    );
    client.edit(
        ROBOT,
        "<xacro:unit name=\"pan\" parent=\"$(arg mount)\"><origin xyz=\"0 0 0.1\"/></xacro:unit>",
        "",
    );
    let text = of_macro(&mut client);
    assert!(
        text.contains("creates 1 link, 1 joint in its only call"),
        "{text}"
    );
}
