//! The preview: models after each change, selection both ways, and the page for browsers.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, UNIT};

fn root(client: &Client, args: Value) -> Value {
    json!({ "root": { "uri": client.uri(ROBOT), "args": args } })
}

/// The next model of a view.
fn model(client: &mut Client, id: &Value) -> Value {
    let next = |client: &mut Client| {
        let ours =
            |note: &Value| note["method"] == "xacro/preview/model" && note["params"]["id"] == *id;
        let at = client.notes.iter().position(ours)?;
        Some(client.notes.remove(at)["params"].clone())
    };
    client.wait(next, || "model".to_owned())
}

/// Models until one is as wanted.
fn model_with(client: &mut Client, id: &Value, wanted: impl Fn(&Value) -> bool) -> Value {
    loop {
        let found = model(client, id);
        if wanted(&found) {
            return found;
        }
    }
}

fn names(list: &Value) -> Vec<String> {
    list.as_array()
        .unwrap()
        .iter()
        .map(|entry| entry["name"].as_str().unwrap().to_owned())
        .collect()
}

fn subscribed() -> (Client, Value, Value) {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    let params = root(&client, json!({}));
    let id = client.request("xacro/preview/subscribe", params)["id"].clone();
    let first = model(&mut client, &id);
    (client, id, first)
}

#[test]
fn subscribing_gives_the_robot() {
    let (_client, _, first) = subscribed();
    assert_eq!(first["ok"], true, "{first}");
    assert_eq!(
        names(&first["model"]["links"]),
        ["desk", "pan_body", "tilt_body"]
    );
    let tilt = &first["model"]["joints"][1];
    assert_eq!(tilt["type"], "revolute");
    assert_eq!(tilt["axis"], json!([0.0, 1.0, 0.0]));
    assert_eq!(tilt["pose"]["xyz"][2], 0.05);
    assert_eq!(tilt["limit"]["upper"], 1.57);
    assert_eq!(first["args"], json!([{ "name": "mount", "value": "desk" }]));
    let mass = &first["model"]["links"][1]["inertial"]["mass"];
    assert_eq!(mass.as_f64(), Some(0.3));
}

#[test]
fn arguments_come_in_the_order_of_their_declarations() {
    let (mut client, id, _) = subscribed();
    client.edit(
        ROBOT,
        "<xacro:arg name=\"mount\" default=\"desk\"/>",
        "<xacro:arg name=\"zoom\" default=\"1\"/><xacro:arg name=\"mount\" default=\"desk\"/><xacro:arg name=\"axis\" default=\"x\"/>",
    );
    let next = model(&mut client, &id);
    assert_eq!(names(&next["args"]), ["zoom", "mount", "axis"]);
}

#[test]
fn an_edit_of_an_included_file_gives_the_next_revision() {
    let (mut client, id, first) = subscribed();
    client.edit(UNIT, "1.57\" effort", "1.2\" effort");
    let next = model(&mut client, &id);
    assert!(next["revision"].as_u64() > first["revision"].as_u64());
    assert_eq!(next["model"]["joints"][0]["limit"]["upper"], 1.2);
}

#[test]
fn broken_text_keeps_the_last_good_robot() {
    let (mut client, id, first) = subscribed();
    client.edit(ROBOT, "</robot>", "<");
    let broken = model_with(&mut client, &id, |model| model["ok"] == false);
    assert!(broken["model"].is_null());
    assert!(names(&broken["lastGood"]["links"]).contains(&"tilt_body".to_owned()));
    assert_eq!(broken["goodRevision"], first["revision"]);
    let error = &broken["errors"][0];
    assert_eq!(error["location"]["uri"], client.uri(ROBOT));
    client.edit(
        ROBOT,
        "axis=\"0 1 0\"><origin xyz=\"0 0 ${m0 / 3}\"/></xacro:unit>\n<",
        "axis=\"1 0 0\"><origin xyz=\"0 0 0\"/></xacro:unit></robot>",
    );
    let fixed = model_with(&mut client, &id, |model| model["ok"] == true);
    assert_eq!(fixed["model"]["joints"][1]["axis"], json!([1.0, 0.0, 0.0]));
    assert!(fixed["lastGood"].is_null() && fixed["errors"] == json!([]));
}

#[test]
fn a_robot_that_was_never_good_shows_what_could_be_made() {
    let mut client = Client::start();
    let text = super::workspace::ROBOT_TEXT.replace("${m0 / 3}", "${m9 / 3}");
    client.open_with(ROBOT, &text);
    let params = root(&client, json!({}));
    let id = client.request("xacro/preview/subscribe", params)["id"].clone();
    let first = model(&mut client, &id);
    assert_eq!(first["ok"], false);
    assert_eq!(first["errors"][0]["code"], "undefined-property");
    assert_eq!(
        names(&first["model"]["links"]),
        ["desk", "pan_body", "tilt_body"]
    );
}

#[test]
fn other_arguments_and_a_second_robot_beside_the_first() {
    let (mut client, id, _) = subscribed();
    let main = json!({ "uri": client.uri(ROBOT), "args": { "mount": "wall" } });
    let beside = json!({ "uri": client.uri(ROBOT) });
    client.request(
        "xacro/preview/setRoot",
        json!({ "id": id, "root": main, "compare": beside }),
    );
    let (a, b) = (model(&mut client, &id), model(&mut client, &id));
    assert_eq!(
        (a["side"].as_str(), b["side"].as_str()),
        (Some("main"), Some("compare"))
    );
    assert_eq!(a["model"]["links"][0]["name"], "wall");
    assert_eq!(b["model"]["links"][0]["name"], "desk");
    assert!(a["revision"].as_u64() < b["revision"].as_u64());
}

fn selection(client: &mut Client) -> Value {
    let next = |client: &mut Client| {
        let at = client
            .notes
            .iter()
            .position(|note| note["method"] == "xacro/preview/select")?;
        Some(client.notes.remove(at)["params"].clone())
    };
    client.wait(next, || "selection".to_owned())
}

fn select_at(client: &mut Client, id: &Value, file: &str, pattern: &str) -> Value {
    let at = client.at(file, pattern);
    let range = json!({ "start": at["position"], "end": at["position"] });
    let location = json!({ "uri": at["textDocument"]["uri"], "range": range });
    client.notify(
        "xacro/preview/select",
        json!({ "id": id, "location": location }),
    );
    selection(client)
}

#[test]
fn the_cursor_selects_what_the_text_makes() {
    let (mut client, id, _) = subscribed();
    let in_macro = select_at(&mut client, &id, UNIT, "<mass val|ue");
    assert_eq!(in_macro["links"], json!(["pan_body", "tilt_body"]));
    assert_eq!(in_macro["joints"], json!([]));
    let joint = select_at(&mut client, &id, UNIT, "<axis| xyz");
    assert_eq!(joint["joints"], json!(["pan", "tilt"]));
    let call = select_at(&mut client, &id, ROBOT, "<xacro:unit na|me=\"tilt\"");
    assert_eq!(
        (&call["links"], &call["joints"]),
        (&json!(["tilt_body"]), &json!(["tilt"]))
    );
    let nothing = select_at(&mut client, &id, ROBOT, "<xacro:prop|erty");
    assert_eq!(nothing["links"], json!([]));
}

#[test]
fn the_cursor_counts_in_utf_16_and_in_unsaved_text() {
    let (mut client, id, _) = subscribed();
    client.edit(ROBOT, "<link name", "<!-- 🤖 --><link name");
    model(&mut client, &id);
    let found = select_at(&mut client, &id, ROBOT, "<!-- 🤖 --><li|nk");
    assert_eq!(found["links"], json!(["desk"]));
}

#[test]
fn a_link_leads_to_its_source() {
    let (mut client, id, _) = subscribed();
    client.notify(
        "xacro/preview/select",
        json!({ "id": id, "link": "tilt_body" }),
    );
    let found = selection(&mut client);
    let place = client.shown(
        found["location"]["uri"].as_str().unwrap(),
        &found["location"]["range"],
    );
    assert_eq!(place, "unit.xacro:4 <link");
}

#[test]
fn meshes_are_named_by_ids_that_change_with_the_file() {
    let (mut client, id, _) = subscribed();
    let file = client.folder.join("src/pan_tilt/meshes/head.stl");
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    std::fs::write(&file, "solid a\nendsolid a\n").unwrap();
    let mesh = |name: &str| {
        format!(
            "<visual><geometry><mesh filename=\"package://pan_tilt/meshes/{name}\"/></geometry></visual><inertial>"
        )
    };
    client.edit(UNIT, "<inertial>", &mesh("head.stl"));
    let shown = model(&mut client, &id);
    let shape = &shown["model"]["links"][1]["visuals"][0]["shape"];
    let name = shape["mesh"].as_str().unwrap().to_owned();
    assert_eq!(shown["model"]["meshes"][&name]["format"], "stl");
    let bytes = client.request("xacro/preview/mesh", json!({ "id": id, "mesh": name }));
    assert_eq!(bytes["data"], "c29saWQgYQplbmRzb2xpZCBhCg==");
    client.edit(UNIT, "head.stl", "heat.stl");
    let missing = model(&mut client, &id);
    let shape = &missing["model"]["links"][1]["visuals"][0]["shape"];
    assert!(
        shape["problem"].as_str().unwrap().contains("heat.stl"),
        "{shape}"
    );
    let path = json!({ "id": id, "mesh": "../package.xml" });
    let asked = client.post("xacro/preview/mesh", path);
    assert!(
        client.reply(asked)["error"]["message"]
            .as_str()
            .unwrap()
            .contains("no open preview")
    );
}

#[test]
fn nothing_is_sent_after_unsubscribing() {
    let (mut client, id, _) = subscribed();
    let urdf = client.request("xacro/preview/urdf", json!({ "id": id }));
    let text = urdf["urdf"].as_str().unwrap_or_default();
    assert!(
        text.contains("<robot") && !text.contains("xacro:"),
        "{text}"
    );
    client.request("xacro/preview/unsubscribe", json!({ "id": id }));
    client.edit(ROBOT, "0.15", "0.25");
    client.diagnostics(ROBOT);
    assert!(
        client
            .notes
            .iter()
            .all(|note| note["method"] != "xacro/preview/model")
    );
    let again = client.post("xacro/preview/unsubscribe", json!({ "id": id }));
    assert!(client.reply(again)["error"].is_object());
}

#[test]
fn the_command_answers_the_address_of_a_page() {
    let mut client = Client::with(super::workspace::pan_tilt(), Options::default());
    client.open(UNIT);
    let argument = client.of(UNIT);
    let params = json!({ "command": "xacro.preview", "arguments": [argument] });
    let first = client.request("workspace/executeCommand", params.clone());
    let url = first["url"].as_str().unwrap();
    assert!(
        url.starts_with("http://127.0.0.1:") && url.contains("/#token="),
        "{url}"
    );
    let second = client.request("workspace/executeCommand", params);
    assert_eq!(first, second);
}
