//! F7, F9, F10: definitions, references, highlights.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, UNIT, pan_tilt, write};

/// `file:line name` of each target.
#[track_caller]
fn check_definition(client: &mut Client, file: &str, at: &str, expected: &[&str]) {
    let targets = client.request("textDocument/definition", client.at(file, at));
    let shown: Vec<String> = targets
        .as_array()
        .into_iter()
        .flatten()
        .map(|link| {
            client.shown(
                link["targetUri"].as_str().unwrap(),
                &link["targetSelectionRange"],
            )
        })
        .collect();
    assert_eq!(shown, expected, "{at}");
}

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

#[test]
fn names_lead_to_where_they_are_given() {
    let mut client = both();
    check_definition(
        &mut client,
        ROBOT,
        "${m|0 / 3}",
        &["pan_tilt.urdf.xacro:3 m0"],
    );
    check_definition(
        &mut client,
        UNIT,
        "${m|0 * 2}",
        &["pan_tilt.urdf.xacro:3 m0"],
    );
    check_definition(
        &mut client,
        UNIT,
        "xyz=\"${ax|is}\"",
        &["unit.xacro:3 axis"],
    );
    check_definition(
        &mut client,
        ROBOT,
        "<xacro:un|it name=\"pan\"",
        &["unit.xacro:3 unit"],
    );
    check_definition(
        &mut client,
        ROBOT,
        "ax|is=\"0 1 0\"",
        &["unit.xacro:3 axis"],
    );
    check_definition(
        &mut client,
        ROBOT,
        "name=\"$(arg mo|unt)\"",
        &["pan_tilt.urdf.xacro:2 mount"],
    );
    check_definition(
        &mut client,
        UNIT,
        "insert_block name=\"a|t\"",
        &["unit.xacro:3 at"],
    );
}

#[test]
fn an_unsaved_include_leads_to_its_new_place() {
    let mut client = both();
    client.edit(
        UNIT,
        "  <!-- A motor with its bracket. -->\n",
        "  <!-- 🤖 -->\n\n\n",
    );
    check_definition(
        &mut client,
        ROBOT,
        "<xacro:un|it name=\"pan\"",
        &["unit.xacro:5 unit"],
    );
}

#[test]
fn names_in_a_broken_file_still_lead_somewhere() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<link name=\"");
    check_definition(
        &mut client,
        ROBOT,
        "${m|0 / 3}",
        &["pan_tilt.urdf.xacro:3 m0"],
    );
}

fn references(client: &mut Client, file: &str, at: &str) -> Vec<String> {
    let mut params = client.at(file, at);
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.request("textDocument/references", params);
    let shown = |place: &Value| client.shown(place["uri"].as_str().unwrap(), &place["range"]);
    found.as_array().unwrap().iter().map(shown).collect()
}

#[test]
fn references_are_found_in_all_files() {
    let mut client = both();
    let expected = [
        "pan_tilt.urdf.xacro:3 m0",
        "unit.xacro:4 m0",
        "pan_tilt.urdf.xacro:8 m0",
    ];
    let mut found = references(&mut client, ROBOT, "name=\"m|0\"");
    found.sort();
    let mut sorted = expected;
    sorted.sort();
    assert_eq!(found, sorted);
    assert_eq!(references(&mut client, UNIT, "${m|0 * 2}").len(), 3);
}

#[test]
fn highlights_tell_giving_from_reading() {
    let mut client = both();
    let found = client.request(
        "textDocument/documentHighlight",
        client.at(ROBOT, "name=\"m|0\""),
    );
    let kinds: Vec<i64> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|h| h["kind"].as_i64().unwrap())
        .collect();
    assert_eq!(kinds, [3, 2]);
    let tags = client.request("textDocument/documentHighlight", client.at(UNIT, "<jo|int"));
    assert_eq!(tags.as_array().unwrap().len(), 2);
}

/// `file:line name` of the targets of another kind of jump; files that are not open: their first line.
#[track_caller]
fn check_jump(client: &mut Client, kind: &str, file: &str, at: &str, expected: &[&str]) {
    let targets = client.request(&format!("textDocument/{kind}"), client.at(file, at));
    let shown = |link: &Value| {
        let uri = link
            .get("targetUri")
            .or_else(|| link.get("uri"))
            .unwrap()
            .as_str()
            .unwrap();
        let range = link
            .get("targetSelectionRange")
            .or_else(|| link.get("range"))
            .unwrap();
        client.shown(uri, range).trim_end().to_owned()
    };
    let shown: Vec<String> = targets
        .as_array()
        .into_iter()
        .flatten()
        .map(shown)
        .collect();
    assert_eq!(shown, expected, "{at}");
}

#[test]
fn a_link_that_a_macro_made_leads_into_the_macro_and_to_the_call() {
    let mut client = both();
    let expected = [
        "unit.xacro:4 ${name}_body",
        "pan_tilt.urdf.xacro:7 <xacro:unit",
    ];
    check_definition(&mut client, ROBOT, "parent=\"pan_b|ody\"", &expected);
    client.edit(ROBOT, "parent=\"pan_body\"", "parent=\"🤖\"");
    client.edit(ROBOT, "parent=\"$(arg mount)\"", "parent=\"desk\"");
    check_definition(
        &mut client,
        ROBOT,
        "parent=\"de|sk\"",
        &["pan_tilt.urdf.xacro:6 $(arg mount)"],
    );
    client.edit(ROBOT, "parent=\"🤖\"", "parent=\"pan_body\"");
    let mut found = references(&mut client, ROBOT, "parent=\"pan_b|ody\"");
    found.sort();
    let expected = [
        "pan_tilt.urdf.xacro:8 pan_body",
        "unit.xacro:4 ${name}_body",
        "unit.xacro:6 ${name}_body",
    ];
    assert_eq!(found, expected);
}

#[test]
fn a_link_and_a_joint_of_one_name_are_two_things() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<link name=\"arm\"/><joint name=\"arm\" type=\"fixed\"><parent link=\"desk\"/><child link=\"arm\"/></joint>\n\
         <material name=\"red\"><color rgba=\"1 0 0 1\"/></material>\
         <link name=\"red\"><visual><geometry><box size=\"1 1 1\"/></geometry><material name=\"red\"/></visual></link></robot>",
    );
    assert_eq!(
        references(&mut client, ROBOT, "<link name=\"ar|m\"").len(),
        2
    );
    assert_eq!(
        references(&mut client, ROBOT, "<joint name=\"ar|m\"").len(),
        1
    );
    assert_eq!(
        references(&mut client, ROBOT, "<material name=\"r|ed\"/>").len(),
        2
    );
    check_definition(
        &mut client,
        ROBOT,
        "<material name=\"r|ed\"/>",
        &["pan_tilt.urdf.xacro:10 red"],
    );
}

#[test]
fn names_of_files_and_keys_of_yaml_lead_to_files() {
    let mut client = both();
    super::workspace::write(
        &client.folder,
        "src/pan_tilt/meshes/head.stl",
        "solid head\nendsolid head\n",
    );
    client.open("src/pan_tilt/config/cam.yaml");
    client.edit(
        ROBOT,
        "</robot>",
        "<xacro:property name=\"masses\" value=\"${cam['mass']}\"/>\
         <link name=\"🤖${cam['fov']} ${cam.mass.head} ${masses['head']}\"><visual><geometry>\
         <mesh filename=\"package://pan_tilt/meshes/head.stl\"/></geometry></visual></link></robot>",
    );
    check_jump(
        &mut client,
        "definition",
        ROBOT,
        "filename=\"uni|t.xacro\"",
        &["unit.xacro:1"],
    );
    check_jump(
        &mut client,
        "definition",
        ROBOT,
        "config/ca|m.yaml",
        &["cam.yaml:1"],
    );
    check_jump(
        &mut client,
        "definition",
        ROBOT,
        "$(find pan|_tilt)",
        &["package.xml:1"],
    );
    check_jump(
        &mut client,
        "definition",
        ROBOT,
        "${cam['f|ov']}",
        &["cam.yaml:1 fov"],
    );
    check_jump(
        &mut client,
        "definition",
        ROBOT,
        "${cam.mass.he|ad}",
        &["cam.yaml:2 head"],
    );
    check_jump(
        &mut client,
        "definition",
        ROBOT,
        "${masses['h|ead']}",
        &["cam.yaml:2 head"],
    );
    check_jump(
        &mut client,
        "definition",
        ROBOT,
        "meshes/he|ad.stl",
        &["head.stl:1"],
    );
}

#[test]
fn declarations_types_and_implementations() {
    let mut client = both();
    super::workspace::write(
        &client.folder,
        "src/pan_tilt/meshes/head.stl",
        "solid head\nendsolid head\n",
    );
    client.open("src/pan_tilt/config/cam.yaml");
    check_jump(
        &mut client,
        "declaration",
        UNIT,
        "xyz=\"${ax|is}\"",
        &["unit.xacro:3 axis"],
    );
    check_jump(
        &mut client,
        "declaration",
        ROBOT,
        "name=\"$(arg mo|unt)\"",
        &["pan_tilt.urdf.xacro:2 mount"],
    );
    check_jump(&mut client, "declaration", ROBOT, "${m|0 / 3}", &[]);
    check_jump(
        &mut client,
        "typeDefinition",
        ROBOT,
        "name=\"c|am\"",
        &["cam.yaml:1"],
    );
    check_jump(&mut client, "implementation", ROBOT, "${m|0 / 3}", &[]);
    // the emoji and the unsaved include count, and the broken end does not
    client.edit(UNIT, "axis:='0 0 1' *at", "axis:='0 0 1' size:=1 *at");
    client.edit(
        UNIT,
        "  <!-- A motor with its bracket. -->\n",
        "\n\n  <!-- 🤖 --> ",
    );
    client.edit(ROBOT, "</robot>", "<link name=\"🤖\"/><link name=\"");
    check_jump(
        &mut client,
        "declaration",
        UNIT,
        "xyz=\"${ax|is}\"",
        &["unit.xacro:4 axis"],
    );
    let found = client.request(
        "textDocument/implementation",
        client.at(UNIT, "name=\"un|it\""),
    );
    let places: Vec<&str> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|link| link["targetUri"].as_str().unwrap())
        .collect();
    assert_eq!(places.len(), 4, "{found}");
    assert!(
        places
            .iter()
            .all(|uri| uri.starts_with("xacro-expanded:/pan_tilt.urdf?root=file")),
        "{found}"
    );
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    let lines: Vec<&str> = expanded["urdf"].as_str().unwrap().lines().collect();
    let line = |link: &Value| {
        lines[link["targetRange"]["start"]["line"].as_u64().unwrap() as usize].trim()
    };
    let shown: Vec<&str> = found.as_array().unwrap().iter().map(line).collect();
    assert_eq!(shown[0], "<link name=\"pan_body\">");
    assert!(shown[3].starts_with("<joint name=\"tilt\""), "{shown:?}");
}

#[test]
fn uses_are_found_in_all_robots_and_in_values_of_yaml() {
    let folder = pan_tilt();
    let place = |name: &str| format!("src/pan_tilt/urdf/{name}");
    let robot = |name: &str, link: &str| {
        format!(
            "<robot name=\"{name}\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<xacro:include filename=\"tip.xacro\"/>\n\
             <xacro:property name=\"c\" value=\"${{xacro.load_yaml('c.yaml')}}\"/>\n<link name=\"b${{len(c)}}{link}\"/>\n\
             <gazebo reference=\"🤖_tip\"/><link name=\"${{size}}\"/></robot>\n"
        )
    };
    let tip = "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:property name=\"size\" value=\"1\"/>\
               <link name=\"🤖_tip\"/></robot>\n";
    write(&folder, &place("tip.xacro"), tip);
    write(
        &folder,
        &place("c.yaml"),
        "🤖_tip: 1\nlinks: [other, 🤖_tip]\n",
    );
    write(&folder, &place("one.urdf.xacro"), robot("one", ""));
    write(&folder, &place("two.urdf.xacro"), robot("two", ""));
    // a link of the same name that another text gives
    let stranger = "<robot name=\"x\"><link name=\"🤖_tip\"/></robot>\n";
    write(&folder, &place("three.urdf"), stranger);
    let mut client = Client::with(folder, Options::default());
    client.open(&place("tip.xacro"));
    client.open(&place("one.urdf.xacro"));
    client.edit(&place("tip.xacro"), "<link", "<!-- 🤖 --><link");
    let found = references(&mut client, &place("one.urdf.xacro"), "reference=\"🤖_|tip");
    let expected = [
        "tip.xacro:1 🤖_tip",
        "one.urdf.xacro:5 🤖_tip",
        "two.urdf.xacro:5 ",
        "c.yaml:2 ",
    ]
    .map(str::to_owned);
    assert_eq!(found, expected);
    let found = references(&mut client, &place("tip.xacro"), "name=\"si|ze\"");
    let expected = [
        "tip.xacro:1 size",
        "one.urdf.xacro:5 size",
        "two.urdf.xacro:5 ",
    ]
    .map(str::to_owned);
    assert_eq!(found, expected);
}

#[test]
fn all_of_a_call_in_front_of_its_name_leads_to_the_macro() {
    let mut client = both();
    for at in [
        "|<xacro:unit name=\"pan\"",
        "<|xacro:unit name=\"pan\"",
        "<xac|ro:unit name=\"pan\"",
        "<xacro|:unit name=\"pan\"",
    ] {
        check_definition(&mut client, ROBOT, at, &["unit.xacro:3 unit"]);
    }
    check_definition(&mut client, ROBOT, "|<link name", &[]);
}
