//! Blocks that are data: configuration, XML, JSON, YAML.

use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

use crate::pages::{self, Block};

/// Blocks of a language that are not for somebody else.
fn of(language: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = pages::told().iter().flat_map(pages::blocks).collect();
    blocks.retain(|block| block.language == language && block.not_run.is_none());
    blocks.retain(|block| block.remark("run:").is_none());
    assert!(!blocks.is_empty(), "no page shows {language}");
    blocks
}

fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("docs-data")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// What `xacro-lint` prints about a file with the words given.
fn findings(folder: &Path, words: &[&str]) -> String {
    let vars = [(
        "AMENT_PREFIX_PATH".to_owned(),
        folder.join("none").display().to_string(),
    )];
    let env = Environment {
        vars: vars.into(),
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let words: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
    let code = cli::run(
        &words,
        &env,
        &mut Io::plain(&mut out, &mut err, &mut &b""[..]),
    );
    if code == 0 {
        String::new()
    } else {
        String::from_utf8(out).unwrap() + &String::from_utf8(err).unwrap()
    }
}

#[test]
fn configurations_are_valid() {
    // with the arguments that the examples give
    let args = [
        "axles", "length", "prefix", "reach", "robot_ip", "side", "sim",
    ]
    .map(|name| format!("<xacro:arg name=\"{name}\" default=\"\"/>"));
    let robot = format!(
        "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">{}<link name=\"a\"/></robot>\n",
        args.concat()
    );
    let mut wrong = Vec::new();
    for block in of("toml") {
        let folder = scratch("toml");
        fs::write(
            folder.join("robot.urdf"),
            "<robot name=\"r\"><link name=\"a\"/></robot>\n",
        )
        .unwrap();
        fs::write(folder.join("xacro-lint.toml"), &block.text).unwrap();
        let roots = block
            .text
            .lines()
            .filter_map(|line| line.strip_prefix("file = "));
        for file in roots.map(|value| folder.join(value.trim_matches('"'))) {
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, &robot).unwrap();
        }
        let words = [
            "check",
            ".",
            "--extend-select",
            "invalid-config",
            "--format",
            "concise",
        ];
        let said = findings(&folder, &words);
        if !said.is_empty() {
            wrong.push(format!("{}: {said}", block.place));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A file, or a piece of a robot: well-formed, with comments that the linter understands.
#[test]
fn xml_is_well_formed() {
    let mut wrong = Vec::new();
    for block in of("xml") {
        let folder = scratch("xml");
        let whole = ["<robot", "<?xml", "<package"]
            .iter()
            .any(|first| block.text.contains(first));
        let text = if whole {
            block.text.clone()
        } else {
            let namespace = "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";
            format!("<robot name=\"r\" {namespace}>\n{}</robot>\n", block.text)
        };
        if block.text.contains("<package") {
            if let Err(error) = roxmltree::Document::parse(&text) {
                wrong.push(format!("{}: {error}", block.place));
            }
            continue;
        }
        fs::write(folder.join("robot.xacro"), text).unwrap();
        let select = "XML001,unknown-rule-in-suppression,malformed-suppression";
        let said = findings(
            &folder,
            &[
                "check",
                "robot.xacro",
                "--select",
                select,
                "--format",
                "concise",
            ],
        );
        // a file on purpose without its prefix is shown with what is said about it
        if !said.is_empty() && block.remark("file").is_none() {
            wrong.push(format!("{}: {said}", block.place));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn json_can_be_read() {
    for block in of("json") {
        let read: Result<serde_json::Value, _> = serde_json::from_str(&block.text);
        assert!(read.is_ok(), "{}: {}", block.place, read.unwrap_err());
    }
}

#[test]
fn yaml_can_be_read() {
    for block in of("yaml") {
        let read = xacro_lsp::yaml::load(&block.text, "block");
        assert!(read.is_ok(), "{}: {read:?}", block.place);
    }
}
