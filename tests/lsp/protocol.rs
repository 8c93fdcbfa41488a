//! What clients may leave out, take back, or ask in a row: versions, settings, ranges, reports.

use serde_json::{Value, json};

use super::actions::{FILE, robot, show, titled};
use super::client::{Client, Options};
use super::positions::short;
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, pan_tilt, write};

#[test]
fn texts_without_versions_are_followed() {
    for version in [Value::Null, json!(1.5), json!("none")] {
        let mut client = Client::start();
        let uri = client.uri(ROBOT);
        let mut document = json!({ "uri": uri, "languageId": "xacro", "text": ROBOT_TEXT });
        let mut change = json!({ "uri": uri });
        if version != "none" {
            (document["version"], change["version"]) = (version.clone(), version.clone());
        }
        client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        let text = ROBOT_TEXT.replace("value=\"0.15\"", "value=\"0.75\"");
        let changes = json!([{ "text": text }]);
        let params = json!({ "textDocument": change, "contentChanges": changes });
        client.notify("textDocument/didChange", params);
        let expanded = client.request("xacro/expand", client.of(ROBOT));
        assert!(
            expanded["urdf"].as_str().unwrap().contains("0 0 0.25"),
            "{version}: {expanded}"
        );
        // findings then carry none either
        assert!(!client.have_version(ROBOT), "{version}");
    }
}

#[test]
fn settings_that_are_taken_back_are_the_default_again() {
    let rule = |level: &str| json!({ "diagnostics": { "delay": 0, "rules": { "undefined-property": level } } });
    let hinted = |client: &mut Client| {
        let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
        let mut params = client.of(ROBOT);
        params["range"] = whole;
        !client
            .request("textDocument/inlayHint", params)
            .as_array()
            .unwrap()
            .is_empty()
    };
    let mut off = rule("off");
    off["inlayHints"] = json!({ "values": false, "paramNames": "never" });
    // asked for, and pushed
    for asks in [true, false] {
        let settings = if asks { off.clone() } else { Value::Null };
        let mut client = Client::with(
            pan_tilt(),
            Options {
                settings,
                ..Options::default()
            },
        );
        client.open(ROBOT);
        if !asks {
            client.notify(
                "workspace/didChangeConfiguration",
                json!({ "settings": { "xacro": off } }),
            );
        }
        client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
        assert!(
            client.eventually(|client| client.findings(ROBOT).is_empty() && !hinted(client)),
            "{asks}"
        );
        client.change_settings(Value::Null);
        client.notify(
            "workspace/didChangeConfiguration",
            json!({ "settings": null }),
        );
        let is_back = |client: &mut Client| !client.findings(ROBOT).is_empty() && hinted(client);
        assert!(
            client.eventually(is_back),
            "{asks}: {:?}",
            client.findings(ROBOT)
        );
    }
}

#[test]
fn settings_of_the_start_hold_where_there_are_no_others() {
    let first = json!({ "diagnostics": { "delay": 0, "rules": { "undefined-property": "off" } } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            first,
            settings: json!([]),
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    client.wait(
        |client| {
            client
                .asked
                .iter()
                .any(|a| a["method"] == "workspace/configuration")
                .then_some(())
        },
        || "question for settings".to_owned(),
    );
    client.request("textDocument/documentSymbol", client.of(ROBOT));
    assert_eq!(client.findings(ROBOT), Vec::<String>::new());
}

#[test]
fn the_largest_folds_are_kept() {
    let text = robot(
        "<link name=\"a\">\n<visual>\n<geometry>\n<sphere/>\n</geometry>\n</visual>\n</link>\n\
         <link name=\"b\">\n<visual/>\n</link>\n<link name=\"🤖\">\n<visual>\n<origin/>\n<geometry/>\n</visual>\n</link>",
    );
    let folds = |limit: Value| -> Vec<(u64, u64)> {
        let capabilities = json!({ "textDocument": { "foldingRange": { "rangeLimit": limit } } });
        let mut client = Client::with(
            pan_tilt(),
            Options {
                capabilities,
                ..Options::default()
            },
        );
        show(&mut client, &text);
        let found = client.request("textDocument/foldingRange", client.of(FILE));
        let lines = |fold: &Value| {
            (
                fold["startLine"].as_u64().unwrap(),
                fold["endLine"].as_u64().unwrap(),
            )
        };
        found.as_array().unwrap().iter().map(lines).collect()
    };
    assert_eq!(folds(json!(100)).len(), 7);
    assert_eq!(folds(json!(4)), [(0, 16), (1, 6), (2, 5), (11, 15)]);
}

#[test]
fn what_is_shown_covers_the_pointer() {
    let mut client = Client::start();
    client.open(ROBOT);
    for (at, expected) in [
        ("$(fi|nd pan_tilt)", "$(find pan_tilt)"),
        ("|$(find pan_tilt)", "$(find pan_tilt)"),
        ("$(find pan|_tilt)", "pan_tilt"),
    ] {
        let hover = client.request("textDocument/hover", client.at(ROBOT, at));
        assert_eq!(
            client.slice(ROBOT, &hover["range"]),
            expected,
            "{at}: {hover}"
        );
    }
}

#[test]
fn a_lens_counts_where_its_macro_stands_now() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    let lenses = client.request("textDocument/codeLens", client.of(UNIT));
    client.edit(UNIT, "  <!-- A motor", "\n\n  <!-- 🤖 -->\n  <!-- A motor");
    let lens = client.request("codeLens/resolve", lenses[0].clone());
    assert_eq!(lens["command"]["title"], "2 calls in 1 root");
    let argument = &lens["command"]["arguments"][0];
    assert_eq!(argument["position"]["line"], 5, "{argument}");
    // a macro that is gone has no calls to count
    client.edit(UNIT, "name=\"unit\"", "name=\"other\"");
    let id = client.post("codeLens/resolve", lenses[0].clone());
    assert_eq!(client.reply(id)["error"]["code"], -32801);
}

#[test]
fn a_folder_named_by_its_path_alone_is_looked_at() {
    let mut client = Client::spawn(pan_tilt(), Options::default());
    let params = json!({ "processId": null, "rootUri": null, "rootPath": client.folder, "capabilities": {} });
    client.request("initialize", params);
    client.notify("initialized", json!({}));
    let found = client.eventually(|client| {
        let found = client.request("workspace/symbol", json!({ "query": "unit" }));
        found.as_array().is_some_and(|found| !found.is_empty())
    });
    assert!(found);
}

/// `file: codes`, or `unchanged`, of a report about the workspace; and the ids of its parts.
fn workspace_report(client: &mut Client, ids: &[Value]) -> (Vec<String>, Vec<Value>) {
    let report = client.request("workspace/diagnostic", json!({ "previousResultIds": ids }));
    let items = report["items"].as_array().unwrap();
    let shown = items.iter().map(|item| {
        let file = item["uri"].as_str().unwrap().rsplit('/').next().unwrap();
        let found: Option<Vec<String>> = item["items"]
            .as_array()
            .map(|items| items.iter().map(short).collect());
        format!(
            "{file}: {}",
            found.map_or("unchanged".to_owned(), |found| found.join(", "))
        )
    });
    let ids = items
        .iter()
        .map(|item| json!({ "uri": item["uri"], "value": item["resultId"] }));
    (shown.collect(), ids.collect())
}

#[test]
fn reports_of_the_workspace_clear_files_that_are_not_open() {
    let capabilities = json!({ "textDocument": { "diagnostic": {} } });
    for says_ids in [true, false] {
        let folder = pan_tilt();
        // the first error of a closed file is shown at the call in the open one
        let broken = super::workspace::UNIT_TEXT
            .replace("${m0 * 2}", "${m1 * 2}")
            .replace("1e-3", "${m2}");
        write(&folder, UNIT, &broken);
        let mut client = Client::with(
            folder,
            Options {
                capabilities: capabilities.clone(),
                ..Options::default()
            },
        );
        client.open(ROBOT);
        let unit = |shown: &[String]| {
            shown
                .iter()
                .find(|line| line.starts_with("unit.xacro"))
                .cloned()
        };
        let (shown, ids) = workspace_report(&mut client, &[]);
        assert!(
            unit(&shown).unwrap().contains("undefined-property"),
            "{shown:?}"
        );
        let (again, _) = workspace_report(&mut client, &ids);
        assert_eq!(unit(&again).unwrap(), "unit.xacro: unchanged", "{again:?}");
        write(&client.folder, UNIT, super::workspace::UNIT_TEXT);
        let (cleared, _) = workspace_report(&mut client, if says_ids { &ids } else { &[] });
        assert_eq!(unit(&cleared).unwrap(), "unit.xacro: ", "{cleared:?}");
    }
}

#[test]
fn meshes_that_come_and_go_unannounced_are_noticed() {
    const MESH: &str = "src/pan_tilt/meshes/cube.stl";
    let text = robot(
        "<link name=\"a\"><visual><geometry><mesh filename=\"package://pan_tilt/meshes/cube.stl\"/></geometry></visual></link>",
    );
    let missing = |found: &[String]| found.iter().any(|found| found.ends_with("mesh-not-found"));
    // pulled
    let capabilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    show(&mut client, &text);
    let pull = |client: &mut Client| -> Vec<String> {
        let report = client.request("textDocument/diagnostic", client.of(FILE));
        report["items"]
            .as_array()
            .unwrap()
            .iter()
            .map(short)
            .collect()
    };
    assert!(missing(&pull(&mut client)));
    write(&client.folder, MESH, super::quick_fixes::cube(1.0));
    assert!(!missing(&pull(&mut client)));
    std::fs::remove_file(client.folder.join(MESH)).unwrap();
    assert!(missing(&pull(&mut client)));
    // pushed, at a save
    let mut client = Client::start();
    show(&mut client, &text);
    assert!(missing(&client.findings(FILE)));
    write(&client.folder, MESH, super::quick_fixes::cube(1.0));
    client.notify("textDocument/didSave", client.of(FILE));
    assert!(client.eventually(|client| !missing(&client.findings(FILE))));
}

#[test]
fn fixes_are_those_of_the_range() {
    let mut client = Client::start();
    show(
        &mut client,
        &robot("<link name=\"🤖${m_0}\"/>\n<link name=\"${m_1}\"/>"),
    );
    let mut asked = |at: &str, shown: &dyn Fn(&[Value]) -> Vec<Value>| -> Vec<String> {
        let diagnostics = shown(&client.diagnostics(FILE));
        let found = super::actions::actions(&mut client, FILE, at, &diagnostics, &["quickfix"]);
        for action in &found {
            assert_eq!(
                action["diagnostics"][0]["code"], "undefined-property",
                "{action}"
            );
        }
        let created = found
            .iter()
            .filter_map(|action| action["title"].as_str())
            .map(str::to_owned);
        created
            .filter(|title| title.contains("Add property"))
            .collect()
    };
    let none = |_: &[Value]| Vec::new();
    assert_eq!(asked("${m|_0}", &none), ["Add property `m_0`"]);
    assert_eq!(asked("${m|_1}", &none), ["Add property `m_1`"]);
    assert_eq!(asked("<li|nk name=\"${m_1}", &none), Vec::<String>::new());
    assert_eq!(
        asked(
            "«<link name=\"🤖${m_0}\"/>\n<link name=\"${m_1}\"/>»",
            &none
        )
        .len(),
        2
    );
    // what the client names is chosen from these
    let second = |found: &[Value]| -> Vec<Value> {
        found
            .iter()
            .filter(|one| one["range"]["start"]["line"] == 2)
            .cloned()
            .collect()
    };
    assert_eq!(
        asked(
            "«<link name=\"🤖${m_0}\"/>\n<link name=\"${m_1}\"/>»",
            &second
        ),
        ["Add property `m_1`"]
    );
    // one that was shown for an older text stands for what is there now
    let old = |found: &[Value]| -> Vec<Value> {
        let mut old = found[0].clone();
        old["range"]["end"] = json!({ "line": 1, "character": 60 });
        vec![old]
    };
    assert_eq!(asked("${m|_0}", &old), ["Add property `m_0`"]);
    // findings of others say nothing
    let foreign = |_: &[Value]| {
        let zero = json!({ "line": 0, "character": 0 });
        vec![json!({ "range": { "start": zero, "end": zero }, "message": "", "source": "xmllint" })]
    };
    assert_eq!(asked("${m|_0}", &foreign), ["Add property `m_0`"]);
    let found = super::actions::actions(&mut client, FILE, "${m|_0}", &[], &["quickfix"]);
    assert!(
        client
            .after(FILE, &titled(&found, "Add property `m_0`")["edit"])
            .contains("name=\"m_0\"")
    );
}

/// The titles of the actions at a place, as an editor asks on its own or as the user does.
fn titles(client: &mut Client, at: &str, is_automatic: bool) -> Vec<String> {
    let place = client.at(FILE, at);
    let mut params = client.of(FILE);
    params["range"] = json!({ "start": place["position"], "end": place["position"] });
    params["context"] =
        json!({ "diagnostics": [], "triggerKind": if is_automatic { 2 } else { 1 } });
    let found = client.request("textDocument/codeAction", params);
    found
        .as_array()
        .unwrap()
        .iter()
        .map(|action| action["title"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn a_sign_beside_the_text_waits_for_no_check() {
    let has_fix = |client: &mut Client, is_automatic| {
        let found = titles(client, "${m|_0}", is_automatic);
        found.iter().any(|title| title.contains("Add property"))
    };
    let text = robot("<link name=\"🤖${m_0}\"/>");
    let mut client = Client::start();
    show(&mut client, &text);
    assert!(client.eventually(|client| has_fix(client, true)));
    // the check of this text comes in a minute
    let first = json!({ "diagnostics": { "delay": 60_000 } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            first,
            ..Options::default()
        },
    );
    show(&mut client, "");
    show(&mut client, &text);
    assert!(!has_fix(&mut client, true));
    assert!(has_fix(&mut client, false));
}

#[test]
fn a_large_robot_is_not_tried_out_for_a_sign_beside_the_text() {
    let mut client = Client::start();
    let links: String = (0..5_000)
        .map(|number| format!("<link name=\"l{number}\"/>\n"))
        .collect();
    let call = "<xacro:macro name=\"m\" params=\"a\"><link name=\"🤖${a}\"/></xacro:macro><xacro:m a=\"x\"/>";
    let has_call = |titles: &[String]| titles.iter().any(|title| title == "Expand macro call `m`");
    for (further, expected) in [("", true), (links.as_str(), false)] {
        show(&mut client, &robot(&format!("{call}\n{further}")));
        assert_eq!(
            has_call(&titles(&mut client, "<xacro:|m a", true)),
            expected
        );
        assert!(has_call(&titles(&mut client, "<xacro:|m a", false)));
    }
}
