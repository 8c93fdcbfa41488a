use std::path::PathBuf;

use super::{AttributeLayout, Config, ConfigMentionKind, Limits, LoadedConfig, Profile, RuleLevel};
use base::Severity;
use packages::RosVersion;
use vfs::testing::Tree;

/// The configuration of `text`, and its warnings without the folder.
pub(super) fn load(text: &str) -> (Tree, Config, Vec<String>) {
    let tree = Tree::new();
    tree.write("xacro-lint.toml", text);
    let LoadedConfig { config, warnings } =
        Config::load(tree.vfs(), &tree.path("xacro-lint.toml")).unwrap();
    let prefix = format!("{}/", tree.root().display());
    let warnings = warnings
        .iter()
        .map(|warning| warning.to_string().replace(&prefix, ""))
        .collect();
    (tree, config, warnings)
}

#[test]
fn a_value_of_another_type_changes_nothing() {
    let text = "urdf-version = '1.1'\nuse-environment = 'no'\nlimits.file-mb = 0\n";
    let (_tree, config, warnings) = load(text);
    let defaults = Config::default();
    assert_eq!(config.urdf_version, defaults.urdf_version);
    assert_eq!(config.use_environment, defaults.use_environment);
    assert_eq!(config.limits, defaults.limits);
    assert_eq!(warnings.len(), 3);
}

#[test]
fn every_key() {
    let (tree, config, warnings) = load(
        r#"
target = "ros1"
urdf-version = ["1.0", "1.1"]
profile = ["mobile", "pedantic", "mobile"]
select = ["XML", "JNT006"]
extend-select = ["STR013"]
ignore = ["unused-macro"]
exclude = ["vendor/**"]
package-path = ["../other", "/abs"]
use-environment = false
allow-elements = ["my_sensor"]
allow-attributes = ["my_unit"]

[severity]
GEO007 = "off"
unused-property = "hint"

[per-file-ignores]
"test/**" = ["STR"]

[thresholds]
max-extent-m = 25
other = 0.5

[[roots]]
file = "urdf/robot.urdf.xacro"
args = { side = "left", sim = true, count = 3, length = 0.10 }
[roots.presets.zulu]
side = "right"
[roots.presets.alpha]
extra = "1"

[[roots]]
file = "*.urdf"

[format]
line-width = 100
attributes = "auto"
self-close = true

[limits]
eval-steps = 1
expand-nodes = 2
expand-ms = 3
file-mb = 4
macro-depth = 5
include-depth = 6
"#,
    );
    assert_eq!(warnings, [""; 0]);
    assert_eq!(config.files, [tree.path("xacro-lint.toml")]);
    assert_eq!(config.target, RosVersion::Ros1);
    assert_eq!(config.urdf_version, ["1.0", "1.1"]);
    assert_eq!(config.profiles, [Profile::Mobile, Profile::Pedantic]);
    assert_eq!(
        config.select.as_deref(),
        Some(["XML".to_owned(), "JNT006".to_owned()].as_slice())
    );
    assert_eq!((config.extend_select.len(), config.ignore.len()), (1, 1));
    assert!(config.exclude[0].matches(&tree.path("vendor/a/b.xacro")));
    assert_eq!(
        config.package_path,
        [tree.path("../other"), PathBuf::from("/abs")]
    );
    assert!(!config.use_environment);
    assert_eq!(
        (
            config.allow_elements[0].as_str(),
            config.allow_attributes[0].as_str()
        ),
        ("my_sensor", "my_unit")
    );
    assert_eq!(config.severity["GEO007"], RuleLevel::Off);
    assert_eq!(
        config.severity["unused-property"],
        RuleLevel::At(Severity::Hint)
    );
    assert!(
        config.per_file_ignores[0]
            .0
            .matches(&tree.path("test/a.xacro"))
    );
    assert_eq!(config.per_file_ignores[0].1, ["STR"]);
    assert_eq!(
        (
            config.thresholds["max-extent-m"],
            config.thresholds["other"]
        ),
        (25.0, 0.5)
    );
    assert_eq!(
        (config.format.line_width, config.format.self_close),
        (100, true)
    );
    assert_eq!(config.format.attributes, AttributeLayout::Auto);
    let limits = Limits {
        eval_steps: 1,
        expand_nodes: 2,
        expand_ms: 3,
        file_mb: 4,
        macro_depth: 5,
        include_depth: 6,
    };
    assert_eq!(config.limits, limits);
    assert_eq!(config.limits.file_bytes(), 4_000_000);
    let mentions: Vec<&str> = config
        .mentions
        .iter()
        .map(|mention| mention.text.as_str())
        .collect();
    let rules = [
        "XML",
        "JNT006",
        "STR013",
        "unused-macro",
        "../other",
        "/abs",
        "GEO007",
        "unused-property",
        "STR",
    ];
    assert_eq!(
        mentions,
        [rules.as_slice(), &["max-extent-m", "other"]].concat()
    );
    assert_eq!(
        config
            .mentions
            .iter()
            .filter(|mention| mention.kind == ConfigMentionKind::Threshold)
            .count(),
        2
    );
}

/// The runs of the first root, without its file.
fn runs(text: &str, choices: &[(&str, &[&str])]) -> Vec<String> {
    let (_, config, warnings) = load(&format!("[[roots]]\nfile = 'a'\n{text}"));
    assert!(warnings.is_empty(), "{warnings:?}");
    let values = |values: &[&str]| values.iter().map(|value| (*value).to_owned()).collect();
    let choices = choices
        .iter()
        .map(|(name, own)| ((*name).to_owned(), values(own)))
        .collect();
    let args = |args: &[(String, String)]| {
        args.iter()
            .map(|(name, value)| format!("{name}:={value}"))
            .collect::<Vec<_>>()
            .join(" ")
    };
    config.roots[0]
        .variants(&choices)
        .iter()
        .map(|run| args(&run.args))
        .collect()
}

#[test]
fn combinations_of_arguments() {
    assert_eq!(
        runs(
            "args = { kind = ['a', 'b'], sim = true, size = [1, 2] }",
            &[]
        ),
        [
            "kind:=a sim:=true size:=1",
            "kind:=a sim:=true size:=2",
            "kind:=b sim:=true size:=1",
            "kind:=b sim:=true size:=2",
        ]
    );
    // what is listed twice is one run
    assert_eq!(runs("args = { kind = ['a', 'a'] }", &[]), ["kind:=a"]);
    let excluded = "args = { kind = ['a', 'b'], size = [1, 2, 3] }\nexclude = [{ kind = 'a', size = [1, 2] }, { size = 3 }, {}]";
    assert_eq!(runs(excluded, &[]), ["kind:=b size:=1", "kind:=b size:=2"]);
    // a preset goes over the lists
    assert_eq!(
        runs(
            "args = { kind = ['a', 'b'] }\npresets.p = { kind = 'c', sim = true }",
            &[]
        ),
        ["kind:=a", "kind:=b", "kind:=c sim:=true"]
    );
    // what launch files offer comes last, and not where the entry says something else
    let choices: [(&str, &[&str]); 2] = [("kind", &["x", "y"]), ("size", &["1", "2"])];
    assert_eq!(
        runs("args = { kind = ['a', 'b'] }", &choices),
        [
            "kind:=a size:=1",
            "kind:=a size:=2",
            "kind:=b size:=1",
            "kind:=b size:=2"
        ]
    );
}

#[test]
fn places_that_name_an_argument() {
    let text = "[[roots]]\nfile = 'a'\nargs = { side = ['l', 'r'] }\nexclude = [{ side = 'l' }]\npresets.p = { side = 'r' }\n\
                [[roots.expect]]\nname = 'side'\nwhen = { side = 'l' }\n";
    let places = super::argument_places(text, "side", |_| true);
    assert_eq!(places.len(), 4);
    assert!(places.iter().all(|place| place.slice(text) == "side"));
}

#[test]
fn a_matrix_without_end() {
    let digits = "[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]";
    let args: Vec<String> = (0..30).map(|n| format!("a{n} = {digits}")).collect();
    let (_, config, warnings) = load(&format!(
        "[[roots]]\nfile = 'a'\nargs = {{ {} }}",
        args.join(", ")
    ));
    assert_eq!(config.roots[0].variants(&Vec::new()).len(), 1_000);
    let message = format!("{} combinations of arguments; only 1000 are used", u64::MAX);
    assert!(warnings[0].ends_with(&message), "{warnings:?}");
}

#[test]
fn expectations() {
    let (_, config, warnings) = load(
        r#"
[[roots]]
file = "a"
[[roots.expect]]
name = "arm"
when = { kind = ["a", "b"], sim = true }
root = "world"
links = ["tool"]
link-count = 0
chains = [["world", "tool"]]
mass = 3
joint.shoulder = { type = "revolute", lower = -1, tolerance = 0 }
command-interfaces = { shoulder = ["position"] }
expands-to = "arm.urdf"
[[roots.expect]]
"#,
    );
    assert!(warnings.is_empty(), "{warnings:?}");
    let [arm, empty] = config.roots[0].expect.as_slice() else {
        panic!()
    };
    assert_eq!(
        (arm.link_count, arm.mass, arm.mass_tolerance),
        (Some(0), Some(3.0), 0.001)
    );
    assert_eq!(arm.when[0].1, ["a", "b"]);
    let joint = &arm.joint[0].1;
    assert_eq!(
        (
            joint.kind.as_deref(),
            joint.lower,
            joint.upper,
            joint.tolerance
        ),
        (Some("revolute"), Some(-1.0), None, 0.0)
    );
    assert_eq!((arm.place.line, empty.place.line), (4, 15));
    let roots = &config
        .settings()
        .into_iter()
        .find(|setting| setting.key == "roots")
        .unwrap()
        .value;
    assert_eq!(
        roots[0]["expect"][0]["joint"]["shoulder"]["type"],
        "revolute"
    );
}

#[test]
fn roots_and_presets() {
    let (tree, config, _) = load(
        r#"
[[roots]]
file = "urdf/robot.urdf.xacro"
args = { side = "left", sim = true, count = 3, length = 0.10 }
presets.zulu = { side = "right" }
presets.alpha = { extra = "1" }
[[roots]]
file = "**/*.urdf"
[[roots]]
file = "gone.xacro"
presets.only = { a = "1" }
"#,
    );
    for file in ["urdf/robot.urdf.xacro", "a.urdf", "sub/b.urdf"] {
        tree.write(file, "");
    }
    let runs: Vec<String> = config.roots[0]
        .variants(&Vec::new())
        .iter()
        .map(|run| {
            let args: Vec<String> = run
                .args
                .iter()
                .map(|(name, value)| format!("{name}:={value}"))
                .collect();
            format!(
                "{}: {}",
                run.preset.as_deref().unwrap_or("-"),
                args.join(" ")
            )
        })
        .collect();
    assert_eq!(
        runs,
        [
            "-: side:=left sim:=true count:=3 length:=0.10",
            "zulu: sim:=true count:=3 length:=0.10 side:=right",
            "alpha: side:=left sim:=true count:=3 length:=0.10 extra:=1",
        ]
    );
    assert_eq!(
        config.roots[0].files(tree.vfs()),
        [tree.path("urdf/robot.urdf.xacro")]
    );
    assert_eq!(
        config.roots[1].files(tree.vfs()),
        [tree.path("a.urdf"), tree.path("sub/b.urdf")]
    );
    assert!(config.roots[2].files(tree.vfs()).is_empty());
    assert_eq!(config.roots[1].variants(&Vec::new()).len(), 1);
    let only: Vec<Option<String>> = config.roots[2]
        .variants(&Vec::new())
        .into_iter()
        .map(|run| run.preset)
        .collect();
    assert_eq!(only, [Some("only".to_owned())]);
    assert_eq!(
        (config.roots[1].place.line, config.roots[1].place.column),
        (8, 8)
    );
}

#[test]
fn what_does_not_fit_is_a_warning_and_the_rest_holds() {
    let table = [
        (
            "taget = 'ros1'",
            "1:1: unknown key `taget`; did you mean `target`?",
        ),
        ("\n\n  whatever = 1", "3:3: unknown key `whatever`"),
        (
            "target = 1",
            "1:10: `target` must be a string, not an integer",
        ),
        (
            "target = 'ros3'",
            "1:10: invalid value `ros3` for `target`; use `ros2`, `ros1`; did you mean `ros2`?",
        ),
        (
            "oldest-reader = 'newest'",
            "1:17: invalid value `newest` for `oldest-reader`; use a version of urdfdom, such as `4.0`",
        ),
        (
            "profile = 'mobile'",
            "1:11: `profile` must be a list, not a string",
        ),
        (
            "profile = ['moblie']",
            "1:12: invalid value `moblie` for `profile`; use `ros-industrial`, `mobile`, `gazebo`, `pedantic`; did you mean `mobile`?",
        ),
        (
            "select = [1]",
            "1:11: `select` must be a list of strings, not an integer",
        ),
        (
            "urdf-version = [1.0]",
            "1:17: `urdf-version` must be a list of strings, not a number",
        ),
        (
            "severity = []",
            "1:12: `severity` must be a table, not a list",
        ),
        (
            "severity.X = 'fatal'",
            "1:14: invalid value `fatal` for `X`; use `error`, `warning`, `info`, `hint`, `off`",
        ),
        (
            "use-environment = 'yes'",
            "1:19: `use-environment` must be a boolean, not a string",
        ),
        (
            "thresholds.x = nan",
            "1:16: `x` must be a number, not a number",
        ),
        (
            "thresholds.x = 2000-01-01",
            "1:16: `x` must be a number, not a date",
        ),
        (
            "[limits]\nfile-mb = 0",
            "2:11: `file-mb` must be from 1 to 1000",
        ),
        (
            "[limits]\neval-steps = -1",
            "2:14: `eval-steps` must be at least 1",
        ),
        (
            "[limits]\nexpand-ms = 1.5",
            "2:13: `expand-ms` must be an integer, not a number",
        ),
        (
            "[limits]\nmacro-dept = 1",
            "2:1: unknown key `macro-dept` in `limits`; did you mean `macro-depth`?",
        ),
        (
            "[format]\nwidth = 1",
            "2:1: unknown key `width` in `format`",
        ),
        (
            "[[roots]]\nargs = {}",
            "1:1: an entry of `roots` has no `file`",
        ),
        (
            "[[roots]]\nfile = 1",
            "2:8: `file` must be a string, not an integer",
        ),
        (
            "[[roots]]\nfile = 'a'\nargs.x = []",
            "3:10: `x` has no values",
        ),
        (
            "[[roots]]\nfile = 'a'\nargs.x = [[]]",
            "3:10: `x` must be a string, number or boolean, or a list of these, not a list",
        ),
        (
            "[[roots]]\nfile = 'a'\nexclude = {}",
            "3:11: `exclude` must be a list, not a table",
        ),
        (
            "[[roots]]\nfile = 'a'\nchoices = 'all'",
            "3:11: invalid value `all` for `choices`; use `launch`",
        ),
        (
            "[[roots]]\nfile = 'a'\n[[roots.expect]]\nlnks = []",
            "4:1: unknown key `lnks` in `expect`; did you mean `links`?",
        ),
        (
            "[[roots]]\nfile = 'a'\n[[roots.expect]]\nlink-count = -1",
            "4:14: `link-count` must not be negative",
        ),
        (
            "[[roots]]\nfile = 'a'\n[[roots.expect]]\nmass = nan",
            "4:8: `mass` must be a finite number, not a number",
        ),
        (
            "[[roots]]\nfile = 'a'\n[[roots.expect]]\nchains = [['a']]",
            "4:11: `chains` must be a list of lists of two or more links, not a list",
        ),
        (
            "[[roots]]\nfile = 'a'\n[[roots.expect]]\njoint.a.uper = 1",
            "4:9: unknown key `uper` in `joint.a`; did you mean `upper`?",
        ),
        (
            "[[roots]]\nfile = 'a'\npresets = 1",
            "3:11: `presets` must be a table, not an integer",
        ),
        (
            "roots = ['a']",
            "1:10: `roots` must be a list of tables, not a string",
        ),
        (
            "extend = 'gone.toml'",
            "1:10: cannot read `gone.toml`: No such file or directory",
        ),
        ("extend = 'xacro-lint.toml'", "1:10: circular `extend`"),
    ];
    for (text, expected) in table {
        let (_tree, config, warnings) = load(&format!("{text}\n[per-file-ignores]\na = ['X']\n"));
        assert_eq!(warnings, [format!("xacro-lint.toml:{expected}")], "{text}");
        assert_eq!(config.per_file_ignores.len(), 1, "{text}");
    }
}

#[test]
fn a_syntax_error_does_not_lose_the_rest() {
    let (_tree, config, warnings) =
        load("target = \"ros1\"\nselect = [\"A\"\nignore = ]\n[limits]\nfile-mb = 7\n");
    assert!(!warnings.is_empty());
    assert!(
        warnings
            .iter()
            .all(|warning| warning.starts_with("xacro-lint.toml:")),
        "{warnings:?}"
    );
    assert_eq!(
        (config.target, config.limits.file_mb),
        (RosVersion::Ros1, 7)
    );
}
