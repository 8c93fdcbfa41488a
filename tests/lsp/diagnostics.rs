//! F2: findings while typing.

use serde_json::{Value, json};

use super::client::{Client, Options, short};
use super::workspace::{ROBOT, UNIT, pan_tilt};

#[test]
fn a_clean_workspace_shows_nothing_bad() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    for file in [ROBOT, UNIT] {
        let bad: Vec<String> = client
            .diagnostics(file)
            .iter()
            .filter(|d| d["severity"].as_i64() <= Some(2))
            .map(short)
            .collect();
        assert_eq!(bad, Vec::<String>::new(), "{file}");
    }
}

#[test]
fn an_undefined_name_is_marked_and_a_near_one_suggested() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"/>",
        "<link name=\"$(arg mount)\"/><link name=\"${m1}\"/>",
    );
    let found = client.diagnostics(ROBOT);
    let undefined: Vec<&Value> = found
        .iter()
        .filter(|d| d["code"] == "undefined-property")
        .collect();
    assert_eq!(undefined.len(), 1, "{found:?}");
    assert_eq!(client.slice(ROBOT, &undefined[0]["range"]), "m1");
    assert_eq!(undefined[0]["source"], "xacro");
    assert!(
        undefined[0]["message"].as_str().unwrap().contains("m0"),
        "{}",
        undefined[0]
    );
}

#[test]
fn a_fixed_file_is_told_to_be_clean_at_its_new_version() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    assert_eq!(client.findings(ROBOT), ["8:76-78 undefined-property"]);
    client.edit(ROBOT, "${m1 / 3}", "${m0 / 3}");
    assert_eq!(client.findings(ROBOT), Vec::<String>::new());
}

#[test]
fn an_unsaved_include_counts() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "name=\"unit\"", "name=\"unitt\"");
    client.edit(ROBOT, "value=\"0.15\"", "value=\"0.16\"");
    let undefined: Vec<String> = client
        .findings(ROBOT)
        .into_iter()
        .filter(|found| found.ends_with("undefined-macro"))
        .collect();
    assert_eq!(
        undefined,
        ["7:2-13 undefined-macro", "8:2-13 undefined-macro"]
    );
}

#[test]
fn columns_count_utf_16() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"/>",
        "<!-- 🤖 --><link name=\"$(arg mount)\"/><link name=\"${m1}\"/>",
    );
    let found = client.diagnostics(ROBOT);
    let undefined = found
        .iter()
        .find(|d| d["code"] == "undefined-property")
        .unwrap();
    assert_eq!(client.slice(ROBOT, &undefined["range"]), "m1");
}

#[test]
fn a_syntax_error_is_reported_and_the_rest_lives_on() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"/>",
        "<link name=\"$(arg mount)\"></joint>",
    );
    let found = client.findings(ROBOT);
    assert!(
        found
            .iter()
            .any(|found| found.ends_with("xml-syntax-error")),
        "{found:?}"
    );
}

#[test]
fn clients_that_pull_are_not_pushed_at() {
    let capabilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    let report = client.request("textDocument/diagnostic", client.of(ROBOT));
    assert_eq!(report["kind"], "full");
    let found: Vec<String> = report["items"]
        .as_array()
        .unwrap()
        .iter()
        .map(short)
        .collect();
    assert_eq!(found, ["8:76-78 undefined-property"]);
    let mut params = client.of(ROBOT);
    params["previousResultId"] = report["resultId"].clone();
    assert_eq!(
        client.request("textDocument/diagnostic", params)["kind"],
        "unchanged"
    );
}

#[test]
fn clients_that_could_pull_are_pushed_at_when_they_say_so() {
    let capabilities = json!({ "textDocument": { "diagnostic": {} } });
    let first = json!({ "diagnostics": { "pull": false } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            first,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    assert_eq!(client.findings(ROBOT), ["8:76-78 undefined-property"]);
}

/// `line:start-end code` of related places, with their messages.
fn related(diagnostic: &Value) -> Vec<String> {
    let shown = |related: &Value| {
        let (place, start) = (&related["location"], &related["location"]["range"]["start"]);
        let file = place["uri"]
            .as_str()
            .unwrap()
            .rsplit('/')
            .next()
            .unwrap()
            .to_owned();
        let line = start["line"].as_u64().unwrap() + 1;
        format!("{file}:{line} {}", related["message"].as_str().unwrap())
    };
    diagnostic["relatedInformation"]
        .as_array()
        .into_iter()
        .flatten()
        .map(shown)
        .collect()
}

#[test]
fn a_wrong_argument_is_marked_at_the_call() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(
        ROBOT,
        "<xacro:unit name=\"tilt\"",
        "<!-- 🤖 --><xacro:unit name=\"tilt\"",
    );
    client.edit(ROBOT, "parent=\"pan_body\"", "parent=\"pan_bdy\"");
    let found = client.diagnostics(ROBOT);
    let undefined: Vec<&Value> = found
        .iter()
        .filter(|d| d["code"] == "undefined-link")
        .collect();
    assert_eq!(undefined.len(), 1, "{found:?}");
    assert_eq!(client.slice(ROBOT, &undefined[0]["range"]), "pan_bdy");
    assert_eq!(undefined[0]["severity"], 1);
    assert_eq!(related(undefined[0]), ["unit.xacro:6 here in macro `unit`"]);
    assert_eq!(client.findings(UNIT), Vec::<String>::new());
    // the fix corrects the call
    let params = json!({
        "textDocument": { "uri": client.uri(ROBOT) },
        "range": undefined[0]["range"],
        "context": { "diagnostics": [undefined[0]] },
    });
    let actions = client.request("textDocument/codeAction", params);
    let fix = &actions[0];
    assert_eq!(fix["title"], "Change argument to `pan_body`", "{actions}");
    assert!(
        client
            .after(ROBOT, &fix["edit"])
            .contains("parent=\"pan_body\"")
    );
}

#[test]
fn an_argument_that_is_handed_down_is_marked_where_it_is_written() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "  <xacro:unit name=\"tilt\"",
        "  <xacro:macro name=\"outer\" params=\"on\">\
         <xacro:unit name=\"deep\" parent=\"${on}\"><origin/></xacro:unit></xacro:macro>\n  \
         <xacro:outer on=\"dsk\"/>\n  <xacro:outer on=\"desk\"/>\n  <xacro:unit name=\"tilt\"",
    );
    let found = client.diagnostics(ROBOT);
    let undefined: Vec<&Value> = found
        .iter()
        .filter(|d| d["code"] == "undefined-link")
        .collect();
    assert_eq!(undefined.len(), 1, "{found:?}");
    assert_eq!(client.slice(ROBOT, &undefined[0]["range"]), "dsk");
}

const BARS: &str = "<xacro:macro name=\"bar\" params=\"name m\"><link name=\"${name}\"><inertial>\
    <mass value=\"${m - 1}\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>\
    </inertial></link><joint name=\"${name}_j\" type=\"fixed\"><parent link=\"desk\"/>\
    <child link=\"${name}\"/></joint></xacro:macro>\n";

#[test]
fn what_holds_for_some_calls_is_marked_at_these_calls() {
    let mut client = Client::start();
    client.open(ROBOT);
    let calls = "<xacro:bar name=\"a\" m=\"2\"/>\n<xacro:bar name=\"b\" m=\"0.5\"/>\n";
    client.edit(ROBOT, "</robot>", &format!("{BARS}{calls}</robot>"));
    let found = client.diagnostics(ROBOT);
    let masses: Vec<&Value> = found
        .iter()
        .filter(|d| d["code"] == "negative-mass")
        .collect();
    assert_eq!(masses.len(), 1, "{found:?}");
    assert_eq!(short(masses[0]), "11:0-10 negative-mass");
    assert_eq!(
        related(masses[0]),
        ["pan_tilt.urdf.xacro:9 here in macro `bar`"]
    );
    client.edit(ROBOT, "m=\"0.5\"", "m=\"1.5\"");
    let left = client.findings(ROBOT);
    assert!(
        !left.iter().any(|found| found.ends_with("negative-mass")),
        "{left:?}"
    );
}

#[test]
fn what_holds_for_every_call_is_marked_in_the_macro_and_noted_at_the_calls() {
    let mut client = Client::start();
    client.open(ROBOT);
    let calls = "<xacro:bar name=\"a\" m=\"0.2\"/>\n<xacro:bar name=\"b\" m=\"0.5\"/>\n";
    client.edit(ROBOT, "</robot>", &format!("{BARS}{calls}</robot>"));
    let shown = |client: &mut Client| -> Vec<String> {
        let found = client.diagnostics(ROBOT);
        let masses = found.iter().filter(|d| d["code"] == "negative-mass");
        masses
            .map(|d| format!("{} {}", short(d), d["severity"]))
            .collect()
    };
    let at_calls = ["10:0-10 negative-mass 4", "11:0-10 negative-mass 4"];
    let all = shown(&mut client);
    assert_eq!(all[1..], at_calls);
    assert!(
        all[0].starts_with("9:") && all[0].ends_with(" 1"),
        "{all:?}"
    );
    // a text that is broken behind it is about its syntax only
    client.edit(ROBOT, "</robot>", "<link name=\"");
    assert_eq!(shown(&mut client), Vec::<String>::new());
}

#[test]
fn a_finding_in_an_unsaved_macro_is_noted_at_its_calls_in_open_files() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "${m0 * 2}", "-1");
    client.edit(ROBOT, "value=\"0.15\"", "value=\"0.16\"");
    let noted = |found: Vec<String>| -> Vec<String> {
        found
            .into_iter()
            .filter(|found| found.ends_with("negative-mass"))
            .collect()
    };
    let at_calls = ["7:2-13 negative-mass", "8:2-13 negative-mass"];
    assert_eq!(noted(client.findings(ROBOT)), at_calls);
    assert_eq!(noted(client.findings(UNIT)), ["4:53-55 negative-mass"]);
}

#[test]
fn clients_that_pull_are_told_when_another_file_changed() {
    let capabilities = json!({
        "textDocument": { "diagnostic": {} },
        "workspace": { "diagnostics": { "refreshSupport": true } },
    });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "name=\"unit\"", "name=\"unitt\"");
    let told = |client: &mut Client| {
        client
            .asked
            .iter()
            .find(|asked| asked["method"] == "workspace/diagnostic/refresh")
            .map(|_| ())
    };
    client.wait(told, || "no refresh".to_owned());
    let report = client.request("textDocument/diagnostic", client.of(ROBOT));
    assert_eq!(report["items"].as_array().unwrap().len(), 2, "{report}");
}

#[test]
fn an_error_in_a_closed_macro_file_is_shown_at_the_call() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "value=\"0.15\"", "value=\"-0.15\"");
    let found = client.diagnostics(ROBOT);
    assert_eq!(
        found.iter().map(short).collect::<Vec<_>>(),
        ["7:2-13 negative-mass", "8:2-13 negative-mass"]
    );
    let cause = &found[0]["relatedInformation"][0]["location"];
    assert!(
        cause["uri"].as_str().unwrap().ends_with("unit.xacro"),
        "{cause}"
    );
    client.open(UNIT);
    assert_eq!(client.findings(UNIT), ["4:53-62 negative-mass"]);
}

#[test]
fn of_very_many_findings_the_rest_is_counted() {
    let mut client = Client::start();
    client.open(ROBOT);
    let links: String = (0..1010)
        .map(|number| format!("<link name=\"a{number}${{m1}}\"/>\n"))
        .collect();
    client.edit(ROBOT, "</robot>", &format!("{links}</robot>"));
    let found = client.diagnostics(ROBOT);
    let told = found.last().unwrap()["message"]
        .as_str()
        .unwrap()
        .to_owned();
    assert_eq!(found.len(), 1001);
    assert!(
        told.ends_with("more findings in this file not shown"),
        "{told}"
    );
}

#[test]
fn an_open_file_of_another_kind_is_not_taken_for_a_robot() {
    let mut client = Client::start();
    client.open("src/pan_tilt/config/cam.yaml");
    client.open("src/pan_tilt/package.xml");
    client.open(ROBOT);
    for file in [
        "src/pan_tilt/config/cam.yaml",
        "src/pan_tilt/package.xml",
        ROBOT,
    ] {
        assert_eq!(client.findings(file), Vec::<String>::new(), "{file}");
    }
}

#[test]
fn what_was_said_before_moves_with_its_text_while_somebody_types() {
    let part = |n: usize| {
        format!(
            "<link name=\"l{n}\"/><joint name=\"j{n}\" type=\"fixed\"><parent link=\"base\"/>\
             <child link=\"l{n}\"/></joint>\n"
        )
    };
    let parts: String = (0..120).map(part).collect();
    let wrong = "<link name=\"${m1}\"/>\n<link name=\"base\"/>\n";
    let text = format!(
        "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<link name=\"root\"/>\n<link name=\"base\"/>\n\
         {parts}{wrong}</robot>\n"
    );
    let mut client = Client::start();
    client.open_with(ROBOT, &text);
    for (old, new) in [
        ("<link name=\"l1\"", "<link name=\"spare\""),
        ("root\"/>\n<link", "root\"/>\n\n\n <link"),
        // only the first of the two moves within its line
        ("\n\n <link", "\n\n <!-- 🤖 --><link"),
        ("spare", "l1"),
        ("<link name=\"${m1}\"", "<!-- 🤖 --><link name=\"${m1}\""),
        ("${m1}\"/>\n", "${m1}\"/>"),
        ("${m1}", "${m1 + m2}"),
    ] {
        client.diagnostics(ROBOT);
        client.edit(ROBOT, old, new);
        let found = client.diagnostics(ROBOT);
        let of = |code: &str| found.iter().find(|found| found["code"] == code).unwrap();
        assert_eq!(
            client.slice(ROBOT, &of("undefined-property")["range"]),
            "m1",
            "{new}"
        );
        let twice = of("duplicate-link-name");
        assert_eq!(client.slice(ROBOT, &twice["range"]), "base", "{new}");
        let first = &twice["relatedInformation"][0]["location"]["range"];
        assert_eq!(client.slice(ROBOT, first), "base", "{new}");
        assert_ne!(*first, twice["range"], "{new}");
    }
}

/// The workspace with three runs of the robot: on a desk, on the wall and on a mast.
fn with_presets() -> std::path::PathBuf {
    let folder = pan_tilt();
    let config = "[[roots]]\nfile = \"src/pan_tilt/urdf/pan_tilt.urdf.xacro\"\nargs = { mount = \"desk\" }\n\
                  presets.wall = { mount = \"wall\" }\npresets.mast = { mount = \"mast\" }\n";
    super::workspace::write(&folder, "xacro-lint.toml", config);
    folder
}

fn showing(contexts: &str) -> Client {
    let settings = json!({ "diagnostics": { "contexts": contexts, "delay": 0 } });
    Client::with(
        with_presets(),
        Options {
            settings,
            ..Options::default()
        },
    )
}

/// A link whose name is wrong where a condition holds, behind a sign that takes two places.
fn wrong_if(condition: &str) -> String {
    format!(
        "<!-- 🤖 --><xacro:if value=\"${{{condition}}}\"><link name=\"${{m1}}\"/></xacro:if></robot>"
    )
}

fn undefined(client: &mut Client, file: &str) -> Vec<Value> {
    let found = client.diagnostics(file).into_iter();
    found
        .filter(|found| found["code"] == "undefined-property")
        .collect()
}

#[test]
fn all_contexts_are_checked_when_asked_for() {
    let mut client = showing("all");
    client.open(ROBOT);
    client.edit(ROBOT, "</robot>", &wrong_if("'$(arg mount)' == 'wall'"));
    assert!(client.eventually(|client| undefined(client, ROBOT).len() == 1));
    let found = undefined(&mut client, ROBOT);
    let message = |found: &Value| {
        found["message"]
            .as_str()
            .unwrap()
            .lines()
            .next()
            .unwrap()
            .to_owned()
    };
    assert!(
        message(&found[0]).ends_with(" [root pan_tilt.urdf.xacro mount:=wall]"),
        "{found:?}"
    );
    assert_eq!(client.slice(ROBOT, &found[0]["range"]), "m1");
    // two of three are told by the message, and listed
    client.edit(ROBOT, "== 'wall'", "!= 'desk'");
    let found = undefined(&mut client, ROBOT);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        message(&found[0]).ends_with(" [root pan_tilt.urdf.xacro mount:=wall and 1 more]"),
        "{found:?}"
    );
    let related = found[0]["relatedInformation"].as_array().unwrap();
    let related: Vec<&str> = related
        .iter()
        .map(|place| place["message"].as_str().unwrap())
        .collect();
    assert!(related.ends_with(&[
        "with root pan_tilt.urdf.xacro mount:=wall",
        "with root pan_tilt.urdf.xacro mount:=mast"
    ]));
    // all of them need no word about it
    client.edit(ROBOT, "!= 'desk'", "!= 'moon'");
    let found = undefined(&mut client, ROBOT);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(!message(&found[0]).contains("[root"), "{found:?}");
    // what is used in one context is not unused
    client.edit(
        ROBOT,
        "<link name=\"${m1}\"/></xacro:if>",
        "<link name=\"l${spare}\"/></xacro:if>",
    );
    client.edit(ROBOT, "!= 'moon'", "== 'wall'");
    client.edit(
        ROBOT,
        "  <link",
        "  <xacro:property name=\"spare\" value=\"1\"/>\n  <link",
    );
    let found = client.findings(ROBOT);
    assert!(
        !found.iter().any(|found| found.ends_with("unused-property")),
        "{found:?}"
    );
}

#[test]
fn the_active_context_alone_is_checked_by_default() {
    for contexts in ["active", "some"] {
        let mut client = showing(contexts);
        client.open(ROBOT);
        client.edit(ROBOT, "</robot>", &wrong_if("'$(arg mount)' == 'wall'"));
        assert_eq!(undefined(&mut client, ROBOT), Vec::<Value>::new());
        client.edit(ROBOT, "== 'wall'", "== 'desk'");
        let found = undefined(&mut client, ROBOT);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            !found[0]["message"].as_str().unwrap().contains("[root"),
            "{found:?}"
        );
        let told = |client: &mut Client| {
            client.diagnostics(ROBOT);
            let mut notes = client.notes.iter();
            notes.any(|note| {
                note["params"]["message"]
                    .as_str()
                    .is_some_and(|m| m.contains("diagnostics.contexts"))
            })
        };
        assert!(
            client.eventually(|client| told(client) == (contexts == "some")),
            "{contexts}"
        );
    }
}

#[test]
fn contexts_of_broken_and_unsaved_files_are_told_apart() {
    let mut client = showing("all");
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(
        UNIT,
        "value=\"${m0 * 2}\"",
        "value=\"${m0 * (m2 if parent == 'wall' else 2)}\"",
    );
    let message = "mount:=wall]";
    let has = |client: &mut Client| {
        // the argument of this call is to blame, or the macro
        let both = [undefined(client, UNIT), undefined(client, ROBOT)].concat();
        both.iter()
            .any(|found| found["message"].as_str().unwrap().contains(message))
    };
    assert!(client.eventually(has));
    // a file that is cut off says so in every context, once
    let text = client.text(ROBOT).to_owned();
    client.edit(
        ROBOT,
        &text,
        text.trim_end().strip_suffix("</robot>").unwrap(),
    );
    let found = client.diagnostics(ROBOT);
    let syntax: Vec<&Value> = found
        .iter()
        .filter(|found| found["code"] == "xml-syntax-error")
        .collect();
    assert_eq!(syntax.len(), 1, "{found:?}");
    assert!(
        !syntax[0]["message"].as_str().unwrap().contains("[root"),
        "{found:?}"
    );
}

#[test]
fn all_contexts_are_pulled_too() {
    let settings = json!({ "diagnostics.contexts": "all" });
    let capabilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::with(
        with_presets(),
        Options {
            settings,
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.edit(ROBOT, "</robot>", &wrong_if("'$(arg mount)' == 'mast'"));
    let told = |client: &mut Client| {
        let report = client.request("textDocument/diagnostic", client.of(ROBOT));
        let items = report["items"].as_array().unwrap().clone();
        items.iter().any(|found| {
            found["message"]
                .as_str()
                .unwrap()
                .contains("[root pan_tilt.urdf.xacro mount:=mast]")
        })
    };
    assert!(client.eventually(told));
}

#[test]
fn an_error_that_cuts_a_robot_short_says_which_rules_did_not_run() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    // two links that nothing connects: with the missing macro nobody can say so
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"/>",
        "<link name=\"$(arg mount)\"/><link name=\"loose\"/>",
    );
    assert!(
        client
            .findings(ROBOT)
            .iter()
            .any(|found| found.ends_with("orphan-link"))
    );
    client.edit(UNIT, "name=\"unit\"", "name=\"unitt\"");
    client.edit(ROBOT, "value=\"0.15\"", "value=\"0.16\"");
    let found = client.diagnostics(ROBOT);
    let messages: Vec<&str> = found
        .iter()
        .filter_map(|found| found["message"].as_str())
        .collect();
    let cut: Vec<&&str> = messages
        .iter()
        .filter(|text| text.contains("not checked in full"))
        .collect();
    assert_eq!(cut.len(), 1, "{messages:?}");
    assert!(
        cut[0].starts_with("macro `unit` is not defined"),
        "{messages:?}"
    );
    assert!(
        cut[0].contains("`pan_tilt.urdf.xacro` is not checked in full"),
        "{messages:?}"
    );
    assert!(
        cut[0].contains(
            "(`collision-left-out`, `gazebo-unknown-reference`, `mimic-unknown-joint` and "
        ),
        "{messages:?}"
    );
    assert!(
        !found.iter().any(|found| found["code"] == "orphan-link"),
        "{messages:?}"
    );
}

#[test]
fn a_package_that_is_not_found_says_what_is_not_checked() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "<xacro:include filename=\"unit.xacro\"/>",
        "<xacro:include filename=\"unit.xacro\"/><xacro:include filename=\"$(find arm_description)/arm.xacro\"/>",
    );
    let found = client.diagnostics(ROBOT);
    let missing: Vec<&Value> = found
        .iter()
        .filter(|found| found["code"] == "package-not-found")
        .collect();
    assert_eq!(missing.len(), 1, "{found:?}");
    let message = missing[0]["message"].as_str().unwrap();
    assert!(
        message.contains("`pan_tilt.urdf.xacro` is not checked in full"),
        "{message}"
    );
    assert!(missing[0]["severity"].as_i64() <= Some(2), "{missing:?}");
}

#[test]
fn a_hint_at_a_call_names_what_that_call_makes() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "${m0 * 2}", "-1");
    let hints = |client: &mut Client| -> Vec<String> {
        let found = client.diagnostics(ROBOT).into_iter();
        let hints = found.filter(|found| found["severity"] == 4);
        hints
            .map(|found| found["message"].as_str().unwrap().to_owned())
            .filter(|message| message.starts_with("this call causes"))
            .collect()
    };
    assert!(client.eventually(|client| hints(client).len() == 2));
    let found = hints(&mut client);
    for (hint, own, other) in [
        (&found[0], "`pan_body`", "tilt_body"),
        (&found[1], "`tilt_body`", "pan_body"),
    ] {
        assert!(hint.contains(own) && !hint.contains(other), "{found:?}");
    }
    // a call further out: which of the calls inside are its own is not known
    client.edit(
        ROBOT,
        "<xacro:unit name=\"pan\" parent=\"$(arg mount)\"><origin xyz=\"0 0 0.1\"/></xacro:unit>",
        "<xacro:macro name=\"both\" params=\"n\"><xacro:unit name=\"${n}\" parent=\"$(arg mount)\"><origin/></xacro:unit></xacro:macro>\n\
         <xacro:both n=\"pan\"/>",
    );
    assert!(client.eventually(|client| hints(client).len() == 3));
    let found = hints(&mut client);
    let outer: Vec<&String> = found
        .iter()
        .filter(|hint| !hint.contains("_body"))
        .collect();
    assert_eq!(outer.len(), 1, "{found:?}");
}

#[test]
fn a_name_that_cannot_be_computed_hides_no_missing_link() {
    let mut client = Client::start();
    client.open(ROBOT);
    let joint =
        "<joint name=\"j\" type=\"fixed\"><parent link=\"desk\"/><child link=\"gone\"/></joint>";
    let with = |name: &str| format!("<link name=\"{name}\"/>{joint}\n</robot>");
    client.edit(ROBOT, "</robot>", &with("left_${nope}"));
    let found = client.diagnostics(ROBOT);
    let undefined = found.iter().find(|found| found["code"] == "undefined-link");
    assert!(undefined.is_some(), "{found:?}");
    let says = |found: &[Value]| {
        let about = found
            .iter()
            .find(|found| found["code"] == "undefined-property");
        about.unwrap()["message"].as_str().unwrap().to_owned()
    };
    let message = says(&found);
    assert!(
        message.contains("`pan_tilt.urdf.xacro` is not checked in full"),
        "{message}"
    );
    // a name of which nothing is known may be that of the link
    client.edit(ROBOT, "left_${nope}", "${nope}");
    let found = client.diagnostics(ROBOT);
    assert!(
        !found.iter().any(|found| found["code"] == "undefined-link"),
        "{found:?}"
    );
    assert!(says(&found).contains("is not checked in full"), "{found:?}");
    // what is known says everything
    client.edit(ROBOT, "${nope}", "gone");
    let found = client.diagnostics(ROBOT);
    assert!(
        !found.iter().any(|found| found["message"]
            .as_str()
            .unwrap()
            .contains("not checked in full")),
        "{found:?}"
    );
}
