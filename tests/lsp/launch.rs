//! Launch files: calls in the root picker, names of arguments, findings.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::offset;
use super::workspace::{ROBOT, pan_tilt, write};

const LAUNCH: &str = "src/pan_tilt/launch/camera.launch.py";
const OLD: &str = "src/pan_tilt/launch/camera.launch";

const PYTHON: &str = "\
import xacro
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.substitutions import FindPackageShare

mount = DeclareLaunchArgument('mount', default_value='wall')
path = [FindPackageShare('pan_tilt'), '/urdf/pan_tilt.urdf.xacro']
robot = Command(['xacro ', *path, ' mount:=', LaunchConfiguration('mount')])
again = Command(['xacro ', *path, ' mount:=ceiling'])
";

const XML: &str = "<launch>
  <param name=\"robot_description\" command=\"$(find xacro)/xacro $(find pan_tilt)/urdf/pan_tilt.urdf.xacro mount:=pole\"/>
</launch>
";

/// A client with a robot and the launch files that call it open.
fn started() -> Client {
    let folder = pan_tilt();
    write(&folder, LAUNCH, PYTHON);
    write(&folder, OLD, XML);
    let mut client = Client::with(folder, Options::default());
    [ROBOT, LAUNCH, OLD]
        .iter()
        .for_each(|file| client.open(file));
    client
}

/// File name and text of each place of an answer, in order.
fn places(client: &Client, answer: &Value) -> Vec<String> {
    let list = answer.as_array().cloned().unwrap_or_default();
    let place = |place: &Value| {
        let uri = place
            .get("targetUri")
            .or_else(|| place.get("uri"))
            .unwrap()
            .as_str()
            .unwrap();
        let range = place
            .get("targetSelectionRange")
            .or_else(|| place.get("range"))
            .unwrap();
        let file = [ROBOT, LAUNCH, OLD]
            .into_iter()
            .find(|file| client.uri(file) == uri)
            .unwrap();
        let text = client.text(file);
        let (start, end) = (offset(text, &range["start"]), offset(text, &range["end"]));
        format!(
            "{}:{} {}",
            file.rsplit('/').next().unwrap(),
            range["start"]["line"],
            &text[start..end]
        )
    };
    let mut places: Vec<String> = list.iter().map(place).collect();
    places.sort();
    places
}

#[test]
fn calls_are_offered_as_roots() {
    let mut client = started();
    let answer = client.request("xacro/roots", client.of(ROBOT));
    let shown = |root: &Value| format!("{} {}", root["preset"], root["args"]);
    let found: Vec<String> = answer["candidates"]
        .as_array()
        .unwrap()
        .iter()
        .map(shown)
        .collect();
    assert_eq!(
        found,
        [
            "null null",
            "\"camera.launch\" {\"mount\":\"pole\"}",
            "\"camera.launch.py\" {\"mount\":\"wall\"}",
            "\"camera.launch.py (2)\" {\"mount\":\"ceiling\"}",
        ]
    );
    assert!(answer["active"]["preset"].is_null(), "{answer}");
    let mut params = client.of(ROBOT);
    params["root"] = answer["candidates"][3].clone();
    client.request("xacro/setRoot", params);
    let answer = client.request("xacro/roots", client.of(ROBOT));
    assert_eq!(answer["args"][0]["value"], "ceiling");
}

#[test]
fn names_of_arguments_lead_to_the_robot() {
    let mut client = started();
    for (file, at) in [
        (LAUNCH, "' mo|unt:='"),
        (LAUNCH, "' mo|unt:=ceiling"),
        (OLD, "mo|unt:=pole"),
    ] {
        let params = client.at(file, at);
        let found = client.request("textDocument/definition", params.clone());
        assert_eq!(
            places(&client, &found),
            ["pan_tilt.urdf.xacro:1 mount"],
            "{at}"
        );
        let hover = client.request("textDocument/hover", params);
        assert!(
            hover["contents"]["value"]
                .as_str()
                .unwrap()
                .contains("desk"),
            "{hover}"
        );
        assert_eq!(hover["range"]["end"]["character"].as_u64().unwrap(), {
            let start = hover["range"]["start"]["character"].as_u64().unwrap();
            start + 5
        });
    }
    // the argument of the launch file is another one
    for at in [
        "DeclareLaunchArgument('mo|unt'",
        "LaunchConfiguration('mo|unt'",
        "import xa|cro",
    ] {
        let params = client.at(LAUNCH, at);
        for method in ["definition", "hover"] {
            let answer = client.request(&format!("textDocument/{method}"), params.clone());
            assert_eq!(answer, Value::Null, "{method} {at}");
        }
    }
}

#[test]
fn references_and_rename_go_through_launch_files() {
    let mut client = started();
    let everywhere = [
        "camera.launch.py:7 mount",
        "camera.launch.py:8 mount",
        "camera.launch:1 mount",
        "pan_tilt.urdf.xacro:1 mount",
        "pan_tilt.urdf.xacro:5 mount",
        "pan_tilt.urdf.xacro:6 mount",
    ];
    for (file, at) in [
        (ROBOT, "name=\"mo|unt\""),
        (ROBOT, "$(arg mo|unt)\"/>"),
        (LAUNCH, "' mo|unt:='"),
    ] {
        let mut params = client.at(file, at);
        params["context"] = json!({ "includeDeclaration": true });
        let found = client.request("textDocument/references", params);
        assert_eq!(places(&client, &found), everywhere, "{file} {at}");
        let mut params = client.at(file, at);
        let prepared = client.request("textDocument/prepareRename", params.clone());
        assert_eq!(prepared["placeholder"], "mount", "{prepared}");
        params["newName"] = json!("holder");
        let edit = client.request("textDocument/rename", params);
        let python = client.after(LAUNCH, &edit);
        let expected = PYTHON.replace(" mount:=", " holder:=");
        assert_eq!(python, expected);
        assert_eq!(client.after(OLD, &edit), XML.replace("mount:=", "holder:="));
    }
}

#[test]
fn an_argument_is_renamed_again() {
    let mut client = started();
    client.edit(LAUNCH, " mount:=', Launch", " holder:=', Launch");
    client.edit(LAUNCH, " mount:=ceiling", " holder:=ceiling");
    client.edit(OLD, "mount:=pole", "holder:=pole");
    client.edit(ROBOT, "name=\"mount\"", "name=\"holder\"");
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"",
        "<link name=\"$(arg holder)\"",
    );
    client.edit(ROBOT, "parent=\"$(arg mount)\"", "parent=\"$(arg holder)\"");
    let mut params = client.at(LAUNCH, "' hol|der:=ceiling'");
    let prepared = client.request("textDocument/prepareRename", params.clone());
    assert_eq!(prepared["placeholder"], "holder", "{prepared}");
    params["newName"] = json!("place");
    let edit = client.request("textDocument/rename", params);
    assert_eq!(client.after(OLD, &edit), XML.replace("mount:=", "place:="));
}

#[test]
fn a_launch_file_that_gives_the_name_to_another_robot_forbids_a_rename() {
    let folder = pan_tilt();
    let other = "<robot name=\"o\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:arg name=\"mount\" default=\"\"/>\
                 <link name=\"$(arg mount)l\"/></robot>";
    write(&folder, "src/pan_tilt/urdf/other.urdf.xacro", other);
    let inner = "<launch><arg name=\"model\" default=\"pan_tilt\"/>\
                 <param name=\"r\" command=\"xacro $(find pan_tilt)/urdf/$(arg model).urdf.xacro mount:=a\"/></launch>";
    write(&folder, OLD, inner);
    write(
        &folder,
        "src/pan_tilt/launch/other.launch",
        "<launch><include file=\"$(find pan_tilt)/launch/camera.launch\"><arg name=\"model\" value=\"other\"/></include></launch>",
    );
    let mut client = Client::with(folder, Options::default());
    client.open(ROBOT);
    let mut params = client.at(ROBOT, "name=\"mo|unt\"");
    params["newName"] = json!("holder");
    let id = client.post("textDocument/rename", params);
    let reply = client.reply(id);
    let message = reply["error"]["message"].as_str().unwrap();
    assert_eq!(
        message,
        "`camera.launch` passes `mount` to `other.urdf.xacro` as well"
    );
}

#[test]
fn arguments_are_completed_in_launch_files() {
    let mut client = started();
    client.edit(LAUNCH, "' mount:=ceiling'", "' mount:=ceiling m'");
    client.edit(OLD, "mount:=pole", "mount:=pole m");
    for (file, at, expected) in [
        (LAUNCH, "mount:=ceiling m|", Some("mount:=")),
        (OLD, "mount:=pole m|", Some("mount:=")),
        (LAUNCH, "' mo|unt:='", Some("mount")),
        (LAUNCH, "LaunchConfiguration('mo|", None),
        (LAUNCH, "import xa|", None),
    ] {
        let answer = client.request("textDocument/completion", client.at(file, at));
        let text = answer["items"].as_array().map(|items| {
            assert_eq!(items.len(), 1, "{answer}");
            assert_eq!(items[0]["detail"], "default: `desk`");
            items[0]["textEdit"]["newText"].as_str().unwrap().to_owned()
        });
        assert_eq!(text.as_deref(), expected, "{at}");
    }
}

#[test]
fn findings_about_calls_are_shown_with_the_robot() {
    let mut client = started();
    assert_eq!(client.findings(LAUNCH), Vec::<String>::new());
    client.edit(LAUNCH, "' mount:=ceiling'", "' mont:=ceiling'");
    assert_eq!(client.findings(LAUNCH), ["9:36-40 unknown-launch-argument"]);
    client.edit(LAUNCH, "' mont:=ceiling'", "' mount:=ceiling'");
    assert_eq!(client.findings(LAUNCH), Vec::<String>::new());
}

#[test]
fn findings_about_calls_need_one_of_both_files_open() {
    let folder = pan_tilt();
    write(&folder, OLD, XML.replace("mount", "mont"));
    let expected = ["2:105-109 unknown-launch-argument"];
    let mut client = Client::with(folder.clone(), Options::default());
    client.open(ROBOT);
    assert_eq!(client.findings(ROBOT), Vec::<String>::new());
    assert_eq!(client.findings_of_closed(OLD), expected);
    let mut client = Client::with(folder, Options::default());
    client.open(OLD);
    assert_eq!(client.findings(OLD), expected);
}
