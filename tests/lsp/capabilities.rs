//! Answers follow what the client can do: one that can nothing, and ones that lack one thing each.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, UNIT, pan_tilt};

/// Everything that tests speak for, and nothing.
const ALL: &str = "";

fn without(pointers: &[&'static str]) -> Client {
    let mut client = Client::with(
        pan_tilt(),
        Options {
            without: pointers.to_vec(),
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.open(UNIT);
    client
}

fn offered(pointers: &[&'static str]) -> Value {
    let options = Options {
        without: pointers.to_vec(),
        ..Options::default()
    };
    Client::spawn(pan_tilt(), options).initialize()["capabilities"].clone()
}

/// Parameters of a request about the name of the macro at one of its calls.
fn call(client: &Client) -> Value {
    client.at(ROBOT, "<xacro:un|it name=\"tilt\"")
}

/// The answers to the main requests, none of which fails.
fn answers(client: &mut Client) -> Vec<(&'static str, Value)> {
    let (at, file) = (call(client), client.of(ROBOT));
    let with = |params: &Value, more: Value| {
        let mut params = params.clone();
        for (key, value) in more.as_object().unwrap() {
            params[key] = value.clone();
        }
        params
    };
    let range = json!({ "start": at["position"], "end": at["position"] });
    let whole =
        json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let requests = [
        ("textDocument/hover", at.clone()),
        ("textDocument/completion", at.clone()),
        ("textDocument/signatureHelp", at.clone()),
        ("textDocument/definition", at.clone()),
        (
            "textDocument/declaration",
            client.at(UNIT, "xyz=\"${ax|is}\""),
        ),
        (
            "textDocument/typeDefinition",
            client.at(ROBOT, "name=\"c|am\""),
        ),
        ("textDocument/implementation", at.clone()),
        (
            "textDocument/references",
            with(&at, json!({ "context": { "includeDeclaration": true } })),
        ),
        ("textDocument/documentHighlight", at.clone()),
        ("textDocument/documentSymbol", file.clone()),
        ("textDocument/foldingRange", file.clone()),
        (
            "textDocument/inlayHint",
            with(&file, json!({ "range": whole })),
        ),
        ("textDocument/codeLens", file.clone()),
        (
            "textDocument/codeAction",
            with(
                &file,
                json!({ "range": range, "context": { "diagnostics": [] } }),
            ),
        ),
        (
            "textDocument/rename",
            with(&at, json!({ "newName": "motor" })),
        ),
    ];
    requests
        .map(|(method, params)| (method, client.request(method, params)))
        .into()
}

fn answer(client: &mut Client, method: &str) -> Value {
    let found = answers(client)
        .into_iter()
        .find(|(asked, _)| asked.ends_with(method));
    found.unwrap_or_else(|| panic!("`{method}` is asked for")).1
}

#[test]
fn each_capability_may_be_missing() {
    for pointer in [
        ALL,
        "/workspace/applyEdit",
        "/textDocument/definition",
        "/textDocument/declaration",
        "/textDocument/typeDefinition",
        "/textDocument/implementation",
        "/textDocument/hover",
        "/textDocument/completion",
        "/textDocument/signatureHelp",
        "/textDocument/documentSymbol",
        "/textDocument/codeAction",
        "/textDocument/rename",
        "/experimental",
    ] {
        let mut client = without(&[pointer]);
        for (method, answer) in answers(&mut client) {
            let text = answer.to_string();
            let plain =
                pointer == ALL || pointer == "/textDocument/hover" && method.ends_with("hover");
            assert!(!plain || !text.contains("**"), "{pointer} {method}: {text}");
            let own = pointer == ALL || pointer == "/experimental";
            assert!(
                !own || !text.contains("xacro-expanded:"),
                "{pointer} {method}: {text}"
            );
        }
        client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
        assert_eq!(
            client.findings(ROBOT),
            ["8:76-78 undefined-property"],
            "{pointer}"
        );
    }
}

#[test]
fn texts_are_plain_where_no_markdown_is_shown() {
    let markdown = answer(&mut without(&[]), "hover")["contents"].clone();
    assert_eq!(markdown["kind"], "markdown");
    assert!(
        markdown["value"]
            .as_str()
            .unwrap()
            .starts_with("**macro** `unit"),
        "{markdown}"
    );
    let plaintext = json!({ "textDocument": { "hover": { "contentFormat": ["plaintext"] } } });
    let only = Options {
        capabilities: plaintext,
        ..Options::default()
    };
    let mut only = Client::with(pan_tilt(), only);
    only.open(ROBOT);
    for mut client in [without(&["/textDocument/hover/contentFormat"]), only] {
        let at = call(&client);
        let plain = client.request("textDocument/hover", at)["contents"].clone();
        assert_eq!(plain["kind"], "plaintext");
        let text = plain["value"].as_str().unwrap();
        assert!(
            text.starts_with("macro unit") && !text.contains('`') && !text.contains("**"),
            "{text}"
        );
    }
}

#[test]
fn documentation_is_plain_where_no_markdown_is_shown() {
    for (pointer, expected) in [
        ("/textDocument/completion", "string"),
        ("/textDocument/signatureHelp", "markdown"),
    ] {
        let mut client = without(&[pointer]);
        client.edit(
            ROBOT,
            "</robot>",
            "<link name=\"${sin(1)}\"/><xacro:unit \n</robot>",
        );
        let at = client.at(ROBOT, "${si|n(1)");
        let found = client.request("textDocument/completion", at);
        let item = found["items"]
            .as_array()
            .unwrap()
            .iter()
            .find(|item| item["label"] == "sin")
            .unwrap();
        let docs = client.request("completionItem/resolve", item.clone())["documentation"].clone();
        let form = docs["kind"].as_str().unwrap_or("string");
        assert_eq!(form, expected, "{docs}");
        assert_eq!(
            docs.to_string().contains("```"),
            expected == "markdown",
            "{docs}"
        );
        let at = client.at(ROBOT, "<xacro:unit |\n");
        let docs =
            client.request("textDocument/signatureHelp", at)["signatures"][0]["documentation"]
                .clone();
        assert_eq!(docs.is_string(), expected == "markdown", "{docs}");
    }
}

#[test]
fn links_are_answered_where_the_request_takes_them() {
    for (method, key) in [
        ("definition", "/textDocument/definition/linkSupport"),
        ("declaration", "/textDocument/declaration/linkSupport"),
        ("typeDefinition", "/textDocument/typeDefinition/linkSupport"),
        ("implementation", "/textDocument/implementation/linkSupport"),
    ] {
        let found = answers(&mut without(&[key]));
        for (asked, answer) in found {
            let is_link = ["finition", "claration", "Definition", "plementation"]
                .iter()
                .any(|end| asked.ends_with(end))
                .then(|| !answer[0]["targetUri"].is_null());
            assert_eq!(
                is_link,
                is_link.map(|_| !asked.ends_with(&format!("/{method}"))),
                "{asked}: {answer}"
            );
        }
    }
}

#[test]
fn symbols_are_flat_where_no_tree_is_shown() {
    let mut client = without(&["/textDocument/documentSymbol"]);
    let found = client.request("textDocument/documentSymbol", client.of(UNIT));
    let shown: Vec<String> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|symbol| {
            let line = symbol["location"]["range"]["start"]["line"]
                .as_u64()
                .unwrap()
                + 1;
            let inside = symbol["containerName"].as_str().unwrap_or("-");
            format!("{line} {} in {inside}", symbol["name"].as_str().unwrap())
        })
        .collect();
    assert_eq!(
        shown,
        ["3 unit in -", "4 ${name}_body in unit", "5 ${name} in unit"]
    );
    assert_eq!(found[0]["location"]["uri"], client.uri(UNIT));
}

#[test]
fn actions_are_commands_where_nothing_else_is_taken() {
    assert_eq!(
        offered(&["/textDocument/codeAction"])["codeActionProvider"],
        true
    );
    let mut client = without(&["/textDocument/codeAction"]);
    client.edit(ROBOT, "${m0 / 3}", "${m_0}");
    let found = super::actions::fixes(&mut client, ROBOT, "undefined-property");
    let command = super::actions::titled(&found, "m0").clone();
    assert!(
        command["command"].is_string() && command["edit"].is_null(),
        "{command}"
    );
    client.request("workspace/executeCommand", command.clone());
    let asked = |client: &mut Client| {
        client
            .asked
            .iter()
            .find(|asked| asked["method"] == "workspace/applyEdit")
            .cloned()
    };
    let asked = client.wait(asked, || "edits of the action".to_owned());
    assert!(
        client
            .after(ROBOT, &asked["params"]["edit"])
            .contains("0 0 ${m0}")
    );
    // made for a text that is gone
    client.edit(ROBOT, "name=\"m0\"", "name=\"m00\"");
    let id = client.post("workspace/executeCommand", command);
    assert_eq!(client.reply(id)["error"]["code"], -32801);
    // who makes no edits for the server is offered none
    let mut client = without(&["/textDocument/codeAction", "/workspace/applyEdit"]);
    assert_eq!(answer(&mut client, "codeAction"), json!([]));
}

#[test]
fn what_a_client_does_not_ask_for_is_not_offered() {
    assert_eq!(offered(&[])["renameProvider"]["prepareProvider"], true);
    assert_eq!(offered(&["/textDocument/rename"])["renameProvider"], true);
    assert!(
        offered(&[])["implementationProvider"] == true
            && offered(&[])["codeLensProvider"].is_object()
    );
    let nothing = offered(&[ALL]);
    assert!(
        nothing["implementationProvider"].is_null() && nothing["codeLensProvider"].is_null(),
        "{nothing}"
    );
}

#[test]
fn our_own_protocol_is_spoken_with_those_who_know_it() {
    let told = |client: &Client| {
        client
            .notes
            .iter()
            .filter(|note| note["method"] == "xacro/contextChanged")
            .count()
    };
    let mut stranger = without(&["/experimental"]);
    stranger.findings(ROBOT);
    stranger.edit(ROBOT, "value=\"0.15\"", "value=\"0.16\"");
    stranger.findings(ROBOT);
    answers(&mut stranger);
    assert_eq!(told(&stranger), 0);
    assert_eq!(answer(&mut stranger, "implementation"), Value::Null);
    assert_eq!(answer(&mut stranger, "codeLens"), Value::Null);
    // options say the same as capabilities
    let knows = json!({ "contextChanged": true, "lensCommands": true, "expandedDocuments": true });
    for first in [
        json!({ "client": knows }),
        json!({ "xacro": { "client": knows } }),
    ] {
        let options = Options {
            without: vec!["/experimental"],
            first,
            ..Options::default()
        };
        let mut client = Client::with(pan_tilt(), options);
        client.open(ROBOT);
        client.open(UNIT);
        client.wait(
            |client| (told(client) > 0).then_some(()),
            || "context".to_owned(),
        );
        assert!(answer(&mut client, "implementation").is_array());
        assert!(answer(&mut client, "codeLens").as_array().unwrap().len() > 1);
        let warned = client
            .notes
            .iter()
            .filter(|note| note["method"] != "xacro/contextChanged");
        assert_eq!(warned.count(), 0, "{:?}", client.notes);
    }
}

#[test]
fn a_lens_shows_the_preview_where_pages_are_shown() {
    let capabilities = json!({ "window": { "showDocument": { "support": true } } });
    let without = vec!["/experimental"];
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            without,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    let lenses = client.request("textDocument/codeLens", client.of(ROBOT));
    let titles: Vec<&Value> = lenses
        .as_array()
        .unwrap()
        .iter()
        .map(|lens| &lens["command"]["title"])
        .collect();
    assert_eq!(titles, ["Preview"]);
    let answer = client.request("workspace/executeCommand", lenses[0]["command"].clone());
    let asked = |client: &mut Client| {
        client
            .asked
            .iter()
            .find(|asked| asked["method"] == "window/showDocument")
            .cloned()
    };
    let asked = client.wait(asked, || "page to be shown".to_owned());
    assert_eq!(
        (&asked["params"]["uri"], &asked["params"]["external"]),
        (&answer["url"], &json!(true))
    );
}
