//! F6, F22, F23, F26: what is shown inside and above the text.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{self, ROBOT, UNIT};

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

/// All hints of a file: `line label`, lines from 1.
fn hints(client: &mut Client, file: &str) -> Vec<String> {
    let found = all_hints(client, file);
    let shown = |hint: &Value| {
        let line = hint["position"]["line"].as_u64().unwrap() + 1;
        format!("{line} {}", hint["label"].as_str().unwrap())
    };
    found.iter().map(shown).collect()
}

fn all_hints(client: &mut Client, file: &str) -> Vec<Value> {
    let mut params = client.of(file);
    params["range"] =
        json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 1000, "character": 0 } });
    client
        .request("textDocument/inlayHint", params)
        .as_array()
        .unwrap()
        .clone()
}

#[test]
fn values_stand_behind_expressions() {
    let mut client = both();
    assert_eq!(
        hints(&mut client, ROBOT),
        ["6 → desk", "7 → desk", "7 at:", "8 at:", "8 = 0.05"]
    );
    let found = hints(&mut client, UNIT);
    // several of a line stand at its end
    let expected = [
        "4 name = pan, tilt; value = 0.3",
        "5 = pan, tilt",
        "6 link = desk, pan_body; link = pan, tilt",
        "7 = 0 0 1, 0 1 0",
    ];
    assert_eq!(found, expected);
    client.edit(ROBOT, "${m0 / 3}", "🤖${m0 / 3}${1 + 1}${'x' + nothing}");
    let last = all_hints(&mut client, ROBOT).pop().unwrap();
    assert_eq!(last["label"], "= 0.05");
    let place = json!({ "start": last["position"], "end": last["position"] });
    assert_eq!(client.slice(ROBOT, &place), "");
    let tooltip = client.request("inlayHint/resolve", last)["tooltip"]["value"].clone();
    assert!(
        tooltip.as_str().unwrap().contains("`m0 / 3` = `0.05`"),
        "{tooltip}"
    );
}

#[test]
fn more_than_three_values_are_cut() {
    let mut client = both();
    let calls = ["a", "b"]
        .map(|name| format!("<xacro:unit name=\"{name}\" parent=\"desk\"><origin/></xacro:unit>"));
    client.edit(ROBOT, "</robot>", &format!("{}</robot>", calls.concat()));
    assert!(hints(&mut client, UNIT).contains(&"5 = pan, tilt, …".to_owned()));
    client.edit(ROBOT, "</robot>", "<link name=\"");
    assert!(
        hints(&mut client, UNIT)
            .iter()
            .any(|hint| hint.ends_with("value = 0.3"))
    );
}

#[test]
fn numbers_are_short_and_what_is_evident_has_no_hint() {
    let mut client = both();
    let call = "<xacro:unit name=\"tilt\"";
    let lines = [
        ("<origin xyz=\"${1 / m0} 0 0\"/>", Some("= 6.667")),
        ("<origin rpy=\"0 0 ${m0 * pi}\"/>", Some("= 0.4712 (27°)")),
        ("<origin xyz=\"${m0 * 1e6 / 4.5} 0 0\"/>", Some("= 33333.0")),
        (
            "<origin xyz=\"${m0 * -1e6 / 4.5} 0 0\"/>",
            Some("= -33333.0"),
        ),
        (
            "<joint name=\"a\" type=\"revolute\"><limit lower=\"${-m0 * pi}\" upper=\"${pi/2}\"/></joint>",
            Some("= -0.4712 (-27°)"),
        ),
        (
            "<joint name=\"a\" type=\"revolute\"><limit lower=\"${-m0 * pi}\" upper=\"${m0 * pi}\"/></joint>",
            Some("lower = -0.4712 (-27°); upper = 0.4712 (27°)"),
        ),
        (
            "<joint name=\"a\" type=\"prismatic\"><limit lower=\"${-m0 * pi}\"/></joint>",
            Some("= -0.4712"),
        ),
        (
            "<joint name=\"a\" type=\"revolute\"><limit lower=\"-1.57\" effort=\"${m0 * 3}\"/></joint>",
            Some("= 0.45"),
        ),
        ("<origin rpy=\"${pi} 0 0\"/>", None),
        ("<origin rpy=\"0 ${-pi/2} 0\"/>", None),
        ("<xacro:property name=\"m1\" value=\"${m0}\"/>", None),
        (
            "<xacro:property name=\"side\" value=\"left_\"/><link name=\"${side}foot\"/>",
            None,
        ),
    ];
    for (line, expected) in lines {
        client.edit(ROBOT, call, &format!("{line}\n{call}"));
        let found = hints(&mut client, ROBOT);
        let own = found.iter().find_map(|hint| hint.strip_prefix("8 "));
        assert_eq!(own, expected, "{line}: {found:?}");
        client.edit(ROBOT, &format!("{line}\n"), "");
    }
}

#[test]
fn settings_turn_hints_off() {
    let settings = json!({ "inlayHints": { "values": false, "paramNames": "never" } });
    let options = Options {
        settings,
        ..Options::default()
    };
    let mut client = Client::with(workspace::pan_tilt(), options);
    client.open(ROBOT);
    client.diagnostics(ROBOT);
    assert!(client.eventually(|client| hints(client, ROBOT).is_empty()));
}

#[test]
fn far_end_tags_say_what_they_end() {
    let mut client = both();
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"/>",
        &format!("<link name=\"base\">{}</link>", "\n".repeat(30)),
    );
    assert!(hints(&mut client, ROBOT).contains(&"36 base".to_owned()));
}

#[test]
fn names_of_files_are_links() {
    let mut client = both();
    workspace::write(
        &client.folder,
        "src/pan_tilt/meshes/head.stl",
        "solid x\nendsolid x\n",
    );
    let visual = "<link name=\"🤖\"><visual><geometry><mesh filename=\"package://pan_tilt/meshes/head.stl\"/></geometry>\
        </visual></link><gazebo><x>$(find pan_tilt)/config/cam.yaml</x><y>package://pan_tilt/gone</y></gazebo></robot";
    client.edit(ROBOT, "</robot>", visual);
    let found = client.request("textDocument/documentLink", client.of(ROBOT));
    let shown = |link: &Value| {
        let target = link["target"]
            .as_str()
            .unwrap()
            .rsplit('/')
            .next()
            .unwrap()
            .to_owned();
        assert!(link["tooltip"].as_str().unwrap().ends_with(&target));
        format!("{} {target}", client.slice(ROBOT, &link["range"]))
    };
    let shown: Vec<String> = found.as_array().unwrap().iter().map(shown).collect();
    let expected = [
        "$(find pan_tilt)/config/cam.yaml cam.yaml",
        "unit.xacro unit.xacro",
        "package://pan_tilt/meshes/head.stl head.stl",
        "$(find pan_tilt)/config/cam.yaml cam.yaml",
    ];
    assert_eq!(shown, expected);
}

#[test]
fn colors_can_be_picked_where_they_are_written() {
    let mut client = both();
    let materials = "<xacro:property name=\"half\" value=\"0.5\"/><material name=\"a\"><color rgba=\"1 0 0 1\"/></material>\
        <material name=\"🤖\"><color rgba=\"0 ${half} 0 1\"/></material><material name=\"c\"><color rgba=\"red\"/></material>\
        <xacro:broken";
    client.edit(ROBOT, "</robot>", materials);
    let found = client.request("textDocument/documentColor", client.of(ROBOT));
    let found = found.as_array().unwrap();
    let texts: Vec<String> = found
        .iter()
        .map(|color| client.slice(ROBOT, &color["range"]))
        .collect();
    assert_eq!(texts, ["1 0 0 1", "0 ${half} 0 1"]);
    assert_eq!(
        found[1]["color"],
        json!({ "red": 0.0, "green": 0.5, "blue": 0.0, "alpha": 1.0 })
    );
    let mut picked = |color: &Value| {
        let mut params = client.of(ROBOT);
        params["range"] = color["range"].clone();
        params["color"] = json!({ "red": 0.33333, "green": 1, "blue": 0, "alpha": 0.5 });
        client.request("textDocument/colorPresentation", params)
    };
    assert_eq!(picked(&found[0])[0]["label"], "0.333 1 0 0.5");
    assert_eq!(picked(&found[1]), json!([]));
}

#[test]
fn lenses_count_calls() {
    let mut client = both();
    let found = client.request("textDocument/codeLens", client.of(UNIT));
    let lens = found[0].clone();
    assert_eq!(client.slice(UNIT, &lens["range"]), "unit");
    let lens = client.request("codeLens/resolve", lens);
    assert_eq!(lens["command"]["title"], "2 calls in 1 root");
    let command =
        json!({ "command": "xacro.showReferences", "arguments": lens["command"]["arguments"] });
    let places = client.request("workspace/executeCommand", command);
    assert_eq!(places.as_array().unwrap().len(), 2);
    client.edit(
        ROBOT,
        "<xacro:unit name=\"tilt\"",
        "<xacro:unitt name=\"tilt\"",
    );
    let found = client.request("textDocument/codeLens", client.of(UNIT));
    assert_eq!(
        client.request("codeLens/resolve", found[0].clone())["command"]["title"],
        "1 call in 1 root"
    );
    assert!(titles(&mut client).contains(&"Expand".to_owned()));
}

/// The titles of the lenses of the robot that need no resolving.
fn titles(client: &mut Client) -> Vec<String> {
    let found = client.request("textDocument/codeLens", client.of(ROBOT));
    let titles = found.as_array().unwrap().iter();
    titles
        .filter_map(|lens| lens["command"]["title"].as_str().map(str::to_owned))
        .collect()
}

#[test]
fn lenses_name_the_arguments_that_matter() {
    let mut client = both();
    let mount = "<xacro:arg name=\"mount\" default=\"desk\"/>";
    let more = "<xacro:arg name=\"side\" default=\"left\"/><xacro:arg name=\"yaml\" default=\"\"/>";
    client.edit(ROBOT, mount, &format!("{mount}{more}"));
    let all = [
        "Preview",
        "Expand",
        "mount:=desk ▾",
        "side:=left ▾",
        "yaml:= ▾",
    ];
    assert_eq!(titles(&mut client), all);
    let mut params = client.of(ROBOT);
    params["args"] =
        json!({ "yaml": "../configurations/of/arms/p.yaml", "side": "left", "mount": "wall" });
    client.request(
        "workspace/executeCommand",
        json!({ "command": "xacro.setArgs", "arguments": [params] }),
    );
    let given = ["Preview", "Expand", "mount:=wall ▾", "yaml:=…/p.yaml ▾"];
    assert_eq!(titles(&mut client), given);
}
