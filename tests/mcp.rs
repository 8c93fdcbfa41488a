//! `xacro-lint mcp`: what a coding assistant sends, and what it is answered.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

const ARM: &str = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="reach" default="0.5"/>
  <link name="base"><visual><geometry><box size="0.1 0.1 $(arg reach)"/></geometry></visual></link>
  <link name="tip"/>
  <joint name="turn" type="Revolute">
    <parent link="base"/>
    <child link="tip"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"#;

/// A folder with a robot whose joint has a misspelled type.
fn arm(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("mcp")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join(".git")).unwrap();
    fs::write(folder.join("arm.urdf.xacro"), ARM).unwrap();
    folder
}

/// Send lines to a server for a folder; its answers.
fn answers(folder: &Path, lines: &[String]) -> Vec<Value> {
    let env = Environment {
        vars: BTreeMap::from([
            ("ROS_DISTRO".to_owned(), "jazzy".to_owned()),
            ("TOKEN".to_owned(), "S3CRET".to_owned()),
        ]),
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut input = lines
        .iter()
        .flat_map(|line| format!("{line}\n").into_bytes());
    let input: Vec<u8> = input.by_ref().collect();
    let mut stdin = input.as_slice();
    let code = cli::run(
        &["mcp".to_owned()],
        &env,
        &mut Io::plain(&mut out, &mut err, &mut stdin),
    );
    assert_eq!((code, String::from_utf8(err).unwrap().as_str()), (0, ""));
    let out = String::from_utf8(out).unwrap();
    out.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

fn call(tool: &str, arguments: Value) -> String {
    let params = json!({ "name": tool, "arguments": arguments });
    json!({ "jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": params }).to_string()
}

/// The answer of a tool: whether it is an error, and its text.
fn check_tool(folder: &Path, tool: &str, arguments: Value) -> (bool, String) {
    let answer = answers(folder, &[call(tool, arguments)]).remove(0);
    let result = &answer["result"];
    let texts = result["content"].as_array().unwrap();
    let texts: Vec<&str> = texts
        .iter()
        .filter_map(|part| part["text"].as_str())
        .collect();
    (result["isError"].as_bool().unwrap(), texts.join("\n"))
}

#[test]
fn a_session() {
    let folder = arm("session");
    let lines = [
        r#"{"jsonrpc":"2.0","id":"a","method":"initialize","params":{"protocolVersion":"2025-06-18","capabilities":{},"clientInfo":{"name":"t","version":"1"}}}"#,
        r#"{"jsonrpc":"2.0","method":"notifications/initialized"}"#,
        "",
        r#"{"jsonrpc":"2.0","id":2,"method":"ping"}"#,
        r#"{"jsonrpc":"2.0","id":3,"method":"tools/list","params":{}}"#,
    ];
    let answers = answers(&folder, &lines.map(str::to_owned));
    assert_eq!(answers.len(), 3, "{answers:?}");
    assert_eq!(answers[0]["id"], "a");
    assert_eq!(answers[0]["result"]["protocolVersion"], "2025-06-18");
    assert_eq!(answers[0]["result"]["serverInfo"]["name"], "xacro-lint");
    assert_eq!(answers[1]["result"], json!({}));
    let tools = answers[2]["result"]["tools"].as_array().unwrap();
    let names: Vec<&str> = tools
        .iter()
        .map(|tool| tool["name"].as_str().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "check",
            "explain",
            "fix_diff",
            "expand",
            "tree",
            "consumers",
            "render"
        ]
    );
    for tool in tools {
        assert_eq!(tool["annotations"]["readOnlyHint"], true);
        let properties = tool["inputSchema"]["properties"].as_object().unwrap();
        assert!(
            properties
                .values()
                .all(|own| own["description"].is_string())
        );
    }
}

#[test]
fn a_version_that_is_not_known_is_answered_by_the_newest() {
    let line = r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"1999-01-01"}}"#;
    let answers = answers(&arm("version"), &[line.to_owned()]);
    assert_eq!(answers[0]["result"]["protocolVersion"], "2025-11-25");
}

#[test]
fn each_tool_says_what_its_command_prints() {
    let folder = arm("tools");
    let robot = json!({ "file": "arm.urdf.xacro", "args": { "reach": 0.75 } });
    let (is_error, found) = check_tool(&folder, "check", json!({}));
    let found: Value = serde_json::from_str(&found).unwrap();
    let errors: Vec<&Value> = found
        .as_array()
        .unwrap()
        .iter()
        .filter(|own| own["severity"] == "error")
        .collect();
    assert!(!is_error && errors.len() == 1, "{found:#}");
    assert_eq!(
        (&errors[0]["name"], &errors[0]["location"]["row"]),
        (&json!("unknown-joint-type"), &json!(5))
    );
    for (tool, arguments, expected) in [
        (
            "check",
            json!({ "paths": ["arm.urdf.xacro"], "select": ["zero-axis"] }),
            "[]",
        ),
        ("explain", json!({ "rule": "zero-axis" }), "zero-axis"),
        (
            "fix_diff",
            json!({ "unsafe_fixes": true }),
            "+  <joint name=\"turn\" type=\"revolute\">",
        ),
        ("expand", robot.clone(), "0.1 0.1 0.75"),
    ] {
        let (is_error, text) = check_tool(&folder, tool, arguments);
        assert!(!is_error && text.contains(expected), "{tool}: {text}");
    }
    assert_eq!(
        fs::read_to_string(folder.join("arm.urdf.xacro")).unwrap(),
        ARM
    );
    fs::write(
        folder.join("arm.urdf.xacro"),
        ARM.replace("Revolute", "revolute"),
    )
    .unwrap();
    for (tool, expected) in [("tree", "\"tip\""), ("consumers", "\"mujoco\"")] {
        let (is_error, text) = check_tool(&folder, tool, robot.clone());
        assert!(!is_error && text.contains(expected), "{tool}: {text}");
    }
}

#[test]
fn a_picture_is_seen_and_not_written() {
    let folder = arm("picture");
    let joint = ARM.replace("Revolute", "revolute");
    fs::write(folder.join("arm.urdf.xacro"), joint).unwrap();
    let asked = json!({ "file": "arm.urdf.xacro", "view": "front", "joints": { "turn": "30deg" } });
    let answer = answers(&folder, &[call("render", asked)]).remove(0);
    let picture = &answer["result"]["content"][0];
    assert_eq!(
        (&picture["type"], &picture["mimeType"]),
        (&json!("image"), &json!("image/png"))
    );
    // the signature of PNG in base64
    assert!(picture["data"].as_str().unwrap().starts_with("iVBORw0KGgo"));
    let names = fs::read_dir(&folder).unwrap();
    assert_eq!(names.count(), 2, "the robot and .git");
}

#[test]
fn mistakes_are_said() {
    let folder = arm("mistakes");
    for (tool, arguments, expected) in [
        (
            "check",
            json!({ "path": ["."] }),
            "unknown argument `path` of `check`: it has `paths`, `args`, `select`, `for`",
        ),
        (
            "check",
            json!({ "paths": "." }),
            "argument `paths` must be an array of texts",
        ),
        ("check", json!([]), "arguments must be an object"),
        ("check", json!({ "select": ["nonsense"] }), "nonsense"),
        (
            "expand",
            json!({}),
            "argument `file` of `expand` is missing",
        ),
        (
            "expand",
            json!({ "file": "none.xacro" }),
            "cannot read `none.xacro`",
        ),
        (
            "expand",
            json!({ "file": "arm.urdf.xacro", "args": { "reach": [1] } }),
            "argument `args` must have texts, numbers or booleans as values",
        ),
        ("explain", json!({ "rule": "zero-axes" }), "zero-axes"),
        (
            "render",
            json!({ "file": "arm.urdf.xacro", "view": "back" }),
            "argument `view` must be one of `iso`, `front`, `side`, `top`",
        ),
        (
            "tree",
            json!({ "file": "arm.urdf.xacro", "args": { "-o": "x" } }),
            "argument `args` must be an object whose names do not start with `-`",
        ),
    ] {
        let (is_error, text) = check_tool(&folder, tool, arguments.clone());
        assert!(
            is_error && text.contains(expected),
            "{tool} {arguments}: {text}"
        );
    }
}

#[test]
fn whatever_comes_in_is_answered_or_is_none_of_our_business() {
    let folder = arm("protocol");
    let deep = format!("{}{}", "[".repeat(5000), "]".repeat(5000));
    for (line, code) in [
        ("{", Some(-32700)),
        (&deep, Some(-32700)),
        ("[]", Some(-32600)),
        ("7", Some(-32600)),
        (
            r#"{"jsonrpc":"2.0","id":1,"method":"tools/none"}"#,
            Some(-32601),
        ),
        (r#"{"jsonrpc":"2.0","id":1,"method":7}"#, Some(-32601)),
        (
            r#"{"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"shell"}}"#,
            Some(-32602),
        ),
        (
            r#"{"jsonrpc":"2.0","id":1,"method":"tools/call"}"#,
            Some(-32602),
        ),
        (r#"{"jsonrpc":"2.0","id":1,"result":{}}"#, None),
        (
            r#"{"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":1}}"#,
            None,
        ),
    ] {
        let ping = r#"{"jsonrpc":"2.0","id":9,"method":"ping"}"#;
        let answers = answers(&folder, &[line.to_owned(), ping.to_owned()]);
        let shown = &line[..line.len().min(80)];
        let codes: Vec<Option<i64>> = answers
            .iter()
            .map(|answer| answer["error"]["code"].as_i64())
            .collect();
        let expected: Vec<Option<i64>> =
            code.iter().map(|&code| Some(code)).chain([None]).collect();
        assert_eq!(codes, expected, "{shown}");
    }
}

#[cfg(unix)]
#[test]
fn nothing_outside_of_the_folder_is_read() {
    let outside = arm("outside");
    fs::write(outside.join("secret.yaml"), "word: S3CRET\n").unwrap();
    fs::write(
        outside.join("secret.xacro"),
        "<robot><link name=\"S3CRET\"/></robot>",
    )
    .unwrap();
    let folder = arm("inside");
    std::os::unix::fs::symlink(&outside, folder.join("linked")).unwrap();
    std::os::unix::fs::symlink(outside.join("secret.xacro"), folder.join("linked.xacro")).unwrap();
    let path = outside.display();
    for (number, body) in [
        format!("<link name=\"${{xacro.load_yaml('{path}/secret.yaml')['word']}}\"/>"),
        "<link name=\"${xacro.load_yaml('linked/secret.yaml')['word']}\"/>".to_owned(),
        format!("<xacro:include filename=\"{path}/secret.xacro\"/>"),
        "<xacro:include filename=\"../outside/secret.xacro\"/>".to_owned(),
        "<xacro:include filename=\"linked/secret.xacro\"/>".to_owned(),
        "<xacro:include filename=\"linked.xacro\"/>".to_owned(),
        "<xacro:include filename=\"../outside/*.xacro\"/>".to_owned(),
        "<link name=\"$(optenv TOKEN none)\"/>".to_owned(),
    ]
    .iter()
    .enumerate()
    {
        let file = format!("r{number}.xacro");
        let text = format!(
            "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">{body}</robot>"
        );
        fs::write(folder.join(&file), text).unwrap();
        for tool in ["expand", "check", "tree", "consumers", "fix_diff"] {
            let arguments = match tool {
                "check" | "fix_diff" => json!({ "paths": [file] }),
                _ => json!({ "file": file }),
            };
            let (_, said) = check_tool(&folder, tool, arguments);
            assert!(!said.contains("S3CRET"), "{tool} of {body}: {said}");
        }
    }
    for asked in [
        format!("{path}/arm.urdf.xacro"),
        "../outside/arm.urdf.xacro".to_owned(),
        "linked/arm.urdf.xacro".to_owned(),
        "/etc/passwd".to_owned(),
    ] {
        let (is_error, said) = check_tool(&folder, "expand", json!({ "file": asked }));
        assert!(
            is_error && said.contains("is outside of"),
            "{asked}: {said}"
        );
        let (is_error, said) = check_tool(&folder, "check", json!({ "paths": [asked] }));
        assert!(
            is_error && said.contains("is outside of"),
            "{asked}: {said}"
        );
    }
    // the same answer whether there is such a file or not
    let said = |name: &str| {
        let (_, said) = check_tool(
            &folder,
            "expand",
            json!({ "file": format!("../outside/{name}") }),
        );
        said.replace(name, "NAME")
    };
    assert_eq!(said("arm.urdf.xacro"), said("none.urdf.xacro"));
}

/// A program that nobody knows is answered with the argument and the names that it takes, not with options of a command line.
#[test]
fn programs_are_named_by_the_argument() {
    let folder = arm("programs");
    for tool in ["check", "consumers"] {
        let mut arguments = json!({ "for": ["gazeboo"] });
        if tool == "consumers" {
            arguments["file"] = json!("arm.urdf.xacro");
        }
        let (is_error, said) = check_tool(&folder, tool, arguments);
        assert!(
            is_error && said.starts_with("argument `for` must be names out of `"),
            "{tool}: {said}"
        );
        assert!(said.contains("`mujoco`") && !said.contains("--"), "{said}");
    }
}
