//! Launch files and configurations with any text, at any place: they come from strangers.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, pan_tilt, write};

const FOLDER: &str = "src/pan_tilt/launch";

/// Texts by name, to be cut and mixed.
const TEXTS: [(&str, &str); 6] = [
    (
        "a.launch.py",
        "path = [FindPackageShare('pan_tilt'), '/urdf/pan_tilt.urdf.xacro']\nm = DeclareLaunchArgument('mount', choices=['desk'])\n\
         r = Command(['xacro ', *path, ' mount:=', LaunchConfiguration('mount')])\nxacro.process_file('é', mappings={'mount': 'x'})\n",
    ),
    (
        "b.launch",
        "<launch><arg name=\"mount\" default=\"pole\"/><param name=\"robot_description\" command=\"$(find xacro)/xacro \
         $(find pan_tilt)/urdf/pan_tilt.urdf.xacro mount:=$(arg mount) 𝛼:=1\"/></launch>\n",
    ),
    (
        "c.launch.xml",
        "<launch><let name=\"m\" value=\"wall\"/><node><param value=\"$(command 'xacro \
         $(find-pkg-share pan_tilt)/urdf/pan_tilt.urdf.xacro mount:=$(var m)')\"/></node></launch>\n",
    ),
    (
        "d.sh",
        "cd $(rospack find pan_tilt)/urdf\nxacro pan_tilt.urdf.xacro mount:=\"$1\" other:='a b' \\\n > r.urdf\n",
    ),
    (
        "e.launch.yaml",
        "launch:\n- param: {value: \"$(command 'xacro a.xacro mount:=b')\"}\n# xacro pan_tilt.urdf.xacro mount:=a\n",
    ),
    (
        "xacro-lint.toml",
        "[[roots]]\nfile = \"src/pan_tilt/urdf/pan_tilt.urdf.xacro\"\nargs = { mount = [\"desk\", \"wall\"] }\n\
         [[roots.expect]]\nlinks = [\"pan_body\"]\n",
    ),
];

/// Numbers that look random and are the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 33) % below.max(1) as u64) as usize
    }

    /// A piece of a text.
    fn piece(&mut self, text: &str) -> String {
        let letters: Vec<char> = text.chars().collect();
        let start = self.roll(letters.len());
        let end = start + self.roll(40);
        letters
            .get(start..end.min(letters.len()))
            .unwrap_or_default()
            .iter()
            .collect()
    }
}

/// A text with pieces cut out and pieces of all texts thrown in.
fn changed(text: &str, dice: &mut Dice) -> String {
    let mut text = text.to_owned();
    for _ in 0..1 + dice.roll(4) {
        let letters: Vec<char> = text.chars().collect();
        let start = dice.roll(letters.len() + 1);
        let end = if dice.roll(2) == 0 {
            start
        } else {
            (start + dice.roll(20)).min(letters.len())
        };
        let (_, other) = TEXTS[dice.roll(TEXTS.len())];
        let new = dice.piece(other);
        text = letters[..start].iter().collect::<String>()
            + &new
            + &letters[end..].iter().collect::<String>();
    }
    text
}

fn file(name: &str) -> String {
    if name.ends_with(".toml") {
        name.to_owned()
    } else {
        format!("{FOLDER}/{name}")
    }
}

#[test]
fn requests_at_any_place_of_any_launch_file_are_answered() {
    const METHODS: [&str; 13] = [
        "hover",
        "completion",
        "definition",
        "declaration",
        "typeDefinition",
        "references",
        "prepareRename",
        "rename",
        "documentHighlight",
        "signatureHelp",
        "codeAction",
        "documentSymbol",
        "formatting",
    ];
    let folder = pan_tilt();
    TEXTS
        .iter()
        .for_each(|(name, text)| write(&folder, &file(name), text));
    let mut client = Client::with(folder, Options::default());
    client.open(ROBOT);
    TEXTS.iter().for_each(|(name, _)| client.open(&file(name)));
    let mut dice = Dice(7);
    for _ in 0..60 {
        let (name, text) = TEXTS[dice.roll(TEXTS.len())];
        let (name, text) = (file(name), changed(text, &mut dice));
        let params = json!({
            "textDocument": { "uri": client.uri(&name), "version": 1000 + dice.roll(1000) },
            "contentChanges": [{ "text": text }],
        });
        client.notify("textDocument/didChange", params);
        for _ in 0..6 {
            let line = dice.roll(text.lines().count() + 2);
            let width = text
                .lines()
                .nth(line)
                .map_or(0, |line| line.encode_utf16().count());
            let position = json!({ "line": line, "character": dice.roll(width + 3) });
            let params = json!({
                "textDocument": { "uri": client.uri(&name) }, "position": position, "newName": "holder",
                "context": { "includeDeclaration": true, "diagnostics": [] },
                "range": { "start": position, "end": position }, "options": { "tabSize": 2, "insertSpaces": true },
            });
            let method = METHODS[dice.roll(METHODS.len())];
            let id = client.post(&format!("textDocument/{method}"), params);
            let reply = client.reply(id);
            let code = reply["error"]["code"].as_i64();
            assert_ne!(
                code,
                Some(-32603),
                "{method} at {position} of {text:?}: {reply}"
            );
        }
    }
    let said = |note: &&Value| {
        note["params"]["message"]
            .as_str()
            .is_some_and(|text| text.contains("internal error"))
    };
    assert_eq!(client.notes.iter().find(said), None);
    // it still knows the calls
    let (name, text) = TEXTS[1];
    let params = json!({
        "textDocument": { "uri": client.uri(&file(name)), "version": 5000 }, "contentChanges": [{ "text": text }],
    });
    client.notify("textDocument/didChange", params);
    let hover = client.request("textDocument/hover", client.at(ROBOT, "$(arg mo|unt)\"/>"));
    assert!(
        hover["contents"]["value"]
            .as_str()
            .unwrap()
            .contains("pole"),
        "{hover}"
    );
}
