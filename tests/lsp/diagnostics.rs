//! F2: findings while typing.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::short;
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
