//! Names whose meaning arguments decide: what other arguments would bring in, and what they cannot.

use serde_json::json;

use super::client::{Client, Options};
use super::names::{leads, references};
use super::workspace::{fresh_folder, write};

/// A client with the files of a folder `src` open, each a robot with one of these contents.
fn with(files: &[(&str, &str)]) -> Client {
    let folder = fresh_folder();
    for (name, content) in files {
        let own = if *name == "r.urdf.xacro" {
            "name=\"r\" "
        } else {
            ""
        };
        let text = format!(
            "<robot {own}xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{content}\n</robot>\n"
        );
        write(&folder, &format!("src/{name}"), text);
    }
    let mut client = Client::with(folder, Options::default());
    for (name, _) in files {
        client.open(&format!("src/{name}"));
    }
    client
}

#[test]
fn what_other_arguments_would_define_is_named_behind_what_was_evaluated() {
    let kinds = ["small", "large"].map(|kind| {
        format!("<xacro:property name=\"kind\" value=\"{kind}\"/><xacro:include filename=\"pads.xacro\"/>")
    });
    let pads = "<link name=\"pad_${kind}\"/><xacro:macro name=\"tip\"><link name=\"tip_${kind}\"/></xacro:macro>\n\
        <xacro:macro name=\"tips\"><xacro:tip/></xacro:macro>";
    let main = "<xacro:arg name=\"kind\" default=\"small\"/>\n\
        <xacro:macro name=\"hand\" params=\"kind\">\n\
        <xacro:if value=\"${kind == 'small'}\"><xacro:include filename=\"small.xacro\"/><xacro:tips/></xacro:if>\n\
        <xacro:if value=\"${kind == 'large'}\"><xacro:include filename=\"large.xacro\"/><xacro:tips/></xacro:if>\n\
        <link name=\"hand_${kind}\"/></xacro:macro>\n\
        <xacro:hand kind=\"$(arg kind)\"/>";
    let mut client = with(&[
        ("r.urdf.xacro", main),
        ("small.xacro", &kinds[0]),
        ("large.xacro", &kinds[1]),
        ("pads.xacro", pads),
    ]);
    let (small, large) = ("small.xacro:2 kind", "large.xacro:2 kind");
    // the parameter is left for a third kind
    leads(
        &mut client,
        "src/r.urdf.xacro",
        "hand_${ki|nd}",
        &[small, "r.urdf.xacro:3 kind", large],
    );
    // each file that includes the pads defines the kind in front of it
    leads(
        &mut client,
        "src/pads.xacro",
        "pad_${ki|nd}",
        &[small, large],
    );
    leads(
        &mut client,
        "src/pads.xacro",
        "tip_${ki|nd}",
        &[small, large],
    );
    let found = references(&mut client, "src/large.xacro", "name=\"ki|nd");
    assert_eq!(
        found,
        [
            "large.xacro:2 kind",
            "pads.xacro:2 kind",
            "pads.xacro:2 kind",
            "r.urdf.xacro:6 kind"
        ]
    );
}

#[test]
fn a_value_that_is_evaluated_later_means_nothing_in_front_of_a_sure_definition() {
    let hand = |index: u8| {
        format!(
            "<xacro:if value=\"${{kind == {index}}}\">\n<xacro:property name=\"own\" value=\"{index}\"/>\n\
             <xacro:property name=\"tip\" value=\"${{own * {index}}}\"/><link name=\"${{tip}}\"/></xacro:if>\n"
        )
    };
    let main = format!(
        "<xacro:macro name=\"hand\" params=\"kind\">{}{}</xacro:macro><xacro:hand kind=\"3\"/>",
        hand(1),
        hand(2)
    );
    let mut client = with(&[("r.urdf.xacro", &main)]);
    leads(
        &mut client,
        "src/r.urdf.xacro",
        "${ow|n * 1}",
        &["r.urdf.xacro:3 own"],
    );
    leads(
        &mut client,
        "src/r.urdf.xacro",
        "${ow|n * 2}",
        &["r.urdf.xacro:6 own"],
    );
}

#[test]
fn what_a_called_macro_hands_out_hides_what_callers_have() {
    let main = "<xacro:arg name=\"on\" default=\"false\"/><xacro:property name=\"size\" value=\"1\"/>\n\
        <xacro:macro name=\"measure\"><xacro:property name=\"size\" value=\"2\" scope=\"parent\"/></xacro:macro>\n\
        <xacro:macro name=\"pad\"><link name=\"old_${size}\"/>\n\
        <xacro:measure/><link name=\"new_${size}\"/></xacro:macro>\n\
        <xacro:if value=\"$(arg on)\"><xacro:pad/></xacro:if><link name=\"base\"/>";
    let mut client = with(&[("r.urdf.xacro", main)]);
    let file = "src/r.urdf.xacro";
    leads(&mut client, file, "old_${si|ze}", &["r.urdf.xacro:2 size"]);
    leads(&mut client, file, "new_${si|ze}", &["r.urdf.xacro:3 size"]);
}

#[test]
fn a_body_calls_the_macros_that_it_includes_itself() {
    let load = |kind: &str| {
        format!(
            "<xacro:macro name=\"load_{kind}\"><xacro:include filename=\"pads_{kind}.xacro\"/>\n<xacro:pad width=\"1\"/></xacro:macro>"
        )
    };
    let pads = |kind: &str| {
        format!(
            "<xacro:macro name=\"pad\" params=\"width\"><link name=\"{kind}_${{width}}\"/></xacro:macro>"
        )
    };
    // others bring in the pads too, in a scope of their own
    let main = "<xacro:arg name=\"kind\" default=\"none\"/>\n\
        <xacro:include filename=\"near.xacro\"/><xacro:include filename=\"far.xacro\"/>\n\
        <xacro:macro name=\"hand\"><xacro:include filename=\"pads_$(arg kind).xacro\"/><xacro:pad width=\"2\"/></xacro:macro>\n\
        <xacro:if value=\"${'$(arg kind)' == 'near'}\"><xacro:load_near/><xacro:hand/></xacro:if>\n\
        <xacro:if value=\"${'$(arg kind)' == 'far'}\"><xacro:load_far/><xacro:hand/></xacro:if><link name=\"base\"/>";
    let mut client = with(&[
        ("r.urdf.xacro", main),
        ("near.xacro", &load("near")),
        ("far.xacro", &load("far")),
        ("pads_near.xacro", &pads("near")),
        ("pads_far.xacro", &pads("far")),
    ]);
    for (kind, other) in [("near", "far"), ("far", "near")] {
        let (file, pads) = (format!("src/{kind}.xacro"), format!("pads_{kind}.xacro"));
        leads(
            &mut client,
            &file,
            "<xacro:pa|d ",
            &[&format!("{pads}:2 pad")],
        );
        let found = references(&mut client, &format!("src/{pads}"), "${wid|th}");
        let is_of = |name: &str| found.iter().any(|place| place.starts_with(name));
        assert!(is_of(&format!("{kind}.xacro")), "{found:?}");
        assert!(!is_of(&format!("{other}.xacro")), "{found:?}");
    }
}

#[test]
fn a_rename_reaches_robots_that_include_from_a_folder_in_an_argument() {
    let folder = fresh_folder();
    write(
        &folder,
        "arm/package.xml",
        "<package format=\"3\"><name>arm</name></package>",
    );
    let offsets = "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:property name=\"offset\" value=\"1\"/></robot>\n";
    write(&folder, "arm/calibration/offsets.xacro", offsets);
    let robot = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n\
        <xacro:arg name=\"folder\" default=\"$(find arm)/calibration\"/>\n\
        <xacro:include filename=\"$(arg folder)/offsets.xacro\"/>\n<link name=\"base_${offset}\"/>\n</robot>\n";
    write(&folder, "arm/robots/r.urdf.xacro", robot);
    let mut client = Client::with(folder, Options::default());
    client.open("arm/calibration/offsets.xacro");
    let mut params = client.at("arm/calibration/offsets.xacro", "name=\"off|set\"");
    params["newName"] = json!("shift");
    let edit = client.request("textDocument/rename", params);
    let changed = edit["changes"].as_object().unwrap();
    assert!(
        changed.keys().any(|uri| uri.ends_with("r.urdf.xacro")),
        "{edit}"
    );
}
