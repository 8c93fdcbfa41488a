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
    let undefined: Vec<&Value> = found.iter().filter(|d| d["code"] == "undefined-property").collect();
    assert_eq!(undefined.len(), 1, "{found:?}");
    assert_eq!(client.slice(ROBOT, &undefined[0]["range"]), "m1");
    assert_eq!(undefined[0]["source"], "xacro");
    assert!(undefined[0]["message"].as_str().unwrap().contains("m0"), "{}", undefined[0]);
}

#[test]
fn a_mended_file_is_told_to_be_clean_at_its_new_version() {
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
    let undefined: Vec<String> =
        client.findings(ROBOT).into_iter().filter(|found| found.ends_with("undefined-macro")).collect();
    assert_eq!(undefined, ["7:2-13 undefined-macro", "8:2-13 undefined-macro"]);
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
    let undefined = found.iter().find(|d| d["code"] == "undefined-property").unwrap();
    assert_eq!(client.slice(ROBOT, &undefined["range"]), "m1");
}

#[test]
fn a_syntax_error_is_reported_and_the_rest_lives_on() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "<link name=\"$(arg mount)\"/>", "<link name=\"$(arg mount)\"></joint>");
    let found = client.findings(ROBOT);
    assert!(found.iter().any(|found| found.ends_with("xml-syntax-error")), "{found:?}");
}

#[test]
fn clients_that_pull_are_not_pushed_at() {
    let capabilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::with(pan_tilt(), Options { capabilities, ..Options::default() });
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    let report = client.request("textDocument/diagnostic", client.of(ROBOT));
    assert_eq!(report["kind"], "full");
    let found: Vec<String> = report["items"].as_array().unwrap().iter().map(short).collect();
    assert_eq!(found, ["8:76-78 undefined-property"]);
    let mut params = client.of(ROBOT);
    params["previousResultId"] = report["resultId"].clone();
    assert_eq!(client.request("textDocument/diagnostic", params)["kind"], "unchanged");
}

#[test]
fn clients_that_pull_are_told_when_another_file_changed() {
    let capabilities = json!({
        "textDocument": { "diagnostic": {} },
        "workspace": { "diagnostics": { "refreshSupport": true } },
    });
    let mut client = Client::with(pan_tilt(), Options { capabilities, ..Options::default() });
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "name=\"unit\"", "name=\"unitt\"");
    let told = |client: &mut Client| {
        client.asked.iter().find(|asked| asked["method"] == "workspace/diagnostic/refresh").map(|_| ())
    };
    client.wait(told, || "no refresh".to_owned());
    let report = client.request("textDocument/diagnostic", client.of(ROBOT));
    assert_eq!(report["items"].as_array().unwrap().len(), 2, "{report}");
}

#[test]
fn an_error_in_a_closed_macro_file_is_shown_at_the_call() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "axis=\"0 1 0\"", "axis=\"0 0 0\"");
    let found = client.diagnostics(ROBOT);
    assert_eq!(found.iter().map(short).collect::<Vec<_>>(), ["8:2-13 zero-axis"]);
    let cause = &found[0]["relatedInformation"][0]["location"];
    assert!(cause["uri"].as_str().unwrap().ends_with("unit.xacro"), "{cause}");
    client.open(UNIT);
    assert_eq!(client.findings(UNIT), ["7:17-24 zero-axis"]);
}
