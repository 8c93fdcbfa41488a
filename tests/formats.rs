//! The forms of the result that other programs read: each holds what its readers require.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing
)] // a test may fail loudly

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde_json::Value;
use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

/// What `check` prints about an example that is broken on purpose.
fn check(format: &str) -> String {
    let cwd = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples/broken_cell");
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        cwd.join("none").display().to_string(),
    )]);
    let (mut out, mut err, mut stdin) = (Vec::new(), Vec::new(), std::io::empty());
    let mut io = Io::plain(&mut out, &mut err, &mut stdin);
    let args = ["check", "--output-format", format].map(str::to_owned);
    assert_eq!(
        cli::run(
            &args,
            &Environment {
                vars,
                cwd,
                ..Environment::default()
            },
            &mut io
        ),
        1
    );
    String::from_utf8(out).unwrap()
}

fn json(format: &str) -> Value {
    serde_json::from_str(&check(format)).unwrap()
}

/// The findings, from the format that the other tests look at closely.
fn findings() -> Vec<Value> {
    json("json").as_array().unwrap().clone()
}

fn position(value: &Value) -> [u64; 2] {
    [&value["row"], &value["column"]].map(|number| number.as_u64().unwrap())
}

#[test]
fn sarif_has_what_the_standard_requires() {
    let (document, findings) = (json("sarif"), findings());
    assert_eq!(document["version"], "2.1.0");
    let run = &document["runs"][0];
    assert_eq!(
        (&run["tool"]["driver"]["name"], &run["columnKind"]),
        (&"xacro-lint".into(), &"unicodeCodePoints".into())
    );
    let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
    let ids: BTreeSet<&str> = rules
        .iter()
        .map(|rule| rule["id"].as_str().unwrap())
        .collect();
    assert_eq!(ids.len(), rules.len());
    let results = run["results"].as_array().unwrap();
    assert_eq!(results.len(), findings.len());
    let mut fingerprints = BTreeSet::new();
    for (result, finding) in results.iter().zip(&findings) {
        let rule = &rules[usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap()];
        assert_eq!(
            (&result["ruleId"], &rule["name"]),
            (&finding["code"], &finding["name"])
        );
        assert!(["error", "warning", "note"].contains(&result["level"].as_str().unwrap()));
        assert!(
            result["message"]["text"]
                .as_str()
                .unwrap()
                .starts_with(finding["message"].as_str().unwrap())
        );
        let place = &result["locations"][0]["physicalLocation"];
        assert_eq!(place["artifactLocation"]["uri"], finding["filename"]);
        let region = |names: [&str; 2]| names.map(|name| place["region"][name].as_u64().unwrap());
        assert_eq!(
            region(["startLine", "startColumn"]),
            position(&finding["location"])
        );
        assert_eq!(
            region(["endLine", "endColumn"]),
            position(&finding["end_location"])
        );
        let related = finding["related"].as_array().unwrap().len();
        assert_eq!(
            result["relatedLocations"].as_array().map_or(0, Vec::len),
            related
        );
        assert_eq!(result["fixes"].is_array(), finding["fix"].is_object());
        assert!(
            fingerprints.insert(
                result["partialFingerprints"]["xacroLint/v1"]
                    .as_str()
                    .unwrap()
            )
        );
    }
}

#[test]
fn gitlab_has_what_code_quality_requires() {
    let (list, findings) = (json("gitlab"), findings());
    let list = list.as_array().unwrap();
    let shown: Vec<&Value> = findings
        .iter()
        .filter(|finding| finding["severity"] != "hint")
        .collect();
    assert_eq!(list.len(), shown.len());
    let mut fingerprints = BTreeSet::new();
    for (entry, finding) in list.iter().zip(shown) {
        assert_eq!(
            (&entry["check_name"], &entry["location"]["path"]),
            (&finding["name"], &finding["filename"])
        );
        assert_eq!(
            entry["location"]["positions"]["begin"]["line"],
            finding["location"]["row"]
        );
        assert!(["info", "minor", "major"].contains(&entry["severity"].as_str().unwrap()));
        assert!(!entry["description"].as_str().unwrap().is_empty());
        assert!(fingerprints.insert(entry["fingerprint"].as_str().unwrap()));
    }
}

#[test]
fn junit_counts_add_up() {
    let text = check("junit");
    let document = roxmltree::Document::parse(&text).unwrap();
    let root = document.root_element();
    let named = |node: roxmltree::Node<'_, '_>, name: &str| {
        node.descendants().filter(|n| n.has_tag_name(name)).count()
    };
    let number = |node: roxmltree::Node<'_, '_>, name: &str| {
        node.attribute(name).unwrap().parse::<usize>().unwrap()
    };
    assert_eq!(root.tag_name().name(), "testsuites");
    for node in root
        .children()
        .filter(|node| node.is_element())
        .chain([root])
    {
        assert_eq!(number(node, "tests"), named(node, "testcase"));
        assert_eq!(number(node, "failures"), named(node, "failure"));
    }
    let serious = ["error", "warning"];
    let failing = findings()
        .iter()
        .filter(|f| serious.contains(&f["severity"].as_str().unwrap()))
        .count();
    assert_eq!(named(root, "failure"), failing);
}

#[test]
fn sarif_repeats() {
    assert_eq!(check("sarif"), check("sarif"));
}
