//! What each feature promises, sentence by sentence, on the pan-tilt workspace. More about each stands in the file of
//! the feature.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::{offset, position};
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, fresh_folder, pan_tilt, write};

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

/// The labels that completion offers behind the end of the text of a file.
fn offered(client: &mut Client, file: &str) -> Vec<Value> {
    let text = client.text(file).to_owned();
    let mut params = client.of(file);
    params["position"] = position(&text, text.len());
    let found = client.request("textDocument/completion", params);
    found["items"]
        .as_array()
        .or(found.as_array())
        .cloned()
        .unwrap_or_default()
}

fn labels(items: &[Value]) -> Vec<&str> {
    items
        .iter()
        .map(|item| item["label"].as_str().unwrap())
        .collect()
}

/// `line:text` of the findings of a rule in an open file.
fn marked(client: &mut Client, file: &str, rule: &str) -> Vec<String> {
    let found = client.diagnostics(file);
    let found = found.iter().filter(|found| found["code"] == rule);
    let shown = |found: &Value| {
        let line = found["range"]["start"]["line"].as_u64().unwrap() + 1;
        format!("{line}:{}", client.slice(file, &found["range"]))
    };
    found.map(shown).collect()
}

#[test]
fn f1_every_feature_is_announced() {
    let mut client = Client::spawn(pan_tilt(), Options::default());
    let answer = client.initialize();
    assert_eq!(answer["serverInfo"]["name"], "xacro-lsp");
    let offered = &answer["capabilities"];
    assert_eq!(offered["textDocumentSync"]["change"], 2);
    for name in [
        "completionProvider",
        "hoverProvider",
        "signatureHelpProvider",
        "inlayHintProvider",
        "definitionProvider",
        "declarationProvider",
        "typeDefinitionProvider",
        "implementationProvider",
        "referencesProvider",
        "documentHighlightProvider",
        "renameProvider",
        "documentSymbolProvider",
        "workspaceSymbolProvider",
        "foldingRangeProvider",
        "selectionRangeProvider",
        "linkedEditingRangeProvider",
        "documentFormattingProvider",
        "documentRangeFormattingProvider",
        "documentOnTypeFormattingProvider",
        "documentLinkProvider",
        "codeLensProvider",
        "codeActionProvider",
        "colorProvider",
        "callHierarchyProvider",
        "semanticTokensProvider",
        "executeCommandProvider",
    ] {
        assert!(!offered[name].is_null() && offered[name] != false, "{name}");
    }
    assert!(!offered["workspace"]["fileOperations"]["willRename"].is_null());
    assert_eq!(
        offered["workspace"]["workspaceFolders"]["changeNotifications"],
        true
    );
    assert_eq!(offered["experimental"]["xacro"]["expand"], 1);
}

#[test]
fn f2_a_syntax_error_and_an_undefined_name_below_are_both_found() {
    let mut client = both();
    let links =
        "<link name=\"🤖\"></joint>".to_owned() + &"\n".repeat(10) + "<link name=\"${m1}\"/>";
    client.edit(ROBOT, "<link name=\"$(arg mount)\"/>", &links);
    assert_eq!(marked(&mut client, ROBOT, "xml-syntax-error").len(), 1);
    assert_eq!(marked(&mut client, ROBOT, "undefined-property"), ["16:m1"]);
}

#[test]
fn f2_an_undefined_name_is_one_error_with_a_suggestion() {
    let mut client = both();
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"/>",
        "<link name=\"$(arg mount)\"/><link name=\"${m1}\"/>",
    );
    let found = client.diagnostics(ROBOT);
    let errors: Vec<&Value> = found
        .iter()
        .filter(|found| found["severity"] == 1)
        .collect();
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert_eq!(client.slice(ROBOT, &errors[0]["range"]), "m1");
    assert_eq!(errors[0]["code"], "undefined-property");
    assert!(errors[0]["message"].as_str().unwrap().contains("`m0`"));
    assert!(!errors[0]["data"].is_null());
}

#[test]
fn f2_a_macro_that_an_unsaved_file_renames_is_missed_at_both_calls() {
    let mut client = both();
    client.edit(UNIT, "name=\"unit\"", "name=\"unitt\"");
    assert!(client.eventually(|client| {
        client.request("xacro/roots", client.of(ROBOT));
        marked(client, ROBOT, "undefined-macro") == ["7:<xacro:unit", "8:<xacro:unit"]
    }));
    client.edit(UNIT, "name=\"unitt\"", "name=\"unit\"");
    assert!(client.eventually(|client| {
        client.request("xacro/roots", client.of(ROBOT));
        client.findings(ROBOT).is_empty()
    }));
}

#[test]
fn f3_completion_knows_what_the_place_wants() {
    let capabilities = json!({ "textDocument": { "completion": { "completionItem": { "snippetSupport": true } } } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "</robot>",
        "<joint name=\"🤖\" type=\"fixed\"><parent link=\"",
    );
    let cut = client.text(ROBOT).trim_end().to_owned();
    let whole = client.text(ROBOT).to_owned();
    client.edit(ROBOT, &whole, &cut);
    let items = offered(&mut client, ROBOT);
    for name in ["desk", "pan_body", "tilt_body"] {
        assert!(
            labels(&items).contains(&name),
            "{name} in {:?}",
            labels(&items)
        );
    }
    client.edit(
        ROBOT,
        &cut,
        &ROBOT_TEXT.replace("</robot>\n", "<link name=\"${cam['"),
    );
    let items = offered(&mut client, ROBOT);
    assert_eq!(labels(&items), ["fov", "mass"]);
    let old = client.text(ROBOT).to_owned();
    client.edit(ROBOT, &old, &ROBOT_TEXT.replace("</robot>\n", "<xacro:un"));
    let items = offered(&mut client, ROBOT);
    let unit = items
        .iter()
        .find(|item| item["label"].as_str().unwrap().contains("unit"))
        .unwrap();
    let text = unit["textEdit"]["newText"].as_str().unwrap();
    assert!(text.contains("name=") && text.contains("parent="), "{unit}");
    let old = client.text(ROBOT).to_owned();
    client.edit(ROBOT, &old, &ROBOT_TEXT.replace("</robot>\n", "<!-- <"));
    assert_eq!(offered(&mut client, ROBOT), Vec::<Value>::new());
}

#[test]
fn f4_hover_shows_values_units_signatures_and_chains() {
    let mut client = both();
    for (file, place, parts) in [
        (ROBOT, "${m0 |/ 3}", &["0.05"] as &[&str]),
        (UNIT, "velo|city", &["rad/s"]),
        (
            ROBOT,
            "<xacro:un|it",
            &["A motor with its bracket.", "axis", "0 0 1"],
        ),
        (ROBOT, "parent=\"pan|_body\"", &["desk", "0.3"]),
        (UNIT, "${m0 |* 2}", &["0.3"]),
    ] {
        let found = client.request("textDocument/hover", client.at(file, place));
        let text = found["contents"]["value"].as_str().unwrap();
        assert!(
            parts.iter().all(|part| text.contains(part)),
            "{parts:?} in {text}"
        );
        assert!(!found["range"].is_null() && text.lines().count() <= 25);
    }
}

#[test]
fn f5_the_parameter_that_is_typed_is_active() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<xacro:unit name=\"x\" parent=\"\"></robot>",
    );
    let help = client.request(
        "textDocument/signatureHelp",
        client.at(ROBOT, "name=\"x\" parent=\"|\""),
    );
    let signature = &help["signatures"][0];
    assert_eq!(signature["label"], "unit(name, parent, axis='0 0 1', *at)");
    let active = help["activeParameter"]
        .as_u64()
        .or(signature["activeParameter"].as_u64());
    assert_eq!(active, Some(1), "{help}");
}

#[test]
fn f6_a_hint_shows_the_value_on_its_line() {
    let mut client = both();
    let mut params = client.of(ROBOT);
    params["range"] =
        json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 9, "character": 0 } });
    let hints = client.request("textDocument/inlayHint", params);
    let mut on_line = hints
        .as_array()
        .unwrap()
        .iter()
        .filter(|hint| hint["position"]["line"] == 7);
    assert!(
        on_line.any(|hint| hint["label"].as_str().unwrap().contains("0.05")),
        "{hints}"
    );
}

#[test]
fn f7_a_link_of_the_expanded_robot_leads_to_the_macro() {
    let mut client = both();
    let found = client.request(
        "textDocument/definition",
        client.at(ROBOT, "parent=\"pan_b|ody\""),
    );
    let first = &found[0];
    assert_eq!(first["targetUri"], client.uri(UNIT));
    assert_eq!(
        client.slice(UNIT, &first["targetSelectionRange"]),
        "${name}_body"
    );
    assert_eq!(
        client.slice(ROBOT, &first["originSelectionRange"]),
        "pan_body"
    );
    assert_eq!(found[1]["targetUri"], client.uri(ROBOT));
}

#[test]
fn f9_a_property_is_used_in_two_files() {
    let mut client = both();
    let mut params = client.at(ROBOT, "name=\"m|0\"");
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.request("textDocument/references", params.clone());
    let mut files: Vec<&str> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|place| place["uri"].as_str().unwrap())
        .collect();
    assert_eq!(files.len(), 3);
    files.sort_unstable();
    files.dedup();
    assert_eq!(files.len(), 2);
    params["context"] = json!({ "includeDeclaration": false });
    assert_eq!(
        client
            .request("textDocument/references", params)
            .as_array()
            .unwrap()
            .len(),
        2
    );
}

#[test]
fn f10_conditions_have_no_highlights_and_tags_have_two() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<xacro:if value=\"1\">🤖</xacro:if></robot>",
    );
    let mut count = |file: &str, place: &str| {
        let found = client.request("textDocument/documentHighlight", client.at(file, place));
        found.as_array().unwrap().len()
    };
    assert_eq!(count(ROBOT, "<xacro:i|f"), 0);
    assert_eq!(count(ROBOT, "<xacro:un|it name=\"pan\""), 2);
    assert_eq!(count(UNIT, "</jo|int>"), 2);
}

#[test]
fn f11_rename_knows_names_from_elements() {
    let mut client = both();
    let mut params = client.at(UNIT, "params=\"name parent ax|is");
    params["newName"] = json!("direction");
    let edit = client.request("textDocument/rename", params.clone());
    let unit = client.after(UNIT, &edit);
    assert!(
        unit.contains("direction:='0 0 1'") && unit.contains("<axis xyz=\"${direction}\"/>"),
        "{unit}"
    );
    assert!(client.after(ROBOT, &edit).contains("direction=\"0 1 0\""));
    params["newName"] = json!("m 0");
    let id = client.post("textDocument/rename", params);
    assert!(!client.reply(id)["error"].is_null());
    assert!(
        client
            .request("textDocument/prepareRename", client.at(UNIT, "<li|mit"))
            .is_null()
    );
}

#[test]
fn f13_macros_of_files_that_are_not_open_are_found() {
    let mut client = both();
    let found = client.request("workspace/symbol", json!({ "query": "le" }));
    let macros = found
        .as_array()
        .unwrap()
        .iter()
        .filter(|symbol| symbol["kind"] == 12);
    let names: Vec<&str> = macros
        .map(|symbol| symbol["name"].as_str().unwrap())
        .collect();
    assert!(names.contains(&"lens"), "{found}");
}

#[test]
fn f16_a_broken_pair_is_not_linked() {
    let mut client = both();
    let linked = client.request(
        "textDocument/linkedEditingRange",
        client.at(UNIT, "<xacro:ma|cro"),
    );
    assert_eq!(linked["ranges"].as_array().unwrap().len(), 2);
    client.edit(UNIT, "</xacro:macro>", "</xacro:macr>");
    let linked = client.request(
        "textDocument/linkedEditingRange",
        client.at(UNIT, "<xacro:ma|cro"),
    );
    assert!(linked.is_null(), "{linked}");
}

#[test]
fn f20_formatting_twice_changes_nothing_more_and_keeps_comments() {
    let mut client = both();
    client.edit(UNIT, "    <joint", "<!--  🤖  a -->\n\n\n\n<joint");
    let ask = |client: &mut Client| {
        let mut params = client.of(UNIT);
        params["options"] = json!({ "tabSize": 2, "insertSpaces": true });
        let edits = client.request("textDocument/formatting", params);
        client.after_edits(UNIT, edits.as_array().unwrap_or(&Vec::new()))
    };
    let (old, once) = (client.text(UNIT).to_owned(), ask(&mut client));
    assert_ne!(old, once);
    assert!(
        once.contains("<!--  🤖  a -->") && once.contains("<!-- A motor with its bracket. -->"),
        "{once}"
    );
    client.edit(UNIT, &old, &once);
    assert_eq!(ask(&mut client), once);
}

#[test]
fn f21_the_end_of_a_tag_brings_the_end_tag() {
    let mut client = both();
    client.edit(ROBOT, "<link name=\"$(arg mount)\"/>", "<link name=\"x\">");
    let mut params = client.at(ROBOT, "<link name=\"x\">|");
    params["ch"] = json!(">");
    params["options"] = json!({ "tabSize": 2, "insertSpaces": true });
    let edits = client.request("textDocument/onTypeFormatting", params);
    let text = client.after_edits(ROBOT, edits.as_array().unwrap());
    assert!(text.contains("<link name=\"x\"></link>"), "{text}");
}

#[test]
fn f23_a_lens_counts_the_calls_of_a_macro() {
    let mut client = both();
    let lenses = client.request("textDocument/codeLens", client.of(UNIT));
    let titles: Vec<String> = lenses
        .as_array()
        .unwrap()
        .iter()
        .map(|lens| {
            let lens = match lens["command"].is_null() {
                true => client.request("codeLens/resolve", lens.clone()),
                false => lens.clone(),
            };
            lens["command"]["title"].as_str().unwrap().to_owned()
        })
        .collect();
    assert_eq!(titles, ["2 calls in 1 root", "Expand"]);
    let lenses = client.request("textDocument/codeLens", client.of(ROBOT));
    let titles: Vec<&str> = lenses
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|lens| lens["command"]["title"].as_str())
        .collect();
    assert!(
        titles.contains(&"Expand") && titles.contains(&"mount:=desk ▾"),
        "{titles:?}"
    );
}

#[test]
fn f25_inertia_and_properties_follow_from_the_text() {
    let mut client = both();
    let found = super::actions::actions(
        &mut client,
        ROBOT,
        "xyz=\"0 0 0.|1\"",
        &[],
        &["refactor.extract"],
    );
    let text = client.after(ROBOT, &found[0]["edit"]);
    assert!(
        text.contains("<xacro:property name=\"origin_xyz\" value=\"0.1\"/>"),
        "{text}"
    );
    assert!(text.contains("xyz=\"0 0 ${origin_xyz}\""), "{text}");
}

#[test]
fn f27_a_macro_has_one_caller_with_two_calls() {
    let mut client = both();
    let items = client.request(
        "textDocument/prepareCallHierarchy",
        client.at(UNIT, "name=\"un|it\""),
    );
    let calls = client.request("callHierarchy/incomingCalls", json!({ "item": items[0] }));
    assert_eq!(calls.as_array().unwrap().len(), 1, "{calls}");
    assert_eq!(calls[0]["fromRanges"].as_array().unwrap().len(), 2);
}

#[test]
fn f31_settings_of_a_wrong_type_are_told_once_and_unknown_ones_are_logged() {
    let settings = json!({ "diagnostics": { "delay": "soon" }, "nonsense": 7 });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            settings,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    let said = |client: &mut Client, method: &str, text: &str| {
        client.request("xacro/roots", client.of(ROBOT));
        let said = client.notes.iter().filter(|note| note["method"] == method);
        said.filter(|note| note["params"]["message"].as_str().unwrap().contains(text))
            .count()
    };
    assert!(
        client.eventually(|client| said(client, "window/showMessage", "diagnostics.delay") == 1)
    );
    assert!(client.eventually(|client| said(client, "window/logMessage", "nonsense") >= 1));
    // asked again, it is not said again
    client.notify(
        "workspace/didChangeConfiguration",
        json!({ "settings": {} }),
    );
    let asked = |client: &mut Client| {
        client.request("xacro/roots", client.of(ROBOT));
        client
            .asked
            .iter()
            .filter(|asked| asked["method"] == "workspace/configuration")
            .count()
            >= 2
    };
    assert!(client.eventually(asked));
    assert_eq!(
        said(&mut client, "window/showMessage", "diagnostics.delay"),
        1
    );
}

#[test]
fn f31_folders_come_and_go_and_single_files_are_served() {
    let mut client = Client::with(
        fresh_folder(),
        Options {
            no_folder: true,
            ..Options::default()
        },
    );
    write(
        &client.folder,
        "one.urdf.xacro",
        ROBOT_TEXT.replace("unit.xacro", "none.xacro"),
    );
    client.open("one.urdf.xacro");
    assert!(!client.findings("one.urdf.xacro").is_empty());
    let lens = "pkg/urdf/lens.xacro";
    write(
        &client.folder,
        lens,
        "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:macro name=\"far\"/></robot>",
    );
    let folder = json!({ "uri": client.uri("pkg"), "name": "pkg" });
    let found = |client: &mut Client| {
        client
            .request("workspace/symbol", json!({ "query": "far" }))
            .as_array()
            .unwrap()
            .len()
    };
    assert_eq!(found(&mut client), 0);
    let event = json!({ "event": { "added": [folder], "removed": [] } });
    client.notify("workspace/didChangeWorkspaceFolders", event);
    assert!(client.eventually(|client| found(client) == 1));
    let event = json!({ "event": { "added": [], "removed": [folder] } });
    client.notify("workspace/didChangeWorkspaceFolders", event);
    assert!(client.eventually(|client| found(client) == 0));
}

#[test]
fn f33_a_broken_robot_is_expanded_as_far_as_it_goes() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<cut name=\"");
    let expanded = client.request("xacro/expand", client.of(UNIT));
    assert_eq!(expanded["ok"], false);
    assert_eq!(expanded["errors"][0]["location"]["uri"], client.uri(ROBOT));
    client.edit(ROBOT, "<cut name=\"", "</robot>");
    let expanded = client.request("xacro/expand", client.of(UNIT));
    assert_eq!(expanded["root"]["uri"], client.uri(ROBOT));
    assert_eq!(expanded["ok"], true, "{expanded}");
}

#[test]
fn f35_what_a_place_came_from_made_that_place() {
    let mut client = both();
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    let urdf = expanded["urdf"].as_str().unwrap().to_owned();
    let start = urdf.find("<robot").unwrap();
    for at in (start..urdf.len())
        .step_by(7)
        .filter(|at| urdf.is_char_boundary(*at))
    {
        let place = position(&urdf, at);
        let answer = client.request(
            "xacro/toSource",
            json!({ "root": client.uri(ROBOT), "position": place }),
        );
        let Some(origin) = answer["locations"].get(0) else {
            continue;
        };
        let params = json!({ "textDocument": { "uri": origin["uri"] }, "position": origin["range"]["start"] });
        let back = client.request("xacro/toExpanded", params);
        let holds = |instance: &Value| {
            let range = &instance["range"];
            offset(&urdf, &range["start"]) <= at && at <= offset(&urdf, &range["end"])
        };
        assert!(
            back["instances"].as_array().unwrap().iter().any(holds),
            "{at} {origin} {back}"
        );
    }
}
