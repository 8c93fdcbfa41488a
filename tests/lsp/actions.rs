//! F24: quick fixes, and what the tests of all actions share.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::position;
use super::workspace::{ROBOT, UNIT, pan_tilt, write};

pub const FILE: &str = "src/pan_tilt/urdf/more.urdf.xacro";

/// The actions for a marked text of an open file: `«` and `»` around it, or `|` for the cursor.
#[track_caller]
pub fn actions(
    client: &mut Client,
    file: &str,
    marked: &str,
    diagnostics: &[Value],
    only: &[&str],
) -> Vec<Value> {
    let (start, end) = match marked.split_once('|') {
        Some((before, _)) => (before.len(), before.len()),
        None => {
            let start = marked.find('«').expect("a mark");
            (start, marked.find('»').expect("a mark") - '«'.len_utf8())
        }
    };
    let plain = marked.replace(['«', '»', '|'], "");
    let text = client.text(file).to_owned();
    let at = text
        .find(&plain)
        .unwrap_or_else(|| panic!("`{plain}` in {file}"));
    let mut params = client.of(file);
    params["range"] =
        json!({ "start": position(&text, at + start), "end": position(&text, at + end) });
    params["context"] = json!({ "diagnostics": diagnostics });
    if !only.is_empty() {
        params["context"]["only"] = json!(only);
    }
    let found = client.request("textDocument/codeAction", params);
    found.as_array().cloned().unwrap_or_default()
}

/// The quick fixes of the only finding of a rule.
#[track_caller]
pub fn fixes(client: &mut Client, file: &str, rule: &str) -> Vec<Value> {
    let found = client.diagnostics(file);
    let of_rule: Vec<Value> = found
        .iter()
        .filter(|d| d["code"] == rule)
        .cloned()
        .collect();
    assert!(!of_rule.is_empty(), "{rule} in {found:?}");
    let found = fixes_of(client, file, &of_rule[0]);
    let mut reworded = of_rule[0].clone();
    let words = reworded["message"].as_str().unwrap_or_default();
    reworded["message"] = words.split_inclusive(' ').rev().collect::<String>().into();
    let edits = |actions: &[Value]| -> Vec<(Value, Value)> {
        let of = |action: &Value| (action["title"].clone(), action["edit"].clone());
        actions.iter().map(of).collect()
    };
    let again = fixes_of(client, file, &reworded);
    assert_eq!(
        edits(&again),
        edits(&found),
        "{rule}: the words of a message make no fix"
    );
    found
}

fn fixes_of(client: &mut Client, file: &str, diagnostic: &Value) -> Vec<Value> {
    let mut params = client.of(file);
    params["range"] = diagnostic["range"].clone();
    params["context"] = json!({ "diagnostics": [diagnostic], "only": ["quickfix"] });
    let found = client.request("textDocument/codeAction", params);
    found.as_array().cloned().unwrap_or_default()
}

#[track_caller]
pub fn titled<'a>(actions: &'a [Value], title: &str) -> &'a Value {
    let titles: Vec<&Value> = actions.iter().map(|action| &action["title"]).collect();
    let found = actions
        .iter()
        .find(|action| action["title"].as_str().unwrap().contains(title));
    found.unwrap_or_else(|| panic!("`{title}` in {titles:?}"))
}

/// Open the file, or give it another text.
pub fn show(client: &mut Client, text: &str) {
    match client.is_open(FILE) {
        true => {
            let old = client.text(FILE).to_owned();
            client.edit(FILE, &old, text);
        }
        false => client.open_with(FILE, text),
    }
}

/// A robot with the xacro namespace around some elements.
pub fn robot(content: &str) -> String {
    format!(
        "<robot name=\"🤖\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{content}\n</robot>\n"
    )
}

#[test]
fn a_typo_is_replaced_by_the_suggestion() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m_0}");
    let found = fixes(&mut client, ROBOT, "undefined-property");
    let fix = titled(&found, "m0");
    assert_eq!(fix["kind"], "quickfix");
    assert_eq!(fix["diagnostics"][0]["code"], "undefined-property");
    assert!(client.after(ROBOT, &fix["edit"]).contains("0 0 ${m0}"));
    let made = client.after(ROBOT, &titled(&found, "Add property `m_0`")["edit"]);
    assert!(
        made.contains("  <xacro:property name=\"m_0\" value=\"0\"/>\n  <xacro:unit name=\"tilt\""),
        "{made}"
    );
}

#[test]
fn names_of_unsaved_includes_are_fixed_too() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "name=\"unit\"", "name=\"unitt\"");
    client.edit(ROBOT, "value=\"0.15\"", "value=\"0.16\"");
    let found = fixes(&mut client, ROBOT, "undefined-macro");
    assert!(
        client
            .after(ROBOT, &titled(&found, "unitt")["edit"])
            .contains("<xacro:unitt name=\"pan\"")
    );
    let made = client.after(ROBOT, &titled(&found, "Add macro `unit`")["edit"]);
    assert!(
        made.contains("<xacro:macro name=\"unit\" params=\"name parent *content\"></xacro:macro>"),
        "{made}"
    );
}

#[test]
fn a_macro_of_the_workspace_can_be_included() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "</robot>", "  <xacro:lens prefix=\"a\"/>\n</robot>");
    let found = fixes(&mut client, ROBOT, "undefined-macro");
    let made = client.after(
        ROBOT,
        &titled(&found, "$(find lens)/urdf/lens.xacro")["edit"],
    );
    let expected = "  <xacro:include filename=\"$(find lens)/urdf/lens.xacro\"/>\n  <xacro:lens prefix=\"a\"/>\n</robot>";
    assert!(made.contains(expected), "{made}");
}

#[test]
fn missing_things_are_created_where_they_are_missed() {
    let mut client = Client::start();
    for (content, rule, title, expected) in [
        (
            "  <link name=\"$(arg side)\"/>",
            "undefined-arg",
            "Add argument `side`",
            "xacro\">\n  <xacro:arg name=\"side\" default=\"\"/>\n  <link",
        ),
        (
            "  <link name=\"a\"/>\n  <joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"tool\"/></joint>",
            "undefined-link",
            "Add link `tool`",
            "  <link name=\"tool\"/>\n  <joint",
        ),
        (
            "  <link name=\"a\"/>\n  <link name=\"b\"/>\n  <joint name=\"j\" type=\"revolute\">\n    <parent link=\"a\"/><child link=\"b\"/>\n  </joint>",
            "missing-joint-limit",
            "Add `limit`",
            "<child link=\"b\"/>\n    <limit lower=\"0\" upper=\"0\" effort=\"0\" velocity=\"0\"/>\n  </joint>",
        ),
        (
            "  <link name=\"a\"><visual><geometry><sphere/></geometry></visual></link>",
            "missing-attribute",
            "Add `radius`",
            "<sphere radius=\"\"/>",
        ),
        (
            "  <xacro:macro name=\"m\" params=\"a\">\n    <link name=\"${a}${prefix}\"/>\n  </xacro:macro>\n  <xacro:m a=\"x\"/>",
            "undefined-property",
            "Add parameter `prefix` to macro `m`",
            "params=\"a prefix\"",
        ),
    ] {
        show(&mut client, &robot(content));
        let found = fixes(&mut client, FILE, rule);
        let made = client.after(FILE, &titled(&found, title)["edit"]);
        assert!(made.contains(expected), "{made}");
    }
}

#[test]
fn broken_syntax_is_fixed() {
    let mut client = Client::start();
    for (content, title, expected) in [
        (
            "<link name=\"a\"></lnk>",
            "Change end tag to `link`",
            "<link name=\"a\"></link>",
        ),
        (
            "<link name=\"a\" name=\"b\"/>",
            "Remove duplicate `name`",
            "<link name=\"a\"/>",
        ),
        (
            "<link name=\"a < b\"/>",
            "Replace with `&lt;`",
            "<link name=\"a &lt; b\"/>",
        ),
        (
            "<link name=\"a & b\"/>",
            "Replace with `&amp;`",
            "<link name=\"a &amp; b\"/>",
        ),
        (
            "<link name=\"a\"><visual></link>",
            "Add `</visual>`",
            "<visual></visual></link>",
        ),
    ] {
        show(&mut client, &robot(content));
        let found = fixes(&mut client, FILE, "xml-syntax-error");
        let made = client.after(FILE, &titled(&found, title)["edit"]);
        assert!(made.contains(expected), "{made}");
    }
}

#[test]
fn a_finding_can_be_hidden() {
    let mut client = Client::start();
    for (title, expected) in [
        (
            "for this line",
            "\n  <!-- xacro-lint: disable-next-line undefined-link -->\n  <joint",
        ),
        (
            "for this file",
            "<!-- xacro-lint: disable-file undefined-link -->\n<robot",
        ),
    ] {
        // the finding stands at the child: the comment goes in front of its own tag
        show(
            &mut client,
            &robot(
                "  <link name=\"a\"/>\n  <joint name=\"j\" type=\"fixed\">\n  <parent link=\"a\"/>\n  <child link=\"t\"/></joint>",
            ),
        );
        let found = fixes(&mut client, FILE, "undefined-link");
        let made = client.after(FILE, &titled(&found, title)["edit"]);
        assert!(
            made.contains(&expected.replace("<joint", "<child")),
            "{made}"
        );
        show(&mut client, &made);
        let left = client.findings(FILE);
        assert!(
            !left.iter().any(|found| found.contains("undefined-link")),
            "{left:?}"
        );
    }
}

#[test]
fn all_safe_fixes_are_made_at_once() {
    let mut client = Client::start();
    let joint = |name: &str, child: &str| {
        format!(
            "  <joint name=\"{name}\" type=\"revolute\">\n    <parent link=\"a\"/><child link=\"{child}\"/>\
             <limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>\n  </joint>\n"
        )
    };
    // what would change the robot is no part of it
    let switch = "  <xacro:property name=\"q\" value=\"true\"/><xacro:if value=\"${q == 'true'}\"><link name=\"d\"/></xacro:if>\n";
    let content = format!(
        "  <link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\n{}{}{switch}",
        joint("é", "b"),
        joint("k", "c")
    );
    show(&mut client, &robot(&content));
    client.diagnostics(FILE);
    let found = actions(&mut client, FILE, "|<robot", &[], &["source.fixAll"]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0]["kind"], "source.fixAll.xacro");
    let made = client.after(FILE, &found[0]["edit"]);
    assert_eq!(made.matches("<axis xyz=\"1 0 0\"/>").count(), 2, "{made}");
    assert!(made.contains("q == 'true'"), "{made}");
    let fix = fixes(&mut client, FILE, "missing-axis");
    assert_eq!(titled(&fix, "1 0 0")["isPreferred"], true);
    let fix = fixes(&mut client, FILE, "string-bool-comparison");
    assert_eq!(titled(&fix, "Replace with `q`")["isPreferred"], Value::Null);
    assert!(
        actions(&mut client, FILE, "|<robot", &[], &[])
            .iter()
            .all(|a| a["kind"] != "source.fixAll.xacro")
    );
}

#[test]
fn what_a_client_makes_up_does_no_harm() {
    let mut client = Client::start();
    client.open(ROBOT);
    let edit = json!({ "uri": "file:///etc/passwd", "newText": "x",
        "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 9, "character": 0 } } });
    let data = json!({ "title": "boo", "safety": "safe", "edits": [edit] });
    let range =
        json!({ "start": { "line": 2, "character": 0 }, "end": { "line": 2, "character": 9 } });
    let forged = |code: Value, data: Value| json!({ "range": range, "message": "m", "source": "xacro", "code": code, "data": data });
    let all = [
        forged(json!("undefined-property"), data.clone()),
        forged(json!("-->"), data.clone()),
        forged(json!(7), json!(null)),
        json!({ "range": { "start": { "line": 4_000_000_000_u32, "character": 9 }, "end": { "line": 0, "character": 0 } },
            "message": "", "source": "xacro", "code": "undefined-arg", "data": [1] }),
    ];
    let found = actions(&mut client, ROBOT, "|<robot", &all, &["quickfix"]);
    assert_eq!(found, Vec::<Value>::new());
}

#[test]
fn a_rule_can_be_switched_off_for_the_project() {
    let folder = pan_tilt();
    write(&folder, "xacro-lint.toml", "ignore = [\"STY\"]\n");
    let mut client = Client::with(folder, Options::default());
    show(&mut client, &robot("  <link name=\"${nothing}\"/>"));
    let found = fixes(&mut client, FILE, "undefined-property");
    let changes =
        &titled(&found, "for this project")["edit"]["changes"][client.uri("xacro-lint.toml")];
    assert_eq!(changes[0]["newText"], "\"undefined-property\", ");
    assert_eq!(
        changes[0]["range"]["start"],
        json!({ "line": 0, "character": 10 })
    );
}

#[test]
fn a_rule_can_be_configured_in_a_file_that_is_made_for_it() {
    let makes =
        json!({ "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create"] } });
    let options = || Options {
        capabilities: json!({ "workspace": makes }),
        ..Options::default()
    };
    let mut client = Client::with(pan_tilt(), options());
    show(&mut client, &robot("  <link name=\"${nothing}\"/>"));
    let found = fixes(&mut client, FILE, "undefined-property");
    let config = client.uri("xacro-lint.toml");
    for (title, text) in [
        (
            "Disable `undefined-property` for this project",
            "ignore = [\"undefined-property\"]\n",
        ),
        (
            "Configure `undefined-property` as warning for this project",
            "[severity]\nundefined-property = \"warning\"\n",
        ),
    ] {
        let changes = &titled(&found, title)["edit"]["documentChanges"];
        assert_eq!(changes[0], json!({ "kind": "create", "uri": config }));
        assert_eq!(changes[1]["textDocument"]["uri"], json!(config));
        assert_eq!(changes[1]["edits"][0]["newText"], text);
    }
    // a file that is there keeps what it says
    let folder = pan_tilt();
    let old = "# ours\ntarget = \"ros2\"\n\n[severity]\nzero-mass = \"info\" # toys\n";
    write(&folder, "xacro-lint.toml", old);
    let mut client = Client::with(folder, options());
    show(&mut client, &robot("  <link name=\"${nothing}\"/>"));
    let found = fixes(&mut client, FILE, "undefined-property");
    let changes = &titled(&found, "as warning for this project")["edit"]["documentChanges"];
    let edit = &changes[0]["edits"][0];
    assert_eq!(edit["newText"], "undefined-property = \"warning\"\n");
    assert_eq!(edit["range"]["start"], json!({ "line": 4, "character": 0 }));
    // the settings of an editor take precedence
    let mut client = Client::with(
        pan_tilt(),
        Options {
            settings: json!({ "severity": { "undefined-property": "warning" } }),
            ..options()
        },
    );
    show(&mut client, &robot("  <link name=\"${nothing}\"/>"));
    let found = fixes(&mut client, FILE, "undefined-property");
    let _ = titled(
        &found,
        "as info for this project (overridden here by the editor's `severity` setting)",
    );
    // clients that make no files are offered nothing that they cannot do
    let mut client = Client::start();
    show(&mut client, &robot("  <link name=\"${nothing}\"/>"));
    let found = fixes(&mut client, FILE, "undefined-property");
    let offers = |action: &serde_json::Value| {
        action["title"]
            .as_str()
            .unwrap()
            .ends_with("for this project")
    };
    assert!(!found.iter().any(offers), "{found:?}");
}
