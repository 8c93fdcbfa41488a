//! What a session says after edits is what a fresh one says of the same texts.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::analysis::{self, AnalysisHost};
use xacro_lsp::base::{CancelFlag, TextRange};
use xacro_lsp::rules::Finding;
use xacro_lsp::vfs::Environment;

/// A session over a folder whose descriptions are all open.
struct Session {
    host: AnalysisHost,
    texts: BTreeMap<PathBuf, String>,
}

impl Session {
    fn over(folder: &Path, texts: &BTreeMap<PathBuf, String>) -> Self {
        let vars = BTreeMap::from([("AMENT_PREFIX_PATH".to_owned(), "/nowhere".to_owned())]);
        let env = Environment {
            vars,
            cwd: folder.to_owned(),
            ..Environment::default()
        };
        let mut host = AnalysisHost::new(env, vec![folder.to_owned()]);
        while host.scan(|| false).is_some() {}
        for (path, text) in texts {
            host.set_text(path, text.clone());
        }
        Self {
            host,
            texts: texts.clone(),
        }
    }

    fn edit(&mut self, path: &Path, start: usize, end: usize, new: &str) {
        self.host
            .edit(path, TextRange::new(start as u32, end as u32), new);
        self.texts
            .get_mut(path)
            .unwrap()
            .replace_range(start..end, new);
    }

    /// All findings of all open files.
    fn findings(&mut self) -> Vec<String> {
        let paths: Vec<PathBuf> = self.texts.keys().cloned().collect();
        let report = analysis::report_on(&mut self.host, &paths, &CancelFlag::default()).unwrap();
        let mut shown: Vec<String> = report
            .findings
            .iter()
            .map(|finding| {
                format!(
                    "{} {}",
                    report.path(finding.span.file).display(),
                    line(finding)
                )
            })
            .collect();
        shown.sort();
        shown
    }
}

fn line(finding: &Finding) -> String {
    let span = finding.span.range;
    format!(
        "{}..{} {:?} {} {} {:?}",
        span.start,
        span.end,
        finding.severity,
        finding.rule.name,
        finding.message,
        finding.help.as_deref()
    )
}

fn descriptions(folder: &Path, into: &mut BTreeMap<PathBuf, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            descriptions(&path, into);
        } else if path
            .extension()
            .is_some_and(|ending| ending == "xacro" || ending == "urdf")
        {
            into.insert(path.clone(), fs::read_to_string(&path).unwrap());
        }
    }
}

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
}

/// Somewhere in a text, a few bytes long.
fn somewhere(dice: &mut Dice, text: &str) -> (usize, usize) {
    let boundary = |mut at: usize| {
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let start = boundary(dice.roll(text.len() + 1));
    (start, boundary((start + dice.roll(6)).min(text.len())))
}

#[test]
fn an_edited_session_says_what_a_fresh_one_says() {
    const NEW: [&str; 12] = [
        "",
        "x",
        "0",
        " ",
        "${",
        "}",
        "<link name=\"extra\"/>",
        "<",
        "\"",
        "-->",
        "<!-- words -->",
        "\n",
    ];
    for (seed, robot) in [
        "industrial_arm",
        "two_joint_gripper",
        "broken_cell",
        "measuring_cell",
    ]
    .iter()
    .enumerate()
    {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("docs/examples")
            .join(robot);
        let mut texts = BTreeMap::new();
        descriptions(&folder, &mut texts);
        let paths: Vec<PathBuf> = texts.keys().cloned().collect();
        assert!(!paths.is_empty(), "{robot}");
        let mut session = Session::over(&folder, &texts);
        session.findings();
        let mut dice = Dice(seed as u64 + 1);
        for round in 0..12 {
            // edits that are taken back now and then, so that texts do not rot
            let before = session.texts.clone();
            for _ in 0..1 + dice.roll(4) {
                let path = paths[dice.roll(paths.len())].clone();
                let (start, end) = somewhere(&mut dice, &session.texts[&path]);
                session.edit(&path, start, end, NEW[dice.roll(NEW.len())]);
            }
            let fresh = Session::over(&folder, &session.texts).findings();
            assert_eq!(session.findings(), fresh, "{robot}, round {round}");
            if round % 3 == 2 {
                for (path, text) in before {
                    session.host.set_text(&path, text.clone());
                    session.texts.insert(path, text);
                }
            }
        }
    }
}

/// A macro whose calls decide what rules say of it, and what they say of others.
const MACRO: &str = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="turns" value="1"/>
  <xacro:macro name="part" params="name parent type:=revolute xyz:='0 0 0.1' axis:='0 0 1' limit:=1.5 speed:=2 ixx:=0.01 shape:=box">
    <link name="${name}">
      <inertial><mass value="1"/><inertia ixx="${ixx}" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
      <visual>
        <xacro:if value="${shape == 'box'}"><geometry><box size="0.1 0.1 0.1"/></geometry></xacro:if>
        <xacro:unless value="${shape == 'box'}"><sphere radius="0.1"/></xacro:unless>
      </visual>
      <extra/>
    </link>
    <joint name="${name}_joint" type="${type}">
      <parent link="${parent}"/><child link="${name}"/>
      <origin xyz="${xyz}"/>
      <axis xyz="${axis}"/>
      <limit lower="${-limit}" upper="${limit * turns}" effort="10" velocity="${speed}"/>
    </joint>
  </xacro:macro>
  <link name="base"/>
"#;

/// Settings of a call, each with values of which some are wrong, and some only beside others.
const SETTINGS: [(&str, &[&str]); 8] = [
    ("type", &["revolute", "fixed", "prismatic", "revolut"]),
    (
        "xyz",
        &["0 0 0.1", "0 0 25", "0 0 2500", "0 0", "0 ${missing} 1"],
    ),
    ("axis", &["0 0 1", "0 0 2", "1 1 0", "0 0 0"]),
    ("limit", &["1.5", "180", "90", "${turns}"]),
    ("speed", &["2", "180", "0"]),
    ("ixx", &["0.01", "0.5", "0", "-1", "x"]),
    ("shape", &["box", "ball"]),
    ("parent", &["base", "p0", "p3", "nowhere"]),
];

/// What stands in front of the calls: it decides without being read by them.
const AROUND: [&str; 7] = [
    "",
    "<gazebo><static>true</static></gazebo>",
    "<xacro:macro name=\"extra\" params=\"\"><link name=\"more\"/></xacro:macro>",
    "<link name=\"far\"><origin xyz=\"${missing}\"/></link>",
    "<xacro:property name=\"turns\" value=\"2\"/>",
    "<xacro:property name=\"turns\" value=\"many\"/>",
    "<link name=\"P3\"/>",
];

fn call(number: usize, settings: &[(&str, &str)]) -> String {
    let settings = settings
        .iter()
        .map(|(name, value)| format!(" {name}=\"{value}\""));
    format!(
        "  <xacro:part name=\"p{number}\"{}/>\n",
        settings.collect::<String>()
    )
}

#[test]
fn calls_that_were_settled_are_asked_again_when_something_else_decides() {
    const CALLS: usize = 10;
    let folder = Path::new("/nowhere");
    let path = folder.join("arm.urdf.xacro");
    let mut dice = Dice(7);
    let mut around = "";
    let mut calls: Vec<Vec<(&str, &str)>> = (0..CALLS).map(|_| vec![("parent", "base")]).collect();
    let write = |around: &str, calls: &[Vec<(&str, &str)>]| {
        let calls = calls
            .iter()
            .enumerate()
            .map(|(number, own)| call(number, own));
        format!("{MACRO}{around}\n{}</robot>\n", calls.collect::<String>())
    };
    let texts = |text: String| BTreeMap::from([(path.clone(), text)]);
    let mut session = Session::over(folder, &texts(write(around, &calls)));
    session.findings();
    for round in 0..150 {
        if dice.roll(5) == 0 {
            around = AROUND[dice.roll(AROUND.len())];
        } else {
            let (name, values) = SETTINGS[dice.roll(SETTINGS.len())];
            let own = &mut calls[dice.roll(CALLS)];
            own.retain(|(known, _)| *known != name);
            own.push((name, values[dice.roll(values.len())]));
        }
        let (old, new) = (session.texts[&path].clone(), write(around, &calls));
        let start = old
            .bytes()
            .zip(new.bytes())
            .take_while(|(a, b)| a == b)
            .count();
        let behind = old.bytes().rev().zip(new.bytes().rev());
        let same = behind.take_while(|(a, b)| a == b).count();
        let same = same.min(old.len() - start).min(new.len() - start);
        session.edit(
            &path,
            start,
            old.len() - same,
            &new[start..new.len() - same],
        );
        let fresh = Session::over(folder, &texts(new.clone())).findings();
        assert_eq!(session.findings(), fresh, "round {round}: {new}");
    }
}

#[test]
fn edited_manifests_count() {
    let folder = std::env::temp_dir().join(format!("edited-manifests-{}", std::process::id()));
    let manifest =
        |name: &str, needs: &str| format!("<package><name>{name}</name>{needs}</package>");
    let files = [
        ("arm/package.xml", manifest("arm", "<exec_depend>tool</exec_depend>")),
        ("tool/package.xml", manifest("tool", "")),
        ("camera/package.xml", manifest("camera", "")),
        ("camera/lens.stl", String::new()),
        (
            "arm/arm.urdf",
            "<robot name='arm'><link name='base'><visual><geometry>\
             <mesh filename='package://camera/lens.stl'/><mesh filename='package://camra/lens.stl'/>\
             </geometry></visual></link></robot>"
                .to_owned(),
        ),
    ];
    let mut texts = BTreeMap::new();
    for (name, text) in &files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
        if !name.ends_with("stl") {
            texts.insert(path, text.clone());
        }
    }
    let tool = folder.join("tool/package.xml");
    let mut session = Session::over(&folder, &texts);
    let first = session.findings();
    for needs in [
        // it brings along what the arm names
        "<exec_depend>camera</exec_depend>",
        // it needs the package that is missing: that is no slip
        "<exec_depend>camra</exec_depend>",
        "",
    ] {
        let text = session.texts[&tool].clone();
        session.edit(&tool, 0, text.len(), &manifest("tool", needs));
        let found = session.findings();
        assert_eq!(found, Session::over(&folder, &session.texts).findings());
        assert_eq!(found == first, needs.is_empty(), "{needs}: {found:#?}");
    }
    fs::remove_dir_all(&folder).unwrap();
}
