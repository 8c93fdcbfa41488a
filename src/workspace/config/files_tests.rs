//! Files of the configuration: which one counts, and what they take over from each other.

use super::settings::ConfigTable;
use super::tests::load;
use super::{Config, LoadedConfig, RuleLevel, find_config, schema};
use base::Severity;
use packages::RosVersion;
use vfs::testing::Tree;

#[test]
fn files_extend_each_other() {
    let tree = Tree::new();
    tree.write(
        "base/lint.toml",
        "target = 'ros1'\nselect = ['A']\nignore = ['B']\npackage-path = ['p']\nurdf-version = ['2']\n\
         thresholds = { x = 1, y = 1 }\n[[roots]]\nfile = 'base.xacro'\n",
    );
    tree.write(
        "ws/xacro-lint.toml",
        "extend = '../base/lint.toml'\nselect = ['C']\nignore = ['D']\npackage-path = ['q']\n\
         thresholds = { y = 2 }\n[[roots]]\nfile = 'near.xacro'\n",
    );
    let LoadedConfig { config, warnings } =
        Config::for_file(tree.vfs(), &tree.path("ws/src/a/b.xacro"));
    assert!(warnings.is_empty());
    assert_eq!(
        config.files,
        [
            tree.path("ws/xacro-lint.toml"),
            tree.path("ws/../base/lint.toml")
        ]
    );
    assert_eq!(config.target, RosVersion::Ros1);
    assert_eq!(config.select, Some(vec!["C".to_owned()]));
    assert_eq!(config.ignore, ["B", "D"]);
    assert_eq!(config.urdf_version, ["2"]);
    assert_eq!(
        config.package_path,
        [tree.path("ws/q"), tree.path("ws/../base/p")]
    );
    assert_eq!((config.thresholds["x"], config.thresholds["y"]), (1.0, 2.0));
    let roots: Vec<&str> = config.roots.iter().map(|root| root.file.as_str()).collect();
    assert_eq!(roots, ["near.xacro", "base.xacro"]);
}

#[test]
fn circles_end() {
    let tree = Tree::new();
    tree.write("a.toml", "extend = 'b.toml'\nignore = ['A']");
    tree.write("b.toml", "extend = 'a.toml'\nignore = ['B']");
    let LoadedConfig { config, warnings } = Config::load(tree.vfs(), &tree.path("a.toml")).unwrap();
    assert_eq!(config.ignore, ["B", "A"]);
    assert_eq!(warnings.len(), 1);
    for number in 0..30 {
        tree.write(
            &format!("c{number}.toml"),
            &format!("extend = 'c{}.toml'", number + 1),
        );
    }
    let LoadedConfig { warnings, .. } = Config::load(tree.vfs(), &tree.path("c0.toml")).unwrap();
    assert_eq!(warnings.len(), 1);
}

#[test]
fn the_nearest_file_counts() {
    let tree = Tree::new();
    for file in [
        "xacro-lint.toml",
        "a/.xacro-lint.toml",
        "a/b/xacro-lint.toml",
        "a/b/.xacro-lint.toml",
    ] {
        tree.write(file, "");
    }
    let table = [
        ("", "xacro-lint.toml"),
        ("a/x", "a/.xacro-lint.toml"),
        ("a/b", "a/b/xacro-lint.toml"),
        ("c/d", "xacro-lint.toml"),
    ];
    for (folder, expected) in table {
        assert_eq!(
            find_config(tree.vfs(), &tree.path(folder)),
            Some(tree.path(expected)),
            "{folder}"
        );
    }
    assert!(Config::load(tree.vfs(), &tree.path("none.toml")).is_err());
}

#[test]
fn settings_of_an_editor_win() {
    let (tree, mut config, _) =
        load("target = 'ros1'\nseverity.a = 'off'\n[limits]\nfile-mb = 7\nexpand-ms = 8\n");
    let settings = serde_json::json!({
        "target": "ros2",
        "packagePaths": ["../other"],
        "useEnvironment": false,
        "diagnostics.rules": { "unused-property": "off" },
        "diagnostics": { "delay": 100, "rules": { "a": "error" } },
        "format.lineWidth": 90,
        "format": { "selfClose": true },
        "limits": { "fileMB": 9 },
        "limits.evalSteps": 5,
        "thresholds": { "max-extent-m": 3 },
        "roots": [{ "file": "a.xacro", "args": { "someArg": "x" } }],
        "inlayHints.values": true,
        "preview": { "fps": 60 },
        "trace.server": "off",
        "ignore": 5,
    });
    let warnings = config.apply_settings(&settings, tree.root());
    let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(warnings, ["`ignore` must be a list, not an integer"]);
    assert_eq!(
        (config.target, config.use_environment),
        (RosVersion::Ros2, false)
    );
    assert_eq!(config.package_path, [tree.path("../other")]);
    assert_eq!(
        (config.severity["unused-property"], config.severity["a"]),
        (RuleLevel::Off, RuleLevel::At(Severity::Error))
    );
    assert_eq!(
        (config.format.line_width, config.format.self_close),
        (90, true)
    );
    assert_eq!(
        (
            config.limits.file_mb,
            config.limits.expand_ms,
            config.limits.eval_steps
        ),
        (9, 8, 5)
    );
    assert_eq!(config.thresholds["max-extent-m"], 3.0);
    assert_eq!(
        config.roots[0].args,
        [("someArg".to_owned(), vec!["x".to_owned()])]
    );
}

#[test]
fn the_schema_has_every_key() {
    let schema = schema();
    let properties = schema["properties"].as_object().unwrap();
    assert_eq!(properties.len(), Config::KEYS.len());
    assert_eq!(
        properties["limits"]["properties"]["file-mb"]["maximum"],
        1000
    );
    assert_eq!(
        properties["roots"]["items"]["properties"]["presets"]["additionalProperties"]["type"],
        "object"
    );
    assert_eq!(properties["target"]["enum"][1], "ros1");
}
