//! F2: findings that an argument or a macro causes, at the calls and in the macro.

use serde_json::{Value, json};

use super::client::Client;
use super::positions::short;
use super::workspace::{ROBOT, UNIT};

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
