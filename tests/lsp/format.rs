//! F20: formatting of documents and ranges.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, UNIT_TEXT, pan_tilt, write};

const FILE: &str = "src/pan_tilt/urdf/more.urdf";

fn formatted(client: &mut Client, file: &str, options: &Value) -> String {
    let mut params = client.of(file);
    params["options"] = options.clone();
    let edits = client.request("textDocument/formatting", params);
    client.after_edits(file, edits.as_array().unwrap())
}

fn blanks(count: u32) -> Value {
    json!({ "tabSize": count, "insertSpaces": true })
}

#[test]
fn formatting_twice_is_formatting_once() {
    let mut client = Client::start();
    for (file, text) in [(ROBOT, ROBOT_TEXT), (UNIT, UNIT_TEXT)] {
        for text in [text.to_owned(), text.replace('\n', "\r\n")] {
            client.open_with(file, &text);
            let once = formatted(&mut client, file, &blanks(4));
            assert_ne!(once, text);
            assert_eq!(once.matches("\r\n").count() > 0, text.contains("\r\n"));
            client.open_with(file, &once);
            assert_eq!(formatted(&mut client, file, &blanks(4)), once);
            let squeezed = |text: &str| text.split_whitespace().collect::<String>();
            assert_eq!(squeezed(&once), squeezed(&text));
        }
    }
}

#[test]
fn the_editor_says_how_far_lines_are_indented() {
    let mut client = Client::start();
    client.open_with(
        FILE,
        "<robot name=\"🤖\"><link name=\"é\"/>\n\n\n<!-- é --></robot>",
    );
    for (options, unit) in [
        (blanks(3), "   "),
        (json!({ "tabSize": 4, "insertSpaces": false }), "\t"),
    ] {
        let expected =
            format!("<robot name=\"🤖\">\n{unit}<link name=\"é\"/>\n\n{unit}<!-- é --></robot>");
        // the end tag closes an element with elements in it, and stands alone
        let expected = expected.replace("--></robot>", "-->\n</robot>");
        assert_eq!(formatted(&mut client, FILE, &options), expected);
    }
    // tabs are what an editor asks for by default: blanks stay
    let text = "<robot name=\"🤖\">\n   <link name=\"é\">\n      <visual/>\n   </link>\n</robot>\n";
    client.open_with(ROBOT, text);
    assert_eq!(
        formatted(
            &mut client,
            ROBOT,
            &json!({ "tabSize": 8, "insertSpaces": false })
        ),
        text
    );
}

#[test]
fn a_range_is_formatted_alone() {
    let mut client = Client::start();
    client.open_with(
        FILE,
        "<robot name=\"🤖\">\n<link name=\"a\"/>\n<link   name=\"b\"/>\n<link name=\"c\"/>\n</robot>\n",
    );
    let mut params = client.of(FILE);
    params["options"] = blanks(2);
    params["range"] =
        json!({ "start": { "line": 2, "character": 0 }, "end": { "line": 2, "character": 18 } });
    let edits = client.request("textDocument/rangeFormatting", params);
    let text = client.after_edits(FILE, edits.as_array().unwrap());
    assert_eq!(
        text,
        "<robot name=\"🤖\">\n<link name=\"a\"/>\n  <link name=\"b\"/>\n<link name=\"c\"/>\n</robot>\n"
    );
}

#[test]
fn a_broken_file_is_left_alone() {
    let mut client = Client::start();
    for text in [
        "<robot><link",
        "<robot><a></b></robot>",
        "",
        "<robot>\n<link name=\"a\"/>\n",
    ] {
        client.open_with(FILE, text);
        assert_eq!(formatted(&mut client, FILE, &blanks(2)), text);
    }
}

#[test]
fn the_configuration_counts() {
    let folder = pan_tilt();
    write(
        &folder,
        "xacro-lint.toml",
        "[format]\nself-close = true\nattributes = 'auto'\nline-width = 20\n",
    );
    let mut client = Client::with(folder, Options::default());
    client.open_with(
        FILE,
        "<robot>\n<link name=\"abc\" other=\"abc\"></link>\n</robot>\n",
    );
    let expected = "<robot>\n  <link name=\"abc\"\n        other=\"abc\"/>\n</robot>\n";
    assert_eq!(formatted(&mut client, FILE, &blanks(2)), expected);
}
