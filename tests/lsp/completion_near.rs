//! Names that are offered though nothing near by gives them, and which of many come first.

use super::client::{Client, Options};
use super::positions::position;
use super::workspace::{fresh_folder, write};

const MAIN: &str = "src/arm/arm.urdf.xacro";
const PART: &str = "src/arm/part.xacro";

const MAIN_TEXT: &str = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left_"/>
  <xacro:property name="joint_1_upper" value="1"/>
  <xacro:property name="joint_2_upper" value="2"/>
  <xacro:property name="joint_3_upper" value="3"/>
  <xacro:property name="joint_3_lower" value="0"/>
  <xacro:include filename="part.xacro"/>
  <xacro:finger prefix="$(arg side)" sizes="${dict(tip=dict(width=1))}"/>
  <xacro:unheard_of depth="1"/>
  <link name="base"/>
</robot>
"#;

const PART_TEXT: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="named" params="prefix name"><link name="${prefix}${name}"/></xacro:macro>
  <xacro:macro name="finger" params="prefix sizes">
    <xacro:named prefix="${prefix}" name="tip"/>
    <xacro:property name="far" value="${sizes.tip.width}"/>
    <joint name="${prefix}slide" type="fixed">
      <parent link="${prefix}knuckle"/>
      <child link="${prefix}tip"/>
    </joint>
  </xacro:macro>
</robot>
"#;

const MANIFEST: &str =
    "<package format=\"3\"><name>arm</name><exec_depend>hand_description</exec_depend></package>";

/// The labels that are offered where `tail` was typed at the end of the robot, or of the macro in the part, as they are sorted.
fn offered(file: &str, tail: &str) -> Vec<String> {
    let folder = fresh_folder();
    write(&folder, MAIN, MAIN_TEXT);
    write(&folder, PART, PART_TEXT);
    write(&folder, "src/arm/package.xml", MANIFEST);
    for mesh in ["joint_1.stl", "joint_2.stl", "joint_3.stl", "joint_4.stl"] {
        write(&folder, &format!("src/arm/meshes/{mesh}"), "");
    }
    let mut client = Client::with(folder, Options::default());
    let (text, end) = if file == MAIN {
        (MAIN_TEXT, "</robot>")
    } else {
        (PART_TEXT, "  </xacro:macro>\n</robot>")
    };
    client.open(MAIN);
    // what the robot is, as it was before somebody typed
    client.request("textDocument/documentSymbol", client.of(MAIN));
    let (before, behind) = text.rsplit_once(end).unwrap();
    let before = format!("{before}{tail}");
    let text = format!("{before}{end}{behind}");
    client.open_with(file, &text);
    let mut params = client.of(file);
    params["position"] = position(&text, before.len());
    let answer = client.request("textDocument/completion", params);
    let mut items = answer["items"].as_array().unwrap().clone();
    items.sort_by_key(|item| item["sortText"].as_str().unwrap().to_owned());
    items
        .iter()
        .map(|item| item["label"].as_str().unwrap().to_owned())
        .collect()
}

#[track_caller]
fn holds(file: &str, tail: &str, expected: &str) {
    let found = offered(file, tail);
    assert!(
        found.iter().any(|label| label == expected),
        "`{expected}` at `{tail}`: {found:?}"
    );
}

#[test]
fn links_that_other_macros_make_are_offered_behind_what_they_begin_with() {
    // the text of the macro refers to it, a robot has it, and it is made by a macro that is called
    holds(
        PART,
        "<joint name=\"j\"><parent link=\"${prefix}kn",
        "${prefix}knuckle",
    );
    holds(
        PART,
        "<joint name=\"j\"><parent link=\"${prefix}ti",
        "${prefix}tip",
    );
}

#[test]
fn links_of_the_robot_are_offered_behind_an_argument() {
    let robot = "<joint name=\"j\" type=\"fixed\"><parent link=\"$(arg side)t";
    holds(MAIN, robot, "$(arg side)tip");
}

#[test]
fn what_stands_elsewhere_is_offered_where_nothing_is_known() {
    holds(PART, "<link name=\"${sizes.tip.w", "width");
    holds(MAIN, "<xacro:unheard_of d", "depth");
    holds(MAIN, "<gazebo><plugin_of_mine n", "name");
    holds(
        MAIN,
        "<xacro:include filename=\"$(find hand",
        "hand_description",
    );
}

#[test]
fn the_nearest_name_comes_first() {
    let found = offered(
        MAIN,
        "<joint name=\"joint_3\" type=\"revolute\"><limit upper=\"${jo",
    );
    assert_eq!(
        found.first().map(String::as_str),
        Some("joint_3_upper"),
        "{found:?}"
    );
    let found = offered(
        MAIN,
        "<joint name=\"joint_2\" type=\"revolute\"><limit upper=\"${jo",
    );
    assert_eq!(
        found.first().map(String::as_str),
        Some("joint_2_upper"),
        "{found:?}"
    );
}

#[test]
fn the_next_file_of_a_folder_comes_first() {
    let mesh = "<link name=\"a\"><visual><geometry><mesh filename=\"meshes/joint_2.stl\"/></geometry></visual><collision><geometry><mesh filename=\"meshes/";
    let found = offered(MAIN, mesh);
    assert_eq!(found[..2], ["joint_2.stl", "joint_3.stl"], "{found:?}");
}
