//! The promises of `docs/security.md` that no other test holds, and that the tests it names exist.
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
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::SystemTime;

use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn the_tests_behind_the_promises_exist() {
    let page = fs::read_to_string(repository().join("docs/security.md")).unwrap();
    let promised = page.split("## What is not promised").next().unwrap();
    let sections: Vec<&str> = promised.split("\n### ").skip(1).collect();
    assert!(sections.len() > 5);
    for section in sections {
        let title = section.lines().next().unwrap();
        let named: Vec<&str> = section
            .split('`')
            .filter(|word| word.contains(".rs::"))
            .collect();
        assert!(!named.is_empty(), "no test behind: {title}");
        for name in named {
            let (file, function) = name.split_once("::").unwrap();
            let text = fs::read_to_string(repository().join(file))
                .unwrap_or_else(|error| panic!("{file}: {error}"));
            let there = [
                format!("fn {function}("),
                format!("macro_rules! {function} "),
            ];
            assert!(
                there.iter().any(|what| text.contains(what)),
                "{title}: there is no `{name}`"
            );
        }
    }
}

fn folder() -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("security")
        .join(number.to_string());
    let _ = fs::remove_dir_all(&folder);
    // a repository of its own: nothing is read of folders above
    fs::create_dir_all(folder.join(".git")).unwrap();
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> String {
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        folder.join("none").display().to_string(),
    )]);
    let env = Environment {
        vars,
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let arguments: Vec<String> = arguments.iter().map(|&word| word.to_owned()).collect();
    let code = cli::run(
        &arguments,
        &env,
        &mut Io::plain(&mut out, &mut err, &mut std::io::empty()),
    );
    out.extend(err);
    format!("{}\n[exit {code}]", String::from_utf8(out).unwrap())
}

fn robot(body: &str) -> String {
    format!("<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{body}\n</robot>\n")
}

const FORMATS: [&str; 7] = [
    "text", "concise", "json", "sarif", "github", "gitlab", "junit",
];

#[test]
fn external_entities_are_not_read() {
    let folder = folder();
    fs::write(folder.join("secret.txt"), "S3CRET").unwrap();
    let path = folder.join("secret.txt").display().to_string();
    for system in [
        "secret.txt",
        &path,
        &format!("file://{path}"),
        "http://127.0.0.1:9/x",
    ] {
        for entity in [
            format!("<!ENTITY e SYSTEM \"{system}\">"),
            format!("<!ENTITY % p SYSTEM \"{system}\"> %p;"),
        ] {
            let text = format!(
                "<!DOCTYPE robot [{entity}]>\n<robot name=\"r\"><link name=\"a\">&e;</link></robot>"
            );
            fs::write(folder.join("r.urdf"), text).unwrap();
            for command in [
                &["check", "."][..],
                &["expand", "r.urdf"],
                &["format", "--diff", "r.urdf"],
            ] {
                let said = run(&folder, command);
                assert!(!said.contains("S3CRET"), "{command:?}: {said}");
            }
        }
    }
}

/// What files with secrets look like; and names under which they may lie.
const SECRETS: [&str; 9] = [
    "S3CRET",
    "root:S3CRET:0:0:root:/root:/bin/bash\ndaemon:x:1:1",
    "-----BEGIN PRIVATE KEY-----\nS3CRET\n-----END PRIVATE KEY-----\n",
    "TOKEN=S3CRET\nKEY='S3CRET'\n",
    "machine github.com\n  login a\n  password S3CRET\n",
    "!S3CRET x",
    "*S3CRET",
    "[S3CRET]\ntoken = \"S3CRET\"\n",
    "PATH=/bin\0TOKEN=S3CRET\0",
];
const SECRET_NAMES: [&str; 4] = ["key", "key.txt", "key.yaml", "key.xml"];

#[test]
fn keys_that_lie_outside_are_not_repeated() {
    let folder = folder();
    let robot_folder = folder.join("ws/arm/urdf");
    fs::create_dir_all(&robot_folder).unwrap();
    fs::write(
        folder.join("ws/arm/package.xml"),
        "<package><name>arm</name></package>",
    )
    .unwrap();
    for (name, secret) in SECRET_NAMES
        .iter()
        .flat_map(|name| SECRETS.iter().map(move |text| (name, text)))
    {
        fs::write(folder.join(name), secret).unwrap();
        let outside = folder.join(name).display().to_string();
        let mut ways = vec![outside, format!("../../../{name}")];
        #[cfg(unix)]
        {
            // a repository can hold links
            let _ = fs::remove_file(robot_folder.join("link.yaml"));
            std::os::unix::fs::symlink(folder.join(name), robot_folder.join("link.yaml")).unwrap();
            ways.push("link.yaml".to_owned());
        }
        for way in ways {
            let load = format!("<link name=\"a${{xacro.load_yaml('{way}')}}\"/>");
            let include = format!("<xacro:include filename=\"{way}\"/><link name=\"a\"/>");
            for body in [load, include] {
                fs::write(robot_folder.join("r.urdf.xacro"), robot(&body)).unwrap();
                for format in FORMATS {
                    let said = run(
                        &robot_folder,
                        &["check", "--output-format", format, "r.urdf.xacro"],
                    );
                    assert!(
                        !said.contains("S3CRET"),
                        "{secret:?} by {body}, {format}: {said}"
                    );
                    assert!(
                        said.contains("[exit 1]"),
                        "{secret:?} by {body}, {format}: {said}"
                    );
                }
                let said = run(&robot_folder, &["expand", "r.urdf.xacro"]);
                assert!(
                    !said.contains("S3CRET") && said.contains("[exit 2]"),
                    "{secret:?} by {body}: {said}"
                );
            }
        }
    }
}

/// Every kind of file that is read is a link to a file outside.
#[cfg(unix)]
#[test]
fn links_to_keys_show_nothing_of_them() {
    const LINKS: [&str; 12] = [
        "m.obj",
        "m.dae",
        "m.stl",
        "m.gltf",
        "m.glb",
        "link.urdf.xacro",
        "link.urdf",
        "xacro-lint.toml",
        "package.xml",
        "CMakeLists.txt",
        "setup.py",
        "demo.launch.py",
    ];
    let folder = folder();
    let arm = folder.join("ws/arm");
    fs::create_dir_all(&arm).unwrap();
    let mesh = |name: &&&str| {
        format!(
            "<visual><geometry><mesh filename=\"package://arm/{name}\"/></geometry></visual><visual><geometry><mesh filename=\"{name}\"/></geometry></visual>"
        )
    };
    let meshes: String = LINKS
        .iter()
        .filter(|name| name.starts_with("m."))
        .map(|name| mesh(&name))
        .collect();
    fs::write(
        arm.join("r.urdf.xacro"),
        robot(&format!("<link name=\"a\">{meshes}</link>")),
    )
    .unwrap();
    for name in LINKS {
        std::os::unix::fs::symlink(folder.join("key.txt"), arm.join(name)).unwrap();
    }
    let more = [
        "v S3CRET 0 0\nf 1 S3CRET 3\nmtllib S3CRET",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nmtllib S3CRET",
        "solid S3CRET\nfacet normal S3CRET 0 0\nS3CRET",
        "\"S3CRET\"",
        "[\"S3CRET\"]",
        "{\"asset\": \"S3CRET\", \"meshes\": [{\"primitives\": \"S3CRET\"}]}",
        "{\"extensionsRequired\": [\"S3CRET_draco\"], \"buffers\": [{\"uri\": \"S3CRET.bin\", \"byteLength\": 1}]}",
        "<COLLADA><S3CRET></COLLADA>",
        "<COLLADA a=\"&S3CRET;\"/>",
        "target = \"S3CRET\"\nS3CRET = 1\n[rules]\nS3CRET = \"S3CRET\"",
    ];
    for secret in SECRETS.iter().chain(&more) {
        fs::write(folder.join("key.txt"), secret).unwrap();
        for format in ["text", "json"] {
            let said = run(
                &arm,
                &["check", "--output-format", format, "--select", "ALL", "."],
            );
            assert!(
                said.contains("m.stl") && said.contains("[exit 1]"),
                "{secret:?}, {format}: {said}"
            );
            assert!(!said.contains("S3CRET"), "{secret:?}, {format}: {said}");
        }
    }
}

#[test]
fn a_bare_text_outside_is_refused_and_parameters_are_not() {
    let folder = folder();
    let (urdf, parameters) = (folder.join("ws/arm/urdf"), folder.join("etc/robot.yaml"));
    fs::create_dir_all(&urdf).unwrap();
    fs::create_dir_all(folder.join("etc")).unwrap();
    let body = format!(
        "<link name=\"a${{xacro.load_yaml('{}')}}\"/>",
        parameters.display()
    );
    fs::write(urdf.join("r.urdf.xacro"), robot(&body)).unwrap();
    for (text, shown) in [
        ("wheels: 4\n", "a{'wheels': 4}"),
        ("[1, 2]", "a[1, 2]"),
        ("7", "a7"),
    ] {
        fs::write(&parameters, text).unwrap();
        let said = run(&urdf, &["expand", "r.urdf.xacro"]);
        assert!(
            said.contains(shown) && said.contains("[exit 0]"),
            "{text}: {said}"
        );
    }
    fs::write(&parameters, "four").unwrap();
    let said = run(&urdf, &["check", "r.urdf.xacro"]);
    for words in [
        "r.urdf.xacro:2:",
        "etc/robot.yaml` is not loaded: it is a single string",
        "move the file into the package",
    ] {
        assert!(said.contains(words), "no `{words}` in {said}");
    }
    // beside the robot it is the robot's own
    fs::write(folder.join("ws/arm/word.yaml"), "four").unwrap();
    let body = "<link name=\"${xacro.load_yaml('../word.yaml')}\"/>";
    fs::write(urdf.join("r.urdf.xacro"), robot(body)).unwrap();
    let said = run(&urdf, &["expand", "r.urdf.xacro"]);
    assert!(
        said.contains("<link name=\"four\"/>") && said.contains("[exit 0]"),
        "{said}"
    );
}

#[test]
fn texts_of_descriptions_are_shown_and_others_have_a_line() {
    let folder = folder();
    let part = robot("<link name=\"wheel\"/>\n<joint name=\"axle\" type=\"turning\"/>");
    for (name, is_shown) in [
        ("wheel.gazebo", true),
        ("wheel.XACRO", true),
        ("wheel.trans", true),
        ("wheel.key", false),
    ] {
        fs::write(folder.join(name), &part).unwrap();
        let include = format!("<xacro:include filename=\"{name}\"/>");
        fs::write(folder.join("r.urdf.xacro"), robot(&include)).unwrap();
        let said = run(
            &folder,
            &["check", "r.urdf.xacro", "--select", "unknown-joint-type"],
        );
        assert!(said.contains(&format!("{name}:3:")), "{name}: {said}");
        assert_eq!(
            said.contains("<joint name=\"axle\""),
            is_shown,
            "{name}: {said}"
        );
    }
}

#[test]
fn python_has_no_way_out() {
    let folder = folder();
    let marker = folder.join("was_here");
    for expression in [
        "__import__('os').system('touch was_here')",
        "().__class__.__bases__[0].__subclasses__()",
        "open('was_here', 'w')",
        "exec('1')",
        "eval('1')",
        "python.open('was_here', 'w')",
        "python.__import__('os')",
        "'{0.__class__}'.format(1)",
        "(lambda: 0).__globals__",
        "xacro.__dict__",
        "globals()",
        "getattr(1, '__class__')",
        "compile('1', '', 'eval')",
    ] {
        let value = expression.replace('\'', "&apos;").replace('<', "&lt;");
        fs::write(
            folder.join("r.urdf.xacro"),
            robot(&format!("<link name=\"${{{value}}}\"/>")),
        )
        .unwrap();
        let said = run(&folder, &["expand", "r.urdf.xacro"]);
        let named_only = said.contains("&lt;class") || said.contains("<class");
        assert!(
            said.contains("[exit 2]") && !named_only,
            "{expression}: {said}"
        );
        assert!(!marker.exists(), "{expression}");
    }
}

/// Times and texts of all files.
fn state(folder: &Path) -> BTreeMap<PathBuf, (SystemTime, Vec<u8>)> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(state(&path));
        } else {
            found.insert(
                path.clone(),
                (
                    path.metadata().unwrap().modified().unwrap(),
                    fs::read(&path).unwrap(),
                ),
            );
        }
    }
    found
}

#[test]
fn checking_changes_nothing() {
    let folder = repository().join("docs/examples");
    let before = state(&folder);
    for format in FORMATS {
        run(&folder, &["check", "--output-format", format, "."]);
    }
    for command in [
        &["fix", "--diff", "."][..],
        &["format", "--diff", "."],
        &["format", "--check", "."],
    ] {
        run(&folder, command);
    }
    assert!(before == state(&folder));
}

/// A robot whose names try everything, and a file whose name does.
fn smuggler() -> PathBuf {
    let folder = folder();
    let name = "a&#10;::error::owned&#13;&#10;##vso[task.setvariable variable=x]owned&#9;";
    let body = format!(
        "<link name=\"{name}\"/>\n<link name=\"{name}\"/>\n<joint name=\"{name}\" type=\"{name}\"/>\n<link name=\"${{undefined_{name}}}\"/>"
    );
    fs::write(folder.join("r.urdf.xacro"), robot(&body)).unwrap();
    #[cfg(unix)]
    fs::write(
        folder.join("x\n::error::owned.urdf"),
        "<robot name=\"x\"><link name=\"a\"/><link name=\"a\"/></robot>",
    )
    .unwrap();
    folder
}

#[test]
fn no_commands_for_the_build_machine() {
    let folder = smuggler();
    for format in FORMATS {
        let said = run(&folder, &["check", "--output-format", format, "."]);
        assert!(said.contains("owned"), "{format}: {said}");
        for line in said.lines() {
            let line = line.trim_start();
            assert!(
                !line.starts_with("::error::owned") && !line.starts_with("##vso"),
                "{format}: {said}"
            );
        }
    }
}

#[test]
fn control_characters_do_not_reach_the_terminal() {
    let folder = folder();
    let text = robot(
        "<link name=\"\u{9b}31m\u{1b}]0;title\u{7}\"/>\n<!-- \u{9b}2J -->\n<link name=\"${a\u{9b}}\"/>",
    );
    fs::write(folder.join("r.urdf.xacro"), text).unwrap();
    #[cfg(unix)]
    fs::write(
        folder.join("x\u{1b}[2J.urdf"),
        "<robot name=\"x\"><link name=\"a\"/><link name=\"a\"/></robot>",
    )
    .unwrap();
    for command in [
        &["check", "."][..],
        &["check", "--output-format", "concise", "."],
        &["expand", "r.urdf.xacro"],
        &["tree", "r.urdf.xacro"],
    ] {
        let said = run(&folder, command);
        let raw = said
            .chars()
            .find(|c| c.is_control() && !['\n', '\t'].contains(c));
        assert_eq!(raw, None, "{command:?}: {said:?}");
    }
}

#[test]
fn settings_of_a_workspace_choose_no_program() {
    let text = fs::read_to_string(repository().join("editors/vscode/package.json")).unwrap();
    let package: serde_json::Value = serde_json::from_str(&text).unwrap();
    let restricted = package["capabilities"]["untrustedWorkspaces"]["restrictedConfigurations"]
        .as_array()
        .unwrap();
    let mut seen = 0;
    let sections = &package["contributes"]["configuration"];
    let sections = sections
        .as_array()
        .cloned()
        .unwrap_or_else(|| vec![sections.clone()]);
    for (name, setting) in sections
        .iter()
        .flat_map(|section| section["properties"].as_object().unwrap())
    {
        if name.starts_with("xacro.server.") {
            assert_eq!(setting["scope"], "machine", "{name}");
            assert!(restricted.iter().any(|listed| listed == name), "{name}");
            seen += 1;
        }
    }
    assert!(seen >= 3, "{seen}");
}
