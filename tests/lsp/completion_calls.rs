//! Completion follows calls: what called macros make, what callers give, and the files that a computed include may mean.

use super::client::{Client, Options};
use super::positions::position;
use super::workspace::{fresh_folder, write};

const FILE: &str = "src/arm/chassis.xacro";

const TEXT: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find arm)/hands/${kind}/${kind}.xacro" ns="hand"/>
  <xacro:macro name="wheel" params="side model:=flat">
    <link name="${prefix}wheel_${side}_${model}"/><!-- in wheel -->
  </xacro:macro>
  <xacro:macro name="both" params="at">
    <xacro:property name="joined" value="${prefix}${at}"/>
    <xacro:wheel side="${at}_outer"/>
    <xacro:wheel side="${joined}"/>
  </xacro:macro>
  <xacro:macro name="chassis" params="prefix mount_parent *origin">
    <xacro:property name="track" value="0.4"/>
    <xacro:wheel side="left"/>
    <xacro:both at="right"/>
    <xacro:camera parent="${prefix}plate_link"/>
    <link name="${prefix}hub_link"/>
    <!-- in chassis -->
  </xacro:macro>
</robot>
"#;

const HAND: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="grip" params="force"><link name="finger"/></xacro:macro>
</robot>
"#;

/// The labels that are offered where `tail` was typed in front of a comment.
fn offered(comment: &str, tail: &str) -> Vec<String> {
    let folder = fresh_folder();
    write(&folder, FILE, TEXT);
    write(
        &folder,
        "src/arm/package.xml",
        "<package format=\"3\"><name>arm</name></package>",
    );
    for kind in ["soft", "hard"] {
        write(&folder, &format!("src/arm/hands/{kind}/{kind}.xacro"), HAND);
    }
    let simulated = TEXT.replace(
        "$(find arm)/hands/${kind}/${kind}.xacro",
        "$(find arm_simulation)/all.xacro",
    );
    write(&folder, "src/arm/simulated.xacro", simulated);
    let mut client = Client::with(folder, Options::default());
    let (before, behind) = TEXT.split_once(comment).unwrap();
    let before = format!("{before}{tail}");
    let text = format!("{before}{behind}");
    client.open_with(FILE, &text);
    let mut params = client.of(FILE);
    params["position"] = position(&text, before.len());
    let answer = client.request("textDocument/completion", params);
    answer["items"]
        .as_array()
        .unwrap()
        .iter()
        .map(|item| item["label"].as_str().unwrap().to_owned())
        .collect()
}

#[track_caller]
fn holds(comment: &str, tail: &str, expected: &str) {
    let found = offered(comment, tail);
    assert!(
        found.iter().any(|label| label == expected),
        "`{expected}` at `{tail}`: {found:?}"
    );
}

const IN_CHASSIS: &str = "<!-- in chassis -->";
const IN_WHEEL: &str = "<!-- in wheel -->";

#[test]
fn links_that_called_macros_make_are_spelled_as_the_caller_would() {
    holds(
        IN_CHASSIS,
        "<joint name=\"j\"><child link=\"${prefix}wheel_l",
        "${prefix}wheel_left_flat",
    );
    // through another macro
    let found = offered(
        IN_CHASSIS,
        "<joint name=\"j\"><child link=\"${prefix}wheel_r",
    );
    assert!(
        found.contains(&"${prefix}wheel_right_outer_flat".to_owned()),
        "{found:?}"
    );
}

#[test]
fn links_that_calls_name_are_offered() {
    holds(
        IN_CHASSIS,
        "<joint name=\"j\"><parent link=\"${prefix}pl",
        "${prefix}plate_link",
    );
}

#[test]
fn what_stands_behind_another_expression_is_offered_behind_this_one() {
    holds(
        IN_CHASSIS,
        "<joint name=\"j\"><parent link=\"${mount_parent}hu",
        "${mount_parent}hub_link",
    );
}

#[test]
fn a_macro_sees_what_its_callers_have() {
    for (tail, expected) in [
        ("${pre", "prefix"),
        ("${tr", "track"),
        ("${moun", "mount_parent"),
        ("${joi", "joined"),
    ] {
        holds(IN_WHEEL, &format!("<link name=\"{tail}"), expected);
    }
    // a block is no value
    let found = offered(IN_WHEEL, "<link name=\"${ori");
    assert!(!found.contains(&"origin".to_owned()), "{found:?}");
}

#[test]
fn files_behind_computed_includes_are_known() {
    holds(IN_CHASSIS, "<xacro:hand.gr", "xacro:hand.grip");
    holds(IN_CHASSIS, "<xacro:hand.grip fo", "force");
}

#[test]
fn packages_that_the_folder_finds_are_offered() {
    holds(
        IN_CHASSIS,
        "<xacro:include filename=\"$(find arm_s",
        "arm_simulation",
    );
}
