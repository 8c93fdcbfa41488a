//! F11: renaming in all files that use a name.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::replace_all;
use super::workspace::{ROBOT, UNIT, pan_tilt};

/// The files after renaming what `at` marks; or the message of the error.
fn renamed(
    client: &mut Client,
    file: &str,
    at: &str,
    new: &str,
) -> Result<BTreeMap<String, String>, String> {
    let mut files = BTreeMap::new();
    for (uri, edits) in client.changes_of_rename(file, at, new)? {
        let name = [ROBOT, UNIT]
            .into_iter()
            .find(|name| client.uri(name) == uri)
            .unwrap();
        let mut text = client.text(name).to_owned();
        replace_all(&mut text, &edits, new);
        files.insert(name.to_owned(), text);
    }
    Ok(files)
}

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

#[test]
fn a_parameter_is_renamed_in_its_macro_and_in_all_calls() {
    let mut client = both();
    let files = renamed(&mut client, UNIT, "${ax|is}", "direction").unwrap();
    assert!(
        files[UNIT].contains("name parent direction:='0 0 1' *at"),
        "{}",
        files[UNIT]
    );
    assert!(
        files[UNIT].contains("<axis xyz=\"${direction}\"/>"),
        "{}",
        files[UNIT]
    );
    assert!(
        files[ROBOT].contains("direction=\"0 1 0\""),
        "{}",
        files[ROBOT]
    );
}

#[test]
fn a_macro_is_renamed_with_its_end_tags() {
    let mut client = both();
    let files = renamed(&mut client, ROBOT, "<xacro:un|it name=\"pan\"", "motor").unwrap();
    assert!(
        files[UNIT].contains("<xacro:macro name=\"motor\""),
        "{}",
        files[UNIT]
    );
    assert_eq!(
        files[ROBOT].matches("xacro:motor").count(),
        4,
        "{}",
        files[ROBOT]
    );
}

#[test]
fn a_property_is_renamed_in_branches_that_are_not_taken_too() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<!-- 🤖 --><xacro:if value=\"false\"><link name=\"${m0}\"/></xacro:if></robot>",
    );
    let files = renamed(&mut client, ROBOT, "name=\"m|0\"", "mass").unwrap();
    assert_eq!(
        files[ROBOT].matches("${mass").count(),
        2,
        "{}",
        files[ROBOT]
    );
    assert_eq!(
        files[UNIT].matches("${mass * 2}").count(),
        1,
        "{}",
        files[UNIT]
    );
}

#[test]
fn names_that_do_not_fit_are_refused() {
    let mut client = both();
    assert!(
        renamed(&mut client, ROBOT, "name=\"m|0\"", "m 0")
            .unwrap_err()
            .contains("invalid name")
    );
    assert!(
        renamed(&mut client, ROBOT, "name=\"m|0\"", "cam")
            .unwrap_err()
            .contains("already defined")
    );
    let made = renamed(&mut client, ROBOT, "parent=\"pan_b|ody\"", "x");
    assert!(made.is_err(), "{made:?}");
}

#[test]
fn names_that_would_change_the_robot_are_refused() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<!-- 🤖 --><link name=\"a${pi / 2}\"/></robot>",
    );
    for name in [
        "if",
        "unless",
        "property",
        "include",
        "macro",
        "arg",
        "insert_block",
        "call",
        "element",
    ] {
        let refused = renamed(&mut client, UNIT, "name=\"un|it\"", name).unwrap_err();
        assert_eq!(refused, format!("`xacro:{name}` is reserved by xacro"));
    }
    for name in ["1a", "a.b", "a:b", "-a", "", "a b", "<a"] {
        let refused = renamed(&mut client, UNIT, "name=\"un|it\"", name).unwrap_err();
        assert!(refused.contains("invalid name"), "{name}: {refused}");
    }
    // a parameter around a use, a name of xacro that is used
    for name in ["axis", "parent", "pi"] {
        let refused = renamed(&mut client, ROBOT, "name=\"m|0\"", name).unwrap_err();
        assert!(refused.contains("another meaning"), "{name}: {refused}");
    }
    // `at` is a block there, and `e` is not used
    for name in ["at", "e"] {
        assert!(
            renamed(&mut client, ROBOT, "name=\"m|0\"", name).is_ok(),
            "{name}"
        );
    }
    // a parameter is known in its macro only, where nobody needs `pi`
    let files = renamed(&mut client, UNIT, "${ax|is}", "pi").unwrap();
    assert!(files[ROBOT].contains("pi=\"0 1 0\""), "{}", files[ROBOT]);
}

#[test]
fn names_that_a_caller_would_capture_are_refused() {
    let mut client = both();
    let macros = "<xacro:property name=\"width\" value=\"1\"/><!-- 🤖 -->
  <xacro:macro name=\"inner\" params=\"n\"><link name=\"${n}_${width}\"/></xacro:macro>
  <xacro:macro name=\"outer\" params=\"p\"><xacro:inner n=\"${p}\"/></xacro:macro>
  <xacro:outer p=\"7\"/>\n</robot>";
    client.edit(ROBOT, "</robot>", macros);
    let refused = renamed(&mut client, ROBOT, "name=\"wid|th\"", "p").unwrap_err();
    assert!(
        refused.ends_with("another meaning where this name is used: pan_tilt.urdf.xacro:10"),
        "{refused}"
    );
    // what a call gives is named after the parameter
    let files = renamed(&mut client, ROBOT, "params=\"|n\"", "p").unwrap();
    assert!(
        files[ROBOT].contains("<xacro:inner p=\"${p}\"/>"),
        "{}",
        files[ROBOT]
    );
}

#[test]
fn what_is_no_name_is_not_renamed() {
    let mut client = both();
    assert_eq!(
        client.request("textDocument/prepareRename", client.at(UNIT, "<lim|it")),
        Value::Null
    );
    let found = client.request("textDocument/prepareRename", client.at(ROBOT, "${m|0 / 3}"));
    assert_eq!(found["placeholder"], "m0");
}

#[test]
fn edits_carry_versions_for_clients_that_take_them() {
    let capabilities = json!({ "workspace": { "workspaceEdit": { "documentChanges": true } } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    let mut params = client.at(ROBOT, "name=\"m|0\"");
    params["newName"] = json!("mass");
    let edit = client.request("textDocument/rename", params);
    let versions: Vec<&Value> = edit["documentChanges"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| &c["textDocument"]["version"])
        .collect();
    assert!(versions.contains(&&json!(1)), "{edit}");
}

/// A client that shows what edits say about themselves.
fn annotating(folder: std::path::PathBuf) -> Client {
    let capabilities = json!({ "workspace": { "workspaceEdit": {
        "documentChanges": true, "changeAnnotationSupport": {} } } });
    Client::with(
        folder,
        Options {
            capabilities,
            ..Options::default()
        },
    )
}

#[test]
fn the_part_of_a_name_that_a_macro_writes_is_renamed_in_every_name_it_makes() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<!-- 🤖 --><gazebo reference=\"tilt_body\"/></robot>",
    );
    let found = client.request(
        "textDocument/prepareRename",
        client.at(UNIT, "<link name=\"${name}_bo|dy\""),
    );
    assert_eq!(found["placeholder"], "_body");
    let files = renamed(&mut client, UNIT, "<link name=\"${name}_bo|dy\"", "_arm").unwrap();
    assert!(
        files[UNIT].contains("<link name=\"${name}_arm\">"),
        "{}",
        files[UNIT]
    );
    assert!(
        files[UNIT].contains("<child link=\"${name}_arm\"/>"),
        "{}",
        files[UNIT]
    );
    assert!(
        files[ROBOT].contains("parent=\"pan_arm\""),
        "{}",
        files[ROBOT]
    );
    assert!(
        files[ROBOT].contains("reference=\"tilt_arm\""),
        "{}",
        files[ROBOT]
    );
    // the same from a file that is included and not saved
    client.edit(UNIT, "_body", "_é");
    client.edit(UNIT, "_body", "_é");
    client.edit(ROBOT, "pan_body", "pan_é");
    client.edit(ROBOT, "tilt_body", "tilt_é");
    let files = renamed(&mut client, UNIT, "<child link=\"${name}_|é\"", "_ü").unwrap();
    assert!(
        files[ROBOT].contains("parent=\"pan_ü\"") && files[ROBOT].contains("\"tilt_ü\""),
        "{}",
        files[ROBOT]
    );
}

#[test]
fn what_a_call_passes_is_renamed_in_every_name_that_holds_it() {
    let mut client = both();
    let files = renamed(&mut client, ROBOT, "name=\"pa|n\"", "yaw").unwrap();
    assert!(
        files[ROBOT].contains("<xacro:unit name=\"yaw\""),
        "{}",
        files[ROBOT]
    );
    assert!(
        files[ROBOT].contains("parent=\"yaw_body\""),
        "{}",
        files[ROBOT]
    );
    assert!(!files.contains_key(UNIT), "{files:?}");
    let refused = renamed(&mut client, ROBOT, "name=\"pa|n\"", "tilt").unwrap_err();
    assert!(refused.contains("is already defined"), "{refused}");
}

#[test]
fn a_name_that_a_macro_makes_is_not_renamed_as_a_whole() {
    let mut client = both();
    let refused = renamed(&mut client, ROBOT, "parent=\"pan_b|ody\"", "arm").unwrap_err();
    let expected = "comes from `unit` on line 4: rename the suffix there or change the argument";
    assert!(
        refused.contains("`pan_body` ") && refused.contains(expected),
        "{refused}"
    );
    // where the name is computed in another way, renaming would tear it apart
    client.edit(
        ROBOT,
        "parent=\"pan_body\"",
        "parent=\"${'pan' + '_body'}\"",
    );
    let refused = renamed(&mut client, UNIT, "<link name=\"${name}_bo|dy\"", "_arm").unwrap_err();
    assert!(refused.contains("`pan_body`"), "{refused}");
    // a broken file is left alone where it is broken
    client.edit(ROBOT, "</robot>", "");
    assert!(renamed(&mut client, ROBOT, "parent=\"${'pan' + '_b|ody'}\"", "x").is_err());
}

#[test]
fn links_are_renamed_in_all_robots_that_share_them() {
    let folder = pan_tilt();
    let arm =
        "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link name=\"🤖_tip\"/></robot>\n";
    let robot = |name: &str| {
        format!(
            "<robot name=\"{name}\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<xacro:include filename=\"tip.xacro\"/>\n\
             <link name=\"b\"/><joint name=\"j\" type=\"fixed\"><parent link=\"b\"/><child link=\"🤖_tip\"/></joint></robot>\n"
        )
    };
    let place = |name: &str| format!("src/pan_tilt/urdf/{name}");
    super::workspace::write(&folder, &place("tip.xacro"), arm);
    for name in ["one", "two"] {
        super::workspace::write(&folder, &place(&format!("{name}.urdf.xacro")), robot(name));
    }
    let mut client = annotating(folder);
    client.open(&place("tip.xacro"));
    client.open(&place("one.urdf.xacro"));
    let mut params = client.at(&place("one.urdf.xacro"), "<child link=\"🤖_|tip");
    params["newName"] = json!("tool");
    let edit = client.request("textDocument/rename", params);
    let changes = edit["documentChanges"].as_array().unwrap();
    assert_eq!(changes.len(), 3, "{edit}");
    for change in changes {
        let uri = change["textDocument"]["uri"].as_str().unwrap();
        let open = client.is_open(&place(uri.rsplit('/').next().unwrap()));
        assert_eq!(
            change["textDocument"]["version"].is_null(),
            !open,
            "{change}"
        );
        // what is not open says so
        let annotation = &change["edits"][0]["annotationId"];
        assert_eq!(annotation.as_str(), (!open).then_some("closed"), "{change}");
    }
    assert_eq!(
        edit["changeAnnotations"]["closed"]["needsConfirmation"], false,
        "{edit}"
    );
}

#[test]
fn files_outside_are_changed_with_consent_and_installed_ones_never() {
    let elsewhere = super::workspace::fresh_folder();
    let share = elsewhere.join("share");
    let part =
        "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link name=\"${p0}\"/></robot>\n";
    for (place, refused) in [("near/part.xacro", false), ("install/part.xacro", true)] {
        super::workspace::write(&share, place, part);
        let path = share.join(place);
        let include = format!("<xacro:include filename=\"{}\"/></robot>", path.display());
        for annotates in [true, false] {
            let mut client = if annotates {
                annotating(pan_tilt())
            } else {
                Client::start()
            };
            client.open(ROBOT);
            client.edit(
                ROBOT,
                "<xacro:property",
                "<xacro:property name=\"p0\" value=\"🤖\"/><xacro:property",
            );
            client.edit(ROBOT, "</robot>", &include);
            let mut params = client.at(ROBOT, "name=\"p|0\"");
            params["newName"] = json!("p1");
            let id = client.post("textDocument/rename", params);
            let reply = client.reply(id);
            let message = reply["error"]["message"].as_str().unwrap_or("");
            match (refused, annotates) {
                (true, _) => assert!(message.contains("is in an install folder"), "{reply}"),
                (false, false) => assert!(message.contains("not in the workspace"), "{reply}"),
                (false, true) => {
                    let asks =
                        &reply["result"]["changeAnnotations"]["outside"]["needsConfirmation"];
                    assert_eq!(asks, true, "{reply}");
                }
            }
        }
    }
    std::fs::remove_dir_all(elsewhere).unwrap();
}

#[test]
fn an_argument_is_renamed_in_the_presets_of_its_robots() {
    let folder = pan_tilt();
    let config = "[[roots]]\nfile = \"src/pan_tilt/urdf/*.urdf.xacro\"\nargs = { mount = \"desk\", other = 1 }\n\
                  [roots.presets]\n\"wall 🤖\" = { \"mount\" = \"wall\" }\n\n[[roots]]\nfile = \"src/other.urdf.xacro\"\n\
                  args = { mount = \"x\" }\n";
    super::workspace::write(&folder, "xacro-lint.toml", config);
    let mut client = Client::with(folder, Options::default());
    client.open(ROBOT);
    client.open("xacro-lint.toml");
    client.open(UNIT);
    client.edit(
        UNIT,
        "<!-- A motor",
        "<!-- xacro-root: pan_tilt.urdf.xacro mount:=🤖 --><!-- A motor",
    );
    let mut params = client.at(ROBOT, "<xacro:arg name=\"mo|unt\"");
    params["newName"] = json!("place");
    let edit = client.request("textDocument/rename", params);
    let changed = client.after("xacro-lint.toml", &edit);
    let expected = config
        .replace("{ mount = \"desk\"", "{ place = \"desk\"")
        .replace("{ \"mount\" = \"wall\"", "{ \"place\" = \"wall\"");
    assert_eq!(changed, expected);
    assert!(client.after(ROBOT, &edit).contains("$(arg place)"));
    assert!(
        client
            .after(UNIT, &edit)
            .contains("pan_tilt.urdf.xacro place:=🤖 -->")
    );
}

#[test]
fn a_namespace_is_renamed_in_the_tags_of_its_calls() {
    let mut client = both();
    client.edit(
        ROBOT,
        "filename=\"unit.xacro\"/>",
        "filename=\"unit.xacro\" ns=\"parts\"/>",
    );
    for _ in 0..2 {
        client.edit(ROBOT, "<xacro:unit name", "<xacro:parts.unit name");
        client.edit(ROBOT, "</xacro:unit>", "</xacro:parts.unit>");
    }
    let files = renamed(&mut client, ROBOT, "ns=\"pa|rts\"", "pieces").unwrap();
    assert!(!files[ROBOT].contains("parts"), "{}", files[ROBOT]);
    assert_eq!(
        files[ROBOT].matches("</xacro:pieces.unit>").count(),
        2,
        "{}",
        files[ROBOT]
    );
}
