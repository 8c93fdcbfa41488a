//! F34: what one place expands to; one call of a macro picked out of many; arguments of a session.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, UNIT};

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

#[track_caller]
fn at(client: &mut Client, file: &str, place: &str) -> Value {
    let found = client.request("xacro/expandAt", client.at(file, place));
    assert!(!found.is_null(), "nothing at {place}");
    found
}

/// `kind expanded` of a place.
#[track_caller]
fn shown(client: &mut Client, file: &str, place: &str) -> String {
    let found = at(client, file, place);
    format!(
        "{} {}",
        found["kind"].as_str().unwrap(),
        found["expanded"].as_str().unwrap()
    )
}

#[test]
fn a_call_expands_to_what_it_makes_alone() {
    let mut client = both();
    let found = at(&mut client, ROBOT, "<xacro:un|it name=\"pan\"");
    assert_eq!(
        (&found["kind"], &found["instances"]),
        (&json!("macro"), &json!(1))
    );
    let expanded = found["expanded"].as_str().unwrap();
    assert!(
        expanded.contains("pan_body") && !expanded.contains("tilt_body"),
        "{expanded}"
    );
    assert!(
        expanded.starts_with("<link name=\"pan_body\">\n  <inertial>"),
        "{expanded}"
    );
    assert!(
        client
            .slice(ROBOT, &found["range"])
            .ends_with("</xacro:unit>")
    );
    // the block of a call belongs to it
    let found = at(&mut client, ROBOT, "<ori|gin xyz=\"0 0 0.1\"");
    assert_eq!(found["kind"], "macro");
}

#[test]
fn every_kind_of_place_has_its_result() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<xacro:property name=\"two\"><link name=\"in_block\"/></xacro:property>\
         <xacro:insert_block name=\"two\"/>\
         <xacro:if value=\"${m0 > 0}\"><link name=\"heavy\"/></xacro:if>\
         <xacro:unless value=\"true\"><link name=\"light\"/></xacro:unless></robot>",
    );
    assert_eq!(
        shown(&mut client, ROBOT, "${m0 |/ 3}"),
        "expression 0.049999999999999996"
    );
    assert_eq!(
        shown(&mut client, ROBOT, "<xacro:prop|erty name=\"m0\""),
        "property 0.15"
    );
    assert_eq!(shown(&mut client, ROBOT, "<xacro:inc|lude"), "include ");
    assert_eq!(
        shown(&mut client, ROBOT, "<xacro:i|f "),
        "condition <link name=\"heavy\"/>"
    );
    assert_eq!(shown(&mut client, ROBOT, "<xacro:un|less"), "condition ");
    assert_eq!(
        shown(&mut client, ROBOT, "<xacro:insert_bl|ock"),
        "block <link name=\"in_block\"/>"
    );
    assert_eq!(
        shown(&mut client, ROBOT, "name=\"tw|o\"><link"),
        "property <link name=\"in_block\"/>"
    );
    assert_eq!(
        shown(&mut client, UNIT, "<xacro:insert_bl|ock"),
        "block <origin xyz=\"0 0 0.1\"/>"
    );
    assert!(
        client
            .request("xacro/expandAt", client.at(ROBOT, "<robot na|me"))
            .is_null()
    );
}

#[test]
fn all_of_a_call_in_front_of_its_name_expands() {
    let mut client = both();
    let on_name = at(&mut client, ROBOT, "<xacro:un|it name=\"pan\"");
    for place in [
        "|<xacro:unit name=\"pan\"",
        "<xac|ro:unit name=\"pan\"",
        "<xacro|:unit name=\"pan\"",
    ] {
        assert_eq!(at(&mut client, ROBOT, place), on_name, "{place}");
    }
}

#[test]
fn a_macro_expands_call_by_call() {
    let mut client = both();
    let mut params = client.at(UNIT, "<xacro:ma|cro");
    let first = client.request("xacro/expandAt", params.clone());
    assert_eq!(first["instances"], 2);
    assert_eq!(
        first["title"],
        "macro `unit` in `unit` at pan_tilt.urdf.xacro:7"
    );
    params["instance"] = json!(1);
    let second = client.request("xacro/expandAt", params.clone());
    assert!(
        second["expanded"].as_str().unwrap().contains("tilt_body"),
        "{second}"
    );
    params["instance"] = json!(2);
    assert_eq!(client.request("xacro/expandAt", params)["expanded"], "");
}

#[test]
fn a_place_expands_under_another_root_too() {
    let mut client = both();
    let mut params = client.at(ROBOT, "$(arg mo|unt)");
    params["root"] = json!({ "uri": client.uri(ROBOT), "args": { "mount": "wall" } });
    assert_eq!(
        client.request("xacro/expandAt", params.clone())["expanded"],
        "wall"
    );
    let command = json!({ "command": "xacro.expandAt", "arguments": [params] });
    assert_eq!(
        client.request("workspace/executeCommand", command)["expanded"],
        "wall"
    );
}

#[test]
fn broken_texts_unsaved_includes_and_wide_characters_are_expanded_as_far_as_they_go() {
    let mut client = both();
    client.edit(
        ROBOT,
        "<xacro:unit name=\"pan\"",
        "<!-- 🤖🤖 --><xacro:unit name=\"pan\"",
    );
    client.edit(UNIT, "_body\"><inertial>", "_arm\"><inertial>");
    let found = at(&mut client, ROBOT, "<xacro:un|it name=\"pan\"");
    assert!(
        found["expanded"]
            .as_str()
            .unwrap()
            .contains("<link name=\"pan_arm\">"),
        "{found}"
    );
    assert!(
        client
            .slice(ROBOT, &found["range"])
            .starts_with("<xacro:unit name=\"pan\"")
    );
    client.edit(ROBOT, "</robot>", "<link name=\"");
    let found = at(&mut client, ROBOT, "<xacro:un|it name=\"pan\"");
    assert!(
        found["expanded"].as_str().unwrap().contains("pan_arm"),
        "{found}"
    );
    client.edit(ROBOT, "m0 / 3", "m0 / nothing");
    assert_eq!(at(&mut client, ROBOT, "m0 |/ nothing")["expanded"], "?");
}

/// The text of the status item that the client was told last for a file.
fn status(client: &mut Client, file: &str, wanted: &str) -> String {
    let uri = json!(client.uri(file));
    client.wait(
        |client| {
            let told = client.notes.iter().rev().find(|note| {
                note["method"] == "xacro/contextChanged"
                    && note["params"]["textDocument"]["uri"] == uri
            })?;
            let text = told["params"]["text"].as_str()?;
            (text == wanted).then(|| text.to_owned())
        },
        || format!("status `{wanted}`"),
    )
}

#[test]
fn values_follow_the_call_that_was_picked() {
    let mut client = both();
    status(&mut client, UNIT, "pan_tilt.urdf.xacro");
    let mut params = client.at(UNIT, "<ax|is");
    params["instance"] = json!(1);
    client.request("xacro/setInstance", params.clone());
    status(&mut client, UNIT, "unit @ pan_tilt.urdf.xacro:8");
    let roots = client.request("xacro/roots", client.of(UNIT));
    assert_eq!(roots["text"], "unit @ pan_tilt.urdf.xacro:8");
    assert_eq!(roots["instance"], roots["text"]);
    let hover = client.request("textDocument/hover", client.at(UNIT, "${na|me}_body"));
    let text = hover["contents"]["value"].as_str().unwrap();
    assert!(
        text.contains("= `tilt`") && !text.contains("- `pan`"),
        "{text}"
    );
    let everything =
        json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let mut asked = client.of(UNIT);
    asked["range"] = everything;
    let hints = client.request("textDocument/inlayHint", asked);
    let labels: Vec<&str> = hints
        .as_array()
        .unwrap()
        .iter()
        .map(|h| h["label"].as_str().unwrap())
        .collect();
    assert!(
        labels.contains(&"= tilt") && labels.contains(&"= 0 1 0"),
        "{labels:?}"
    );
    // the call moves down, and is still the one that was picked
    client.edit(
        ROBOT,
        "  <xacro:unit name=\"pan\"",
        "  <!-- 🤖 -->\n  <xacro:unit name=\"pan\"",
    );
    status(&mut client, UNIT, "unit @ pan_tilt.urdf.xacro:9");
    assert_eq!(shown(&mut client, UNIT, "${na|me}_body"), "expression tilt");
    params["instance"] = Value::Null;
    client.request("xacro/setInstance", params);
    status(&mut client, UNIT, "pan_tilt.urdf.xacro");
    let hover = client.request("textDocument/hover", client.at(UNIT, "${na|me}_body"));
    assert!(
        hover["contents"]["value"]
            .as_str()
            .unwrap()
            .contains("- `pan`"),
        "{hover}"
    );
}

#[test]
fn an_instance_that_is_not_there_is_refused() {
    let mut client = both();
    let mut params = client.at(UNIT, "<ax|is");
    params["instance"] = json!(2);
    let id = client.post("xacro/setInstance", params);
    let reply = client.reply(id);
    assert!(
        reply["error"]["message"]
            .as_str()
            .unwrap()
            .contains("called 2 times"),
        "{reply}"
    );
    let mut params = client.at(ROBOT, "<link na|me");
    params["instance"] = json!(0);
    let id = client.post("xacro/setInstance", params);
    assert!(
        client.reply(id)["error"]["message"]
            .as_str()
            .unwrap()
            .contains("no called macro")
    );
}

#[test]
fn arguments_are_set_for_the_session_and_taken_back() {
    let mut client = both();
    let mut params = client.of(UNIT);
    params["args"] = json!({ "mount": "wall" });
    let set = |params: &Value| json!({ "command": "xacro.setArgs", "arguments": [params] });
    let roots = client.request("workspace/executeCommand", set(&params));
    assert_eq!(
        roots["args"],
        json!([{ "name": "mount", "value": "wall", "default": "desk" }])
    );
    status(&mut client, UNIT, "pan_tilt.urdf.xacro mount:=wall");
    assert_eq!(
        shown(&mut client, ROBOT, "$(arg mo|unt)"),
        "expression wall"
    );
    params["args"] = json!({});
    client.request("workspace/executeCommand", set(&params));
    assert_eq!(
        shown(&mut client, ROBOT, "$(arg mo|unt)"),
        "expression desk"
    );
}
