//! The limits of the server, reached; see `tests/limits.rs`.

use serde_json::{Value, json};
use xacro_lsp::base::limits::*;

use super::client::{Client, Options};
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, fresh_folder, write};

fn robot(body: &str) -> String {
    format!("<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{body}\n</robot>\n")
}

/// A server that shows one robot with this body.
fn showing(body: &str) -> Client {
    let folder = fresh_folder();
    write(&folder, "r.urdf.xacro", robot(body));
    let mut client = Client::with(folder, Options::default());
    client.open("r.urdf.xacro");
    client
}

#[test]
fn diagnostics() {
    let links: String = (0..DIAGNOSTICS + 100)
        .map(|n| format!("<link name=\"${{gone{n}}}\"/>\n"))
        .collect();
    let found = showing(&links).diagnostics("r.urdf.xacro");
    assert_eq!(found.len(), DIAGNOSTICS + 1);
    let last = found.last().unwrap()["message"].as_str().unwrap();
    assert!(last.contains("100"), "{last}");
}

#[test]
fn log_lines() {
    let mut client = showing("<link name='a'/>");
    for _ in 0..LOG_LINES {
        client.edit("r.urdf.xacro", "</robot>", " </robot>");
        client.diagnostics("r.urdf.xacro");
    }
    assert_eq!(
        client
            .request("xacro/log", Value::Null)
            .as_array()
            .unwrap()
            .len(),
        LOG_LINES
    );
}

#[test]
fn related() {
    let calls: String = (0..RELATED * 2)
        .map(|n| format!("<xacro:m n=\"{n}\"/>\n"))
        .collect();
    let body = format!(
        "<xacro:macro name=\"m\" params=\"n\"><link name=\"${{gone}}${{n}}\"/></xacro:macro>\n{calls}"
    );
    let found = showing(&body).diagnostics("r.urdf.xacro");
    let most = found
        .iter()
        .filter_map(|one| one["relatedInformation"].as_array())
        .map(Vec::len)
        .max();
    assert!(
        most.is_some_and(|most| most > 0 && most <= RELATED),
        "{most:?}"
    );
}

#[test]
fn symbols() {
    let links: String = (0..SYMBOLS + 50)
        .map(|n| format!("<link name=\"l{n}\"/>\n"))
        .collect();
    let mut client = showing(&links);
    let found = client.request("textDocument/documentSymbol", client.of("r.urdf.xacro"));
    let top = found.as_array().unwrap();
    let count = if top.len() == 1 {
        top[0]["children"].as_array().unwrap().len()
    } else {
        top.len()
    };
    assert_eq!(count, SYMBOLS);
}

/// The deepest nesting of objects under `key`.
fn depth(mut level: Vec<&Value>, key: &str) -> usize {
    let mut depth = 0;
    while !level.is_empty() {
        depth += 1;
        let inner = level.iter().filter_map(|value| value.get(key));
        level = inner
            .flat_map(|value| {
                value
                    .as_array()
                    .map_or(vec![value], |list| list.iter().collect())
            })
            .collect();
    }
    depth
}

#[test]
fn symbol_depth() {
    let count = 6000;
    let body = format!(
        "{}{}",
        "<xacro:macro name=\"a\">".repeat(count),
        "</xacro:macro>".repeat(count)
    );
    let mut client = showing(&body);
    let found = client.request("textDocument/documentSymbol", client.of("r.urdf.xacro"));
    let levels = depth(found.as_array().unwrap().iter().collect(), "children");
    assert!(
        (SYMBOL_DEPTH..SYMBOL_DEPTH + 3).contains(&levels),
        "{levels}"
    );
}

#[test]
fn selections() {
    let count = 6000;
    let mut client = showing(&format!("{}x{}", "<a>".repeat(count), "</a>".repeat(count)));
    let place = client.at("r.urdf.xacro", "<a>x|");
    let params = json!({ "textDocument": place["textDocument"], "positions": [place["position"]] });
    let found = client.request("textDocument/selectionRange", params);
    assert_eq!(depth(vec![&found[0]], "parent"), SELECTIONS);
}

#[test]
fn workspace_symbols() {
    let links: String = (0..WORKSPACE_SYMBOLS + 50)
        .map(|n| format!("<link name=\"wheel{n}\"/>\n"))
        .collect();
    let mut client = showing(&links);
    assert!(client.eventually(|client| {
        let found = client.request("workspace/symbol", json!({ "query": "wheel" }));
        found
            .as_array()
            .is_some_and(|found| found.len() == WORKSPACE_SYMBOLS)
    }));
}

#[test]
fn completions() {
    let many: String = (0..COMPLETIONS + 100)
        .map(|n| format!("<xacro:property name=\"value_{n}\" value=\"{n}\"/>"))
        .collect();
    let mut client = showing(&format!("{many}<link name=\"${{value_}}\"/>"));
    let answer = client.request(
        "textDocument/completion",
        client.at("r.urdf.xacro", "${value_|"),
    );
    assert_eq!(answer["isIncomplete"], true);
    assert_eq!(answer["items"].as_array().unwrap().len(), COMPLETIONS);
}

#[test]
fn rename_robots() {
    let folder = fresh_folder();
    write(
        &folder,
        "part.xacro",
        robot("<xacro:macro name=\"part\" params=\"n\"><link name=\"${n}\"/></xacro:macro>"),
    );
    let uses = robot("<xacro:include filename=\"part.xacro\"/>\n<xacro:part n=\"a\"/>");
    for n in 0..RENAME_ROBOTS + 10 {
        write(&folder, &format!("r{n}.urdf.xacro"), &uses);
    }
    let mut client = Client::with(folder, Options::default());
    client.open("part.xacro");
    let mut params = client.at("part.xacro", "name=\"pa|rt\"");
    params["newName"] = json!("piece");
    assert!(client.eventually(|client| {
        let edit = client.request("textDocument/rename", params.clone());
        let files = edit["changes"].as_object().map_or(0, serde_json::Map::len);
        assert!(files <= RENAME_ROBOTS + 2, "{files}");
        files >= RENAME_ROBOTS
    }));
}

#[test]
fn name_letters() {
    let mut client = Client::start();
    client.open(ROBOT);
    let mut params = client.at(ROBOT, "name=\"m|0\"");
    params["newName"] = json!("n".repeat(NAME_LETTERS + 1));
    let id = client.post("textDocument/rename", params);
    let message = client.reply(id)["error"]["message"]
        .as_str()
        .unwrap()
        .to_owned();
    assert!(message.contains("limited to 200 characters"), "{message}");
}

fn subscribe(client: &mut Client) -> Value {
    let params = json!({ "root": { "uri": client.uri(ROBOT), "args": {} } });
    let id = client.post("xacro/preview/subscribe", params);
    client.reply(id)
}

/// The next model.
fn model(client: &mut Client) -> Value {
    let next = |client: &mut Client| {
        let at = client
            .notes
            .iter()
            .position(|note| note["method"] == "xacro/preview/model")?;
        Some(client.notes.remove(at)["params"].clone())
    };
    client.wait(next, || "model".to_owned())
}

#[test]
fn views() {
    let mut client = Client::start();
    client.open(ROBOT);
    for _ in 0..VIEWS {
        assert!(subscribe(&mut client)["error"].is_null());
    }
    let message = subscribe(&mut client)["error"]["message"]
        .as_str()
        .unwrap()
        .to_owned();
    assert!(
        message.contains("the limit of 32 open previews is reached: close one first"),
        "{message}"
    );
}

#[test]
fn sent_bytes() {
    let mut client = Client::start();
    write(&client.folder, "src/pan_tilt/meshes/a.stl", "");
    let mesh = client.folder.join("src/pan_tilt/meshes/a.stl");
    std::fs::File::options()
        .write(true)
        .open(mesh)
        .unwrap()
        .set_len(SENT_BYTES + 1)
        .unwrap();
    let visual = "<link name=\"seen\"><visual><geometry><mesh filename=\"package://pan_tilt/meshes/a.stl\"/></geometry>\
                  </visual></link></robot>";
    client.open_with(ROBOT, &ROBOT_TEXT.replace("</robot>", visual));
    client.open(UNIT);
    subscribe(&mut client);
    let shown = model(&mut client);
    let mesh = shown["model"]["meshes"]
        .as_object()
        .unwrap()
        .keys()
        .next()
        .unwrap_or_else(|| panic!("{shown}"));
    let id = client.post("xacro/preview/mesh", json!({ "mesh": mesh }));
    let reply = client.reply(id);
    let message = reply["error"]["message"]
        .as_str()
        .unwrap_or_else(|| panic!("{reply} for {shown}"));
    assert!(
        message.contains("it has more than 256 MB, the limit"),
        "{message}"
    );
}

#[test]
fn sent_errors() {
    let mut client = Client::start();
    let links: String = (0..SENT_ERRORS + 50)
        .map(|n| format!("<link name=\"${{gone{n}}}\"/>\n"))
        .collect();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace("</robot>", &format!("{links}</robot>")),
    );
    subscribe(&mut client);
    assert_eq!(
        model(&mut client)["errors"].as_array().unwrap().len(),
        SENT_ERRORS
    );
}

#[test]
fn rewritten_mesh_bytes() {
    let mut client = Client::start();
    let file = "src/pan_tilt/meshes/a.stl";
    write(&client.folder, file, "solid");
    let mesh = client.folder.join(file);
    std::fs::File::options()
        .write(true)
        .open(mesh)
        .unwrap()
        .set_len(REWRITTEN_MESH_BYTES + 1)
        .unwrap();
    let arguments = json!([{ "uri": client.uri(file) }]);
    let id = client.post(
        "workspace/executeCommand",
        json!({ "command": "xacro.rewriteMesh", "arguments": arguments }),
    );
    let reply = client.reply(id);
    let message = reply["error"]["message"]
        .as_str()
        .unwrap_or_else(|| panic!("{reply}"));
    assert!(
        message.contains("it has more than 104 MB, the limit"),
        "{message}"
    );
}
