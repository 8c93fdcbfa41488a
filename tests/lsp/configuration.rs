//! Completion and hover in `xacro-lint.toml`.

use serde_json::Value;

use super::client::{Client, Options};
use super::workspace::{ROBOT, pan_tilt, write};

const CONFIG: &str = "xacro-lint.toml";
const LAUNCH: &str = "src/pan_tilt/launch/camera.launch";

/// An argument with conditions, beside `mount`.
const SIDE: &str = "<xacro:arg name=\"side\" default=\"left\"/>\n  <xacro:if value=\"${'$(arg side)' == 'right'}\"><link name=\"cover\"/></xacro:if>\n  \
                    <xacro:arg name=\"sim\" default=\"false\"/>\n  <xacro:arg name=\"note\" default=\"$(arg sim)\"/>\n  <link name=\"$(arg mount)\"/>";

/// A client with a configuration; `|` marks nothing yet.
fn started(text: &str) -> Client {
    let folder = pan_tilt();
    let robot = std::fs::read_to_string(folder.join(ROBOT)).unwrap();
    write(
        &folder,
        ROBOT,
        robot.replace("<link name=\"$(arg mount)\"/>", SIDE),
    );
    let command = "xacro $(find pan_tilt)/urdf/pan_tilt.urdf.xacro mount:=pole";
    write(
        &folder,
        LAUNCH,
        format!("<launch><param name=\"robot_description\" command=\"{command}\"/></launch>\n"),
    );
    write(&folder, CONFIG, "");
    let mut client = Client::with(folder, Options::default());
    client.open(ROBOT);
    client.open_with(CONFIG, text);
    client
}

/// What is offered at `|`, and the text that is written for the first one.
fn offered(text: &str) -> (Vec<String>, String) {
    let mut client = started(&text.replace('|', ""));
    let mut params = client.of(CONFIG);
    let before = text.split('|').next().unwrap();
    let line = before.matches('\n').count();
    let character = before.rsplit('\n').next().unwrap().len();
    params["position"] = serde_json::json!({ "line": line, "character": character });
    let answer = client.request("textDocument/completion", params);
    let items = answer["items"].as_array().cloned().unwrap_or_default();
    let label = |item: &Value| item["label"].as_str().unwrap().to_owned();
    let first = items
        .first()
        .map(|item| item["textEdit"]["newText"].as_str().unwrap().to_owned());
    (items.iter().map(label).collect(), first.unwrap_or_default())
}

#[track_caller]
fn check(text: &str, labels: &[&str], first: &str) {
    let (found, written) = offered(text);
    assert_eq!(
        (
            found.iter().map(String::as_str).collect::<Vec<_>>(),
            written.as_str()
        ),
        (labels.to_vec(), first),
        "{text}"
    );
}

const ROOT: &str = "[[roots]]\nfile = \"src/pan_tilt/urdf/pan_tilt.urdf.xacro\"\n";

#[test]
fn keys() {
    check(
        "[for|",
        &[
            "severity",
            "per-file-ignores",
            "thresholds",
            "roots",
            "format",
            "limits",
        ],
        "severity",
    );
    check(
        "[format]\nline|",
        &["line-width", "attributes", "self-close"],
        "line-width = ",
    );
    check(
        "[[roots]]\n|",
        &["file", "args", "exclude", "choices", "presets", "expect"],
        "file = ",
    );
    check("target = |\n", &["ros2", "ros1"], "\"ros2\"");
    check("target = \"r|\"\n", &["ros2", "ros1"], "ros2");
    check("use-environment = |\n", &["true", "false"], "true");
    let (rules, first) = offered("[severity]\n|");
    assert!(
        rules.contains(&"undefined-link".to_owned()) && first.ends_with(" = "),
        "{rules:?}"
    );
    check("# |", &[], "");
    check("target = \"ros1\" |", &[], "");
}

#[test]
fn arguments_of_the_robot() {
    let names = ["mount", "side", "sim", "note"];
    check(&format!("{ROOT}args = {{ | }}"), &names, "mount = ");
    check(&format!("{ROOT}args = {{ m| = 1 }}"), &names, "mount");
    check(&format!("{ROOT}args = {{ \"m|"), &names, "mount\" = ");
    check(
        &format!("{ROOT}exclude = [{{ side = \"left\", |"),
        &names,
        "mount = ",
    );
    check(&format!("{ROOT}presets.real = {{ |"), &names, "mount = ");
    check(
        &format!("{ROOT}[[roots.expect]]\nwhen = {{ |"),
        &names,
        "mount = ",
    );
    check(
        "[[roots]]\nargs = { | }\nfile = \"src/pan_tilt/urdf/pan_tilt.urdf.xacro\"\n",
        &names,
        "mount = ",
    );
    check("[[roots]]\nargs = { | }\n", &[], "");
}

#[test]
fn values_of_arguments() {
    check(
        &format!("{ROOT}args = {{ mount = |"),
        &["desk", "pole"],
        "\"desk\"",
    );
    check(
        &format!("{ROOT}args = {{ side = [\"left\", \"|"),
        &["left", "right"],
        "left\"",
    );
    check(
        &format!("{ROOT}args = {{ sim = | }}"),
        &["false", "true"],
        "false",
    );
    check(&format!("{ROOT}args = {{ note = | }}"), &[], "");
    check(&format!("{ROOT}choices = |"), &["launch"], "\"launch\"");
}

#[test]
fn paths_links_and_joints() {
    check("[[roots]]\nfile = \"|\"", &["src/"], "src/");
    check(
        "[[roots]]\nfile = \"src/pan_tilt/urdf/|\"",
        &[
            "src/pan_tilt/urdf/pan_tilt.urdf.xacro",
            "src/pan_tilt/urdf/unit.xacro",
        ],
        ROBOT,
    );
    check(
        &format!("{ROOT}[[roots.expect]]\nroot = |"),
        &["desk", "pan_body", "tilt_body"],
        "\"desk\"",
    );
    check(
        &format!("{ROOT}[[roots.expect]]\njoints = [\"|\"]"),
        &["pan", "tilt"],
        "pan",
    );
    check(
        &format!("{ROOT}[[roots.expect]]\nchains = [[\"desk\", \"|\"]]"),
        &["desk", "pan_body", "tilt_body"],
        "desk",
    );
    check(
        &format!("{ROOT}[[roots.expect]]\njoint.|"),
        &["pan", "tilt"],
        "pan = ",
    );
}

#[test]
fn keys_are_explained_and_nothing_else_is_answered() {
    let mut client = started(&format!("{ROOT}args = {{ side = \"left\" }}\n"));
    let params = client.at(CONFIG, "ar|gs");
    let hover = client.request("textDocument/hover", params.clone());
    assert!(
        hover["contents"]["value"]
            .as_str()
            .unwrap()
            .starts_with("Arguments by name"),
        "{hover}"
    );
    for method in [
        "definition",
        "declaration",
        "typeDefinition",
        "documentHighlight",
        "documentSymbol",
        "foldingRange",
    ] {
        let answer = client.request(&format!("textDocument/{method}"), params.clone());
        assert_eq!(answer, Value::Null, "{method}");
    }
    assert_eq!(
        client.request("textDocument/hover", client.at(CONFIG, "\"le|ft")),
        Value::Null
    );
    assert_eq!(client.findings(CONFIG), Vec::<String>::new());
}
